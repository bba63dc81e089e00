#!/usr/bin/env bash
# What takes too long to run for every change: sanitizers over the core, the server and the clients,
# fuzzing, and the contract beside that of a commit before. Says which of them failed, at the end.
# usage: deploy/check_long.sh [asan | tsan | fuzz | buf]   all of them unless given
# BASE=COMMIT       whose contract this one must be compatible with (main unless given)
# FUZZ_RUNS=NUMBER  inputs that each fuzzer tries (2,000,000 unless given)
# JOBS=NUMBER       of the compiler (2 unless given)
set -euo pipefail
cd "$(dirname "$0")/.."
jobs=${JOBS:-2}

# Test programs of the core, the server and the C++ client; tsan's of what has threads.
asan_targets=(core_depth_test core_detector_test core_grasping_test core_lens_test core_objects_test
  core_paper_test core_planning_test core_relations_test core_saliency_test core_scene_test core_seeds_test
  core_segmentation_test core_shape_test core_tracking_test core_types_test server_conversion_test
  server_test client_test)
tsan_targets=(core_types_test core_detector_test core_tracking_test server_test client_test)

sanitize() { # PRESET TARGET...
  local preset=$1
  shift
  eval "$(/usr/bin/python3 deploy/preset_environment.py "$preset")"
  cmake --preset "$preset" >/dev/null
  nice cmake --build --preset "$preset" --target "$@" -j "$jobs"
  # By folder: programs that were not built have a test named NAME_NOT_BUILT, and Python's need others.
  for name in "$@"; do
    find "build/$preset/tests" -type f -name "$name" -perm -u+x -printf '%h\n'
  done | sort -u | while read -r folder; do
    echo "$preset: $folder"
    nice ctest --test-dir "$folder" --output-on-failure -j "$jobs" -E "_NOT_BUILT|^Python|^client_package" </dev/null || exit
  done
}

fuzz() {
  cmake --preset release >/dev/null
  nice cmake --build --preset release --target fovea_fuzzer -j "$jobs"
  for name in bundle jpeg mcap png request routes rvl zstd; do
    mkdir -p "build/release/tests/fuzz/found/$name"
    nice "build/release/tests/fuzz/${name}_fuzzer" -runs="${FUZZ_RUNS:-2000000}" -max_len=8192 \
      -timeout=20 -print_final_stats=1 "build/release/tests/fuzz/found/$name" \
      "tests/fuzz/corpus/$name"
  done
}

buf() {
  local tool=build/buf
  command -v npm >/dev/null || deploy/install_dependencies.sh npm
  [ -x "$tool/node_modules/.bin/buf" ] || npm install --no-save --prefix "$tool" @bufbuild/buf@1.75.0
  "$tool/node_modules/.bin/buf" lint proto
  "$tool/node_modules/.bin/buf" breaking proto --against ".git#ref=$(git rev-parse "${BASE:-main}"),subdir=proto"
}

case ${1:-} in
  asan) sanitize asan "${asan_targets[@]}" ;;
  tsan) sanitize tsan "${tsan_targets[@]}" ;;
  fuzz) fuzz ;;
  buf) buf ;;
  "")
    # Each in a shell of its own, which ends with its first error.
    failed=""
    for part in asan tsan fuzz buf; do
      echo "--- $part"
      "$0" "$part" || failed="$failed $part"
    done
    [ -z "$failed" ] || { echo "check_long: failed:$failed" >&2; exit 1; }
    ;;
  *) echo "check_long: $1 is not one of asan, tsan, fuzz, buf" >&2; exit 1 ;;
esac
