"""What all tests share: a server with observers, fovea-observer, and a generated scene."""

from __future__ import annotations

import os
import subprocess
import threading
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest
from PIL import Image
from processes import (
    OBSERVERS,
    PATIENCE,
    Events,
    ObserverProcess,
    ServerProcess,
    Visitor,
    history_flags,
    write_observers,
)

import fovea

if TYPE_CHECKING:
    from browser import Browser


@dataclass
class Scene:
    """A generated tabletop of 320x240 with exact depth and labels."""

    color: Any
    depth: Any
    labels: Any
    intrinsics = fovea.CameraIntrinsics(262.5, 262.5, 159.5, 119.5)

    def frame(self, **changes: Any) -> fovea.Frame:
        parts = {"color": self.color, "depth": self.depth, "intrinsics": self.intrinsics}
        return fovea.Frame(**(parts | changes))


@pytest.fixture(scope="session")
def scene(tmp_path_factory: pytest.TempPathFactory) -> Scene:
    folder = tmp_path_factory.mktemp("scene")
    command = [os.environ["FOVEA_SCENES"], "--output", str(folder)]
    command += ["--kind", "tabletop", "--size", "320x240", "--sensor", "ideal"]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    color, depth, labels = (
        np.array(Image.open(folder / f"tabletop_1_{name}.png"))
        for name in ("color", "depth", "label")
    )
    return Scene(color, depth.astype(np.uint16), labels)


@pytest.fixture(scope="session")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[ServerProcess]:
    with ServerProcess(write_observers(tmp_path_factory.mktemp("observers"))) as process:
        yield process


@pytest.fixture(scope="session")
def observer(server: ServerProcess) -> Iterator[ObserverProcess]:
    with ObserverProcess(server.address) as process:
        yield process


class Robots:
    """Robots of a server, by name."""

    def __init__(self, address: str) -> None:
        self.address = address

    def detect(self, robot: str, frame: fovea.Frame, **options: Any) -> fovea.Detections:
        with fovea.Client(self.address, robot=robot, timeout=PATIENCE) as client:
            return client.detect_frame(frame, fovea.DetectOptions(**options))


@dataclass
class Recorded:
    """An observer that keeps a history of a server of its own."""

    observer: ObserverProcess
    robots: Robots

    def visitor(self, name: str) -> Visitor:
        visitor = Visitor(self.observer.address)
        assert visitor.log_in(OBSERVERS[name][0]).status == 200
        return visitor

    def record(self, robot: str, *frames: fovea.Frame, **options: Any) -> list[int]:
        """Sends them, and waits until they are in the history; their numbers there."""
        visitor = self.visitor("ann")
        newest: list[int] = []
        for frame in frames:
            last = max(visitor.history(robot), default=0)
            self.robots.detect(robot, frame, **options)
            try:
                newest.append(visitor.newer(robot, last, PATIENCE / 4))
            except AssertionError:
                # On a busy machine pings may come late, and what is answered until the observer is
                # connected again is not recorded.
                self.robots.detect(robot, frame, **options)
                newest.append(visitor.newer(robot, last))
        return newest


def bundle(robot: str, at: int, before: int = 0, after: int = 0) -> str:
    return f"/api/history/bundle?robot={robot}&at={at}&before={before}&after={after}"


@pytest.fixture(scope="module")
def recorded(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Recorded]:
    folder = tmp_path_factory.mktemp("recorded")
    with (
        ServerProcess(write_observers(folder)) as server,
        ObserverProcess(server.address, "127.0.0.1:0", *history_flags(folder)) as observer,
    ):
        recorded = Recorded(observer, Robots(server.address))
        recorder_is_ready(recorded.visitor("ann"), recorded.robots)
        yield recorded


def recorder_is_ready(visitor: Visitor, robots: Robots) -> None:
    """Once anything of it is recorded, all is."""
    blank = np.zeros((48, 64), np.uint16)
    camera = fovea.CameraIntrinsics(50, 50, 31.5, 23.5)
    frame = fovea.Frame(
        color=np.zeros((48, 64, 3), np.uint8), depth=blank, intrinsics=camera, id="first"
    )
    while not visitor.history("first"):
        robots.detect("first", frame)


@dataclass
class Watched:
    """A server of one test's own, which may end it, and who watches it."""

    observers: Path
    server: ServerProcess
    visitor: Visitor
    events: Events


@pytest.fixture
def watched(tmp_path: Path) -> Iterator[Watched]:
    observers = write_observers(tmp_path)
    with ServerProcess(observers) as server, ObserverProcess(server.address) as observer:
        visitor = Visitor(observer.address)
        visitor.log_in(OBSERVERS["ann"][0])
        with Events(visitor) as events:
            events.servers("watching")
            yield Watched(observers, server, visitor, events)


@pytest.fixture
def visitor(observer: ObserverProcess) -> Visitor:
    return Visitor(observer.address)


@pytest.fixture
def robots(server: ServerProcess) -> Robots:
    return Robots(server.address)


class Sending:
    """A robot that sends the same frame again and again, until the end of a test."""

    def __init__(self, robots: Robots, robot: str, frame: fovea.Frame) -> None:
        self.answer = robots.detect(robot, frame, return_masks=True)
        self._stop = threading.Event()
        self._thread = threading.Thread(target=self._run, args=(robots, robot, frame))

    def _run(self, robots: Robots, robot: str, frame: fovea.Frame) -> None:
        while not self._stop.wait(0.2):
            robots.detect(robot, frame)

    def __enter__(self) -> Sending:
        self._thread.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._stop.set()
        self._thread.join()


@pytest.fixture
def sending(robots: Robots, scene: Scene) -> Iterator[Sending]:
    with Sending(robots, "kitchen-1", scene.frame()) as robot:
        yield robot


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    """Debian's Chromium, where that is."""
    pytest.importorskip("selenium", reason="python3-selenium is not installed")
    from browser import CHROMIUM, DRIVER, Browser

    if not (CHROMIUM and DRIVER):
        pytest.skip("chromium and chromium-driver are not installed")
    opened = Browser()
    yield opened
    opened.close()


@pytest.fixture
def picture(browser: Browser, observer: ObserverProcess, sending: Sending) -> Any:
    """The canvas of the robot that sends, in large, with a frame in it."""
    browser.log_in(observer.url, OBSERVERS["ann"][0])
    browser.find("[data-robot=kitchen-1] button").click()
    return browser.find("#picture[data-id]")


@pytest.fixture
def past(browser: Browser, recorded: Recorded, scene: Scene) -> Iterator[Any]:
    """The canvas of a robot that sends, and of which there is a history from before."""
    frames = [scene.frame(id=f"before {number}") for number in range(4)]
    recorded.record("arm", *frames)
    browser.log_in(recorded.observer.url, OBSERVERS["ann"][0])
    with Sending(recorded.robots, "arm", scene.frame(id="now")):
        browser.find("[data-robot=arm] button").click()
        yield browser.find("#picture[data-id]")
