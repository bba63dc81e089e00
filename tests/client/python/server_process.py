"""The real server, as a child process."""

from __future__ import annotations

import os
import signal
import socket
import subprocess
from typing import ClassVar, TextIO

PATIENCE = 60.0  # seconds; only a broken test waits that long


class HeldAddress:
    """An address of loopback that nobody else is given until it is closed, while whoever sets
    SO_REUSEADDR may listen on it: servers do, and HAProxy."""

    def __init__(self) -> None:
        self._socket = socket.socket()
        self._socket.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        self._socket.bind(("127.0.0.1", 0))
        self.port = int(self._socket.getsockname()[1])

    def __str__(self) -> str:
        return f"127.0.0.1:{self.port}"

    def close(self) -> None:
        self._socket.close()


class ServerProcess:
    """fovea-server on a free port, which stays that of this program, or on `address`; it logs errors
    to stderr, or all to `log`."""

    _held: ClassVar[list[HeldAddress]] = []

    def __init__(self, *flags: str, address: str = "", log: TextIO | None = None) -> None:
        if not address:
            self._held.append(HeldAddress())
            address = str(self._held[-1])
        level = "info" if log else "error"
        command = [os.environ["FOVEA_SERVER"], "--listen", address, "--log-level", level, *flags]
        self._process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=log, text=True)
        line = self._process.stdout.readline()
        assert line.startswith("listening on "), line
        self.address = line.split()[-1]

    def __enter__(self) -> ServerProcess:
        return self

    def __exit__(self, *_: object) -> None:
        self.kill()

    def freeze(self) -> None:
        """It answers nothing until thaw()."""
        self._process.send_signal(signal.SIGSTOP)
        os.waitpid(self._process.pid, os.WUNTRACED)  # until all of its threads have stopped

    def thaw(self) -> None:
        self._process.send_signal(signal.SIGCONT)

    def stop(self) -> None:
        """Its log is whole then."""
        self._process.terminate()
        self._process.wait()

    def kill(self) -> None:
        self._process.kill()
        self._process.wait()
        self._process.stdout.close()
