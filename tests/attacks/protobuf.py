"""Messages of protobuf by hand."""

from __future__ import annotations

import os
import struct


def varint(value: int) -> bytes:
    low = [value >> shift & 0x7F for shift in range(0, max(1, value.bit_length()), 7)]
    return bytes([each | 0x80 for each in low[:-1]] + [low[-1]])


def field(number: int, value: bytes) -> bytes:
    return varint(number << 3 | 2) + varint(len(value)) + value


def _image(encoding: int, width: int, height: int, pixels: bytes) -> bytes:
    head = b"\x08" + varint(encoding) + b"\x10" + varint(width) + b"\x18" + varint(height)
    return head + field(4, pixels)


def noisy_request(width: int = 1920, height: int = 1080) -> bytes:
    """A DetectRequest with a raw frame in which everything stands out: 10 MB at 1920x1080."""
    lines = 40  # of noise, again and again
    color = os.urandom(3 * width * lines) * (height // lines)
    noise = struct.unpack(f"<{width * lines}H", os.urandom(2 * width * lines))
    depth = struct.pack(f"<{len(noise)}H", *(800 + each % 400 for each in noise))
    intrinsics = struct.pack("<BdBdBdBd", 9, 1000, 17, 1000, 25, width / 2, 33, height / 2)
    fields = field(3, _image(1, width, height, color))
    fields += field(4, _image(1, width, height, depth * (height // lines)))
    return field(1, fields + field(5, intrinsics))


def profile(name: str) -> bytes:
    """DetectOptions.profile = name, appended to a DetectRequest."""
    return field(2, field(1, name.encode()))


def option(name: str, value: float) -> bytes:
    """DetectOptions.parameters[name] = value, appended to a DetectRequest."""
    entry = field(1, name.encode()) + b"\x11" + struct.pack("<d", value)
    return field(2, field(2, entry))
