"""The package as pip installs it, and the examples with it."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from server_process import ServerProcess

import fovea

SOURCE = Path(os.environ["FOVEA_SOURCE_DIR"])
EXAMPLES = SOURCE / "client/examples/python"


PIP = [sys.executable, "-m", "pip", "install", "--no-index", "--no-build-isolation", "--no-deps"]


@pytest.fixture(scope="module")
def sources(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of them, from which pip has installed an older version with one module more."""
    folder = tmp_path_factory.mktemp("source")
    for part in ("client/python", "proto"):
        built = shutil.ignore_patterns("build", "*.egg-info", "__pycache__")
        shutil.copytree(SOURCE / part, folder / part, ignore=built)
    (folder / "client/python/build/lib/fovea").mkdir(parents=True)
    (folder / "client/python/build/lib/fovea/gone.py").touch()
    return folder / "client/python"


@pytest.fixture(scope="module")
def installed(sources: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Where the package is, installed without network from a copy of the sources."""
    folder = tmp_path_factory.mktemp("pip")
    command = [*PIP, "--target", str(folder / "target"), str(sources)]
    subprocess.run(command, check=True, capture_output=True, env=os.environ | {"HOME": str(folder)})
    return folder / "target"


@pytest.fixture(scope="module")
def frames(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with tabletop_1, with six objects, of the camera whose intrinsics the examples have."""
    folder = tmp_path_factory.mktemp("frames")
    command = [os.environ["FOVEA_SCENES"], "--output", str(folder), "--kind", "tabletop"]
    subprocess.run(command, check=True)
    return folder


def run_with(installed: Path, *arguments: str) -> str:
    environment = os.environ | {"PYTHONPATH": str(installed)}
    finished = subprocess.run(
        [sys.executable, *arguments], env=environment, capture_output=True, text=True, timeout=300
    )
    assert finished.returncode == 0, finished.stderr
    return finished.stdout


def test_the_installed_package_is_complete(installed: Path) -> None:
    built = Path(fovea.__file__).parent
    assert built != installed / "fovea"
    files = sorted(
        path.relative_to(built) for path in built.rglob("*.py*") if path.suffix != ".pyc"
    )
    assert Path("v1/detection_service_pb2_grpc.py") in files
    for file in [*files, Path("py.typed")]:
        assert (installed / "fovea" / file).read_bytes() == (built / file).read_bytes()
    assert not (installed / "fovea/gone.py").exists()
    program = "import fovea, importlib.metadata as m; print(fovea.__file__, m.version('fovea'))"
    expected = [str(installed / "fovea/__init__.py"), fovea.__version__]
    assert run_with(installed, "-c", program).split() == expected


def test_an_editable_install_is_refused(sources: Path, tmp_path: Path) -> None:
    """The sources lack the modules of the contract."""
    command = [*PIP, "--target", str(tmp_path), "--editable", str(sources)]
    finished = subprocess.run(command, capture_output=True, text=True, check=False)
    assert finished.returncode != 0
    assert "no editable install" in finished.stdout + finished.stderr


def test_the_example_finds_objects(installed: Path, server: ServerProcess, frames: Path) -> None:
    files = str(frames / "tabletop_1_color.png"), str(frames / "tabletop_1_depth.png")
    output = run_with(installed, str(EXAMPLES / "detect_once.py"), server.address, *files)
    assert len(output.splitlines()) >= 5
    assert all(line.endswith(" grasps") for line in output.splitlines())


@pytest.mark.parametrize("example", ["clean_up.py", "detect_once.py", "detect_stream.py"])
def test_the_examples_explain_themselves(installed: Path, example: str) -> None:
    assert run_with(installed, str(EXAMPLES / example), "--help").startswith(f"usage: {example}")


def test_the_example_of_a_stream_runs_over_a_folder(
    installed: Path, server: ServerProcess, frames: Path
) -> None:
    output = run_with(
        installed, str(EXAMPLES / "detect_stream.py"), server.address, str(frames), "--frames", "3"
    )
    lines = output.splitlines()
    assert lines[-1].startswith("frame 2: ")


def test_the_example_cleans_up(installed: Path, server: ServerProcess) -> None:
    command = [os.environ["FOVEA_CLEAN_UP"], "--things", "2", "--sensor", "ideal", "--"]
    command += [sys.executable, str(EXAMPLES / "clean_up.py"), server.address]
    environment = os.environ | {"PYTHONPATH": str(installed)}
    finished = subprocess.run(
        command, env=environment, capture_output=True, text=True, timeout=300, check=False
    )
    assert finished.returncode == 0, finished.stderr
    assert "1 scenes, 2 things" in finished.stdout
    assert any(line.endswith(" taken") for line in finished.stdout.splitlines()), finished.stdout


def test_it_stands_beside_another_copy_of_the_health_protocol(installed: Path) -> None:
    """As of grpcio-health-checking, whose messages have the same names."""
    program = """
from google.protobuf import descriptor_pb2, descriptor_pool
file = descriptor_pb2.FileDescriptorProto(name="grpc/health/v1/health.proto")
file.package = "grpc.health.v1"
file.message_type.add(name="HealthCheckRequest")
descriptor_pool.Default().Add(file)
import fovea
"""
    run_with(installed, "-c", program)
