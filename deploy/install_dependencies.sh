#!/bin/sh
# Installs the Debian 12 packages that building and testing Fovea needs, if any is missing.
# Runs as root, or as a user with sudo. Prints nothing when all are there.
# usage: deploy/install_dependencies.sh [PACKAGE...]   (others beside them)
set -eu

packages="
build-essential cmake ninja-build ccache pkg-config
libeigen3-dev libhwy-dev libopencv-dev libpcl-dev
libgrpc-dev libgrpc++-dev libprotobuf-dev protobuf-compiler protobuf-compiler-grpc grpc-proto
libssl-dev libsystemd-dev prometheus-cpp-dev libspdlog-dev libfmt-dev libcli11-dev libzstd-dev zlib1g-dev liblz4-dev libsqlite3-dev libzip-dev libturbojpeg0-dev libspng-dev nlohmann-json3-dev
libboost-dev
libopenni2-dev libyaml-cpp-dev
libgtest-dev libgmock-dev libbenchmark-dev libmatio-dev libdlib-dev
python3 python3-grpcio python3-numpy python3-protobuf python3-setuptools
help2man file haproxy
python3-pil python3-pip python3-pytest python3-zstandard openssl
chromium chromium-driver python3-selenium
"

missing=""
for package in $packages "$@"; do
  # A line for each architecture; what is held is installed, too.
  dpkg-query -W -f '${db:Status-Status}\n' "$package" 2>/dev/null | grep -qx installed ||
    missing="$missing $package"
done
[ -n "$missing" ] || exit 0

if [ "$(id -u)" -eq 0 ]; then
  as_root=""
elif command -v sudo >/dev/null 2>&1; then
  as_root="sudo"
else
  echo "install_dependencies: these packages are missing, and neither root nor sudo is here:$missing" >&2
  exit 1
fi

echo "Installing:$missing"
$as_root apt-get update -q
# shellcheck disable=SC2086  # a list of package names
$as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends $missing
