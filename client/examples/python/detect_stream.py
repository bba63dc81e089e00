"""A live loop: frames go out as fast as the camera has them, the newest is always answered.

The camera here plays the files NAME_color.png (or .jpg) and NAME_depth.png of a folder over and
over, at 10 Hz; put your driver in its place.
"""

import argparse
import itertools
import time
from collections.abc import Iterator
from pathlib import Path

import fovea

RATE_HZ = 10
INTRINSICS = fovea.CameraIntrinsics(fx=525, fy=525, cx=319.5, cy=239.5)


def camera(folder: Path, num_frames: int | None) -> Iterator[fovea.Frame]:
    colors = sorted([*folder.glob("*_color.png"), *folder.glob("*_color.jpg")])
    if not colors:
        raise SystemExit(f"{folder}: no NAME_color.png or .jpg")
    for number, color in enumerate(itertools.islice(itertools.cycle(colors), num_frames)):
        depth = color.with_name(color.stem.removesuffix("_color") + "_depth.png")
        yield fovea.Frame(
            color.read_bytes(),
            depth.read_bytes(),
            INTRINSICS,
            id=str(number),
            captured_at_ns=time.time_ns(),
        )
        time.sleep(1 / RATE_HZ)  # else it would send as fast as the network takes it


def show(answer: fovea.StreamAnswer) -> None:
    found = answer.detections
    if found is None:
        print(f"frame {answer.frame_id}: {answer.error}")
        return
    noun = "object" if len(found.objects) == 1 else "objects"
    age_ms = (time.time_ns() - (found.captured_at_ns or 0)) / 1e6
    print(
        f"frame {answer.frame_id}: {len(found.objects)} {noun}, {age_ms:.0f} ms old, "
        f"{answer.dropped} dropped before it, {answer.lost} lost",
        flush=True,
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("address", help="of the server, HOST:PORT")
    parser.add_argument("folder", type=Path)
    parser.add_argument("--frames", type=int, help="after which it ends; else it goes on")
    arguments = parser.parse_args()
    with fovea.Client(arguments.address) as client:
        client.check(timeout=60)  # waits for a server that is not up yet
        # Is opened again when the server was away for up to this long.
        answers = client.stream(camera(arguments.folder, arguments.frames), timeout=60)
        for answer in answers:
            show(answer)


if __name__ == "__main__":
    main()
