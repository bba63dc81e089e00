"""Messages that do not come to their end."""

from __future__ import annotations

import time
from collections import deque
from contextlib import ExitStack

from http2 import DETECT, HEALTH, REFLECTION, STREAM, Connection, Ended, call, message, reset
from target import Tally, Target, attack, rounds

CHUNK = bytes(16000)
HALF = message(size=15 << 20)  # the beginning of 15 MiB
FEW, MANY = 1, 32
CALLS = 64  # what a connection may have at once
HALVES, IDLE = 12, 4  # streams, of the 16 that a robot may have


def _begin(target: Target, path: str, calls: int) -> Connection:
    connection = target.connect(patience=0.3)
    streams = [connection.next_stream() for _ in range(calls)]
    connection.send(*(call(path, stream) for stream in streams))
    for stream in streams:
        connection.send_data(stream, HALF)
    return connection


def _push(connection: Connection, calls: int, tally: Tally) -> None:
    for number in range(calls):
        tally["bytes"] += connection.send_data(2 * number + 1, CHUNK)
    list(connection.receive(0.001))


def _half_messages(target: Target, path: str, connections: int) -> Tally:
    """Sends on every connection as much as the server takes of messages that it never ends."""
    tally: Tally = Tally()
    held: dict[int, Connection] = {}
    with ExitStack() as stack:
        while target.goes_on():
            for number in range(connections):
                try:
                    if number not in held:
                        held[number] = stack.enter_context(_begin(target, path, CALLS))
                        tally["connections"] += 1
                    _push(held[number], CALLS, tally)
                except (Ended, OSError):
                    tally["ended"] += 1
                    if number in held:
                        held.pop(number).__exit__()
    return tally


@attack("bytes")
def half_a_health_check(target: Target) -> Tally:
    """64 half-sent messages of 15 MiB to health, on one connection"""
    return _half_messages(target, HEALTH, FEW)


@attack("bytes")
def half_frames(target: Target) -> Tally:
    """The same to Detect"""
    return _half_messages(target, DETECT, FEW)


@attack("bytes")
def half_frames_of_streams(target: Target) -> Tally:
    """The same to DetectStream"""
    return _half_messages(target, STREAM, FEW)


@attack("bytes", "ended", setups=("open",))
def half_frames_beside_calls_that_end(target: Target) -> Tally:
    """180 MiB of half-sent messages on a connection, beside streams that are reset one by one"""
    tally: Tally = Tally()
    while target.goes_on():
        try:
            with _begin(target, STREAM, HALVES) as connection:
                _push_beside_calls_that_end(target, connection, tally)
        except (Ended, OSError):
            tally["ended"] += 1
    return tally


def _push_beside_calls_that_end(target: Target, connection: Connection, tally: Tally) -> None:
    idle: deque[int] = deque()
    while target.goes_on():
        idle.append(connection.next_stream())
        connection.send(call(STREAM, idle[-1]))
        if len(idle) == IDLE:
            _push(connection, HALVES, tally)
            connection.send(reset(idle.popleft()))


@attack("bytes")
def many_half_health_checks(target: Target) -> Tally:
    """64 half-sent messages to health on each of 32 connections, from 16 hosts"""
    return _half_messages(target, HEALTH, MANY)


@attack("bytes")
def many_half_frames(target: Target) -> Tally:
    """The same to Detect"""
    return _half_messages(target, DETECT, MANY)


@attack("bytes")
def many_half_frames_of_streams(target: Target) -> Tally:
    """The same to DetectStream"""
    return _half_messages(target, STREAM, MANY)


@attack("bytes")
def half_reflections(target: Target) -> Tally:
    """The same to reflection, on one connection"""
    return _half_messages(target, REFLECTION, FEW)


@attack("bytes")
def dribble(target: Target) -> Tally:
    """64 frames that come byte by byte, in a DATA frame each"""
    tally: Tally = Tally()
    for survived in rounds(target, tally):
        with survived, _begin(target, DETECT, CALLS) as connection:
            while target.goes_on():
                for number in range(CALLS):
                    tally["bytes"] += connection.send_data(2 * number + 1, b"x")
                list(connection.receive(0.001))
    return tally


@attack("calls", setups=("open",))
def vanishing_uploads(target: Target) -> Tally:
    """Half a frame, and the connection is gone"""
    tally: Tally = Tally()
    for survived in rounds(target, tally):
        with survived, target.connect() as connection:
            stream = connection.next_stream()
            connection.send(call(DETECT, stream))
            connection.send_data(stream, message(target.request)[: len(target.request) // 2])
            tally["calls"] += 1
    return tally


@attack("calls")
def impossible_lengths(target: Target) -> Tally:
    """Messages that are said to be 4 GiB, and ones with flags that nobody knows"""
    tally: Tally = Tally()
    for survived in rounds(target, tally):
        for prefix in (message(size=2**32 - 1), b"\xff\xff\xff\xff\xff"):
            for path in (HEALTH, DETECT, STREAM, REFLECTION):
                with survived, target.connect() as connection:
                    tally["calls"] += 1
                    connection.ask(path, prefix + CHUNK, 0.2)
        time.sleep(0.01)
    return tally
