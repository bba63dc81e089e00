"""Streams of robots, and when they are answered again after their server was killed."""

from __future__ import annotations

import signal
import threading
import time
from collections.abc import Iterator

from conftest import Scene
from fleet import Fleet, Member, Robots
from server_process import PATIENCE

import fovea

PERIOD_S = 0.2


class Streams:
    def __init__(self, fleet: Fleet, scene: Scene, count: int) -> None:
        self._fleet = fleet
        self._scene = scene
        self._changed = threading.Condition()
        # By robot: of each answer when it came, and when its frame was taken.
        self._answers: dict[str, list[tuple[float, float]]] = {}
        self._robots = Robots(fleet, count, self._run)
        self._names = [f"robot-{number}" for number in range(count)]

    def __enter__(self) -> Streams:
        return self

    def __exit__(self, *_: object) -> None:
        self._robots.join()

    def times_to_return(self, killed: Member) -> list[float]:
        """Kills the server and returns, of each stream that it had, how long it took until a frame
        was answered that was taken after that: seconds. Then the server is there again."""
        robots = self._at(killed)
        killed_at = time.monotonic()
        killed.end(signal.SIGKILL)
        first = self._first_answers(self._names, killed_at)
        killed.start()
        self._wait_until_used(killed)
        return [first[robot] - killed_at for robot in robots]

    def _at(self, member: Member) -> list[str]:
        self._first_answers(self._names, time.monotonic())
        before = member.frames_by_robot()
        self._first_answers(self._names, time.monotonic())
        after = member.frames_by_robot()
        return [name for name in self._names if after.get(name, 0) > before.get(name, 0)]

    def _first_answers(self, robots: list[str], taken: float) -> dict[str, float]:
        """When each got the answer to a frame taken later than that; waits for it."""

        def found() -> dict[str, float]:
            return {
                robot: min(came for came, of in answers if of > taken)
                for robot, answers in self._answers.items()
                if robot in robots and answers and answers[-1][1] > taken
            }

        with self._changed:
            back = lambda: self._robots.errors or len(found()) == len(robots)  # noqa: E731
            assert self._changed.wait_for(back, PATIENCE), "streams that did not come back"
            assert not self._robots.errors, self._robots.errors
            return found()

    def _wait_until_used(self, member: Member) -> None:
        """Whatever stands in front has seen that it is there again."""
        deadline = time.monotonic() + PATIENCE
        while "probe" not in member.frames_by_robot():
            assert time.monotonic() < deadline, "a server that gets no calls"
            with self._fleet.client("probe") as client:
                client.detect_frame(self._scene.frame())

    def _run(self, name: str, client: fovea.Client, stop: threading.Event) -> None:
        def camera() -> Iterator[fovea.Frame]:
            while not stop.wait(PERIOD_S):
                yield self._scene.frame(id=str(time.monotonic()))

        num_known = 0
        for answer in client.stream(camera()):
            num_known += 1 + answer.dropped + answer.lost
            assert answer.sequence + 1 == num_known
            with self._changed:
                answers = self._answers.setdefault(name, [])
                answers.append((time.monotonic(), float(answer.frame_id)))
                self._changed.notify_all()
