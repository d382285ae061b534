"""The tables of a verification: its figures, what their uncertainties consist of, its clouds."""

from typing import Literal

from crenel.gauges.quick.document import (
    BudgetedPart,
    CloudPart,
    FigurePart,
    VerificationFile,
)
from crenel.gauges.quick.maths.figure_budget import K, Source
from crenel.gauges.quick.report_figures import cloud_plot
from crenel.gauges.report.head import DECISIONS
from crenel.messages.message import Text, Unit, join, message, quantity
from crenel.messages.uncertainty import part_quantity, uncertainty_quantity
from crenel.report.content import Pictures, ReportTable, Section, TextBlock
from crenel.report.formatting import (
    NONE,
    error_value,
    in_both_units,
    limit_beside,
    plus_minus,
    value_beside,
)

MARK = " *"


def results_table(document: VerificationFile) -> ReportTable[Text]:
    rows: list[tuple[Text, ...]] = [
        (
            figure.title,
            value_beside(figure.value, figure.limit, figure.unit),
            in_both_units(figure.value, [figure.limit])[1] if figure.unit == "µm" else "",
            *_uncertainties(figure),
            NONE if figure.limit is None else limit_beside(figure.value, figure.limit, figure.unit),
            DECISIONS[figure.decision],
        )
        for figure in document.figures
    ]
    columns = (
        message("figure"),
        message("value"),
        message("mm"),
        message("measurement-u"),
        message("test-u"),
        message("limit"),
        message("decision"),
    )
    return ReportTable(columns, rows, (28, 12, 13, 13, 13, 11, 14))


def _uncertainties(figure: FigurePart) -> tuple[Text, Text]:
    """Measurement and test value uncertainty, k = 2; the one that the limit is judged by is
    marked. Older records list no budget, and the two do not agree: only the marked one counts."""
    by_test = figure.judged_by == "test"
    measured = plus_minus(uncertainty_quantity(figure.expanded_uncertainty, figure.unit))
    if figure.test_uncertainty is None:
        return measured, NONE
    test = plus_minus(uncertainty_quantity(K * figure.test_uncertainty, figure.unit))
    marked = join([test if by_test else measured, MARK], "")
    if not figure.budget:
        return (NONE, marked) if by_test else (marked, NONE)
    return (measured, marked) if by_test else (marked, test)


SOURCES: dict[Source, Text] = {
    "gauge": message("gauge"),
    "probe": message("probe"),
    "points": message("scatter-of-points"),
    "clouds": message("scatter-of-clouds"),
}


def budget_sections(document: VerificationFile) -> list[Section[Text]]:
    """What every expanded uncertainty consists of; older records do not state it."""
    found: list[tuple[Text, BudgetedPart, Literal["µm", "″"]]] = []
    for figure in document.figures:
        found.append((figure.title, figure, figure.unit))
        for statistic, part in figure.spread.items():
            title = message("figure-over-clouds", title=figure.title, of=statistic)
            found.append((title, part, figure.unit))
    found = [one for one in found if one[1].budget]
    if not found:
        return []
    sources = [one for one in SOURCES if any(one in part.budget for _, part, _ in found)]
    rows: list[tuple[Text, ...]] = [
        (
            title,
            error_value(part.value, unit),
            uncertainty_quantity(part.expanded_uncertainty, unit),
            *(_part(part, source, unit) for source in sources),
        )
        for title, part, unit in found
    ]
    columns = (
        message("figure"),
        message("value"),
        message("measurement-u"),
        *(SOURCES[source] for source in sources),
    )
    table = ReportTable[Text](columns, rows, (40, 13, 13, *[13] * len(sources)))
    text = TextBlock[Text](message("uncertainty-is-root-of-parts"))
    return [Section(message("uncertainty-budgets"), [table, text], together=False)]


def _part(part: BudgetedPart, source: Source, unit: Unit) -> Text:
    if source not in part.budget:
        return "–"
    return part_quantity(K * part.budget[source], part.expanded_uncertainty, unit)


FORM_FIGURES: tuple[tuple[str, Text, int], ...] = (
    ("form_all_um", message("form-all-m"), 1),
    ("range_all_um", message("range-all-m"), 1),
)
"""The form figures of all points in the gate; older clouds have none."""
CLOUD_FIGURES: tuple[tuple[str, Text, int], ...] = (
    ("angle_arcsec", message("angle"), 1),
    ("z_error_um", "Z, µm", 1),
    ("offset_error_um", message("offset-m"), 1),
    ("radius_error_um", message("radius-m"), 1),
    ("centre_error_um", message("centre-m"), 1),
)


def cloud_sections(document: VerificationFile) -> list[Section[Text]]:
    """The figures of each cloud as a table, and as points over the clouds (article, Figs. 7-11)."""
    known = [
        (name, title, decimals)
        for name, title, decimals in CLOUD_FIGURES
        if any(getattr(cloud, name) is not None for cloud in document.clouds)
    ]
    forms = [
        (name, title, decimals)
        for name, title, decimals in FORM_FIGURES
        if any(getattr(cloud, name) is not None for cloud in document.clouds)
    ]
    rows: list[tuple[Text, ...]] = [
        (
            cloud.name,
            str(cloud.used),
            quantity(cloud.rms_um, decimals=1),
            quantity(cloud.form_um, decimals=1),
            *(_cell(cloud, name, decimals) for name, _, decimals in (*forms, *known)),
        )
        for cloud in document.clouds
    ]
    columns = (
        message("cloud"),
        message("points-used"),
        "rms, µm",
        message("form-95-m"),
        *(title for _, title, _ in (*forms, *known)),
    )
    widths = (18, 12, 10, 13, *[12] * (len(forms) + len(known)))
    table = ReportTable[Text](columns, rows, widths)
    sections = [Section[Text](message("clouds-heading"), [table], together=False)]
    if len(document.clouds) > 1 and known:
        plots = [cloud_plot(document, name, title) for name, title, _ in known]
        sections.append(Section(message("over-clouds"), [Pictures(plots, 3)], together=False))
    return sections


def _cell(cloud: CloudPart, name: str, decimals: int) -> Text:
    value = getattr(cloud, name)
    return "–" if value is None else quantity(value, decimals=decimals)
