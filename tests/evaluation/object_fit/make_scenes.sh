#!/usr/bin/env bash
# The generated scenes that the object model is fitted to, in folders of OUT (docs/fitted_models.md).
set -euo pipefail
if [[ $# -ne 2 ]]; then
  echo "usage: $0 BUILD OUT" >&2
  exit 2
fi
scenes() { # FOLDER SENSOR SEED COUNT KIND...
  local folder=$1 sensor=$2 seed=$3 count=$4
  shift 4
  for kind in "$@"; do
    "$build/tests/support/fovea-scenes" --output "$out/$folder" --kind "$kind" --count "$count" \
      --seed "$seed" --sensor "$sensor" >/dev/null
  done
}
build=$1
out=$2
kinds=(tabletop cluttered stacked touching occluded steep shallow room two_tables floor empty_table
  household household_floor supplies supplies_floor)
scenes simple kinect 50000 4 "${kinds[@]}"
scenes simple realsense 60000 4 "${kinds[@]}"
scenes parts kinect 6000 20 household
scenes parts realsense 6500 20 household
scenes parts kinect 7000 20 household_floor
scenes parts realsense 7500 20 household_floor
scenes large_and_thin halo_stereo 70000 12 luggage tools
scenes large_and_thin kinect 71000 8 luggage tools
scenes tablets_and_desks halo_stereo 70000 8 tablet desk
scenes tablets_and_desks kinect 71000 4 tablet desk
