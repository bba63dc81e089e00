"""What is asked of servers through the observer: options to try on a frame, and picks for robots."""

from __future__ import annotations

import os
import signal
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from conftest import Recorded, Scene
from picking import Picking
from processes import (
    OBSERVERS,
    Events,
    ObserverProcess,
    ServerProcess,
    Visitor,
    history_flags,
    write_observers,
)

import fovea


def test_options_are_those_of_the_server(recorded: Recorded, scene: Scene) -> None:
    number = recorded.record("arm", scene.frame())[0]
    visitor = recorded.visitor("ann")
    told = visitor.get(f"/api/options?robot=arm&id={number}").json()["options"]
    with fovea.Client(recorded.robots.address) as client:
        options = {option.name: option for option in client.list_options()}
    assert {option["name"] for option in told} == set(options)
    for option in told:
        assert option["description"] == options[option["name"]].description
        assert option["maximum"] == options[option["name"]].maximum


def test_what_is_tried_is_what_would_be_answered(recorded: Recorded, scene: Scene) -> None:
    number = recorded.record("arm", scene.frame(), parameters={"max_depth_m": 4})[0]
    visitor = recorded.visitor("ann")
    for change in ({}, {"objects.min_probability": 0.99}):
        body = {"robot": "arm", "id": number, "options": {"parameters": change}}
        tried = visitor.post("/api/try", body)
        assert tried.status == 200, tried.body
        wanted = recorded.robots.detect(
            "other", scene.frame(), parameters={"max_depth_m": 4} | change
        )
        found = tried.json()["detections"]["objects"]
        assert [each["label"] for each in found] == [each.label for each in wanted.objects]
        assert [each["bounding_box"]["x"] for each in found] == [
            each.bounding_box.x for each in wanted.objects
        ]
        assert all(each["mask"]["runs"] for each in found)


def test_robots_notice_nothing_of_it(recorded: Recorded, scene: Scene) -> None:
    number = recorded.record("arm", scene.frame())[0]
    visitor = recorded.visitor("ann")
    before = len(visitor.history("arm"))
    with fovea.Client(recorded.robots.address) as client:
        answered = client.get_statistics().frames_received
        assert visitor.post("/api/try", {"robot": "arm", "id": number}).status == 200
        assert client.get_statistics().frames_received == answered
    assert len(visitor.history("arm")) == before


@pytest.mark.parametrize(
    ("options", "status", "words"),
    [
        ({"parameters": {"no.such": 1}}, 400, "no.such"),
        ({"parameters": {"max_depth_m": -1}}, 400, "max_depth_m"),
        ({"profile": "none"}, 400, "options.profile"),
        ({"no_such": 1}, 400, "options: "),
        ([], 400, "options: "),
        ("x", 400, "options: "),
    ],
)
def test_mistakes_come_in_the_words_of_the_server(
    recorded: Recorded, scene: Scene, options: Any, status: int, words: str
) -> None:
    number = recorded.record("arm", scene.frame())[0]
    body = {"robot": "arm", "id": number, "options": options}
    answer = recorded.visitor("ann").post("/api/try", body)
    assert answer.status == status and words in answer.json()["error"]


def newest(visitor: Visitor, robot: str) -> Any:
    with Events(visitor) as events:
        return events.robot(robot)


@pytest.fixture
def arm(recorded: Recorded, scene: Scene) -> Iterator[Picking]:
    with Picking(recorded.robots.address, "picker", scene.frame(id="what I saw")) as robot:
        yield robot


@pytest.mark.parametrize("past", [False, True])
def test_a_pick_reaches_the_robot_that_asks_for_it(
    recorded: Recorded, arm: Picking, past: bool
) -> None:
    visitor = recorded.visitor("ann")
    if past:
        number = visitor.history("picker", 1)[-1]
    else:
        number = newest(visitor, "picker")["id"]
    assert arm.first is not None
    wanted = arm.first.objects[-1]
    body = {"robot": "picker", "id": number, "past": past, "label": wanted.label}
    answer = visitor.post("/api/pick", body)
    assert answer.status == 200 and answer.json()["delivered"], answer.body
    while not arm.picks:  # it is sent, and may be on its way
        assert arm.came.wait(1)
    pick = arm.picks[0]
    assert (pick.observer, pick.frame_id, pick.label) == ("ann", "what I saw", wanted.label)
    assert pick.oriented_box is not None and pick.answered_at_ns
    assert pick.oriented_box.size == pytest.approx(wanted.oriented_box.size, abs=1e-9)


def test_a_robot_that_did_not_ask_gets_none(recorded: Recorded, scene: Scene) -> None:
    with Picking(recorded.robots.address, "shy", scene.frame(), picks=False) as shy:
        visitor = recorded.visitor("ann")
        body = {"robot": "shy", "id": newest(visitor, "shy")["id"], "label": 1}
        answer = visitor.post("/api/pick", body)
        assert answer.status == 409 and "shy takes no picks" in answer.json()["error"]
        assert not shy.picks


def test_only_objects_of_the_frame_are_picked(recorded: Recorded, arm: Picking) -> None:
    visitor = recorded.visitor("ann")
    for label in (0, 250):
        body = {
            "robot": "picker",
            "id": visitor.history("picker", 1)[-1],
            "past": True,
            "label": label,
        }
        assert visitor.post("/api/pick", body).status == 404
    assert not arm.picks


def test_rights_that_are_taken_back_are_gone(scene: Scene, tmp_path: Path) -> None:
    observers = write_observers(tmp_path)
    with (
        ServerProcess(observers) as server,
        ObserverProcess(server.address, "127.0.0.1:0", *history_flags(tmp_path)) as observer,
        Picking(server.address, "arm", scene.frame()),
    ):
        visitor = Visitor(observer.address)
        visitor.log_in(OBSERVERS["ann"][0])
        number = visitor.history("arm", 1)[-1]
        body = {"robot": "arm", "id": number, "past": True, "label": 1}
        assert visitor.post("/api/try", body).status == 200
        fewer = OBSERVERS | {"ann": (OBSERVERS["ann"][0], "view", "*")}
        write_observers(tmp_path, fewer)
        os.kill(server.pid, signal.SIGHUP)
        while visitor.get("/api/session").json().get("rights") != ["view"]:
            visitor.log_in(OBSERVERS["ann"][0])  # it may have been logged out at once
        for path in ("/api/try", "/api/pick"):
            assert visitor.post(path, body).status == 404
        assert visitor.get(f"/api/history/bundle?robot=arm&at={number}").status == 404
        assert visitor.get(f"/api/history/answer?robot=arm&id={number}").status == 200
