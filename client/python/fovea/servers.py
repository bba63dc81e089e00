"""The servers that a client's address stands for, a connection to each, and the choice of one."""

from __future__ import annotations

import threading
import time
from collections.abc import Iterable, Iterator
from typing import Any

import grpc

from fovea.addresses import Target, find_targets, parse_addresses
from fovea.channel import check_tls, make_channel
from fovea.checks import whole
from fovea.errors import FoveaError, Unavailable
from fovea.health import Health
from fovea.options import TlsOptions
from fovea.server_choice import ServerChoice, ServerRound
from fovea.v1 import detection_service_pb2, detection_service_pb2_grpc

_MOST_MIB = 2047  # gRPC counts bytes in 31 bits
_FRESH = 5.0  # seconds between two lookups of names


class Server:
    def __init__(
        self,
        target: Target,
        has_others: bool,
        tls: TlsOptions | None,
        max_answer_mib: int,
        metadata: list[tuple[str, str]],
    ) -> None:
        self.name = target.target
        self.channel = make_channel(target, has_others, tls, max_answer_mib)
        self.stub: Any = detection_service_pb2_grpc.DetectionServiceStub(self.channel)  # type: ignore[no-untyped-call]
        # Answers come as bytes: of one that it cannot parse gRPC leaves the call open.
        self.detect_stream: Any = self.channel.stream_stream(
            "/fovea.v1.DetectionService/DetectStream",
            request_serializer=detection_service_pb2.DetectStreamRequest.SerializeToString,
        )
        self.health = Health(self.channel, metadata)
        self.is_watched = False


class Servers:
    """Thread-safe."""

    def __init__(
        self,
        address: str,
        tls: TlsOptions | None,
        max_answer_mib: int,
        metadata: list[tuple[str, str]],
    ) -> None:
        """Raises InvalidArgument for an address, a limit of answers or TLS options that are none."""
        check_tls(tls)
        self.address = address
        self.tls = tls
        self.max_answer_bytes = whole(max_answer_mib, "max_answer_mib", _MOST_MIB) << 20
        self._addresses = parse_addresses(address)
        self._of_channel = tls, max_answer_mib, metadata
        self._lock = threading.RLock()
        self._choice = ServerChoice()
        self._servers: dict[str, Server] = {}
        self._has_names = any(each.is_name for each in self._addresses)
        self._looked_up = float("-inf")
        self._lookup: threading.Thread | None = None
        self._problem: FoveaError | None = None
        if not self._has_names:
            self._take(find_targets(self._addresses))

    def close(self) -> None:
        """In a thread, which no signal interrupts: gRPC waits for ever for what was half closed."""

        def close_all() -> None:
            for server in list(self._servers.values()):
                server.channel.close()

        closing = threading.Thread(target=close_all)
        closing.start()
        closing.join()

    def all(self, timeout: float) -> list[Server]:
        """As far as names are looked up; waits where nothing is known, else raises Unavailable."""
        if not self._servers:
            self.refresh(at_once=True)
            if self._lookup:
                self._lookup.join(timeout)
        with self._lock:
            if not self._servers:
                problem = "the server's name could not be looked up in time"
                raise self._problem or Unavailable("UNAVAILABLE", problem)
            return list(self._servers.values())

    def home(self, timeout: float) -> Server:
        self.all(timeout)
        with self._lock:
            home = self._servers[self._choice.home(time.monotonic())]
            self._watch(home)
            return home

    def refresh(self, at_once: bool = False) -> None:
        """Looks names up again, in a thread that nobody has to wait for."""
        with self._lock:
            if not self._has_names or (self._lookup and self._lookup.is_alive()):
                return
            if at_once or time.monotonic() - self._looked_up >= _FRESH:
                self._lookup = threading.Thread(target=self._look_up, daemon=True)
                self._lookup.start()

    def on_away(self, server: Server, duration: float | None = None) -> None:
        self.refresh()
        with self._lock:
            self._choice.on_away(server.name, time.monotonic(), duration)

    def on_answered(self, server: Server) -> None:
        with self._lock:
            self._choice.on_answered(server.name)

    def on_disconnected(self, server: Server) -> None:
        self.refresh()
        with self._lock:
            self._choice.on_disconnected(server.name)

    def move(self, server: Server) -> None:
        """It is the one to ask first from now on."""
        with self._lock:
            self._choice.move(server.name)

    def are_all_away(self) -> bool:
        with self._lock:
            return self._choice.are_all_away(time.monotonic())

    def back_soonest(self, names: Iterable[str]) -> Server | None:
        """Of these, which is the one to ask first then."""
        with self._lock:
            if not (known := [name for name in names if name in self._servers]):
                return None
            name = self._choice.back_soonest(known)
            self._choice.move(name)
            self._watch(self._servers[name])
            return self._servers[name]

    def round(self, asks_others: bool, timeout: float) -> Round:
        self.all(timeout)
        return Round(self, asks_others)

    def _look_up(self) -> None:
        try:
            targets = find_targets(self._addresses)
        except FoveaError as error:
            with self._lock:
                self._problem, self._looked_up = error, time.monotonic()
        else:
            self._take(targets)

    def _take(self, targets: list[Target]) -> None:
        with self._lock:
            self._looked_up = time.monotonic()
            self._servers = {
                each.target: self._servers.get(each.target)
                or Server(each, len(targets) > 1, *self._of_channel)
                for each in targets
            }
            self._choice.set_servers(self._servers)

    def _watch(self, server: Server) -> None:
        """Chooses anew when the connection ends, as a server asks for that has had it for long."""
        if server.is_watched or len(self._servers) < 2:
            return
        server.is_watched = True
        was_ready = False

        def on_change(state: grpc.ChannelConnectivity) -> None:
            nonlocal was_ready
            is_ready = state is grpc.ChannelConnectivity.READY
            if was_ready and not is_ready:
                self.on_disconnected(server)
            was_ready = is_ready

        server.channel.subscribe(on_change)


class Round:
    """One call's way around, see ServerRound."""

    def __init__(self, servers: Servers, asks_others: bool) -> None:
        self._servers = servers
        self._round = ServerRound(servers._choice, asks_others)
        self.home: Server | None = None  # whom to wait for

    def asks(self) -> Iterator[tuple[Server, bool]]:
        """Servers, and whether they are to keep no place in line."""
        while True:
            with self._servers._lock:
                ask = self._round.next(time.monotonic())
                server = ask and self._servers._servers.get(ask.server)
                if server:
                    self._servers._watch(server)
            if not ask:
                return
            if not server:  # no longer one of them, by another thread's lookup
                self.on_away()
                continue
            if not ask.only_if_room:
                self.home = server
            yield server, ask.only_if_room

    @property
    def wait(self) -> float | None:
        return self._round.wait

    def on_answered(self) -> None:
        with self._servers._lock:
            self._round.on_answered()

    def on_refused(self, retry_after: float) -> None:
        self._servers.refresh()
        with self._servers._lock:
            self._round.on_refused(retry_after)

    def on_away(self) -> None:
        self._servers.refresh()
        with self._servers._lock:
            self._round.on_away(time.monotonic())
