"""Frames from files."""

from __future__ import annotations

import io
import os
from typing import Any

import numpy as np
import numpy.typing as npt

from fovea.errors import InvalidArgument, MissingPackage


# No server takes a larger message.
_LARGEST_FILE = 1 << 30


class BrokenImage(InvalidArgument, OSError):
    """The file is cut off, or no image. An OSError, too, as for files that cannot be opened."""

    def __reduce__(self) -> tuple[Any, ...]:
        """For pickle: of two kinds of exceptions, __new__ is not the first one's."""
        return BrokenImage, (self.field, self.message.removeprefix(f"{self.field}: "))


def read_frame(
    color: str | os.PathLike[str], depth: str | os.PathLike[str]
) -> tuple[npt.NDArray[np.uint8], npt.NDArray[np.uint16]]:
    """A colour image (PNG or JPEG) and a 16-bit PNG of depth, as Client.detect takes them: HxWx3
    uint8 RGB, HxW uint16 in the file's units with 0 = not measured. Pixels as stored, whatever EXIF
    says, without alpha.

        color, depth = fovea.read_frame("a_color.png", "a_depth.png")

    Raises OSError where a file cannot be opened; InvalidArgument where depth has not 16 bits,
    colour has not 8, or a file is broken, then an OSError as well; MissingPackage without Pillow.
    """
    file = _bytes_of(color, "frame.color")
    image = _read(file, os.fspath(color), "frame.color")
    if image.mode.startswith(("I", "F")) or _is_png_of_16_bits(file):
        raise InvalidArgument("frame.color", f"{os.fspath(color)} is not an image of 8 bits")
    measured = _read(_bytes_of(depth, "frame.depth"), os.fspath(depth), "frame.depth")
    return np.array(image.convert("RGB")), _depth_of(measured, os.fspath(depth))


def _is_png_of_16_bits(file: bytes) -> bool:
    # Pillow keeps the upper half of each colour, which is nearly black where a camera has 12 bits.
    bit_depth_at = 24  # in the header, which comes first
    return file.startswith(b"\x89PNG") and file[bit_depth_at] == 16


def _depth_of(image: Any, path: str) -> npt.NDArray[np.uint16]:
    # Pillow reads grey images of 16 bits as "I" (int32) up to version 9, later as "I;16".
    if image.format != "PNG" or not image.mode.startswith("I"):
        raise InvalidArgument("frame.depth", f"{path} is not a PNG of 16 bits a pixel")
    return np.array(image).astype(np.uint16)


def _bytes_of(path: str | os.PathLike[str], field: str) -> bytes:
    file = bytearray()
    with open(os.fspath(path), "rb") as opened:
        while part := opened.read(1 << 20):  # a device has no end
            file += part
            if len(file) > _LARGEST_FILE:
                raise BrokenImage(field, f"{os.fspath(path)} has more than 1 GiB")
    return bytes(file)


def _read(file: bytes, path: str, field: str) -> Any:
    try:
        from PIL import Image, UnidentifiedImageError
    except ImportError:
        raise MissingPackage("png", "python3-pil") from None
    try:
        image = Image.open(io.BytesIO(file))
        image.load()  # else the pixels are read later, where nothing knows the file
    except MemoryError:
        raise
    except UnidentifiedImageError:
        raise BrokenImage(field, f"{path} is not an image") from None
    except Exception as error:  # Pillow raises many kinds for what is broken
        raise BrokenImage(field, f"{path} cannot be read: {error}") from error
    return image
