"""Takes the caller's frames, for one connection after another."""

from __future__ import annotations

import threading
import time
from collections.abc import Iterable, Iterator
from queue import SimpleQueue
from typing import TypeAlias

from fovea.errors import InvalidArgument
from fovea.frame import Frame
from fovea.options import DetectOptions, options_to_proto
from fovea.v1 import detection_pb2, detection_service_pb2, frame_pb2

Request: TypeAlias = detection_service_pb2.DetectStreamRequest
Item: TypeAlias = Frame | tuple[Frame, DetectOptions]  # options hold for the frames after it, too
Inbox: TypeAlias = "SimpleQueue[Request | None]"  # of one connection; None = no more will come


class FrameFeed:
    """Iterates the caller's frames in one thread, whatever becomes of connections, and takes one
    only when a connection wants it. gRPC's threads never run code of the caller's, in which they
    could hang.

    close() takes no lock, and SimpleQueue.put() needs none: the garbage collector may call it in
    any thread, also in one that holds a lock of this class.
    """

    def __init__(
        self,
        frames: Iterable[Item],
        options: detection_pb2.DetectOptions,
        every_frame: bool,
        picks: bool,
    ) -> None:
        self.has_ended = False  # the caller's frames
        self.failure: BaseException | None = None  # of the caller's iterator
        self.waiting_since: float | None = None  # None = there is no answer to come
        self._frames = iter(frames)
        self._options = options
        self._refused_options: InvalidArgument | None = None  # of those that hold
        self._picks = picks
        self._every_frame = every_frame
        self._lock = threading.Lock()
        self._num_sent = 0
        self._unfit: dict[int, InvalidArgument] = {}  # by sequence: what was not sent as it is
        self._under_way: Item | None = None  # with every_frame: sent, not answered yet
        self._held: Item | None = None  # for the next connection
        self._inbox: Inbox | None = None  # of the connection there is
        self._wanting: SimpleQueue[Inbox | None] = SimpleQueue()  # None = nobody any more
        self._thread: threading.Thread | None = None

    def connect(self) -> tuple[int, Iterator[Request]]:
        """How many frames were sent or lost so far, and what a new connection is to send."""
        inbox: Inbox = SimpleQueue()
        with self._lock:
            self._inbox = inbox
            if self.has_ended:
                self._end()
            num_sent = self._num_sent
        if self._thread is None:
            # A daemon, since it may hang in the caller's iterator when the program ends.
            self._thread = threading.Thread(target=self._run, name="fovea-frames", daemon=True)
            self._thread.start()
        return num_sent, self._requests(inbox)

    def disconnect(self) -> None:
        """Frames sent without an answer are lost, and so is one that comes now, as it would be old
        when there is a connection again. With every_frame they go to the next connection."""
        with self._lock:
            self.waiting_since = None
            if self._under_way is not None:
                self._held, self._under_way = self._under_way, None
                self._num_sent -= 1
            inbox, self._inbox = self._inbox, None
        if inbox:
            inbox.put(None)

    def close(self) -> None:
        inbox, self._inbox = self._inbox, None
        if inbox:
            inbox.put(None)
        self._wanting.put(None)

    def has_all_answers(self, next_expected: int) -> bool:
        with self._lock:
            return self.has_ended and next_expected == self._num_sent > 0

    def answered(self, sequence: int) -> InvalidArgument | None:
        """Returns the error of a frame that was not sent as it is."""
        with self._lock:
            self._under_way = None
            idle = sequence + 1 == self._num_sent and not self.has_ended
            self.waiting_since = None if idle else time.monotonic()
            for dropped in [key for key in self._unfit if key < sequence]:
                del self._unfit[dropped]
            return self._unfit.pop(sequence, None)

    def go_on(self) -> None:
        """The caller wants the next answer."""
        if self._every_frame and self._inbox:
            self._wanting.put(self._inbox)

    def _requests(self, inbox: Inbox) -> Iterator[Request]:
        self._wanting.put(inbox)
        while request := inbox.get():
            yield request
            if not self._every_frame:
                self._wanting.put(inbox)

    def _run(self) -> None:
        try:
            while inbox := self._wanting.get():
                if inbox is self._inbox:  # else it broke meanwhile
                    self._hand_over(self._next_item(), inbox)
        except StopIteration:
            pass
        except BaseException as error:  # the caller's thread is to raise it, be it SystemExit
            self.failure = error
        self._frames = iter(())  # the caller's may be closed now
        with self._lock:
            self.has_ended = True
            self._end()

    def _end(self) -> None:
        self.waiting_since = time.monotonic()  # for the end of the stream
        if self._inbox:
            self._inbox.put(None)

    def _next_item(self) -> Item:
        item, self._held = self._held, None
        return next(self._frames) if item is None else item

    def _hand_over(self, item: Item, inbox: Inbox) -> None:
        request, error = self._request_of(item)
        with self._lock:
            if inbox is not self._inbox and (self._inbox or self._every_frame):
                self._held = item
                return
            sequence, self._num_sent = self._num_sent, self._num_sent + 1
            if not self._inbox:
                return  # lost
            if self._every_frame:
                self._under_way = item
            if error:
                self._unfit[sequence] = error
            if self.waiting_since is None:
                self.waiting_since = time.monotonic()
            inbox.put(request)

    def _request_of(self, item: Item) -> tuple[Request, InvalidArgument | None]:
        frame, options = item if isinstance(item, tuple) and len(item) == 2 else (item, None)
        if not isinstance(frame, Frame):
            raise TypeError(f"frames must be fovea.Frame, not {type(frame).__name__}")
        if options is not None:
            self._take(options)
        error: InvalidArgument | None
        try:
            proto, error = frame.to_proto(), self._refused_options
        except InvalidArgument as of_frame:
            error = of_frame
        if error is None:
            return self._request_with(proto), None
        # It keeps its place: the server refuses it, and its answer gets this error.
        frame_id = "" if error.field == "frame.id" else frame.id
        return self._request_with(frame_pb2.Frame(id=frame_id)), error

    def _take(self, options: DetectOptions) -> None:
        """Options that are refused hold, too, as at the server: the frame that they came with may be
        dropped, and nobody would hear of it."""
        self._refused_options = None
        try:
            self._options = options_to_proto(options)
        except InvalidArgument as error:
            self._refused_options = error

    def _request_with(self, frame: frame_pb2.Frame) -> Request:
        """Each holds what the first of a connection has to say, since any may be that."""
        return Request(frame=frame, options=self._options, accept_picks=self._picks)
