"""Tokens and TLS."""

from __future__ import annotations

import hashlib
import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest
from conftest import Scene
from server_process import PATIENCE, ServerProcess

import fovea

TOKEN = "0123456789abcdef"
ONCE = fovea.RetryOptions(max_attempts=1)


def test_a_token_opens_the_door(scene: Scene, tmp_path: Path) -> None:
    tokens = tmp_path / "tokens"
    tokens.write_text(f"kitchen {hashlib.sha256(TOKEN.encode()).hexdigest()}\n")
    with ServerProcess("--tokens", str(tokens)) as server:
        with fovea.Client(server.address, token=TOKEN, timeout=PATIENCE) as client:
            client.check()
            assert client.detect_frame(scene.frame()).objects
            assert [answer.error for answer in client.stream([scene.frame()])] == [None]
        for wrong in ("", "another"):
            with fovea.Client(server.address, token=wrong) as stranger:
                assert stranger.is_serving()  # health needs no token
                with pytest.raises(fovea.Unauthenticated):
                    stranger.check()
                with pytest.raises(fovea.Unauthenticated):
                    stranger.detect_frame(scene.frame())
                with pytest.raises(fovea.Unauthenticated):
                    list(stranger.stream([scene.frame()]))


class Authority:
    """Issues certificates for 127.0.0.1 with the openssl tool."""

    def __init__(self, folder: Path, name: str) -> None:
        self._folder = folder
        self.pem, self._key = self._make(name, "-addext", "keyUsage=keyCertSign")

    def issue(self, name: str) -> tuple[Path, Path]:
        signed = ["-CA", str(self.pem), "-CAkey", str(self._key)]
        kind = ["-addext", "basicConstraints=CA:FALSE", "-addext", "subjectAltName=IP:127.0.0.1"]
        return self._make(name, *signed, *kind)

    def _make(self, name: str, *flags: str) -> tuple[Path, Path]:
        certificate, key = self._folder / f"{name}.pem", self._folder / f"{name}.key"
        command = [
            "openssl",
            "req",
            "-x509",
            "-newkey",
            "ec",
            "-pkeyopt",
            "ec_paramgen_curve:P-256",
        ]
        command += ["-nodes", "-days", "1", "-subj", f"/CN={name}", *flags]
        command += ["-out", str(certificate), "-keyout", str(key)]
        subprocess.run(command, check=True, capture_output=True)
        return certificate, key


@pytest.fixture
def authority(tmp_path: Path) -> Authority:
    return Authority(tmp_path, "authority")


@pytest.fixture
def mutual_server(authority: Authority) -> Iterator[ServerProcess]:
    certificate, key = authority.issue("server")
    flags = ["--tls-cert", str(certificate), "--tls-key", str(key)]
    with ServerProcess(*flags, "--tls-client-ca", str(authority.pem)) as server:
        yield server


def test_mutual_tls(authority: Authority, mutual_server: ServerProcess, scene: Scene) -> None:
    certificate, key = authority.issue("robot")
    root = authority.pem.read_bytes()
    tls = fovea.TlsOptions(root, certificate.read_bytes(), key.read_bytes())
    assert "PRIVATE" not in repr(tls)
    with fovea.Client(mutual_server.address, tls=tls, timeout=PATIENCE) as client:
        client.check()
        assert client.detect_frame(scene.frame()).objects


def test_check_says_what_keeps_it_from_a_server_that_is_there(
    authority: Authority, mutual_server: ServerProcess, server: ServerProcess
) -> None:
    trusting = fovea.TlsOptions(authority.pem.read_bytes())
    for there, tls, problem in (
        (mutual_server, None, "closes the connection; does the server want TLS"),
        (mutual_server, trusting, "closes the connection; does the server want a certificate"),
        (server, trusting, "does not speak TLS; leave tls out?"),
    ):
        with fovea.Client(there.address, tls=tls) as client:
            with pytest.raises(fovea.Unavailable, match=f"{there.address} {problem}"):
                client.check()


def test_wrong_certificates_are_unavailable(
    authority: Authority, mutual_server: ServerProcess, tmp_path: Path
) -> None:
    another = Authority(tmp_path, "another")
    certificate, key = another.issue("stranger")
    stranger = certificate.read_bytes(), key.read_bytes()
    for tls in (
        None,
        fovea.TlsOptions(authority.pem.read_bytes()),
        fovea.TlsOptions(authority.pem.read_bytes(), *stranger),
        fovea.TlsOptions(another.pem.read_bytes(), *stranger),
    ):
        with fovea.Client(mutual_server.address, tls=tls, retry=ONCE, timeout=PATIENCE) as client:
            with pytest.raises(fovea.Unavailable):
                client.get_server_info()
