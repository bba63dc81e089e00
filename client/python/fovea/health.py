"""The standard health protocol, grpc.health.v1."""

from __future__ import annotations

from collections.abc import Iterable

import grpc
from google.protobuf.wrappers_pb2 import Int32Value, StringValue

# HealthCheckRequest is a string with tag 1, HealthCheckResponse an enumeration with tag 1: the
# same bytes as these well-known types. Another copy of health.proto in this process, such as that
# of grpcio-health-checking, would clash with one of ours.
_REQUEST = StringValue(value="fovea.v1.DetectionService")
_CODEC = {
    "request_serializer": StringValue.SerializeToString,
    "response_deserializer": Int32Value.FromString,
}
_SERVING = 1


class Health:
    def __init__(self, channel: grpc.Channel, metadata: list[tuple[str, str]]) -> None:
        self._check = channel.unary_unary("/grpc.health.v1.Health/Check", **_CODEC)
        self._watch = channel.unary_stream("/grpc.health.v1.Health/Watch", **_CODEC)
        self._metadata = metadata

    def is_serving(self, timeout: float) -> bool:
        """Asks once. Raises grpc.RpcError where no server answers."""
        answer = self._check(_REQUEST, timeout=timeout, metadata=self._metadata)
        return bool(answer.value == _SERVING)

    def watch(self, timeout: float) -> Iterable[bool]:
        """Whether it serves, now and after each change; waits for a server that is not up yet.

        Raises grpc.RpcError after `timeout` seconds.
        """
        call = self._watch(_REQUEST, timeout=timeout, metadata=self._metadata, wait_for_ready=True)
        try:
            for answer in call:
                yield answer.value == _SERVING
        finally:
            call.cancel()
