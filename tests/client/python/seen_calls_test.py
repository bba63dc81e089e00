"""What a server sees of calls: their connections and deadlines."""

from __future__ import annotations

from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from typing import Any

import grpc
import pytest
from server_process import PATIENCE

import fovea
from fovea.health import Health
from fovea.v1 import detection_service_pb2, detection_service_pb2_grpc


class Reception(detection_service_pb2_grpc.DetectionServiceServicer):  # type: ignore[misc]
    """Tells the connections of its callers apart."""

    def __init__(self) -> None:
        self.peers: set[str] = set()
        self.time_left: float = 0  # of the last call

    def GetServerInfo(self, _: Any, context: grpc.ServicerContext) -> Any:
        self.peers.add(context.peer())
        self.time_left = context.time_remaining()
        return detection_service_pb2.GetServerInfoResponse()


@contextmanager
def server_with(reception: Reception) -> Iterator[str]:
    """Its address."""
    server = grpc.server(ThreadPoolExecutor(1))
    detection_service_pb2_grpc.add_DetectionServiceServicer_to_server(reception, server)
    address = f"127.0.0.1:{server.add_insecure_port('127.0.0.1:0')}"
    server.start()
    yield address
    server.stop(None).wait()


def test_every_client_has_a_connection_of_its_own() -> None:
    reception = Reception()
    with server_with(reception) as address:
        with fovea.Client(address, timeout=PATIENCE) as one, fovea.Client(address) as other:
            for client in (one, other, one, other):
                client.get_server_info()
    assert len(reception.peers) == 2


def test_all_of_a_check_has_its_timeout(monkeypatch: pytest.MonkeyPatch) -> None:
    """What is left of it is for the second call."""
    monkeypatch.setattr(Health, "is_serving", lambda *_: True)
    reception = Reception()
    with server_with(reception) as address:
        with fovea.Client(address, timeout=100 * PATIENCE) as client:
            with pytest.raises(fovea.VersionMismatch):
                client.check(timeout=PATIENCE)
    assert 0 < reception.time_left < 2 * PATIENCE  # which gRPC rounds up
