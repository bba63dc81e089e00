"""What all tests share: one server, and one generated frame with its files."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image
from server_process import PATIENCE, ServerProcess

import fovea


@dataclass
class Scene:
    """A generated tabletop of 320x240."""

    color_file: Path
    depth_file: Path
    color: Any  # HxWx3 uint8
    depth: Any  # HxW uint16, millimetres
    intrinsics = fovea.CameraIntrinsics(262.5, 262.5, 159.5, 119.5)

    def frame(self, **changes: Any) -> fovea.Frame:
        parts = {"color": self.color, "depth": self.depth, "intrinsics": self.intrinsics}
        return fovea.Frame(**(parts | changes))


def make_scene(folder: Path) -> Scene:
    command = [os.environ["FOVEA_SCENES"], "--output", str(folder)]
    subprocess.run([*command, "--kind", "tabletop", "--size", "320x240"], check=True)
    color_file, depth_file = folder / "tabletop_1_color.png", folder / "tabletop_1_depth.png"
    return Scene(
        color_file,
        depth_file,
        np.array(Image.open(color_file)),
        np.array(Image.open(depth_file)).astype(np.uint16),
    )


@pytest.fixture(scope="session")
def scene(tmp_path_factory: pytest.TempPathFactory) -> Scene:
    return make_scene(tmp_path_factory.mktemp("scene"))


@pytest.fixture(scope="session")
def server() -> Iterator[ServerProcess]:
    with ServerProcess() as process:
        yield process


@pytest.fixture
def client(server: ServerProcess) -> Iterator[fovea.Client]:
    # Other tests on this machine may take long turns.
    with fovea.Client(server.address, timeout=PATIENCE) as connected:
        yield connected
