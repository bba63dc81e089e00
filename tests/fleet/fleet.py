"""Two servers with TLS, with HAProxy before them or without, and robots."""

from __future__ import annotations

import os
import re
import signal
import subprocess
import threading
import urllib.request
from collections.abc import Callable
from pathlib import Path

from access_test import Authority
from server_process import PATIENCE, HeldAddress

import fovea

CONFIGURATION = Path(__file__).resolve().parents[2] / "deploy" / "haproxy" / "haproxy.cfg"


class Member:
    """One of the servers, at the same addresses whenever it runs."""

    def __init__(self, certificate: Path, key: Path) -> None:
        self.address, self.metrics = HeldAddress(), HeldAddress()
        self._flags = ["--tls-cert", str(certificate), "--tls-key", str(key), "--hold-s", "2"]
        self.start()

    def start(self) -> None:
        command = [os.environ["FOVEA_SERVER"], "--listen", str(self.address), "--log-level", "off"]
        command += ["--metrics-listen", str(self.metrics), "--compute-threads", "1", *self._flags]
        command += ["--max-waiting", "8"]  # room for a frame of each robot, however slow we are
        self.process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
        assert self.process.stdout.readline().startswith("listening on ")

    def end(self, number: int) -> None:
        self.process.send_signal(number)
        self.process.wait(PATIENCE)
        self.process.stdout.close()

    def close(self) -> None:
        self.end(signal.SIGKILL)
        self.address.close()
        self.metrics.close()

    def frames_by_robot(self) -> dict[str, int]:
        """Received since it started."""
        with urllib.request.urlopen(f"http://{self.metrics}/metrics", timeout=PATIENCE) as page:
            text = page.read().decode()
        lines = re.findall(r'^fovea_robot_frames_received_total\{robot="(.*)"\} (\d+)', text, re.M)
        return {robot: int(count) for robot, count in lines}


class Fleet:
    """As a context: that of servers that are ready."""

    def __init__(self, folder: Path, *, with_proxy: bool) -> None:
        authority = Authority(folder, "authority")
        certificate, key = authority.issue("server")
        self.tls = fovea.TlsOptions(authority.pem.read_bytes())
        self.members = [Member(certificate, key) for _ in range(2)]
        self.address = ",".join(str(member.address) for member in self.members)
        self._folder = folder
        self._proxy_address = HeldAddress()
        self._proxy = self._start_proxy() if with_proxy else None

    def __enter__(self) -> Fleet:
        with self.client("first") as client:
            client.wait_until_ready(PATIENCE)
        return self

    def __exit__(self, *_: object) -> None:
        for member in self.members:
            member.close()
        if self._proxy:
            self._proxy.terminate()
            self._proxy.wait(PATIENCE)
        self._proxy_address.close()

    def client(self, robot: str) -> fovea.Client:
        # Behind a proxy a connection outlasts the server's readiness by its drain and a second.
        retry = fovea.RetryOptions(max_attempts=10)
        return fovea.Client(self.address, tls=self.tls, robot=robot, timeout=PATIENCE, retry=retry)

    def restart_one_after_the_other(self) -> None:
        for member in self.members:
            member.end(signal.SIGTERM)
            member.start()
            with fovea.Client(str(member.address), tls=self.tls) as client:
                client.wait_until_ready(PATIENCE)

    def _start_proxy(self) -> subprocess.Popen[str]:
        """With the configuration of deploy/, but for the addresses."""
        text = CONFIGURATION.read_text()
        self.address = str(self._proxy_address)
        text = text.replace("bind :50051", f"bind {self.address}")
        for name, member in zip(("one", "two"), self.members):
            line = f"    server {name} {member.address} port {member.metrics.port}"
            text, replaced = re.subn(rf"^ *server {name} .*$", line, text, flags=re.MULTILINE)
            assert replaced == 1
        (self._folder / "haproxy.cfg").write_text(text)
        return subprocess.Popen(
            [os.environ["HAPROXY"], "-db", "-f", str(self._folder / "haproxy.cfg")], text=True
        )


class Robots:
    """Each does `work` over and over, with a client of its own, until they are told to stop."""

    def __init__(
        self, fleet: Fleet, count: int, work: Callable[[str, fovea.Client, threading.Event], None]
    ) -> None:
        self.stop = threading.Event()
        self.errors: list[BaseException] = []

        def run(name: str) -> None:
            try:
                with fleet.client(name) as client:
                    work(name, client, self.stop)
            except BaseException as error:
                self.errors.append(error)

        names = [f"robot-{number}" for number in range(count)]
        self._threads = [threading.Thread(target=run, args=(name,)) for name in names]
        for thread in self._threads:
            thread.start()

    def join(self) -> None:
        self.stop.set()
        for thread in self._threads:
            thread.join()
        assert not self.errors, self.errors
