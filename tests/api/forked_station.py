"""The bench's station as a process that begins with what is imported once, and so in a moment."""

import os
import subprocess
import sys
from collections.abc import Mapping, Sequence
from multiprocessing.context import ForkServerProcess
from pathlib import Path

import typer

from app.bench.faults.station import StationProcess
from tests.api.processes import CONTEXT


class ForkedStation(StationProcess):
    """A station as the bench starts it, but for the time that the imports take."""

    def _launch(
        self, arguments: Sequence[str], environment: Mapping[str, str], user: int | None
    ) -> "ForkedProcess":
        if environment or user is not None:
            raise ValueError("a forked station has the environment and the user of the tests")
        return ForkedProcess(self._output, arguments)


class ForkedProcess:
    """A process of the fork server, with the methods of ``subprocess.Popen``."""

    def __init__(self, output: Path, arguments: Sequence[str]) -> None:
        self._process: ForkServerProcess = CONTEXT.Process(
            target=_serve, args=(output, arguments), daemon=True
        )
        output.touch()
        self._process.start()

    @property
    def pid(self) -> int:
        assert self._process.pid is not None
        return self._process.pid

    def poll(self) -> int | None:
        return self._process.exitcode

    def wait(self, timeout: float | None = None) -> int:
        self._process.join(timeout)
        if self._process.exitcode is None:
            raise subprocess.TimeoutExpired("the station", timeout or 0.0)
        return self._process.exitcode

    def send_signal(self, sig: int) -> None:
        os.kill(self.pid, sig)

    def kill(self) -> None:
        self._process.kill()


def _serve(output: Path, arguments: Sequence[str]) -> None:
    """In the process: the same as the bench's command."""
    from app.bench.faults.served import serve

    console = os.open(output, os.O_WRONLY | os.O_APPEND)
    for descriptor in (1, 2):
        os.dup2(console, descriptor)
    os.close(console)
    sys.argv[1:] = arguments
    typer.run(serve)
