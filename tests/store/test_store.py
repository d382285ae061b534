"""The station's memory: nothing acknowledged is lost, nothing written is changed."""

import os
import signal
import sqlite3
import subprocess
import sys
from collections.abc import Callable
from contextlib import closing
from dataclasses import replace
from pathlib import Path

import pytest

from crenel.errors import OperationError
from crenel.formats.recording.completeness import MissingFrames
from crenel.formats.results.scan_record import PartNames
from crenel.store.calibrations import CalibrationFigures
from crenel.store.scans import ScanRecord
from crenel.store.store import Store
from tests.present import present
from tests.refusals import refused, refused_as
from tests.store.conftest import FIGURES, accept_calibration, open_database, reopened

ROOT = Path(__file__).resolve().parents[2]


def test_a_journal_comes_back_in_order_after_reopening(store: Store) -> None:
    store.journal.begin_session("s1", "calibration")
    first = store.journal.append("s1", "point_taken", {"face": "crest", "joints_rad": [0.1, 0.2]})
    second = store.journal.append("s1", "point_voided", {"index": 0})
    with reopened(store) as again:
        assert again.journal.rows("s1") == [first, second]
        assert again.journal.last_number() == second.number > first.number
        assert again.journal.latest("calibration", "point_taken") == first
        assert again.journal.latest("verification", "point_taken") is None
        assert again.journal.latest_session("calibration") is not None
        assert again.journal.latest_session("verification") is None


def test_an_idempotency_key_acts_once_over_all_sessions(store: Store) -> None:
    store.journal.begin_session("s1", "calibration")
    store.journal.begin_session("s2", "calibration")
    store.journal.append("s1", "point_taken", {}, "k1")
    assert store.journal.knows_key("k1")
    assert not store.journal.knows_key("k2")
    with pytest.raises(sqlite3.IntegrityError):
        store.journal.append("s2", "point_taken", {}, "k1")
    assert store.journal.rows("s2") == []


@pytest.mark.parametrize("statement", ["DELETE FROM journal", "UPDATE journal SET kind = 'x'"])
def test_the_journal_refuses_to_be_rewritten(store: Store, statement: str) -> None:
    store.journal.begin_session("s1", "calibration")
    row = store.journal.append("s1", "point_taken", {})
    store.close()
    with (
        open_database(store) as database,
        pytest.raises(sqlite3.IntegrityError, match="append-only"),
    ):
        database.execute(statement)
    with reopened(store) as again:
        assert again.journal.rows("s1") == [row]


def test_no_number_that_is_not_one_enters_the_journal(store: Store) -> None:
    store.journal.begin_session("s1", "calibration")
    with pytest.raises(OperationError, match="JSON compliant"):
        store.journal.append("s1", "point_taken", {"residual": float("nan")})
    assert store.journal.rows("s1") == []


def test_only_the_last_accepted_calibration_is_active(store: Store) -> None:
    assert store.calibrations.active() is None
    for session in ("s1", "s2"):
        accept_calibration(store, session)
    active = present(store.calibrations.active())
    assert active.id == "s2"
    assert active.file == store.folder / "sessions/s2/calibration.json"
    assert active.figures == CalibrationFigures(**FIGURES)
    assert [(c.id, c.active) for c in store.calibrations.all()] == [("s2", True), ("s1", False)]
    assert [row.kind for row in store.journal.rows("s2")] == ["accepted"]
    latest = present(store.journal.latest_session("calibration"))
    assert latest.ended_at is not None


def test_each_sensor_has_its_own_active_calibration(store: Store) -> None:
    for session, sensor in (("s1", "left"), ("s2", "right"), ("s3", "left")):
        accept_calibration(store, session, sensor)
    found = {name: store.calibrations.active(name) for name in ("left", "right")}
    assert {name: one.id for name, one in found.items() if one} == {"left": "s3", "right": "s2"}
    assert store.calibrations.active() is None


def test_a_failed_acceptance_changes_nothing(store: Store) -> None:
    accept_calibration(store, "s1")
    file = store.folder / "sessions/s1/calibration.json"
    with pytest.raises(sqlite3.IntegrityError):
        store.calibrations.accept("s1", "the same once more", file, FIGURES, None)
    active = present(store.calibrations.active())
    assert active.name == "Calibration s1"
    assert len(store.journal.rows("s1")) == 1


def test_scans_are_listed_newest_first(store: Store) -> None:
    scans = []
    for i, at in enumerate(("2026-01-01T10:00:00Z", "2026-01-01T11:00:00Z")):
        folder = store.folder / f"scans/n{i}"
        missing = MissingFrames(i, 2)
        record = ScanRecord(
            *(f"n{i}", f"Scan {i}", folder, at, 10, 2, 0.5, "s1"),
            left_out=missing,
            part=PartNames(part="Cover", customer="Müller"),
            frames_too_fast=i or None,
            sources=("a", "b")[:i],
        )
        scans.append(record)
        store.scans.add(scans[-1])
    assert store.scans.all() == scans[::-1]
    assert store.scans.newest() == scans[1]
    assert store.scans.get("n0") == scans[0]
    assert store.scans.get("n9") is None
    store.scans.complete("n0", 20, 4, 0.5, MissingFrames(3, 4))
    completed = store.scans.get("n0")
    assert completed == replace(scans[0], points=20, frames=4, left_out=MissingFrames(3, 4))
    grown = replace(scans[1], points=30, seconds=1.5, frames_lost=2, sources=("a", "b"))
    store.scans.note_merged(grown)
    store.scans.set_part("n1", PartNames(part="Lid"))
    assert store.scans.get("n1") == replace(grown, part=PartNames(part="Lid"))


def test_a_data_folder_can_be_moved(store: Store, tmp_path: Path) -> None:
    accept_calibration(store, "s1")
    store.close()
    store.folder.rename(tmp_path / "after")
    with closing(Store(tmp_path / "after")) as moved:
        active = moved.calibrations.active()
    assert present(active).file == tmp_path / "after/sessions/s1/calibration.json"


def test_a_second_server_is_refused_naming_the_first(store: Store) -> None:
    with refused_as("data-folder-in-use", str(os.getpid())):
        Store(store.folder)
    with reopened(store):
        pass


def test_a_database_of_a_later_version_is_left_alone(store: Store) -> None:
    store.close()
    with open_database(store) as database:
        database.execute("PRAGMA user_version = 99")
    for _ in range(2):  # the refusal must also let the lock go
        with refused("database-newer"):
            Store(store.folder)


@pytest.mark.parametrize("version", [0, 2, 99])
def test_another_programs_database_is_left_alone(tmp_path: Path, version: int) -> None:
    connection = sqlite3.connect(tmp_path / "station.db")
    connection.executescript(f"CREATE TABLE things (x); PRAGMA user_version = {version};")
    connection.close()
    with pytest.raises(OperationError, match="another program"):
        Store(tmp_path)


@pytest.mark.parametrize("name", ["", "-wal", "-shm", "-journal"])
@pytest.mark.parametrize(
    "make",
    [
        os.mkdir,
        os.mkfifo,
        lambda path: path.symlink_to("/dev/zero"),
        lambda path: path.symlink_to(path),
    ],
)
def test_a_false_file_is_named(name: str, make: Callable[[Path], object], tmp_path: Path) -> None:
    if name:
        Store(tmp_path).close()
    make(tmp_path / f"station.db{name}")
    with pytest.raises(OperationError) as caught:
        Store(tmp_path)
    words = "used" if name else "read as a station database"
    assert f"station.db{name} cannot be {words}" in str(caught.value.what)
    assert str(caught.value.why).startswith("it is a ")
    assert "ove it away" in str(caught.value.remedy)
    assert "permission" not in caught.value.line


def test_a_link_beside_the_database_that_leads_nowhere_is_named(tmp_path: Path) -> None:
    Store(tmp_path).close()
    (tmp_path / "station.db-wal").symlink_to(tmp_path / "nowhere")
    with pytest.raises(OperationError, match=r"station\.db-wal cannot be used .* Move it away"):
        Store(tmp_path)


@pytest.mark.parametrize("times", [1, 1000])
def test_what_is_not_a_database_is_named(tmp_path: Path, times: int) -> None:
    content = "no database at all, but long enough to be read as one"
    (tmp_path / "station.db").write_text(times * content)
    with refused_as("database-unreadable", "station.db"):
        Store(tmp_path)


def test_a_folder_that_cannot_be_made_is_refused(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with refused("data-folder-unwritable"):
        Store(tmp_path / "file" / "data")


WRITER = """
import sys
from pathlib import Path
from crenel.store.store import Store
store = Store(Path(sys.argv[1]))
store.journal.begin_session("s1", "calibration")
for i in range(100000):
    store.journal.append("s1", "point_taken", {"i": i})
    print(i, flush=True)
"""


@pytest.mark.device
def test_a_killed_process_loses_no_row_that_it_acknowledged(store: Store) -> None:
    store.close()
    with subprocess.Popen(
        [sys.executable, "-c", WRITER, str(store.folder)],
        stdout=subprocess.PIPE,
        cwd=ROOT,
        text=True,
    ) as writer:
        assert writer.stdout is not None
        acknowledged = -1
        for line in writer.stdout:
            acknowledged = int(line)
            if acknowledged == 50:
                writer.send_signal(signal.SIGKILL)
                break
        acknowledged = max([acknowledged, *(int(n) for n in writer.stdout.read().split())])
    with reopened(store) as again:
        kept = [row.payload["i"] for row in again.journal.rows("s1")]
    assert kept[: acknowledged + 1] == list(range(acknowledged + 1))
