#!/bin/sh
# Shows Fovea at work: starts the server, sends it frames, prints what it found and leaves pictures
# and a point cloud in demo/.
#
# usage: deploy/demo.sh BUILD_FOLDER
# FRAME=DIR/NAME      use DIR/NAME_color.(png|jpg) and DIR/NAME_depth.png instead of generated frames
# INTRINSICS=FX,FY,CX,CY   of the camera that took FRAME, in pixels (default: 525,525,319.5,239.5)
set -eu

build=$1
out=demo
intrinsics=${INTRINSICS:-525,525,319.5,239.5}
mkdir -p "$out/frames" "$out/results"
rm -f "$out"/frames/* "$out"/results/*

# Now, not by the server once it runs: else the wait below may find the address of an earlier run.
: >"$out/server.log"
"$build/server/fovea-server" --listen 127.0.0.1:0 --log-level warn >>"$out/server.log" 2>&1 &
server=$!
trap 'kill "$server" 2>/dev/null; wait "$server" 2>/dev/null || true' EXIT

address=""
while [ -z "$address" ]; do
  kill -0 "$server" 2>/dev/null || { cat "$out/server.log" >&2; exit 1; }
  address=$(sed -n 's/^listening on //p' "$out/server.log")
  [ -n "$address" ] || sleep 0.1
done

if [ -n "${FRAME:-}" ]; then
  found=0
  for file in "${FRAME}_color.png" "${FRAME}_color.jpg" "${FRAME}_depth.png"; do
    [ -f "$file" ] && cp "$file" "$out/frames/" && found=$((found + 1))
  done
  if [ "$found" -lt 2 ]; then
    echo "demo: FRAME=$FRAME needs ${FRAME}_color.png (or .jpg) and ${FRAME}_depth.png" >&2
    exit 1
  fi
  first=$(basename "$FRAME")
else
  for kind in tabletop stacked floor; do
    "$build/tests/support/fovea-scenes" --output "$out/frames" --kind "$kind" --count 1 --seed 7 \
      >/dev/null
  done
  first=$(basename "$(ls "$out"/frames/*_color.png | head -n 1)" _color.png)
fi

"$build/client/cli/fovea" detect --server "$address" --intrinsics "$intrinsics" \
  --input "$out/frames" --output "$out/results"
color=$(ls "$out/frames/${first}"_color.* | head -n 1)
"$build/client/cli/fovea" detect --server "$address" --intrinsics "$intrinsics" \
  --color "$color" --depth "$out/frames/${first}_depth.png" --cloud "$out/results/${first}.ply"

echo
echo "Pictures:    $(ls "$out"/results/*_overlay.jpg | tr '\n' ' ')"
echo "Point cloud: $out/results/${first}.ply"
