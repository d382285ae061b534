"""Results of an inspection as CSV, XLSX, QIF, page and paper; and its map of deviations."""

import csv
import json
import shutil
from dataclasses import replace
from pathlib import Path
from xml.etree import ElementTree as ET

import numpy as np
import openpyxl
import pytest
from typer.testing import CliRunner

from crenel.cli.main import cli
from crenel.formats.xml_text import local_name
from crenel.metrology.decision import GUARDED_95
from crenel.parts.cad.evaluate_part import read_part
from crenel.parts.deviation.evaluate_deviation import DeviationOrder, deviate
from crenel.parts.deviation.evaluate_inspection_map import map_part, read_inspected_part
from crenel.parts.deviation.maths_decisions import IN, OUT, DeviationLimits
from crenel.parts.document_results import InspectionFile
from crenel.parts.evaluate import align_part, judge_part, measure_part
from crenel.parts.evaluate_folder import find_files
from crenel.parts.evaluate_temperature import PartTemperature
from crenel.parts.exchange.write_qif import qif_bytes
from crenel.report.contents.reports import render_report
from tests.parts.draws import first_setting, write_draw
from tests.parts.simulated_inspection import draw_station, plan_passes, usual_passes
from tests.parts.simulated_plate import Plate
from tests.parts.simulated_plate_folder import LIMITS_MM, write_plate_folder
from tests.refusals import refused_as

pytestmark = pytest.mark.slow

ORDER = {
    "QIFDocument": "QPId! Header StandardsDefinitions FileUnits Features Characteristics Results!",
    "Features": "FeatureDefinitions FeatureNominals FeatureItems",
    "PlaneFeatureDefinition": "",
    "CylinderFeatureDefinition": "InternalExternal! Diameter!",
    "SphereFeatureDefinition": "InternalExternal! Diameter!",
    "ConeFeatureDefinition": "InternalExternal! Diameter! HalfAngle!",
    "PlaneFeatureNominal": "Name FeatureDefinitionId! Location! Normal!",
    "CylinderFeatureNominal": "Name FeatureDefinitionId! Axis!",
    "ConeFeatureNominal": "Name FeatureDefinitionId! Axis!",
    "SphereFeatureNominal": "Name FeatureDefinitionId! Location!",
    "PlaneFeatureItem": "FeatureNominalId FeatureName! DeterminationMode!",
    "DeterminationMode": "Checked!",
    "Axis": "AxisPoint! Direction!",
    "PlaneFeatureMeasurement": "FeatureItemId FeatureName Location Normal",
    "CylinderFeatureMeasurement": "FeatureItemId FeatureName Axis Diameter",
    "ConeFeatureMeasurement": "FeatureItemId FeatureName Axis Diameter HalfAngle",
    "SphereFeatureMeasurement": "FeatureItemId FeatureName Location Diameter",
    "UserDefinedLinearCharacteristicDefinition": "Name Tolerance NonTolerance WhatToMeasure!",
    "UserDefinedAngularCharacteristicDefinition": "Name Tolerance NonTolerance WhatToMeasure!",
    "Tolerance": "MaxValue MinValue DefinedAsLimit!",
    "UserDefinedLinearCharacteristicItem": "Name FeatureItemIds CharacteristicNominalId!",
    "MeasurementResults": "MeasuredFeatures MeasuredCharacteristics InspectionStatus!",
}
"""The children of elements in the order of the schema; those with a mark are required."""


@pytest.fixture(scope="module")
def inspected(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the results in all forms."""
    folder = tmp_path_factory.mktemp("inspected")
    write_draw(folder, first_setting(), 3)
    names = ("results.json", "r.csv", "r.xlsx", "r.qif", "r.html", "r.pdf")
    outputs = [text for name in names for text in ("-o", str(folder / name))]
    run = CliRunner().invoke(cli, ["inspect", str(folder), *outputs])
    assert run.exit_code == 4, run.output
    return folder


@pytest.fixture(scope="module")
def result(inspected: Path) -> InspectionFile:
    return InspectionFile.read(inspected / "results.json")


def test_csv_and_workbook_have_every_dimension(inspected: Path, result: InspectionFile) -> None:
    with (inspected / "r.csv").open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert [row["dimension"] for row in rows] == [one.id for one in result.dimensions]
    for row, one in zip(rows, result.dimensions, strict=True):
        assert float(row["measured"]) == one.value
        assert one.standard_uncertainty is not None
        assert float(row["U_k2"]) == 2 * one.standard_uncertainty
        assert row["decision"] == one.decision
        squares = sum(float(value or 0) ** 2 for name, value in row.items() if name[:2] == "u_")
        assert squares == pytest.approx(one.standard_uncertainty**2, rel=1e-6)
    book = openpyxl.load_workbook(inspected / "r.xlsx")
    assert {"dimensions", "features", "exclusions", "alignment", "correlation"} < set(
        book.sheetnames
    )
    cells = list(book["dimensions"].iter_rows(min_row=2, values_only=True))
    assert [row[0] for row in cells] == [one.id for one in result.dimensions]
    assert book["correlation"].max_column == 1 + len(result.dimensions)


def test_qif_has_features_and_characteristics_in_the_order_of_the_schema(
    inspected: Path, result: InspectionFile
) -> None:
    root = ET.fromstring((inspected / "r.qif").read_bytes())
    for element in root.iter():
        name, children = local_name(element), [local_name(child) for child in element]
        if name in ORDER:
            known = ORDER[name].replace("!", "").split()
            places = [known.index(child) for child in children]
            assert places == sorted(set(places)), name
            assert {one[:-1] for one in ORDER[name].split() if one.endswith("!")} <= set(children)
        if (count := element.get("n")) is not None:
            assert int(count) == len(children) > 0, name
    ids = [int(one.get("id", "0")) for one in root.iter() if one.get("id")]
    assert sorted(ids) == list(range(1, int(root.get("idMax", "0")) + 1))
    by_id = {one.get("id"): local_name(one) for one in root.iter() if one.get("id")}
    for element in root.iter():
        if local_name(element).endswith("ItemId"):
            assert by_id[element.text].endswith("Item")
        if local_name(element) == "FeatureItemIds":
            assert all(by_id[one.text].endswith("FeatureItem") for one in element)


def test_qif_states_what_was_measured_with_its_uncertainty(
    inspected: Path, result: InspectionFile
) -> None:
    root = ET.fromstring((inspected / "r.qif").read_bytes())
    space = {"q": "http://qifstandards.org/xsd/qif3"}
    measured = root.findall(".//q:CharacteristicMeasurements/*", space)
    words = {"pass": "PASS", "fail": "FAIL", "undecided": "INDETERMINATE", "none": "UNDEFINED"}
    for element, one in zip(measured, result.dimensions, strict=True):
        value = element.find("q:Value", space)
        assert value is not None
        assert float(value.text or "") == pytest.approx(one.value, abs=1e-6)
        u = float(value.get("combinedUncertainty", "nan"))
        assert u == pytest.approx(one.standard_uncertainty, abs=1e-6)
        status = element.find("q:Status/q:CharacteristicStatusEnum", space)
        assert status is not None
        assert status.text == words[one.decision]
    bore = next(one for one in result.features if one.id == "H1")
    found = root.find(".//q:CylinderFeatureMeasurement/q:Diameter", space)
    assert found is not None
    assert float(found.text or "") == pytest.approx(bore.parameters["diameter_mm"], abs=1e-6)
    own = next(one for one in result.dimensions if one.id == "d-H1")
    u = float(found.get("combinedUncertainty", "nan"))
    assert u == pytest.approx(own.standard_uncertainty, rel=1e-3)


def test_the_same_data_give_the_same_bytes_and_the_report_says_all(
    inspected: Path, result: InspectionFile, tmp_path: Path
) -> None:
    page = (inspected / "r.html").read_text("utf-8")
    for one in result.dimensions:
        assert f"<td>{one.id}</td>" in page
    for text in ("at the datums", "at the far corner", "ISO 14253-1", "Calibration", "outliers"):
        assert text in page
    for warning in result.warnings:
        assert str(warning)[:30] in page
    again = [str(tmp_path / f"r.{form}") for form in ("csv", "xlsx", "qif", "html", "pdf")]
    outputs = [text for name in again for text in ("-o", name)]
    CliRunner().invoke(cli, ["inspect", str(inspected), *outputs])
    for name in again:
        assert Path(name).read_bytes() == (inspected / Path(name).name).read_bytes(), name
    whole = [render_report(inspected, form, "de") for form in (".html", ".html", ".pdf", ".pdf")]
    assert whole[0] == whole[1]
    assert whole[2] == whole[3]
    assert "unverändert" in whole[0].decode()
    assert qif_bytes(result) == (inspected / "r.qif").read_bytes()


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("-o", "r.docx"), "results are not written in this form"),
        (("--map", "map.stl"), "results are not written in this form"),
        (("-o", "r.html", "--language", "xx"), "there is no language xx"),
        (("--map", "map.ply"), "a map needs a scan"),
        (("-o", "{folder}/arm.json"), "arm.json"),
    ],
)
def test_what_cannot_be_written_is_refused_before_anything_is_measured(
    inspected: Path, tmp_path: Path, arguments: tuple[str, ...], said: str
) -> None:
    folder = shutil.copytree(inspected, tmp_path / "part")
    for scan in (folder / "scans").iterdir():
        scan.write_bytes(b"never read")
    given = [one.format(folder=folder) for one in arguments]
    run = CliRunner().invoke(cli, ["inspect", str(folder), *given])
    assert run.exit_code == 1
    assert said in run.stderr
    assert len(run.stderr.strip().splitlines()) == 1


def test_lengths_are_those_at_20_degrees_and_u_has_the_temperature(inspected: Path) -> None:
    found = measure_part(find_files(inspected))
    program = found.inspection.program
    part = program.part.model_copy(update={"expansion_per_c": 2e-5})
    inspection = replace(found.inspection, program=program.model_copy(update={"part": part}))
    warm = replace(found, inspection=inspection)
    usual = {one.id: one for one in judge_part(warm).dimensions}
    result = judge_part(warm, GUARDED_95, PartTemperature(30.0, 1.0))
    assert any("at 20 °C" in str(text) for text in result.warnings)
    for one in result.dimensions:
        before = usual[one.id]
        assert one.standard_uncertainty is not None
        assert before.standard_uncertainty is not None
        length = 0.0 if one.unit == "deg" or one.kind == "position" else before.value
        if one.kind != "position":
            assert one.value - before.value == pytest.approx(-2e-4 * length, abs=1e-5)
            added = one.contributions["temperature"]
            assert added == pytest.approx(np.hypot(2e-5, 10 * 2e-6) * abs(length), abs=1e-5)
        squares = sum(value**2 for value in one.contributions.values())
        assert squares == pytest.approx(one.standard_uncertainty**2, rel=1e-6)
    with refused_as("part-expansion", "expands"):
        judge_part(found, GUARDED_95, PartTemperature(30.0, 1.0))
    with refused_as("part-temperature", "300.0"):
        judge_part(warm, GUARDED_95, PartTemperature(300.0, 1.0))


def test_the_diameter_of_the_tip_is_an_error_of_all_touches(tmp_path: Path) -> None:
    write_draw(tmp_path, first_setting(), 5, both=("H1",))
    widths = []
    for tip_um in (0.0, 4.0):
        found = measure_part(find_files(tmp_path, tip_um=tip_um))
        bore = found.wanted.index(("H1", "touch"))
        widths.append(4 * found.knowledge.block(bore)[-1, -1])
    assert widths[1] - widths[0] == pytest.approx(0.004**2, rel=1e-3)


@pytest.fixture(scope="module")
def plate_folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("plate")
    station = draw_station(4)
    planned = plan_passes(station, usual_passes(Plate()), 2)
    write_plate_folder(folder, Plate(), station, planned, 71)
    return folder


def test_a_map_in_the_frame_of_its_own_datums_is_decided_as_its_truth(plate_folder: Path) -> None:
    files, plate = find_files(plate_folder), Plate()
    found = measure_part(files)
    result = map_part(found, read_inspected_part(files), GUARDED_95)
    cells = result.placed.cells
    x, y, z = cells.at_mm.T
    on_top = (cells.normals[:, 2] > 0.9) & (z < plate.top_mm + 1)
    true = plate.relief_mm(x, y) * on_top
    x0, y0, x1, y1, _ = plate.step
    clear = np.minimum.reduce([x - x0, x1 - x, y - y0, y1 - y]) < -2
    dent, bump, flat = true == -0.05, true == 0.15, on_top & (true == 0) & clear
    assert min(dent.sum(), bump.sum()) > 10
    assert not (result.decisions[dent] == IN).any()
    assert (result.decisions[bump] == OUT).all()
    assert not (result.decisions[flat] == OUT).any()
    pulls = ((cells.deviation_mm - true) / result.u_mm)[flat]
    assert 0.6 < float(np.sqrt(np.mean(pulls**2))) < 1.5
    # what datums and cells share cancels: as if independent, the same cells are known far less
    align_part(files).write(plate_folder / "alignment.json")
    apart = deviate(
        DeviationOrder(
            files.scans[0],
            read_part(plate_folder / "part.stl"),
            files.calibration,
            files.arm,
            plate_folder / "alignment.json",
            DeviationLimits(*LIMITS_MM),
            1.5,
        )
    )
    assert np.median(apart.u_mm) > 2 * np.median(result.u_mm[flat])


def test_the_command_writes_the_map_and_ends_by_it(plate_folder: Path, tmp_path: Path) -> None:
    results, plan = tmp_path / "results.json", tmp_path / "map.ply"
    arguments = ["inspect", str(plate_folder), "-o", str(results), "--map", str(plan), "--json"]
    run = CliRunner().invoke(cli, arguments)
    assert run.exit_code == 4, run.output
    said = json.loads(run.stdout)
    assert said["map"]["decision"] == "fail"
    assert said["map"]["outside"] > 10
    assert said["files"] == [str(results), str(plan)]
    assert plan.read_bytes().startswith(b"ply")
    assert InspectionFile.read(results).verdict == "fail"
