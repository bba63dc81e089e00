"""The calls of a client: made again where that helps, with errors that are ours, until it is closed."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import grpc

from fovea.channel import metadata_of_call
from fovea.errors import Cancelled, FoveaError, error_of_call
from fovea.explanations import of_server
from fovea.options import RetryOptions
from fovea.readiness import wait_until_connected
from fovea.retry import call_with_retries
from fovea.server_info import Statistics, statistics_from_proto
from fovea.servers import Server, Servers
from fovea.v1 import detection_service_pb2


class Calls:
    """Thread-safe. All of them raise a FoveaError: Cancelled once the client is closed."""

    def __init__(
        self, servers: Servers, retry: RetryOptions, metadata: list[tuple[str, str]]
    ) -> None:
        self.servers = servers
        self.retry = retry
        self._metadata = metadata
        self._closed = threading.Event()

    def close(self) -> None:
        """Ends all, of other threads too."""
        self._closed.set()
        self.servers.close()

    def ask(
        self,
        method: Callable[[Any], Any],
        request: object,
        timeout: float,
        request_id: str = "",
        traceparent: str = "",
    ) -> Any:
        """The answer of whichever server takes the call. method: of its stub."""
        metadata = self._metadata + metadata_of_call(request_id, traceparent)

        def call(server: Server, seconds_left: float, only_if_room: bool) -> Any:
            sent = metadata + [("fovea-only-if-room", "1")] * only_if_room
            with self.errors():
                return method(server.stub)(request, timeout=seconds_left, metadata=sent)

        try:
            return call_with_retries(self.servers, call, timeout, self.retry, self.wait)
        except FoveaError as error:
            error.request_id = error.request_id or request_id
            raise of_server(error, self.servers.address, timeout) from None

    def streams(self, request_id: str, traceparent: str) -> Callable[[Server, Iterator[Any]], Any]:
        """What opens a stream of requests to a server, each time under the same names."""
        metadata = self._metadata + metadata_of_call(request_id, traceparent)

        def open_call(server: Server, requests: Iterator[Any]) -> Any:
            with self.errors():
                return server.detect_stream(requests, metadata=metadata)

        return open_call

    def get_statistics(self, server: Server, timeout: float) -> Statistics:
        request = detection_service_pb2.GetStatisticsRequest()
        with self.errors():
            response = server.stub.GetStatistics(request, timeout=timeout, metadata=self._metadata)
        return statistics_from_proto(response)

    def wait(self, server: Server | None, seconds: float) -> None:
        # gRPC connects again at once only while somebody looks on, else within 5 s.
        watcher: Callable[[grpc.ChannelConnectivity], None] = lambda _: None
        if server and not self._closed.is_set():
            server.channel.subscribe(watcher)
            self._closed.wait(seconds)
            server.channel.unsubscribe(watcher)
        elif not server:
            self._closed.wait(seconds)
        self._require_open()

    def wait_until_connected(self, seconds: float, patience: float) -> Server | None:
        self._require_open()
        server = wait_until_connected(self.servers, self._closed, seconds, patience)
        self._require_open()
        return server

    def _require_open(self) -> None:
        if self._closed.is_set():
            raise Cancelled("CANCELLED", "the client is closed")

    @contextmanager
    def errors(self) -> Iterator[None]:
        """Turns exceptions of gRPC into ours."""
        try:
            yield
        except grpc.RpcError as error:
            raise error_of_call(error, self.servers.max_answer_bytes) from None
        except ValueError:  # what gRPC says of a closed channel
            if not self._closed.is_set():
                raise
            raise Cancelled("CANCELLED", "the client is closed") from None
