"""Reads google.rpc.BadRequest from the trailing metadata `grpc-status-details-bin`.

By the numbers of its fields: with generated modules of our own, programs that have those of
googleapis-common-protos as well could not import both.
"""

from __future__ import annotations

from collections.abc import Iterator

_BAD_REQUEST = b"/google.rpc.BadRequest"
_FIXED_SIZES = {1: 8, 5: 4}  # by wire type


def field_of_details(details: bytes) -> str:
    """Path of the field that the first violation is about; "" where there is none."""
    try:
        for detail in _parts(details, 3):  # google.rpc.Status.details
            if not b"".join(_parts(detail, 1)).endswith(_BAD_REQUEST):  # Any.type_url
                continue
            for bad_request in _parts(detail, 2):  # Any.value
                for violation in _parts(bad_request, 1):  # BadRequest.field_violations
                    for field in _parts(violation, 1):  # FieldViolation.field
                        return field.decode()
    except (IndexError, KeyError, UnicodeDecodeError):  # no such message
        pass
    return ""


def _parts(message: bytes, number: int) -> Iterator[bytes]:
    """The strings, or messages as bytes, of this number in a serialized message."""
    at = 0
    while at < len(message):
        key, at = _varint(message, at)
        if key & 7 == 0:
            _, at = _varint(message, at)
        elif key & 7 == 2:
            size, at = _varint(message, at)
            if key >> 3 == number:
                yield message[at : at + size]
            at += size
        else:
            at += _FIXED_SIZES[key & 7]


def _varint(message: bytes, at: int) -> tuple[int, int]:
    """The number that begins there, and where it ends."""
    value, shift = 0, 0
    while True:
        byte = message[at]
        value |= (byte & 0x7F) << shift
        at, shift = at + 1, shift + 7
        if byte < 0x80:
            return value, at
