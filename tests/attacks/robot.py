"""A good robot: calls now and then, as the library does, and notes how it fares."""

from __future__ import annotations

import time
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

import fovea
from fovea.v1 import detection_service_pb2

DEADLINE = 30.0  # seconds; of a call with its attempts
PAUSE = 0.1


@dataclass(frozen=True)
class Access:
    address: str
    token: str
    authority: bytes  # empty: no TLS

    def client(self) -> fovea.Client:
        tls = fovea.TlsOptions(root_certificates=self.authority) if self.authority else None
        retry = fovea.RetryOptions(max_attempts=100)
        return fovea.Client(
            self.address, timeout=DEADLINE, token=self.token, tls=tls, retry=retry, robot="good"
        )


@dataclass
class Report:
    """Latencies in seconds, of answered calls, and what went wrong with the others."""

    kept: list[float] = field(default_factory=list)  # over a connection that was there before
    newcomer: list[float] = field(default_factory=list)  # over a new connection each
    faults: list[str] = field(default_factory=list)

    def add(self, other: Report) -> None:
        self.kept += other.kept
        self.newcomer += other.newcomer
        self.faults += other.faults


@cache
def load(scene: str) -> dict[str, Any]:
    """The generated frame of 320x240 of this path without its endings."""
    color = np.array(Image.open(Path(scene + "_color.png")))
    depth = np.array(Image.open(Path(scene + "_depth.png"))).astype(np.uint16)
    intrinsics = fovea.CameraIntrinsics(262.5, 262.5, 159.5, 119.5)
    return {"color": color, "depth": depth, "intrinsics": intrinsics}


def drive(access: Access, scene: str, until: float) -> Report:
    """Calls in turn over a connection that stays and over a new one, at least once each."""
    report, frame = Report(), load(scene)
    with access.client() as kept:
        while True:
            _call(kept, frame, report.kept, report.faults)
            with access.client() as newcomer:
                _call(newcomer, frame, report.newcomer, report.faults)
            if time.monotonic() >= until:
                return report
            time.sleep(PAUSE)


def _call(client: fovea.Client, frame: dict[str, Any], took: list[float], wrong: list[str]) -> None:
    began = time.monotonic()
    try:
        found = client.detect(**frame)
    except fovea.FoveaError as error:
        wrong.append(f"after {time.monotonic() - began:.1f} s: {error}")
        return
    took.append(time.monotonic() - began)
    if not found.objects:
        wrong.append("no objects in the answer")


def percentile(values: list[float], share: float) -> float:
    """The smallest value that `share` of all do not exceed; 0 where there are none."""
    ordered = sorted(values)
    return ordered[min(len(ordered) - 1, int(share * len(ordered)))] if ordered else 0.0


def request_bytes(frame: fovea.Frame) -> bytes:
    """The DetectRequest of a frame, for attackers to send."""
    request = detection_service_pb2.DetectRequest(frame=frame.to_proto())
    return bytes(request.SerializeToString())
