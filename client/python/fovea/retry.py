"""Calls that are made again where that is safe and promises something."""

from __future__ import annotations

import random
import time
from collections.abc import Callable
from typing import TypeVar

from fovea.errors import Cancelled, DeadlineExceeded, FoveaError, Overloaded, Unavailable
from fovea.options import RetryOptions
from fovea.servers import Round, Server, Servers

Answer = TypeVar("Answer")


def is_worth_retrying(error: FoveaError) -> bool:
    """Detection changes nothing on the server: what matters is only what it would bring."""
    # Cancelled is not by us, but by a server that stops.
    return isinstance(error, (Unavailable, Cancelled, Overloaded))


def backoff_after(attempt: int, options: RetryOptions, retry_after: float | None) -> float:
    """Seconds to wait before attempt `attempt` + 1 (the first is 1): as long as the server says,
    since it keeps a place in line that long, else by the options."""
    if retry_after:
        return retry_after
    wait = min(options.backoff * 2.0 ** min(attempt - 1, 16), options.max_backoff)
    return wait * random.uniform(0.5, 1)


def call_with_retries(
    servers: Servers,
    call: Callable[[Server, float, bool], Answer],
    timeout: float,
    options: RetryOptions,
    wait: Callable[[Server | None, float], None],
) -> Answer:
    """Makes call(server, seconds left, whether to keep no place in line): around the servers until one
    answers, and again if need be and while `timeout` allows. A way around is one attempt; those after
    which a server says when to come back are not counted.

    wait(server, seconds) waits before the next attempt, or raises where there is to be none. Raises
    the error of the last attempt where none succeeds; of refusals the one of the server that it
    would have waited for.
    """
    deadline = time.monotonic() + timeout
    attempt = 1
    while True:
        way: Round | None = None
        try:
            way = servers.round(attempt == 1, deadline - time.monotonic())
            return _go_around(way, call, deadline)
        except FoveaError as error:
            seconds = backoff_after(attempt, options, way.wait if way else None)
            # Who is told when to come back has no end but the deadline.
            is_told = way is not None and way.wait is not None and options.max_attempts > 1
            is_last = attempt >= options.max_attempts and not is_told
            is_too_late = time.monotonic() + seconds >= deadline
            if is_last or is_too_late or not is_worth_retrying(error):
                raise
        wait(way.home if way else None, seconds)
        attempt += 1


def _go_around(
    way: Round, call: Callable[[Server, float, bool], Answer], deadline: float
) -> Answer:
    failure: FoveaError = Unavailable("UNAVAILABLE", "there is no server")
    for server, only_if_room in way.asks():
        try:
            answer = call(server, deadline - time.monotonic(), only_if_room)
            way.on_answered()
            return answer
        except Overloaded as error:
            way.on_refused(error.retry_after)
            failure = error
        except FoveaError as error:
            if is_worth_retrying(error) or isinstance(error, DeadlineExceeded):
                way.on_away()  # the next call is made to another one
            if not is_worth_retrying(error):
                raise
            failure = error
    raise failure  # the last one's is of whom the client waits for
