"""The shortest useful client: two image files in, positions and grasps out.

usage: detect_once.py ADDRESS COLOR DEPTH   (PNG or JPEG; 16-bit PNG in millimetres)
"""

import sys
from pathlib import Path

import fovea

address, color, depth = sys.argv[1:]
intrinsics = fovea.CameraIntrinsics(fx=525, fy=525, cx=319.5, cy=239.5)
try:
    with fovea.Client(address) as client:
        found = client.detect(Path(color).read_bytes(), Path(depth).read_bytes(), intrinsics)
except fovea.FoveaError as error:
    sys.exit(f"detect_once: {error}")

for each in found.objects:
    x, y, z = each.oriented_box.pose[:3, 3]
    print(f"{each.label}: {x:.3f} {y:.3f} {z:.3f} m, {len(each.grasps)} grasps")
