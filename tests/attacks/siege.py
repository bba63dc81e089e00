"""Attackers and a good robot against one server, and what has to hold afterwards."""

from __future__ import annotations

import multiprocessing
import subprocess
import time
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import robot
from besieged import Besieged, Usage
from catalogue import be_an_attacker, run_attack
from target import Attack, Tally

# What docs/operations.md promises with the defaults and two compute threads.
PROMISED_MIB = 900
# Of files and threads that gRPC opens when it needs them, and keeps.
SLACK = 24
RECOVERY = 30.0  # seconds; only a server that does not recover takes that long


@dataclass
class Outcome:
    tallies: dict[str, Tally]
    robot: robot.Report
    usage: Usage
    log_bytes: int
    faults: list[str]

    def __str__(self) -> str:
        return (
            f"peak {self.usage.peak_mib} MiB, log {self.log_bytes / 1e6:.1f} MB, good robot "
            f"{_latencies(self.robot.kept)}, newly connected {_latencies(self.robot.newcomer)}"
        )


def _latencies(seconds: list[float]) -> str:
    p50, p99 = (round(1000 * robot.percentile(seconds, share)) for share in (0.5, 0.99))
    return f"{len(seconds)} answers, p50 {p50} ms, p99 {p99} ms"


class Siege:
    """The processes of attackers and of the robot, and the frame that both know."""

    def __init__(self, scenes: Path, folder: Path, attackers: int) -> None:
        command = [str(scenes), "--output", str(folder), "--kind", "tabletop", "--size", "320x240"]
        subprocess.run(command, check=True)
        self._scene = str(folder / "tabletop_1")
        frame = robot.fovea.Frame(**robot.load(self._scene))
        self._request = robot.request_bytes(frame)
        spawn = multiprocessing.get_context("spawn")
        self._attackers = ProcessPoolExecutor(attackers, spawn, initializer=be_an_attacker)
        self._warm: list[Besieged] = []
        self._robot = ProcessPoolExecutor(1, spawn)

    def close(self) -> None:
        self._attackers.shutdown(cancel_futures=True)
        self._robot.shutdown(cancel_futures=True)

    def lay(
        self,
        server: Besieged,
        attacks: Sequence[Attack],
        seconds: float,
        must: tuple[str, ...] = (),
    ) -> Outcome:
        """Runs the attacks at once for so long, and until `must`, beside a good robot, and looks at
        what is left."""
        if server not in self._warm:  # gRPC has made its threads
            self._serve(server, 0)
            self._warm.append(server)
        before, log_before = server.usage(), server.log_bytes
        target = server.target(self._request)
        running = {
            each.name: self._attackers.submit(run_attack, each.name, target, seconds, must)
            for each in attacks
        }
        report = self._serve(server, seconds)
        tallies = {name: future.result(seconds + 60) for name, future in running.items()}
        report.faults += [f"afterwards: {fault}" for fault in self._serve(server, 0).faults]
        usage = server.usage()
        after = _recovered(server, before)
        outcome = Outcome(tallies, report, usage, server.log_bytes - log_before, [])
        outcome.faults = _faults(server, attacks, outcome, before, after)
        return outcome

    def _serve(self, server: Besieged, seconds: float) -> robot.Report:
        until = time.monotonic() + seconds
        future = self._robot.submit(robot.drive, server.access(), self._scene, until)
        return future.result(seconds + 4 * robot.DEADLINE)


def _recovered(server: Besieged, before: Usage) -> Usage:
    """What it uses once it uses no more than before, or does not come to that in time."""
    give_up = time.monotonic() + RECOVERY
    while True:
        now = server.usage()
        if max(now.files - before.files, now.threads - before.threads) <= SLACK:
            return now
        if time.monotonic() > give_up:
            return now
        time.sleep(0.05)


def _faults(
    server: Besieged, attacks: Sequence[Attack], outcome: Outcome, before: Usage, after: Usage
) -> list[str]:
    if not server.lives():
        return ["the server has ended: " + " | ".join(server.last_words)]
    faults = [f"good robot: {fault}" for fault in outcome.robot.faults]
    if outcome.usage.peak_mib > PROMISED_MIB:
        faults.append(f"{outcome.usage.peak_mib} MiB resident, {PROMISED_MIB} are promised")
    for what in ("files", "threads"):
        was, now = getattr(before, what), getattr(after, what)
        if now - was > SLACK:
            faults.append(f"{now} {what} are left, {was} were there before")
    for each in attacks:
        tally = outcome.tallies[each.name]
        faults += [f"{each.name} was no attack: no {what}" for what in each.must if not tally[what]]
    return faults
