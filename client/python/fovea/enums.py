"""Names of the contract's numbers."""

from __future__ import annotations

import re


def name_of(enum: type, number: int) -> str:
    """ "estimated" for GRAVITY_SOURCE_ESTIMATED; the number where a newer server sends more."""
    for name, value in enum.items():  # type: ignore[attr-defined]
        if value == number:
            return re.split("_SOURCE_|_REMOVAL_|_REASON_|_KIND_|_NAME_", str(name), maxsplit=1)[
                1
            ].lower()
    return str(number)
