"""Which of several servers a client asks. Knows no network and no clock.

A client stays with one server, its home, since it has a place in line there. When that refuses, the
others are asked once whether they have room at once; the home changes where another one takes its
calls twice in a row, or promises to be free much sooner. Servers that are away are left alone for a
while that doubles. Without a home, one is chosen by chance. The same as client/server_choice.h.
"""

from __future__ import annotations

import random
from collections.abc import Iterable
from dataclasses import dataclass

_FIRST_AWAY, _LONGEST_AWAY = 0.1, 5.0
# A move costs a place in line: it has to be worth it, and what servers say is a guess.
_MUCH_SOONER = 0.8
_ANSWERS_TO_MOVE = 2
# The most that one refusal makes others do, however many there are.
_MAX_OTHERS = 3


@dataclass
class _State:
    away_until: float = float("-inf")
    failures: int = 0


@dataclass(frozen=True)
class Ask:
    server: str
    in_line_elsewhere: bool = False  # the home has a place for this client


class ServerChoice:
    """Not thread-safe. Times are in seconds."""

    def __init__(self, seed: int | None = None) -> None:
        self._random = random.Random(seed)
        self._servers: dict[str, _State] = {}
        self._home = ""
        self._num_elsewhere = 0  # answers in a row that did not come from home

    def set_servers(self, names: Iterable[str]) -> None:
        """Where these are others than before, the home is chosen anew."""
        servers = {name: self._servers.get(name, _State()) for name in names}
        if servers.keys() != self._servers.keys():
            self._home = ""
        self._servers = servers

    def home(self, now: float) -> str:
        """Chosen where there is none or it is away; whoever is back soonest where all are."""
        if self.are_all_away(now):
            self._home = min(self._servers, key=lambda name: self._servers[name].away_until)
        elif not self._home or self.is_away(self._home, now):
            self._home = self.another(set(), now, only_there=True)
            self._num_elsewhere = 0
        return self._home

    def move(self, name: str) -> None:
        self._home = name

    def on_away(self, name: str, now: float, duration: float | None = None) -> None:
        """For `duration`, or a tenth of a second that doubles up to five seconds."""
        if state := self._servers.get(name):
            doubled = min(_FIRST_AWAY * 2.0 ** min(state.failures, 10), _LONGEST_AWAY)
            state.failures += 1
            state.away_until = now + (doubled if duration is None else duration)

    def on_disconnected(self, name: str) -> None:
        """Its connection ended, for whatever reason: it may be chosen again, like any other."""
        if self._home == name:
            self._home = ""

    def on_answered(self, name: str) -> None:
        if name in self._servers:
            self._servers[name] = _State()
        self._num_elsewhere = 0 if name == self._home else self._num_elsewhere + 1
        if self._num_elsewhere >= _ANSWERS_TO_MOVE:
            self._home, self._num_elsewhere = name, 0

    def is_away(self, name: str, now: float) -> bool:
        state = self._servers.get(name)
        return state is None or state.away_until > now

    def are_all_away(self, now: float) -> bool:
        return all(state.away_until > now for state in self._servers.values())

    def another(self, but: set[str], now: float, *, only_there: bool) -> str:
        """At random; rather one that is not away. "" where there is none."""
        rest = [name for name in self._servers if name not in but]
        there = [name for name in rest if not self.is_away(name, now)]
        names = there if there or only_there else rest
        return self._random.choice(names) if names else ""


class ServerRound:
    """One call's way around the servers: each is asked once at most, but a server that the home is
    moved to once more."""

    def __init__(self, choice: ServerChoice, asks_others: bool) -> None:
        """asks_others: where the home refuses."""
        self.wait: float | None = None  # when the home says to come back
        self._choice = choice
        self._others_left = _MAX_OTHERS if asks_others else 0
        self._last: Ask | None = None
        self._asked: set[str] = set()
        self._least: tuple[float, str] | None = None  # of the others
        self._has_moved = False

    def next(self, now: float) -> Ask | None:
        """Whom to ask next; None once nobody is left that promises anything. Then one of the
        following is to be called."""
        self._last = self._next(now)
        if self._last:
            self._asked.add(self._last.server)
        return self._last

    def on_answered(self) -> None:
        assert self._last
        self._choice.on_answered(self._last.server)

    def on_refused(self, retry_after: float) -> None:
        assert self._last
        if not self._last.in_line_elsewhere:
            self.wait = retry_after
        elif self._least is None or retry_after < self._least[0]:
            self._least = retry_after, self._last.server

    def on_away(self, now: float) -> None:
        assert self._last
        self._choice.on_away(self._last.server, now)

    def _next(self, now: float) -> Ask | None:
        if not self._asked:
            return Ask(self._choice.home(now))
        if self._has_moved:
            return None
        if self.wait is None:  # the home is away
            name = self._choice.another(self._asked, now, only_there=False)
            if name:
                self._choice.move(name)
            return Ask(name) if name else None
        if self._others_left:
            self._others_left -= 1
            name = self._choice.another(self._asked, now, only_there=True)
            if name:
                return Ask(name, in_line_elsewhere=True)
        return self._move()

    def _move(self) -> Ask | None:
        """Asks for a place in line there."""
        if self._least is None or self.wait is None or self._least[0] >= self.wait * _MUCH_SOONER:
            return None
        self._has_moved, self.wait = True, None
        self._choice.move(self._least[1])
        return Ask(self._least[1])
