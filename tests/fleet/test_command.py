"""``crenel catalogue`` on the data folder of a station."""

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner, Result

from crenel.cli.main import cli
from crenel.fleet.catalogue.catalogue import FleetCatalogue
from crenel.store.store import Store
from tests.fleet.records import add_every_kind
from tests.fleet.test_ageing import ageing_station
from tests.fleet.test_questions import ten_months

pytestmark = pytest.mark.device

FILE = "[catalogue]\ndatabase = 'sqlite:///a.db'\n"
SETTINGS = """
[catalogue]
database = "sqlite:///catalogue.db"

[stations.room-1]
name = "Measuring room 1"
data = "data"

[stations.room-2]
archive = { url = "archive-of-room-2" }
"""


@pytest.fixture
def config(store: Store, tmp_path: Path) -> Path:
    """Of a fleet whose first station has a record of every kind."""
    add_every_kind(store)
    path = tmp_path / "fleet.toml"
    path.write_text(SETTINGS)
    return path


@pytest.fixture
def empty(own: FleetCatalogue, tmp_path: Path) -> Path:
    """The settings of a fleet without stations, whose catalogue is ``own``."""
    path = tmp_path / "fleet.toml"
    path.write_text('[catalogue]\ndatabase = "sqlite:///catalogue.db"\n')
    return path


def run(config: Path, *arguments: str) -> Result:
    return CliRunner().invoke(cli, ["catalogue", *arguments, "--config", str(config)])


def refusal(config: Path, *arguments: str) -> str:
    refused = run(config, *arguments)
    assert (refused.exit_code, refused.stderr.count("\n")) == (1, 1), refused.stderr
    return refused.stderr


def test_a_station_is_collected_and_shown(config: Path, caplog: pytest.LogCaptureFixture) -> None:
    collected = run(config, "collect")
    assert "7 records are new" in collected.stdout
    assert "room-2: The archive" in collected.stderr
    assert not caplog.records  # on a console, they would say it once more
    assert collected.exit_code == 3  # of one station of two
    found = json.loads(run(config, "search", "housing 4711", "--json").stdout)["records"]
    assert [one["id"] for one in found] == ["20260504-111500"]
    assert "Housing 4711" in run(config, "search", "--since", "2026-05-04", "--kind", "scan").stdout
    newest = run(config, "search", "--most", "2").stdout
    assert newest.startswith("the newest 2 records; there are more")
    assert run(config, "search", "--most", "7").stdout.startswith("7 records")
    shown = run(config, "show", "room-1", "tip_check", "20260504-080000-dd44")
    assert "tip-diameter-error" in shown.stdout
    assert "-100 µm" in shown.stdout
    stations = json.loads(run(config, "status", "--json").stdout)["stations"]
    assert [(one["id"], one["records"]) for one in stations] == [("room-1", 7), ("room-2", 0)]
    assert stations[1]["problem"]
    assert "record.parquet: 7 rows" in run(config, "export", str(config.parent / "tables")).stdout


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("[stations.room-1]\ndata = 'data'\n", "[catalogue] is missing"),
        ("[catalogue]\n", "database is missing. Add it as docs/fleet.md shows."),
        (
            f"{FILE}[stations.Room_2]\ndata = 'data'\n",
            "the name of the table [stations.Room_2]: it must be lower-case letters",
        ),
        ("[catalogue]\ndatabase = 'nonsense'\n", "nonsense is no address of a catalogue"),
        ("[catalogue]\ndatabase = 'sqlite://'\n", "it names no file"),
        (f"{FILE}[stations.a]\n", "[stations.a]: there is neither"),
        (
            f"{FILE}[stations.a]\ndata = 'data'\n[stations.b]\ndata = './x/../data/'\n",
            "the stations a and b have the same place",
        ),
        (
            f"{FILE}[stations]\na.archive.url = 's3://p/a'\nb.archive.url = 's3://p/a/'\n",
            "the stations a and b have the same place, s3://p/a/",
        ),
        ("[catalogue]\ndatabase = 'postgresql://u@127.0.0.1:1/a'\n", "cannot be used now"),
    ],
)
def test_settings_that_cannot_work_are_one_clear_line(tmp_path: Path, text: str, said: str) -> None:
    path = tmp_path / "fleet.toml"
    path.write_text(text)
    assert said in refusal(path, "status")


def test_missing_settings_are_named(tmp_path: Path) -> None:
    assert "there is no such file" in refusal(tmp_path / "none.toml", "status")


def test_the_questions_are_answered(config: Path) -> None:
    run(config, "collect")
    used = json.loads(run(config, "calibration", "4711", "--json").stdout)["recordings"]
    assert [one["calibration"]["label"] for one in used] == ["Calibration of May"]
    assert "Calibration of May" not in run(config, "drift", "arm-largest").stdout
    assert "1 value of 1 station, 0 changes" in run(config, "drift", "arm-largest").stdout
    assert "choose one of arm-half-range" in run(config, "drift", "size").stderr
    reversed_days = ("--since", "2026-06-01", "--until", "2026-05-01")
    assert "is not after" in run(config, "drift", "arm-largest", *reversed_days).stderr
    assert "Arm check: largest distance" in run(config, "drift", "arm-largest").stdout
    spread = json.loads(run(config, "spread", "laser-plane-offset", "--json").stdout)
    assert [len(one["values"]) for one in spread["sensors"]] == [1]
    assert "Offset of the laser plane" in run(config, "spread", "laser-plane-offset").stdout
    assert "choose one of" in run(config, "spread", "size").stderr
    alone = CliRunner().invoke(cli, ["drift", "arm-largest", "--config", str(config)])
    assert alone.stdout == run(config, "drift", "arm-largest").stdout


def test_a_planted_change_is_printed_with_its_recordings(empty: Path, own: FleetCatalogue) -> None:
    own.add(ten_months((120, 150), by_calibration=True))
    printed = run(empty, "drift", "location-scan", "--station", "room-3").stdout
    assert "cal-4" in printed
    assert "room-3/scan/scan-120" in printed
    assert printed.count("room-3/scan/") == 30
    (period,) = json.loads(run(empty, "drift", "location-scan", "--json").stdout)["periods"]
    assert len(period["recordings"]) == 30
    assert "has 3 values or more" in printed
    assert "90 of 100 values: the first level" in printed
    chosen = run(empty, "drift", "location-scan", "--right-since", "2025-05-10").stdout
    assert "10 of 100 values: chosen" in chosen
    assert chosen.count("room-3/scan/") == 270


def test_values_that_stand_out_are_printed_alone(empty: Path, own: FleetCatalogue) -> None:
    own.add(ten_months((121, 126), by_calibration=True))
    own.add(ten_months((0, 30), by_calibration=True, station="room-4"))
    printed = run(empty, "drift", "location-scan").stdout
    assert (printed.count("stands out"), printed.count("too few for a period")) == (2, 1)
    assert "room-3/scan/" not in printed
    assert "differed from" in printed
    assert "90 of 100 values: that of most values" in printed
    assert printed.count("room-4/scan/") == 30


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("search", "--kind", "perfromance"), "no kind perfromance; choose one of calibration,"),
        (("show", "room-1", "scn", "x"), "no kind scn; choose one of calibration,"),
        (("search", "--station", "room-99"), "There are: room-1, room-2."),
        (("calibration", "4711", "--station", "room-99"), "no station room-99 in the catalogue"),
        (("drift", "arm-largest", "--station", "room-99"), "no station room-99 in the catalogue"),
        (("spread", "arm-largest", "--station", "room-99"), "no station room-99 in the catalogue"),
        (("ageing", "arm-largest", "--station", "room-99"), "no station room-99 in the catalogue"),
    ],
)
def test_what_is_misspelt_is_named(config: Path, words: tuple[str, ...], said: str) -> None:
    run(config, "collect")
    assert said in refusal(config, *words)


def test_nothing_found_is_said(config: Path) -> None:
    assert "no values of size: the catalogue has no results" in run(config, "spread", "size").stderr
    run(config, "collect")
    assert run(config, "search", "--since", "2031-01-01").stdout == "No record is found.\n"
    assert run(config, "search", "4711", "--kind", "performance").stdout == "No record is found.\n"
    assert run(config, "calibration", "4999").stdout == "No scan is found.\n"
    one = run(config, "search", "housing", "--kind", "scan").stdout
    assert "1 record" in one
    assert "1 records" not in one
    backwards = refusal(config, "search", "--since", "2026-05-04", "--until", "2026-05-01")
    assert backwards == "crenel: --until 2026-05-01 is not after --since 2026-05-04.\n"


def test_ageing_is_printed_for_each_station(empty: Path, own: FleetCatalogue) -> None:
    own.add(ageing_station("room-1", 6.0, 1.5))
    own.add(ageing_station("room-22", 0.0, 0.0))
    printed = run(empty, "ageing", "gauge-offset").stdout
    assert "Gauge: Distance from the touched plane" in printed
    assert "none shown" in printed
    found = json.loads(run(empty, "ageing", "gauge-offset", "--station", "room-1", "--json").stdout)
    (aged,) = found["stations"]
    assert abs(aged["per_1000_h"]["value"] - 6.0) < 2 * aged["per_1000_h"]["expanded_uncertainty"]
