#!/usr/bin/env bash
# Everything is installed below the prefix and finds each other there; of /usr, where Debian has it.
# usage: check_install.sh BUILD_FOLDER SOURCE_FOLDER PYTHON
set -euo pipefail
build=$1 source=$2 python=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

fail() {
  echo "check_install: $*" >&2
  exit 1
}

DESTDIR=$work/root cmake --install "$build" --prefix /opt/fovea >/dev/null
outside=$(find "$work/root" -type f -not -path "$work/root/opt/fovea/*")
[ -z "$outside" ] || fail "these are outside of the prefix: $outside"

cmake --install "$build" --prefix "$work/own" >/dev/null
"$work/own/bin/fovea-server" --config "$work/own/etc/fovea/fovea-server.toml" --check-config
unit=$work/own/lib/systemd/system/fovea-server.service
grep -qx "ExecStart=$work/own/bin/fovea-server --config $work/own/etc/fovea/fovea-server.toml" "$unit" ||
  fail "the unit starts another server: $(grep ExecStart= "$unit")"

# The page holds three.js, whose licence wants to be with every copy.
words() { tr -cs '[:alnum:]' ' '; }
permission=$(sed -n '/^Permission/,$p' "$source/client/observer/page/dist/licenses.txt" | words)
words <"$work/own/share/doc/fovea-observer/copyright" | grep -F "$permission" >/dev/null ||
  fail "the licence of three.js is not in the copyright file of fovea-observer"

# As make does it: also where a folder has two words, and for others whatever the umask is.
install=$(make -C "$source" --dry-run --silent install BUILD="$build" PREFIX="$work/two words" | tail -n 1)
(umask 077 && eval "$install" >/dev/null)
closed=$(find "$work/two words" -type d -not -perm -755)
[ -z "$closed" ] || fail "others may not look into $closed"
words=$work/two\\x20words # as systemd writes it
grep -qxF "ExecStart=$words/bin/fovea-server --config $words/etc/fovea/fovea-server.toml" \
  "$work/two words/lib/systemd/system/fovea-server.service" || fail "the unit of two words starts another server"

# An edited configuration stays; a relative prefix is one from where the command runs.
echo 'max-pixels = 1000000' >>"$work/own/etc/fovea/fovea-server.toml"
cp "$work/own/etc/fovea/fovea-server.toml" "$work/edited.toml"
(cd "$work" && cmake --install "$build" --prefix own | grep "Kept as it is" >/dev/null) ||
  fail "nothing says that the configuration was kept"
cmp "$work/edited.toml" "$work/own/etc/fovea/fovea-server.toml"
cmp "$source/deploy/fovea-server.toml" "$work/own/etc/fovea/fovea-server.toml.new"
grep -qx "ExecStart=$work/own/bin/fovea-server --config $work/own/etc/fovea/fovea-server.toml" "$unit" ||
  fail "the unit of a relative prefix starts another server: $(grep ExecStart= "$unit")"
PYTHONPATH=$(echo "$work"/own/lib/python3.*/dist-packages) "$python" -B -c 'import fovea'

DESTDIR=$work/debian cmake --install "$build" --prefix /usr >/dev/null
for file in etc/fovea/fovea-server.toml usr/lib/python3/dist-packages/fovea/__init__.py; do
  [ -f "$work/debian/$file" ] || fail "/$file is not there"
done
cmp "$source/deploy/fovea-server.service" "$work/debian/usr/lib/systemd/system/fovea-server.service"

# Built in a folder of two words. Where libraries have a folder of the architecture, as below /usr on
# Debian, fovea.pc finds the rest.
other="$work/other build"
cmake -S "$source" -B "$other" -G Ninja -D CMAKE_BUILD_TYPE=Release \
  -D CMAKE_INSTALL_LIBDIR=lib/x86_64-linux-gnu -D FOVEA_BUILD_TESTS=OFF -D FOVEA_BUILD_CAPTURE=OFF \
  -D FOVEA_BUILD_PCL=OFF >/dev/null
install -D "$other/fovea.pc" "$work/own/lib/x86_64-linux-gnu/pkgconfig/fovea.pc"
headers=$(PKG_CONFIG_PATH=$work/own/lib/x86_64-linux-gnu/pkgconfig pkg-config --variable=includedir fovea)
[ -f "$headers/fovea/client/client.h" ] || fail "fovea.pc looks for headers in $headers"
cmake --build "$other" --target fovea_python changelogs >/dev/null
cmake --install "$other" --component python --prefix "$work/of_other" >/dev/null

DESTDIR=$work/local cmake --install "$build" --prefix /usr/local >/dev/null
# Debian's python3 has one folder there, of its own minor version.
searched=$("$python" -c 'import site; print(next(p for p in site.getsitepackages() if p.startswith("/usr/local/")))')
[ -d "$work/local$searched/fovea" ] || fail "python3 looks in $searched, the library is not there"

# A package, of those that make makes: for others whatever the umask is, and it says what it is.
cmake --build "$build" --target changelogs >/dev/null
package=$(make -C "$source" --dry-run --silent package BUILD="$build" | tail -n 1)
(umask 077 && eval "$package -D CPACK_COMPONENTS_ALL=python -B $work/packages" >/dev/null)
closed=$(dpkg-deb --contents "$work"/packages/*.deb | grep '^d' | grep -v '^drwxr-xr-x' || true)
[ -z "$closed" ] || fail "others may not look into $closed"
synopsis=$(dpkg-deb --field "$work"/packages/*.deb Description | sed -n 1p)
[ "$synopsis" = "Python client of fovea, which detects unknown objects" ] || fail "its synopsis: $synopsis"
version=$(dpkg-deb --field "$work"/packages/*.deb Version)
commit=$(git -C "$source" log -1 --format=%h --abbrev=12 2>/dev/null || true)
[ -z "$commit" ] || { dpkg --compare-versions "$version" gt 0.1.0-1 && [ "${version##*.}" = "$commit" ]; } ||
  fail "a package of $commit has the version $version"
dpkg-deb --extract "$work"/packages/*.deb "$work/unpacked"
said=$(zcat "$work/unpacked/usr/share/doc/python3-fovea/changelog.Debian.gz" | sed -n '1s/.*(\(.*\)).*/\1/p')
[ "$said" = "$version" ] || fail "a package of version $version has a changelog of $said"
