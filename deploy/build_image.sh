#!/bin/bash
# Builds the image of the Dockerfile without a Docker daemon, runs it as it should be run (read-only,
# without rights) and asks it through a published port, in plaintext and with TLS. Needs root, a
# build (make), and the packages buildah, podman, runc, netavark, iptables, mmdebstrap and openssl.
# Leaves the image fovea-server in the store, and nothing else but its base.
#
# BASE=IMAGE   base to build on; else one like debian:bookworm-slim is made from Debian's packages
# STORE=DIR    where the images go; else buildah's own store
# CLI=FILE     the command line that asks; else that of build/release
set -euo pipefail
cd "$(dirname "$0")/.."

for tool in buildah podman runc iptables mmdebstrap openssl; do
  command -v "$tool" >/dev/null || { echo "build_image: $tool is missing: apt-get install $tool" >&2; exit 1; }
done
cli=${CLI:-build/release/client/cli/fovea}
[ -x "$cli" ] || { echo "build_image: $cli is missing: make" >&2; exit 1; }

store=(--storage-driver vfs ${STORE:+--root "$STORE" --runroot "$STORE/run"})
export DISABLE_HC_SYSTEMD=true # health checks when we ask for them
podman=(podman "${store[@]}" --runtime runc --cgroup-manager cgroupfs --events-backend none)
image=fovea-server
name=fovea-image-check
base_container=""
work=$(mktemp -d)

clean_up() {
  "${podman[@]}" rm --force --ignore "$name" >/dev/null 2>&1 || true
  [ -z "$base_container" ] || buildah "${store[@]}" rm "$base_container" >/dev/null 2>&1 || true
  rm -rf "$work"
}
trap clean_up EXIT
trap 'exit 1' INT TERM

fail() {
  echo "build_image: $*" >&2
  exit 1
}

# As debian:bookworm-slim is: no documentation but licences, no translations.
make_base() {
  mmdebstrap --variant=minbase --include=usr-is-merged \
    --dpkgopt='path-exclude=/usr/share/doc/*' --dpkgopt='path-include=/usr/share/doc/*/copyright' \
    --dpkgopt='path-exclude=/usr/share/man/*' --dpkgopt='path-exclude=/usr/share/info/*' \
    --dpkgopt='path-exclude=/usr/share/locale/*' --dpkgopt='path-exclude=/usr/share/lintian/*' \
    bookworm "$work/base.tar" >/dev/null
  base_container=$(buildah "${store[@]}" from scratch)
  buildah "${store[@]}" add "$base_container" "$work/base.tar" / >/dev/null
  rm "$work/base.tar"
  buildah "${store[@]}" config --env PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin "$base_container"
  buildah "${store[@]}" commit --rm "$base_container" "$1" >/dev/null
  base_container=""
}

# This store keeps every layer as a copy of all files below it: 4 GB for each step of the build.
# Without layers each stage is one container, and that of the compilers is never stored as an image.
build() {
  local base=${BASE:-localhost/fovea-base} commit
  [ -n "${BASE:-}" ] || make_base "$base"
  commit=$(git describe --always --dirty=-modified --abbrev=12 --exclude='*' 2>/dev/null || true)
  buildah "${store[@]}" bud --layers=false --force-rm --isolation chroot --format docker \
    --build-arg BASE="$base" --build-arg FOVEA_COMMIT="$commit" -t "$image" .
  podman "${store[@]}" images --format '{{.Repository}} {{.Size}}' | grep -E 'fovea-(server|base)'
}

# Flags of podman, "--", flags of the server.
serve() {
  local flags=()
  while [ "$1" != -- ]; do flags+=("$1") && shift; done
  shift
  "${podman[@]}" rm --force --ignore "$name" >/dev/null
  "${podman[@]}" run --detach --name "$name" --read-only --cap-drop all \
    --security-opt no-new-privileges --ulimit nofile=4096:4096 --ulimit nproc=4096:4096 \
    --publish 127.0.0.1::50051 ${flags[@]+"${flags[@]}"} "$image" "$@" >/dev/null
  until "${podman[@]}" logs "$name" 2>&1 | grep -q '^listening on '; do
    [ "$("${podman[@]}" inspect --format '{{.State.Running}}' "$name")" = true ] ||
      { "${podman[@]}" logs "$name" >&2; exit 1; }
  done
  "${podman[@]}" healthcheck run "$name"
  address=$("${podman[@]}" port "$name" 50051)
}

stop() {
  "${podman[@]}" stop --time 10 "$name" >/dev/null
  local code
  code=$("${podman[@]}" inspect --format '{{.State.ExitCode}}' "$name")
  [ "$code" = 0 ] || fail "it ended with $code"
  echo "ended with 0"
}

check_packages() {
  local list licence
  list=$("${podman[@]}" run --rm --network none --ulimit nofile=4096:4096 --ulimit nproc=4096:4096 \
    --entrypoint sh "$image" -c \
    'for package in $(dpkg-query -W -f "\${Package}\n"); do ls /usr/share/doc/$package/copyright; done; dpkg-query -W')
  for package in fovea-server libgrpc29; do
    licence=/usr/share/doc/$package/copyright
    grep -q "^$package" <<<"$list" || fail "dpkg does not know $package"
    grep -qx "$licence" <<<"$list" || fail "$licence is not there"
  done
  echo "$(grep -c '^/usr/share/doc/.*/copyright' <<<"$list") copyright files"
}

check_unprotected() {
  echo "--- without protection"
  if "${podman[@]}" run --rm --network none --ulimit nofile=4096:4096 --ulimit nproc=4096:4096 \
    "$image" 2>"$work/error"; then fail "it serves other machines without having been told to"; fi
  cat "$work/error"
  grep -q -- --insecure "$work/error" || fail "the error does not say what to do"
  serve -- --insecure
  "$cli" health --server "$address"
  "$cli" info --server "$address" | head -n 4
  stop
}

check_tls() {
  echo "--- with TLS and a token"
  openssl req -x509 -newkey rsa:2048 -nodes -days 1 -subj /CN=fovea -addext subjectAltName=IP:127.0.0.1 \
    -keyout "$work/key.pem" -out "$work/cert.pem" 2>/dev/null
  printf secret >"$work/token"
  echo "robot $(sha256sum <"$work/token" | cut -d' ' -f1)" >"$work/tokens"
  chmod 755 "$work" && chmod 644 "$work"/*
  serve --volume "$work:/keys:ro" -- --tls-cert /keys/cert.pem --tls-key /keys/key.pem --tokens /keys/tokens
  "$cli" health --server "$address" --tls-ca "$work/cert.pem"
  "$cli" info --server "$address" --tls-ca "$work/cert.pem" --token-file "$work/token" | head -n 1
  if "$cli" info --server "$address" --tls-ca "$work/cert.pem" 2>/dev/null; then fail "it answers without a token"; fi
  stop
}

build
check_packages
check_unprotected
check_tls
