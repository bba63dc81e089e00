"""Whether any of the servers serves, and waiting until one does or is connected."""

from __future__ import annotations

import math
import threading
import time
from collections.abc import Callable
from contextlib import AbstractContextManager

import grpc

from fovea.errors import Cancelled, DeadlineExceeded, FoveaError, Unavailable
from fovea.explanations import of_server, why_unavailable
from fovea.servers import Server, Servers

_LONGEST_LOOK = 1.0  # seconds for one server to answer, where it is asked again
_BETWEEN = 0.05  # seconds
_LOOK = 0.02  # seconds

Errors = Callable[[], AbstractContextManager[None]]  # turns exceptions of gRPC into ours


def is_serving(servers: Servers, errors: Errors, timeout: float) -> bool:
    """Asks each once. Raises a FoveaError where none answers."""
    error: FoveaError | None = None
    deadline = time.monotonic() + timeout
    has_answered = False
    for server in servers.all(timeout):
        try:
            with errors():
                if server.health.is_serving(deadline - time.monotonic()):
                    return True
            has_answered = True
        except FoveaError as failure:
            error = failure
    if error and not has_answered:
        raise of_server(error, servers.address, timeout)
    return False


def wait_until_ready(
    servers: Servers,
    errors: Errors,
    wait: Callable[[Server | None, float], None],
    timeout: float,
    patience: float = math.inf,
) -> None:
    """Returns once one serves.

    patience: seconds after which it is enough that none takes the connection; raises Unavailable.
    """
    start = time.monotonic()
    problem, is_away = "", False
    while (rest := start + timeout - time.monotonic()) > 0:
        known: list[Server] = []
        is_away = True
        try:
            known = servers.all(rest)
        except Unavailable as error:
            problem = error.message
        for server in known:
            rest = start + timeout - time.monotonic()
            try:
                with errors():
                    if server.health.is_serving(min(_LONGEST_LOOK, max(0, rest))):
                        return
                problem, is_away = "it does not serve", False
            except Unavailable as error:
                problem = error.message
            except (Cancelled, DeadlineExceeded) as error:
                problem, is_away = error.message, False
        if is_away and time.monotonic() - start > patience:
            raise Unavailable("UNAVAILABLE", why_unavailable(problem, servers.address, servers.tls))
        rest = start + timeout - time.monotonic()
        # Not at the end: gRPC's thread that looks on would find the channel closed.
        looks_on = bool(known) and rest > _BETWEEN
        wait(known[0] if looks_on else None, min(_BETWEEN, max(0, rest)))
    if is_away:
        problem = why_unavailable(problem, servers.address, servers.tls)
    text = f"the server at {servers.address} is not ready within {timeout:g} s: {problem}"
    raise DeadlineExceeded("DEADLINE_EXCEEDED", text)


def wait_until_connected(
    servers: Servers, closed: threading.Event, seconds: float, patience: float
) -> Server | None:
    """Waits `seconds`, and then up to a second for whichever server is connected first; where
    `patience` is over none is waited for.

    Calls to one that was away fail at once until gRPC has connected again, for which somebody has
    to look on: who calls one of them after the other can miss each while it is there.
    """
    connected: set[str] = set()

    def watcher_of(server: Server) -> Callable[[grpc.ChannelConnectivity], None]:
        def on_change(state: grpc.ChannelConnectivity) -> None:
            is_connected = state is grpc.ChannelConnectivity.READY
            (connected.add if is_connected else connected.discard)(server.name)

        return on_change

    watchers = [(each.channel, watcher_of(each)) for each in servers.all(patience)]
    for channel, watcher in watchers:
        channel.subscribe(watcher, try_to_connect=True)
    closed.wait(seconds)
    end = time.monotonic() + min(patience - seconds, _LONGEST_LOOK)
    while not connected and time.monotonic() < end and not closed.is_set():
        closed.wait(_LOOK)
    for channel, watcher in watchers:
        channel.unsubscribe(watcher)
    return servers.back_soonest(connected)
