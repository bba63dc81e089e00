"""A server with observers, fovea-observer before it, and browsers' requests to that."""

from __future__ import annotations

import hashlib
import http.client
import json
import os
import signal
import socket
import subprocess
import time
from pathlib import Path
from typing import Any
from urllib.parse import quote

PATIENCE = 60.0  # seconds; only a broken test waits that long

# Who may what, with which token.
OBSERVERS = {
    "ann": ("token-of-ann", "view,try,download,pick", "*"),
    "ben": ("token-of-ben", "view", "kitchen-*"),
    "cat": ("token-of-cat", "view", "nobody"),
    # fovea-observer itself, where it records.
    "rec": ("token-of-rec", "view,download", "*"),
}


def write_observers(folder: Path, observers: dict[str, tuple[str, str, str]] = OBSERVERS) -> Path:
    lines = [
        f"{name} {hashlib.sha256(token.encode()).hexdigest()} {rights} {robots}\n"
        for name, (token, rights, robots) in observers.items()
    ]
    path = folder / "observers"
    path.write_text("".join(lines))
    return path


def self_signed(folder: Path, name: str) -> tuple[str, str]:
    """A certificate of localhost and its key."""
    certificate, key = (str(folder / f"{name}.{kind}") for kind in ("pem", "key"))
    command = ["openssl", "req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:P-256"]
    command += ["-nodes", "-subj", "/CN=localhost", "-addext", "subjectAltName=DNS:localhost"]
    command += ["-keyout", key, "-out", certificate]
    subprocess.run(command, check=True, capture_output=True)
    return certificate, key


def history_flags(folder: Path, **flags: Any) -> list[str]:
    """Of an observer that records to a folder here."""
    token = folder / "recorder"
    token.write_text(OBSERVERS["rec"][0] + "\n")
    named = {"history": folder / "history", "history-token-file": token, "history-rate": 30}
    named |= {f"history-{name}": value for name, value in flags.items()}
    return [part for name, value in named.items() for part in (f"--{name}", str(value))]


class Process:
    """A program of ours that says where it listens in its first line. `options` are Popen's."""

    def __init__(self, *command: str, **options: Any) -> None:
        self._process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True, **options)
        assert self._process.stdout is not None
        self.line = self._process.stdout.readline().strip()
        assert self.line, f"{command[0]} did not start"

    def __enter__(self) -> Any:
        return self

    def __exit__(self, *_: object) -> None:
        self.kill()

    def kill(self) -> None:
        self._process.kill()
        self._process.wait()

    def hang_up(self) -> str:
        """What it says to SIGHUP, where its standard error is a pipe."""
        os.kill(self.pid, signal.SIGHUP)
        assert self._process.stderr is not None
        return str(self._process.stderr.readline()).strip()

    @property
    def pid(self) -> int:
        return self._process.pid


_held: list[socket.socket] = []


def held_address() -> str:
    """One of loopback that nobody else is given while this program runs; whoever sets SO_REUSEADDR,
    as our programs do, may listen on it, now or again."""
    held = socket.socket()
    held.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    held.bind(("127.0.0.1", 0))
    _held.append(held)
    return f"127.0.0.1:{held.getsockname()[1]}"


class ServerProcess(Process):
    def __init__(self, observers: Path, address: str = "") -> None:
        flags = ["--listen", address or held_address(), "--log-level", "error"]
        flags += ["--observers", str(observers)]
        super().__init__(os.environ["FOVEA_SERVER"], *flags)
        self.address = self.line.split()[-1]


class ObserverProcess(Process):
    def __init__(
        self, server: str, listen: str = "127.0.0.1:0", *flags: str, **options: Any
    ) -> None:
        command = ["--server", server, "--listen", listen, *flags]
        super().__init__(os.environ["FOVEA_OBSERVER"], *command, **options)
        self.url = self.line.split()[-1]
        self.address = self.url.split("/")[2]


class Answer:
    def __init__(self, response: http.client.HTTPResponse) -> None:
        self.status = response.status
        self.headers = response.headers
        self.body = response.read()

    def json(self) -> Any:
        return json.loads(self.body)


class Visitor:
    """Sends requests as a browser would, or as a browser never would."""

    def __init__(self, address: str) -> None:
        self.address = address
        self.headers: dict[str, str] = {}
        self.csrf = ""

    def ask(self, method: str, path: str, body: str | None = None, **headers: str) -> Answer:
        connection = http.client.HTTPConnection(self.address, timeout=PATIENCE)
        try:
            named = {name.replace("_", "-"): value for name, value in headers.items()}
            connection.request(method, path, body, self.headers | named)
            return Answer(connection.getresponse())
        finally:
            connection.close()

    def get(self, path: str, **headers: str) -> Answer:
        return self.ask("GET", path, **headers)

    def post(self, path: str, body: Any) -> Answer:
        """As the page does it."""
        own = {"Origin": f"http://{self.address}", "X_Fovea_CSRF": self.csrf}
        return self.ask("POST", path, json.dumps(body), **own)

    def history(self, robot: str, count: int = 0, patience: float = PATIENCE) -> list[int]:
        """The frames that are there; waits for so many."""
        end = time.monotonic() + patience
        while time.monotonic() < end:
            ids = self.get(f"/api/history?robot={quote(robot)}").json()["ids"]
            if len(ids) >= count:
                return list(ids)
            time.sleep(0.02)
        raise AssertionError(f"{robot} has no {count} frames in the history")

    def newer(self, robot: str, than: int, patience: float = PATIENCE) -> int:
        """The newest frame; waits for one after that, while old ones may go."""
        end = time.monotonic() + patience
        while time.monotonic() < end:
            newest = max(self.history(robot), default=0)
            if newest > than:
                return newest
            time.sleep(0.02)
        raise AssertionError(f"{robot} has no frame after {than} in the history")

    def log_in(self, token: str) -> Answer:
        body = json.dumps({"token": token})
        answer = self.ask("POST", "/api/login", body, Origin=f"http://{self.address}")
        if answer.status == 200:
            self.headers["Cookie"] = answer.headers["Set-Cookie"].split(";")[0]
            self.csrf = answer.json()["csrf"]
        return answer


class Events:
    """The lines of /api/events."""

    def __init__(self, visitor: Visitor, query: str = "") -> None:
        self._connection = http.client.HTTPConnection(visitor.address, timeout=PATIENCE)
        self._connection.request("GET", f"/api/events{query}", headers=visitor.headers)
        self.response = self._connection.getresponse()
        assert self.response.status == 200, self.response.read()

    def __enter__(self) -> Events:
        return self

    def __exit__(self, *_: object) -> None:
        self.response.close()
        self._connection.close()

    def next(self) -> Any:
        end = time.monotonic() + PATIENCE
        is_named = False  # others than changes are: "alive", "ended"
        while time.monotonic() < end:
            line = self.response.readline().decode()
            assert line, "the stream has ended"
            if line.startswith("data: ") and not is_named:
                return json.loads(line[len("data: ") :])
            is_named = line.startswith("event: ")
        raise AssertionError("the stream lives, but nothing happens")

    def robot(self, name: str, newer_than: int = 0) -> Any:
        """Of the list of robots, the next one of this name."""
        while True:
            for robot in self.next()["robots"]:
                if robot["robot"] == name and robot["id"] > newer_than:
                    return robot

    def robots(self, *names: str) -> dict[str, Any]:
        """The first lines of these robots, which may come together or one after the other."""
        seen: dict[str, Any] = {}
        while not all(name in seen for name in names):
            seen = {robot["robot"]: robot for robot in self.next()["robots"]} | seen
        return {name: seen[name] for name in names}

    def servers(self, state: str) -> Any:
        while True:
            servers = self.next()["servers"]
            if all(server["state"] == state for server in servers):
                return servers
