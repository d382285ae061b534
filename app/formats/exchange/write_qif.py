"""A performance test as QIF 3.0 results: one characteristic for each symbol, with its value.

QIF 3.0 has no type for ISO 10360-12. Every symbol is therefore a user-defined linear characteristic
whose name is the symbol. The figures of ASME B89.4.22 are written in the same way, not as
``AACMMB89Test``. The file is not validated against the schema of QIF, which is not at hand: readers
that insist on the schema may refuse it.
"""

import uuid
from xml.etree import ElementTree as ET

from app.formats.exchange.xml_text import add, xml_bytes
from app.formats.performance.results import PerformanceFigure, PerformanceFile
from app.formats.performance.symbols import is_signed
from app.metrology.decision import Decision

QIF = "http://qifstandards.org/xsd/qif3"
VERSION = "3.0.0"
STATUS: dict[Decision, str] = {
    "pass": "PASS",
    "fail": "FAIL",
    "uncertain": "UNKNOWN",
    "none": "NOT_DEFINED",
}
KIND = "UserDefinedLinearCharacteristic"
LINEAR, ANGULAR = ("LinearUnit", "meter", "mm", "0.001"), (
    "AngularUnit", "radian", "degree", "0.017453292519943295",
)  # fmt: skip
NAMESPACE = uuid.uuid5(uuid.NAMESPACE_URL, QIF)


def qif_bytes(document: PerformanceFile) -> bytes:
    """The file, UTF-8, with identical bytes for the same result; lengths are in mm.

    Source:
        ANSI/DMSC Quality Information Framework 3.0, characteristics and results.
    """
    ET.register_namespace("", QIF)
    root = ET.Element(_qif("QIFDocument"), {"versionQIF": VERSION})
    add(root, _qif("QPId"), _unique_id(document))
    application = add(add(root, _qif("Header")), _qif("Application"))
    add(application, _qif("Name"), f"{document.software.name} {document.software.version}")
    add(application, _qif("Organization"), document.station or document.software.name)
    _units(root)
    count = len(document.figures)
    # definitions, nominals, items and measurements are numbered one after the other
    _characteristics(root, document.figures, count)
    _measurements(root, document, 3 * count)
    root.set("idMax", str(4 * count + 1))
    return xml_bytes(root)


def _qif(name: str) -> str:
    return f"{{{QIF}}}{name}"


def _unique_id(document: PerformanceFile) -> str:
    """The same for the same test with the same data."""
    hashes = " ".join(one.sha256 for one in document.inputs)
    return str(uuid.uuid5(NAMESPACE, f"{document.id} {hashes}"))


def _units(root: ET.Element) -> None:
    primary = add(add(root, _qif("FileUnits")), _qif("PrimaryUnits"))
    for element, standard, name, factor in (ANGULAR, LINEAR):
        unit = add(primary, _qif(element))
        add(unit, _qif("SIUnitName"), standard)
        add(unit, _qif("UnitName"), name)
        add(add(unit, _qif("UnitConversion")), _qif("Factor"), factor)


def _characteristics(root: ET.Element, figures: tuple[PerformanceFigure, ...], count: int) -> None:
    """A definition with its tolerance, a nominal and an item for each symbol."""
    parent = add(root, _qif("Characteristics"))
    definitions = add(parent, _qif("CharacteristicDefinitions"), n=str(count))
    nominals = add(parent, _qif("CharacteristicNominals"), n=str(count))
    items = add(parent, _qif("CharacteristicItems"), n=str(count))
    for number, figure in enumerate(figures, 1):
        definition = add(definitions, _qif(f"{KIND}Definition"), id=str(number))
        add(definition, _qif("Description"), str(figure.title))
        add(definition, _qif("Name"), figure.symbol)
        if figure.limit is not None:
            _tolerance(definition, figure, figure.limit)
        add(definition, _qif("WhatToMeasure"), figure.symbol)
        nominal = add(nominals, _qif(f"{KIND}Nominal"), id=str(count + number))
        add(nominal, _qif("CharacteristicDefinitionId"), str(number))
        add(nominal, _qif("TargetValue"), "0")
        item = add(items, _qif(f"{KIND}Item"), id=str(2 * count + number))
        add(item, _qif("Name"), figure.symbol)
        add(item, _qif("CharacteristicNominalId"), str(count + number))


def _tolerance(definition: ET.Element, figure: PerformanceFigure, limit_um: float) -> None:
    """The permissible error as limits of the value."""
    tolerance = add(definition, _qif("Tolerance"))
    add(tolerance, _qif("MaxValue"), _in_mm(limit_um))
    add(tolerance, _qif("MinValue"), _in_mm(-limit_um) if is_signed(figure.quantity) else "0")
    add(tolerance, _qif("DefinedAsLimit"), "true")


def _measurements(root: ET.Element, document: PerformanceFile, before: int) -> None:
    """The measured value, or that there is none, of each item."""
    figures = document.figures
    count = len(figures)
    collection = add(add(root, _qif("Results")), _qif("MeasurementResultsSet"), n="1")
    results = add(collection, _qif("MeasurementResults"), id=str(before + count + 1))
    measured = add(results, _qif("MeasuredCharacteristics"))
    parent = add(measured, _qif("CharacteristicMeasurements"), n=str(count))
    for number, figure in enumerate(figures, 1):
        one = add(parent, _qif(f"{KIND}Measurement"), id=str(before + number))
        status = "NOT_MEASURED" if figure.value is None else STATUS[figure.decision]
        add(add(one, _qif("Status")), _qif("CharacteristicStatusEnum"), status)
        add(one, _qif("CharacteristicItemId"), str(before - count + number))
        if figure.value is not None:
            value = add(one, _qif("Value"), _in_mm(figure.value))
            if figure.test_uncertainty is not None:
                # QIF states a combined standard uncertainty, k = 1
                value.set("combinedUncertainty", _in_mm(figure.test_uncertainty / 2))


def _in_mm(value_um: float) -> str:
    """Micrometres in mm, to the nanometre."""
    return f"{value_um / 1e3:.6f}"
