"""When a stream goes to another server: the same cases as tests/client/server_load_test.cc."""

from __future__ import annotations

from fovea.server_info import StageStatistics, Statistics
from fovea.server_load import ServerLoad


def statistics(seconds: int, num_frames: int, num_waiting: int) -> Statistics:
    """After so many seconds and frames, each of which took half a second, and one in the queue."""
    stages = {"queue": 1000.0, "decode": 250.0, "mrf": 250.0}
    return Statistics(
        uptime_ms=seconds * 1000.0,
        frames_received=num_frames,
        frames_answered={"OK": num_frames},
        frames_dropped=0,
        frames_waiting=num_waiting,
        objects=0,
        streams=0,
        received_bytes=0,
        sent_bytes=0,
        stages={
            name: StageStatistics(num_frames, num_frames * each) for name, each in stages.items()
        },
    )


def load_of(*looks: tuple[int, int, int]) -> ServerLoad:
    load = ServerLoad()
    for look in looks:
        load.note(statistics(*look))
    return load


def test_says_how_often_robots_get_answers_that_take_turns() -> None:
    assert load_of((100, 50, 3)).turn(0) is None
    load = load_of((100, 50, 3), (110, 90, 7))
    assert (load.turn(0), load.turn(1)) == (2.0, 2.25)  # eight at four frames a second


def test_goes_by_the_work_of_a_frame_where_nothing_waits() -> None:
    assert load_of((100, 50, 0), (110, 54, 0)).turn(1) == 1.0


def test_who_had_nothing_to_do_answers_at_once() -> None:
    assert load_of((100, 50, 0), (110, 50, 0)).turn(1) == 0.0


def test_knows_nothing_of_who_hangs_or_was_started_anew() -> None:
    assert load_of((100, 50, 2), (110, 50, 2)).turn(1) is None
    assert load_of((100, 50, 2), (5, 60, 2)).turn(1) is None
    assert load_of((100, 50, 2), (5, 60, 2), (15, 80, 1)).turn(0) == 1.0
