"""All attacks, and how one is run in a process of its own: which needs no more than this."""

from __future__ import annotations

import os
import resource
import time
from dataclasses import replace

import callers  # noqa: F401  each enters its attacks into the catalogue
import compression
import connecting  # noqa: F401
import floods  # noqa: F401
import frames
import readers  # noqa: F401
import uploads  # noqa: F401
import watching  # noqa: F401
from target import CATALOGUE, Tally, Target


def be_an_attacker() -> None:
    """Before its time begins: what it sends is made while it still gets processors."""
    for encoding in ("gzip", "deflate"):
        compression.bomb(encoding)
    frames.extreme_bodies()
    # An attacker has a machine of its own: here it has the processors that the server leaves free.
    os.nice(19)
    most = resource.getrlimit(resource.RLIMIT_NOFILE)[1]
    resource.setrlimit(resource.RLIMIT_NOFILE, (most, most))


LONGEST = 45.0  # seconds; one attacker among many may get no processor for a while


def run_attack(name: str, target: Target, seconds: float, must: tuple[str, ...] = ()) -> Tally:
    """For so long, and on until it was an attack, and what `must` names has come of it, too."""
    attack = CATALOGUE[name]
    network = 1 + list(CATALOGUE).index(name)
    give_up = time.monotonic() + max(seconds, LONGEST)
    tally = Tally()
    while True:
        until = time.monotonic() + seconds
        tally.update(attack.run(replace(target, until=until, network=network)))
        if all(tally[what] for what in (*attack.must, *must)) or time.monotonic() >= give_up:
            return tally
