"""A performance test as QIF 3.0 results: one characteristic for each symbol, with its value.

QIF 3.0 has no type for ISO 10360-12. Every symbol is therefore a user-defined linear characteristic
whose name is the symbol. A contact test is also written as ``AACMMB89Test``, the accuracy of the
arm among the measurement resources. The order and the required parts of all elements are those of
the schema of QIF 3.0, which is no part of the program (see ``check_schema``).
"""

import re
import uuid
from xml.etree import ElementTree as ET

from crenel.formats.xml_text import add, xml_bytes
from crenel.gauges.exchange.write_qif_arm import (
    QIF,
    add_arm,
    air_temperatures_c,
    arm_test_parts,
    in_mm,
    qif_name,
)
from crenel.gauges.judgement.document import PerformanceFigure, PerformanceFile
from crenel.gauges.plan.document_symbols import is_signed
from crenel.metrology.decision import Decision

VERSION = "3.0.0"
STATUS: dict[Decision, str] = {
    "pass": "PASS",
    "fail": "FAIL",
    "uncertain": "INDETERMINATE",
    "none": "UNDEFINED",
}
INSPECTION = {"pass": "PASS", "fail": "FAIL", "uncertain": "UNKNOWN"}
KIND = "UserDefinedLinearCharacteristic"
UNITS = (
    ("AngularUnit", "radian", "degree", "0.017453292519943295", ""),
    ("LinearUnit", "meter", "mm", "0.001", ""),
)
CELSIUS = ("TemperatureUnit", "kelvin", "Celsius", "1", "273.15")
STANDARD = re.compile(r"(?P<publisher>\w+) (?P<designator>\S+?)[:-](?P<year>\d{4}\b.*)")
PUBLISHERS = ("ASME", "DIN", "ISO")
"""Those of ours that QIF enumerates."""
NAMESPACE = uuid.uuid5(uuid.NAMESPACE_URL, QIF)


def qif_bytes(document: PerformanceFile) -> bytes:
    """The file, UTF-8, with identical bytes for the same result; lengths are in mm.

    Source:
        ANSI/DMSC Quality Information Framework 3.0: characteristics, results, resources.
    """
    ET.register_namespace("", QIF)
    root = ET.Element(qif_name("QIFDocument"), {"versionQIF": VERSION})
    add(root, qif_name("QPId"), _unique_id(document))
    application = add(add(root, qif_name("Header")), qif_name("Application"))
    add(application, qif_name("Name"), f"{document.software.name} {document.software.version}")
    # definitions, nominals, items and measurements are numbered one after the other, then results,
    # standards and the arm
    count = len(document.figures)
    standards = document.standards or (document.edition,)
    first_standard = 4 * count + 2
    arm = first_standard + len(standards)
    parts = arm_test_parts(document)
    _standards(root, standards, first_standard)
    _units(root, bool(parts and air_temperatures_c(document)))
    if parts:
        add_arm(root, document, parts, arm)
    if count:
        _characteristics(root, document.figures, first_standard)
    _measurements(root, document, 3 * count)
    root.set("idMax", str(arm if parts else arm - 1))
    return xml_bytes(root)


def _unique_id(document: PerformanceFile) -> str:
    """The same for the same test with the same data."""
    hashes = " ".join(one.sha256 for one in document.inputs)
    return str(uuid.uuid5(NAMESPACE, f"{document.id} {hashes}"))


def _standards(root: ET.Element, names: tuple[str, ...], first: int) -> None:
    """Every standard of the test, split into who publishes it, its number and its year."""
    parent = add(root, qif_name("StandardsDefinitions"), n=str(len(names)))
    for number, name in enumerate(names, first):
        known = STANDARD.fullmatch(name)
        standard = add(parent, qif_name("Standard"), id=str(number))
        organization = add(standard, qif_name("Organization"))
        publisher = known["publisher"] if known else "–"
        chosen = "StandardsOrganizationEnum"
        if publisher not in PUBLISHERS:
            chosen = "OtherStandardsOrganization"
        add(organization, qif_name(chosen), publisher)
        add(standard, qif_name("Designator"), known["designator"] if known else name)
        if known:
            add(standard, qif_name("Year"), known["year"])


def _units(root: ET.Element, with_temperature: bool) -> None:
    primary = add(add(root, qif_name("FileUnits")), qif_name("PrimaryUnits"))
    units = (*UNITS, CELSIUS) if with_temperature else UNITS
    for element, standard, name, factor, offset in units:
        unit = add(primary, qif_name(element))
        add(unit, qif_name("SIUnitName"), standard)
        add(unit, qif_name("UnitName"), name)
        conversion = add(unit, qif_name("UnitConversion"))
        add(conversion, qif_name("Factor"), factor)
        if offset:
            add(conversion, qif_name("Offset"), offset)


def _characteristics(
    root: ET.Element, figures: tuple[PerformanceFigure, ...], standard: int
) -> None:
    """A definition with its tolerance, a nominal and an item for each symbol."""
    count = len(figures)
    parent = add(root, qif_name("Characteristics"))
    add(parent, qif_name("FormalStandardId"), str(standard))
    definitions = add(parent, qif_name("CharacteristicDefinitions"), n=str(count))
    nominals = add(parent, qif_name("CharacteristicNominals"), n=str(count))
    items = add(parent, qif_name("CharacteristicItems"), n=str(count))
    for number, figure in enumerate(figures, 1):
        definition = add(definitions, qif_name(f"{KIND}Definition"), id=str(number))
        add(definition, qif_name("Description"), str(figure.title))
        add(definition, qif_name("Name"), figure.symbol)
        if figure.limit is None:
            add(definition, qif_name("NonTolerance"), "MEASURED")
        else:
            _tolerance(definition, figure, figure.limit)
        add(definition, qif_name("WhatToMeasure"), figure.symbol)
        nominal = add(nominals, qif_name(f"{KIND}Nominal"), id=str(count + number))
        add(nominal, qif_name("CharacteristicDefinitionId"), str(number))
        add(nominal, qif_name("TargetValue"), "0")
        item = add(items, qif_name(f"{KIND}Item"), id=str(2 * count + number))
        add(item, qif_name("Name"), figure.symbol)
        add(item, qif_name("CharacteristicNominalId"), str(count + number))


def _tolerance(definition: ET.Element, figure: PerformanceFigure, limit_um: float) -> None:
    """The permissible error as limits of the value."""
    tolerance = add(definition, qif_name("Tolerance"))
    add(tolerance, qif_name("MaxValue"), in_mm(limit_um))
    add(tolerance, qif_name("MinValue"), in_mm(-limit_um) if is_signed(figure.quantity) else "0")
    add(tolerance, qif_name("DefinedAsLimit"), "true")


def _measurements(root: ET.Element, document: PerformanceFile, before: int) -> None:
    """The measured value, or that there is none, of each item, and the verdict."""
    figures = document.figures
    count = len(figures)
    collection = add(add(root, qif_name("Results")), qif_name("MeasurementResultsSet"), n="1")
    results = add(collection, qif_name("MeasurementResults"), id=str(before + count + 1))
    if count:
        measured = add(results, qif_name("MeasuredCharacteristics"))
        parent = add(measured, qif_name("CharacteristicMeasurements"), n=str(count))
    for number, figure in enumerate(figures, 1):
        one = add(parent, qif_name(f"{KIND}Measurement"), id=str(before + number))
        status = "NOT_ANALYZED" if figure.value is None else STATUS[figure.decision]
        add(add(one, qif_name("Status")), qif_name("CharacteristicStatusEnum"), status)
        add(one, qif_name("CharacteristicItemId"), str(before - count + number))
        if figure.value is not None:
            value = add(one, qif_name("Value"), in_mm(figure.value))
            if figure.test_uncertainty is not None:
                # QIF states a combined standard uncertainty, k = 1, always with a mean error: none
                # is known, since the artefact's calibrated values are used
                value.set("combinedUncertainty", in_mm(figure.test_uncertainty / 2))
                value.set("meanError", "0")
    verdict = INSPECTION[document.verdict.result]
    add(add(results, qif_name("InspectionStatus")), qif_name("InspectionStatusEnum"), verdict)
