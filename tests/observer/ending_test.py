"""Rights that are narrowed and sessions that end while somebody looks."""

from __future__ import annotations

import os
import signal
import subprocess
import time
from pathlib import Path
from typing import Any

from conftest import Robots, Scene
from processes import (
    OBSERVERS,
    PATIENCE,
    Events,
    ObserverProcess,
    ServerProcess,
    Visitor,
    write_observers,
)


def part_of(line: Any, part: str) -> str:
    return f"/api/{part}?robot={line['robot']}&id={line['id']}"


def close_look(events: Events, robots: Robots, robot: str, scene: Scene) -> Any:
    """The look begins some time after the page asks for it."""
    while True:
        robots.detect(robot, scene.frame())
        if close := events.next().get("close"):
            return close


def test_what_is_covered_no_more_is_gone(scene: Scene, tmp_path: Path) -> None:
    with (
        ServerProcess(write_observers(tmp_path)) as server,
        ObserverProcess(server.address) as observer,
    ):
        robots, visitor = Robots(server.address), Visitor(observer.address)
        visitor.log_in(OBSERVERS["ann"][0])
        with Events(visitor, "?close=hall&depth=1") as events:
            events.servers("watching")
            close = close_look(events, robots, "hall", scene)
            for robot in ("attic", "kitchen-1"):
                robots.detect(robot, scene.frame())
            with Events(visitor) as more:
                seen = more.robots("attic", "kitchen-1")
            gone = [part_of(seen["attic"], part) for part in ("answer", "preview")]
            gone += [part_of(close, part) for part in ("answer", "picture", "depth")]
            assert all(visitor.get(path).status == 200 for path in gone)
            ann = ("token-of-ann", "view", "kitchen-*")
            write_observers(tmp_path, OBSERVERS | {"ann": ann})
            os.kill(server.pid, signal.SIGHUP)
            while (who := visitor.get("/api/session").json()).get("robots") != ["kitchen-*"]:
                assert who["csrf"], "the session is the same"
            for path in gone:
                answer = visitor.get(path)
                assert answer.status == 404
                assert answer.body == visitor.get("/api/answer?robot=nobody&id=1").body
            robots.detect("kitchen-1", scene.frame())
            assert events.robot(
                "kitchen-1", seen["kitchen-1"]["id"]
            ), "who looks need not log in anew"
        with Events(visitor, "?close=hall&depth=1") as events:
            first = events.next()
            assert "close" not in first
            (kitchen,) = first["robots"]
        assert kitchen["robot"] == "kitchen-1"
        for part in ("answer", "preview"):
            assert visitor.get(part_of(kitchen, part)).status == 200


def rest_of(events: Events) -> list[bytes]:
    """The lines until the stream ends."""
    lines = []
    end = time.monotonic() + PATIENCE
    while line := events.response.readline():
        lines.append(line)
        assert time.monotonic() < end, "the stream goes on"
    return lines


def test_events_end_with_their_session(
    observer: ObserverProcess, robots: Robots, scene: Scene
) -> None:
    gone, other = Visitor(observer.address), Visitor(observer.address)
    for visitor in (gone, other):
        visitor.log_in(OBSERVERS["ann"][0])
    with Events(gone) as events, Events(gone, "?close=hall") as close, Events(other) as stays:
        for each in (events, close, stays):
            each.servers("watching")
        assert gone.post("/api/logout", {}).status == 200
        for each in (events, close):
            assert rest_of(each)[-3:] == [b"event: ended\n", b"data: {}\n", b"\n"]
        robots.detect("yard", scene.frame())
        assert stays.robot("yard")


def test_signals_that_do_nothing_end_nothing(tmp_path: Path) -> None:
    with (
        ServerProcess(write_observers(tmp_path)) as server,
        open(tmp_path / "log", "wb+") as log,
        ObserverProcess(server.address, stderr=log.fileno()) as observer,
    ):
        for number in (signal.SIGUSR1, signal.SIGUSR2):
            os.kill(observer.pid, number)
            end = time.monotonic() + PATIENCE
            while f"{number.name} does nothing here" not in (tmp_path / "log").read_text():
                assert Visitor(observer.address).get("/").status == 200
                assert time.monotonic() < end, "the log does not say so"


def test_signals_that_do_nothing_end_nothing_at_the_start(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "token")
    history = ["--history", tmp_path / "history", "--history-token-file", tmp_path / "token"]
    command = [os.environ["FOVEA_OBSERVER"], "--server", "127.0.0.1:1", "--listen", "127.0.0.1:0"]
    process = subprocess.Popen([*command, *history], stdout=subprocess.PIPE, text=True)
    try:
        with open(tmp_path / "token", "w") as token:  # which it waits for
            for number in (signal.SIGUSR1, signal.SIGUSR2):
                os.kill(process.pid, number)
            token.write("token-of-it")
        assert process.stdout is not None
        assert process.stdout.readline().startswith("open http")
    finally:
        process.kill()
        process.wait()
