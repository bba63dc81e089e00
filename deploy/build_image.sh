#!/bin/sh
# Builds the image of the Dockerfile without a Docker daemon, runs it as it should be run (read-only,
# without rights) and asks it for its health. Needs root, and the packages buildah, podman, runc and
# mmdebstrap. Leaves the image fovea-server in buildah's store.
#
# BASE=IMAGE   base to build on; else one is made from Debian's packages
set -eu
cd "$(dirname "$0")/.."

for tool in buildah podman runc mmdebstrap; do
  command -v "$tool" >/dev/null || { echo "build_image: $tool is missing: apt-get install $tool" >&2; exit 1; }
done

store="--storage-driver vfs"
image=fovea-server
base=${BASE:-}
if [ -z "$base" ]; then
  base=localhost/fovea-base
  work=$(mktemp -d)
  trap 'rm -rf "$work"' EXIT
  mmdebstrap --variant=minbase bookworm "$work/base.tar" >/dev/null
  container=$(buildah $store from scratch)
  buildah $store add "$container" "$work/base.tar" / >/dev/null
  buildah $store config --env PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin "$container"
  buildah $store commit --rm "$container" "$base" >/dev/null
fi

buildah $store bud --layers --isolation chroot --format docker --build-arg BASE="$base" -t "$image" .
podman $store images --format '{{.Repository}} {{.Size}}' | grep -E 'fovea-(server|base)'

run="podman $store --runtime runc --cgroup-manager cgroupfs --events-backend none"
name=fovea-image-check
$run rm --force --ignore "$name" >/dev/null
# Its own health checks would need systemd.
$run run --detach --name "$name" --network host --read-only --cap-drop all --no-healthcheck \
  --ulimit nofile=1024:1024 --ulimit nproc=1024:1024 "$image" --listen 127.0.0.1:0 >/dev/null
trap '$run rm --force "$name" >/dev/null 2>&1; [ -z "${work:-}" ] || rm -rf "$work"' EXIT
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
