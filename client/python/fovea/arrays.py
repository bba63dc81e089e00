"""Arrays of an answer from the bytes of its messages."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt


def array_of(data: bytes, dtype: npt.DTypeLike, *shape: int) -> npt.NDArray[Any]:
    """A copy: the bytes of a message must not be written to, the arrays of an answer may be."""
    return np.frombuffer(data, dtype=dtype).reshape(shape).copy()
