"""Reads the answers of one call."""

from __future__ import annotations

from queue import Empty, SimpleQueue
from threading import Thread
from typing import Any


class AnswerReader:
    """Waits for answers in a thread of its own, as gRPC knows no limit for that.

    No ThreadPoolExecutor: the end of the program would wait for its threads, and so would the
    garbage collector, maybe in the thread of gRPC that they wait for.
    """

    def __init__(self, call: Any) -> None:
        self._call = call
        self._asked: SimpleQueue[bool] = SimpleQueue()  # False = no more
        self._answers: SimpleQueue[Any] = SimpleQueue()  # or what gRPC raised
        Thread(target=self._run, name="fovea-stream", daemon=True).start()

    def ask(self) -> None:
        """For one answer, which get() then returns."""
        self._asked.put(True)

    def get(self, timeout: float) -> Any:
        """None at the end. Raises TimeoutError or grpc.RpcError."""
        try:
            answer = self._answers.get(timeout=max(timeout, 0))
        except Empty:
            raise TimeoutError from None
        if isinstance(answer, Exception):
            raise answer
        return answer

    def close(self) -> None:
        """Cancels what has no answer yet."""
        self._call.cancel()
        self._asked.put(False)

    def _run(self) -> None:
        while self._asked.get():
            try:
                self._answers.put(next(self._call, None))
            except Exception as error:
                self._answers.put(error)
