"""What all results in QIF 3.0 have alike: head, standards, units, statuses, characteristics."""

import re
import uuid
from xml.etree import ElementTree as ET

from crenel.formats.json_document import Software
from crenel.formats.xml_text import add
from crenel.metrology.decision import Decision

QIF = "http://qifstandards.org/xsd/qif3"
VERSION = "3.0.0"
STATUS: dict[Decision, str] = {
    "pass": "PASS",
    "fail": "FAIL",
    "uncertain": "INDETERMINATE",
    "none": "UNDEFINED",
}
INSPECTION: dict[Decision, str] = {
    "pass": "PASS",
    "fail": "FAIL",
    "uncertain": "UNKNOWN",
    "none": "UNKNOWN",
}
UNITS = (
    ("AngularUnit", "radian", "degree", "0.017453292519943295", ""),
    ("LinearUnit", "meter", "mm", "0.001", ""),
)
CELSIUS = ("TemperatureUnit", "kelvin", "Celsius", "1", "273.15")
STANDARD = re.compile(r"(?P<publisher>\w+) (?P<designator>\S+?)[:-](?P<year>\d{4}\b.*)")
PUBLISHERS = ("ASME", "DIN", "ISO")
"""Those of ours that QIF enumerates."""
NAMESPACE = uuid.uuid5(uuid.NAMESPACE_URL, QIF)


def qif_name(name: str) -> str:
    """An element's name with the namespace of QIF 3.0."""
    return f"{{{QIF}}}{name}"


def qif_root(software: Software, identity: str) -> ET.Element:
    """The root with its head.

    Args:
        identity: what is the same for the same result with the same data, and for no other.
    """
    ET.register_namespace("", QIF)
    root = ET.Element(qif_name("QIFDocument"), {"versionQIF": VERSION})
    add(root, qif_name("QPId"), str(uuid.uuid5(NAMESPACE, identity)))
    application = add(add(root, qif_name("Header")), qif_name("Application"))
    add(application, qif_name("Name"), f"{software.name} {software.version}")
    return root


def add_standards(root: ET.Element, names: tuple[str, ...], first: int) -> None:
    """Standards, split into who publishes each, its number and its year; numbered from first."""
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


def add_units(root: ET.Element, with_temperature: bool = False) -> None:
    """Degrees and millimetres, and °C where temperatures are stated."""
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


def add_limits(definition: ET.Element, lower: str | None, upper: str | None) -> None:
    """The limits of a characteristic's value as its tolerance, or that it has none."""
    if lower is None and upper is None:
        add(definition, qif_name("NonTolerance"), "MEASURED")
        return
    tolerance = add(definition, qif_name("Tolerance"))
    if upper is not None:
        add(tolerance, qif_name("MaxValue"), upper)
    if lower is not None:
        add(tolerance, qif_name("MinValue"), lower)
    add(tolerance, qif_name("DefinedAsLimit"), "true")


def add_measurement(
    parent: ET.Element, kind: str, number: int, item: int, status: str
) -> ET.Element:
    """The measurement of a characteristic's item, whose value is still to be added."""
    one = add(parent, qif_name(f"{kind}Measurement"), id=str(number))
    add(add(one, qif_name("Status")), qif_name("CharacteristicStatusEnum"), status)
    add(one, qif_name("CharacteristicItemId"), str(item))
    return one


def add_value(measurement: ET.Element, value: str, standard_uncertainty: str | None) -> None:
    """A measured value.

    QIF states a combined standard uncertainty, k = 1, always with a mean error: none is known.
    """
    element = add(measurement, qif_name("Value"), value)
    if standard_uncertainty is not None:
        element.set("combinedUncertainty", standard_uncertainty)
        element.set("meanError", "0")


def add_status(results: ET.Element, verdict: Decision) -> None:
    """The verdict on all characteristics together, the last part of results."""
    status = add(results, qif_name("InspectionStatus"))
    add(status, qif_name("InspectionStatusEnum"), INSPECTION[verdict])
