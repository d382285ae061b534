"""The benches of a station, its start, viewers and cameras, at paces that any machine keeps."""

import math
import os
import shutil
from contextlib import nullcontext
from multiprocessing.connection import Connection
from pathlib import Path
from types import SimpleNamespace

import pytest

from crenel.errors import OperationError
from crenel_hardware.simulator.devices.fast_simulator import FastStationConfig
from tests.bench.station import camera, live, start, view, viewers
from tests.bench.station import subprocess_station as apart
from tests.bench.station.start import Rounds, StartRow, columns, run, table
from tests.bench.station.started import InstalledCopy, find_copy
from tests.hardware.fake_cameras import port_for_this_test

pytestmark = [pytest.mark.device, pytest.mark.soak]

PACE = FastStationConfig(profiles_hz=20.0, width_px=500, height_px=128)
COMPILES = """#!/bin/sh
if [ ! -e "$PYTHONPYCACHEPREFIX" ]; then sleep 0.3; mkdir "$PYTHONPYCACHEPREFIX"; fi
"""
"""As a program that is slow only while its caches are empty."""


def test_a_scan_is_recorded_whole_and_seen_by_its_viewers() -> None:
    found = live.run(PACE, 4.0)
    assert found.frames_lost == found.frames_without_joints == 0
    assert found.frames_recorded > 40
    # a stripe that ends at the picture's border may lack its last columns
    assert found.points >= 0.95 * PACE.width_px * found.frames_recorded
    assert 0 < found.age_median_s <= found.age_95_s < 20
    assert found.join_s > 0
    assert found.recording_mb_s > 0
    assert len(live.table(found)) == 8


def test_viewers_get_states_pictures_and_points_while_one_takes_nothing() -> None:
    found = viewers.run(PACE, 3, 6.0)
    assert found.states > 20
    assert 0 < found.age_median_s <= found.age_95_s
    assert found.pictures_hz > 0
    assert found.view_mb_s > 0
    assert found.lost_alone == found.lost_watched == 0
    assert len(viewers.table(found)) == 5


def test_a_second_viewer_gets_all_and_the_colours_change() -> None:
    points = 8 * view.PIECE
    found = view.run(points)
    assert found.points == points
    assert 50_000 < found.points_displayed <= points
    assert found.join_s > 0
    assert found.join_mb > 15 * found.points_displayed / 2**20
    assert 0 < found.recolour_s < 60
    assert len(view.table(found)) == 5


def test_what_a_camera_loses_is_counted() -> None:
    if shutil.which(camera.PROGRAM) is None:
        pytest.skip("aravis-tools is not installed")
    with port_for_this_test():
        found = camera.run(3.0, 30.0, 5)
    assert 0 < found.whole < found.sent
    assert found.lost > 0
    assert found.unaccounted == 0
    assert 0 < found.age_median_s <= found.age_99_s
    assert dict(camera.table(found))["neither received nor counted"] == "0"


def script(folder: Path, text: str) -> Path:
    place = folder / ".venv" / "bin" / "crenel"
    place.parent.mkdir(parents=True)
    place.write_text(text)
    place.chmod(0o755)
    return place


def test_only_warm_rounds_find_leftovers(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    rested = SimpleNamespace(ready_s=lambda: 0.0, idle_mb=lambda: 200.0)
    monkeypatch.setattr(start, "_demo", lambda *_, **__: iter(()))
    monkeypatch.setattr(start, "DemoProcess", lambda *_: nullcontext(rested))
    monkeypatch.setattr(InstalledCopy, "size_mb", lambda self: 500.0)
    (tmp_path / "session" / "images").mkdir(parents=True)
    script(tmp_path / "one", COMPILES)
    copies = [find_copy("this", tmp_path / "one"), find_copy("against", tmp_path / "one")]
    rows = {row.measure: row for row in run(copies, Rounds(2, 2, 0), tmp_path / "session")}
    for copy in copies:
        for command in ("crenel --help", "crenel calibrate --method one-pose"):
            assert rows[f"cold: {command}"].figures[copy.name][1] > 0.3
            assert rows[f"warm: {command}"].figures[copy.name][1] < 0.3
    assert rows["idle station: RSS"].unit == rows["installed size"].unit == "MB"


def test_a_table_has_each_copy_beside_the_others() -> None:
    rows = [
        StartRow("cold: ready", "s", {"this": (2.0, 1.5, 3.0), "against": (90.0, 90.0, 90.0)}),
        StartRow("cold: devices lost", "", {"this": (0.0, 0.0, 0.0), "against": (3.0, 3.0, 3.0)}),
    ]
    assert table(rows) == [
        ("cold: ready", "2.00 s (1.50–3.00)", "90.00 s"),
        ("cold: devices lost", "0", "3"),
    ]
    copies = [InstalledCopy("this", Path("crenel")), InstalledCopy("against", Path("crenel"))]
    assert columns(copies) == ("measure", "this", "against")


def test_a_command_that_fails_is_reported_with_its_last_line(tmp_path: Path) -> None:
    executable = script(tmp_path, "#!/bin/sh\necho no such session >&2\nexit 1\n")
    with pytest.raises(OperationError, match="crenel calibrate failed: no such session"):
        find_copy("this", executable).seconds(tmp_path, "calibrate")


def test_a_copy_that_is_not_there_is_refused(tmp_path: Path) -> None:
    with pytest.raises(OperationError, match="no such program"):
        find_copy("against", tmp_path)


def _gone(pipe: Connection) -> None:
    pipe.send("ready")


def _silent(pipe: Connection) -> None:
    pipe.recv()


def test_a_station_that_ends_is_reported() -> None:
    with (
        pytest.raises(OperationError, match="the station under test does not respond"),
        apart.run_in_process(_gone) as (pipe, _),
    ):
        list(iter(pipe.recv, None))


def test_a_station_that_does_not_start_is_reported(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(apart, "PATIENCE_S", 0.1)
    with (
        pytest.raises(OperationError, match=r"does not start.*nothing came of it in") as reported,
        apart.run_in_process(_silent),
    ):
        pass
    assert "a file" not in reported.value.line


def test_the_memory_of_a_process_is_reported() -> None:
    assert apart.memory_mb(os.getpid()) > 10
    assert math.isnan(apart.memory_mb(1 << 30))
