"""``crenel rebuild`` as a process, on a scheduler and workers that are lost while it runs, from a
store that is away for a while."""

import json
import os
import subprocess
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from crenel.messages.message import message
from crenel.progress import Progress, no_progress
from tests.bench.fleet.dask_processes import DaskProcesses
from tests.bench.fleet.recording_stations import KEY, SECRET
from tests.bench.fleet.s3_server import BUCKET, CuttingProxy, S3Server
from tests.bench.station.started import failure_error
from tests.bench.station.subprocess_station import stuck_error

CLOUDS = "clouds/"
"""In the bucket: what is rebuilt."""
WORKERS = 2
LOOK_S = 0.2
PATIENCE_S = 900.0
"""Without anything that was waited for."""
STORE_LOST_AT, WORKER_LOST_AT, SCHEDULER_LOST_AT = 0.1, 0.2, 0.5
"""Shares of the recordings that are rebuilt by then."""


@dataclass(frozen=True)
class RebuildRun:
    """What the command said and printed."""

    printed: dict[str, Any]
    said: str
    seconds: float


def rebuild_with_losses(
    server: S3Server,
    proxy: CuttingProxy,
    folder: Path,
    source: str,
    recordings: int,
    away_s: float,
    progress: Progress = no_progress,
) -> RebuildRun:
    """Rebuilds all recordings, while the store is away, a worker is killed, and the scheduler is.

    Only the scheduler and the workers are started again, as a supervisor does; the command is not.

    Args:
        proxy: between the store and everything else; it forwards all.
        folder: for the processes' own files.
        source: in the bucket: an archive, or what several are in.
        recordings: that are rebuilt.
        away_s: for so long the store is away, and longer until the command notices.

    Raises:
        OperationError: the command fails, ends before everything was lost, or does not go on.
    """
    environment = {
        **os.environ,
        "AWS_ENDPOINT_URL": f"http://127.0.0.1:{proxy.port}",
        "AWS_ACCESS_KEY_ID": KEY,
        "AWS_SECRET_ACCESS_KEY": SECRET,
        "AWS_DEFAULT_REGION": "us-east-1",
    }

    def count_results() -> int:
        return sum(name.endswith(".json") for name in server.names(CLOUDS))

    def wait_for_results(share: float) -> None:
        def are_there() -> bool:
            found = count_results()
            progress(found / recordings, f"{found} of {recordings} rebuilt")
            return found >= max(share * recordings, 1)

        command.wait_for(f"{share:.0%} of all results", are_there)

    dask = DaskProcesses(folder, environment)
    try:
        dask.start_scheduler()
        for _ in range(WORKERS):
            dask.start_worker()
        places = (f"s3://{BUCKET}/{source}", "-o", f"s3://{BUCKET}/{CLOUDS}".rstrip("/"))
        command = _RebuildCommand(folder, environment, *places, "--scheduler", dask.address)
        try:
            wait_for_results(STORE_LOST_AT)
            proxy.restore(0)  # no connection goes on, and none is taken
            began_s = time.monotonic()
            command.wait_for_text(str(message("batch-store-away", why="")))
            time.sleep(max(began_s + away_s - time.monotonic(), 0.0))
            proxy.restore(float("inf"))
            wait_for_results(WORKER_LOST_AT)
            dask.kill_worker()
            wait_for_results(SCHEDULER_LOST_AT)
            dask.kill_scheduler()
            command.wait_for_text(str(message("batch-scheduler-away", address=dask.address)))
            dask.start_scheduler()
            for _ in range(WORKERS):
                dask.start_worker()
            return command.wait(lambda: wait_for_results(0.0))
        finally:
            command.close()
    finally:
        dask.close()


class _RebuildCommand:
    def __init__(self, folder: Path, environment: dict[str, str], *arguments: str) -> None:
        self._printed, self._said = folder / "printed.json", folder / "said.txt"
        self._began_s = time.monotonic()
        crenel = Path(sys.executable).with_name("crenel")
        with self._printed.open("w") as printed, self._said.open("w") as said:
            self._process = subprocess.Popen(
                [crenel, "rebuild", *arguments, "--json"],
                env=environment,
                cwd=folder,
                stdout=printed,
                stderr=said,
            )

    def wait_for(self, what: str, holds: Callable[[], bool]) -> None:
        """Until a condition holds; raises ``OperationError`` if the command ends before."""
        deadline_s = time.monotonic() + PATIENCE_S
        while not holds():
            if self._process.poll() is not None:
                raise failure_error(f"crenel rebuild ended before {what}", self._said.read_text())
            if time.monotonic() > deadline_s:
                raise stuck_error(f"crenel rebuild does not get to {what}", PATIENCE_S)
            time.sleep(LOOK_S)

    def wait_for_text(self, text: str) -> None:
        """Until the command said so."""
        self.wait_for(f"'{text}'", lambda: text in self._said.read_text())

    def wait(self, look: Callable[[], None]) -> RebuildRun:
        """Until it ends; ``look`` is called meanwhile.

        Raises:
            OperationError: it printed no result, or does not end.
        """
        deadline_s = time.monotonic() + PATIENCE_S
        while self._process.poll() is None:
            if time.monotonic() > deadline_s:
                raise stuck_error("crenel rebuild does not end", PATIENCE_S)
            look()
            time.sleep(LOOK_S)
        taken_s, said = time.monotonic() - self._began_s, self._said.read_text()
        printed = self._printed.read_text()
        if not printed:
            raise failure_error("crenel rebuild failed", said)
        return RebuildRun(json.loads(printed), said, taken_s)

    def close(self) -> None:
        self._process.kill()
        self._process.wait()
