"""Two servers with TLS under load, restarted one after the other and killed."""

from __future__ import annotations

import os
import re
import signal
import socket
import subprocess
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from access_test import Authority
from conftest import Scene, scene  # noqa: F401
from server_process import PATIENCE

import fovea

NUM_ROBOTS = 4


def free_port() -> int:
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        return int(taken.getsockname()[1])


class Member:
    """One of the servers, at the same ports whenever it runs."""

    def __init__(self, certificate: Path, key: Path) -> None:
        self.address, self.metrics = (f"127.0.0.1:{free_port()}" for _ in range(2))
        self._flags = ["--tls-cert", str(certificate), "--tls-key", str(key), "--hold-s", "2"]
        self.start()

    def start(self) -> None:
        command = [os.environ["FOVEA_SERVER"], "--listen", self.address, "--log-level", "off"]
        command += ["--metrics-listen", self.metrics, "--compute-threads", "1", *self._flags]
        self.process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
        assert self.process.stdout.readline().startswith("listening on ")

    def end(self, number: int) -> None:
        self.process.send_signal(number)
        self.process.wait(PATIENCE)
        self.process.stdout.close()


class Fleet:
    def __init__(self, authority: Authority) -> None:
        certificate, key = authority.issue("server")
        self.tls = fovea.TlsOptions(authority.pem.read_bytes())
        self.members = [Member(certificate, key) for _ in range(2)]
        self.address = ",".join(member.address for member in self.members)

    def client(self, robot: str) -> fovea.Client:
        # Behind a proxy a connection outlasts the server's readiness by its drain and a second.
        retry = fovea.RetryOptions(max_attempts=10)
        return fovea.Client(
            self.address, tls=self.tls, robot=robot, timeout=PATIENCE, retry=retry
        )

    def restart_one_after_the_other(self) -> None:
        for member in self.members:
            member.end(signal.SIGTERM)
            member.start()
            with fovea.Client(member.address, tls=self.tls) as client:
                client.wait_until_ready(PATIENCE)


@pytest.fixture
def authority(tmp_path: Path) -> Authority:
    return Authority(tmp_path, "authority")


@pytest.fixture(params=["with HAProxy", "without a proxy"])
def fleet(request: pytest.FixtureRequest, authority: Authority, tmp_path: Path) -> Iterator[Fleet]:
    fleet = Fleet(authority)
    proxy = start_proxy(fleet, tmp_path) if request.param == "with HAProxy" else None
    with fleet.client("first") as client:
        client.wait_until_ready(PATIENCE)
    yield fleet
    for member in fleet.members:
        member.end(signal.SIGKILL)
    if proxy:
        proxy.terminate()
        proxy.wait(PATIENCE)


def start_proxy(fleet: Fleet, folder: Path) -> subprocess.Popen[str]:
    """With the configuration of deploy/, but for the addresses."""
    text = (Path(os.environ["FOVEA_SOURCE_DIR"]) / "deploy/haproxy/haproxy.cfg").read_text()
    address = f"127.0.0.1:{free_port()}"
    text = text.replace("bind :50051", f"bind {address}")
    for name, member in zip(("one", "two"), fleet.members):
        port = member.metrics.split(":")[1]
        line = f"    server {name} {member.address} port {port}"
        text, replaced = re.subn(rf"^ *server {name} .*$", line, text, flags=re.MULTILINE)
        assert replaced == 1
    (folder / "haproxy.cfg").write_text(text)
    fleet.address = address
    return subprocess.Popen(
        [os.environ["HAPROXY"], "-db", "-f", str(folder / "haproxy.cfg")], text=True
    )


class Robots:
    """Each does `work` over and over, with a client of its own, until they are told to stop."""

    def __init__(self, fleet: Fleet, work: Callable[[fovea.Client, threading.Event], None]) -> None:
        self.stop = threading.Event()
        self.errors: list[BaseException] = []

        def run(number: int) -> None:
            try:
                with fleet.client(f"robot-{number}") as client:
                    work(client, self.stop)
            except BaseException as error:
                self.errors.append(error)

        self._threads = [threading.Thread(target=run, args=(i,)) for i in range(NUM_ROBOTS)]
        for thread in self._threads:
            thread.start()

    def join(self) -> None:
        self.stop.set()
        for thread in self._threads:
            thread.join()
        assert not self.errors


def test_no_call_fails_while_both_are_restarted(fleet: Fleet, scene: Scene) -> None:
    num_answers = [0]

    def call(client: fovea.Client, stop: threading.Event) -> None:
        while not stop.is_set():
            assert client.detect_frame(scene.frame()).objects
            num_answers[0] += 1
            stop.wait(0.8)  # a load that one server can bear

    robots = Robots(fleet, call)
    fleet.restart_one_after_the_other()
    robots.join()
    assert num_answers[0] > NUM_ROBOTS


def test_streams_are_back_when_one_is_killed(fleet: Fleet, scene: Scene) -> None:
    """Says how long it took; that every stream is back, with each frame answered or counted as
    lost, is what is asserted."""
    killed_at: list[float] = []
    gaps: list[float] = []

    def stream(client: fovea.Client, stop: threading.Event) -> None:
        def camera() -> Iterator[fovea.Frame]:
            while not stop.wait(0.2):
                yield scene.frame()

        num_known = 0
        last = time.monotonic()
        for answer in client.stream(camera()):
            num_known += 1 + answer.dropped + answer.lost
            assert answer.sequence + 1 == num_known
            now = time.monotonic()
            if killed_at and last < killed_at[0] + 0.3 and now > killed_at[0]:
                gaps.append(now - killed_at[0])
            last = now

    robots = Robots(fleet, stream)
    for member in fleet.members:
        threading.Event().wait(2)
        killed_at[:] = [time.monotonic()]
        member.end(signal.SIGKILL)
        threading.Event().wait(3)
        member.start()
        threading.Event().wait(1)
    robots.join()
    print(f"back after {sorted(round(gap, 2) for gap in gaps)} s")
    assert gaps
