"""An inspection as QIF 3.0 results: features, characteristics, and what was measured of both.

A dimension is a user-defined linear or angular characteristic, which names its features; what it
measures is its kind, in the words of the program. The order and the required parts of all elements
are those of the schema of QIF 3.0, which is no part of the program.
"""

from collections.abc import Iterator, Mapping, Sequence
from itertools import count
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
from crenel.formats.json_document import SOFTWARE
from crenel.formats.xml_text import add, xml_bytes
from crenel.metrology.decision import Decision
from crenel.parts.document_results import DimensionResult, InspectionFile, Outcome
from crenel.parts.exchange.write_qif_features import add_feature_measurements, add_features

LINEAR, ANGULAR = "UserDefinedLinearCharacteristic", "UserDefinedAngularCharacteristic"
DECISIONS: dict[Outcome, Decision] = {
    "pass": "pass",
    "fail": "fail",
    "undecided": "uncertain",
    "none": "none",
}


def qif_bytes(document: InspectionFile) -> bytes:
    """The file, UTF-8, with identical bytes for the same result; mm and degrees, part frame.

    Source:
        ANSI/DMSC Quality Information Framework 3.0: features, characteristics, results.
    """
    hashes = " ".join(one.sha256 for one in document.inputs)
    root = qif_root(document.software or SOFTWARE, f"{document.program} {hashes}")
    ids = count(1)
    standard = next(ids)
    add_standards(root, (f"{document.rule.standard}:{document.rule.edition}",), standard)
    add_units(root)
    items = add_features(root, document.features, ids)
    characteristics = _characteristics(root, document.dimensions, items, standard, ids)
    collection = add(add(root, qif_name("Results")), qif_name("MeasurementResultsSet"), n="1")
    results = add(collection, qif_name("MeasurementResults"), id=str(next(ids)))
    add_feature_measurements(results, document.features, items, ids)
    if document.dimensions:
        measured = add(results, qif_name("MeasuredCharacteristics"))
        number = str(len(document.dimensions))
        parent = add(measured, qif_name("CharacteristicMeasurements"), n=number)
        for one, item in zip(document.dimensions, characteristics, strict=True):
            status = STATUS[DECISIONS[one.decision]]
            element = add_measurement(parent, kind_of(one), next(ids), item, status)
            u = one.standard_uncertainty
            add_value(element, _number(one, one.value), None if u is None else _number(one, u))
    add_status(results, DECISIONS[document.verdict])
    root.set("idMax", str(next(ids) - 1))
    return xml_bytes(root)


def kind_of(dimension: DimensionResult) -> str:
    """The kind of characteristic that a dimension is."""
    return ANGULAR if dimension.unit in ("deg", "°") else LINEAR


def _number(dimension: DimensionResult, value: float) -> str:
    """A value in mm or degrees, to the nanometre or to 0.2 milliseconds of arc."""
    per_unit = 1e3 if dimension.unit in ("um", "µm") else 1.0
    return f"{value / per_unit:.{6 if kind_of(dimension) == LINEAR else 7}f}"


def _characteristics(
    root: ET.Element,
    dimensions: Sequence[DimensionResult],
    features: Mapping[str, int],
    standard: int,
    ids: Iterator[int],
) -> list[int]:
    """A definition with its tolerance, a nominal and an item of each dimension; the items' ids."""
    if not dimensions:
        return []
    parent = add(root, qif_name("Characteristics"))
    add(parent, qif_name("FormalStandardId"), str(standard))
    number = str(len(dimensions))
    definitions, nominals, items = (
        add(parent, qif_name(f"Characteristic{name}"), n=number)
        for name in ("Definitions", "Nominals", "Items")
    )
    found = []
    for one in dimensions:
        kind, (definition, nominal, item) = kind_of(one), (next(ids) for _ in range(3))
        element = add(definitions, qif_name(f"{kind}Definition"), id=str(definition))
        add(element, qif_name("Name"), one.id)
        limits = (None if off is None else one.nominal + off for off in (one.lower, one.upper))
        add_limits(element, *(None if at is None else _number(one, at) for at in limits))
        add(element, qif_name("WhatToMeasure"), one.kind)
        element = add(nominals, qif_name(f"{kind}Nominal"), id=str(nominal))
        add(element, qif_name("CharacteristicDefinitionId"), str(definition))
        add(element, qif_name("TargetValue"), _number(one, one.nominal))
        element = add(items, qif_name(f"{kind}Item"), id=str(item))
        add(element, qif_name("Name"), one.id)
        known = [features[name] for name in one.features if name in features]
        if known:
            listed = add(element, qif_name("FeatureItemIds"), n=str(len(known)))
            for feature in known:
                add(listed, qif_name("Id"), str(feature))
        add(element, qif_name("CharacteristicNominalId"), str(nominal))
        found.append(item)
    return found
