"""HTTP/2 and gRPC by hand, so that a client can do what no library would let it."""

from __future__ import annotations

import socket
import struct
import time
from collections.abc import Iterator
from enum import IntEnum

PREFACE = b"PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n"
END_STREAM, END_HEADERS, ACK = 1, 4, 1
MAX_FRAME = 16384
FIRST_WINDOW = 65535

HEALTH = "/grpc.health.v1.Health/Check"
WATCH = "/grpc.health.v1.Health/Watch"
DETECT = "/fovea.v1.DetectionService/Detect"
STREAM = "/fovea.v1.DetectionService/DetectStream"
INFO = "/fovea.v1.DetectionService/GetServerInfo"
REFLECTION = "/grpc.reflection.v1alpha.ServerReflection/ServerReflectionInfo"


class Kind(IntEnum):
    DATA = 0
    HEADERS = 1
    RST_STREAM = 3
    SETTINGS = 4
    PING = 6
    GOAWAY = 7
    WINDOW_UPDATE = 8
    CONTINUATION = 9


class Setting(IntEnum):
    HEADER_TABLE_SIZE = 1
    INITIAL_WINDOW_SIZE = 4
    MAX_FRAME_SIZE = 5


def frame(kind: Kind, flags: int = 0, stream: int = 0, payload: bytes = b"") -> bytes:
    length = struct.pack(">I", len(payload))[1:]
    return length + bytes([kind, flags]) + struct.pack(">I", stream) + payload


def setting(which: Setting, value: int) -> bytes:
    return struct.pack(">HI", which, value)


def _length(size: int) -> bytes:
    """HPACK's integer with a prefix of 7 bits."""
    if size < 127:
        return bytes([size])
    rest, size = bytearray([127]), size - 127
    while size >= 128:
        rest.append(size % 128 + 128)
        size //= 128
    return bytes(rest) + bytes([size])


def literal(name: str | bytes, value: str | bytes, indexed: bool = False) -> bytes:
    """A header for HPACK; `indexed` ones the server has to keep in its table."""
    coded = b"\x40" if indexed else b"\x00"
    for text in (name, value):
        octets = text if isinstance(text, bytes) else text.encode()
        coded += _length(len(octets)) + octets
    return coded


def call_block(path: str, *more: tuple[str | bytes, str | bytes]) -> bytes:
    """The headers of a gRPC call, coded: POST, http, and literals."""
    fields = [
        (":path", path),
        (":authority", "fovea"),
        ("content-type", "application/grpc"),
        ("te", "trailers"),
        *more,
    ]
    return b"\x83\x86" + b"".join(literal(name, value) for name, value in fields)


def call(path: str, stream: int, *more: tuple[str | bytes, str | bytes]) -> bytes:
    return frame(Kind.HEADERS, END_HEADERS, stream, call_block(path, *more))


def message(payload: bytes = b"", compressed: bool = False, size: int | None = None) -> bytes:
    """As gRPC puts it into DATA; `size` is what its prefix says, if not the truth."""
    return struct.pack(">BI", compressed, len(payload) if size is None else size) + payload


def reset(stream: int, code: int = 8) -> bytes:
    return frame(Kind.RST_STREAM, 0, stream, struct.pack(">I", code))


def is_end(kind: int, flags: int) -> bool:
    """Whether this frame ends its stream."""
    closing = kind in (Kind.HEADERS, Kind.DATA) and bool(flags & END_STREAM)
    return closing or kind == Kind.RST_STREAM


class Ended(Exception):
    """The server ended the connection, or takes nothing more."""


class Connection:
    """One connection, which keeps to the windows that the server gives unless told otherwise."""

    def __init__(self, raw: socket.socket, settings: bytes = b"", patience: float = 2.0) -> None:
        raw.settimeout(patience)
        self._socket = raw
        self._received = bytearray()
        self._first_window = FIRST_WINDOW
        self._windows = {0: FIRST_WINDOW}
        self.streams = 0
        self.send(PREFACE, frame(Kind.SETTINGS, payload=settings))

    def __enter__(self) -> Connection:
        return self

    def __exit__(self, *_: object) -> None:
        self._socket.close()

    def next_stream(self) -> int:
        self.streams += 1
        return 2 * self.streams - 1

    def send(self, *frames: bytes) -> None:
        try:
            self._socket.sendall(b"".join(frames))
        except OSError as error:
            raise Ended(str(error)) from error

    def receive(self, wait: float = 0.0) -> Iterator[tuple[Kind | int, int, int, bytes]]:
        """Frames that have come, or come within `wait` seconds: kind, flags, stream, payload."""
        self._fill(wait)
        while len(self._received) >= 9:
            size = int.from_bytes(self._received[:3], "big")
            if len(self._received) < 9 + size:
                return
            kind, flags = self._received[3], self._received[4]
            stream = int.from_bytes(self._received[5:9], "big")
            payload = bytes(self._received[9 : 9 + size])
            del self._received[: 9 + size]
            self._note(kind, flags, stream, payload)
            yield kind, flags, stream, payload

    def ask(
        self, path: str, body: bytes, patience: float, *more: tuple[str | bytes, str | bytes]
    ) -> bytes:
        """A call with this body, as far as the server takes it; returns all that came meanwhile, in which
        HPACK's literals can be searched."""
        stream = self.next_stream()
        self.send(call(path, stream, *more))
        said, sent, silent_since = b"", 0, time.monotonic()
        while time.monotonic() - silent_since < patience:
            some = self.send_data(stream, body[sent:], end=True)
            sent += some
            heard = list(self.receive(0.01))
            if some or heard:
                silent_since = time.monotonic()
            for kind, flags, of, payload in heard:
                said += bytes([kind]) + payload
                if kind == Kind.GOAWAY or of == stream and is_end(kind, flags):
                    return said
        raise Ended("no answer")

    def send_data(self, stream: int, data: bytes, end: bool = False) -> int:
        """As much as the windows let through; returns how much that was."""
        sent = 0
        while sent < len(data):
            size = min(MAX_FRAME, len(data) - sent, self._windows[0], self._window(stream))
            if size <= 0:
                return sent
            last = end and sent + size == len(data)
            flags = END_STREAM if last else 0
            self.send(frame(Kind.DATA, flags, stream, data[sent : sent + size]))
            self._windows[0] -= size
            self._windows[stream] = self._window(stream) - size
            sent += size
        return sent

    def _window(self, stream: int) -> int:
        return self._windows.get(stream, 0) + (self._first_window if stream else 0)

    def _fill(self, wait: float) -> None:
        patience = self._socket.gettimeout()
        self._socket.settimeout(max(wait, 1e-4))
        try:
            some = self._socket.recv(1 << 20)
            if not some:
                raise Ended("closed")
            self._received += some
        except TimeoutError:
            pass
        except OSError as error:
            raise Ended(str(error)) from error
        finally:
            self._socket.settimeout(patience)

    def _note(self, kind: int, flags: int, stream: int, payload: bytes) -> None:
        if kind == Kind.WINDOW_UPDATE:
            more = int.from_bytes(payload, "big")
            self._windows[stream] = self._windows.get(stream, 0) + more
        elif kind == Kind.SETTINGS and not flags & ACK:
            for which, value in struct.iter_unpack(">HI", payload):
                if which == Setting.INITIAL_WINDOW_SIZE:
                    self._first_window = value
            self.send(frame(Kind.SETTINGS, ACK))
