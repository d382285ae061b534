"""What cannot be read at a start is set aside and reported; everything else is served."""

import json
from collections.abc import Iterator
from contextlib import ExitStack, suppress
from pathlib import Path

import pytest

from crenel.errors import OperationError
from crenel.guide.common.datasheet_library import read_library
from crenel.messages.message import mentions
from crenel.operations.health_checks import HealthChecker
from crenel.operations.home import build_home
from crenel.operations.unreadable_files import list_unreadable
from crenel.store.scans import ScanRecord
from crenel.store.store import Store
from crenel.timestamps import utc_now
from crenel.wire.json_response import encode_json
from crenel_hardware.simulator.station import SimulatedStation
from tests.guide.stations import Station
from tests.present import present

pytestmark = pytest.mark.device

PAGE_BYTES = 4096


@pytest.fixture(scope="module")
def simulation() -> Iterator[SimulatedStation]:
    with SimulatedStation() as simulation:
        yield simulation


@pytest.fixture
def station(simulation: SimulatedStation, tmp_path: Path) -> Station:
    return Station(simulation, tmp_path)


@pytest.mark.parametrize("payload", ["no JSON", "[1, 2]", '{"to": null}', "{" * 3000])
@pytest.mark.parametrize("kind", ["calibration", "arm", "verify"])
def test_a_session_with_a_bad_row_is_set_aside(station: Station, kind: str, payload: str) -> None:
    store = Store(station.data)
    store.journal.begin_session("bad", kind)
    with store._database.transaction() as connection:
        connection.execute(
            "INSERT INTO journal (session_id, at, kind, payload) VALUES ('bad', ?, ?, ?)",
            ("2026-01-01T00:00:00Z", "of_a_newer_version", payload),
        )
    store.close()
    with station.opened() as context:
        assert any("bad cannot be read" in str(text) for text in list_unreadable(context))
        assert context.guide.start().running
        assert build_home(context).next.page == "calibrate"


@pytest.mark.parametrize(
    "change",
    [
        "UPDATE calibration SET accepted_at = 'yesterday'",
        "UPDATE scan SET started_at = 'yesterday'",
        "UPDATE scan SET folder = '../elsewhere'",
        "UPDATE scan SET name = CAST(x'e4' AS TEXT)",
    ],
)
def test_with_damaged_rows_health_and_home_are_shown(station: Station, change: str) -> None:
    folder = station.data / "scans/one"
    with station.opened(calibrated=True) as context:
        context.store.scans.add(ScanRecord("one", "One", folder, utc_now(), 7, 3, 1.0, "true"))
        with context.store._database.transaction() as connection:
            connection.execute(change)
        folder.mkdir()
        (folder / "scan.mcap").write_bytes(b"no recording")
        context.recovery.list_unlisted()
        assert HealthChecker(context).look().items
        assert encode_json(build_home(context))
        assert len(context.store.scans.all()) == 1
        assert encode_json(context.store.scans.all()[0].name)


def test_a_calibration_that_is_emptied_while_in_use_is_not_scanned_with(station: Station) -> None:
    with station.opened(calibrated=True) as context:
        file = context.store.calibrations.all()[0].file
        whole = file.read_text()
        assert context.scanner.trouble is None
        file.write_text("")
        assert build_home(context).checks[0].state == "failed"
        refusal = present(context.scanner.why_not())
        assert refusal.code == "calibration-unreadable"
        with pytest.raises(OperationError, match="cannot be read"):
            context.scanner.start("")
        file.write_text(whole)
        assert context.scanner.trouble is None
        assert build_home(context).checks[0].state == "valid"


def test_a_cut_calibration_is_not_valid(station: Station) -> None:
    with station.opened(calibrated=True) as context:
        file = context.store.calibrations.all()[0].file
    file.write_text(file.read_text()[:200])
    with station.opened() as context:
        line = build_home(context).checks[0]
        assert (line.state, line.quality) == ("failed", "bad")
        refusal = present(context.scanner.why_not())
        assert refusal.code == "calibration-unreadable"
        assert str(station.data) not in refusal.line
        assert list_unreadable(context)


def test_a_calibration_whose_files_go_while_the_station_runs_is_not_valid(station: Station) -> None:
    with station.opened(calibrated=True) as context:
        file = context.store.calibrations.all()[0].file
        assert build_home(context).checks[0].state == "valid"
        for spoiled in (file, file.parent / "arm.json"):
            content = spoiled.read_bytes()
            for spoil in (None, lambda path: path.write_bytes(b"{"), Path.mkdir):
                spoiled.unlink(missing_ok=True)
                if spoil is not None:
                    spoil(spoiled)
                line = build_home(context).checks[0]
                assert line.state == "failed"
                assert mentions(line.text, f"sessions/true/{spoiled.name}")
                assert str(station.data) not in str(line.text)
            spoiled.rmdir()
            spoiled.write_bytes(content)
            assert build_home(context).checks[0].state == "valid"


def test_an_empty_database_beside_sessions_is_refused(tmp_path: Path) -> None:
    Store(tmp_path).close()
    (tmp_path / "sessions" / "one").mkdir()
    (tmp_path / "station.db").write_bytes(b"")
    with pytest.raises(OperationError, match="last backup"):
        Store(tmp_path)


def test_a_damaged_page_of_the_database_is_said_to_be_one(station: Station) -> None:
    with station.opened(calibrated=True) as context:
        context.guide.start()
    database = station.data / "station.db"
    whole, refused = database.read_bytes(), []
    for at in range(0, len(whole), PAGE_BYTES):
        for beside in station.data.glob("station.db-*"):
            beside.unlink()
        database.write_bytes(whole[:at] + bytes(PAGE_BYTES) + whole[at + PAGE_BYTES :])
        with ExitStack() as stack:
            try:
                context = stack.enter_context(station.opened())
            except OperationError as refusal:
                refused.append(refusal.code)
                continue
            for look in (build_home, list_unreadable, lambda context: context.guide.start()):
                with suppress(OperationError):
                    look(context)
    assert set(refused) == {"database-unreadable"}
    assert len(refused) < len(whole) // PAGE_BYTES


def test_a_row_that_cannot_be_folded_is_not_kept(station: Station) -> None:
    with station.opened() as context:
        context.guide.start()
        before = context.store.journal.last_number()
        with pytest.raises(OperationError, match="not saved"):
            context.guide.append("went_back", {"to": "nowhere"})
        assert context.store.journal.last_number() == before
        assert context.guide.state.step == "devices"


def test_texts_that_are_no_unicode(tmp_path: Path) -> None:
    assert json.loads(encode_json({"a": ["\ud800"]})) == {"a": ["\N{REPLACEMENT CHARACTER}"]}
    folder = tmp_path / "objects"
    folder.mkdir()
    (folder / "Pr\udcfcf.json").write_text("{}")
    (folder / "half.json").write_text('{"name": "\\ud800"}')
    findings = read_library(tmp_path).findings
    assert len(findings) == 2
    encode_json(findings).decode()
    assert any("Rename it" in str(finding.text) for finding in findings)
