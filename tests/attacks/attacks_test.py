"""Each family of attacks at once, for seconds; run.py does it for as long as one likes."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path

import pytest
from besieged import Besieged
from siege import Siege
from target import CATALOGUE, Attack

SERVER, SCENES = Path(os.environ["FOVEA_SERVER"]), Path(os.environ["FOVEA_SCENES"])
FAMILIES = sorted({each.family for each in CATALOGUE.values() if "tokens" in each.setups})


@pytest.fixture(scope="module")
def siege(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Siege]:
    made = Siege(SCENES, tmp_path_factory.mktemp("scene"), len(CATALOGUE))
    yield made
    made.close()


@pytest.fixture(scope="module")
def with_tokens(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Besieged]:
    with Besieged(SERVER, "tokens", tmp_path_factory.mktemp("tokens")) as server:
        yield server
        assert server.stop() == 0


def against(setup: str, family: str = "") -> list[Attack]:
    return [
        each for each in CATALOGUE.values() if setup in each.setups and family in ("", each.family)
    ]


def hold(siege: Siege, server: Besieged, attacks: list[Attack], seconds: float) -> None:
    outcome = siege.lay(server, attacks, seconds)
    print(outcome)
    assert not outcome.faults


@pytest.mark.parametrize("family", FAMILIES)
def test_holds_with_tokens(siege: Siege, with_tokens: Besieged, family: str) -> None:
    hold(siege, with_tokens, against("tokens", family), 3)


@pytest.mark.parametrize("setup", ["open", "tls"])
def test_holds_against_all_at_once(siege: Siege, tmp_path: Path, setup: str) -> None:
    with Besieged(SERVER, setup, tmp_path) as server:
        hold(siege, server, against(setup), 8)
        assert server.stop() == 0
