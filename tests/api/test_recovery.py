"""Scans whose process was killed, or whose disk was full: listed, whole, with their clouds."""

import os
import signal
from collections.abc import Callable
from pathlib import Path
from typing import Any

import httpx
import pytest

from app.formats.clouds.files import read_cloud
from app.formats.recording.raw import MAGIC
from app.store.store import Store
from tests.api.conftest import wait_for
from tests.api.processes import demonstration
from tests.formats.test_recording_bombs import LARGE, lz4_zeros, zstd
from tests.sent_texts import english

pytestmark = [pytest.mark.device, pytest.mark.usefixtures("fork_server")]

Scan = dict[str, Any]


def until(http: httpx.Client, path: str, enough: Callable[[Any], bool]) -> Any:
    return wait_for(lambda: http.get(path).json(), enough)


def health(http: httpx.Client, name: str) -> Scan:
    items = http.get("/api/health").json()["health"]["items"]
    return next(dict(item) for item in items if item["id"] == name)


def test_scans_under_way_when_the_process_dies_are_listed_with_their_clouds(tmp_path: Path) -> None:
    with demonstration(tmp_path, calibrated=True) as (http, pid):
        until(http, "/api/scan", lambda scan: scan["state"] == "idle")
        http.post("/api/scan/start", json={"name": "Bracket"}).raise_for_status()
        http.post("/api/scan/simulation", json={"on": True}).raise_for_status()
        before = until(http, "/api/scan", lambda scan: scan["seconds"] > 2.0)
        os.kill(pid, signal.SIGKILL)
    scans = tmp_path / "scans"
    (folder,) = scans.iterdir()
    (scans / ".deleted-20260101-000000").mkdir()
    assert list(folder.glob(".*.part")), "the cloud's part was left"
    with demonstration(tmp_path, calibrated=True) as (http, _):
        (scan,) = http.get("/api/scans").json()
        assert scan["name"] == "Bracket"
        assert english(scan["note"]).startswith("The station ended during this scan.")
        (scan,) = until(http, "/api/scans", lambda scans: scans[0]["points"] > 0)
        assert english(scan["note"]).endswith("All recorded data is kept.")
        # what was shown less than half a second before may be lost
        assert scan["frames"] > 0.5 * before["frames"]
        assert len(read_cloud(folder / "cloud.ply").points_mm) == scan["points"]
        names = [folder.name, "cloud.ply", "scan.mcap"]
        assert sorted(path.name for path in scans.rglob("*")) == sorted(names)
        assert health(http, "recordings")["quality"] == "good"
        (folder / "scan.mcap").write_bytes((folder / "scan.mcap").read_bytes()[:-1])
        assert "is incomplete" in english(http.get("/api/scans").json()[0]["note"])
        (folder / "scan.mcap").unlink()
        assert "is missing" in english(http.get("/api/scans").json()[0]["note"])
    (folder / "scan.mcap").write_bytes(b"")
    with demonstration(tmp_path, calibrated=True) as (http, _):
        (scan,) = http.get("/api/scans").json()
        assert english(scan["note"]) == "The recording is empty."
        item = health(http, "recordings")
        assert item["quality"] == "bad"
        assert english(item["what"]) == "Bracket: the recording is empty."
    store = Store(tmp_path)
    assert store.check() == ""
    store.close()


def test_recordings_that_open_to_gigabytes_hold_up_no_start(tmp_path: Path) -> None:
    Store(tmp_path).close()
    bombs = {"lz4": lz4_zeros(LARGE, LARGE), "zstd": zstd(LARGE, LARGE), "holes": b"\1"}
    for name, bomb in bombs.items():
        (tmp_path / "scans" / name).mkdir(parents=True)
        (tmp_path / "scans" / name / "scan.mcap").write_bytes(MAGIC + bomb)
    os.truncate(tmp_path / "scans" / "holes" / "scan.mcap", 1 << 40)
    with demonstration(tmp_path, calibrated=True) as (http, pid):
        scans = http.get("/api/scans").json()
        assert {scan["name"] for scan in scans} == set(bombs)
        said = "Its points cannot be computed"
        until(http, "/api/scans", lambda scans: all(said in english(one["note"]) for one in scans))
        status = Path(f"/proc/{pid}/status").read_text()
        assert int(status.split("VmHWM:")[1].split()[0]) < 1_500_000
