"""Images of a request from arrays or whole files, in the encodings of the contract."""

from __future__ import annotations

import io
import os
from typing import Any

import numpy as np

from fovea.checks import positive
from fovea.errors import InvalidArgument, MissingPackage
from fovea.v1 import frame_pb2

JPEG_QUALITY = 90
_COLOR, _DEPTH, _UNIT = "frame.color", "frame.depth", "frame.depth.unit_m"


def make_color_image(color: Any, encoding: str = "rgb8") -> frame_pb2.ColorImage:
    """HxWx3 uint8, or the bytes of a PNG or JPEG file, which are sent as they are.

    encoding: "rgb8" (as it is, lossless), "bgr8" (the same for arrays in the order blue, green,
    red), "png" (RGB array, lossless) or "jpeg" (RGB array, lossy).
    """
    if isinstance(color, (bytes, bytearray, memoryview)):
        return _color_file(bytes(color))
    _require_array(color, _COLOR, ("uint8",), "HxWx3 uint8")
    if np.any(getattr(color, "mask", False)):
        raise InvalidArgument(_COLOR, "has masked pixels; give them a colour with filled()")
    if color.ndim != 3 or color.shape[2] != 3:
        raise InvalidArgument(_COLOR, f"has the shape {color.shape}, not HxWx3")
    if encoding in ("rgb8", "bgr8"):
        number = getattr(frame_pb2, f"COLOR_ENCODING_{encoding.upper()}")
        return frame_pb2.ColorImage(encoding=number, data=color.tobytes(), **_size_of(color))
    if encoding == "png":
        return _color_file(_file_of(color, "png", compress_level=1))
    if encoding == "jpeg":
        return _color_file(_file_of(color, "jpeg", quality=JPEG_QUALITY))
    raise InvalidArgument(f"{_COLOR}.encoding", f'"{encoding}" is not one of rgb8, bgr8, png, jpeg')


def make_depth_image(
    depth: Any, encoding: str = "raw", unit_m: float | None = None
) -> frame_pb2.DepthImage:
    """HxW uint16 in units of `unit_m` metres (None: 0.001) with 0 = not measured, or any integers
    that fit into it (Pillow 9 reads 16-bit PNG files as int32; of 8 bits only with `unit_m`); or
    HxW float32 in metres, where NaN or <= 0 = not measured, without `unit_m`; or the bytes of a
    16-bit PNG file, which are sent as they are. What a masked array masks is not measured.

    encoding: "raw", "zstd" or "png" (uint16 only). All are lossless.
    """
    if isinstance(depth, (bytes, bytearray, memoryview)):
        return _depth_file(bytes(depth), unit_m)
    if isinstance(depth, np.ma.MaskedArray):
        depth = _filled(depth)
    if isinstance(depth, np.ndarray) and np.issubdtype(depth.dtype, np.integer):
        _require_16_bits(depth, unit_m)
        depth = _as_uint16(depth)
    _require_array(depth, _DEPTH, ("uint16", "float32"), "HxW uint16 or float32")
    if depth.ndim != 2:
        raise InvalidArgument(_DEPTH, f"has the shape {depth.shape}, not HxW")
    kind = "16UC1" if depth.dtype.name == "uint16" else "32FC1"
    if kind == "32FC1" and unit_m is not None:
        raise InvalidArgument(
            _UNIT, "float depth is in metres; depth_unit_m is for depth in integers, leave it out"
        )
    if encoding == "png":
        if kind != "16UC1":
            raise InvalidArgument(f"{_DEPTH}.encoding", '"png" holds uint16 only, not float32')
        return _depth_file(_file_of(depth, "png", compress_level=1), unit_m)
    if encoding not in ("raw", "zstd"):
        raise InvalidArgument(f"{_DEPTH}.encoding", f'"{encoding}" is not one of raw, zstd, png')
    data = depth.astype(depth.dtype.newbyteorder("<"), copy=False).tobytes()
    if encoding == "zstd":
        data, kind = _zstd_of(data), kind + "_ZSTD"
    number = getattr(frame_pb2, f"DEPTH_ENCODING_{kind}")
    size = _size_of(depth)
    return frame_pb2.DepthImage(encoding=number, data=data, unit_m=_unit_of(unit_m), **size)


def _require_array(image: Any, field: str, dtypes: tuple[str, ...], expected: str) -> None:
    if isinstance(image, (str, os.PathLike)):
        problem = (
            f"is a path, not an array of {expected}; fovea.read_frame(color, depth) reads files"
        )
        raise InvalidArgument(field, problem)
    if not isinstance(image, np.ndarray):
        hint = "; np.asarray(image) is one" if hasattr(image, "__array_interface__") else ""
        problem = f"is {type(image).__name__}, not an array of {expected}{hint}"
        raise InvalidArgument(field, problem)
    if image.dtype.name not in dtypes:
        is_wider = image.dtype.kind == "f" and "float32" in dtypes
        hint = "; .astype(np.float32) makes it that" if is_wider else ""
        raise InvalidArgument(field, f"is an array of {image.dtype.name}, not {expected}{hint}")
    if image.size == 0:
        raise InvalidArgument(field, f"is empty: its shape is {image.shape}")


def _filled(depth: Any) -> Any:
    """With what stands for "not measured", whatever the array's own fill_value is."""
    if depth.dtype.kind not in "iuf":
        return depth  # and is refused
    return depth.filled(np.nan if depth.dtype.kind == "f" else 0)


def _require_16_bits(depth: Any, unit_m: float | None) -> None:
    """Pictures of depth have 8 bits; whoever has depth of 8 bits knows its unit."""
    if depth.dtype.itemsize == 1 and depth.ndim == 2 and unit_m is None:
        raise InvalidArgument(
            _DEPTH,
            f"is an array of {depth.dtype.name}, in millimetres nothing beyond 0.255 m: a picture "
            "of depth? Give uint16 or float32, or depth_unit_m with it",
        )


def _as_uint16(depth: Any) -> Any:
    if depth.dtype.name == "uint16" or depth.size == 0:
        return depth.astype(depth.dtype.newbyteorder("="), copy=False)
    low, high = int(depth.min()), int(depth.max())
    if low < 0 or high > 65535:
        raise InvalidArgument(
            _DEPTH,
            f"is an array of {depth.dtype.name} with values from {low} to {high}, which uint16 "
            "does not hold",
        )
    return depth.astype(np.uint16)


def _size_of(image: Any) -> dict[str, int]:
    return {"width": image.shape[1], "height": image.shape[0]}


def _is_png(file: bytes) -> bool:
    return file.startswith(b"\x89PNG\r\n\x1a\n")


def _color_file(file: bytes) -> frame_pb2.ColorImage:
    if _is_png(file):
        return frame_pb2.ColorImage(encoding=frame_pb2.COLOR_ENCODING_PNG, data=file)
    if file.startswith(b"\xff\xd8\xff"):
        return frame_pb2.ColorImage(encoding=frame_pb2.COLOR_ENCODING_JPEG, data=file)
    raise InvalidArgument(f"{_COLOR}.data", "is neither a PNG nor a JPEG file")


def _unit_of(unit_m: float | None) -> float:
    return 0.001 if unit_m is None else positive(unit_m, _UNIT, "depth_unit_m")


def _depth_file(file: bytes, unit_m: float | None) -> frame_pb2.DepthImage:
    if not _is_png(file):
        raise InvalidArgument(f"{_DEPTH}.data", "is not a PNG file")
    encoding = frame_pb2.DEPTH_ENCODING_16UC1_PNG
    return frame_pb2.DepthImage(encoding=encoding, data=file, unit_m=_unit_of(unit_m))


def _file_of(image: Any, kind: str, **settings: Any) -> bytes:
    try:
        from PIL import Image
    except ImportError:
        raise MissingPackage(kind, "python3-pil") from None
    file = io.BytesIO()
    Image.fromarray(np.ascontiguousarray(image)).save(file, kind, **settings)
    return file.getvalue()


def _zstd_of(data: bytes) -> bytes:
    try:
        import zstandard
    except ImportError:
        raise MissingPackage("zstd", "python3-zstandard") from None
    return bytes(zstandard.ZstdCompressor(level=1).compress(data))
