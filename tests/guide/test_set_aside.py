"""What cannot be read at a start is set aside and reported; everything else is served."""

import json
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import pytest

from app.errors import OperationError
from app.guide.common.datasheet_library import read_library
from app.messages.message import mentions
from app.operations.context import Context
from app.operations.health_checks import HealthChecker
from app.operations.home import build_home
from app.operations.unreadable_files import list_unreadable
from app.server.composition import close_context, open_context
from app.server.demo import station_parts
from app.server.station_parts import StationParts
from app.store.scans import ScanRecord
from app.store.store import Store
from app.timestamps import utc_now
from app.wire.json_response import encode_json
from hardware.simulator.station import SimulatedStation
from tests.api.calibrated import use_truth

pytestmark = pytest.mark.device

PAGE_BYTES = 4096


@pytest.fixture(scope="module")
def simulation() -> Iterator[SimulatedStation]:
    with SimulatedStation() as simulation:
        yield simulation


@pytest.fixture
def parts(simulation: SimulatedStation, tmp_path: Path) -> StationParts:
    return replace(station_parts(simulation, tmp_path), simulated_operator=None)


def closed(context: Context) -> None:
    close_context(context)
    context.store.close()
    context.monitoring.close()


@pytest.mark.parametrize("payload", ["no JSON", "[1, 2]", '{"to": null}', "{" * 3000])
@pytest.mark.parametrize("kind", ["calibration", "arm", "verify"])
def test_a_session_with_a_bad_row_is_set_aside(
    parts: StationParts, kind: str, payload: str
) -> None:
    store = Store(parts.data)
    store.journal.begin_session("bad", kind)
    with store._database.transaction() as connection:
        connection.execute(
            "INSERT INTO journal (session_id, at, kind, payload) VALUES ('bad', ?, ?, ?)",
            ("2026-01-01T00:00:00Z", "of_a_newer_version", payload),
        )
    store.close()
    context = open_context(parts)
    try:
        assert any("bad cannot be read" in str(text) for text in list_unreadable(context))
        assert context.guide.start().running
        assert build_home(context).next.page == "calibrate"
    finally:
        closed(context)


@pytest.mark.parametrize(
    "change",
    [
        "UPDATE calibration SET accepted_at = 'yesterday'",
        "UPDATE scan SET started_at = 'yesterday'",
        "UPDATE scan SET folder = '../elsewhere'",
        "UPDATE scan SET name = CAST(x'e4' AS TEXT)",
    ],
)
def test_damaged_rows_do_not_keep_health_and_home_from_being_shown(
    simulation: SimulatedStation, parts: StationParts, change: str
) -> None:
    context = open_context(parts)
    try:
        use_truth(SimpleNamespace(simulation=simulation, data=parts.data, context=context), "true")
        context.store.scans.add(
            ScanRecord("one", "One", parts.data / "scans/one", utc_now(), 7, 3, 1.0, "true")
        )
        with context.store._database.transaction() as connection:
            connection.execute(change)
        (parts.data / "scans/one").mkdir()
        (parts.data / "scans/one/scan.mcap").write_bytes(b"no recording")
        context.recovery.list_unlisted()
        assert HealthChecker(context).look().items
        assert encode_json(build_home(context))
        assert len(context.store.scans.all()) == 1
        assert encode_json(context.store.scans.all()[0].name)
    finally:
        closed(context)


def test_a_calibration_that_is_emptied_while_in_use_is_not_scanned_with(
    simulation: SimulatedStation, parts: StationParts
) -> None:
    context = open_context(parts)
    try:
        use_truth(SimpleNamespace(simulation=simulation, data=parts.data, context=context), "true")
        file = context.store.calibrations.all()[0].file
        whole = file.read_text()
        assert context.scanner.trouble is None
        file.write_text("")
        assert build_home(context).checks[0].state == "failed"
        refusal = context.scanner.why_not()
        assert refusal is not None
        assert refusal.code == "calibration-unreadable"
        with pytest.raises(OperationError, match="cannot be read"):
            context.scanner.start("")
        file.write_text(whole)
        assert context.scanner.trouble is None
        assert build_home(context).checks[0].state == "valid"
    finally:
        closed(context)


def test_a_cut_calibration_is_not_valid(simulation: SimulatedStation, parts: StationParts) -> None:
    context = open_context(parts)
    use_truth(SimpleNamespace(simulation=simulation, data=parts.data, context=context), "true")
    file = context.store.calibrations.all()[0].file
    closed(context)
    file.write_text(file.read_text()[:200])
    context = open_context(parts)
    try:
        line = build_home(context).checks[0]
        assert (line.state, line.quality) == ("failed", "bad")
        refusal = context.scanner.why_not()
        assert refusal is not None
        assert refusal.code == "calibration-unreadable"
        assert str(parts.data) not in refusal.line
        assert list_unreadable(context)
    finally:
        closed(context)


def test_a_calibration_whose_files_go_while_the_station_runs_is_not_valid(
    simulation: SimulatedStation, parts: StationParts
) -> None:
    context = open_context(parts)
    use_truth(SimpleNamespace(simulation=simulation, data=parts.data, context=context), "true")
    file = context.store.calibrations.all()[0].file
    try:
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
                assert str(parts.data) not in str(line.text)
            spoiled.rmdir()
            spoiled.write_bytes(content)
            assert build_home(context).checks[0].state == "valid"
    finally:
        closed(context)


def test_an_empty_database_beside_sessions_is_refused(tmp_path: Path) -> None:
    Store(tmp_path).close()
    (tmp_path / "sessions" / "one").mkdir()
    (tmp_path / "station.db").write_bytes(b"")
    with pytest.raises(OperationError, match="last backup"):
        Store(tmp_path)


def test_a_damaged_page_of_the_database_is_said_to_be_one(
    simulation: SimulatedStation, parts: StationParts
) -> None:
    context = open_context(parts)
    use_truth(SimpleNamespace(simulation=simulation, data=parts.data, context=context), "true")
    context.guide.start()
    closed(context)
    database = parts.data / "station.db"
    whole, refused = database.read_bytes(), []
    for at in range(0, len(whole), PAGE_BYTES):
        for beside in parts.data.glob("station.db-*"):
            beside.unlink()
        database.write_bytes(whole[:at] + bytes(PAGE_BYTES) + whole[at + PAGE_BYTES :])
        try:
            context = open_context(parts)
        except OperationError as refusal:
            refused.append(refusal.code)
            continue
        try:
            for look in (build_home, list_unreadable, lambda context: context.guide.start()):
                with suppress(OperationError):
                    look(context)
        finally:
            closed(context)
    assert set(refused) == {"database-unreadable"}
    assert len(refused) < len(whole) // PAGE_BYTES


def test_a_row_that_cannot_be_folded_is_not_kept(parts: StationParts) -> None:
    context = open_context(parts)
    try:
        context.guide.start()
        before = context.store.journal.last_number()
        with pytest.raises(OperationError, match="not saved"):
            context.guide.append("went_back", {"to": "nowhere"})
        assert context.store.journal.last_number() == before
        assert context.guide.state.step == "devices"
    finally:
        closed(context)


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
