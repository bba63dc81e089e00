"""One stream of frames and its answers."""

from __future__ import annotations

import time
from collections.abc import Callable, Generator, Iterator
from contextlib import closing
from dataclasses import dataclass
from typing import Any

import grpc
from google.protobuf.message import DecodeError

from fovea.answer_reader import AnswerReader
from fovea.better_server import BetterServer
from fovea.calls import Calls
from fovea.detections import Detections, detections_from_proto
from fovea.errors import (
    DeadlineExceeded,
    FoveaError,
    Unavailable,
    error_of,
    error_of_call,
    error_retry_after,
)
from fovea.frame_feed import FrameFeed
from fovea.picks import Pick, pick_from_proto
from fovea.retry import backoff_after, is_worth_retrying
from fovea.servers import Server
from fovea.v1 import detection_service_pb2


@dataclass(frozen=True, eq=False)
class StreamAnswer:
    """Of one frame: either detections or error is there, and the other one is None."""

    frame_id: str  # of the frame that this answers
    sequence: int  # its place among the frames sent, from 0, over all connections
    # Frames that came after the last one answered and before this one, and get no answer.
    dropped: int
    # Frames since the last answer that were sent into a connection that broke or was left, and get
    # no answer.
    lost: int
    detections: Detections | None
    error: FoveaError | None
    # What somebody has marked since the answer before; with picks=True alone.
    pick: Pick | None = None


class ResumingStream:
    """A stream that is opened again when it breaks. Client.stream makes it and documents it."""

    _reader: AnswerReader  # of the connection there is
    _server: Server  # of that

    def __init__(
        self,
        feed: FrameFeed,
        calls: Calls,
        open_call: Callable[[Server, Iterator[Any]], Any],
        timeout: float,
        request_id: str,
    ) -> None:
        """open_call: what calls.streams() returns."""
        servers = calls.servers
        self._feed = feed
        self._calls = calls
        self._servers = servers
        self._open_call = open_call
        self._retry = calls.retry
        self._timeout = timeout
        self._request_id = request_id
        self._better_server = BetterServer(lambda: servers.all(timeout), calls.get_statistics)
        self._first_of_call = 0
        self._next_expected = 0  # number of the first frame whose fate is not known
        self._num_lost = 0
        self._failures = 0
        self._broken_since = 0.0
        self._broken_by: FoveaError | None = None

    def run(self) -> Generator[StreamAnswer, None, None]:
        with closing(self._feed):
            self._open()
            try:
                while (answer := self._receive()) is not None:
                    yield answer
                    if not self._move_if_better():  # a new connection wants its first frame itself
                        self._feed.go_on()
            finally:
                self._reader.close()
        if self._feed.failure:
            raise self._feed.failure
        if self._num_lost and self._broken_by:  # no answer is left that could say so
            raise self._broken_by

    def _open(self, server: Server | None = None) -> None:
        num_sent, requests = self._feed.connect()
        self._num_lost += num_sent - self._next_expected
        self._next_expected = self._first_of_call = num_sent
        self._server = server or self._servers.home(self._timeout)
        self._reader = AnswerReader(self._open_call(self._server, requests))

    def _receive(self) -> StreamAnswer | None:
        while True:
            try:
                response = self._next_response()
            except FoveaError as error:
                error.request_id = error.request_id or self._request_id
                self._reader.close()
                self._feed.disconnect()
                if self._feed.failure or self._feed.has_all_answers(self._next_expected):
                    return None
                self._resume(error)
            else:
                return None if response is None else self._answer_of(response)

    def _next_response(self) -> Any:
        self._reader.ask()
        asked = time.monotonic()
        while True:
            try:
                return _parsed(self._reader.get(self._seconds_left(asked)))
            except grpc.RpcError as error:
                raise error_of_call(error, self._servers.max_answer_bytes) from None
            except TimeoutError:
                if self._seconds_left(asked) <= 0:
                    raise DeadlineExceeded(
                        "DEADLINE_EXCEEDED",
                        f"no answer of the stream from {self._servers.address} "
                        f"for {self._timeout:g} s",
                    ) from None

    def _seconds_left(self, asked: float) -> float:
        since = self._feed.waiting_since
        if since is None:
            return self._timeout
        return max(asked, since) + self._timeout - time.monotonic()

    def _resume(self, error: FoveaError) -> None:
        """Waits and opens the stream again; raises the error where that is not worth it."""
        self._broken_by = error
        if self._failures == 0:
            self._broken_since = time.monotonic()
        self._failures += 1
        too_late = time.monotonic() - self._broken_since >= self._timeout
        promises = is_worth_retrying(error) and not self._feed.has_ended
        if too_late or self._retry.max_attempts <= 1 or not promises:
            raise error
        self._report_end(error)
        # Also where another server is there: robots that lost the same one should not all come at
        # once.
        elsewhere = not self._servers.are_all_away()
        retry_after = None if elsewhere else error_retry_after(error)
        seconds = backoff_after(1 if elsewhere else self._failures, self._retry, retry_after)
        if elsewhere:
            self._calls.wait(self._servers.home(self._timeout), seconds)
            self._open()
        else:
            patience = self._broken_since + self._timeout - time.monotonic()
            self._open(self._calls.wait_until_connected(seconds, patience))

    def _move_if_better(self) -> bool:
        """To a server with less to do, if there is one; what was sent and not answered is lost.
        Whether it did."""
        better = self._better_server.find(self._server)
        if not better or self._feed.has_ended:  # what is under way is to be answered
            return False
        self._broken_by = Unavailable("UNAVAILABLE", "the stream went to another server")
        self._reader.close()
        self._feed.disconnect()
        self._servers.move(better)
        self._open()
        return True

    def _report_end(self, error: FoveaError) -> None:
        retry_after = error_retry_after(error)
        if retry_after == 0:  # the server has had the stream for long enough
            self._servers.on_disconnected(self._server)
        else:
            self._servers.on_away(self._server, retry_after)

    def _answer_of(self, response: Any) -> StreamAnswer:
        if self._failures:
            self._servers.on_answered(self._server)
        self._failures = 0
        sequence = response.sequence + self._first_of_call
        self._next_expected = sequence + 1
        error: FoveaError | None = self._feed.answered(sequence)
        if response.HasField("error"):
            error = error or _error_of_frame(response.error, self._request_id)
        lost, self._num_lost = self._num_lost, 0
        return StreamAnswer(
            frame_id=response.frame_id,
            sequence=sequence,
            dropped=response.dropped,
            lost=lost,
            detections=None if error else detections_from_proto(response.detections),
            error=error,
            pick=pick_from_proto(response.pick) if response.HasField("pick") else None,
        )


def _parsed(answer: bytes | None) -> Any:
    if answer is None:
        return None
    try:
        return detection_service_pb2.DetectStreamResponse.FromString(answer)
    except DecodeError:
        raise FoveaError(
            "INTERNAL", "the server sent a DetectStreamResponse that cannot be read"
        ) from None


def _error_of_frame(proto: detection_service_pb2.FrameError, request_id: str) -> FoveaError:
    has_time = proto.HasField("retry_after")
    retry_after = proto.retry_after.ToMilliseconds() / 1000 if has_time else None
    error = error_of(proto.code, proto.message, proto.field, retry_after)
    error.request_id = proto.request_id or request_id  # older servers do not say it
    return error
