"""A worker that is killed, a scheduler that is lost, and a store that does not answer."""

import os
import subprocess
import sys
import threading
import time
from collections.abc import Callable
from pathlib import Path

import pytest

pytest.importorskip("distributed")
pytest.importorskip("moto")
pytest.importorskip("s3fs")

from app.archive.archive import Archive
from app.archive.archive_settings import ArchiveSettings
from app.archive.pace import full_speed
from app.formats.datasheets.arm import read_any_arm
from app.formats.results.calibration import read_calibration
from app.workflows.reconstruct import reconstruct_cloud
from tests.archive.filled import lists_of
from tests.archive.s3 import BUCKET, CuttingProxy, S3Server
from tests.batch.dask_processes import DaskProcesses
from tests.batch.filled import CALIBRATION, fill_station

pytestmark = pytest.mark.slow
CRENEL = Path(sys.executable).with_name("crenel")
SCANS = tuple(f"scan-{number}" for number in range(10))
DEADLINE_S = 200.0


def fill_store(data: Path, server: S3Server) -> None:
    """An archive in the S3 store, of a station with scans."""
    (data.parent / "secret").write_text("secret\n")
    given = {
        "url": f"s3://{BUCKET}/room-2",
        "endpoint": server.url,
        "access_key": "key",
        "secret_file": "secret",
    }
    settings = ArchiveSettings.model_validate(given, context=data.parent / "station.toml")
    store = fill_station(data, SCANS, 100)
    try:
        Archive(settings, data, lists_of(store), full_speed()).run()
    finally:
        store.close()


class Command:
    """``crenel`` in a process of its own, and what it says."""

    def __init__(self, environment: dict[str, str], *arguments: str) -> None:
        self._process = subprocess.Popen(
            [CRENEL, *arguments], env=environment, stderr=subprocess.PIPE, text=True
        )
        self.said: list[str] = []
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()

    def wait_for(self, what: str, holds: Callable[[], bool]) -> None:
        """Until a condition holds; fails if the command ends before."""
        deadline_s = time.monotonic() + DEADLINE_S
        while not holds():
            assert self._process.poll() is None, (what, self.said)
            assert time.monotonic() < deadline_s, (what, self.said)
            time.sleep(0.2)

    def wait_for_text(self, text: str) -> None:
        self.wait_for(text, lambda: any(text in line for line in self.said))

    def wait(self) -> int:
        status = self._process.wait(DEADLINE_S)
        self._reader.join(DEADLINE_S)
        return status

    def close(self) -> None:
        self._process.kill()
        self._process.wait()

    def _read(self) -> None:
        assert self._process.stderr is not None
        with self._process.stderr as lines:
            self.said.extend(lines)


def test_every_result_is_there_once_whatever_is_lost(tmp_path: Path) -> None:
    with S3Server() as server:
        fill_store(tmp_path / "data", server)
        proxy = CuttingProxy(server.port, 1)
        proxy.restore(float("inf"))
        environment = {
            **os.environ,
            "AWS_ENDPOINT_URL": f"http://127.0.0.1:{proxy.port}",
            "AWS_ACCESS_KEY_ID": "key",
            "AWS_SECRET_ACCESS_KEY": "secret",
            "AWS_DEFAULT_REGION": "us-east-1",
        }
        dask = DaskProcesses(tmp_path, environment)
        dask.start_scheduler()
        dask.start_worker()
        dask.start_worker()
        output = ("-o", f"s3://{BUCKET}/clouds")
        places = (f"s3://{BUCKET}/room-2", *output, "--scheduler", dask.address)
        command = Command(environment, "rebuild", *places)

        def results() -> int:
            listed = server.client.list_objects_v2(Bucket=BUCKET, Prefix="clouds/")
            return sum(one["Key"].endswith(".json") for one in listed.get("Contents", ()))

        try:
            command.wait_for("the first result", lambda: results() >= 1)
            proxy.restore(0)  # no connection goes on, and none is taken
            command.wait_for_text("meanwhile the work waits")
            dask.kill_worker()
            proxy.restore(float("inf"))
            command.wait_for("results without a worker", lambda: results() >= 3)
            dask.kill_scheduler()
            command.wait_for_text("is lost")
            dask.start_scheduler()
            dask.start_worker()
            dask.start_worker()
            assert command.wait() == 0, command.said
        finally:
            command.close()
            dask.close()
            proxy.close()
        check_clouds(server.content("clouds/"), tmp_path)


def check_clouds(content: dict[str, bytes], tmp_path: Path) -> None:
    """Each scan has one document and one cloud, which is that of its recording."""
    assert len(content) == 2 * len(SCANS)
    session = tmp_path / "data/sessions" / CALIBRATION
    calibration = read_calibration(session / "calibration.json")
    arm = read_any_arm(session / "arm.json")
    for scan_id in SCANS:
        (document,) = (
            name for name in content if name.startswith(f"room-2-{scan_id}-") and ".json" in name
        )
        direct = tmp_path / "direct.ply"
        recording = tmp_path / "data/scans" / scan_id / "scan.mcap"
        reconstruct_cloud(recording, calibration, arm, direct)
        assert content[document.replace(".json", ".ply")] == direct.read_bytes()
