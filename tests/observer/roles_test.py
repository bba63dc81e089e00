"""Who gets what: every observer, every robot, everything that is served. What is not somebody's is
as if it were not there."""

from __future__ import annotations

import json
from collections.abc import Iterator
from fnmatch import fnmatchcase
from pathlib import Path
from typing import Any
from urllib.parse import quote

import numpy as np
import pytest
from conftest import Recorded, Robots, recorder_is_ready
from processes import (
    OBSERVERS,
    Answer,
    Events,
    ObserverProcess,
    ServerProcess,
    Visitor,
    history_flags,
    write_observers,
)

import fovea

# Names with what means something to shells, paths and addresses.
ROBOTS = ("attic", "kitchen-1", "kitchen-2", "hall", "hall/1", "a[b]*?", "..", "x y&z=%2F")
NOBODY = "no such robot"
RIGHTS = {
    "sees all": ("view", "*"),
    "sees kitchens": ("view", "kitchen-*"),
    "sees one": ("view", "hall"),
    "sees none": ("view", "nobody"),
    "tries kitchens": ("view,try", "kitchen-*,attic"),
    "takes halls": ("view,download", "hall*"),
    "picks kitchens": ("view,pick", "kitchen-?"),
    "tries and picks": ("view,try,pick", "*-2,a*"),
    "may all with some": ("view,try,download,pick", "kitchen-1,..,x*"),
    "may all": ("view,try,download,pick", "*"),
}
TABLE = {
    name.replace(" ", "-"): (f"token {name}".replace(" ", "-"), *rest)
    for name, rest in RIGHTS.items()
} | {"rec": OBSERVERS["rec"]}

# What is served, and the right that it needs. A pick is refused by the robot, which takes none.
ENDPOINTS = {
    "live answer": "view",
    "live preview": "view",
    "close": "view",
    "history": "view",
    "past answer": "view",
    "past picture": "view",
    "past depth": "view",
    "bundle": "download",
    "bundle of seconds": "download",
    "options": "try",
    "try": "try",
    "pick": "pick",
    "pick of the past": "pick",
}
PICKED = 409


def frame() -> fovea.Frame:
    depth = np.full((48, 64), 1000, np.uint16)
    depth[20:30, 20:40] = 900
    color = np.full((48, 64, 3), 60, np.uint8)
    color[20:30, 20:40] = (200, 40, 40)
    return fovea.Frame(color, depth, fovea.CameraIntrinsics(50, 50, 31.5, 23.5), id="secret")


class World:
    """All robots have sent a frame, and all observers are logged in."""

    def __init__(self, recorded: Recorded) -> None:
        self.visitors: dict[str, Visitor] = {}
        for name, (token, _, _) in TABLE.items():
            self.visitors[name] = Visitor(recorded.observer.address)
            assert self.visitors[name].log_in(token).status == 200
        self.live: dict[str, dict[str, int]] = {}
        all_of_it = self.visitors["may-all"]
        looks = {name: Events(visitor) for name, visitor in self.visitors.items()}
        for look in looks.values():
            look.servers("watching")
        for robot in ROBOTS:
            recorded.robots.detect(robot, frame())
            all_of_it.history(robot, 1)
        for name, look in looks.items():
            seen: dict[str, int] = {}
            mine = [robot for robot in ROBOTS if covers(name, robot)]
            while not all(robot in seen for robot in mine):
                for line in look.next()["robots"]:
                    seen[line["robot"]] = line["id"]
            self.live[name] = seen
            look.__exit__()
        self.past = {robot: all_of_it.history(robot)[0] for robot in ROBOTS}

    def ask(self, name: str, robot: str, endpoint: str, number: int) -> Answer:
        visitor, of = self.visitors[name], quote(robot, safe="")
        if endpoint.startswith("live "):
            return visitor.get(f"/api/{endpoint.removeprefix('live ')}?robot={of}&id={number}")
        if endpoint == "history":
            return visitor.get(f"/api/history?robot={of}")
        if endpoint.startswith("past "):
            part = endpoint.removeprefix("past ")
            return visitor.get(f"/api/history/{part}?robot={of}&id={number}")
        if endpoint.startswith("bundle"):
            around = "&before=600&after=600" if endpoint != "bundle" else ""
            return visitor.get(f"/api/history/bundle?robot={of}&at={number}{around}")
        if endpoint == "options":
            return visitor.get(f"/api/options?robot={of}&id={number}")
        body = {"robot": robot, "id": number, "past": endpoint != "pick", "label": 1}
        return visitor.post("/api/try" if endpoint == "try" else "/api/pick", body)


def covers(name: str, robot: str) -> bool:
    patterns = TABLE[name][2].split(",")
    return any(fnmatchcase(robot, pattern.replace("[", "[[]")) for pattern in patterns)


def may(name: str, robot: str, endpoint: str) -> bool:
    return covers(name, robot) and ENDPOINTS[endpoint] in TABLE[name][1].split(",")


@pytest.fixture(scope="module")
def world(tmp_path_factory: pytest.TempPathFactory) -> Iterator[World]:
    folder = tmp_path_factory.mktemp("roles")
    with (
        ServerProcess(write_observers(folder, TABLE)) as server,
        ObserverProcess(server.address, "127.0.0.1:0", *history_flags(folder)) as observer,
    ):
        recorded = Recorded(observer, Robots(server.address))
        visitor = Visitor(observer.address)
        visitor.log_in(TABLE["may-all"][0])
        recorder_is_ready(visitor, recorded.robots)
        yield World(recorded)


@pytest.mark.parametrize("endpoint", [each for each in ENDPOINTS if each != "close"])
@pytest.mark.parametrize("name", list(TABLE))
def test_each_gets_what_is_theirs_and_nothing_else(world: World, name: str, endpoint: str) -> None:
    live = endpoint.startswith("live ") or endpoint == "pick"
    for robot in ROBOTS:
        # Numbers of frames are each session's own where they are of now.
        numbers = list(range(1, 40)) if live else [world.past[robot]]
        if robot in world.live[name] and live:
            numbers = [world.live[name][robot]]
        for number in numbers:
            answer = world.ask(name, robot, endpoint, number)
            none = world.ask(name, NOBODY, endpoint, number)
            if may(name, robot, endpoint):
                expected = (PICKED, 404) if ENDPOINTS[endpoint] == "pick" else (200,)
                assert answer.status in expected, (robot, answer.body)
                assert answer.body != none.body or ENDPOINTS[endpoint] == "pick"
            else:
                same = (answer.status, answer.body) == (none.status, none.body)
                assert same, (robot, answer.status, answer.body[:200])
                assert b"secret" not in answer.body


@pytest.mark.parametrize("name", list(TABLE))
def test_lists_hold_what_is_theirs_and_nothing_else(world: World, name: str) -> None:
    assert set(world.live[name]) - {"first"} == {robot for robot in ROBOTS if covers(name, robot)}
    with Events(world.visitors[name], "?close=attic&depth=1") as look:
        shown = look.next()["robots"]
    assert all(covers(name, line["robot"]) for line in shown)


@pytest.mark.parametrize("name", list(TABLE))
def test_what_is_answered_is_of_that_robot(world: World, name: str) -> None:
    for robot in ROBOTS:
        if not may(name, robot, "past answer"):
            continue
        answer = world.ask(name, robot, "past answer", world.past[robot]).json()
        assert answer["line"]["robot"] == answer["frame"]["robot"] == robot
        ids = world.ask(name, robot, "history", 0).json()["ids"]
        assert ids == [world.past[robot]]


def test_without_a_session_there_is_nothing(world: World) -> None:
    stranger = Visitor(world.visitors["may-all"].address)
    world.visitors["stranger"] = stranger
    for robot in (*ROBOTS, NOBODY):
        for endpoint in ENDPOINTS:
            if endpoint != "close":
                answer = world.ask("stranger", robot, endpoint, world.past["attic"])
                assert answer.status == 401 and b"secret" not in answer.body
    del world.visitors["stranger"]


def test_posts_need_the_page(world: World) -> None:
    """From another page a browser sends the cookie at most."""
    visitor = world.visitors["may-all"]
    own = f"http://{visitor.address}"
    body = json.dumps({"robot": "attic", "id": world.past["attic"], "past": True, "label": 1})
    for path in ("/api/try", "/api/pick"):
        assert visitor.ask("POST", path, body).status == 403
        assert visitor.ask("POST", path, body, Origin="http://evil.example").status == 403
        assert visitor.ask("POST", path, body, Origin=own).status == 403
        assert visitor.get(path).status == 404


@pytest.mark.parametrize(
    "body",
    [
        "",
        "[",
        "[]",
        "{}",
        '{"robot": 1}',
        '{"robot": "attic", "id": -1}',
        '{"robot": "attic", "id": "x"}',
    ],
)
def test_malformed_requests_are_refused(world: World, body: str) -> None:
    visitor = world.visitors["may-all"]
    headers: dict[str, Any] = {"Origin": f"http://{visitor.address}", "X_Fovea_CSRF": visitor.csrf}
    for path in ("/api/try", "/api/pick"):
        assert visitor.ask("POST", path, body, **headers).status == 400


def test_a_history_is_private(world: World, tmp_path: Path) -> None:
    """Its files are of the user who runs the observer."""
    folder = write_observers(tmp_path, TABLE).parent
    with (
        ServerProcess(folder / "observers") as server,
        ObserverProcess(server.address, "127.0.0.1:0", *history_flags(folder)) as observer,
    ):
        visitor = Visitor(observer.address)
        visitor.log_in(TABLE["may-all"][0])
        recorder_is_ready(visitor, Robots(server.address))
        for path in (folder / "history").rglob("*"):
            assert path.stat().st_mode & 0o077 == 0, path
