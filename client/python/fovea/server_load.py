"""How busy a server is. Knows no network. The same as client/server_load.h."""

from __future__ import annotations

from dataclasses import dataclass

from fovea.server_info import Statistics

_NO_WORK = ("queue", "processor_wait")


@dataclass(frozen=True)
class _Work:
    """Of a server since it started; times in seconds."""

    uptime: float
    num_frames: int
    # Of all frames, without their time in the queue. What they wait for a processor is in the others.
    work: float

    @staticmethod
    def of(statistics: Statistics) -> _Work:
        stages = statistics.stages.items()
        return _Work(
            statistics.uptime_ms / 1000,
            sum(statistics.frames_answered.values()),
            sum(stage.total_ms for name, stage in stages if name not in _NO_WORK) / 1000,
        )


class ServerLoad:
    def __init__(self) -> None:
        self.num_waiting = 0
        self._last: _Work | None = None
        self._seconds_per_frame: float | None = None

    def note(self, statistics: Statistics) -> None:
        now, last = _Work.of(statistics), self._last
        self.num_waiting, self._last = statistics.frames_waiting, now
        self._seconds_per_frame = None
        if last is None or now.uptime <= last.uptime or now.num_frames < last.num_frames:
            return  # it was started anew
        num_frames, seconds = now.num_frames - last.num_frames, now.uptime - last.uptime
        if num_frames > 0:
            # Where nothing waits there may be more to have: what one thread can do at least.
            busy = seconds if self.num_waiting else min(seconds, now.work - last.work)
            self._seconds_per_frame = busy / num_frames
        elif not self.num_waiting:
            self._seconds_per_frame = 0.0

    def turn(self, more: int) -> float | None:
        """Seconds from one answer to the next that each robot gets if they take turns and `more` of
        them come; 0 where there was nothing to do. None where that is not known: before it was
        noted twice."""
        if self._seconds_per_frame is None:
            return None
        computed = 1
        return (self.num_waiting + computed + more) * self._seconds_per_frame
