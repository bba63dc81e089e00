"""Answers of a server that cannot be read."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from typing import Any

import grpc
import numpy as np
import pytest
from server_process import PATIENCE

import fovea


class Nonsense(grpc.GenericRpcHandler):  # type: ignore[misc]
    """Answers the first frame of a stream with what is no message, and leaves the call open."""

    def __init__(self) -> None:
        self.ended = threading.Event()

    def service(self, _: Any) -> Any:
        return grpc.stream_stream_rpc_method_handler(self._answer)

    def _answer(self, requests: Iterator[bytes], context: grpc.ServicerContext) -> Iterator[bytes]:
        context.add_callback(self.ended.set)
        next(requests)
        yield b"\xff\xff"
        self.ended.wait()


@contextmanager
def server_of(handler: Nonsense) -> Iterator[str]:
    """Its address."""
    server = grpc.server(ThreadPoolExecutor(1))
    server.add_generic_rpc_handlers((handler,))
    address = f"127.0.0.1:{server.add_insecure_port('127.0.0.1:0')}"
    server.start()
    yield address
    server.stop(None).wait()


def test_an_answer_that_cannot_be_read_ends_its_stream() -> None:
    pixels = np.zeros((4, 4, 3), np.uint8)
    frame = fovea.Frame(pixels, np.ones((4, 4), np.uint16), fovea.CameraIntrinsics(4, 4, 1, 1))
    handler = Nonsense()
    with server_of(handler) as address, fovea.Client(address, timeout=PATIENCE) as client:
        with pytest.raises(fovea.FoveaError) as caught:
            list(client.stream([frame]))
        assert str(caught.value) == (
            "INTERNAL: the server sent a DetectStreamResponse that cannot be read"
        )
        assert handler.ended.wait(PATIENCE)
