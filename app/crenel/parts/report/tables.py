"""The tables of an inspection's report."""

from crenel.gauges.report.head import DECISIONS
from crenel.messages.limits import decimals_beside
from crenel.messages.message import Quantity, Text, Unit, join, message, quantity
from crenel.metrology.decision import Decision
from crenel.parts.document_results import DimensionResult, ExclusionRule, InspectionFile, Outcome
from crenel.report.content import ReportTable, TextBlock
from crenel.report.formatting import NONE, micrometres

OUTCOMES: dict[Outcome, Decision] = {
    "pass": "pass",
    "fail": "fail",
    "undecided": "uncertain",
    "none": "none",
}
UNITS: dict[str, Unit] = {"mm": "mm", "um": "µm", "µm": "µm", "deg": "°", "°": "°"}
DECIMALS: dict[Unit, int] = {"mm": 4, "µm": 1, "°": 4}
RULES: dict[ExclusionRule, Text] = {
    "outlier": message("part-rule-outlier"),
    "edge": message("part-rule-edge"),
    "incidence": message("part-rule-incidence"),
    "wrong-side": message("part-rule-wrong-side"),
    "other-feature": message("part-rule-other-feature"),
}
SOURCES: dict[str, Text] = {
    "calibration": message("part-source-calibration"),
    "arm": message("part-source-arm"),
    "tip": message("part-source-tip"),
    "encoders": message("part-source-encoders"),
    "stripe": message("part-source-stripe"),
    "touches": message("part-source-touches"),
    "form": message("part-source-form"),
    "temperature": message("part-source-temperature"),
}


def dimensions_table(document: InspectionFile) -> ReportTable[Text]:
    """Every dimension: nominal, limits, measured, deviation, U or scatter, decision."""
    is_full = document.uncertainty == "full"
    rows = []
    for one in document.dimensions:
        spread = one.standard_uncertainty if is_full else one.scatter
        # so exact that neither limit seems to be on the other side of the value
        limits = [at for at in (one.lower, one.upper) if at is not None]
        off = one.value - one.nominal
        more = decimals_beside(off, limits, DECIMALS[UNITS[one.unit]])
        rows.append(
            (
                one.id,
                _value(one, one.nominal, more),
                _limits(one),
                _value(one, one.value, more),
                Quantity(off, UNITS[one.unit], more, signed=True),
                NONE if spread is None else _value(one, 2 * spread, more),
                DECISIONS[OUTCOMES[one.decision]],
            )
        )
    columns = (
        message("part-dimension"),
        message("part-nominal"),
        message("part-limits"),
        message("part-measured-value"),
        message("part-deviation"),
        "U, k = 2" if is_full else message("part-scatter-k-2"),
        message("part-decision"),
    )
    return ReportTable(columns, rows, (20, 14, 18, 16, 15, 13, 14), small=True)


def dimension_value(one: DimensionResult) -> Quantity:
    """What was measured, as in the table."""
    return _value(one, one.value, DECIMALS[UNITS[one.unit]])


def _value(one: DimensionResult, value: float, decimals: int) -> Quantity:
    return quantity(value, UNITS[one.unit], decimals)


def _limits(one: DimensionResult) -> Text:
    """As deviations from the nominal."""

    def limit(value: float) -> Quantity:
        unit = UNITS[one.unit]
        places = decimals_beside(value, [], 1)
        while places < 6 and abs(round(value, places) - value) > 1e-9:
            places += 1
        return Quantity(value, unit, places, signed=True)

    if one.lower is None and one.upper is None:
        return NONE
    if one.lower is None:
        assert one.upper is not None
        return message("part-at-most", upper=limit(one.upper))
    if one.upper is None:
        return message("part-at-least", lower=limit(one.lower))
    return message("part-between", lower=limit(one.lower), upper=limit(one.upper))


def features_table(document: InspectionFile) -> ReportTable[Text]:
    """Every feature by each of the means, with what its fit used."""
    rows = [
        (
            one.id,
            message("part-kind", kind=one.kind),
            message("part-means", means=one.source),
            str(one.points),
            str(one.used),
            str(one.frames),
            micrometres(one.rms_um),
            micrometres(one.form_um),
        )
        for one in document.features
    ]
    columns = (
        message("part-feature"),
        message("part-kind-of-feature"),
        message("part-measured-by"),
        message("part-points"),
        message("part-used"),
        message("part-frames"),
        "RMS",
        message("part-range-of-cells"),
    )
    return ReportTable(columns, rows, (18, 16, 14, 12, 12, 12, 14, 16), numbers=3, small=True)


def exclusions_text(document: InspectionFile) -> list[TextBlock[Text]]:
    """What was left out of each feature by which rule; nothing is left out without a word."""
    rows = [
        message("part-left-out-of-feature", feature=one.id, means=one.source, parts=join(parts))
        for one in document.features
        if (
            parts := [
                message("part-left-out-by-rule", count=each.count, rule=RULES[each.rule])
                for each in one.excluded
            ]
        )
    ]
    if not rows:
        return [TextBlock(message("part-nothing-left-out"), small=True)]
    return [TextBlock(row, small=True) for row in rows]


def frame_texts(document: InspectionFile) -> list[Text]:
    """What the part frame is known to, at the datums and at the far corner, and from what."""
    found = document.alignment
    if found is None or not found.datums:
        return []
    texts: list[Text] = [message("part-frame-from", datums=", ".join(found.datums))]
    if found.at_datums_um is not None and found.far_corner is not None:
        texts.append(
            message(
                "part-frame-known",
                datums=micrometres(2 * found.at_datums_um),
                corner=micrometres(2 * found.far_corner.u_um),
            )
        )
    return texts


def budget_table(document: InspectionFile) -> ReportTable[Text] | None:
    """Standard uncertainties of each dimension by source; None where none is known."""
    if document.uncertainty != "full":
        return None
    present = {
        name
        for one in document.dimensions
        for name, value in one.contributions.items()
        if value > 0
    }
    names = [name for name in SOURCES if name in present]
    if not names:
        return None

    def cell(one: DimensionResult, value: float | None) -> Text:
        unit = UNITS[one.unit]
        if value is None:
            return NONE
        return micrometres(1e3 * value) if unit == "mm" else quantity(value, unit, DECIMALS[unit])

    rows = [
        (
            one.id,
            *(cell(one, one.contributions.get(name)) for name in names),
            cell(one, one.standard_uncertainty),
        )
        for one in document.dimensions
    ]
    columns = (message("part-dimension"), *(SOURCES[name] for name in names), "u, k = 1")
    return ReportTable(columns, rows, (20, *(13 for _ in names), 13), small=True)
