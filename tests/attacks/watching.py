"""The port of metrics, which asks for no token."""

from __future__ import annotations

import socket
import time

from target import Tally, Target, attack


@attack("connections")
def slow_metrics(target: Target) -> Tally:
    """200 connections to the metrics that send a header a byte at a time"""
    tally: Tally = Tally()
    held: list[socket.socket] = []
    while target.goes_on():
        try:
            if len(held) < 200:
                held.append(target.dial(port=target.metrics_port))
                tally["connections"] += 1
            one = held[tally["rounds"] % len(held)]
            one.sendall(b"GET /metrics HTTP/1.1\r\nx: "[tally["rounds"] // 200 % 27 :][:1])
            tally["rounds"] += 1
        except OSError:
            held.pop(tally["rounds"] % max(1, len(held))).close()
            tally["ended"] += 1
    for each in held:
        each.close()
    return tally


@attack("questions")
def garbage_to_metrics(target: Target) -> Tally:
    """Requests to the metrics that are none, too long, or of which nobody takes the answer"""
    tally: Tally = Tally()
    words = [b"\x16\x03\x01\x00" * 100, b"GET /" + b"a" * 100_000, b"POST /metrics HTTP/1.1\r\n"]
    words += [b"GET /metrics HTTP/1.1\r\n" + b"x: y\r\n" * 5000, b"GET /metrics HTTP/1.1\r\n\r\n"]
    words += [b"GET /metrics HTTP/1.1\r\nContent-Length: 99999999999\r\n\r\n" + bytes(5000)]
    while target.goes_on():
        try:
            with target.dial(port=target.metrics_port) as one:
                one.sendall(words[tally["questions"] % len(words)])
                tally["questions"] += 1
                one.settimeout(0.02)
                one.recv(100)
        except OSError:
            tally["ended"] += 1
        time.sleep(0.001)
    return tally
