"""Numbers and texts that callers give, checked before anything is sent. Errors name the field."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from fovea.errors import DeadlineExceeded, InvalidArgument

_LONGEST = 1e9  # seconds; gRPC takes times far beyond for such as have passed
_REAL = (int, float, np.integer, np.floating)


def shown(value: Any) -> str:
    """Python refuses to write integers of thousands of digits, and nobody reads them."""
    if isinstance(value, int) and value.bit_length() > 128:
        return f"an integer of {value.bit_length()} bits"
    return repr(value)


def real(value: Any, field: str) -> float:
    if not _is_finite(value):
        raise InvalidArgument(field, f"{shown(value)} is not a finite number")
    return float(value)


def positive(value: Any, field: str, name: str) -> float:
    """Above 0, which on the wire stands for what was not given. name: of the argument, which the
    contract may call otherwise."""
    if not (_is_finite(value) and value > 0):
        raise InvalidArgument(field, f"{name}={shown(value)} is not a finite number above 0")
    return float(value)


def _is_finite(value: Any) -> bool:
    """True and False are integers to Python, and no numbers to who gives a length."""
    try:
        is_number = isinstance(value, _REAL) and not isinstance(value, bool)
        return is_number and math.isfinite(value)
    except OverflowError:  # an integer beyond what a float holds
        return False


def whole(value: Any, field: str, most: int = 2**32 - 1, least: int = 1) -> int:
    """Unless told up to what 32 bits hold."""
    if not (isinstance(value, (int, np.integer)) and least <= value <= most):
        problem = f"{shown(value)} is not a whole number from {least} to {most}"
        raise InvalidArgument(field, problem)
    return int(value)


def flag(value: Any, field: str) -> bool:
    if not isinstance(value, (int, np.bool_, np.integer)):  # 0 and 1 are usual
        raise InvalidArgument(field, f"{shown(value)} is not True or False")
    return bool(value)


def text(value: Any, field: str) -> str:
    """What a message can hold."""
    if not isinstance(value, str):
        raise InvalidArgument(field, f"{value!r} is not a str")
    try:
        value.encode()
    except UnicodeEncodeError:
        raise InvalidArgument(field, f"{value!r} is not Unicode text") from None
    return value


def timeout_of_client(timeout: Any) -> float:
    if not (isinstance(timeout, _REAL) and 0 < timeout < math.inf):
        raise InvalidArgument("timeout", f"{shown(timeout)} is not a number of seconds above 0")
    return float(min(timeout, _LONGEST))


def timeout_of_call(timeout: Any) -> float:
    """What is left of somebody's time may well be nothing, which is no mistake of the caller's:
    DeadlineExceeded."""
    if isinstance(timeout, _REAL) and timeout <= 0:
        problem = f"timeout={shown(timeout)}: no time is left for the call"
        raise DeadlineExceeded("DEADLINE_EXCEEDED", problem)
    return timeout_of_client(timeout)
