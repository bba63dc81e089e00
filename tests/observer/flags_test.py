"""Mistakes on the command line: each is named with its flag and its value, and nothing is served."""

from __future__ import annotations

import os
import socket
import subprocess
from pathlib import Path

import pytest
from processes import PATIENCE, self_signed


def error_of(*flags: str) -> str:
    command = [os.environ["FOVEA_OBSERVER"], *flags]
    finished = subprocess.run(command, capture_output=True, text=True, timeout=PATIENCE)
    assert finished.returncode != 0 and finished.stdout == ""
    return finished.stderr


@pytest.mark.parametrize("flag", ["--history-minutes", "--history-rate"])
@pytest.mark.parametrize("value", ["nan", "-nan", "inf", "-inf", "1e999", "0", "9999", "two"])
def test_numbers_are_finite_and_in_their_range(flag: str, value: str) -> None:
    # Nothing is served where they are taken, either: the port is none.
    error = error_of("--listen", "127.0.0.1:none", f"{flag}={value}")
    assert f'{flag}: "{value}" is not a number from ' in error


@pytest.mark.parametrize(
    "listen", ["127.0.0.1:99999", "127.0.0.1:65536", "127.0.0.1", "127.0.0.1:", "127.0.0.1:x", ":1"]
)
def test_addresses_have_a_port_that_there_can_be(listen: str) -> None:
    error = error_of("--listen", listen)
    assert error.startswith(f'fovea-observer: --listen: "{listen}" is not HOST:PORT with a port')


def test_where_nothing_can_be_listened_on_is_named() -> None:
    with socket.create_server(("127.0.0.1", 0)) as used:
        address = f"127.0.0.1:{used.getsockname()[1]}"
        start = f"fovea-observer: --listen: cannot listen on {address}: "
        assert error_of("--listen", address) == f"{start}Address already in use\n"
    foreign = "192.0.2.1:0"  # of documentation (RFC 5737)
    error = error_of("--listen", foreign, "--insecure")
    assert error.startswith(f"fovea-observer: --listen: cannot listen on {foreign}: ")


def test_files_of_tls_are_named(tmp_path: Path) -> None:
    def error_with(certificate: str, key: str) -> str:
        flags = ["--https-cert", certificate, "--https-key", key]
        return error_of("--listen", "127.0.0.1:0", *flags).removeprefix("fovea-observer: ")

    certificate, key = self_signed(tmp_path, "own")
    text, nowhere = tmp_path / "text", str(tmp_path / "nowhere")
    text.write_text("no PEM")
    no_chain = f"--https-cert: {text} holds no certificate chain in PEM\n"
    assert error_with(str(text), key) == no_chain
    for other in (str(text), self_signed(tmp_path, "other")[1], certificate):
        no_key = f"--https-key: {other} does not hold the key, in PEM, of {certificate}\n"
        assert error_with(certificate, other) == no_key
    assert error_with(nowhere, key).startswith(f"--https-cert: cannot read {nowhere}")
    assert error_with(certificate, nowhere).startswith(f"--https-key: cannot read {nowhere}")
    os.mkfifo(pipe := str(tmp_path / "pipe"))
    assert error_with(pipe, key) == f"--https-cert: {pipe} is no file that can be read again\n"
