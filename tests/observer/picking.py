"""A robot that lets people mark objects for it."""

from __future__ import annotations

import itertools
import threading

from processes import PATIENCE

import fovea


class Picking:
    """A robot that streams, and keeps what people mark for it."""

    def __init__(self, address: str, robot: str, frame: fovea.Frame, picks: bool = True) -> None:
        self.picks: list[fovea.Pick] = []
        self.first: fovea.Detections | None = None
        self.came = threading.Event()
        self._stop = threading.Event()
        self._client = fovea.Client(address, robot=robot)
        self._thread = threading.Thread(target=self._run, args=(frame, picks))
        self._thread.start()
        assert self.came.wait(PATIENCE)

    def _run(self, frame: fovea.Frame, picks: bool) -> None:
        frames = itertools.takewhile(lambda _: not self._stop.wait(0.02), itertools.repeat(frame))
        for answer in self._client.stream(frames, every_frame=True, picks=picks):
            self.first = self.first or answer.detections
            self.came.set()
            if answer.pick:
                self.picks.append(answer.pick)

    def __enter__(self) -> Picking:
        return self

    def __exit__(self, *_: object) -> None:
        self._stop.set()
        self._thread.join()
        self._client.close()
