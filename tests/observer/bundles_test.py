"""Bundles of the last minutes on disk, which are sent once more."""

from __future__ import annotations

import io
import json
import os
import re
import subprocess
import zipfile
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import Recorded, Scene, bundle
from processes import PATIENCE

import fovea
from fovea.v1 import detection_pb2, detection_service_pb2


def test_bundles_hold_the_seconds_around(recorded: Recorded, scene: Scene) -> None:
    frames = [scene.frame(id=f"frame {number}") for number in range(4)]
    ids = recorded.record("hall/1", *frames)
    visitor = recorded.visitor("ann")
    answer = visitor.get(bundle("hall%2F1", ids[1], 600, 600))
    assert re.search(r'filename="fovea_hall_1_\d+T\d+Z.zip"', answer.headers["Content-Disposition"])
    with zipfile.ZipFile(io.BytesIO(answer.body)) as file:
        about = json.loads(file.read("bundle.json"))
        assert [frame["frame_id"] for frame in about["frames"]] == [f.id for f in frames]
        assert all(frame["robot"] == "hall/1" and frame["server"] for frame in about["frames"])
        assert about["frames"][0]["server_version"] == fovea.__version__
        assert file.testzip() is None
    with zipfile.ZipFile(io.BytesIO(visitor.get(bundle("hall%2F1", ids[1])).body)) as file:
        about = json.loads(file.read("bundle.json"))
        assert [frame["frame_id"] for frame in about["frames"]] == ["frame 1"]


def replay(path: Path, server: str, output: Path, *flags: str) -> subprocess.CompletedProcess[str]:
    command = [os.environ["FOVEA_CLI"], "detect", "--server", server, "--input", str(path)]
    command += ["--output", str(output), *flags]
    return subprocess.run(command, capture_output=True, text=True, timeout=PATIENCE)


def timeless(path: Path) -> bytes:
    answer = detection_pb2.Detections.FromString(path.read_bytes())
    assert answer.objects
    answer.ClearField("stage_times")
    return bytes(answer.SerializeToString(deterministic=True))


def save(recorded: Recorded, robot: str, frame: int, folder: Path) -> Path:
    path = folder / "bundle.zip"
    path.write_bytes(recorded.visitor("ann").get(bundle(robot, frame)).body)
    return path


@pytest.mark.parametrize(
    "options",
    [{"return_masks": False}, {"return_masks": True, "return_rejected": True}],
)
@pytest.mark.parametrize("flags", [[], ["--no-masks", "--no-overlay"]])
def test_a_bundle_is_answered_as_it_was(
    recorded: Recorded, scene: Scene, tmp_path: Path, options: Any, flags: list[str]
) -> None:
    frame = scene.frame(id="odd one")
    number = recorded.record("arm", frame, parameters={"max_depth_m": 4}, **options)[0]
    path = save(recorded, "arm", number, tmp_path)
    server = recorded.robots.address
    finished = replay(path, server, tmp_path / "again", *flags)
    assert finished.returncode == 0, finished.stderr
    assert "the same answer as then" in finished.stdout
    with zipfile.ZipFile(path) as file:
        file.extractall(tmp_path / "saved")
    saved = tmp_path / "saved" / "frame_0001_answer.pb"
    again = tmp_path / "again" / "frame_0001_answer.pb"
    assert timeless(saved) == timeless(again)
    request = detection_service_pb2.DetectRequest.FromString(
        (tmp_path / "saved" / "frame_0001_request.pb").read_bytes()
    )
    assert request.frame.color.data == scene.color.tobytes()
    assert request.options.parameters == {"max_depth_m": 4}
    assert request.options.return_masks == options["return_masks"]


def of_the_folder(recorded: Recorded, frame: Any, folder: Path) -> tuple[Any, Any]:
    """The objects of the answer in the bundle of this frame, and of that to the unpacked bundle."""
    number = recorded.record("arm", frame)[0]
    with zipfile.ZipFile(save(recorded, "arm", number, folder)) as file:
        file.extractall(folder / "saved")
    finished = replay(folder / "saved", recorded.robots.address, folder / "again")
    assert finished.returncode == 0, finished.stderr
    then = json.loads((folder / "saved" / "frame_0001_answer.json").read_text())
    now = json.loads((folder / "again" / "frame_0001.json").read_text())
    assert then["objects"]
    return then["objects"], now["objects"]


def test_a_bundle_is_a_folder_of_frames(recorded: Recorded, scene: Scene, tmp_path: Path) -> None:
    then, now = of_the_folder(recorded, scene.frame(), tmp_path)
    assert [found["label"] for found in then] == [found["label"] for found in now]


def test_a_bundle_is_a_folder_that_knows_its_depth_camera(
    recorded: Recorded, scene: Scene, tmp_path: Path
) -> None:
    frame = scene.frame(
        depth=2 * scene.depth[::2, ::2],
        depth_unit_m=0.0005,
        depth_intrinsics=fovea.CameraIntrinsics(131.25, 131.25, 79.75, 59.75),
        color_from_depth=np.eye(4),
    )
    then, now = of_the_folder(recorded, frame, tmp_path)
    assert [found["oriented_box"] for found in then] == [found["oriented_box"] for found in now]


def test_options_are_changed_by_flags(recorded: Recorded, scene: Scene, tmp_path: Path) -> None:
    number = recorded.record("arm", scene.frame())[0]
    path = save(recorded, "arm", number, tmp_path)
    flags = ["--set", "objects.min_probability=1"]
    finished = replay(path, recorded.robots.address, tmp_path / "again", *flags)
    assert finished.returncode == 0, finished.stderr
    assert "another answer than then" in finished.stdout
    flags = ["--set", "no.such=1"]
    finished = replay(path, recorded.robots.address, tmp_path / "more", *flags)
    assert finished.returncode == 1 and "no.such" in finished.stderr
    finished = replay(path, recorded.robots.address, tmp_path / "more", "--gravity", "0,1,0")
    assert finished.returncode == 1 and "sent as they were" in finished.stderr


def test_frames_that_were_refused_are_bundled_too(
    recorded: Recorded, scene: Scene, tmp_path: Path
) -> None:
    visitor = recorded.visitor("ann")
    with pytest.raises(fovea.FoveaError):
        recorded.robots.detect("arm-bad", scene.frame(), parameters={"no.such": 1})
    number = visitor.history("arm-bad", 1)[0]
    path = save(recorded, "arm-bad", number, tmp_path)
    with zipfile.ZipFile(path) as file:
        assert "no.such" in json.loads(file.read("frame_0001_error.json"))["message"]
    finished = replay(path, recorded.robots.address, tmp_path / "again")
    assert finished.returncode == 1 and "no.such" in finished.stderr


def test_bundles_that_are_none_are_refused_in_words(recorded: Recorded, tmp_path: Path) -> None:
    def refused(write: Any) -> str:
        path = tmp_path / "bad.zip"
        write(path)
        finished = replay(path, recorded.robots.address, tmp_path / "out")
        assert finished.returncode == 1, finished.stdout
        return finished.stderr

    def zip_of(files: dict[str, bytes]) -> Any:
        def write(path: Path) -> None:
            with zipfile.ZipFile(path, "w") as file:
                for name, content in files.items():
                    file.writestr(name, content)

        return write

    about = json.dumps({"format": "fovea-bundle", "version": 1}).encode()
    newer = json.dumps({"format": "fovea-bundle", "version": 2}).encode()
    assert "no readable zip" in refused(lambda path: path.write_bytes(b"no zip at all"))
    assert "no bundle.json" in refused(zip_of({"a.txt": b""}))
    assert "none of fovea-observer's" in refused(zip_of({"bundle.json": b"[[["}))
    assert "version" in refused(zip_of({"bundle.json": newer}))
    assert "holds no frame" in refused(zip_of({"bundle.json": about}))
    assert "no plain file name" in refused(
        zip_of({"../../evil_request.pb": b"", "bundle.json": about})
    )
    assert "no plain file name" in refused(zip_of({"a/b_request.pb": b"", "bundle.json": about}))
    garbage = zip_of({"bundle.json": about, "f_request.pb": b"\xff\xff"})
    assert "f_request.pb in it is no fovea.v1.DetectRequest" in refused(garbage)
