#!/usr/bin/env python3
"""Attacks a fovea-server that it starts itself, and tells how a good robot fares meanwhile."""

from __future__ import annotations

import argparse
import os
import sys
import tempfile
from pathlib import Path

BUILD = Path(__file__).resolve().parents[2] / "build" / "release"
EXAMPLES = """
run.py --list                      what there is
run.py                             one after the other, 5 s each
run.py --only rapid-reset          one of them
run.py --seconds 600               all at once for ten minutes, with each kind of protection
"""


def arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        description=__doc__, epilog=EXAMPLES, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--list", action="store_true", help="name the attacks, and exit")
    parser.add_argument(
        "--only", action="append", default=[], metavar="NAME", help="this attack; may be repeated"
    )
    parser.add_argument(
        "--setup", action="append", default=[], choices=("open", "tokens", "tls"), help="this one"
    )
    parser.add_argument(
        "--seconds", type=float, default=0, help="all at once for so long; 0 = one after the other"
    )
    parser.add_argument("--each", type=float, default=5, help="seconds of each, one by one")
    parser.add_argument("--alone", type=float, default=10, help="seconds of the robot alone")
    parser.add_argument(
        "--server", type=Path, default=BUILD / "server" / "fovea-server", metavar="PATH"
    )
    return parser.parse_args()


def main(args: argparse.Namespace) -> int:
    import plan

    if args.list:
        for each in plan.CATALOGUE.values():
            print(f"{each.name:30} {each.what} ({', '.join(each.setups)})")
        return 0
    unknown = [name for name in args.only if name not in plan.CATALOGUE]
    if unknown:
        print(f"--only: {unknown[0]} is not one of the attacks that --list names", file=sys.stderr)
        return 2
    with tempfile.TemporaryDirectory() as folder:
        return plan.carry_out(args, Path(folder))


def find_library(server: Path) -> None:
    """The server's build has the Python library, too."""
    package = server.resolve().parents[1] / "client" / "python" / "package"
    sys.path.insert(0, str(package))
    inherited = os.environ.get("PYTHONPATH", "")
    os.environ["PYTHONPATH"] = os.pathsep.join(filter(None, [str(package), inherited]))


if __name__ == "__main__":
    wanted = arguments()
    find_library(wanted.server)
    sys.exit(main(wanted))
