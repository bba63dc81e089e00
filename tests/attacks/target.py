"""What attackers know of the server, and how an attack is written down."""

from __future__ import annotations

import itertools
import socket
import ssl
import time
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import dataclass

from http2 import Connection, Ended

HOSTS = 16  # of each attack; good robots are 127.0.0.1
# Seconds without a word from the server; an attacker among many seldom gets a processor.
PATIENCE = 8.0
Tally = Counter[str]
_next_host = itertools.count()


@dataclass(frozen=True)
class Target:
    """`request`: a whole frame as a DetectRequest; `until`: when to stop, of time.monotonic(),
    which all processes of a machine share."""

    port: int
    metrics_port: int
    setup: str  # open, tokens or tls
    request: bytes
    until: float = 0.0
    network: int = 1  # of the attack, so that no host is punished for another attack

    def goes_on(self) -> bool:
        return time.monotonic() < self.until

    def dial(self, port: int | None = None) -> socket.socket:
        """From the next one of the attack's hosts."""
        source = f"127.0.{self.network}.{2 + next(_next_host) % HOSTS}"
        where = ("127.0.0.1", self.port if port is None else port)
        raw = socket.create_connection(where, timeout=5, source_address=(source, 0))
        raw.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        return raw

    def connect(self, settings: bytes = b"", patience: float = 2.0) -> Connection:
        try:
            raw = self.dial()
            if self.setup == "tls":
                raw = trusting().wrap_socket(raw)
            return Connection(raw, settings, patience)
        except OSError as error:
            raise Ended(str(error)) from error


def trusting() -> ssl.SSLContext:
    """TLS with whoever answers."""
    context = ssl.SSLContext(ssl.PROTOCOL_TLS_CLIENT)
    context.check_hostname = False
    context.verify_mode = ssl.CERT_NONE
    context.set_alpn_protocols(["h2"])
    return context


@dataclass(frozen=True)
class Attack:
    """`run` goes on until the target's time is up and counts what it achieved: each counter named
    in `must` has to be more than 0, so that no attack passes without having been one."""

    name: str
    what: str
    run: Callable[[Target], Tally]
    setups: tuple[str, ...]
    must: tuple[str, ...]
    family: str


CATALOGUE: dict[str, Attack] = {}


def attack(
    *must: str, setups: tuple[str, ...] = ("open", "tokens")
) -> Callable[[Callable[[Target], Tally]], Callable[[Target], Tally]]:
    """Enters a function into the catalogue, where its first line of documentation explains it."""

    def enter(run: Callable[[Target], Tally]) -> Callable[[Target], Tally]:
        what = (run.__doc__ or "").partition("\n\n")[0]
        name = run.__name__.replace("_", "-")
        CATALOGUE[name] = Attack(name, " ".join(what.split()), run, setups, must, run.__module__)
        return run

    return enter


def rounds(target: Target, tally: Tally) -> Iterator[suppress]:
    """For loops whose body the server may end at any time: `for survived in rounds(…): with
    survived: …`."""
    while target.goes_on():
        tally["rounds"] += 1
        yield suppress(Ended, OSError)
