"""Cleans up a floor: takes what is likeliest to hold, of what nothing stands on, and looks again.

`fovea-clean-up` simulates the robot: it writes what the camera sees to the standard input, a
request a line, and does the grasps that come back (docs/clean_up.md).
"""

import argparse
import base64
import json
import sys
from typing import Any

import numpy as np

import fovea

LEAST = 0.01  # likely to hold; it has time, and can try again
HANDS = [
    fovea.Gripper("jaw", max_opening_m=0.14, max_grasps=20, min_probability=LEAST),
    fovea.Gripper("cup", suction_diameter_m=0.03, max_grasps=20, min_probability=LEAST),
]

parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("address", help="of the server, HOST:PORT")
arguments = parser.parse_args()
options = fovea.DetectOptions(grippers=HANDS, return_masks=False)
tried: list[fovea.Grasp] = []


def chance(grasp: fovea.Grasp) -> float:
    """Half as much for each time that it was tried, less for places near it: it did not hold."""
    apart = [np.linalg.norm(grasp.tool_center_point - each.tool_center_point) for each in tried]
    return grasp.probability * float(np.prod([1 - 0.5 * np.exp(-each / 0.05) for each in apart]))


def tell(**decision: Any) -> None:
    plain = lambda value: value.tolist() if isinstance(value, np.ndarray) else vars(value)
    print(json.dumps(decision, default=plain), flush=True)


try:
    with fovea.Client(arguments.address, timeout=60) as client:
        for line in sys.stdin:
            frame = json.loads(line)["frame"]
            color, depth = (base64.b64decode(frame[each]["data"]) for each in ("color", "depth"))
            intrinsics = fovea.CameraIntrinsics(**frame["intrinsics"])
            found = client.detect(color, depth, intrinsics, options=options)

            free = [grasp for each in found.objects if not each.blocked_by for grasp in each.grasps]
            best = max(free, key=chance, default=None)
            if best is None or chance(best) <= LEAST:  # it is not worth the while
                tell(left=found.objects)
            else:
                tell(grasp=best)
                tried.append(best)
except fovea.FoveaError as error:
    sys.exit(f"clean_up: {error}")
