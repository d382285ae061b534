"""Records of data folders and archives come into the catalogue, also what was missed."""

from collections.abc import Iterator, Mapping
from pathlib import Path

import pytest

from crenel.archive.archive import Archive
from crenel.archive.archive_settings import ArchiveSettings
from crenel.archive.remote_store import FolderStore
from crenel.archive.store_errors import store_error
from crenel.fleet.catalogue.catalogue import FleetCatalogue
from crenel.fleet.catalogue.database import CatalogueError
from crenel.fleet.catalogue.entry import CatalogueEntry
from crenel.fleet.catalogue.reading import (
    KnownContent,
    SearchQuery,
    read_record,
    search,
    summarise_stations,
)
from crenel.fleet.collection.collector import CollectedStation, CollectionResult, collect
from crenel.fleet.collection.places import ArchivePlace, FolderPlace, RecordPlace, SourceRecord
from crenel.store.store import Store
from tests.archive.filled import LATER, archive_of
from tests.batch.filled import fill_station
from tests.fleet.postgres import PostgresServer
from tests.fleet.records import CALIBRATION_ID, add_calibration, add_every_kind, add_recorded_scan

pytestmark = pytest.mark.device

Known = Mapping[str, KnownContent]


def settings_of(folder: Path) -> ArchiveSettings:
    return ArchiveSettings.model_validate({"url": str(folder)}, context=folder / "fleet.toml")


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "archive").mkdir()
    return tmp_path / "archive"


@pytest.fixture
def place(folder: Path) -> ArchivePlace:
    return ArchivePlace(settings_of(folder))


@pytest.fixture
def archive(store: Store, folder: Path) -> Archive:
    return archive_of(store, str(folder))


def collect_from(
    catalogue: FleetCatalogue, *places: RecordPlace, complete: bool = False
) -> CollectionResult:
    return collect(catalogue, [CollectedStation("room-1", "Room 1", places)], complete)


def entries(catalogue: FleetCatalogue) -> dict[str, CatalogueEntry]:
    found: dict[str, CatalogueEntry] = {}
    with catalogue.reading() as connection:
        for one in search(connection, SearchQuery(limit=1000)):
            entry = read_record(connection, "room-1", one.entry.kind, one.entry.id)
            assert entry is not None
            found[entry.kind] = entry
    return found


def check_every_kind(found: dict[str, CatalogueEntry]) -> None:
    checks = {"verification", "performance", "arm_check", "tip_check"}
    assert found.keys() == checks | {"calibration", "session", "scan"}
    calibration = found["calibration"]
    assert (calibration.label, calibration.operator) == ("Calibration of May", "Ada")
    assert (calibration.verdict, calibration.temperature_c) == ("good", 20.5)
    assert calibration.calibration_id == CALIBRATION_ID == calibration.id
    assert {one.quantity: one.value for one in calibration.figures}["laser-plane-offset"] == 0.25
    verification = found["verification"]
    assert verification.verdict in ("pass", "fail", "uncertain")
    assert all(one.quantity.startswith("gauge-") for one in verification.figures)
    assert verification.figures
    assert len(verification.calibration_sha256) == 64
    assert "plane-scan" in {one.quantity for one in found["performance"].figures}
    arm, tip = found["arm_check"], found["tip_check"]
    assert (arm.verdict, arm.figures[0].value, arm.figures[0].limit) == ("bad", 71.0, 60.0)
    assert (tip.verdict, tip.figures[0].value) == ("fail", -100.0)
    assert tip.figures[0].expanded_uncertainty == 20.0
    scan = found["scan"]
    assert (scan.label, scan.points, scan.calibration_id) == ("Housing 4711", 3, CALIBRATION_ID)
    assert (scan.arm_serial, scan.sensor_serial) == ("A-17", "L-3")
    assert scan.at.isoformat() == "2026-05-04T11:15:00+00:00"
    assert [file.path for file in scan.files] == ["cloud.ply", "scan.mcap"]


def test_every_kind_of_a_data_folder(store: Store, catalogue: FleetCatalogue) -> None:
    add_every_kind(store)
    result = collect_from(catalogue, FolderPlace(store.folder))
    assert (result.new, result.problems) == (7, {})
    check_every_kind(entries(catalogue))
    assert collect_from(catalogue, FolderPlace(store.folder)).new == 0


def test_every_kind_of_an_archive_with_the_same_hashes(
    store: Store, catalogue: FleetCatalogue, archive: Archive, place: ArchivePlace
) -> None:
    add_every_kind(store)
    collect_from(catalogue, FolderPlace(store.folder))
    here = entries(catalogue)
    archive.run()
    assert collect_from(catalogue, place).new == 0
    both = entries(catalogue)
    check_every_kind(both)
    for kind, entry in both.items():
        assert entry.archived_at is not None, kind
        assert (entry.content, entry.files) == (here[kind].content, here[kind].files)
        assert entry.figures == here[kind].figures


@pytest.fixture
def archived(store: Store, archive: Archive, place: ArchivePlace) -> ArchivePlace:
    add_every_kind(store)
    archive.run()
    return place


def test_an_archive_alone_has_all(archived: ArchivePlace, own: FleetCatalogue) -> None:
    assert collect_from(own, archived).new == 7
    check_every_kind(entries(own))
    assert collect_from(own, archived, complete=True).new == 0


def test_a_cloud_that_no_archive_has_is_counted_all_the_same(
    own: FleetCatalogue, folder: Path, place: ArchivePlace, tmp_path: Path
) -> None:
    station = fill_station(tmp_path / "data", ["20260501-100000"])
    data = FolderPlace(tmp_path / "data")
    assert collect_from(own, data).new == 2
    here = entries(own)["scan"]
    archive_of(station, str(folder)).run()
    station.close()
    collect_from(own, place, data)
    there = entries(own)["scan"]
    assert (here.content, here.files) == (there.content, there.files)
    assert [file.path for file in there.files] == ["scan.mcap"]
    assert (there.points, there.archived_at is None) == (5, False)
    assert collect_from(own, place, data).new == 0


def test_what_was_missed_is_collected_later(
    store: Store, own: FleetCatalogue, archive: Archive, place: ArchivePlace
) -> None:
    for number in range(3):
        add_recorded_scan(store, f"20260504-11150{number}", f"Housing {number}")
    archive.run()
    assert collect_from(own, place).new == 3
    for number in range(3, 8):
        add_recorded_scan(store, f"20260504-11150{number}", f"Housing {number}")
        archive.run()
    assert collect_from(own, place).new == 5


def test_a_scan_that_was_named_later_is_found_by_its_new_name(
    store: Store, own: FleetCatalogue, archive: Archive, place: ArchivePlace
) -> None:
    add_recorded_scan(store, "20260504-111500", "Scan 1")
    archive.run()
    collect_from(own, place)
    store.scans.rename("20260504-111500", "Housing 4711")
    assert archive.run() == 1
    assert archive.run() == 0
    assert collect_from(own, place).new == 0
    scan = entries(own)["scan"]
    assert (scan.label, scan.archived_at is not None) == ("Housing 4711", True)
    store.scans.rename("20260504-111500", "Cover 9")
    collect_from(own, FolderPlace(store.folder))
    assert entries(own)["scan"].label == "Cover 9"


def test_records_that_left_the_station_stay_in_the_catalogue(
    store: Store, own: FleetCatalogue, folder: Path, place: ArchivePlace
) -> None:
    add_recorded_scan(store, "20260504-111500", "Housing 1")
    collect_from(own, FolderPlace(store.folder))
    archive_of(store, str(folder), later=LATER, rules={"keep_days": 1}).run()
    assert not (store.folder / "scans/20260504-111500").exists()
    collect_from(own, FolderPlace(store.folder), place)
    assert entries(own)["scan"].archived_at is not None


def test_a_session_that_runs_is_not_collected(store: Store, own: FleetCatalogue) -> None:
    add_calibration(store)
    store.journal.begin_session("20260505-090000-ff66", "calibration")
    (store.folder / "sessions/20260505-090000-ff66").mkdir()
    (store.folder / "sessions/20260505-090000-ff66/arm.json").write_text("{}")
    assert collect_from(own, FolderPlace(store.folder)).new == 1


def test_a_document_that_cannot_be_read_hides_no_record(store: Store, own: FleetCatalogue) -> None:
    add_every_kind(store)
    (store.folder / "sessions/20260504-073000-cc33/arm-check.json").write_text("{")
    (store.folder / "scans/20260504-111500/scan.mcap").write_bytes(b"none")
    assert collect_from(own, FolderPlace(store.folder)).new == 7
    found = entries(own)
    assert "arm_check" not in found
    assert found["scan"].label == "Housing 4711"


class FailingStore(FolderStore):
    """Is away from its n-th reading on, until it is mended."""

    left = 10**9

    def read(self, name: str) -> Iterator[bytes]:
        self.left -= 1
        if self.left < 0:
            raise store_error("archive-away", "the archive", "the cable is out")
        return super().read(name)


def test_a_lost_archive_costs_nothing(archived: object, own: FleetCatalogue, folder: Path) -> None:
    remote = FailingStore(folder)
    place = ArchivePlace(settings_of(folder), remote)
    new = 0
    for left in range(2, 12):
        remote.left = left
        result = collect_from(own, place)
        new += result.new
        if not result.problems:
            break
        assert "cannot be reached" in result.problems["room-1"].line
    remote.left = 10**9
    result = collect_from(own, place)
    assert (new + result.new, result.problems) == (7, {})
    check_every_kind(entries(own))
    with own.reading() as connection:
        assert summarise_stations(connection)[0].problem == ""


def test_a_damaged_copy_is_reported_and_the_rest_collected(
    archived: ArchivePlace, own: FleetCatalogue, folder: Path
) -> None:
    (copy,) = folder.glob("sessions/*/*/tip-check.json")
    copy.write_text("{}")
    result = collect_from(own, archived)
    assert result.new == 6
    assert isinstance(result.problems["room-1"], Exception)
    assert "tip-check.json differs" in result.problems["room-1"].line
    with own.reading() as connection:
        assert "differs" in summarise_stations(connection)[0].problem


def test_a_copy_that_is_missing_is_reported_and_the_rest_collected(
    archived: ArchivePlace, own: FleetCatalogue, folder: Path
) -> None:
    for name in ("scans/*/*/scan.mcap", "sessions/*/*/calibration.json"):
        (copy,) = folder.glob(name)
        copy.unlink()
    result = collect_from(own, archived)
    assert result.new == 5
    assert "calibration.json differs" in result.problems["room-1"].line
    assert "missing" in result.problems["room-1"].line


def test_a_station_away_stops_no_other(store: Store, own: FleetCatalogue, tmp_path: Path) -> None:
    add_every_kind(store)
    away = ArchivePlace(settings_of(tmp_path / "unmounted"))
    here = CollectedStation("room-1", "", [FolderPlace(store.folder)])
    result = collect(own, [CollectedStation("room-0", "", [away]), here])
    assert (result.new, list(result.problems)) == (7, ["room-0"])
    assert "is not there" in result.problems["room-0"].line


@pytest.fixture
def few_at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("crenel.fleet.collection.collector.AT_ONCE", 2)


@pytest.mark.usefixtures("few_at_once")
def test_the_database_stops_in_the_middle_and_nothing_is_lost(
    store: Store, archive: Archive, archived: ArchivePlace, postgres: PostgresServer
) -> None:
    stopping = StoppingPlace(archived, postgres, 4)
    with FleetCatalogue(postgres.new_database()) as catalogue:
        try:
            with pytest.raises(CatalogueError, match="cannot be used now"):
                collect_from(catalogue, stopping)
            # the station goes on, and so does its archive
            add_recorded_scan(store, "20260504-121500", "Housing 4712")
            assert archive.run() == 1
        finally:
            postgres.start()
        with catalogue.reading() as connection:
            before = len(search(connection, SearchQuery()))
        assert 0 < before < 7
        result = collect_from(catalogue, archived)
        assert (before + result.new, result.problems) == (8, {})
        assert len(entries(catalogue)) == 7


class StoppingPlace:
    """An archive; behind its n-th record, the database loses its power."""

    def __init__(self, place: ArchivePlace, server: PostgresServer, after: int) -> None:
        self.name, self.documents = place.name, place.documents
        self._place, self._server, self._after = place, server, after

    def list_new(self, known: Known, complete: bool = False) -> Iterator[SourceRecord]:
        for number, record in enumerate(self._place.list_new(known, complete)):
            if number == self._after:
                self._server.stop()
            yield record


def test_a_place_that_fails_in_any_way_stops_no_other(store: Store, own: FleetCatalogue) -> None:
    add_every_kind(store)

    class Failing(FolderPlace):
        def list_new(self, known: Known, complete: bool = False) -> Iterator[SourceRecord]:
            raise ZeroDivisionError

    result = collect_from(own, Failing(store.folder), FolderPlace(store.folder))
    assert (result.new, result.problems["room-1"].code) == (7, "failed")
