"""Scans of an earlier version, whose recordings do not state the calibration in use."""

import json
import tarfile
from pathlib import Path

import pytest

pytest.importorskip("distributed")
pytest.importorskip("sqlalchemy")

from crenel.archive.records import open_record_lists
from crenel.batch.places import find_places, settings_for
from crenel.batch.rebuild import RebuildPlan, plan_rebuild
from crenel.batch.recordings import Selection
from crenel.batch.task import perform
from crenel.store.store import Store
from tests.api.test_earlier_version import ARCHIVE, CALIBRATION, SCAN
from tests.batch.filled import archive_and_close
from tests.cli.test_cli import done


@pytest.fixture
def earlier(tmp_path: Path) -> Path:
    with tarfile.open(ARCHIVE) as archive:
        archive.extractall(tmp_path / "data", filter="data")
    return tmp_path / "data"


def plan(place: Path, selection: Selection | None = None) -> RebuildPlan:
    place.with_name("out").mkdir(exist_ok=True)
    output = settings_for(str(place.with_name("out")))
    return plan_rebuild(find_places([str(place)]), selection or Selection(), output, ".ply")


def test_its_scan_is_rebuilt_with_the_calibration_in_the_list(earlier: Path) -> None:
    before = (earlier / "station.db").read_bytes()
    planned = plan(earlier, Selection(taken_with=frozenset({CALIBRATION})))
    assert planned.refused == []
    (task,) = planned.tasks
    assert (task.recording.id, task.recording.started_at.date().isoformat()) == (SCAN, "2026-11-25")
    assert [one.id for one in task.calibrations.values()] == [CALIBRATION]
    done = perform(task, earlier.parent, 1)
    assert (done.state, done.result["points"]) == ("done", 65226)
    assert (earlier / "station.db").read_bytes() == before
    with open_record_lists(earlier) as lists:  # brings the database up to date
        lists.scans.rename(SCAN, "Housing 4711")
    (task,) = plan(earlier, Selection(labels=frozenset({"Housing 4711"}))).tasks
    assert task.recording.calibration_ids == {"": CALIBRATION}


def test_the_archive_of_its_scan_states_the_calibration(earlier: Path, tmp_path: Path) -> None:
    archive_and_close(Store(earlier), tmp_path / "room-2")
    (task,) = plan(tmp_path / "room-2").tasks
    assert [one.id for one in task.calibrations.values()] == [CALIBRATION]


def test_the_catalogue_knows_its_calibration(earlier: Path, tmp_path: Path) -> None:
    config = tmp_path / "fleet.toml"
    catalogue = '[catalogue]\ndatabase = "sqlite:///c.db"\n'
    config.write_text(f'{catalogue}[stations.room-1]\ndata = "data"\n')

    def ask(*words: str) -> str:
        return done("catalogue", *words, "--config", config).stdout

    ask("collect")
    (found,) = json.loads(ask("calibration", SCAN, "--json"))["recordings"]
    assert found["recording"]["calibration_id"] == CALIBRATION
    assert found["calibration"]["id"] == found["newest"]["id"] == CALIBRATION
