"""``crenel rebuild`` on this machine."""

import contextlib
import json
import os
import sys
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import pytest
from fsspec.implementations.memory import MemoryFileSystem

pytest.importorskip("distributed")

from crenel.batch.period import Period, parse_period
from crenel.batch.places import find_places, settings_for
from crenel.batch.rebuild import RebuildTask, plan_rebuild
from crenel.batch.recordings import Selection
from crenel.batch.results import ResultStore
from crenel.batch.task import perform
from crenel.errors import OperationError
from crenel.formats.clouds.files import read_cloud
from crenel.formats.datasheets.arm import read_any_arm
from crenel.formats.open_file import LARGEST_DOCUMENT
from crenel.formats.results.calibration import read_calibration
from crenel.workflows.reconstruct import reconstruct_cloud
from tests.batch.filled import CALIBRATION, archive_and_close, fill_archive, fill_station
from tests.cli.test_cli import crenel, refused
from tests.present import present

pytestmark = pytest.mark.device

SCANS = ("one", "two", "three")
CRENEL = Path(sys.executable).with_name("crenel")


def run(*arguments: object, cwd: Path, status: int = 0) -> dict[str, Any]:
    with contextlib.chdir(cwd):
        ran = crenel(*map(str, arguments), "--json")
    assert ran.exit_code == status, ran.output
    found: dict[str, Any] = json.loads(ran.stdout)
    return found


def plan(
    place: Path | str, output: Path, selection: Selection | None = None
) -> tuple[list[RebuildTask], ResultStore]:
    results = ResultStore(settings_for(str(output)))
    results.prepare()
    places = find_places([str(place)])
    made = plan_rebuild(places, selection or Selection(), results.settings, ".ply")
    assert made.refused == []
    return made.tasks, results


@pytest.fixture
def archive(tmp_path: Path) -> Path:
    fill_archive(tmp_path / "plant" / "room-2", tmp_path / "data", SCANS)
    return tmp_path / "plant" / "room-2"


def direct_cloud(data: Path, scan_id: str) -> bytes:
    """The cloud of a scan in a data folder, reconstructed from its recording alone."""
    session, target = data / "sessions" / CALIBRATION, data.with_name("direct.ply")
    calibration = read_calibration(session / "calibration.json")
    arm = read_any_arm(session / "arm.json")
    reconstruct_cloud(data / "scans" / scan_id / "scan.mcap", calibration, arm, target)
    return target.read_bytes()


def test_every_cloud_is_made_once_and_as_its_recording_is(archive: Path, tmp_path: Path) -> None:
    made = run("rebuild", archive, "-o", "clouds", "--workers", 2, cwd=tmp_path)
    assert (made["made"], made["already_there"], made["refused"]) == (3, 0, {})
    clouds = sorted((tmp_path / "clouds").glob("*.ply"))
    for cloud, scan_id in zip(clouds, sorted(SCANS), strict=True):
        assert cloud.name.startswith(f"room-2-{scan_id}-")
        assert cloud.read_bytes() == direct_cloud(tmp_path / "data", scan_id)
    before = {path: path.stat().st_mtime_ns for path in (tmp_path / "clouds").iterdir()}
    assert len(before) == 6
    # the plant, in which the archive is; and the station's own folder: the same recordings
    again = run("rebuild", archive.parent, "data", "-o", "clouds", cwd=tmp_path)
    assert (again["made"], again["already_there"]) == (0, 6)
    assert {path: path.stat().st_mtime_ns for path in (tmp_path / "clouds").iterdir()} == before


def test_recordings_are_chosen_by_period_station_and_use(archive: Path, tmp_path: Path) -> None:
    def chosen(selection: Selection) -> list[str]:
        return [task.recording.id for task in plan(archive, tmp_path / "out", selection)[0]]

    assert chosen(Selection()) == sorted(SCANS)
    assert chosen(Selection(period=parse_period("2026-05-02..2026-05-03"))) == ["three", "two"]
    assert chosen(Selection(period=parse_period("2027"))) == []
    assert chosen(Selection(stations=frozenset({"room-3"}))) == []
    assert chosen(Selection(taken_with=frozenset({CALIBRATION}))) == sorted(SCANS)
    assert chosen(Selection(taken_with=frozenset({"another"}))) == []


def test_another_calibration_or_format_is_another_result(archive: Path, tmp_path: Path) -> None:
    tasks, results = plan(archive, tmp_path / "out")
    assert perform(tasks[0], tmp_path, 1).state == "done"
    assert results.whole_keys({task.key[:16] for task in tasks}) == {tasks[0].key[:16]}
    calibration = tmp_path / "data/sessions" / CALIBRATION / "calibration.json"
    calibration.write_text(calibration.read_text().replace("0.25", "0.35"))
    given = tmp_path / "given"
    args = ("--calibration", calibration, "-o", given)
    assert run("rebuild", archive, *args, "--period", "2026-05-01", cwd=tmp_path)["made"] == 1
    (document,) = given.glob("*.json")
    assert document.stem.rpartition("-")[2] not in {task.key[:16] for task in tasks}
    (cloud,), (before,) = given.glob("*.ply"), (tmp_path / "out").glob("*.ply")
    assert abs(read_cloud(cloud).points_mm - read_cloud(before).points_mm).max() > 0.01


def test_a_result_that_is_damaged_later_is_made_again(tmp_path: Path) -> None:
    """A cloud that was removed, one that was cut off, and a document that was; one is whole."""
    archive = tmp_path / "plant" / "room-2"
    fill_archive(archive, tmp_path / "data", (*SCANS, "whole"))
    tasks, results = plan(archive, tmp_path / "out")
    for task in tasks:
        assert perform(task, tmp_path, 1).state == "done"
    before = {path: path.read_bytes() for path in (tmp_path / "out").iterdir()}
    removed, cut, without_end, whole = (task.stem for task in tasks)
    (tmp_path / "out" / f"{removed}.ply").unlink()
    for damaged in (f"{cut}.ply", f"{without_end}.json"):
        path = tmp_path / "out" / damaged
        os.truncate(path, path.stat().st_size - 10)
    keys = {task.stem: task.key[:16] for task in tasks}
    assert results.whole_keys(set(keys.values())) == {keys[whole]}
    made = run("rebuild", archive, "-o", "out", "--workers", 1, cwd=tmp_path)
    assert (made["made"], made["already_there"]) == (3, 1)
    assert {path: path.read_bytes() for path in (tmp_path / "out").iterdir()} == before


def test_a_cloud_that_a_store_lost_is_made_again(archive: Path, tmp_path: Path) -> None:
    files = MemoryFileSystem()
    results = ResultStore(settings_for("memory://lost-clouds"))
    tasks = plan_rebuild(find_places([str(archive)]), Selection(), results.settings, ".ply").tasks
    assert perform(tasks[0], tmp_path, 1).state == "done"
    assert results.read(tasks[0].stem) is not None
    cloud = f"/lost-clouds/{tasks[0].stem}.ply"
    files.pipe_file(cloud, files.cat_file(cloud)[:-1])
    assert results.read(tasks[0].stem) is None
    files.rm_file(cloud)
    assert results.read(tasks[0].stem) is None
    assert perform(tasks[0], tmp_path, 1).state == "done"
    assert files.size(cloud) == results.read(tasks[0].stem)["cloud_bytes"]  # type: ignore[index]


def test_recordings_of_other_devices_are_left_out(archive: Path, tmp_path: Path) -> None:
    calibration = tmp_path / "data/sessions" / CALIBRATION / "calibration.json"
    calibration.write_text(calibration.read_text().replace("S-1", "S-2"))
    found = run("rebuild", archive, "--calibration", calibration, cwd=tmp_path)
    assert (found["made"], found["of_other_devices"]) == (0, 3)


def test_what_cannot_be_rebuilt_is_named_and_the_rest_is_made(tmp_path: Path) -> None:
    fill_station(tmp_path / "data", SCANS).close()
    damaged = tmp_path / "data/scans/two/scan.mcap"
    damaged.write_bytes(b"no recording")
    os.utime(damaged, (0, 0))
    found = run("rebuild", "data", "-o", "out", "--workers", 1, cwd=tmp_path, status=3)
    assert found["made"] == 2
    assert list(found["refused"]) == ["data/two"]
    left = sorted(path.suffix for path in (tmp_path / "out").iterdir())
    assert left == [".json", ".json", ".ply", ".ply"]
    alone = ("rebuild", "data", "-o", "out2", "--record", "two", "--workers", 1)
    assert run(*alone, cwd=tmp_path, status=1)["made"] == 0


def test_a_recording_that_an_archive_lost_hinders_no_other(archive: Path, tmp_path: Path) -> None:
    (lost,) = archive.glob("scans/two/*/scan.mcap")
    lost.unlink()
    found = run("rebuild", archive, "-o", "out", "--workers", 1, cwd=tmp_path, status=3)
    assert found["made"] == 2
    assert list(found["refused"]) == ["room-2/two"]


def test_a_damaged_recording_of_a_store_is_named_by_its_address(tmp_path: Path) -> None:
    place = tmp_path / "room-2"
    store = fill_station(tmp_path / "data", ["one"])
    (tmp_path / "data/scans/one/scan.mcap").write_bytes(b"no recording")
    archive_and_close(store, place)
    tasks, _ = plan(f"file://{place}", tmp_path / "out")
    refusal = present(perform(tasks[0], tmp_path, 1).refusal)
    (record,) = place.glob("scans/one/*")
    named = f"file://{place}/scans/one/{record.name}/scan.mcap: "
    assert refusal.error().line.startswith(named)


def test_a_calibration_that_is_damaged_is_named_and_no_temporary_file(tmp_path: Path) -> None:
    fill_station(tmp_path / "data", SCANS).close()
    (tmp_path / "data/sessions" / CALIBRATION / "arm.json").write_text("{")
    tasks, _ = plan(tmp_path / "data", tmp_path / "out")
    refusal = present(perform(tasks[0], tmp_path, 1).refusal)
    line = refusal.error().line
    said = f"The calibration {CALIBRATION} cannot be used: arm.json: it is not JSON"
    assert line.startswith(said)
    assert str(tmp_path) not in line


def test_a_place_that_is_away_is_no_refusal(archive: Path, tmp_path: Path) -> None:
    tasks, _ = plan(archive, tmp_path / "out")
    archive.rename(tmp_path / "away")
    assert perform(tasks[0], tmp_path, 1).state == "away"
    (tmp_path / "away").rename(archive)
    (Path(archive) / tasks[0].recording.file.name).unlink()
    assert perform(tasks[0], tmp_path, 1).state == "refused"
    assert perform(tasks[1], tmp_path, 1).state == "done"


def test_nothing_is_written_into_what_is_read(archive: Path, tmp_path: Path) -> None:
    assert "is within the records" in refused("rebuild", archive, "-o", archive / "clouds")
    assert not (archive / "clouds").exists()


def test_an_output_that_cannot_be_written_is_refused_at_once(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("no folder")
    for place in ("file", "file/below"):
        with pytest.raises(OperationError, match="file"):
            ResultStore(settings_for(str(tmp_path / place))).prepare()
    ResultStore(settings_for(str(tmp_path / "new"))).prepare()
    assert list((tmp_path / "new").iterdir()) == []


def test_an_address_that_was_given_is_not_looked_for_in_settings(tmp_path: Path) -> None:
    with pytest.raises(OperationError, match="is no archive"):
        find_places([str(tmp_path)])
    with pytest.raises(OperationError, match="is not there") as refused:
        find_places([str(tmp_path / "none")])
    assert str(refused.value.remedy) == "Mount its disk, or correct its address"


def test_what_is_no_file_is_named_and_the_rest_is_made(archive: Path, tmp_path: Path) -> None:
    recording = next(archive.glob("scans/one/*/scan.mcap"))
    recording.unlink()
    os.mkfifo(recording)
    tasks, results = plan(archive, tmp_path / "clouds")
    states = {task.recording.id: perform(task, tmp_path, 1).state for task in tasks}
    assert states == {"one": "refused", "two": "done", "three": "done"}
    os.mkfifo(tmp_path / "clouds" / "one.json")
    assert results.read("one") is None


def test_recordings_of_a_calibration_too_long_are_named(archive: Path, tmp_path: Path) -> None:
    calibration = next(archive.glob(f"sessions/{CALIBRATION}/*/calibration.json"))
    os.truncate(calibration, LARGEST_DOCUMENT + 1)
    output = settings_for(str(tmp_path / "clouds"))
    made = plan_rebuild(find_places([str(archive)]), Selection(), output, ".ply")
    assert made.tasks == []
    assert [refusal.code for _, refusal in made.refused] == ["file-too-large"] * len(SCANS)


def test_a_name_of_an_address_that_is_no_text_is_refused(archive: Path) -> None:
    archive.rename(archive.with_name("room-\udcfc"))
    with pytest.raises(OperationError, match="is not UTF-8"):
        find_places([str(archive.parent)])


def test_a_file_beside_archives_is_no_hindrance(archive: Path) -> None:
    (archive.parent / "a-file").write_text("notes")
    assert [place.station for place in find_places([str(archive.parent)])] == ["room-2"]


@pytest.mark.parametrize(
    ("text", "begin", "end"),
    [
        ("2026-05-13", (2026, 5, 13), (2026, 5, 14)),
        ("2026-12", (2026, 12, 1), (2027, 1, 1)),
        ("2026", (2026, 1, 1), (2027, 1, 1)),
        ("..2026-05", (1970, 1, 1), (2026, 6, 1)),
        ("2026-05-13..", (2026, 5, 13), (9999, 1, 1)),
    ],
)
def test_periods(text: str, begin: tuple[int, int, int], end: tuple[int, int, int]) -> None:
    expected = Period(datetime(*begin, tzinfo=UTC), datetime(*end, tzinfo=UTC))
    assert parse_period(text) == expected


@pytest.mark.parametrize("text", ["", "May", "2026-13", "2026-06..2026-05", "99999"])
def test_what_is_no_period_is_refused(text: str) -> None:
    with pytest.raises(OperationError, match="is no period"):
        parse_period(text)
