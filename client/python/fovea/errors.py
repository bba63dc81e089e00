"""What goes wrong, as exceptions. All are FoveaError."""

from __future__ import annotations

import re
from typing import Any

import grpc

from fovea.status_details import field_of_details

# The path in front of the server's message: "frame.depth.data", "options.parameters[no.such]",
# "options.grasps.grippers[0].name", "frame.color.width, height" or "metadata fovea-robot".
_FIELD = re.compile(
    r"((?:metadata )?[\w.-]+(?:\[.*?\](?:\.[\w.]+)?)?(?:, [\w.]+)*): (.*)", re.DOTALL
)

_TOO_LARGE = re.compile(r"larger than max \((\d+) vs\. (\d+)\)")


class FoveaError(Exception):
    """A call that did not succeed; str() is "CODE: message", of calls "CODE: message (request ID)".

    code: name of the gRPC status code, for example "UNAVAILABLE".
    message: without the code and the request's id.
    request_id: what the log of the server calls the request, if it came there; "" where the server
        says nothing and the caller gave none.
    """

    request_id = ""

    def __init__(self, code: str, message: str) -> None:
        super().__init__(f"{code}: {message}")
        self.code = code
        self.message = message

    def __str__(self) -> str:
        text = super().__str__()
        return f"{text} (request {self.request_id})" if self.request_id else text

    def __reduce__(self) -> tuple[Any, ...]:
        """For pickle, since the constructors differ."""
        return _restored, (type(self), self.args, self.__dict__)


def _restored(kind: type[FoveaError], args: tuple[Any, ...], state: dict[str, Any]) -> FoveaError:
    error = kind.__new__(kind, *args)
    error.__dict__.update(state)
    return error


class InvalidArgument(FoveaError, ValueError):
    """The request cannot be answered as it is, and never will be.

    field: path of what is wrong in the contract, for example "frame.depth.data"; "" if unknown.
    """

    def __init__(self, field: str, problem: str) -> None:
        super().__init__("INVALID_ARGUMENT", f"{field}: {problem}" if field else problem)
        self.field = field


class MissingPackage(FoveaError, ImportError):
    """An encoding needs a Python package that is not installed.

    package: name of the Debian package that has it.
    """

    def __init__(self, encoding: str, package: str) -> None:
        super().__init__(
            "FAILED_PRECONDITION", f'the encoding "{encoding}" needs the Debian package {package}'
        )
        self.package = package


class VersionMismatch(FoveaError):
    """The server speaks another version of the contract."""

    def __init__(self, server: str, client: str) -> None:
        super().__init__(
            "FAILED_PRECONDITION", f"the server has version {server}, this library is {client}"
        )


class Unauthenticated(FoveaError):
    """The token is missing, unknown or has expired."""


class Unavailable(FoveaError):
    """No server answers there, or it is stopping."""

    # 0: a server that had the stream for long enough asks for another one, wherever.
    retry_after: float | None = None


class DeadlineExceeded(FoveaError, TimeoutError):
    """No answer in time."""


class Cancelled(FoveaError):
    """The call was ended, for example because the client was closed."""


class ResourceExhausted(FoveaError):
    """Larger than the server or this client takes, or more to compute than the server gives one."""


class Overloaded(ResourceExhausted):
    """The server has too much to do. retry_after: seconds after which it asks to come back."""

    def __init__(self, message: str, retry_after: float) -> None:
        super().__init__("RESOURCE_EXHAUSTED", message)
        self.retry_after = retry_after


_CLASSES = {
    "CANCELLED": Cancelled,
    "DEADLINE_EXCEEDED": DeadlineExceeded,
    "RESOURCE_EXHAUSTED": ResourceExhausted,
    "UNAVAILABLE": Unavailable,
    "UNAUTHENTICATED": Unauthenticated,
}
_NAMES = {code.value[0]: code.name for code in grpc.StatusCode}


def error_of(
    code: int, message: str, field: str = "", retry_after: float | None = None
) -> FoveaError:
    """The exception for a status code by its number, as FrameError has it.

    field: what the server says that it is about; older ones say it in the message only.
    retry_after: seconds.
    """
    name = _NAMES.get(code, "UNKNOWN")
    if name == "RESOURCE_EXHAUSTED" and retry_after is not None:
        return Overloaded(message, retry_after)
    if name != "INVALID_ARGUMENT":
        return _CLASSES.get(name, FoveaError)(name, message)
    found = _FIELD.fullmatch(message)
    if found and found[1].startswith(field):  # "frame.color.width, height" says more
        return InvalidArgument(found[1], found[2])
    return InvalidArgument(field, message.removeprefix(f"{field}: "))


def _without_grpc(details: str, max_answer_bytes: int) -> str:
    """What gRPC says of a message that is too large names neither which nor what helps."""
    found = _TOO_LARGE.search(details)
    if not found:
        return details
    size, most = (f"{int(number) / (1 << 20):.1f} MiB" for number in found.groups())
    if int(found[2]) == max_answer_bytes:
        return f"the answer is {size}, this client takes {most} (max_answer_mib)"
    return (
        f"the frame is {size}, the server takes {most} (--max-message-mib): send a smaller image, "
        "or png, jpeg or zstd"
    )


def error_of_call(call: grpc.RpcError, max_answer_bytes: int) -> FoveaError:
    """The exception for a call of gRPC that failed.

    max_answer_bytes: the largest message that this client takes.
    """
    field, retry_after, request_id = "", None, ""
    for key, value in call.trailing_metadata() or ():
        if key == "retry-after-ms" and value.isdecimal():
            retry_after = int(value) / 1000
        if key == "grpc-status-details-bin":
            field = field_of_details(value)
        if key == "fovea-request-id":
            request_id = value
    details = _without_grpc(call.details() or "", max_answer_bytes)
    error = error_of(call.code().value[0], details, field, retry_after)
    error.request_id = request_id
    if isinstance(error, Unavailable):
        error.retry_after = retry_after
    return error


def error_retry_after(error: FoveaError) -> float | None:
    """Seconds after which the server asks to come back, where it does."""
    return error.retry_after if isinstance(error, (Overloaded, Unavailable)) else None
