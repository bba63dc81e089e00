"""The real server as a process of its own, in real limits, and what it uses."""

from __future__ import annotations

import fcntl
import hashlib
import mmap
import os
import resource
import subprocess
import termios
import threading
from array import array
from collections import deque
from dataclasses import dataclass
from pathlib import Path
from typing import IO

from robot import Access
from target import Target

MAX_FILES = 1024
TOKEN = "a token that no attacker knows"
SETUPS = ("open", "tokens", "tls")


@dataclass(frozen=True)
class Usage:
    """Of memory the most since it was looked at last."""

    peak_mib: int
    files: int
    threads: int


class Besieged:
    """fovea-server with its defaults and `flags`, on loopback; `setup` says whom it lets in. Where
    nobody reads its log, that goes to a pipe of two pages."""

    def __init__(
        self, binary: Path, setup: str, folder: Path, *flags: str, reads_log: bool = True
    ) -> None:
        self.setup = setup
        self._authority = b""
        command = [str(binary), "--listen", "127.0.0.1:0", "--metrics-listen", "127.0.0.1:0"]
        self._process = subprocess.Popen(
            [*command, *self._protection(folder), *flags],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            errors="replace",
            preexec_fn=_limit,
        )
        self.log_bytes = 0
        self.last_words: deque[str] = deque(maxlen=20)
        if reads_log:
            threading.Thread(target=self._read_log, daemon=True).start()
        else:
            fcntl.fcntl(self._log(), fcntl.F_SETPIPE_SZ, 2 * mmap.PAGESIZE)
        assert self._process.stdout
        self.port = int(self._process.stdout.readline().rpartition(":")[2])
        metrics = self._process.stdout.readline()  # metrics at http://127.0.0.1:9464/metrics
        self.metrics_port = int(metrics.rpartition(":")[2].partition("/")[0])

    def _protection(self, folder: Path) -> list[str]:
        if self.setup == "open":
            return []
        tokens = folder / "tokens"
        tokens.write_text(f"good {hashlib.sha256(TOKEN.encode()).hexdigest()}\n")
        if self.setup == "tokens":
            return ["--tokens", str(tokens)]
        key, certificate = str(folder / "key.pem"), folder / "certificate.pem"
        make = "openssl req -x509 -newkey rsa:2048 -nodes -days 2 -subj /CN=127.0.0.1"
        more = ["-addext", "subjectAltName=IP:127.0.0.1", "-keyout", key, "-out", str(certificate)]
        subprocess.run([*make.split(), *more], check=True, capture_output=True)
        self._authority = certificate.read_bytes()
        return ["--tokens", str(tokens), "--tls-cert", str(certificate), "--tls-key", key]

    def _log(self) -> IO[str]:
        assert self._process.stderr
        return self._process.stderr

    def unread_log_bytes(self) -> int:
        """What the pipe of a log that nobody reads holds."""
        count = array("i", [0])
        fcntl.ioctl(self._log(), termios.FIONREAD, count)
        return count[0]

    def _read_log(self) -> None:
        for line in self._log():
            self.log_bytes += len(line)
            self.last_words.append(line.rstrip())

    def __enter__(self) -> Besieged:
        return self

    def __exit__(self, *_: object) -> None:
        self._process.kill()
        self._process.wait()

    def access(self) -> Access:
        token = "" if self.setup == "open" else TOKEN
        return Access(f"127.0.0.1:{self.port}", token, self._authority)

    def target(self, request: bytes) -> Target:
        return Target(self.port, self.metrics_port, self.setup, request)

    def lives(self) -> bool:
        return self._process.poll() is None

    def stop(self) -> int:
        """Asks it to end; returns its exit code."""
        self._process.terminate()
        return self._process.wait(timeout=60)

    def usage(self) -> Usage:
        of_process = Path(f"/proc/{self._process.pid}")
        lines = (of_process / "status").read_text().splitlines()
        status = dict(line.split(":", 1) for line in lines)
        (of_process / "clear_refs").write_text("5")  # the peak begins anew
        return Usage(
            peak_mib=int(status["VmHWM"].split()[0]) >> 10,
            files=len(os.listdir(of_process / "fd")),
            threads=int(status["Threads"]),
        )


def _limit() -> None:
    resource.setrlimit(resource.RLIMIT_NOFILE, (MAX_FILES, MAX_FILES))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
