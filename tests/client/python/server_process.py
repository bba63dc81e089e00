"""The real server, as a child process."""

from __future__ import annotations

import os
import signal
import subprocess
from typing import TextIO

PATIENCE = 60.0  # seconds; only a broken test waits that long


class ServerProcess:
    """fovea-server on a free port, or on `address`; it logs errors to stderr, or all to `log`."""

    def __init__(
        self, *flags: str, address: str = "127.0.0.1:0", log: TextIO | None = None
    ) -> None:
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
