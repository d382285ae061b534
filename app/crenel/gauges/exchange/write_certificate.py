"""A performance test as a Digital Calibration Certificate, version 3.3.0.

The values are test values, and their uncertainty is that of artefact and set-up. The certificate is
not signed.
"""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from datetime import UTC
from xml.etree import ElementTree as ET

from crenel.errors import OperationError
from crenel.formats.results.decision_rule import RulePart, describe_rule
from crenel.formats.xml_text import add, xml_bytes
from crenel.gauges.exchange.certificate_values import DCC, SI
from crenel.gauges.judgement.document import PerformanceFigure, PerformanceFile
from crenel.gauges.plan.document_symbols import is_signed
from crenel.messages.catalogue import renderer
from crenel.messages.message import Text, message
from crenel.timestamps import parse_moment

VERSION = "3.3.0"
SCHEMA = f"https://ptb.de/dcc https://ptb.de/dcc/v{VERSION}/dcc.xsd"
INSTANCE = "http://www.w3.org/2001/XMLSchema-instance"
LANGUAGES = ("en", "de")
CONFORMITY = {"pass": "pass", "fail": "fail"}
"""An undecided value has no statement of conformity, and one without a limit neither."""
COUNTRY = re.compile("[A-Z]{2}")
NUMBERS = re.compile(r"\d{1,3}(?:\.\d{1,3}){0,3}")
KELVIN = 273.15
for _prefix, _name in (("dcc", DCC), ("si", SI), ("xsi", INSTANCE)):
    ET.register_namespace(_prefix, _name)


@dataclass(frozen=True)
class Issuer:
    """Who issues the certificate."""

    laboratory: str
    country: str
    """ISO 3166-1, two capital letters."""
    customer: str = ""
    """Empty: the laboratory itself."""


def certificate_bytes(document: PerformanceFile, issuer: Issuer) -> bytes:
    """The file, UTF-8, with identical bytes for the same result.

    Raises:
        OperationError: the laboratory or the country is missing or impossible.

    Source:
        PTB, Digital Calibration Certificate 3.3.0, and D-SI 2.2.
    """
    if not issuer.laboratory.strip():
        raise OperationError(
            "issuer-unknown",
            message("certificate-needs-laboratory"),
            remedy=message("enter-laboratory"),
        )
    if not COUNTRY.fullmatch(issuer.country):
        raise OperationError(
            "issuer-unknown",
            message("certificate-needs-country", country=issuer.country or "–"),
            remedy=message("enter-country"),
        )
    root = ET.Element(_dcc("digitalCalibrationCertificate"), {"schemaVersion": VERSION})
    root.set(f"{{{INSTANCE}}}schemaLocation", SCHEMA)
    _administration(add(root, _dcc("administrativeData")), document, issuer)
    _results(add(root, _dcc("measurementResults")), document)
    return xml_bytes(root)


def _dcc(name: str) -> str:
    return f"{{{DCC}}}{name}"


def _si(name: str) -> str:
    return f"{{{SI}}}{name}"


def _texts(parent: ET.Element, name: str, text: Text) -> ET.Element:
    """A name or description in every language; a name that has no translation, once."""
    element = add(parent, _dcc(name))
    if isinstance(text, str):
        add(element, _dcc("content"), text)
        return element
    for language in LANGUAGES:
        add(element, _dcc("content"), renderer(language)(text), lang=language)
    return element


def _identification(parent: ET.Element, issuer: str, value: str) -> None:
    one = add(add(parent, _dcc("identifications")), _dcc("identification"))
    add(one, _dcc("issuer"), issuer)
    add(one, _dcc("value"), _short_text(value))


def _short_text(text: str) -> str:
    """As the certificate wants short texts: not empty, without space about them."""
    return text.strip() or "–"


def _administration(parent: ET.Element, document: PerformanceFile, issuer: Issuer) -> None:
    _software(parent, "dccSoftware", document)
    core = add(parent, _dcc("coreData"))
    add(core, _dcc("countryCodeISO3166_1"), issuer.country)
    for language in LANGUAGES:
        add(core, _dcc("usedLangCodeISO639_1"), language)
    add(core, _dcc("mandatoryLangCodeISO639_1"), LANGUAGES[0])
    add(core, _dcc("uniqueIdentifier"), _short_text(document.id))
    begun, ended = _days(document)
    add(core, _dcc("beginPerformanceDate"), begun)
    add(core, _dcc("endPerformanceDate"), ended)
    add(core, _dcc("performanceLocation"), "laboratory")
    items = add(parent, _dcc("items"))
    serials = document.serial_numbers
    for name, serial in (
        (message("arm"), serials.arm),
        (message("sensor-heading"), serials.sensor),
    ):
        item = add(items, _dcc("item"))
        _texts(item, "name", name)
        _identification(item, "manufacturer", serial)
    laboratory = add(parent, _dcc("calibrationLaboratory"))
    contact = add(laboratory, _dcc("contact"))
    _texts(contact, "name", issuer.laboratory)
    add(add(contact, _dcc("location")), _dcc("countryCode"), issuer.country)
    signer = add(add(parent, _dcc("respPersons")), _dcc("respPerson"))
    _texts(add(signer, _dcc("person")), "name", document.operator or issuer.laboratory)
    add(signer, _dcc("mainSigner"), "true")
    customer = add(parent, _dcc("customer"))
    _texts(customer, "name", issuer.customer or issuer.laboratory)
    add(add(customer, _dcc("location")), _dcc("countryCode"), issuer.country)
    _statements(parent, document)


def _statements(parent: ET.Element, document: PerformanceFile) -> None:
    statements = add(parent, _dcc("statements"))
    for text in (document.status, *document.problems, *document.notes):
        if text:
            _texts(add(statements, _dcc("statement")), "declaration", text)
    rule = add(statements, _dcc("statement"), refType="basic_conformity")
    add(rule, _dcc("norm"), _short_text(f"{document.rule.standard}:{document.rule.edition}"))
    _texts(rule, "declaration", describe_rule(document.rule))
    if document.verdict.result in CONFORMITY:
        add(rule, _dcc("conformity"), CONFORMITY[document.verdict.result])


def _software(parent: ET.Element, name: str, document: PerformanceFile) -> None:
    software = add(add(parent, _dcc(name)), _dcc("software"))
    _texts(software, "name", document.software.name)
    numbers = NUMBERS.match(document.software.version)
    add(software, _dcc("release"), f"v{numbers[0] if numbers else 0}")


def _results(parent: ET.Element, document: PerformanceFile) -> None:
    results = add(parent, _dcc("measurementResult"))
    title = message("performance-test", kind=document.kind)
    _texts(results, "name", title)
    methods = add(results, _dcc("usedMethods"))
    for standard in document.standards:
        method = add(methods, _dcc("usedMethod"))
        _texts(method, "name", title)
        add(method, _dcc("norm"), _short_text(standard))
    uncertainty = add(methods, _dcc("usedMethod"), refType="basic_uncertainty")
    _texts(uncertainty, "name", message("test-value-uncertainty"))
    _texts(uncertainty, "description", message("test-value-uncertainty-text"))
    add(uncertainty, _dcc("norm"), "ISO 14253-5:2015")
    _software(results, "usedSoftware", document)
    _artefacts(results, document)
    _conditions(results, document)
    result = add(add(results, _dcc("results")), _dcc("result"))
    _texts(result, "name", message("results"))
    data = add(result, _dcc("data"))
    known = [one for one in document.figures if one.value is not None]
    for figure in known:
        _figure(data, figure, document.rule)
    if not known:
        _texts(data, "text", message("certificate-without-values"))


def _artefacts(parent: ET.Element, document: PerformanceFile) -> None:
    parts = [one for one in (document.sphere, document.length, document.plate) if one is not None]
    if not parts:
        return
    equipments = add(parent, _dcc("measuringEquipments"))
    for part in parts:
        one = add(equipments, _dcc("measuringEquipment"), refType="basic_normalUsed")
        _texts(one, "name", part.name)
        identifications = add(one, _dcc("identifications"))
        numbers = (
            ("manufacturer", part.serial_number),
            ("calibrationLaboratory", part.certificate),
        )
        for issuer, value in numbers:
            found = add(identifications, _dcc("identification"))
            add(found, _dcc("issuer"), issuer)
            add(found, _dcc("value"), _short_text(value))


def _conditions(parent: ET.Element, document: PerformanceFile) -> None:
    conditions = add(parent, _dcc("influenceConditions"))
    _condition(conditions, message("temperature"), document.temperature_c)
    part = document.temperatures
    if part is not None:
        _condition(conditions, message("artefact-temperature"), part.artefact_c)
        _condition(conditions, message("arm-temperature"), part.arm_c)


def _condition(
    parent: ET.Element, title: Text, readings_c: tuple[float | None, float | None]
) -> None:
    """A temperature at the beginning and at the end."""
    one = add(parent, _dcc("influenceCondition"), refType="basic_temperature")
    _texts(one, "name", title)
    data = add(one, _dcc("data"))
    names = (message("at-beginning"), message("at-end"))
    measured = [
        (name, value) for name, value in zip(names, readings_c, strict=True) if value is not None
    ]
    for name, value in measured:
        quantity = add(data, _dcc("quantity"))
        _texts(quantity, "name", name)
        _real(quantity, f"{value + KELVIN:.2f}", "\\kelvin")
    if not measured:
        _texts(data, "text", message("not-measured"))


def _figure(parent: ET.Element, figure: PerformanceFigure, rule: RulePart) -> None:
    """One value in micrometres, with its uncertainty and its conformity."""
    kind = "basic_measurementError" if is_signed(figure.quantity) else "basic_measuredValue"
    quantity = add(parent, _dcc("quantity"), refType=kind)
    _texts(quantity, "name", message("titled-text", title=figure.symbol, text=figure.title))
    assert figure.value is not None
    real = _real(quantity, _number(figure.value), "\\micro\\metre")
    if figure.test_uncertainty is not None:
        stated = add(real, _si("measurementUncertaintyUnivariate"))
        expanded = add(stated, _si("expandedMU"))
        add(expanded, _si("valueExpandedMU"), _number(figure.test_uncertainty))
        add(expanded, _si("coverageFactor"), "2")
        add(expanded, _si("coverageProbability"), "0.95")
        add(expanded, _si("distribution"), "normal")
    if figure.limit is None:
        return
    meta = add(
        add(quantity, _dcc("measurementMetaData")), _dcc("metaData"), refType="basic_conformity"
    )
    _texts(meta, "declaration", figure.reason)
    if figure.decision in CONFORMITY:
        add(meta, _dcc("conformityXMLList"), CONFORMITY[figure.decision])
    data = add(meta, _dcc("data"))
    limits: list[tuple[str, Text, float]] = [
        ("", message("maximum-permissible-error"), figure.limit)
    ]
    if figure.test_uncertainty is not None:
        guard = rule.guard_factor * figure.test_uncertainty / 2
        wider = rule.bearer == "user"  # up to there, the user cannot prove the opposite
        accepted = figure.limit + guard if wider else max(figure.limit - guard, 0.0)
        upper = ("basic_acceptanceLimitUpper", message("acceptance-limit-upper"), accepted)
        lower = ("basic_acceptanceLimitLower", message("acceptance-limit-lower"), -accepted)
        limits += [lower, upper] if is_signed(figure.quantity) else [upper]
    _limits(data, limits)


def _limits(parent: ET.Element, limits: Sequence[tuple[str, Text, float]]) -> None:
    for kind, name, value in limits:
        quantity = add(parent, _dcc("quantity"), **({"refType": kind} if kind else {}))
        _texts(quantity, "name", name)
        _real(quantity, _number(value), "\\micro\\metre")


def _real(parent: ET.Element, value: str, unit: str) -> ET.Element:
    real = add(parent, _si("real"))
    add(real, _si("value"), value)
    add(real, _si("unit"), unit)
    return real


def _number(value: float) -> str:
    """Micrometres, to the nanometre."""
    return f"{value:.3f}"


def _days(document: PerformanceFile) -> tuple[str, str]:
    """The days of the beginning and of the end, which the rules of the PTB want in this order."""
    begun, ended = _day(document.started_at), _day(document.ended_at)
    if ended < begun:
        raise OperationError(
            "moments-reversed", message("certificate-days-reversed", begun=begun, ended=ended)
        )
    return begun, ended


def _day(text: str) -> str:
    """The date of a moment in UTC, like the times in a report."""
    try:
        return parse_moment(text).astimezone(UTC).date().isoformat()
    except ValueError as error:
        raise OperationError(
            "moment-unknown", message("certificate-needs-date", text=text or "–")
        ) from error
