#!/usr/bin/env python3
"""Kills one of two servers again and again, and tells how long their streams take to be answered
by the other one."""

from __future__ import annotations

import argparse
import math
import os
import shutil
import statistics
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--kills", type=int, default=20, metavar="N")
    parser.add_argument("--streams", type=int, default=8, metavar="N", help="at 5 Hz each")
    parser.add_argument("--proxy", action="store_true", help="HAProxy, else the client's list")
    parser.add_argument(
        "--build", type=Path, default=ROOT / "build" / "release", metavar="DIR", help="what is run"
    )
    return parser.parse_args()


def prepare(build: Path) -> None:
    sys.path += [str(build / "client/python/package"), str(ROOT / "tests/client/python")]
    os.environ["FOVEA_SERVER"] = str(build / "server/fovea-server")
    os.environ["FOVEA_SCENES"] = str(build / "tests/support/fovea-scenes")
    os.environ["HAPROXY"] = shutil.which("haproxy", path=os.environ["PATH"] + ":/usr/sbin") or ""


def main(args: argparse.Namespace) -> None:
    from conftest import make_scene
    from fleet import Fleet
    from streams import Streams

    times: list[float] = []
    with (
        tempfile.TemporaryDirectory() as folder,
        Fleet(Path(folder), with_proxy=args.proxy) as fleet,
        Streams(fleet, make_scene(Path(folder)), args.streams) as streams,
    ):
        for kill in range(args.kills):
            back = streams.times_to_return(fleet.members[kill % 2])
            times += back
            print(f"{kill + 1}:", *(f"{seconds:.2f}" for seconds in sorted(back)), flush=True)
    times.sort()
    p95 = times[math.ceil(0.95 * len(times)) - 1]
    print(
        f"{len(times)} streams of {args.kills} kills were back after p50 "
        f"{statistics.median(times):.2f}, p95 {p95:.2f}, at most {times[-1]:.2f} s"
    )


if __name__ == "__main__":
    wanted = arguments()
    prepare(wanted.build)
    main(wanted)
