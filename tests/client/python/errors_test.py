"""What errors say of themselves, and what is read out of a server's."""

from __future__ import annotations

import pickle

import fovea
from fovea.errors import error_of
from fovea.status_details import field_of_details


def test_errors_without_a_field_have_none() -> None:
    for message in ("the message is not a DetectStreamRequest", "", "some words: and more"):
        error = error_of(3, message)
        assert isinstance(error, fovea.InvalidArgument)
        assert (error.field, error.message) == ("", message)


def test_errors_travel_between_processes() -> None:
    for error in (
        fovea.InvalidArgument("frame.depth", "is empty"),
        fovea.Overloaded("full", retry_after=0.5),
        fovea.MissingPackage("png", "python3-pil"),
        fovea.VersionMismatch("1.0.0", "2.0.0"),
    ):
        copy = pickle.loads(pickle.dumps(error))
        assert type(copy) is type(error)
        assert str(copy) == str(error)
        assert vars(copy) == vars(error)


def test_unknown_codes_are_errors_too() -> None:
    assert error_of(13, "oh").code == "INTERNAL"
    assert error_of(99, "oh").code == "UNKNOWN"


def _part(number: int, content: bytes) -> bytes:
    """A field of a message, as protobuf writes it."""
    return bytes([number << 3 | 2, len(content)]) + content


def test_details_name_the_field() -> None:
    violation = _part(1, b"frame.depth") + _part(2, b"is missing")
    bad_request = _part(1, b"type.googleapis.com/google.rpc.BadRequest") + _part(
        2, _part(1, violation)
    )
    other = _part(1, b"type.googleapis.com/google.rpc.RetryInfo") + _part(2, b"")
    status = b"\x08\x03" + _part(2, b"text") + _part(3, other) + _part(3, bad_request)
    assert field_of_details(status) == "frame.depth"
    assert field_of_details(_part(3, other)) == ""
    for broken in (b"", b"\xff", b"\x1a", b"\x1b", status[:-40]):
        assert field_of_details(broken) == ""


def test_fields_of_servers_that_send_details_and_of_older_ones() -> None:
    for field in ("frame.depth", ""):
        error = error_of(3, "frame.depth: is missing", field)
        assert isinstance(error, fovea.InvalidArgument)
        assert (error.field, error.message) == ("frame.depth", "frame.depth: is missing")
    odd = error_of(3, "options.parameters[a]b]: no", "options.parameters[a]b]")
    assert isinstance(odd, fovea.InvalidArgument)
    assert odd.field == "options.parameters[a]b]"
    for field in ("options.grasps.grippers[0].name", ""):
        indexed = error_of(3, "options.grasps.grippers[0].name: is too long", field)
        assert isinstance(indexed, fovea.InvalidArgument)
        assert indexed.field == "options.grasps.grippers[0].name"
    assert error_of(8, "full", retry_after=0.5).args == error_of(8, "full").args
    assert isinstance(error_of(8, "full", retry_after=0.5), fovea.Overloaded)
