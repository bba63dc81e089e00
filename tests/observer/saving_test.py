"""Bundles while others are made or sent: one at a time, and nobody waits for it."""

from __future__ import annotations

import http.client
import io
import socket
import time
import zipfile

import numpy as np
import pytest
from conftest import Recorded, Scene
from processes import OBSERVERS, PATIENCE, Visitor

FRAMES = 16  # more than what the system keeps of a connection that nobody reads


@pytest.fixture(scope="module")
def path(recorded: Recorded, scene: Scene) -> str:
    """Of a bundle that hardly can be compressed: some MiB."""
    noise = np.random.default_rng(1)
    for number in range(FRAMES):
        color = noise.integers(0, 256, scene.color.shape, np.uint8)
        ids = recorded.record("hall", scene.frame(color=color, id=f"frame {number}"))
    return f"/api/history/bundle?robot=hall&at={ids[-1]}&before=600&after=600"


class Download:
    """A bundle of which nothing is taken before somebody reads."""

    def __init__(self, visitor: Visitor, path: str) -> None:
        host, port = visitor.address.split(":")
        connection = socket.socket()
        connection.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
        connection.settimeout(PATIENCE)
        connection.connect((host, int(port)))
        self._connection = http.client.HTTPConnection(visitor.address, timeout=PATIENCE)
        self._connection.sock = connection
        self._connection.request("GET", path, headers=visitor.headers)
        self.response = self._connection.getresponse()
        assert self.response.status == 200
        assert int(self.response.headers["Content-Length"]) > 5 << 20

    def close(self) -> None:
        self.response.close()
        self._connection.close()


def test_one_at_a_time_until_it_has_been_sent(recorded: Recorded, path: str) -> None:
    download = Download(recorded.visitor("ann"), path)
    refusal = recorded.visitor("ann").get(path)
    assert refusal.status == 429 and int(refusal.headers["Retry-After"]) > 0
    assert refusal.json()["error"].startswith("somebody saves a bundle already")
    # More than there are threads: who asks for something else is answered.
    assert all(recorded.visitor("ann").get(path).status == 429 for _ in range(16))
    assert Visitor(recorded.observer.address).log_in(OBSERVERS["cat"][0]).status == 200
    assert recorded.visitor("ben").get(path).status == 404, "which tells nothing of others"
    with zipfile.ZipFile(io.BytesIO(download.response.read())) as file:
        assert file.testzip() is None
        assert sum(name.endswith("_request.pb") for name in file.namelist()) == FRAMES
    assert recorded.visitor("ann").get(path).status == 200
    download.close()


def test_who_leaves_makes_room(recorded: Recorded, path: str) -> None:
    visitor = recorded.visitor("ann")
    Download(visitor, path).close()
    end = time.monotonic() + PATIENCE
    while (status := visitor.get(path).status) == 429 and time.monotonic() < end:
        pass
    assert status == 200
