"""The commands of the README, run as they are written: only the port is another one."""

import os
import re
import shlex
import shutil
import subprocess
import time
from collections.abc import Iterator
from pathlib import Path

import pytest
from PIL import Image

ROOT = Path(__file__).resolve().parents[2]
BUILD = Path(os.environ["FOVEA_BUILD"])


def commands() -> list[str]:
    """Those of the section "Use it" that run our programs, each on one line."""
    section = (ROOT / "README.md").read_text().split("## Use it\n")[1].split("\n## ")[0]
    blocks = re.findall(r"```sh\n(.*?)```", section, re.DOTALL)
    lines = "".join(blocks).replace("\\\n", " ").splitlines()
    return [line.split("#")[0].strip() for line in lines if line.startswith("build/release/")]


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Where a reader would stand: in the clone with its build, and a frame C.png and D.png."""
    here = tmp_path_factory.mktemp("readme")
    (here / "build").mkdir()
    (here / "build" / "release").symlink_to(BUILD)
    (here / "client").symlink_to(ROOT / "client")
    frame = ROOT / "client/examples/frames/tabletop"
    Image.open(f"{frame}_color.jpg").save(here / "C.png")
    shutil.copy(f"{frame}_depth.png", here / "D.png")
    return here


@pytest.fixture(scope="module")
def address(folder: Path) -> Iterator[str]:
    (start,) = [line for line in commands() if "fovea-server" in line]
    started = start.replace(":50051", ":0")
    server = subprocess.Popen(
        shlex.split(started),
        cwd=folder,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
    )
    assert server.stdout is not None
    yield server.stdout.readline().removeprefix("listening on ").strip()
    server.terminate()
    assert server.wait() == 0


# One needs a recording from elsewhere, and pipes it into another program.
DETECT = [line for line in commands() if "/fovea detect" in line and "|" not in line]


@pytest.mark.parametrize("command", DETECT)
def test_detect(command: str, folder: Path, address: str) -> None:
    begun = time.time() - 1
    run = shlex.split(command.replace("127.0.0.1:50051", address))
    done = subprocess.run(run, cwd=folder, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    for flag in ("--overlay", "--labels", "--json", "--cloud"):
        if flag in run:
            assert (folder / run[run.index(flag) + 1]).stat().st_mtime > begun, flag
    if "--output" in run:
        assert list((folder / "results").glob("*_overlay.*"))


def test_flags_of_the_camera_client_exist() -> None:
    (command,) = [line for line in commands() if "fovea-capture" in line]
    program, *arguments = shlex.split(command)
    help_text = subprocess.run(
        [str(BUILD / program.removeprefix("build/release/")), "--help"],
        capture_output=True,
        text=True,
        check=True,
    ).stdout
    for argument in arguments:
        assert not argument.startswith("--") or argument in help_text
