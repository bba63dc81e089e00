"""Who gets what over HTTP, without a browser."""

from __future__ import annotations

import gzip
import http.client
import json
import os
import signal
import ssl
import subprocess
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import Robots, Scene, Watched
from processes import (
    OBSERVERS,
    PATIENCE,
    Answer,
    Events,
    ObserverProcess,
    Process,
    ServerProcess,
    Visitor,
    self_signed,
)

MAX_CLOSE = 24  # robots that one token looks at closely at once
PARTS = ("answer", "preview", "picture", "depth")


def part_of(robot: Any, part: str) -> str:
    return f"/api/{part}?robot={robot['robot']}&id={robot['id']}"


def test_the_page_needs_no_token_and_nothing_from_elsewhere(visitor: Visitor) -> None:
    for path, kind in (
        ("/", "text/html"),
        ("/page.js", "text/javascript"),
        ("/page.css", "text/css"),
    ):
        answer = visitor.get(path)
        assert answer.status == 200 and answer.headers["Content-Type"].startswith(kind)
        assert answer.headers["Content-Security-Policy"].startswith("default-src 'self';")
        assert answer.headers["X-Content-Type-Options"] == "nosniff"
        assert b"//cdn" not in gzip.decompress(answer.body)


@pytest.mark.parametrize(
    "path", ["session", "events", "answer?robot=a&id=1", "preview?robot=a&id=1"]
)
def test_all_else_needs_a_login(visitor: Visitor, path: str) -> None:
    assert visitor.get(f"/api/{path}").status == 401
    assert visitor.get(f"/api/{path}", Cookie="fovea_session=" + 64 * "0").status == 401


@pytest.mark.parametrize("token", ["", "wrong", "token-of-ann ", 300 * "x", "a\nb", "\u00e9"])
def test_wrong_tokens_are_refused(visitor: Visitor, token: str) -> None:
    answer = visitor.log_in(token)
    assert answer.status in (400, 401) and answer.json()["error"]
    assert "Set-Cookie" not in answer.headers


def test_why_a_server_refuses_is_said(visitor: Visitor, server: ServerProcess) -> None:
    answer = visitor.log_in("wrong")
    assert answer.json()["error"].startswith(f"no server knows this token ({server.address}: ")
    command = [os.environ["FOVEA_SERVER"], "--listen", "127.0.0.1:0", "--log-level", "error"]
    with Process(*command) as blind, ObserverProcess(blind.line.split()[-1]) as observer:
        problem = Visitor(observer.address).log_in(OBSERVERS["ann"][0]).json()["error"]
    assert problem.endswith(": the server has no observers (--observers))")


def test_cookies_are_kept_from_scripts_and_other_sites(visitor: Visitor) -> None:
    cookie = visitor.log_in(OBSERVERS["ann"][0]).headers["Set-Cookie"]
    assert "; HttpOnly" in cookie and "; SameSite=Strict" in cookie and "; Path=/" in cookie


def test_tells_who_is_logged_in(visitor: Visitor) -> None:
    visitor.log_in(OBSERVERS["ben"][0])
    who = visitor.get("/api/session").json()
    assert who["name"] == "ben" and who["rights"] == ["view"] and who["robots"] == ["kitchen-*"]


def test_who_logs_in_again_leaves_no_session_behind(visitor: Visitor) -> None:
    """As a browser forgets its old cookie: nobody could end that session."""
    visitor.log_in(OBSERVERS["ann"][0])
    before = visitor.headers["Cookie"]
    visitor.log_in(OBSERVERS["ben"][0])
    assert visitor.get("/api/session", Cookie=before).status == 401
    assert visitor.get("/api/session").json()["name"] == "ben"


@pytest.mark.parametrize("host", ["evil.example", "evil.example:80", "", "127.0.0.1.evil.example"])
def test_other_names_for_this_machine_are_refused(visitor: Visitor, host: str) -> None:
    assert visitor.get("/", Host=host).status == 421


def test_other_pages_cannot_post(visitor: Visitor) -> None:
    body = '{"token": "token-of-ann"}'
    for origin in ("http://evil.example", "null", f"https://{visitor.address}"):
        assert visitor.ask("POST", "/api/login", body, Origin=origin).status == 403
    assert visitor.ask("POST", "/api/login", body).status == 403
    visitor.log_in(OBSERVERS["ann"][0])
    own = f"http://{visitor.address}"
    assert visitor.ask("POST", "/api/logout", "", Origin=own).status == 403
    assert visitor.ask("POST", "/api/logout", "", Origin=own, X_Fovea_CSRF="0").status == 403
    assert visitor.get("/api/session").status == 200
    answer = visitor.ask("POST", "/api/logout", "", Origin=own, X_Fovea_CSRF=visitor.csrf)
    assert answer.status == 200
    assert visitor.get("/api/session").status == 401


def test_the_page_may_come_through_something_that_encrypts(server: ServerProcess) -> None:
    """With --insecure; browsers say what they have asked, which is https."""
    body = '{"token": "token-of-ann"}'
    flags = ["--insecure", "--host", "robots.example"]
    with ObserverProcess(server.address, "127.0.0.1:0", *flags) as observer:
        visitor = Visitor(observer.address)

        def log_in(origin: str) -> Answer:
            headers = {"Host": "robots.example", "Origin": origin}
            return visitor.ask("POST", "/api/login", body, **headers)

        encrypted, plain = log_in("https://robots.example"), log_in("http://robots.example")
        assert (encrypted.status, plain.status) == (200, 200)
        assert "; Secure" in encrypted.headers["Set-Cookie"]
        assert "; Secure" not in plain.headers["Set-Cookie"]
        for origin in ("https://evil.example", "https://robots.example:8443", "https://", "null"):
            assert log_in(origin).status == 403


def test_names_of_this_machine_have_no_case(server: ServerProcess) -> None:
    """Browsers write them in small letters."""
    with ObserverProcess(server.address, "127.0.0.1:0", "--host", "Robot-PC") as observer:
        visitor = Visitor(observer.address)
        for host in ("robot-pc", "Robot-PC:8080", "LOCALHOST"):
            assert visitor.get("/", Host=host).status == 200
        assert visitor.get("/", Host="robot-pcs").status == 421


def test_each_observer_sees_its_robots_and_no_other(
    visitor: Visitor, robots: Robots, scene: Scene
) -> None:
    visitors = {}
    for name, (token, _, _) in OBSERVERS.items():
        visitors[name] = Visitor(visitor.address)
        assert visitors[name].log_in(token).status == 200
    with Events(visitors["ann"]) as of_ann, Events(visitors["ben"]) as of_ben:
        of_ann.servers("watching")
        of_ben.servers("watching")
        for robot in ("attic-1", "kitchen-1"):
            robots.detect(robot, scene.frame())
        kitchen = of_ben.robot("kitchen-1")
        seen = of_ann.robots("attic-1", "kitchen-1")
    for part in ("answer", "preview"):
        assert visitors["ben"].get(part_of(kitchen, part)).status == 200
        for robot in seen.values():
            assert visitors["ann"].get(part_of(robot, part)).status == 200
    # Numbers of frames are each observer's own, so try all that there can be.
    for part in PARTS:
        for number in range(1, 20):
            foreign = {"robot": "attic-1", "id": number}
            assert visitors["ben"].get(part_of(foreign, part)).status == 404
            for robot in ("attic-1", "kitchen-1"):
                none = {"robot": robot, "id": number}
                assert visitors["cat"].get(part_of(none, part)).status == 404


def test_a_close_look_brings_picture_and_depth(
    visitor: Visitor, robots: Robots, scene: Scene
) -> None:
    visitor.log_in(OBSERVERS["ann"][0])
    with Events(visitor, "?close=kitchen-2&depth=1") as events:
        close = None
        while close is None:  # the look begins some time after the page asks for it
            robots.detect("kitchen-2", scene.frame())
            close = events.next().get("close")
        assert visitor.get(part_of(close, "picture")).body.startswith(b"\xff\xd8")
        depth = visitor.get(part_of(close, "depth"))
        assert depth.headers["Content-Encoding"] == "gzip"
        pixels = np.frombuffer(gzip.decompress(depth.body), "<u2").reshape(scene.depth.shape)
        assert np.array_equal(pixels, scene.depth)
        answer = visitor.get(part_of(close, "answer")).json()
        assert len(answer["detections"]["objects"]) == close["objects"] > 0


def test_looks_at_many_robots_one_after_the_other(
    visitor: Visitor, robots: Robots, scene: Scene
) -> None:
    """More than may be at once: who leaves makes room, also for those who wait for it."""
    visitor.log_in(OBSERVERS["ann"][0])
    with ExitStack() as looks:
        for number in range(MAX_CLOSE):
            look = looks.enter_context(Events(visitor, f"?close=hall-{number}"))
            look.servers("watching")
        with Events(visitor, "?close=hall-late") as events:
            robots.detect("hall-late", scene.frame())
            robot = events.robot("hall-late")
            assert robot["objects"] > 0
            looks.close()
            close = None
            while close is None:
                robots.detect("hall-late", scene.frame())
                close = events.next().get("close")
            assert close["robot"] == "hall-late"


def test_robots_with_long_names_are_looked_at(visitor: Visitor) -> None:
    """As those of certificates may be."""
    visitor.log_in(OBSERVERS["ann"][0])
    with Events(visitor, f"?close={253 * 'a'}") as events:
        events.servers("watching")


def test_a_close_look_at_a_foreign_robot_shows_nothing(
    visitor: Visitor, robots: Robots, scene: Scene
) -> None:
    visitor.log_in(OBSERVERS["ben"][0])
    with Events(visitor, "?close=attic-3&depth=1") as events:
        events.servers("watching")
        for _ in range(3):
            robots.detect("attic-3", scene.frame())
            robots.detect("kitchen-3", scene.frame())
        last = events.robot("kitchen-3")
        assert "close" not in last
        for part in PARTS:
            for number in range(1, last["id"] + 10):
                path = part_of({"robot": "attic-3", "id": number}, part)
                assert visitor.get(path).status == 404


def test_says_when_the_server_is_away_and_back(scene: Scene, watched: Watched) -> None:
    watched.server.kill()
    assert watched.events.servers("away")[0]["problem"]
    with ServerProcess(watched.observers, watched.server.address) as again:
        watched.events.servers("watching")
        Robots(again.address).detect("attic", scene.frame())
        assert watched.events.robot("attic")["objects"] > 0


def test_a_token_that_is_taken_back_ends_the_session(watched: Watched) -> None:
    watched.observers.write_text("")
    os.kill(watched.server.pid, signal.SIGHUP)
    while not watched.events.response.readline().startswith(b"event: ended"):
        pass
    assert watched.visitor.get("/api/session").status == 401


def test_other_machines_only_with_tls() -> None:
    command = [os.environ["FOVEA_OBSERVER"], "--listen", "0.0.0.0:0"]
    finished = subprocess.run(command, capture_output=True, text=True, timeout=PATIENCE)
    assert finished.returncode == 1
    assert finished.stderr.startswith('fovea-observer: --listen: "0.0.0.0:0" is open to other')


def test_serves_tls(server: ServerProcess, tmp_path: Path) -> None:
    certificate, key = self_signed(tmp_path, "page")
    flags = ["--https-cert", certificate, "--https-key", key]
    with ObserverProcess(server.address, "127.0.0.1:0", *flags) as observer:
        assert observer.url.startswith("https://")
        address = f"localhost:{observer.address.split(':')[1]}"
        context = ssl.create_default_context(cafile=certificate)
        connection = http.client.HTTPSConnection(address, timeout=PATIENCE, context=context)
        body = json.dumps({"token": OBSERVERS["ann"][0]})
        connection.request("POST", "/api/login", body, {"Origin": f"https://{address}"})
        answer = connection.getresponse()
        assert answer.status == 200
        assert "; Secure" in answer.headers["Set-Cookie"]
        connection.close()
    refused = [os.environ["FOVEA_OBSERVER"], "--listen", "127.0.0.1:0", *flags[:3], "/nowhere"]
    finished = subprocess.run(refused, capture_output=True, text=True, timeout=PATIENCE)
    assert finished.returncode == 1 and "/nowhere" in finished.stderr


def test_sighup_reads_the_certificate_again(server: ServerProcess, tmp_path: Path) -> None:
    files = [Path(path) for path in self_signed(tmp_path, "page")]
    first = [path.read_text() for path in files]
    second = [Path(path).read_text() for path in self_signed(tmp_path, "next")]
    flags = ["--https-cert", str(files[0]), "--https-key", str(files[1])]
    with ObserverProcess(server.address, "127.0.0.1:0", *flags, stderr=subprocess.PIPE) as observer:
        host, port = observer.address.split(":")

        def served() -> str:
            return ssl.get_server_certificate((host, int(port)))

        assert served() == first[0]
        files[0].write_text(second[0])
        assert f"--https-key: {files[1]} does not hold the key" in observer.hang_up()
        assert served() == first[0], "the key is not there yet"
        files[1].write_text(second[1])
        assert "certificate and key are read again" in observer.hang_up()
        assert served() == second[0]


def test_sighup_ends_no_observer(server: ServerProcess) -> None:
    with ObserverProcess(server.address, stderr=subprocess.PIPE) as observer:
        assert "nothing to read again" in observer.hang_up()
        assert Visitor(observer.address).get("/").status == 200
