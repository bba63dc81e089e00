#!/usr/bin/env bash
# Runs server and command line with the sanitizers of addresses, of undefined behaviour and of numbers
# too large for an int, which the one before leaves out: frames that are part of the clone with all
# that can be asked of them, both profiles, and files that are none. There must be no report, and the
# same pictures, answers and errors as from BUILD_FOLDER, except for times and the commit.
# Compiled by Clang without optimisation, which takes half of the time of GCC, and shows that another
# compiler gives the same answers; `make check-long PART=asan` runs the tests.
# usage: deploy/check_sanitized.sh BUILD_FOLDER
set -euo pipefail
cd "$(dirname "$0")/.."
ls "$1/server/fovea-server" "$1/client/cli/fovea" >/dev/null

sanitized=build/asan_clang
out=$(mktemp -d)
server=""
finish() {
  local status=$?
  [ -z "$server" ] || kill "$server" 2>/dev/null || true
  [ "$status" = 0 ] || find "$out" -maxdepth 1 -name "*.log" -exec cat {} + >&2
  rm -rf "$out"
}
trap finish EXIT
frames=client/examples/frames

deploy/install_dependencies.sh clang libclang-rt-dev
cmake --preset asan -B "$sanitized" -D CMAKE_CXX_COMPILER=clang++ -D CMAKE_BUILD_TYPE=None -D CMAKE_CXX_FLAGS="-O0 -g1" \
  -D FOVEA_SANITIZE=address,undefined,float-cast-overflow \
  -D FOVEA_BUILD_TESTS=OFF -D FOVEA_BUILD_CAPTURE=OFF -D FOVEA_BUILD_PCL=OFF >/dev/null
cmake --build "$sanitized" --target fovea-server fovea
eval "$(/usr/bin/python3 deploy/preset_environment.py asan)"

head -c 20000 "$frames/floor_depth.png" >"$out/cut_depth.png"
head -c 20000 "$frames/floor_color.jpg" >"$out/cut_color.jpg"

# Sends everything from programs in folder $1, and leaves what comes back in $2.
run() {
  local log=$2.log
  mkdir "$2"
  : >"$log"
  "$1/server/fovea-server" --listen 127.0.0.1:0 --max-compute-ms 300000 --log-level warn >>"$log" 2>&1 &
  server=$!
  until grep -q "^listening on " "$log"; do
    kill -0 "$server" 2>/dev/null || exit 1
    sleep 0.1
  done
  local address
  address=$(sed -n "s/^listening on //p" "$log")
  ask() { "$1/client/cli/fovea" detect --server "$address" --intrinsics 525,525,319.5,239.5 --timeout 300 "${@:2}"; }
  ask "$1" --input "$frames" --output "$2/frames" --cloud ply >/dev/null 2>&1
  one=(--color "$frames/stacked_color.jpg" --depth "$frames/stacked_depth.png")
  ask "$1" "${one[@]}" --gripper jaw=0.14,0.05 --gripper suction=0.03 --place 0.1,0.1,0.1 \
    --max-places 3 --place-margin 0.01 --collision-primitives --height-map-cell 0.02 --height-map "$2/heights.png" \
    --camera-pose 0.1,0.2,1.5,1,0,0,0 --distortion plumb_bob=0.08,-0.15,0.001,-0.002,0.05 --cloud "$2/all.ply" \
    --show seeds,saliency,rejected,grasps,collisions --overlay "$2/all.jpg" --explain "$2/steps" \
    --labels "$2/all.png" --json "$2/all.json" >/dev/null
  ask "$1" "${one[@]}" --profile paper --set color_saliency.downscale=2 --json "$2/paper.json" >/dev/null
  ask "$1" --color "$frames/floor_color.jpg" --depth "$out/cut_depth.png" 2>"$2/cut_depth.txt" && exit 1
  ask "$1" --color "$out/cut_color.jpg" --depth "$frames/floor_depth.png" 2>"$2/cut_color.txt" && exit 1
  sed -i 's/ (request [0-9]*)$//' "$2"/cut_*.txt # their number depends on how often was asked before
  "$1/client/cli/fovea" options --server "$address" >"$2/options.txt"
  kill "$server"
  wait "$server"
  server=""
}
run "$sanitized" "$out/sanitized"
run "$1" "$out/released"
diff -r -I '"duration"' -I '"server_build"' "$out/sanitized" "$out/released"
echo "no report of a sanitizer, and the same answers"
