"""The connection, and what every call carries."""

from __future__ import annotations

import atexit
import weakref
from typing import Any

import grpc

from fovea.addresses import Target
from fovea.errors import InvalidArgument
from fovea.options import TlsOptions

_PEM = {
    "root_certificates": b"CERTIFICATE",
    "certificate_chain": b"CERTIFICATE",
    "private_key": b"PRIVATE KEY",
}
_LONGEST_ID = 64
_open: weakref.WeakSet[grpc.Channel] = weakref.WeakSet()


def make_channel(
    target: Target, has_others: bool, tls: TlsOptions | None, max_answer_mib: int
) -> grpc.Channel:
    """To one server; has_others: of several, so that little time is spent on one that is away."""
    options: list[tuple[str, int | str]] = [
        ("grpc.max_receive_message_length", max_answer_mib << 20),
        # Else all clients of a process share one connection, where a small call waits for the
        # large frames of the others.
        ("grpc.use_local_subchannel_pool", 1),
        # Else http_proxy takes frames, those for this machine too, to a proxy for web pages.
        ("grpc.enable_http_proxy", 0),
        # A server that is back is found soon, one that is gone without a word is noticed.
        ("grpc.initial_reconnect_backoff_ms", 100),
        # Also the time that one attempt has, TLS included.
        ("grpc.min_reconnect_backoff_ms", 2_000 if has_others else 5_000),
        ("grpc.max_reconnect_backoff_ms", 2_000),
        ("grpc.keepalive_time_ms", 20_000),
        ("grpc.keepalive_timeout_ms", 5_000),
    ]
    if target.authority:
        options.append(("grpc.default_authority", target.authority))
    channel = _connect(target.target, tls, options)
    _open.add(channel)
    return channel


@atexit.register
def _close_all() -> None:
    """While threads still run: what ends a channel later waits for its threads for ever."""
    for channel in list(_open):
        channel.close()


def _connect(
    target: str, tls: TlsOptions | None, options: list[tuple[str, int | str]]
) -> grpc.Channel:
    if tls is None:
        return grpc.insecure_channel(target, options)
    credentials = grpc.ssl_channel_credentials(
        tls.root_certificates or None, tls.private_key or None, tls.certificate_chain or None
    )
    return grpc.secure_channel(target, credentials, options)


def check_tls(tls: Any) -> None:
    """gRPC ends the program where one of a pair is missing, and takes any text, to fail at each call
    without a word about it. Raises InvalidArgument."""
    if tls is None:
        return
    if not isinstance(tls, TlsOptions):
        raise InvalidArgument("tls", f"is {type(tls).__name__}, not fovea.TlsOptions")
    for name in _PEM:
        if not isinstance(getattr(tls, name), bytes):
            raise InvalidArgument(f"tls.{name}", "is not bytes: the text of a PEM file is")
    for name, other in (
        ("private_key", "certificate_chain"),
        ("certificate_chain", "private_key"),
    ):
        if getattr(tls, other) and not getattr(tls, name):
            raise InvalidArgument(f"tls.{name}", f"is missing; it goes together with {other}")
    for name, kind in _PEM.items():
        text = getattr(tls, name)
        if text and kind + b"-----" not in text:
            problem = f"holds no {kind.decode()} in PEM; it takes the text of a file, not its path"
            raise InvalidArgument(f"tls.{name}", problem)


def make_metadata(token: str, robot: str) -> list[tuple[str, str]]:
    """Raises InvalidArgument for what cannot travel in a header."""
    metadata = []
    if token:
        metadata.append(("authorization", "Bearer " + _token(token)))
    if robot:
        metadata.append(("fovea-robot", _printable("metadata fovea-robot", robot)))
    return metadata


def _token(token: Any) -> str:
    field = "metadata authorization"
    if isinstance(token, str) and token.endswith(("\n", "\r")):
        problem = (
            "the token ends in a line break, as the text of a file does: token.strip() has none"
        )
        raise InvalidArgument(field, problem)
    return _printable(field, token, "the token ")


def metadata_of_call(request_id: str, traceparent: str) -> list[tuple[str, str]]:
    """Raises InvalidArgument for what cannot travel in a header, and for ids that the server would
    refuse: its log would not have them, and errors would say that it has."""
    if isinstance(request_id, str) and len(request_id) > _LONGEST_ID:
        problem = f"request_id has {len(request_id)} characters, more than {_LONGEST_ID}"
        raise InvalidArgument("metadata fovea-request-id", problem)
    given = {"fovea-request-id": request_id, "traceparent": traceparent}
    return [(key, _printable(f"metadata {key}", text)) for key, text in given.items() if text]


def _printable(field: str, text: Any, name: str = "") -> str:
    """name: what the message begins with, where the field does not say what that is."""
    if not isinstance(text, str):
        raise InvalidArgument(field, f"{name}is {type(text).__name__}, not a str")
    if not (text.isascii() and text.isprintable()):
        raise InvalidArgument(field, f"{name}must be printable ASCII characters")
    return text
