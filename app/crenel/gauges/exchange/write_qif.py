"""A performance test as QIF 3.0 results: one characteristic for each symbol, with its value.

QIF 3.0 has no type for ISO 10360-12. Every symbol is therefore a user-defined linear characteristic
whose name is the symbol. A contact test is also written as ``AACMMB89Test``, the accuracy of the
arm among the measurement resources. The order and the required parts of all elements are those of
the schema of QIF 3.0, which is no part of the program (see ``check_schema``).
"""

from xml.etree import ElementTree as ET

from crenel.formats.exchange.qif import (
    STATUS,
    add_limits,
    add_measurement,
    add_standards,
    add_status,
    add_units,
    add_value,
    qif_name,
    qif_root,
)
from crenel.formats.xml_text import add, xml_bytes
from crenel.gauges.exchange.write_qif_arm import (
    add_arm,
    air_temperatures_c,
    arm_test_parts,
    in_mm,
)
from crenel.gauges.judgement.document import PerformanceFigure, PerformanceFile
from crenel.gauges.plan.document_symbols import is_signed

KIND = "UserDefinedLinearCharacteristic"


def qif_bytes(document: PerformanceFile) -> bytes:
    """The file, UTF-8, with identical bytes for the same result; lengths are in mm.

    Source:
        ANSI/DMSC Quality Information Framework 3.0: characteristics, results, resources.
    """
    hashes = " ".join(one.sha256 for one in document.inputs)
    root = qif_root(document.software, f"{document.id} {hashes}")
    # definitions, nominals, items and measurements are numbered one after the other, then results,
    # standards and the arm
    count = len(document.figures)
    standards = document.standards or (document.edition,)
    first_standard = 4 * count + 2
    arm = first_standard + len(standards)
    parts = arm_test_parts(document)
    add_standards(root, standards, first_standard)
    add_units(root, bool(parts and air_temperatures_c(document)))
    if parts:
        add_arm(root, document, parts, arm)
    if count:
        _characteristics(root, document.figures, first_standard)
    _measurements(root, document, 3 * count)
    root.set("idMax", str(arm if parts else arm - 1))
    return xml_bytes(root)


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
        add_limits(definition, *_limits(figure))
        add(definition, qif_name("WhatToMeasure"), figure.symbol)
        nominal = add(nominals, qif_name(f"{KIND}Nominal"), id=str(count + number))
        add(nominal, qif_name("CharacteristicDefinitionId"), str(number))
        add(nominal, qif_name("TargetValue"), "0")
        item = add(items, qif_name(f"{KIND}Item"), id=str(2 * count + number))
        add(item, qif_name("Name"), figure.symbol)
        add(item, qif_name("CharacteristicNominalId"), str(count + number))


def _limits(figure: PerformanceFigure) -> tuple[str | None, str | None]:
    """The permissible error as limits of the value."""
    if figure.limit is None:
        return None, None
    return (in_mm(-figure.limit) if is_signed(figure.quantity) else "0"), in_mm(figure.limit)


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
        status = "NOT_ANALYZED" if figure.value is None else STATUS[figure.decision]
        item = before - count + number
        one = add_measurement(parent, KIND, before + number, item, status)
        if figure.value is not None:
            # no mean error is known, since the artefact's calibrated values are used
            u = figure.test_uncertainty
            add_value(one, in_mm(figure.value), None if u is None else in_mm(u / 2))
    add_status(results, document.verdict.result)
