#!/bin/sh
# Shows Fovea at work: starts the server, sends it frames, prints what it found and leaves pictures
# and a point cloud in demo/, of which it names the one to look at. In a terminal it then goes on, and
# says where a browser shows what a robot sees (WATCH=no: it ends; WATCH=yes: also elsewhere).
#
# usage: deploy/demo.sh BUILD_FOLDER
# FRAME=DIR/NAME      use DIR/NAME_color.(png|jpg) and DIR/NAME_depth.png instead of generated frames
# INTRINSICS=FX,FY,CX,CY   of the camera that took FRAME, in pixels (default: 525,525,319.5,239.5)
# FOVEA_DATA=DIR      recordings, of which one comes among the generated frames where they are
set -eu

build=$1
out=demo
intrinsics=${INTRINSICS:-525,525,319.5,239.5}
mkdir -p "$out/frames" "$out/results"
rm -f "$out"/frames/* "$out"/results/* "$out/objects.png"

# Now, not by the server once it runs: else the wait below may find the address of an earlier run.
: >"$out/server.log"
token=$(openssl rand -hex 16)
(umask 077 && echo "demo $(printf %s "$token" | sha256sum | cut -d' ' -f1) view,try,download *" >"$out/observers" && echo "$token" >"$out/recorder")
"$build/server/fovea-server" --listen 127.0.0.1:0 --log-level warn --observers "$out/observers" >>"$out/server.log" 2>&1 &
server=$! observer=""
trap 'kill $server $observer 2>/dev/null; wait 2>/dev/null || true' EXIT
trap 'exit 0' INT TERM HUP

# What the program with this number says in the log after these words.
await() {
  found=""
  while [ -z "$found" ]; do
    kill -0 "$1" 2>/dev/null || { cat "$3" >&2; exit 1; }
    found=$(sed -n "s/^$2 //p" "$3")
    [ -n "$found" ] || sleep 0.1
  done
}
await "$server" "listening on" "$out/server.log"
address=$found

# A frame into demo/frames; fails if a half of it is not there.
add_frame() {
  cp "$1_depth.png" "$out/frames/" &&
    if [ -f "$1_color.png" ]; then cp "$1_color.png" "$out/frames/"; else cp "$1_color.jpg" "$out/frames/"; fi
}

if [ -n "${FRAME:-}" ]; then
  add_frame "$FRAME" 2>/dev/null || {
    echo "demo: FRAME=$FRAME needs ${FRAME}_color.png (or .jpg) and ${FRAME}_depth.png" >&2
    exit 1
  }
else
  for kind in tabletop stacked floor; do add_frame "client/examples/frames/$kind"; done
  # The same camera took this one, but it may not be part of a clone.
  add_frame "${FOVEA_DATA:-../shared/data}/floor/floor1" 2>/dev/null || true
fi

"$build/client/cli/fovea" detect --server "$address" --intrinsics "$intrinsics" \
  --input "$out/frames" --output "$out/results"
for depth in "$out"/frames/*_depth.png; do break; done
first=$(basename "$depth" _depth.png)
for color in "$out/frames/${first}"_color.*; do break; done
"$build/client/cli/fovea" detect --server "$address" --intrinsics "$intrinsics" \
  --color "$color" --depth "$depth" --cloud "$out/results/${first}.ply"

/usr/bin/python3 deploy/side_by_side.py "$out/objects.png" "$out"/results/*_overlay.jpg
echo
echo "Look at      $out/objects.png (each frame in $out/results)"
echo "Point cloud: $out/results/${first}.ply"

case ${WATCH:-} in
  yes) ;;
  "") [ -t 1 ] || exit 0 ;;
  *) exit 0 ;;
esac
echo
echo "Building the page that shows what a robot sees (a minute or two; Ctrl-C ends it) …"
cmake --build "$build" --target fovea-observer
: >"$out/observer.log"
"$build/client/observer/fovea-observer" --server "$address" --listen "${LISTEN:-127.0.0.1:8080}" \
  --history "$out/history" --history-token-file "$out/recorder" --history-minutes 5 --history-size 256MB \
  >>"$out/observer.log" 2>&1 &
observer=$!
await "$observer" open "$out/observer.log"
echo
echo "Open this address: ${found}#token=$token"
echo "It shows what a robot sees that sends these frames again and again; Ctrl-C ends it."
while kill -0 "$observer" 2>/dev/null; do
  "$build/client/cli/fovea" detect --server "$address" --robot demo --intrinsics "$intrinsics" \
    --input "$out/frames" --json - >/dev/null 2>>"$out/observer.log" || true
  sleep 1
done
cat "$out/observer.log" >&2
exit 1
