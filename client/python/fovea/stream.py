"""One stream of frames and its answers."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Generator, Iterable, Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import Any

import grpc

from fovea.detections import Detections, detections_from_proto
from fovea.errors import DeadlineExceeded, FoveaError, InvalidArgument, error_of, error_of_call
from fovea.frame import Frame
from fovea.v1 import detection_pb2, detection_service_pb2, frame_pb2


@dataclass(frozen=True, eq=False)
class StreamAnswer:
    """Of one frame: either detections or error is there, and the other one is None."""

    frame_id: str  # of the frame that this answers
    sequence: int  # its place among the frames sent, from 0
    # Frames that came after the last one answered and before this one, and get no answer.
    dropped: int
    detections: Detections | None
    error: FoveaError | None


class DetectStream:
    """Client.stream makes it and documents it.

    gRPC takes the frames in a thread of its own, and answers are read in another one, so that the
    caller never waits without a limit.
    """

    def __init__(
        self,
        frames: Iterable[Frame],
        options: detection_pb2.DetectOptions,
        timeout: float,
        every_frame: bool,
    ) -> None:
        self._frames = iter(frames)
        self._options = options
        self._timeout = timeout
        # How many frames may be under way.
        self._places = threading.Semaphore(1) if every_frame else None
        self._lock = threading.Lock()
        self._num_sent = 0
        self._all_sent = False
        self._waiting_since: float | None = None  # None = there is nothing to come
        self._unfit: dict[int, InvalidArgument] = {}  # by sequence: what was not sent as it is
        self._failure: Exception | None = None  # of the iterator of frames
        self._ended = False

    def run(self, open_call: Callable[[Iterator[Any]], Any]) -> Generator[StreamAnswer, None, None]:
        with ThreadPoolExecutor(1, "fovea-stream") as reader:
            call = open_call(self._requests())
            try:
                while (response := self._receive(reader, call)) is not None:
                    yield self._answer_of(response)
                    if self._places:
                        self._places.release()
            finally:
                self._ended = True
                call.cancel()
                if self._places:
                    self._places.release()
        if self._failure:
            raise self._failure

    def _requests(self) -> Iterator[detection_service_pb2.DetectStreamRequest]:
        try:
            while True:
                if self._places:
                    self._places.acquire()
                if self._ended:
                    break
                yield self._request_of(next(self._frames))
        except StopIteration:
            pass
        except Exception as error:  # would be lost in gRPC's thread
            self._failure = error
        with self._lock:
            self._all_sent = True
            self._waiting_since = time.monotonic()  # for the end

    def _request_of(self, frame: Frame) -> detection_service_pb2.DetectStreamRequest:
        if not isinstance(frame, Frame):
            raise TypeError(f"frames must be fovea.Frame, not {type(frame).__name__}")
        try:
            proto = frame.to_proto()
        except InvalidArgument as error:
            # It keeps its place: the server refuses it, and its answer gets this error.
            with self._lock:
                self._unfit[self._num_sent] = error
            proto = frame_pb2.Frame(id=frame.id)
        request = detection_service_pb2.DetectStreamRequest(frame=proto)
        if self._num_sent == 0:
            request.options.CopyFrom(self._options)
        with self._lock:
            self._num_sent += 1
            if self._waiting_since is None:
                self._waiting_since = time.monotonic()
        return request

    def _receive(self, reader: ThreadPoolExecutor, call: Any) -> Any:
        asked = time.monotonic()
        response = reader.submit(lambda: next(call, None))
        while True:
            try:
                return response.result(self._seconds_left(asked))
            except grpc.RpcError as error:
                if self._failure:
                    return None
                raise error_of_call(error) from None
            except TimeoutError:
                if self._seconds_left(asked) <= 0:
                    raise DeadlineExceeded(
                        "DEADLINE_EXCEEDED", f"no answer of the stream for {self._timeout} s"
                    ) from None

    def _seconds_left(self, asked: float) -> float:
        with self._lock:
            if self._waiting_since is None:
                return self._timeout
            return max(asked, self._waiting_since) + self._timeout - time.monotonic()

    def _answer_of(self, response: Any) -> StreamAnswer:
        with self._lock:
            idle = response.sequence + 1 == self._num_sent and not self._all_sent
            self._waiting_since = None if idle else time.monotonic()
        error: FoveaError | None = self._take_unfit(response.sequence)
        if response.HasField("error"):
            error = error or error_of(response.error.code, response.error.message)
        return StreamAnswer(
            frame_id=response.frame_id,
            sequence=response.sequence,
            dropped=response.dropped,
            detections=None if error else detections_from_proto(response.detections),
            error=error,
        )

    def _take_unfit(self, sequence: int) -> InvalidArgument | None:
        """Those of frames before, which were dropped, are forgotten."""
        with self._lock:
            for dropped in [key for key in self._unfit if key < sequence]:
                del self._unfit[dropped]
            return self._unfit.pop(sequence, None)
