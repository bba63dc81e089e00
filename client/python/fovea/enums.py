"""Names of the contract's numbers."""

from __future__ import annotations

from typing import Any


def name_of(enum: Any, number: int) -> str:
    """ "estimated" for GRAVITY_SOURCE_ESTIMATED; the number where a newer server sends more."""
    names = {value: str(name) for name, value in enum.items()}
    prefix = names[0].removesuffix("UNSPECIFIED")
    return names[number].removeprefix(prefix).lower() if number in names else str(number)
