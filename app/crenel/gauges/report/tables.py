"""The facts and tables of a performance test's report."""

from crenel.formats.results.decision_rule import RulePart, describe_rule
from crenel.gauges.judgement.document import PerformanceFigure, PerformanceFile
from crenel.gauges.plan.document import GatePart
from crenel.gauges.plan.document_symbols import is_signed
from crenel.gauges.report.head import DECISIONS, device_facts, temperatures_text
from crenel.gauges.sphere.maths_pattern import COUNT, PATCH_DEG
from crenel.messages.message import Text, join, message, quantity, rounded
from crenel.messages.uncertainty import uncertainty_quantity
from crenel.report.content import ReportTable
from crenel.report.formatting import (
    NONE,
    UNKNOWN,
    device_name,
    format_moment,
    limit_beside,
    micrometres,
    plus_minus,
    software_name,
    value_beside,
)

ERRORS: tuple[tuple[Text, Text, Text], ...] = (
    (message("error-probe-matrix"), message("shows-probe-matrix"), message("hides-probe-matrix")),
    (message("error-sensor-scale"), message("shows-sensor-scale"), message("hides-sensor-scale")),
    (message("error-laser-plane"), message("shows-laser-plane"), message("hides-laser-plane")),
    (message("error-stripe-noise"), message("shows-stripe-noise"), message("hides-stripe-noise")),
    (message("error-arm-links"), message("shows-arm-links"), message("hides-arm-links")),
    (message("error-arm-joints"), message("shows-arm-joints"), message("hides-arm-joints")),
    (message("error-tip-diameter"), message("shows-tip-diameter"), message("hides-tip-diameter")),
    (message("error-clock"), message("shows-clock"), message("hides-clock")),
)
"""Kinds of error: where each shows, and where it does not."""
MOST_VALUES, MOST_GROUPS = 20, 40
"""So many of a figure are listed; all are in the exported tables."""


def test_facts(document: PerformanceFile) -> list[tuple[Text, Text]]:
    """Who tested what, when, by which editions, and with which artefact."""
    return [
        (message("operator"), document.operator or UNKNOWN),
        (message("begun"), format_moment(document.started_at)),
        (message("performance-ended"), format_moment(document.ended_at)),
        (message("temperature"), temperatures_text(*document.temperature_c)),
        *_artefact_temperatures(document),
        *device_facts(document.serial_numbers),
        (message("performance-editions"), join([*document.standards]) or UNKNOWN),
        *_artefacts(document),
        (message("software"), software_name(document.software.version)),
    ]


def _artefact_temperatures(document: PerformanceFile) -> list[tuple[Text, Text]]:
    """The temperatures of artefact and arm, if one was measured."""
    part = document.temperatures
    if part is None:
        return []
    return [
        (message("artefact-temperature"), temperatures_text(*part.artefact_c)),
        (message("arm-temperature"), temperatures_text(*part.arm_c)),
    ]


def _artefacts(document: PerformanceFile) -> list[tuple[Text, Text]]:
    """Each artefact with its certificate."""
    found: list[tuple[Text, Text]] = []
    sphere, bar, plate = document.sphere, document.length, document.plate
    if sphere is not None:
        size = message(
            "sphere-by-certificate",
            diameter=quantity(sphere.diameter_mm, "mm", 4),
            known=rounded(sphere.diameter_sd_um, "µm"),
            form=rounded(sphere.form_um, "µm"),
        )
        found.append((message("sphere"), join([device_name(sphere.name, sphere.serial_number)])))
        found.append((message("certificate"), _certificate(sphere.certificate, sphere.valid_until)))
        found.append((message("certified-values"), size))
    if bar is not None:
        lengths = join([quantity(part.length_mm, "mm", 3) for part in bar.lengths], "; ")
        found.append((message("length-standard"), device_name(bar.name, bar.serial_number)))
        found.append((message("certificate"), _certificate(bar.certificate, bar.valid_until)))
        found.append((message("certified-values"), lengths))
    if plate is not None:
        flatness = message("plate-by-certificate", flatness=rounded(plate.flatness_um, "µm"))
        found.append((message("plate"), device_name(plate.name, plate.serial_number)))
        found.append((message("certificate"), _certificate(plate.certificate, plate.valid_until)))
        found.append((message("certified-values"), flatness))
    return found


def _certificate(name: str, valid_until: str) -> Text:
    if not name:
        return message("no-certificate-stated")
    return message("certificate-valid-until", name=name, date=valid_until) if valid_until else name


def figures_table(document: PerformanceFile) -> ReportTable[Text]:
    """One row for each symbol."""
    rows: list[tuple[Text, ...]] = [
        (
            one.symbol,
            one.title,
            value_text(one),
            limit_text(one),
            ""
            if one.test_uncertainty is None
            else plus_minus(uncertainty_quantity(one.test_uncertainty, "µm")),
            DECISIONS[one.decision],
        )
        for one in document.figures
    ]
    columns = (
        message("performance-symbol"),
        message("figure"),
        message("value"),
        "MPE",
        "U, k = 2",
        message("decision"),
    )
    return ReportTable(columns, rows, (37, 31, 14, 12, 13, 15), numbers=2)


def value_text(one: PerformanceFigure) -> Text:
    """The value in micrometres, with its sign if it has one; a dash without a value."""
    if one.value is None:
        return "–"
    return value_beside(one.value, one.limit, "µm", is_signed(one.quantity))


def limit_text(one: PerformanceFigure) -> Text:
    """The maximum permissible error, on both sides of zero for signed figures."""
    if one.limit is None:
        return NONE
    limit = limit_beside(one.value, one.limit, "µm")
    return plus_minus(limit) if is_signed(one.quantity) else message("at-most-limit", limit=limit)


def rule_text(rule: RulePart) -> Text:
    """The decision rule, and by which uncertainty a figure is judged."""
    return join([describe_rule(rule), message("performance-judged-by-test-uncertainty")], " ")


def gate_texts(gate: GatePart) -> list[Text]:
    """Which points of a scan take part, and how they become 25."""
    return [
        message(
            "performance-gate-points",
            shell=rounded(gate.shell_mm, "mm"),
            incidence=rounded(gate.incidence_deg, "°"),
            cone=rounded(gate.cone_deg, "°"),
            pole=join([rounded(value, digits=4) for value in gate.pole], " "),
        ),
        message("performance-patches", count=COUNT, half=rounded(PATCH_DEG, "°")),
    ]


def positions_table(document: PerformanceFile) -> ReportTable[Text]:
    """What each position of the sphere had besides the figures."""
    rows: list[tuple[Text, ...]] = [
        (
            str(one.position),
            _micrometres_or_dash(one.moved_um),
            str(one.points),
            str(one.points_outside),
            str(min((patch.points for patch in one.patches), default=0)),
            _micrometres_or_dash(one.free_dispersion_um),
            _micrometres_or_dash(one.location_fixed_um),
        )
        for one in document.spheres
    ]
    columns = (
        message("sphere-position"),
        message("sphere-moved"),
        message("points-in-gate"),
        message("points-outside-gate"),
        message("fewest-in-patch"),
        message("dispersion-free-centre"),
        message("location-fixed-diameter"),
    )
    return ReportTable(columns, rows, (10, 14, 14, 16, 16, 18, 18))


def _micrometres_or_dash(value: float | None) -> Text:
    return "–" if value is None else micrometres(value)


def values_table(document: PerformanceFile) -> ReportTable[Text]:
    """Every value of each figure, and the touches and scans that it comes from."""
    rows: list[tuple[Text, ...]] = [
        (
            one.symbol,
            _values(one),
            _origin(one.data),
        )
        for one in document.figures
    ]
    columns = (
        message("performance-symbol"),
        message("values-in-micrometres"),
        message("computed-from"),
    )
    return ReportTable[Text](columns, rows, (28, 32, 60), numbers=3, small=True)


def _origin(groups: tuple[str, ...]) -> Text:
    """The groups of touches and the scans; of many, which are numbered, the first and the last."""
    if len(groups) <= MOST_GROUPS:
        return join([*groups]) if groups else "–"
    return message("first-to-last-group", first=groups[0], last=groups[-1], count=len(groups))


def _values(one: PerformanceFigure) -> Text:
    if len(one.values) > MOST_VALUES:
        return message("so-many-values", count=len(one.values))
    known = ["–" if value is None else quantity(value, decimals=1) for value in one.values]
    return join(known) if known else "–"


def sensitivity_table() -> ReportTable[Text]:
    """Which error shows where, and where it does not."""
    columns = (message("error-of"), message("error-shows-in"), message("error-hides-in"))
    return ReportTable(columns, ERRORS, (26, 48, 36), numbers=3, small=True)
