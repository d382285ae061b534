"""Results of performance tests as CSV, XLSX and QIF 3.0."""

import csv
import io
import sys
from pathlib import Path
from statistics import stdev
from xml.etree import ElementTree as ET

import openpyxl
import pytest

from crenel.formats.exchange.qif import QIF
from crenel.formats.exchange.write_tables import (
    workbook_obstacle,
    write_csv_folder,
    write_workbook,
)
from crenel.formats.xml_text import local_name
from crenel.gauges.exchange.result_tables import result_tables
from crenel.gauges.exchange.write_qif import qif_bytes
from crenel.gauges.judgement.document import PerformanceFigure, PerformanceFile
from tests.gauges.judgement.results import (
    BUILDERS,
    SPHERE,
    Build,
    contact_result,
    lengths_result,
    plane_result,
    sphere_result,
)
from tests.present import present
from tests.refusals import refused_as

NAMES = {"q": QIF}
LINEAR = "UserDefinedLinearCharacteristic"
ORDER = {
    "QIFDocument": (
        "QPId! Header StandardsDefinitions FileUnits MeasurementResources Characteristics Results!"
    ),
    "Standard": "Organization! Designator! Year",
    "PrimaryUnits": "AngularUnit LinearUnit TemperatureUnit",
    "LinearUnit": "SIUnitName UnitName! UnitConversion",
    "UnitConversion": "Factor! Offset",
    "AACMM": "Name! SerialNumber Accuracies",
    "AACMMAccuracy": "EnvironmentalRange! AACMMB89Test! AccuracySource!",
    "EnvironmentalRange": "MaxAmbientTemperature MinAmbientTemperature",
    "AACMMB89Test": (
        "EffectiveDiameterPerformanceTest SinglePointArticulationPerformanceTest "
        "VolumetricPerformanceTest"
    ),
    "EffectiveDiameterPerformanceTest": "AverageDiameter! StandardDeviation!",
    "SinglePointArticulationPerformanceTest": " ".join(
        f"{value}{seat}!"
        for value in ("MaxDeviationFromAverage", "TwiceStandardDeviation")
        for seat in ("Near", "Far", "Middle")
    ),
    "VolumetricPerformanceTest": "DeviationsFromCalibration! TwiceStandardDeviation!",
    "Characteristics": (
        "FormalStandardId! CharacteristicDefinitions! CharacteristicNominals! CharacteristicItems"
    ),
    f"{LINEAR}Definition": "Description Name Tolerance NonTolerance WhatToMeasure!",
    "Tolerance": "MaxValue! MinValue DefinedAsLimit!",
    f"{LINEAR}Nominal": "CharacteristicDefinitionId! TargetValue",
    f"{LINEAR}Item": "Name CharacteristicNominalId!",
    f"{LINEAR}Measurement": "Status! CharacteristicItemId! Value",
    "MeasurementResults": "MeasuredCharacteristics InspectionStatus!",
}
"""The children of elements in the order of the schema; those with a mark are required."""
VALUES = {
    "CharacteristicStatusEnum": {"PASS", "FAIL", "INDETERMINATE", "NOT_ANALYZED", "UNDEFINED"},
    "InspectionStatusEnum": {"PASS", "FAIL", "UNKNOWN"},
    "NonTolerance": {"MEASURED", "SET"},
    "StandardsOrganizationEnum": {"ASME", "DIN", "ISO"},
}
"""What enumerations of the schema have of ours."""


class Tables:
    """The CSV files of a result."""

    def __init__(self, document: PerformanceFile, folder: Path) -> None:
        self.folder = folder
        write_csv_folder(result_tables(document), folder)

    def __getitem__(self, name: str) -> list[dict[str, str]]:
        return list(csv.DictReader(io.StringIO((self.folder / f"{name}.csv").read_text("utf-8"))))


def write_tables(document: PerformanceFile, path: Path) -> None:
    """The workbook of a result."""
    write_workbook(result_tables(document), path, document.id, document.ended_at)


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
    assert float(tables["offset"][0]["offset_mm"]) == present(document.offset).offset_mm[0]
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
    write_tables(document, tmp_path / "result.xlsx")
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
        write_tables(document, tmp_path / name)
    assert (tmp_path / "a.xlsx").read_bytes() == (tmp_path / "b.xlsx").read_bytes()
    cells = [cell for row in openpyxl.load_workbook(tmp_path / "a.xlsx")["test"] for cell in row]
    assert [cell.data_type for cell in cells if cell.value == "=1+1"] == ["s"]
    assert not [cell for cell in cells if cell.hyperlink]


def test_without_its_extra_it_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert not workbook_obstacle()
    monkeypatch.setitem(sys.modules, "xlsxwriter", None)
    assert "pip install 'crenel[xlsx]'" in str(workbook_obstacle())
    with refused_as("extra-missing", "crenel[xlsx]"):
        write_tables(sphere_result(tmp_path / "test"), tmp_path / "result.xlsx")
    assert not (tmp_path / "result.xlsx").exists()


def variants(document: PerformanceFile) -> list[PerformanceFile]:
    """The result, and what it may lack."""
    unknown = tuple(one.model_copy(update={"value": None}) for one in document.figures)
    return [
        document,
        document.model_copy(update={"figures": unknown}),
        document.model_copy(update={"figures": (), "standards": ()}),
        document.model_copy(update={"temperature_c": (None, None), "sphere": None}),
    ]


@pytest.mark.parametrize("build", BUILDERS)
def test_elements_are_in_the_order_of_the_schema_and_complete(tmp_path: Path, build: Build) -> None:
    for document in variants(build(tmp_path)):
        for element in ET.fromstring(qif_bytes(document)).iter():
            name, children = local_name(element), [local_name(child) for child in element]
            if name in ORDER:
                known = ORDER[name].replace("!", "").split()
                places = [known.index(child) for child in children]
                assert places == sorted(set(places))
                needed = {one[:-1] for one in ORDER[name].split() if one.endswith("!")}
                assert needed <= set(children)
            if name == f"{LINEAR}Definition":
                assert ("Tolerance" in children) != ("NonTolerance" in children)
            if name in VALUES:
                assert element.text in VALUES[name]


@pytest.mark.parametrize("build", BUILDERS)
def test_every_measurement_is_linked_to_its_definition(tmp_path: Path, build: Build) -> None:
    document = build(tmp_path)
    root = ET.fromstring(qif_bytes(document))
    ids = [int(one.get("id", "0")) for one in root.iter() if one.get("id")]
    assert sorted(ids) == list(range(1, int(root.get("idMax", "0")) + 1))
    by_id = {one.get("id"): one for one in root.iter() if one.get("id")}
    standard = by_id[root.findtext("q:Characteristics/q:FormalStandardId", "", NAMES)]
    assert local_name(standard) == "Standard"
    measurements = root.findall(".//q:CharacteristicMeasurements/*", NAMES)
    assert len(measurements) == len(document.figures)
    for one, figure in zip(measurements, document.figures, strict=True):
        item = by_id[one.findtext("q:CharacteristicItemId", "", NAMES)]
        nominal = by_id[item.findtext("q:CharacteristicNominalId", "", NAMES)]
        definition = by_id[nominal.findtext("q:CharacteristicDefinitionId", "", NAMES)]
        assert definition.findtext("q:Name", "", NAMES) == figure.symbol
        value = one.find("q:Value", NAMES)
        status = one.findtext("q:Status/q:CharacteristicStatusEnum", "", NAMES)
        if figure.value is None:
            assert (value, status) == (None, "NOT_ANALYZED")
            continue
        assert value is not None
        assert float(value.text or "") == pytest.approx(figure.value / 1e3, abs=6e-7)
        # the schema wants both or none
        assert (value.get("meanError") is None) == (value.get("combinedUncertainty") is None)
        assert (status == "PASS") == (figure.decision == "pass")
        largest = definition.findtext("q:Tolerance/q:MaxValue", None, NAMES)
        assert (None if largest is None else 1e3 * float(largest)) == figure.limit


@pytest.mark.parametrize("build", BUILDERS)
def test_lists_state_how_much_they_hold(tmp_path: Path, build: Build) -> None:
    for document in variants(build(tmp_path)):
        content = qif_bytes(document)
        assert content == qif_bytes(document)
        counted = [one for one in ET.fromstring(content).iter() if one.get("n")]
        assert counted
        assert all(int(one.get("n", "")) == len(one) > 0 for one in counted)


@pytest.mark.parametrize(
    ("name", "parts"),
    [
        ("ISO 10360-12:2016", ("ISO", "10360-12", "2016")),
        ("ASME B89.4.22-2004 (R2019)", ("ASME", "B89.4.22", "2004 (R2019)")),
        ("VDI 2617:2011", ("VDI", "2617", "2011")),
        ("House rule 7", ("–", "House rule 7", None)),
    ],
)
def test_a_standard_is_split(tmp_path: Path, name: str, parts: tuple[str | None, ...]) -> None:
    document = plane_result(tmp_path).model_copy(update={"standards": (name,)})
    standard = present(ET.fromstring(qif_bytes(document)).find(".//q:Standard", NAMES))
    publisher = standard.findtext("q:Organization/*", None, NAMES)
    kind = local_name(standard[0][0])
    assert (kind == "StandardsOrganizationEnum") == (publisher in ("ASME", "ISO"))
    stated = [standard.findtext(f"q:{one}", None, NAMES) for one in ("Designator", "Year")]
    assert (publisher, *stated) == parts


def numbers(part: ET.Element | None) -> list[float]:
    assert part is not None
    return [float(one.text or "nan") for one in part]


def values_mm(figure: PerformanceFigure) -> list[float]:
    return [1e-3 * (value or 0.0) for value in figure.values]


def test_the_contact_test_is_the_accuracy_of_the_arm(tmp_path: Path) -> None:
    document = contact_result(tmp_path)
    root = ET.fromstring(qif_bytes(document))
    test = present(root.find("q:MeasurementResources//q:AACMMB89Test", NAMES))
    found = {one.quantity: one for one in document.figures}
    diameter = numbers(test.find("q:EffectiveDiameterPerformanceTest", NAMES))
    errors_mm = values_mm(found["effective-diameter"])
    mean = SPHERE.diameter_mm + sum(errors_mm) / 3
    assert diameter == pytest.approx([mean, stdev(errors_mm)], abs=6e-7)
    # near, far and in the middle
    of_seats = (found["articulation-largest"], found["articulation-two-s"])
    seats = [values_mm(figure)[place] for figure in of_seats for place in (0, 2, 1)]
    articulation = test.find("q:SinglePointArticulationPerformanceTest", NAMES)
    assert numbers(articulation) == pytest.approx(seats, abs=6e-7)
    deviations = values_mm(found["volumetric-largest"])
    listed = test.find("q:VolumetricPerformanceTest/q:DeviationsFromCalibration", NAMES)
    assert numbers(listed) == pytest.approx(deviations, abs=6e-7)
    twice = test.findtext("q:VolumetricPerformanceTest/q:TwiceStandardDeviation", "", NAMES)
    assert float(twice) == pytest.approx(2 * stdev(deviations), abs=6e-7)
    conditions = root.find(".//q:EnvironmentalRange", NAMES)
    assert numbers(conditions) == [20.9, 20.4]
    arm = present(root.find(".//q:AACMM", NAMES))
    assert arm.findtext("q:SerialNumber", "", NAMES) == "A-1"


def test_incomplete_parts_of_the_contact_test_are_left_out(tmp_path: Path) -> None:
    document = contact_result(tmp_path)
    figures = tuple(
        one.model_copy(update={"values": one.values[:2]})
        if one.quantity != "volumetric-largest"
        else one
        for one in document.figures
    )
    root = ET.fromstring(qif_bytes(document.model_copy(update={"figures": figures})))
    test = present(root.find(".//q:AACMMB89Test", NAMES))
    assert [local_name(one) for one in test] == ["VolumetricPerformanceTest"]
    other = ET.fromstring(qif_bytes(sphere_result(tmp_path)))
    assert other.find(".//q:MeasurementResources", NAMES) is None
