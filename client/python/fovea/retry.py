"""Calls that are made again where that is safe and promises something."""

from __future__ import annotations

import random
import time
from collections.abc import Callable
from typing import TypeVar

from fovea.errors import Cancelled, FoveaError, Overloaded, Unavailable
from fovea.options import RetryOptions

Answer = TypeVar("Answer")


def is_worth_retrying(error: FoveaError) -> bool:
    """Detection changes nothing on the server: what matters is only what it would bring."""
    # Cancelled is not by us, but by a server that stops.
    return isinstance(error, (Unavailable, Cancelled, Overloaded))


def backoff_after(attempt: int, options: RetryOptions, error: FoveaError) -> float:
    """Seconds to wait before attempt `attempt` + 1 (the first is 1)."""
    wait = min(options.backoff * 2.0 ** min(attempt - 1, 16), options.max_backoff)
    wait *= random.uniform(0.5, 1)
    return max(wait, error.retry_after) if isinstance(error, Overloaded) else wait


def call_with_retries(
    call: Callable[[float], Answer],
    timeout: float,
    options: RetryOptions,
    wait: Callable[[float], None],
) -> Answer:
    """Makes call(seconds left), again if need be and while `timeout` allows.

    wait(seconds) waits before the next attempt, or raises where there is to be none. Raises the
    error of the last attempt where none succeeds.
    """
    deadline = time.monotonic() + timeout
    attempt = 1
    while True:
        try:
            return call(deadline - time.monotonic())
        except FoveaError as error:
            seconds = backoff_after(attempt, options, error)
            is_last = attempt >= options.max_attempts or time.monotonic() + seconds >= deadline
            if is_last or not is_worth_retrying(error):
                raise
        wait(seconds)
        attempt += 1
