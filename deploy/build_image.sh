#!/bin/sh
# Builds the image of the Dockerfile without a Docker daemon, runs it as it should be run (read-only,
# without rights) and asks it for its health. Needs root, and the packages buildah, podman, runc and
# mmdebstrap. Leaves the image fovea-server in the store, and nothing else but its base.
#
# BASE=IMAGE   base to build on; else one is made from Debian's packages
# STORE=DIR    where the images go; else buildah's own store
set -eu
cd "$(dirname "$0")/.."

for tool in buildah podman runc mmdebstrap; do
  command -v "$tool" >/dev/null || { echo "build_image: $tool is missing: apt-get install $tool" >&2; exit 1; }
done

store="--storage-driver vfs ${STORE:+--root $STORE --runroot $STORE/run}"
run="podman $store --runtime runc --cgroup-manager cgroupfs --events-backend none"
image=fovea-server
name=fovea-image-check
base=${BASE:-}
base_container=""
work=$(mktemp -d)

clean_up() {
  $run rm --force --ignore "$name" >/dev/null 2>&1 || true
  [ -z "$base_container" ] || buildah $store rm "$base_container" >/dev/null 2>&1 || true
  rm -rf "$work"
}
trap clean_up EXIT
trap 'exit 1' INT TERM

if [ -z "$base" ]; then
  base=localhost/fovea-base
  mmdebstrap --variant=minbase bookworm "$work/base.tar" >/dev/null
  base_container=$(buildah $store from scratch)
  buildah $store add "$base_container" "$work/base.tar" / >/dev/null
  rm "$work/base.tar"
  buildah $store config --env PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin "$base_container"
  buildah $store commit --rm "$base_container" "$base" >/dev/null
  base_container=""
fi

# This store keeps every layer as a copy of all files below it: 4 GB for each step of the build.
# Without layers each stage is one container, and that of the compilers is never stored as an image.
buildah $store bud --layers=false --force-rm --isolation chroot --format docker \
  --build-arg BASE="$base" -t "$image" .
podman $store images --format '{{.Repository}} {{.Size}}' | grep -E 'fovea-(server|base)'

# Its own health checks would need systemd.
$run rm --force --ignore "$name" >/dev/null
$run run --detach --name "$name" --network host --read-only --cap-drop all --no-healthcheck \
  --ulimit nofile=1024:1024 --ulimit nproc=1024:1024 "$image" --listen 127.0.0.1:0 >/dev/null
address=""
while [ -z "$address" ]; do
  running=$($run inspect --format '{{.State.Running}}' "$name")
  address=$($run logs "$name" 2>&1 | sed -n 's/^listening on //p')
  [ -n "$address" ] || [ "$running" = true ] || { $run logs "$name" >&2; exit 1; }
done
$run exec "$name" fovea health --server "$address"
$run exec "$name" fovea info --server "$address" | head -n 4
$run stop --time 20 "$name" >/dev/null
code=$($run inspect --format '{{.State.ExitCode}}' "$name")
echo "exit code $code"
[ "$code" = 0 ]
