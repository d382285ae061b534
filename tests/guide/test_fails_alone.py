"""What fails in one check or one part of the support bundle is reported in its place alone."""

import asyncio
import io
import json
import zipfile
from collections.abc import Iterator
from pathlib import Path

import pytest

from crenel.api.monitoring.support import LOG_BYTES, bundle
from crenel.errors import OperationError
from crenel.operations.context import Context
from crenel.operations.health_checks import HealthChecker
from crenel.operations.publishers import tick
from crenel.operations.status_report import build_report
from crenel.operations.unreadable_files import list_unreadable
from crenel_hardware.simulator.station import SimulatedStation
from tests.guide.stations import Station

pytestmark = pytest.mark.device

ADDRESSES = ("http://[", "http://a[b]/", "http://x:99999999/", "http://x\u202e/", "ftp://x/")


@pytest.fixture(scope="module")
def simulation() -> Iterator[SimulatedStation]:
    with SimulatedStation() as simulation:
        yield simulation


@pytest.fixture
def station(simulation: SimulatedStation, tmp_path: Path) -> Station:
    return Station(simulation, tmp_path)


@pytest.fixture
def context(station: Station) -> Iterator[Context]:
    with station.opened() as context:
        yield context


def bundled(context: Context) -> dict[str, str]:
    with zipfile.ZipFile(io.BytesIO(bundle(context))) as archive:
        return {name: archive.read(name).decode() for name in archive.namelist()}


def are_made(files: dict[str, str]) -> bool:
    return not any(text.startswith("This part could not be created") for text in files.values())


def all_are_checked(context: Context) -> bool:
    return not any(item.id.startswith("not-made") for item in HealthChecker(context).look().items)


@pytest.mark.parametrize("url", ADDRESSES)
def test_an_address_that_is_none_is_not_read_from_the_file(station: Station, url: str) -> None:
    (station.data / "notifications.json").write_text(json.dumps({"url": url, "secret": "s"}))
    with station.opened() as context:
        assert context.monitoring.webhook.settings.url == ""
        assert all_are_checked(context)
        assert are_made(bundled(context))


def test_a_failed_check_stops_no_other(context: Context, monkeypatch: pytest.MonkeyPatch) -> None:
    whole = {item.id for item in HealthChecker(context).look().items}

    def broken(*_: object) -> list[str]:
        raise IndexError("a fault of the program")

    def refused(*_: object) -> str:
        raise OperationError("database-unreadable", "The database cannot be read")

    monkeypatch.setattr("crenel.operations.health_checks.list_unreadable", broken)
    monkeypatch.setattr(type(context.store), "check", refused)
    items = {item.id: item for item in HealthChecker(context).look().items}
    assert str(items["not-made-records"].what) == "The check records could not run: IndexError."
    assert items["not-made-database"].quality == "attention"
    assert "The database cannot be read" in str(items["not-made-database"].what)
    assert whole - set(items) == {"records", "database"}


def test_a_failed_guide_stops_no_other(context: Context, monkeypatch: pytest.MonkeyPatch) -> None:
    done: list[str] = []

    def broken() -> None:
        raise IndexError("a fault of the program")

    for name in ("guide", "verify_guide"):
        monkeypatch.setattr(getattr(context, name), "refresh", broken)
    for name in ("arm_guide", "performance_guide"):
        monkeypatch.setattr(getattr(context, name), "refresh", lambda name=name: done.append(name))
    monkeypatch.setattr(context.recovery, "step", lambda: done.append("recovery"))

    async def until_home() -> None:
        task = asyncio.create_task(tick(context))
        while context.bus.latest("home") is None:
            await asyncio.sleep(0)
        task.cancel()

    asyncio.run(until_home())
    assert done[:3] == ["arm_guide", "performance_guide", "recovery"]


def test_a_failed_part_holds_its_error(context: Context, monkeypatch: pytest.MonkeyPatch) -> None:
    def broken(_: Context) -> object:
        raise IndexError(f"in {context.store.folder}")

    monkeypatch.setattr("crenel.api.monitoring.support.build_report", broken)
    files = bundled(context)
    assert files["report.json"].startswith("This part could not be created.\n")
    assert "IndexError: in DATA" in files["report.json"]
    assert json.loads(files["health.json"])["items"]
    assert len(files) >= 9


def test_odd_rows_and_endless_logs_are_bundled(context: Context) -> None:
    context.store.journal.begin_session("odd", "calibration")
    payload = '{"field": "arm", "id": "\\ud800", "long": "%s"}' % ("a" * 200_000)
    with context.store._database.transaction() as connection:
        connection.execute(
            "INSERT INTO journal (session_id, at, kind, payload) VALUES ('odd', '', 'chosen', ?)",
            (payload,),
        )
    logs = context.monitoring.logs.folder
    with (logs / "station.jsonl.1").open("wb") as file:
        file.truncate(1 << 42)
        file.seek(0, 2)
        file.write(b'\n{"text": "the last line"}\n')
    (logs / "station.jsonl.2").write_bytes(b"x" * (LOG_BYTES + 5) + b"\n" + b"[" * 100_000)
    files = bundled(context)
    row = json.loads(files["journal.jsonl"].splitlines()[-1])
    assert row["payload"]["id"] == "\ud800"
    assert json.loads(files["logs/station.jsonl.1"].splitlines()[-1])["text"] == "the last line"
    assert len(files["logs/station.jsonl.2"]) < 2 * LOG_BYTES
    assert are_made(files)


@pytest.mark.parametrize("total_um", ["-1e308", "1e308", "-1", "1e999", "NaN", '"many"'])
def test_figures_that_no_calibration_has_are_set_aside(station: Station, total_um: str) -> None:
    figures = json.dumps({"verdict": "good", **dict.fromkeys(("arm_serial", "object_serial"), "")})
    figures = f'{figures[:-1]}, "sensor_serial": "", "total_um": {total_um}}}'
    with station.opened(calibrated=True) as context:
        (record,) = context.store.calibrations.all()
        with context.store._database.transaction() as connection:
            connection.execute("UPDATE calibration SET figures = ?", (figures,))
        assert context.store.calibrations.all() == []
        assert [one.id for one in context.store.calibrations.unreadable()] == [record.id]
        assert any("is unreadable" in str(text) for text in list_unreadable(context))
        assert build_report(context).calibration is None
        assert all_are_checked(context)
