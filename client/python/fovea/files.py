"""Frames from files."""

from __future__ import annotations

import os
from typing import Any

import numpy as np
import numpy.typing as npt

from fovea.errors import InvalidArgument, MissingPackage


def read_frame(
    color: str | os.PathLike[str], depth: str | os.PathLike[str]
) -> tuple[npt.NDArray[np.uint8], npt.NDArray[np.uint16]]:
    """A colour image (PNG or JPEG) and a 16-bit PNG of depth, as Client.detect takes them: HxWx3
    uint8 RGB, HxW uint16 in the file's units with 0 = not measured. Pixels as stored, whatever EXIF
    says, without alpha.

        color, depth = fovea.read_frame("a_color.png", "a_depth.png")

    Raises OSError where a file cannot be read, InvalidArgument where depth has not 16 bits, and
    MissingPackage without Pillow.
    """
    image = _open(color)
    if image.mode.startswith(("I", "F")):
        raise InvalidArgument("frame.color", f"{os.fspath(color)} is not an image of 8 bits")
    return np.array(image.convert("RGB")), _depth_of(_open(depth), os.fspath(depth))


def _depth_of(image: Any, path: str) -> npt.NDArray[np.uint16]:
    # Pillow reads grey images of 16 bits as "I" (int32) up to version 9, later as "I;16".
    if image.format != "PNG" or not image.mode.startswith("I"):
        raise InvalidArgument("frame.depth", f"{path} is not a PNG of 16 bits a pixel")
    return np.array(image).astype(np.uint16)


def _open(path: str | os.PathLike[str]) -> Any:
    try:
        from PIL import Image
    except ImportError:
        raise MissingPackage("png", "python3-pil") from None
    return Image.open(os.fspath(path))
