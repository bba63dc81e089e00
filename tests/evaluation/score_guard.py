"""Fails where box F1 of a fixed set has fallen by more than a point below its figure.

usage: score_guard.py BUILD_FOLDER [--write]

Frames of others and mOSD, where the data are (../shared/data or FOVEA_DATA), generated scenes
otherwise. The figures stand in score_figures.json beside this; --write sets those that it measures.
"""

import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
FIGURES = HERE / "score_figures.json"
DATA = Path(os.environ.get("FOVEA_DATA", HERE.parents[1] / ".." / "shared" / "data"))
MARGIN = 0.01
GENERATED = ("tabletop", "stacked", "household", "floor", "luggage")


def measure(build: Path, *flags: str) -> float:
    with tempfile.TemporaryDirectory() as folder:
        answer = Path(folder) / "scores.json"
        command = [str(build / "tests/evaluation/fovea-eval"), "detection", "--threads", "2"]
        subprocess.run(
            [*command, *flags, "--json", str(answer)], check=True, stdout=subprocess.DEVNULL
        )
        scores = json.loads(answer.read_text())
    if isinstance(scores, list):  # of boxes drawn by hand: a row for each method
        return float(scores[0]["summary"]["all"]["f"])
    return float(scores["summary"]["boxes"]["f"])


def measure_generated(build: Path) -> float:
    with tempfile.TemporaryDirectory() as folder:
        for kind in GENERATED:
            command = [str(build / "tests/support/fovea-scenes"), "--output", folder]
            command += ["--kind", kind, "--count", "6", "--seed", "90000"]
            subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        return measure(build, "--data", folder, "--labels", "plain")


def measure_all(build: Path) -> dict[str, float]:
    if not (DATA / "real").is_dir() or not (DATA / "osd").is_dir():
        return {"generated": measure_generated(build)}
    return {
        "real": measure(build, "--data", str(DATA / "real"), "--labels", "boxes"),
        "mosd": measure(build, "--data", str(DATA / "osd"), "--labels", "mosd"),
    }


def main() -> int:
    if len(sys.argv) < 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    measured = measure_all(Path(sys.argv[1]))
    figures = json.loads(FIGURES.read_text()) if FIGURES.exists() else {}
    if "--write" in sys.argv:
        figures.update({name: round(score, 3) for name, score in measured.items()})
        FIGURES.write_text(json.dumps(figures, indent=2, sort_keys=True) + "\n")
    fallen = False
    for name, score in measured.items():
        enough = score >= figures[name] - MARGIN
        fallen = fallen or not enough
        print(f"box F1, {name}: {score:.3f} ({figures[name]:.3f})" + ("" if enough else ": FALLEN"))
    return 1 if fallen else 0


if __name__ == "__main__":
    sys.exit(main())
