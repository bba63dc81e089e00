#!/bin/sh
# Installs the Debian packages of a build folder in a bare Debian 12, runs them there and removes
# them again. Needs root and mmdebstrap.
# usage: deploy/try_packages.sh BUILD_FOLDER   (after make package)
set -eu
ls "$1"/*.deb >/dev/null

command -v mmdebstrap >/dev/null || { echo "try_packages: mmdebstrap is missing: apt-get install mmdebstrap" >&2; exit 1; }
work=$(mktemp -d)
server=""
trap '[ -z "$server" ] || kill "$server" 2>/dev/null || true; rm -rf "$work"' EXIT
root=$work/root
mmdebstrap --quiet --variant=minbase bookworm "$root"
cp /etc/resolv.conf "$root/etc/" 2>/dev/null || true
find "$root" | sort >"$work/before"

inside() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"; }
mkdir "$root/packages"
cp "$1"/*.deb "$root/packages/"
inside sh -c 'apt-get update -q && apt-get install -y -q --no-install-recommends /packages/*.deb' >"$work/log" 2>&1 ||
  { tail -n 20 "$work/log" >&2; exit 1; }
echo "installed: $(cd "$root/packages" && echo *)"

inside fovea-server --version
inside fovea-server --config /etc/fovea/fovea-server.toml --check-config
mkfifo "$work/says"
chroot "$root" fovea-server --listen 127.0.0.1:0 --log-level error >"$work/says" & # as itself, to be signalled
server=$!
read -r address <"$work/says"
address=${address#listening on }
inside fovea health --server "$address"
if [ -e "$root/usr/bin/fovea-capture" ]; then inside fovea-capture --help >/dev/null && echo "fovea-capture runs"; fi
inside fovea-observer --version
if [ -d "$root/usr/lib/python3/dist-packages/fovea" ]; then
  inside python3 -c "import fovea; print('python:', fovea.Client('$address').get_server_info().version)"
fi
kill "$server"
wait "$server" || { echo "try_packages: the server ended with $?" >&2; exit 1; }
server=""

inside sh -c 'apt-get purge -y -q "*fovea*"' >"$work/log" 2>&1 || { tail -n 20 "$work/log" >&2; exit 1; }
rm -r "$root/packages"
find "$root" | sort >"$work/after"
left=$(comm -13 "$work/before" "$work/after" | grep -i fovea || true)
[ -z "$left" ] || { echo "left behind:"; echo "$left"; exit 1; }
echo "removed without a trace"
