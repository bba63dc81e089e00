"""Attacks against servers that are set up in a certain way."""

from __future__ import annotations

import mmap
import os
import time
from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path

import pytest
from besieged import Besieged
from http2 import INFO, message
from readers import NO_WINDOW, ask_and_take_nothing
from siege import Siege
from target import CATALOGUE, PATIENCE, Tally, Target

SERVER, SCENES = Path(os.environ["FOVEA_SERVER"]), Path(os.environ["FOVEA_SCENES"])


@pytest.fixture(scope="module")
def siege(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Siege]:
    made = Siege(SCENES, tmp_path_factory.mktemp("scene"), 1)
    yield made
    made.close()


def hold(siege: Siege, server: Besieged, attack: str, seconds: float, *must: str) -> Tally:
    outcome = siege.lay(server, [CATALOGUE[attack]], seconds, must)
    print(outcome)
    assert not outcome.faults
    assert server.stop() == 0
    return outcome.tallies[attack]


def test_frames_that_cost_too_much_are_cut_off(siege: Siege, tmp_path: Path) -> None:
    # Some forty times what the good robot's frame takes, and a fraction of what the attack's do.
    with Besieged(SERVER, "open", tmp_path, "--max-compute-ms", "1000") as server:
        assert hold(siege, server, "extreme-options", 8, "cut off")["cut off"] > 0


def test_options_that_are_not_allowed_are_refused(siege: Siege, tmp_path: Path) -> None:
    with Besieged(SERVER, "open", tmp_path, "--client-options", "safe") as server:
        tally = hold(siege, server, "extreme-options", 5, "not allowed")
    assert tally["not allowed"] > 0
    assert tally["cut off"] == 0


def test_who_takes_no_answers_holds_no_threads_for_long(tmp_path: Path) -> None:
    def is_told(target: Target) -> bool:
        with target.connect(patience=PATIENCE) as asking:
            return b"paper" in asking.ask(INFO, message(), PATIENCE)

    few_s = ("--max-transfer-s", "1")
    with Besieged(SERVER, "open", tmp_path, *few_s) as server, ExitStack() as stack:
        target = server.target(b"")
        assert is_told(target)
        while is_told(target):
            ask_and_take_nothing(stack.enter_context(target.connect(NO_WINDOW)))
        # They answer no pings either: gRPC itself ends their connections, after 40 s.
        give_up = time.monotonic() + 25
        while not is_told(target):
            assert time.monotonic() < give_up


def test_nobody_waits_for_who_reads_the_log(siege: Siege, tmp_path: Path) -> None:
    with Besieged(SERVER, "open", tmp_path, reads_log=False) as server:
        hold(siege, server, "log-flood", 3)
        # Poll calls a pipe full once none of its two pages is empty.
        assert server.unread_log_bytes() > mmap.PAGESIZE
