"""The shortest useful client: two image files in, positions and grasps out.

Set the intrinsics to those of your camera.
"""

import argparse
import sys
from pathlib import Path

import fovea

parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("address", help="of the server, HOST:PORT")
parser.add_argument("color", type=Path, help="PNG or JPEG")
parser.add_argument("depth", type=Path, help="16-bit PNG in millimetres, registered to colour")
arguments = parser.parse_args()
intrinsics = fovea.CameraIntrinsics(fx=525, fy=525, cx=319.5, cy=239.5)
try:
    color, depth = arguments.color.read_bytes(), arguments.depth.read_bytes()
    with fovea.Client(arguments.address) as client:
        found = client.detect(color, depth, intrinsics)
except (fovea.FoveaError, OSError) as error:
    sys.exit(f"detect_once: {error}")

for each in found.objects:
    x, y, z = each.oriented_box.pose[:3, 3]
    print(f"{each.label}: {x:.3f} {y:.3f} {z:.3f} m, {len(each.grasps)} grasps")
