"""Masks from their run lengths."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from fovea.v1 import detection_pb2


def decode_mask(proto: detection_pb2.Mask, height: int, width: int) -> npt.NDArray[np.bool_]:
    """height x width, True = object. Raises ValueError where the message contradicts itself."""
    bounds = proto.bounds
    runs = np.array(proto.runs, dtype=np.int64)
    if runs.sum() != bounds.width * bounds.height:
        raise ValueError(
            f"the mask's runs cover {runs.sum()} pixels, not {bounds.width * bounds.height}"
        )
    if bounds.x + bounds.width > width or bounds.y + bounds.height > height:
        raise ValueError("the mask goes beyond the image")
    inside = np.repeat(np.arange(runs.size) % 2 == 1, runs)
    mask = np.zeros((height, width), dtype=bool)
    rows = slice(bounds.y, bounds.y + bounds.height)
    columns = slice(bounds.x, bounds.x + bounds.width)
    mask[rows, columns] = inside.reshape(bounds.height, bounds.width)
    return mask
