"""Results of performance tests as CSV and XLSX."""

import csv
import io
import sys
from pathlib import Path

import openpyxl
import pytest

from app.formats.exchange.result_tables import result_tables
from app.formats.exchange.write_tables import workbook_obstacle, write_csv_tables, write_workbook
from app.formats.performance.results import PerformanceFile
from tests.formats.performance_builders import BUILDERS, Build, lengths_result, sphere_result
from tests.refusals import refused_as


class Tables:
    """The CSV files of a result."""

    def __init__(self, document: PerformanceFile, folder: Path) -> None:
        self.folder = folder
        write_csv_tables(document, folder)

    def __getitem__(self, name: str) -> list[dict[str, str]]:
        return list(csv.DictReader(io.StringIO((self.folder / f"{name}.csv").read_text("utf-8"))))


@pytest.mark.parametrize("build", BUILDERS)
def test_csv_has_every_figure_to_the_last_digit(tmp_path: Path, build: Build) -> None:
    document = build(tmp_path / "test")
    tables = Tables(document, tmp_path / "csv")
    rows = tables["figures"]
    assert [row["symbol"] for row in rows] == [one.symbol for one in document.figures]
    for row, figure in zip(rows, document.figures, strict=True):
        assert (float(row["value_um"]) if row["value_um"] else None) == figure.value
        assert row["data"].split() == list(figure.data)
        assert row["decision"] == figure.decision
    values = [value for one in document.figures for value in one.values]
    assert [float(row["value_um"]) for row in tables["values"]] == values


def test_csv_has_places_centres_and_offset(tmp_path: Path) -> None:
    document = sphere_result(tmp_path / "test")
    tables = Tables(document, tmp_path / "csv")
    places = tables["places"]
    assert len(places) == 50
    second = document.spheres[1]
    assert float(places[30]["touched_um"]) == second.touch_deviations_um[5]
    assert float(places[30]["scanned_um"]) == second.patches[5].deviation_um
    centres = tables["centres"]
    assert len(centres) == 30
    scanned = [row for row in centres if row["by"] == "scan" and row["position"] == "1"]
    assert float(scanned[4]["z_mm"]) == document.spheres[0].scan_centres_mm[4][2]
    assert document.offset is not None
    assert float(tables["offset"][0]["offset_mm"]) == document.offset.offset_mm[0]
    assert len(tables["inputs"]) == 11


def test_csv_has_the_105_lengths(tmp_path: Path) -> None:
    document = lengths_result(tmp_path / "test")
    tables = Tables(document, tmp_path / "csv")
    errors_um = [float(row["error_um"]) for row in tables["lengths"]]
    assert errors_um == [one.error_um for one in document.lengths]
    assert len(errors_um) == 105
    about = {row["name"]: row["value"] for row in tables["test"]}
    artefact_c = [about[f"artefact_temperature_{at}_c"] for at in ("start", "end")]
    assert artefact_c == ["20.2", "20.7"]
    assert (about["arm_temperature_end_c"], about["temperature_steady"]) == ("21.9", "true")


@pytest.mark.parametrize("build", BUILDERS)
def test_another_program_reads_the_same_from_a_workbook(tmp_path: Path, build: Build) -> None:
    document = build(tmp_path / "test")
    write_workbook(document, tmp_path / "result.xlsx")
    book = openpyxl.load_workbook(tmp_path / "result.xlsx")
    tables = result_tables(document)
    assert book.sheetnames == [table.name for table in tables]
    for table in tables:
        rows = list(book[table.name].iter_rows(values_only=True))
        assert rows[0] == table.columns
        for found, row in zip(rows[1:], table.rows, strict=True):
            for cell, value in zip(found, row, strict=True):
                # XLSX has 16 digits, and an empty text is an empty cell
                exact = isinstance(value, str) or value is None
                assert cell == ((value or None) if exact else pytest.approx(value, rel=1e-14))


def test_a_workbook_is_the_same_again_and_has_no_formulas(tmp_path: Path) -> None:
    document = sphere_result(tmp_path / "test").model_copy(
        update={"operator": "=1+1", "station": "https://example.com"}
    )
    for name in ("a.xlsx", "b.xlsx"):
        write_workbook(document, tmp_path / name)
    assert (tmp_path / "a.xlsx").read_bytes() == (tmp_path / "b.xlsx").read_bytes()
    cells = [cell for row in openpyxl.load_workbook(tmp_path / "a.xlsx")["test"] for cell in row]
    assert [cell.data_type for cell in cells if cell.value == "=1+1"] == ["s"]
    assert not [cell for cell in cells if cell.hyperlink]


def test_without_the_extra_the_error_names_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert not workbook_obstacle()
    monkeypatch.setitem(sys.modules, "xlsxwriter", None)
    assert "pip install 'crenel[xlsx]'" in str(workbook_obstacle())
    with refused_as("extra-missing", "crenel[xlsx]"):
        write_workbook(sphere_result(tmp_path / "test"), tmp_path / "result.xlsx")
    assert not (tmp_path / "result.xlsx").exists()
