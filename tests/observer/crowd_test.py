"""Connections that ask for nothing, or never to the end: they take no place from others."""

from __future__ import annotations

import http.client
import socket
import time
from collections.abc import Iterator
from contextlib import ExitStack

import pytest
from conftest import Robots, Scene
from processes import OBSERVERS, PATIENCE, Events, ObserverProcess, ServerProcess, Visitor

MAX_CONNECTIONS = 256
UNREAD = 40 * b"GET /page.js HTTP/1.1\r\nHost: localhost\r\n\r\n"  # more than sockets hold
TO_CLOSE = 30.0  # seconds; half of what a connection may be idle between requests


@pytest.fixture
def alone(server: ServerProcess) -> Iterator[ObserverProcess]:
    """Of no other test, which its crowds would disturb."""
    with ObserverProcess(server.address) as process:
        yield process


def connect(observer: ObserverProcess, text: bytes = b"") -> socket.socket:
    host, port = observer.address.split(":")
    connection = socket.socket()
    connection.settimeout(PATIENCE)
    connection.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
    connection.connect((host, int(port)))
    connection.sendall(text)
    return connection


@pytest.mark.parametrize(
    "text",
    [
        b"",
        b"GET / HTTP/1.1\r\n",
        b"POST /api/login HTTP/1.1\r\nHost: localhost\r\nContent-Length: 9\r\n\r\n{",
        UNREAD,
    ],
)
def test_crowds_make_room_for_whoever_comes(
    alone: ObserverProcess, robots: Robots, scene: Scene, text: bytes
) -> None:
    visitor = Visitor(alone.address)
    visitor.log_in(OBSERVERS["ann"][0])
    with ExitStack() as crowd, Events(visitor) as events:
        events.servers("watching")
        for _ in range(MAX_CONNECTIONS + 50):
            connection = crowd.enter_context(connect(alone, text))
            if text == UNREAD:
                assert connection.recv(1)
        assert visitor.get("/").status == 200
        # By another browser, as one that logs in again ends what it looked at before.
        assert Visitor(alone.address).log_in(OBSERVERS["ann"][0]).status == 200
        robots.detect("barn", scene.frame())
        assert events.robot("barn"), "what is at work is not closed"


def is_closed(connection: socket.socket, text: bytes) -> bool:
    """Waits for that, while more of the text comes, byte by byte."""
    connection.settimeout(0.2)
    end = time.monotonic() + TO_CLOSE
    while time.monotonic() < end:
        try:
            if connection.recv(1) == b"":
                return True
        except TimeoutError:
            if text:
                connection.sendall(text[:1])
                text = text[1:]
        except OSError:
            return True
    return False


def test_headers_have_some_seconds_and_connections_that_are_kept_more(
    alone: ObserverProcess,
) -> None:
    kept = http.client.HTTPConnection(alone.address, timeout=PATIENCE)
    kept.request("GET", "/")
    assert kept.getresponse().read()
    silent, half = connect(alone), connect(alone, b"GET / HTTP/1.1\r\n")
    assert is_closed(half, b"X-Slow: " + 1000 * b"x")
    assert is_closed(silent, b"")
    kept.auto_open = 0  # the same connection, or none
    kept.request("GET", "/")
    assert kept.getresponse().status == 200
    kept.close()
