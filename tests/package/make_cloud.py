"""Writes the organised cloud of a colour and a depth image as PCD, for the example of PCL.

usage: make_cloud.py COLOR DEPTH FX,FY,CX,CY CLOUD
"""

import sys

import numpy as np
from PIL import Image


def write_cloud(color_path: str, depth_path: str, camera: str, cloud_path: str) -> None:
    fx, fy, cx, cy = (float(number) for number in camera.split(","))
    color = np.asarray(Image.open(color_path).convert("RGB"), dtype=np.uint32)
    z = np.asarray(Image.open(depth_path), dtype=np.float32) / 1000
    z[z == 0] = np.nan
    v, u = np.indices(z.shape)
    points = np.zeros(z.size, dtype=[("x", "<f4"), ("y", "<f4"), ("z", "<f4"), ("rgb", "<u4")])
    points["x"] = ((u - cx) / fx * z).ravel()
    points["y"] = ((v - cy) / fy * z).ravel()
    points["z"] = z.ravel()
    points["rgb"] = (color[..., 0] << 16 | color[..., 1] << 8 | color[..., 2]).ravel()
    header = (
        "VERSION .7\nFIELDS x y z rgb\nSIZE 4 4 4 4\nTYPE F F F U\nCOUNT 1 1 1 1\n"
        f"WIDTH {z.shape[1]}\nHEIGHT {z.shape[0]}\nVIEWPOINT 0 0 0 1 0 0 0\n"
        f"POINTS {z.size}\nDATA binary\n"
    )
    with open(cloud_path, "wb") as file:
        file.write(header.encode() + points.tobytes())


if __name__ == "__main__":
    write_cloud(*sys.argv[1:5])
