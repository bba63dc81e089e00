"""Which of several servers a client asks. Knows no network and no clock.

A client stays with one server, its home. When that has no room, others are asked for it; where none
has any, the client asks for a place in line where the wait is least, and that is its home from then
on. Until then nobody keeps a place for it: one that it does not take would hold up those behind it.
The home changes as well where another one takes its calls twice in a row. Servers that are away are
left alone for a while that doubles. Without a home, one is chosen by chance. The same as
client/server_choice.h.
"""

from __future__ import annotations

import random
from collections.abc import Iterable
from dataclasses import dataclass

_FIRST_AWAY, _LONGEST_AWAY = 0.1, 5.0
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
    only_if_room: bool = False  # else it is to keep a place in line


class ServerChoice:
    """Not thread-safe. Times are in seconds."""

    def __init__(self, seed: int | None = None) -> None:
        self._random = random.Random(seed)
        self._servers: dict[str, _State] = {}
        self._home = ""
        self._num_elsewhere = 0  # answers in a row that did not come from home
        self.has_asked_others = False  # when a call got a place in line last

    def set_servers(self, names: Iterable[str]) -> None:
        """Where these are others than before, the home is chosen anew."""
        servers = {name: self._servers.get(name, _State()) for name in names}
        if servers.keys() != self._servers.keys():
            self._home = ""
        self._servers = servers

    def home(self, now: float) -> str:
        """Chosen where there is none or it is away; whoever is back soonest where all are."""
        if self.are_all_away(now):
            self._home = self.back_soonest(self._servers)
        elif not self._home or self.is_away(self._home, now):
            self._home = self.another(set(), now, only_there=True)
            self._num_elsewhere = 0
        return self._home

    def back_soonest(self, names: Iterable[str]) -> str:
        return min(names, key=lambda name: self._servers[name].away_until)

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
    """One call's way around the servers: each is asked once at most for room, then one for a place
    in line."""

    def __init__(self, choice: ServerChoice, asks_others: bool) -> None:
        """asks_others: where the home has no room; every second call that gets a place in line does
        so, which is enough."""
        self.wait: float | None = None  # when whoever keeps a place says to come back
        self._choice = choice
        self._asks_others = asks_others
        self._others_left = _MAX_OTHERS
        self._last: Ask | None = None
        self._asked: set[str] = set()
        self._least: tuple[float, str] | None = None  # without a place

    def next(self, now: float) -> Ask | None:
        """Whom to ask next; None once nobody is left that promises anything. Then one of the
        following is to be called."""
        ask = self._next(now)
        if ask:
            self._last = ask
            self._asked.add(ask.server)
        return ask

    def on_answered(self) -> None:
        assert self._last
        self._choice.on_answered(self._last.server)

    def on_refused(self, retry_after: float) -> None:
        assert self._last
        if not self._last.only_if_room:
            self.wait = retry_after
            if self._asks_others:
                self._choice.has_asked_others = self._least is not None
        elif self._least is None or retry_after < self._least[0]:
            self._least = retry_after, self._last.server

    def on_away(self, now: float) -> None:
        assert self._last
        self._choice.on_away(self._last.server, now)

    def _next(self, now: float) -> Ask | None:
        if not self._last:
            return self._ask_home(self._choice.home(now), now)
        if self.wait is not None or (self._least and not self._last.only_if_room):
            return None
        if self._least:
            return self._ask_another(self._least[1], now)
        name = self._choice.another(self._asked, now, only_there=False)  # the home is away
        return self._ask_home(name, now) if name else None

    def _ask_home(self, name: str, now: float) -> Ask:
        """For a place in line at once where there is nobody else to ask."""
        self._choice.move(name)
        has_others = bool(self._choice.another(self._asked | {name}, now, only_there=True))
        asks_others = self._asks_others and not self._choice.has_asked_others
        return Ask(name, only_if_room=asks_others and has_others)

    def _ask_another(self, least: str, now: float) -> Ask:
        """For room; once nobody is left, whoever said the least for a place."""
        if self._others_left:
            self._others_left -= 1
            if name := self._choice.another(self._asked, now, only_there=True):
                return Ask(name, only_if_room=True)
        self._choice.move(least)
        return Ask(least)
