"""Looks now and then whether a stream would get more answers at another server. The same as
client/better_server.h."""

from __future__ import annotations

import random
import time
from collections import defaultdict
from collections.abc import Callable

from fovea.errors import FoveaError
from fovea.server_info import Statistics
from fovea.server_load import ServerLoad
from fovea.servers import Server

_SHORTEST, _LONGEST = 3.0, 7.0  # seconds between two looks
_TIMEOUT = 0.2
# What servers say is of some moments: a move has to be worth it.
_MUCH_SOONER = 0.85
# However many there are.
_MAX_OTHERS = 3


class BetterServer:
    def __init__(
        self,
        servers: Callable[[], list[Server]],
        get_statistics: Callable[[Server, float], Statistics],
    ) -> None:
        """get_statistics(server, timeout)."""
        self._servers = servers
        self._get_statistics = get_statistics
        self._loads: defaultdict[str, ServerLoad] = defaultdict(ServerLoad)
        self._plan_next()

    def find(self, own: Server) -> Server | None:
        """A server where a stream at `own` would be answered much more often. None where there is
        none that is known, and most times, since servers are asked every few seconds only. That
        takes some milliseconds, 0.2 s for each that does not answer."""
        if time.monotonic() < self._next:
            return None
        self._plan_next()
        others = [server for server in self._servers() if server is not own]
        if not others or not self._ask(own) or not self._loads[own.name].num_waiting:
            return None
        best: Server | None = None
        least = (self._loads[own.name].turn(more=0) or 0.0) * _MUCH_SOONER
        for other in random.sample(others, min(len(others), _MAX_OTHERS)):
            turn = self._loads[other.name].turn(more=1) if self._ask(other) else None
            if turn is not None and turn < least:
                best, least = other, turn
        return best

    def _plan_next(self) -> None:
        """By chance, so that not all streams of a server leave it at once."""
        self._next = time.monotonic() + random.uniform(_SHORTEST, _LONGEST)

    def _ask(self, server: Server) -> bool:
        try:
            self._loads[server.name].note(self._get_statistics(server, _TIMEOUT))
        except FoveaError:
            return False
        return True
