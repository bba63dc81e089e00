#!/usr/bin/env bash
# Installs the client library into an empty folder, builds the examples against it by CMake and one
# by pkg-config, and runs them against a real server.
# usage: check_client_package.sh BUILD_FOLDER SOURCE_FOLDER SERVER SCENES_TOOL CLEAN_UP_TOOL [PYTHON]
# With PYTHON, which must have numpy and Pillow, the example of fovea::pcl too.
set -euo pipefail
build=$1 source=$2 server=$3 scenes=$4 clean_up=$5 python=${6:-}

work=$(mktemp -d)
server_pid=""
trap '[ -z "$server_pid" ] || kill "$server_pid"; rm -rf "$work"' EXIT

cmake --install "$build" --component dev --prefix "$work/prefix" >/dev/null
cmake -S "$source/client/examples/cpp" -B "$work/examples" -G Ninja \
  -DCMAKE_PREFIX_PATH="$work/prefix" >/dev/null
cmake --build "$work/examples"
cmake -S "$source/tests/package/without_pcl" -B "$work/without_pcl" -G Ninja \
  -DCMAKE_PREFIX_PATH="$work/prefix" -DCMAKE_DISABLE_FIND_PACKAGE_PCL=ON >/dev/null
if [ -n "$python" ]; then
  cmake -S "$source/client/examples/pcl" -B "$work/pcl_example" -G Ninja \
    -DCMAKE_PREFIX_PATH="$work/prefix" >/dev/null
  cmake --build "$work/pcl_example"
fi

export PKG_CONFIG_PATH=$work/prefix/lib/pkgconfig
# shellcheck disable=SC2046  # a list of flags
${CXX:-c++} -std=c++20 "$source/client/examples/cpp/detect_once.cc" -o "$work/by_pkg_config" \
  $(pkg-config --cflags --libs fovea)

"$scenes" --output "$work/frames" --kind tabletop --count 1 --seed 7 >/dev/null
frame=$(ls "$work"/frames/*_color.png)
frame=${frame%_color.png}

mkfifo "$work/says"
"$server" --listen 127.0.0.1:0 --log-level error >"$work/says" &
server_pid=$!
read -r address <"$work/says"
address=${address#listening on }

for program in "$work/examples/detect_once" "$work/by_pkg_config"; do
  "$program" "$address" "${frame}_color.png" "${frame}_depth.png" | tee "$work/once"
  grep -q " m, .* grasps" "$work/once"
done
"$work/examples/detect_stream" "$address" "${frame}_color.png" "${frame}_depth.png" |
  tee "$work/stream"
grep -q "^frame .* objects*, " "$work/stream"
"$clean_up" --things 2 --sensor ideal -- "$work/examples/clean_up" "$address" | tee "$work/clean_up"
grep -q " taken$" "$work/clean_up"
if [ -n "$python" ]; then
  "$python" "$source/tests/package/make_cloud.py" "${frame}_color.png" "${frame}_depth.png" \
    525,525,319.5,239.5 "$work/cloud.pcd"
  "$work/pcl_example/detect_cloud" "$address" "$work/cloud.pcd" | tee "$work/cloud"
  # As many objects as of the images that the cloud was made of, each with points.
  num_objects=$(grep -c "^[0-9]*: [1-9][0-9]* points around .* m$" "$work/cloud")
  [ "$num_objects" -eq "$(wc -l <"$work/once")" ]
fi
