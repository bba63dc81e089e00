"""Mistakes on the command line: each is named with its flag and its value, and nothing is served."""

from __future__ import annotations

import os
import subprocess

import pytest
from processes import PATIENCE


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
