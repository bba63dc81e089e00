"""Talks to a fovea server."""

from __future__ import annotations

import math
import time
from collections.abc import Generator, Iterable
from dataclasses import fields
from types import TracebackType
from typing import Any

import numpy as np
import numpy.typing as npt

from fovea.calls import Calls
from fovea.channel import make_metadata
from fovea.checks import timeout_of_call, timeout_of_client
from fovea.detections import Detections, detections_from_proto
from fovea.errors import InvalidArgument
from fovea.frame import CameraIntrinsics, Frame
from fovea.frame_feed import FrameFeed, Item
from fovea.options import DetectOptions, RetryOptions, TlsOptions, options_to_proto
from fovea.readiness import is_serving, wait_until_ready
from fovea.server_info import (
    Option,
    ServerInfo,
    Statistics,
    options_from_proto,
    require_same_version,
    server_info_from_proto,
    statistics_from_proto,
)
from fovea.servers import Servers
from fovea.stream import ResumingStream, StreamAnswer
from fovea.v1 import detection_service_pb2

_OF_FRAME = {field.name for field in fields(Frame)}
_OF_OPTIONS = {field.name for field in fields(DetectOptions)}
_NOBODY_THERE = 0.8  # seconds: a server that is being started with its client is up by then


class Client:
    """Thread-safe: one client serves any number of threads over one connection, which it opens at
    the first call and opens again when it was lost. All times are in seconds.

    Every call has a deadline and raises a FoveaError: DeadlineExceeded when that passes,
    Unavailable when the server is away, after the attempts of `retry`, which go on for less than a
    second; Overloaded when it has too much to do until then; InvalidArgument, which names the field,
    at once.

        with fovea.Client("127.0.0.1:50051") as client:
            found = client.detect(color, depth, intrinsics)
    """

    def __init__(
        self,
        address: str,
        *,
        timeout: float = 10.0,
        retry: RetryOptions = RetryOptions(),
        max_answer_mib: int = 64,
        tls: TlsOptions | None = None,
        token: str = "",
        robot: str = "",
    ) -> None:
        """Does not connect yet; check() does.

        address: HOST:PORT (IPv6 in brackets), unix:/PATH, or several of these with commas between
            them; else InvalidArgument is raised. A name stands for all addresses that it has, and
            is looked up again when something fails. Of several servers the client stays with one,
            chosen by chance, asks the others as soon as that has no room or is away, and goes to
            another one where that takes its calls or promises to be free sooner.
        timeout: of a call that is given none; above 0, else InvalidArgument is raised.
        max_answer_mib: largest answer, 1 to 2047; the clouds of a 2048x1536 frame are 45 MiB.
        tls: encrypts where it is given.
        token: without TLS anybody on the way can read it. robot: the robot's name; empty = the
            server goes by the token, the certificate or the host. Where a token or certificate says
            whose it is, that counts, and a name given beside it is ignored.
        """
        self._timeout = timeout_of_client(timeout)
        metadata = make_metadata(token, robot)
        self._servers = Servers(address, tls, max_answer_mib, metadata)
        self._calls = Calls(self._servers, retry, metadata)

    def __enter__(self) -> Client:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()

    def close(self) -> None:
        """Ends all calls, of other threads too: they raise Cancelled."""
        self._calls.close()

    def wait_until_ready(self, timeout: float | None = None) -> None:
        """Returns once the server says that it serves; raises a FoveaError after `timeout`."""
        self._wait_until_ready(self._timeout_of(timeout))

    def is_serving(self) -> bool:
        """Asks once. False where the server answers that it does not serve; raises a FoveaError
        where it does not answer."""
        return is_serving(self._servers, self._calls.errors, self._timeout)

    def check(self, timeout: float | None = None) -> ServerInfo:
        """Waits until the server serves, and sees that it has the version of this library.

        Where nobody takes the connection, it raises Unavailable with the address within
        a second, or after `timeout` where that is given. Raises VersionMismatch, or another FoveaError
        where the server does not serve in time or does not let this client in.
        """
        patience = _NOBODY_THERE if timeout is None else math.inf
        end = time.monotonic() + self._timeout_of(timeout)
        self._wait_until_ready(end - time.monotonic(), patience)
        info = self.get_server_info(end - time.monotonic())
        require_same_version(info.version)
        return info

    def get_server_info(self, timeout: float | None = None) -> ServerInfo:
        """What this server is and what it lets through."""
        request = detection_service_pb2.GetServerInfoRequest()
        seconds = self._timeout_of(timeout)
        return server_info_from_proto(
            self._calls.ask(lambda stub: stub.GetServerInfo, request, seconds)
        )

    def list_options(self) -> list[Option]:
        """Every option of the server's method, in the order of the pipeline."""
        request = detection_service_pb2.ListOptionsRequest()
        return options_from_proto(
            self._calls.ask(lambda stub: stub.ListOptions, request, self._timeout)
        )

    def get_statistics(self) -> Statistics:
        """What it has done since it started, over all robots."""
        request = detection_service_pb2.GetStatisticsRequest()
        return statistics_from_proto(
            self._calls.ask(lambda stub: stub.GetStatistics, request, self._timeout)
        )

    def detect(
        self,
        color: npt.NDArray[np.uint8] | bytes,
        depth: npt.NDArray[np.uint16] | npt.NDArray[np.float32] | bytes,
        intrinsics: CameraIntrinsics | npt.ArrayLike,
        options: DetectOptions = DetectOptions(),
        *,
        timeout: float | None = None,
        request_id: str = "",
        traceparent: str = "",
        **frame: Any,
    ) -> Detections:
        """The objects in one frame. Frame says what color, depth and intrinsics may be, and which
        further arguments there are, for example gravity, camera_pose or depth_encoding.

        No object is an answer, whose diagnostics say why.

        request_id: what the server calls the request in its log, 1 to 64 printable ASCII
            characters; empty = a number that it makes up.
        traceparent: W3C Trace Context: whose children the spans of the call's frames are, where the
            server sends traces.
        """
        ids = {"request_id": request_id, "traceparent": traceparent}
        _require_known(frame)
        whole = Frame(color, depth, intrinsics, **frame)
        return self.detect_frame(whole, options, timeout=timeout, **ids)

    def detect_frame(
        self,
        frame: Frame,
        options: DetectOptions = DetectOptions(),
        *,
        timeout: float | None = None,
        request_id: str = "",
        traceparent: str = "",
    ) -> Detections:
        request = detection_service_pb2.DetectRequest(
            frame=frame.to_proto(), options=options_to_proto(options)
        )
        if request.options.tracking.enabled:
            problem = "tracking needs a stream of frames; call Client.stream"
            raise InvalidArgument("options.tracking.enabled", problem)
        seconds = self._timeout_of(timeout)
        response = self._calls.ask(
            lambda stub: stub.Detect, request, seconds, request_id, traceparent
        )
        return detections_from_proto(response.detections)

    def stream(
        self,
        frames: Iterable[Item],
        options: DetectOptions = DetectOptions(),
        *,
        timeout: float | None = None,
        every_frame: bool = False,
        picks: bool = False,
        request_id: str = "",
        traceparent: str = "",
    ) -> Generator[StreamAnswer, None, None]:
        """Sends frames as `frames` yields them and yields the answers in order.

        Made for cameras: the server answers the newest frame and drops those that came while it
        was at work; StreamAnswer.dropped counts them, and the last frame is always answered. With
        `every_frame` the next frame is taken only when the last one has its answer, so that none
        is dropped. A frame that cannot be answered gets an error in its answer and the stream goes
        on. Raises whatever `frames` raises, after the answers to the frames before.

        Instead of a Frame, `frames` may yield (Frame, DetectOptions): these options hold from that
        frame on.

        A stream that breaks, for example because the server was killed and started again, is opened
        again as `retry` says, however often. Frames that were sent and have no answer are lost, and
        StreamAnswer.lost counts them; with `every_frame` they are sent again. So it is where the
        stream goes to another server, which has less to do. Raises the FoveaError
        where trying again would bring nothing, where no frame has been answered for `timeout` since
        the stream broke, and at the end where the last frames were lost.

        `frames` is iterated in another thread. Stop early by leaving the loop or with close(): what
        has no answer yet is cancelled.

        timeout: longest wait for an answer while a frame has none; the stream itself has no end.
        picks: people who watch the robot may mark objects for it: StreamAnswer.pick.
        request_id, traceparent: as those of detect(), of every connection of the stream.
        """
        open_call = self._calls.streams(request_id, traceparent)
        feed = FrameFeed(frames, options_to_proto(options), every_frame, picks)
        seconds = self._timeout_of(timeout)
        return ResumingStream(feed, self._calls, open_call, seconds, request_id).run()

    def _wait_until_ready(self, timeout: float, patience: float = math.inf) -> None:
        wait_until_ready(self._servers, self._calls.errors, self._calls.wait, timeout, patience)

    def _timeout_of(self, timeout: float | None) -> float:
        return self._timeout if timeout is None else timeout_of_call(timeout)


def _require_known(frame: dict[str, Any]) -> None:
    """Python's own error would name Frame.__init__, which nobody called."""
    for name in (name for name in frame if name not in _OF_FRAME):
        taken = f"; options=fovea.DetectOptions({name}=...) takes it" if name in _OF_OPTIONS else ""
        raise TypeError(f"detect() got an unexpected keyword argument {name!r}{taken}")
