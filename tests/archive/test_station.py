"""A station with an archive, in its pages and on the command line."""

import json
import os
import time
from collections.abc import Callable
from contextlib import AbstractContextManager
from pathlib import Path
from typing import Any

import httpx
import pytest
from typer.testing import CliRunner

from crenel.archive.archive_settings import ArchiveSettings
from crenel.cli.main import cli
from crenel.formats.datasheets.arm import read_any_arm
from crenel.formats.recording.raw import MAGIC
from crenel.formats.results.calibration import read_calibration
from crenel.operations.services import MonitoringSettings
from crenel.store.store import Store
from crenel.workflows.reconstruct import reconstruct_cloud
from tests.api.conftest import Server, running_server
from tests.archive.filled import add_scan, check_whole, content_of
from tests.batch.filled import CALIBRATION, fill_station
from tests.sent_texts import english

DEADLINE_S = 120.0


def add_old_scan(store: Store, scan_id: str) -> Path:
    """A scan that was recorded a hundred days ago."""
    folder = add_scan(store, scan_id, 3000)
    (folder / "scan.mcap").write_bytes(MAGIC + bytes(3000) + MAGIC)
    for path in folder.iterdir():
        seconds = time.time() - 100 * 86_400
        os.utime(path, (seconds, seconds))
    return folder


def settings_file(top: Path, more: str) -> Path:
    file = top / "station.toml"
    file.write_text(f'[station]\ndata = "data"\n{more}')
    return file


def until(http: httpx.Client, path: str, ready: Callable[[Any], bool]) -> Any:
    deadline_s = time.monotonic() + DEADLINE_S
    while not ready(found := http.get(path).json()):
        assert time.monotonic() < deadline_s, found
        time.sleep(0.1)
    return found


def archiving_server(store: Store, place: Path) -> AbstractContextManager[Server]:
    """A station that keeps what it archives for 90 days."""
    rules = {"url": str(place), "keep_days": 90}
    settings = ArchiveSettings.model_validate(rules, context=place.parent / "station.toml")
    return running_server(store.folder, monitoring=MonitoringSettings(archive=settings))


def findings(view: Any) -> dict[str, Any]:
    return {item["id"]: item for item in view["health"]["items"]}


@pytest.mark.device
def test_a_scan_that_left_the_disk_is_listed_and_comes_back(store: Store, place: Path) -> None:
    folder = add_old_scan(store, "old")
    before = content_of(folder)
    store.close()
    with archiving_server(store, place) as server:
        (scan,) = until(server.http, "/api/scans", lambda scans: bool(scans[0]["note"]))
        assert english(scan["note"]).endswith("crenel archive fetch scans old")
        assert not folder.exists()
        health = findings(
            until(server.http, "/api/health", lambda view: "archive" in findings(view))
        )
        for name in ("archive", "recordings", "records"):
            assert health[name]["quality"] == "good", health[name]
        assert health["archive-disk"]["quality"] == "attention"
        assert english(health["archive-disk"]["what"]).startswith(f"The archive {place} is on the")
        missing = server.http.get("/api/scans/old/cloud.ply")
        assert missing.status_code == 404
        assert "crenel archive fetch" in missing.text
        assert scan["away"]
        assert server.http.post("/api/scans/old/fetch").status_code == 202
        (scan,) = until(server.http, "/api/scans", lambda scans: not scans[0]["away"])
        assert content_of(folder) == before
        assert scan["note"] == ""
        assert server.http.get("/api/scans/old/cloud.ply").content == before["cloud.ply"]


@pytest.mark.slow
def test_commands_fill_verify_and_read_archives(store: Store, tmp_path: Path, place: Path) -> None:
    folder = add_old_scan(store, "old")
    before = content_of(folder)
    file = settings_file(tmp_path, f'[archive]\nurl = "{place}"\nkeep_days = 90\n')

    def run(*words: str, status: int = 0) -> str:
        done = CliRunner().invoke(cli, ["archive", *words, "--config", str(file)])
        assert done.exit_code == status, done.output
        return done.output

    assert json.loads(run("status", "--json"))["waiting"] == 1
    assert "1 record copied" in run("run")
    state = json.loads(run("status", "--json"))
    assert (state["waiting"], [one["id"] for one in state["in_archive_only"]]) == (0, ["old"])
    assert "scans old" in run("status")
    assert "whole" in run("verify")
    run("fetch", "scans", "old")
    assert content_of(folder) == before
    assert "already" in run("fetch", "scans", "old", status=1)
    run("fetch", "photos", "old", status=2)
    run("fetch", "scans", "../old", status=2)
    assert "every copy read there since" in run("status")
    (copy,) = place.glob("scans/old/*/scan.mcap")
    copy.unlink()
    assert "or of another size: scans/old/" in run("status", status=1)
    incomplete = json.loads(run("status", "--json", status=1).partition("\ncrenel:")[0])
    assert incomplete["look"]["incomplete"] == [copy.relative_to(place).as_posix()]
    assert "scan.mcap" in run("verify", status=1)
    run("run")
    assert len(check_whole(content_of(place))) == 1
    place.rename(place.with_name("away"))
    answer = run("status", status=1)
    assert "archived and here" in answer
    assert "is not there" in answer
    settings_file(tmp_path, "")
    assert "names no archive" in run("status", status=1)


@pytest.mark.device
def test_a_scan_that_comes_back_without_a_cloud_gets_it_again(tmp_path: Path, place: Path) -> None:
    store = fill_station(tmp_path / "data", ["old"])
    session, folder = tmp_path / "data/sessions" / CALIBRATION, tmp_path / "data/scans/old"
    figures = {"total_um": 20.0, "verdict": "good"}
    serials = {"arm_serial": "A-1", "object_serial": "", "sensor_serial": "S-1"}
    file = session / "calibration.json"
    store.calibrations.accept(CALIBRATION, "May", file, figures | serials, None)
    expected = tmp_path / "expected.ply"
    calibration, arm = read_calibration(file), read_any_arm(session / "arm.json")
    reconstruct_cloud(folder / "scan.mcap", calibration, arm, expected)
    recorded_s = (folder / "scan.mcap").stat().st_mtime
    os.utime(folder / "cloud.ply", (recorded_s, recorded_s))
    store.close()
    with archiving_server(store, place) as server:
        until(server.http, "/api/scans", lambda scans: scans[0]["away"])
        assert not list(place.glob("scans/old/*/cloud.ply"))
        assert server.http.post("/api/scans/old/fetch").status_code == 202
        until(
            server.http, "/api/scans", lambda scans: not scans[0]["away"] and not scans[0]["note"]
        )
        made = server.http.get("/api/scans/old/cloud.ply")
        assert made.content == expected.read_bytes()
        health = until(server.http, "/api/health", lambda view: "archive" in findings(view))
        assert findings(health)["archive"]["quality"] == "good"
