"""The Parquet files hold the catalogue, and the document's questions are answered from them."""

import re
from datetime import timedelta
from pathlib import Path

import pytest

pytest.importorskip("duckdb")
pytest.importorskip("pyarrow")
pytest.importorskip("sqlalchemy")

import duckdb

from crenel.fleet.catalogue.catalogue import FleetCatalogue
from crenel.fleet.exports import export_parquet
from tests.bench.fleet.invented import START, PlantedStep, invent_entries

pytestmark = pytest.mark.device

PAGE = (Path(__file__).parents[2] / "docs/fleet.md").read_text(encoding="utf-8")
QUESTIONS = re.findall(r"^```sql\n(.*?)^```$", PAGE, re.MULTILINE | re.DOTALL)
DAY = timedelta(days=1)
FAILING = PlantedStep("room-2", START + 120 * DAY, START + 150 * DAY, by_um=50.0)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("exports")
    with FleetCatalogue(f"sqlite:///{path}/catalogue.db") as catalogue:
        catalogue.add(list(invent_entries(3, 3000, 1, timedelta(hours=7.2), [FAILING])))
        with catalogue.reading() as connection:
            rows = export_parquet(connection, path)
    assert (rows["record"], len(QUESTIONS)) == (3000, 5)
    return path


def ask(folder: Path, question: str) -> list[dict[str, object]]:
    with duckdb.connect() as connection:
        connection.execute("SET TimeZone = 'UTC'")
        found = connection.execute(re.sub(r"'(\w+\.parquet)'", rf"'{folder}/\1'", question))
        names = [column[0] for column in found.description]
        return [dict(zip(names, row, strict=True)) for row in found.fetchall()]


def test_scans_of_each_month(folder: Path) -> None:
    found = ask(folder, QUESTIONS[0])
    assert {one["station"] for one in found} == {"room-1", "room-2", "room-3"}
    (scans,) = ask(folder, "SELECT count(*) AS n FROM 'record.parquet' WHERE kind = 'scan'")
    assert sum(int(str(one["scans"])) for one in found) == scans["n"]


def test_location_errors_by_quarter(folder: Path) -> None:
    found = ask(folder, QUESTIONS[1])
    assert max(found, key=lambda one: float(str(one["worst_95_um"])))["station"] == "room-2"
    assert {one["limit_um"] for one in found} == {60.0}


def test_dependence_on_temperature(folder: Path) -> None:
    found = ask(folder, QUESTIONS[2])
    assert len(found) == 3 * 6
    assert all(abs(float(str(one["correlation"]))) < 1 for one in found)


def test_scans_before_a_failed_test(folder: Path) -> None:
    found = ask(folder, QUESTIONS[3])
    assert found
    assert {one["station"] for one in found} == {"room-2"}
    assert all(str(one["made_at"]) < str(one["failed_at"]) for one in found)


def test_the_laser_plane_from_calibration_to_calibration(folder: Path) -> None:
    found = ask(folder, QUESTIONS[4])
    assert len(found) == 3 * 10
    assert sum(one["moved_um"] is None for one in found) == 3
