"""The connection, and what every call carries."""

from __future__ import annotations

import grpc

from fovea.errors import InvalidArgument
from fovea.options import TlsOptions


def make_channel(address: str, tls: TlsOptions | None, max_answer_mib: int) -> grpc.Channel:
    options = [
        ("grpc.max_receive_message_length", max_answer_mib << 20),
        ("grpc.lb_policy_name", "round_robin"),
        # Else all clients of a process share one connection, where a small call waits for the
        # large frames of the others.
        ("grpc.use_local_subchannel_pool", 1),
        # A server that is back is found soon, one that is gone without a word is noticed.
        ("grpc.initial_reconnect_backoff_ms", 100),
        # Also the time that one attempt has, TLS included.
        ("grpc.min_reconnect_backoff_ms", 5_000),
        ("grpc.max_reconnect_backoff_ms", 2_000),
        ("grpc.keepalive_time_ms", 20_000),
        ("grpc.keepalive_timeout_ms", 5_000),
    ]
    if tls is None:
        return grpc.insecure_channel(address, options)
    credentials = grpc.ssl_channel_credentials(
        tls.root_certificates or None, tls.private_key or None, tls.certificate_chain or None
    )
    return grpc.secure_channel(address, credentials, options)


def make_metadata(token: str, robot: str) -> list[tuple[str, str]]:
    """Raises InvalidArgument for what cannot travel in a header."""
    metadata = []
    if token:
        metadata.append(("authorization", "Bearer " + _printable("metadata authorization", token)))
    if robot:
        metadata.append(("fovea-robot", _printable("metadata fovea-robot", robot)))
    return metadata


def _printable(field: str, text: str) -> str:
    if not (text.isascii() and text.isprintable()):
        raise InvalidArgument(field, "must be printable ASCII characters")
    return text
