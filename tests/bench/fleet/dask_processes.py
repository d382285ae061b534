"""A scheduler and workers of Dask as processes, as an administrator starts them."""

import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path

from tests.bench.station.subprocess_station import free_port

STARTED_MODULES = ()  # programs of others

DEADLINE_S = 60.0


class DaskProcesses:
    """A scheduler on a fixed port, and workers that can be lost."""

    def __init__(self, folder: Path, environment: Mapping[str, str]) -> None:
        self._port = free_port()
        self._folder, self._environment = folder, dict(environment)
        self._scheduler: subprocess.Popen[bytes] | None = None
        self._workers: list[subprocess.Popen[bytes]] = []

    @property
    def address(self) -> str:
        """Of the scheduler."""
        return f"tcp://127.0.0.1:{self._port}"

    def start_scheduler(self) -> None:
        """Starts the scheduler, also again on its port."""
        host = ("--host", "127.0.0.1", "--port", f"{self._port}")
        self._scheduler = self._start("scheduler", *host, "--no-dashboard")

    def start_worker(self) -> None:
        """Starts one more worker with one thread."""
        options = ("--nthreads", "1", "--no-dashboard", "--no-nanny", "--death-timeout", "120")
        place = ("--local-directory", str(self._folder))
        self._workers.append(self._start("worker", self.address, *options, *place))

    def kill_worker(self) -> None:
        """Ends the oldest one, as the kernel does when there is no memory."""
        lost = self._workers.pop(0)
        lost.kill()
        lost.wait(DEADLINE_S)

    def kill_scheduler(self) -> None:
        """Its workers notice, and end."""
        if self._scheduler is not None:
            self._scheduler.kill()
            self._scheduler.wait(DEADLINE_S)

    def close(self) -> None:
        """Ends all of them; idempotent."""
        for process in (*self._workers, self._scheduler):
            if process is not None:
                process.kill()
                process.wait(DEADLINE_S)

    def _start(self, *arguments: str) -> subprocess.Popen[bytes]:
        return subprocess.Popen(
            [sys.executable, "-m", "dask", *arguments],
            env=self._environment,
            cwd=self._folder,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
