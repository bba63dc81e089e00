"""How wrong sizes are on frames of other people's cameras that show things of the YCB set.

usage: known_sizes.py SERVER REAL_FOLDER      (PYTHONPATH: that of the Python client)

The sizes are those of Calli et al. 2015 ("The YCB Object and Model Set"), millimetres, each thing as
it stands or lies; compared one by one from the largest to the smallest with those of the found
object's completed box. A thing is found if the IoU of the boxes in the image is above 0.5.
"""

import json
import sys
from pathlib import Path
from statistics import median

import fovea

SIZES_MM = {
    "cracker box": (230, 160, 60),
    "cheezit": (230, 160, 60),
    "sugar box": (175, 89, 38),
    "sugar": (175, 89, 38),
    "mustard bottle": (175, 85, 50),
    "mustard": (175, 85, 50),
    "soup can": (101, 66, 66),
    "tuna can": (85, 85, 33),
    "coffee can": (139, 102, 102),
    "spam can": (97, 82, 50),
    "bleach bottle": (250, 98, 65),
    "red bowl": (159, 159, 53),
}


def iou(found: fovea.BoundingBox2D, box: list[int]) -> float:
    """`box`: x0, y0, x1, y1, as boxes.json has it."""
    x0, y0, x1, y1 = box
    width = min(x1, found.x + found.width) - max(x0, found.x)
    height = min(y1, found.y + found.height) - max(y0, found.y)
    shared = max(0, width) * max(0, height)
    return shared / (found.width * found.height + (x1 - x0) * (y1 - y0) - shared)


def most_alike(objects: list[fovea.Object], box: list[int]) -> fovea.Object | None:
    """Of those whose box has an IoU above 0.5 with this one."""
    found = [each for each in objects if iou(each.bounding_box, box) > 0.5]
    return max(found, key=lambda each: iou(each.bounding_box, box)) if found else None


def main() -> None:
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    address, folder = sys.argv[1], Path(sys.argv[2])
    errors: list[float] = []
    with fovea.Client(address, timeout=60) as client:
        for source in ("posecnn", "sixdof"):
            fx, fy, cx, cy = map(float, (folder / source / "intrinsics.txt").read_text().split(","))
            intrinsics = fovea.CameraIntrinsics(fx=fx, fy=fy, cx=cx, cy=cy)
            frames = json.loads((folder / source / "boxes.json").read_text())
            for name, things in frames.items():
                path = folder / source / name
                frame = fovea.read_frame(f"{path}_color.png", f"{path}_depth.png")
                found = client.detect(*frame, intrinsics)
                for thing in things:
                    if thing["name"] not in SIZES_MM:
                        continue
                    label = f"{source}/{name} {thing['name']}"
                    best = most_alike(found.objects, thing["box"])
                    if best is None:
                        print(f"{label:34} not found")
                        continue
                    sizes = sorted(
                        (1000 * float(size) for size in best.oriented_box.size), reverse=True
                    )
                    true = SIZES_MM[thing["name"]]
                    errors += [abs(a - b) for a, b in zip(sizes, true)]
                    said = " x ".join(f"{size:.0f}" for size in sizes)
                    print(f"{label:34} {said:18} is {' x '.join(map(str, true))}")
    print(f"{len(errors)} sizes, median error {median(errors):.1f} mm")


if __name__ == "__main__":
    main()
