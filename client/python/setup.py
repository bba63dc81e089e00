"""Adds the modules generated from proto/ to the package; pyproject.toml says the rest."""
import shutil
import subprocess
from pathlib import Path

from setuptools import setup
from setuptools.command.build_py import build_py

PROTO = Path(__file__).resolve().parents[2] / "proto"


def tool(name: str, package: str) -> str:
    path = shutil.which(name)
    if path is None:
        raise SystemExit(f"{name} is missing; Debian has it in {package}")
    return path


def generate(folder: str) -> None:
    protos = sorted(str(path) for path in PROTO.glob("fovea/v1/*.proto"))
    if not protos:
        raise SystemExit(f"no protos in {PROTO}; build from a whole clone of the repository")
    plugin = tool("grpc_python_plugin", "protobuf-compiler-grpc")
    subprocess.run(
        [tool("protoc", "protobuf-compiler"), f"--proto_path={PROTO}"]
        + [f"--{kind}_out={folder}" for kind in ("python", "pyi")]
        + protos,
        check=True,
    )
    # Only the file with the service: the others would give empty modules.
    service = [proto for proto in protos if proto.endswith("_service.proto")]
    subprocess.run(
        [tool("protoc", "protobuf-compiler"), f"--proto_path={PROTO}", f"--grpc_out={folder}"]
        + [f"--plugin=protoc-gen-grpc={plugin}"]
        + service,
        check=True,
    )


class BuildWithProtos(build_py):
    def run(self) -> None:
        if self.editable_mode:
            raise SystemExit("no editable install: there are modules that only the build generates")
        # pip keeps this folder beside the sources, and in it what an older version had.
        shutil.rmtree(Path(self.build_lib) / "fovea", ignore_errors=True)
        super().run()
        generate(self.build_lib)


setup(cmdclass={"build_py": BuildWithProtos})
