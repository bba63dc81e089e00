"""A live loop: frames go out as fast as the camera has them, the newest is always answered.

The camera here plays the files NAME_color.png and NAME_depth.png of a folder over and over; put
your driver in its place.

usage: detect_stream.py ADDRESS FOLDER [--frames N]
"""

import argparse
import itertools
import time
from collections.abc import Iterator
from pathlib import Path

import fovea

INTRINSICS = fovea.CameraIntrinsics(fx=525, fy=525, cx=319.5, cy=239.5)


def camera(folder: Path, num_frames: int | None) -> Iterator[fovea.Frame]:
    colors = sorted(folder.glob("*_color.png"))
    for number, color in enumerate(itertools.islice(itertools.cycle(colors), num_frames)):
        depth = color.with_name(color.name.replace("_color", "_depth"))
        yield fovea.Frame(
            color.read_bytes(),
            depth.read_bytes(),
            INTRINSICS,
            id=str(number),
            captured_at_ns=time.time_ns(),
        )


def show(answer: fovea.StreamAnswer) -> None:
    found = answer.detections
    if found is None:
        print(f"frame {answer.frame_id}: {answer.error}")
        return
    age_ms = (time.time_ns() - (found.captured_at_ns or 0)) / 1e6
    print(
        f"frame {answer.frame_id}: {len(found.objects)} objects, {age_ms:.0f} ms old, "
        f"{answer.dropped} dropped before it, {answer.lost} lost",
        flush=True,
    )


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("address")
    parser.add_argument("folder", type=Path)
    parser.add_argument("--frames", type=int)
    arguments = parser.parse_args()
    with fovea.Client(arguments.address) as client:
        client.check(timeout=60)  # waits for a server that is not up yet
        # Is opened again when the server was away for up to this long.
        answers = client.stream(camera(arguments.folder, arguments.frames), timeout=60)
        for answer in answers:
            show(answer)


if __name__ == "__main__":
    main()
