"""Clients that are closed while gRPC is still at work, and interrupted in that."""

from __future__ import annotations

import socket
import threading
from typing import Any

import pytest
from server_process import PATIENCE

import fovea


def test_a_client_closed_after_waiting_in_vain_leaves_no_failure(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    failures: list[Any] = []
    monkeypatch.setattr(threading, "excepthook", failures.append)
    before = set(threading.enumerate())
    with socket.create_server(("127.0.0.1", 0)) as silent:
        for _ in range(20):
            with fovea.Client(f"127.0.0.1:{silent.getsockname()[1]}", timeout=0.05) as client:
                with pytest.raises(fovea.DeadlineExceeded):
                    client.wait_until_ready()
    for each in set(threading.enumerate()) - before:
        each.join(PATIENCE)
    assert [str(each.exc_value) for each in failures] == []


def test_no_interrupt_ends_closing_midway(monkeypatch: pytest.MonkeyPatch) -> None:
    """The second Ctrl-C of somebody who does not want to wait: what gRPC had half closed hung."""
    client = fovea.Client("127.0.0.1:1")
    (server,) = client._servers.all(PATIENCE)
    closed_by: list[threading.Thread] = []
    close = server.channel.close
    monkeypatch.setattr(
        server.channel, "close", lambda: (closed_by.append(threading.current_thread()), close())
    )
    client.close()
    assert len(closed_by) == 1
    assert closed_by[0] is not threading.main_thread()  # the only one that signals interrupt
