"""Two servers with TLS under load, restarted one after the other and killed."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from pathlib import Path

import pytest
from conftest import Scene, scene  # noqa: F401
from fleet import Fleet, Robots
from streams import Streams

import fovea

NUM_ROBOTS = 4


@pytest.fixture(params=["with HAProxy", "without a proxy"])
def fleet(request: pytest.FixtureRequest, tmp_path: Path) -> Iterator[Fleet]:
    with Fleet(tmp_path, with_proxy=request.param == "with HAProxy") as fleet:
        yield fleet


def test_no_call_fails_while_both_are_restarted(fleet: Fleet, scene: Scene) -> None:
    num_answers = [0]

    def call(_: str, client: fovea.Client, stop: threading.Event) -> None:
        while not stop.is_set():
            assert client.detect_frame(scene.frame()).objects
            num_answers[0] += 1
            stop.wait(0.2)

    robots = Robots(fleet, NUM_ROBOTS, call)
    fleet.restart_one_after_the_other()
    robots.join()
    assert num_answers[0] > NUM_ROBOTS


def test_every_stream_is_back_when_its_server_is_killed(fleet: Fleet, scene: Scene) -> None:
    """With each frame answered or counted as lost. kill.py says how long it takes."""
    with Streams(fleet, scene, NUM_ROBOTS) as streams:
        num_back = [len(streams.times_to_return(member)) for member in fleet.members]
    # Streams stay: all that the first one had are at the second one.
    assert num_back[1] == NUM_ROBOTS
