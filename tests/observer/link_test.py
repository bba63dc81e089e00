"""Connections between page and observer that go silent without an end."""

from __future__ import annotations

import socket
import threading
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
from conftest import Sending, Watched
from processes import (
    OBSERVERS,
    Events,
    ObserverProcess,
    ServerProcess,
    Visitor,
    write_observers,
)

if TYPE_CHECKING:
    from browser import Browser


def test_who_is_away_and_back_is_said_once(tmp_path: Path) -> None:
    """On standard error, however many watch."""
    observers, told = write_observers(tmp_path), tmp_path / "told"
    with ServerProcess(observers) as server, open(told, "w") as log:
        with ObserverProcess(server.address, stderr=log) as observer:
            visitors = [Visitor(observer.address) for _ in range(2)]
            for visitor, name in zip(visitors, ("ann", "ben")):
                visitor.log_in(OBSERVERS[name][0])
            with Events(visitors[0]) as one, Events(visitors[1]) as another:

                def both_see(state: str) -> None:
                    for events in (one, another):
                        events.servers(state)

                server.kill()
                both_see("away")
                for _ in range(2):
                    with ServerProcess(observers, server.address):
                        both_see("watching")
                    both_see("away")
    name = f"fovea-observer: the server at {server.address} is "
    ends = [line.removeprefix(name).split(":")[0] for line in told.read_text().splitlines()]
    assert ends == ["away", "back", "away", "back", "away"]


class Link:
    """Passes connections on; those that were there at a cut get nothing any more, and no end. Until
    it is mended there are no others."""

    def __init__(self, address: str) -> None:
        host, port = address.split(":")
        self._there = (host, int(port))
        self._listener = socket.create_server(("127.0.0.1", 0))
        self.url = f"http://127.0.0.1:{self._listener.getsockname()[1]}/"
        self._cuts = 0
        self._is_cut = False
        threading.Thread(target=self._accept, daemon=True).start()

    def cut(self) -> None:
        self._is_cut = True
        self._cuts += 1

    def mend(self) -> None:
        self._is_cut = False

    def close(self) -> None:
        self._listener.close()

    def _accept(self) -> None:
        while True:
            try:
                here = self._listener.accept()[0]
            except OSError:
                return
            if self._is_cut:
                here.close()
                continue
            there = socket.create_connection(self._there)
            for ends in ((here, there), (there, here)):
                threading.Thread(target=self._pass, args=(*ends, self._cuts), daemon=True).start()

    def _pass(self, source: socket.socket, sink: socket.socket, cuts: int) -> None:
        try:
            while data := source.recv(1 << 16):
                if self._cuts == cuts:
                    sink.sendall(data)
            if self._cuts == cuts:
                sink.shutdown(socket.SHUT_WR)
        except OSError:
            pass  # one of them has left


@pytest.fixture
def link(observer: ObserverProcess) -> Iterator[Link]:
    link = Link(observer.address)
    yield link
    link.close()


def newest(browser: Browser) -> int:
    return int(browser.find("[data-robot=kitchen-1] canvas[data-id]").get_attribute("data-id"))


def test_a_page_whose_connections_are_lost_goes_on(
    browser: Browser, observer: ObserverProcess, sending: Sending, link: Link
) -> None:
    browser.log_in(link.url, OBSERVERS["ann"][0])
    newest(browser)
    link.cut()
    browser.until(lambda: "the observer is away" in browser.text("#servers"))
    before = newest(browser)
    link.mend()
    browser.until(lambda: "away" not in browser.text("#servers"))
    browser.until(lambda: newest(browser) > before)


def test_events_say_that_they_live(observer: ObserverProcess) -> None:
    """So that a page without robots does not take its connection for lost."""
    visitor = Visitor(observer.address)
    visitor.log_in(OBSERVERS["ann"][0])
    with Events(visitor) as events:
        while line := events.response.readline():
            if line == b"event: alive\n":
                return
    raise AssertionError("the stream has ended")


def test_a_server_that_is_back_is_watched_at_once(watched: Watched) -> None:
    """Not at one of the next attempts, each of which says once more that it is away."""
    watched.server.kill()
    watched.events.servers("away")
    with (
        ServerProcess(watched.observers, watched.server.address),
        Events(watched.visitor) as events,
    ):
        states = [events.next()["servers"][0]["state"]]
        while states[-1] != "watching":
            states.append(events.next()["servers"][0]["state"])
    assert states.count("away") <= 2, states
