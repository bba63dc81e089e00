"""The last minutes on disk: who sees what of them, and what outlives what."""

from __future__ import annotations

import os
import resource
import subprocess
from pathlib import Path

import pytest
from conftest import Recorded, Robots, Scene, bundle, recorder_is_ready
from processes import (
    OBSERVERS,
    PATIENCE,
    Events,
    ObserverProcess,
    ServerProcess,
    Visitor,
    held_address,
    history_flags,
    write_observers,
)


PARTS = ("answer", "picture", "depth")


def past(robot: str, frame: int, part: str) -> str:
    return f"/api/history/{part}?robot={robot}&id={frame}"


def folder_size(folder: Path) -> int:
    return sum(path.stat().st_size for path in folder.rglob("*.frame"))


def test_what_was_seen_can_be_seen_again(recorded: Recorded, scene: Scene) -> None:
    first, second = recorded.record("attic", scene.frame(id="one"), scene.frame(id="two"))
    visitor = recorded.visitor("ann")
    for frame, name in ((first, "one"), (second, "two")):
        answer = visitor.get(past("attic", frame, "answer")).json()
        assert answer["line"]["frame_id"] == answer["frame"]["frame_id"] == name
        assert len(answer["frame"]["detections"]["objects"]) == answer["line"]["objects"] > 0
        assert "frame" not in answer["frame"] and "answer" not in answer["frame"]
        assert visitor.get(past("attic", frame, "picture")).body.startswith(b"\xff\xd8")
        assert visitor.get(past("attic", frame, "depth")).headers["Content-Encoding"] == "gzip"


def test_each_session_sees_what_its_own_token_lets_it_see(recorded: Recorded, scene: Scene) -> None:
    """Whatever the observer's own token let it record."""
    kitchen = recorded.record("kitchen-1", scene.frame())[0]
    attic = recorded.record("attic", scene.frame())[0]
    ben, cat = recorded.visitor("ben"), recorded.visitor("cat")
    assert ben.history("kitchen-1") and not ben.history("attic") and not cat.history("kitchen-1")
    for part in PARTS:
        assert ben.get(past("kitchen-1", kitchen, part)).status == 200
        assert ben.get(past("attic", attic, part)).status == 404
        assert cat.get(past("kitchen-1", kitchen, part)).status == 404
    # Ben has no right to download, whatever he sees.
    for robot, frame in (("kitchen-1", kitchen), ("attic", attic)):
        for path in (bundle(robot, frame), bundle(robot, frame, 5, 5)):
            assert ben.get(path).status == 404
            assert cat.get(path).status == 404
            assert recorded.visitor("ann").get(path).status == 200


@pytest.mark.parametrize(
    "query", ["", "at=x", "at=-1", "at=1&before=x", "at=1&after=601", "at=99999999999999999999"]
)
def test_malformed_moments_are_named(recorded: Recorded, query: str) -> None:
    answer = recorded.visitor("ann").get(f"/api/history/bundle?robot=first&{query}")
    assert answer.status == 400 and answer.json()["error"].startswith("at: ")


def test_outlives_both_programs(scene: Scene, tmp_path: Path) -> None:
    observers, flags = write_observers(tmp_path), history_flags(tmp_path)
    with ServerProcess(observers) as server:
        robots = Robots(server.address)
        with ObserverProcess(server.address, held_address(), *flags) as observer:
            visitor = Visitor(observer.address)
            visitor.log_in(OBSERVERS["ann"][0])
            recorder_is_ready(visitor, robots)
            robots.detect("attic", scene.frame())
            kept = visitor.history("attic", 1)
            # The server is killed and comes back: what it saw stays, and more is recorded.
            server.kill()
            assert visitor.history("attic") == kept
            with ServerProcess(observers, server.address):
                end = len(kept)
                while len(visitor.history("attic")) == end:
                    robots.detect("attic", scene.frame())
                kept = visitor.history("attic")
                observer.kill()
                folder = tmp_path / "history" / "attic"
                half = folder / f"{kept[-1] + 1:020}.frame"
                half.write_bytes((folder / f"{kept[-1]:020}.frame").read_bytes()[:-1])
                (folder / f"{kept[-1] + 2:020}.frame.part").write_bytes(b"FOVEAHF1")
                with ObserverProcess(server.address, observer.address, *flags) as again:
                    visitor = Visitor(again.address)
                    visitor.log_in(OBSERVERS["ann"][0])
                    known = visitor.history("attic", len(kept))
                    assert known[: len(kept)] == kept
                    assert visitor.get(past("attic", kept[0], "answer")).status == 200
                    assert not half.exists() and not list(folder.glob("*.part"))
                    while len(visitor.history("attic")) == len(known):
                        robots.detect("attic", scene.frame())


def test_robots_that_are_silent_now_are_listed(scene: Scene, tmp_path: Path) -> None:
    """With their newest frame, to whoever may see them."""
    observers, flags = write_observers(tmp_path), history_flags(tmp_path)
    with ServerProcess(observers) as server:
        with ObserverProcess(server.address, "127.0.0.1:0", *flags) as observer:
            recorded = Recorded(observer, Robots(server.address))
            recorder_is_ready(recorded.visitor("ann"), recorded.robots)
            frames = scene.frame(id="one"), scene.frame(id="two")
            newest = recorded.record("attic", *frames)[-1]
            recorded.record("kitchen-1", scene.frame())
        with ObserverProcess(server.address, "127.0.0.1:0", *flags) as observer:
            again = Recorded(observer, recorded.robots)
            ann = again.visitor("ann")
            with Events(ann) as events:
                line = events.robots("attic", "kitchen-1")["attic"]
            assert line["frame_id"] == "two" and line["came_at_us"] == newest
            shown = f"?robot=attic&id={line['id']}"
            assert len(ann.get(f"/api/answer{shown}").json()["detections"]["objects"]) > 0
            assert ann.get(f"/api/preview{shown}").body.startswith(b"\xff\xd8")
            with Events(again.visitor("ben")) as events:
                seen: set[str] = set()
                while "kitchen-1" not in seen:
                    seen |= {robot["robot"] for robot in events.next()["robots"]}
            assert seen == {"kitchen-1"}
            with Events(ann) as events:
                again.record("attic", scene.frame(id="three"))
                while line["frame_id"] != "three":  # the server's newest, "two", may come before it
                    line = events.robot("attic", newer_than=line["id"])


def test_stays_within_its_size(scene: Scene, tmp_path: Path) -> None:
    most = 2 << 20
    observers, flags = write_observers(tmp_path), history_flags(tmp_path, size=most)
    with (
        ServerProcess(observers) as server,
        ObserverProcess(server.address, "127.0.0.1:0", *flags) as observer,
    ):
        recorded = Recorded(observer, Robots(server.address))
        visitor = recorded.visitor("ann")
        recorder_is_ready(visitor, recorded.robots)
        first: list[int] = []
        for robot in ("attic", "hall", "yard"):
            for _ in range(8):
                newest = recorded.record(robot, scene.frame())
                first = first or newest
                assert folder_size(tmp_path / "history") <= most
                assert folder_size(tmp_path / "history" / robot) <= most / 2
        assert first[0] not in visitor.history("attic"), "the oldest goes first"
        assert visitor.history("yard")
        told = visitor.get("/api/session").json()["history"]
        assert told["shortage"] == "holds less than 10 minutes: --history-size is too little"
        assert told["problem"] == ""


def test_what_cannot_be_written_ends_nothing(scene: Scene, tmp_path: Path) -> None:
    """Files that would be larger than they may be, and a log whose reader has gone."""

    def limit_files() -> None:
        resource.setrlimit(resource.RLIMIT_FSIZE, (1 << 16, 1 << 16))

    reader, log = os.pipe()
    os.close(reader)
    flags = history_flags(tmp_path)
    with (
        ServerProcess(write_observers(tmp_path)) as server,
        ObserverProcess(
            server.address, "127.0.0.1:0", *flags, stderr=log, preexec_fn=limit_files
        ) as observer,
    ):
        os.close(log)
        recorded = Recorded(observer, Robots(server.address))
        visitor = recorded.visitor("ann")
        while "too large" not in visitor.get("/api/session").json()["history"]["problem"]:
            recorded.robots.detect("attic", scene.frame())


def test_the_oldest_minutes_go(scene: Scene, tmp_path: Path) -> None:
    observers, flags = write_observers(tmp_path), history_flags(tmp_path, minutes=1)
    with ServerProcess(observers) as server:
        robots = Robots(server.address)
        with ObserverProcess(server.address, "127.0.0.1:0", *flags) as observer:
            visitor = Visitor(observer.address)
            visitor.log_in(OBSERVERS["ann"][0])
            recorder_is_ready(visitor, robots)
            robots.detect("attic", scene.frame())
            number = visitor.history("attic", 1)[0]
        # As if that had been more than a minute ago.
        folder = tmp_path / "history" / "attic"
        old = folder / f"{number - 61_000_000:020}.frame"
        (folder / f"{number:020}.frame").rename(old)
        with ObserverProcess(server.address, "127.0.0.1:0", *flags) as observer:
            visitor = Visitor(observer.address)
            visitor.log_in(OBSERVERS["ann"][0])
            assert visitor.history("attic") == [
                number - 61_000_000
            ], "a silent robot's last minutes"
            while visitor.history("attic")[0] < number:
                robots.detect("attic", scene.frame())
            assert not old.exists()


def test_who_records_is_said(tmp_path: Path) -> None:
    observers = write_observers(tmp_path)
    with ServerProcess(observers) as server:
        without = ["--history", str(tmp_path / "none")]
        with ObserverProcess(server.address, "127.0.0.1:0", *without) as observer:
            visitor = Visitor(observer.address)
            visitor.log_in(OBSERVERS["ann"][0])
            assert visitor.get("/api/session").json()["history"] is None
            assert visitor.get("/api/history?robot=attic").status == 404
        flags = history_flags(tmp_path)
        (tmp_path / "recorder").write_text(OBSERVERS["ben"][0])  # who may not download
        with ObserverProcess(server.address, "127.0.0.1:0", *flags) as observer:
            visitor = Visitor(observer.address)
            visitor.log_in(OBSERVERS["ann"][0])
            while not (told := visitor.get("/api/session").json()["history"]["problem"]):
                pass
            assert "download" in told


def test_mistakes_of_flags_are_named(tmp_path: Path) -> None:
    def error_of(*flags: str) -> str:
        command = [os.environ["FOVEA_OBSERVER"], "--listen", "127.0.0.1:0", *flags]
        finished = subprocess.run(command, capture_output=True, text=True, timeout=PATIENCE)
        assert finished.returncode == 1
        return finished.stderr

    token = tmp_path / "token"
    token.write_text("\n")
    assert "--history-token-file needs --history" in error_of("--history-token-file", str(token))
    used = ["--history", str(tmp_path / "used"), "--history-token-file", str(token)]
    assert "no token in its first line" in error_of(*used)
    nowhere = str(tmp_path / "nowhere")
    assert f"--history-token-file: cannot read {nowhere}" in error_of(*used[:3], nowhere)
    token.write_text("token")
    (tmp_path / "file").write_text("")
    assert "--history: " in error_of("--history", str(tmp_path / "file"), *used[2:])
    with ObserverProcess("127.0.0.1:1", "127.0.0.1:0", *used):
        assert "another program uses it" in error_of(*used)
