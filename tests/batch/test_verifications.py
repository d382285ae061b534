"""``crenel verify`` and ``crenel study`` over archives and data folders."""

import csv
import os
from collections.abc import Callable
from pathlib import Path

import pytest

pytest.importorskip("distributed")

from crenel.batch.places import find_places, settings_for
from crenel.batch.recordings import Selection
from crenel.batch.results import SHORT_KEY, ResultStore
from crenel.batch.task import perform
from crenel.batch.verifications import (
    VerificationTask,
    With,
    plan_verifications,
    table_of,
    table_text,
    table_with_uncertainties,
)
from crenel.formats.open_file import LARGEST_DOCUMENT
from crenel.gauges.plan.document_gauge import GaugeFile
from crenel.gauges.quick.document import VerificationFile
from crenel.gauges.quick.evaluate_study import FIGURES
from crenel.store.store import Store
from tests.batch.filled import CALIBRATION, archive_and_close, fill_station
from tests.batch.test_rebuild import run
from tests.cli.test_cli import crenel
from tests.gauges.quick.test_repeatability import scan_a_plane
from tests.gauges.quick.test_study import RECORD

pytestmark = pytest.mark.device

OTHER = "20260601-080000-calibration"
VERIFIED = ("v1", "v2")


def add_verification(
    store: Store,
    record_id: str,
    taken_at: str,
    offset_mm: float = 0.0,
    calibration: str = CALIBRATION,
    clouds: int = 2,
) -> Path:
    """Clouds of one plane, 20 µm apart and off along its normal, by a session's calibration."""
    folder = store.folder / "verifications" / record_id
    for number in range(1, clouds + 1):
        (folder / f"cloud-{number}").mkdir(parents=True)
        scan_a_plane(folder / f"cloud-{number}" / "scan.mcap", 0.02 * number + offset_mm)
    session = store.folder / "sessions" / calibration
    for name in ("calibration.json", "arm.json"):
        (folder / name).write_bytes((session / name).read_bytes())
    GaugeFile(shape="plane").write(folder / "gauge.json")
    (cloud,) = RECORD["clouds"]
    cloud = {**cloud, "taken_at": taken_at}
    parts = [
        {**cloud, "name": f"Cloud {number}", "recording": f"cloud-{number}/scan.mcap"}
        for number in range(1, clouds + 1)
    ]
    known = {**RECORD, "id": record_id, "gauge": {"shape": "plane", "name": "Plate"}}
    known |= {"calibration": {**RECORD["calibration"], "id": calibration}, "clouds": parts}
    VerificationFile.model_validate(known).write(folder / "verification.json")
    store.journal.begin_session(record_id, "verification")
    store.journal.end_session(record_id)
    return folder


def add_calibration(store: Store, session_id: str) -> None:
    """Another one, with another laser plane, of the same devices."""
    sessions = store.folder / "sessions"
    (sessions / session_id).mkdir()
    for name in ("calibration.json", "arm.json"):
        content = (sessions / CALIBRATION / name).read_text()
        (sessions / session_id / name).write_text(content.replace("0.25", "0.35"))
    store.journal.begin_session(session_id, "calibration")
    store.journal.end_session(session_id)


@pytest.fixture
def archive(tmp_path: Path) -> Path:
    place = tmp_path / "room-2"
    store = fill_station(tmp_path / "data", [])
    for number, record_id in enumerate(VERIFIED, 5):
        add_verification(store, record_id, f"2026-0{number}-21T10:16:00Z")
    add_calibration(store, OTHER)
    archive_and_close(store, place)
    return place


def plan(
    place: Path, tmp_path: Path, rebuilt_with: With, selection: Selection | None = None
) -> tuple[list[VerificationTask], ResultStore]:
    results = ResultStore(settings_for(str(tmp_path / "out")))
    results.prepare()
    tasks, refused = plan_verifications(
        find_places([str(place)]), selection or Selection(), results.settings, rebuilt_with
    )
    assert refused == []
    return tasks, results


def test_clouds_are_measured_with_the_verified_calibration(archive: Path, tmp_path: Path) -> None:
    tasks, _ = plan(archive, tmp_path, "own")
    assert [task.record.id for task in tasks] == list(VERIFIED)
    outcomes = [perform(task, tmp_path, 1) for task in tasks]
    assert [one.refusal for one in outcomes] == [None, None]
    rows = table_of(zip(tasks, (one.result for one in outcomes), strict=True))
    assert [row[:5] for row in rows] == [
        ["room-2", one, f"2026-0{number}-21T10:16:00Z", f"Cloud {cloud}", CALIBRATION]
        for number, one in enumerate(VERIFIED, 5)
        for cloud in (1, 2)
    ]
    table = list(csv.DictReader(table_text(rows).splitlines()))
    heights = [float(row["z_error_um"]) for row in table[:2]]
    assert abs(heights[1] - heights[0]) == pytest.approx(20, rel=0.2)
    # a figure that there is has its uncertainty beside it
    for row in table:
        assert {name for name in FIGURES if row[name]} == {
            name for name in FIGURES if float(row[f"U_{name}"] or 0) > 0
        }
    headings, printed = table_with_uncertainties(rows)
    assert headings[5:] == ["rms_um", "angle_arcsec", "z_error_um"]
    assert all("±" in cell for row in printed for cell in row[5:])


def test_a_study_takes_all_calibrations_of_the_station(archive: Path, tmp_path: Path) -> None:
    tasks, results = plan(archive, tmp_path, "all")
    outcome = perform(tasks[0], tmp_path, 1)
    assert sorted(outcome.result["calibration_ids"]) == [CALIBRATION, OTHER]
    assert len(outcome.result["rows"]) == 4
    kept = results.read(tasks[0].stem)
    assert kept == outcome.result
    assert perform(tasks[0], tmp_path, 1).result == kept


def test_verifications_are_chosen_by_their_calibration(archive: Path, tmp_path: Path) -> None:
    assert plan(archive, tmp_path, "own", Selection(taken_with=frozenset({OTHER})))[0] == []


Damage = Callable[[Path], object]


def replace_by_a_long_file(path: Path) -> None:
    os.truncate(path, LARGEST_DOCUMENT + 1)


def replace_by_a_pipe(path: Path) -> None:
    path.unlink()
    os.mkfifo(path)


def replace_by_text(path: Path) -> None:
    path.write_text("no calibration")


DAMAGES = (replace_by_a_long_file, replace_by_a_pipe, replace_by_text)


@pytest.mark.parametrize("damage", DAMAGES)
def test_damaged_calibrations_are_left_out(archive: Path, tmp_path: Path, damage: Damage) -> None:
    damage(next(archive.glob(f"sessions/{OTHER}/*/calibration.json")))
    output = settings_for(str(tmp_path / "out"))
    tasks, refused = plan_verifications(find_places([str(archive)]), Selection(), output, "all")
    assert [name for name, _ in refused] == [f"room-2/{OTHER}"]
    assert [[one.id for one in task.sources] for task in tasks] == [[CALIBRATION]] * 2


def refusal_of(tmp_path: Path, url: str, name: str, damage: Damage) -> tuple[str, Path]:
    """Why a verification is refused that was archived with a damaged file, and its copy."""
    place = tmp_path / "room-2"
    store = fill_station(tmp_path / "data", [])
    damage(add_verification(store, "v1", "2026-05-21T10:16:00Z", clouds=1) / name)
    archive_and_close(store, place)
    output = settings_for(str(tmp_path / "out"))
    ResultStore(output).prepare()
    tasks, refused = plan_verifications(find_places([url]), Selection(), output, "own")
    found = [one for _, one in refused] + [perform(one, tmp_path, 1).refusal for one in tasks]
    (refusal,) = found
    assert refusal is not None
    (record,) = place.glob("verifications/v1/*")
    return refusal.error().line, record


@pytest.mark.parametrize("address", ["{}", "file://{}"], ids=["folder", "store"])
@pytest.mark.parametrize(
    ("name", "damage"),
    [
        *(("gauge.json", Path.unlink), ("gauge.json", replace_by_text)),
        *(("verification.json", replace_by_text), ("arm.json", Path.unlink)),
    ],
)
def test_a_damaged_copy_is_named(tmp_path: Path, address: str, name: str, damage: Damage) -> None:
    url = address.format(tmp_path / "room-2")
    line, record = refusal_of(tmp_path, url, name, damage)
    assert line.startswith(f"{url}/verifications/v1/{record.name}/{name}: ")


def test_a_calibration_that_was_archived_damaged_is_named_by_its_id(tmp_path: Path) -> None:
    line, _ = refusal_of(tmp_path, str(tmp_path / "room-2"), "arm.json", replace_by_text)
    assert f": {CALIBRATION}: arm.json: it is not JSON" in line


@pytest.mark.parametrize("damage", DAMAGES)
def test_damaged_verifications_are_named(archive: Path, tmp_path: Path, damage: Damage) -> None:
    damage(next(archive.glob("verifications/v1/*/verification.json")))
    output = settings_for(str(tmp_path / "out"))
    tasks, refused = plan_verifications(find_places([str(archive)]), Selection(), output, "own")
    assert [name for name, _ in refused] == ["room-2/v1"]
    assert [task.record.id for task in tasks] == ["v2"]


def test_an_archive_that_is_lost_midway_gives_no_study(archive: Path, tmp_path: Path) -> None:
    tasks, results = plan(archive, tmp_path, "all")
    archive.rename(tmp_path / "away")
    assert perform(tasks[0], tmp_path, 1).state == "away"
    assert results.whole_keys({task.key[:SHORT_KEY] for task in tasks}) == set()


def test_a_file_that_comes_incomplete_is_tried_again(archive: Path, tmp_path: Path) -> None:
    tasks, results = plan(archive, tmp_path, "own")
    path = archive / tasks[0].record.files["cloud-1/scan.mcap"].name
    whole = path.read_bytes()
    path.write_bytes(whole[:-1])
    assert perform(tasks[0], tmp_path, 1).state == "again"
    assert results.whole_keys({task.key[:SHORT_KEY] for task in tasks}) == set()
    path.write_bytes(whole)
    assert perform(tasks[0], tmp_path, 1).state == "done"


def test_a_damaged_file_is_refused_in_the_end(archive: Path, tmp_path: Path) -> None:
    (path,) = archive.glob("verifications/v1/*/cloud-1/scan.mcap")
    path.write_bytes(path.read_bytes()[:-1])
    found = run("verify", "plane", archive, "--workers", 1, "-o", "out", cwd=tmp_path, status=3)
    assert found["made"] == 1
    assert list(found["refused"]) == ["room-2/v1"]


def test_the_commands_print_and_keep_the_table(archive: Path, tmp_path: Path) -> None:
    args = ("--workers", 1, "-o", "out")
    found = run("verify", "plane", archive, *args, "--period", "2026-05", cwd=tmp_path)
    assert (found["made"], len(found["rows"])) == (1, 2)
    assert (tmp_path / "out/table.csv").read_text().count("\n") == 3
    in_2027 = ("--since", "2027-01-01")
    for words in (
        ("verify", "sphere", archive),
        ("study", archive, "--period", "2027"),
        ("drift", "gauge-rms", archive, *in_2027),
    ):
        none = crenel(*words, "-o", tmp_path / "out")
        assert none.exit_code == 1
        assert "is chosen. The places have 2 on a plane." in none.stderr
    studied = run("study", archive, "data", *args, cwd=tmp_path)
    # the records are the same in the archive and in the data folder: each has one result
    assert (studied["made"], len(studied["rows"])) == (2, 8)
