"""Calls that are well made and ill meant."""

from __future__ import annotations

import time
from collections.abc import Sequence
from itertools import cycle, product

from http2 import DETECT, HEALTH, INFO, STREAM, Kind, call, is_end, message
from protobuf import field
from target import Tally, Target, attack, rounds

Header = tuple[str | bytes, str | bytes]


def _calls(target: Target, path: str, headers: Sequence[Header], body: bytes, tally: Tally) -> None:
    """One call, to its end; counts whether the server answered."""
    with target.connect() as connection:
        tally["calls"] += 1
        tally["answered"] += b"grpc-status" in connection.ask(path, body, 3.0, *headers)


@attack("answered", setups=("open",))
def invented_names(target: Target) -> Tally:
    """Whole frames, each by a robot that was never heard of"""
    tally: Tally = Tally()
    for survived in rounds(target, tally):
        with survived:
            headers = [("fovea-robot", f"invented-{time.monotonic_ns()}")]
            _calls(target, DETECT, headers, message(target.request), tally)
    return tally


@attack("names", setups=("open",))
def thousands_of_names(target: Target) -> Tally:
    """Names by the thousand, with frames that are none"""
    tally: Tally = Tally()
    for survived in rounds(target, tally):
        with survived, target.connect() as connection:
            for _ in range(200):
                stream = connection.next_stream()
                name = ("fovea-robot", f"robot {time.monotonic_ns()}")
                connection.send(call(DETECT, stream, name))
                connection.send_data(stream, message(b"\xff\xff"), end=True)
                tally["names"] += 1
                list(connection.receive(0.001))
    return tally


BAD_NAMES = [b"\xff\xfe\x80", b"\x00", b"a\r\nb: c", b"n" * 7000, b'" code=OK', b""]
BAD_KEYS = [b"fovea-robot", b"fovea-request-id", b"traceparent", b"authorization", b"grpc-timeout"]


@attack("calls")
def bad_metadata(target: Target) -> Tally:
    """Names, request ids and deadlines of bytes that are no text"""
    tally: Tally = Tally()
    for survived in rounds(target, tally):
        for key in BAD_KEYS:
            for value in BAD_NAMES if target.goes_on() else ():
                with survived:
                    _calls(target, INFO, [(key, value)], message(), tally)
    return tally


@attack("calls", setups=("open",))
def bad_text_in_frames(target: Target) -> Tally:
    """Frame ids that are no UTF-8, empty or long, which end up in the log"""
    tally: Tally = Tally()
    for survived in rounds(target, tally):
        for name in BAD_NAMES:
            body = field(1, field(1, name))  # DetectRequest.frame.id
            with survived:
                _calls(target, DETECT, [], message(body), tally)
    return tally


@attack("answered", setups=("tokens", "tls"))
def bad_tokens(target: Target) -> Tally:
    """Tokens that are tried one after the other"""
    tally: Tally = Tally()
    for survived in rounds(target, tally):
        with survived:
            token = ("authorization", f"Bearer {time.monotonic_ns():064x}")
            _calls(target, (DETECT, STREAM, INFO)[tally["rounds"] % 3], [token], message(), tally)
    return tally


@attack("refused", setups=("tokens",))
def frames_without_token(target: Target) -> Tally:
    """Whole frames without a token, 50 at a time on a connection"""
    tally: Tally = Tally()
    for survived in rounds(target, tally):
        with survived, target.connect() as connection:
            streams = [connection.next_stream() for _ in range(50)]
            connection.send(*(call(DETECT, stream) for stream in streams))
            for stream in streams:
                connection.send_data(stream, message(target.request), end=True)
            while target.goes_on():
                heard = list(connection.receive(0.1))
                tally["refused"] += sum(kind == Kind.HEADERS for kind, *_ in heard)
                if not heard:
                    break
    return tally


@attack("calls", setups=("open",))
def expired_deadlines(target: Target) -> Tally:
    """Whole frames whose deadline passes before anybody can look at them"""
    tally: Tally = Tally()
    for survived in rounds(target, tally):
        timeout = ("grpc-timeout", ("1n", "0S", "5m", "-1S")[tally["rounds"] % 4])
        with survived:
            _calls(target, DETECT, [timeout], message(target.request), tally)
    return tally


@attack("answered", setups=("open",))
def nested_messages(target: Target) -> Tally:
    """Messages of groups within groups, and of fields that nobody knows"""
    tally: Tally = Tally()
    bodies = [b"\x0b" * 100_000, (b"\xfa\xff\x01\x02hi") * 20_000, b"\x0a\xff\xff\xff\xff\x0f"]
    for survived in rounds(target, tally):
        for path in (DETECT, STREAM, INFO, HEALTH):
            for body in bodies:
                with survived:
                    _calls(target, path, [], message(body), tally)
    return tally


@attack("bytes", setups=("open",))
def swelling_messages(target: Target) -> Tally:
    """Megabytes of messages in a message that are empty, and take a hundred bytes each once parsed"""
    tally: Tally = Tally()
    grippers = field(2, field(10, b"\x0a\x00" * (4 << 20)))
    bodies = [message(grippers), message(b"\x7b\x7c" * (4 << 20))]
    kinds = cycle(product((DETECT, STREAM, INFO), bodies))
    for survived, (path, body) in zip(rounds(target, tally), kinds):
        with survived, target.connect() as connection:
            stream, sent, ended = connection.next_stream(), 0, False
            connection.send(call(path, stream))
            while sent < len(body) and not ended and target.goes_on():
                some = connection.send_data(stream, body[sent : sent + (1 << 17)], end=False)
                sent += some
                tally["bytes"] += some
                for kind, flags, of, _ in connection.receive(0.01):
                    ended |= of == stream and is_end(kind, flags)
    return tally
