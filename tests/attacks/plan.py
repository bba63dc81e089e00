"""Which attacks go against which server, one by one or all at once."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path

from besieged import SETUPS, Besieged
from siege import Outcome, Siege
from target import CATALOGUE, Attack


def scenes_of(server: Path) -> Path:
    return server.resolve().parents[1] / "tests" / "support" / "fovea-scenes"


def _tell(what: str, outcome: Outcome) -> int:
    print(f"{'FAILED' if outcome.faults else 'ok':7} {what:30} {outcome}", flush=True)
    for name, tally in outcome.tallies.items():
        print(f"{'':8}{name}: " + ", ".join(f"{n} {key}" for key, n in tally.items()))
    for fault in outcome.faults:
        print(f"{'':8}! {fault}")
    return bool(outcome.faults)


def _one_setup(
    args: argparse.Namespace, siege: Siege, server: Besieged, attacks: Sequence[Attack]
) -> int:
    print(f"== {server.setup}", flush=True)
    failed = _tell("good robot alone", siege.lay(server, [], args.alone))
    if args.seconds > 0:
        return failed + _tell("all at once", siege.lay(server, attacks, args.seconds))
    for each in attacks:
        failed += _tell(each.name, siege.lay(server, [each], args.each))
        if not server.lives():
            break
    return failed


def carry_out(args: argparse.Namespace, folder: Path) -> int:
    """Returns how many attacks were successful."""
    attacks = [each for name, each in CATALOGUE.items() if not args.only or name in args.only]
    siege = Siege(scenes_of(args.server), folder, len(attacks) if args.seconds > 0 else 1)
    failed = 0
    try:
        for setup in args.setup or SETUPS:
            against = [each for each in attacks if setup in each.setups]
            if not against:
                continue
            with Besieged(args.server, setup, folder) as server:
                failed += _one_setup(args, siege, server, against)
                if server.lives() and (code := server.stop()) != 0:
                    print(f"FAILED  exit code {code}")
                    failed += 1
    finally:
        siege.close()
    return failed
