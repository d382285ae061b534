"""The report on gauges as tables for printing."""

from collections.abc import Iterator, Mapping, Sequence

from crenel.gauges.quick.clouds.document import CloudReport, GaugeReport
from crenel.gauges.quick.clouds.evaluate import DISPERSIONS, FIGURES, PARAMETERS, Shape
from crenel.gauges.quick.maths.figure_budget import K, Source, Statistic
from crenel.messages.message import Quantity, Unit
from crenel.messages.uncertainty import part_quantity, uncertainty_quantity

STATISTICS: dict[Statistic, str] = {
    "mean": "mean",
    "standard_deviation": "standard deviation",
    "range": "range",
}
SMALLEST = 1e-6
SOURCES: tuple[Source, ...] = ("gauge", "points", "clouds")


def report_table(report: GaugeReport) -> tuple[list[str], list[list[str]]]:
    """Headings and rows for printing: one row per cloud, then the scatter over several.

    Every figure has its expanded uncertainty (k = 2) beside it.
    """
    shown = _figure_names(report)
    headings = ["cloud", "points", "used", *(FIGURES[name][0] for name in shown)]
    rows = [
        [
            cloud.file,
            str(cloud.points),
            str(cloud.used),
            *(_show_figure(report.shape, cloud, name) for name in shown),
        ]
        for cloud in report.clouds
    ]
    for statistic, title in STATISTICS.items() if report.spread else ():
        figures = (
            _show(
                getattr(report.spread[name], statistic),
                report.spread[name].expanded_uncertainty.get(statistic),
                name,
            )
            if name in report.spread
            else ""
            for name in shown
        )
        rows.append([title, "", "", *figures])
    return headings, rows


def budget_table(report: GaugeReport) -> tuple[list[str], list[list[str]]]:
    """Headings and rows for printing: what each expanded uncertainty (k = 2) consists of.

    The root of the sum of squares of the parts, as printed, is the uncertainty, as printed.
    """
    found = list(_budgets(report))
    known = [source for source in SOURCES if any(source in parts for *_, parts in found)]
    rows = []
    for of, name, whole, parts in found:
        unit = _unit(name)
        shown = (
            _text(part_quantity(K * parts[source], whole, unit)) if source in parts else ""
            for source in known
        )
        rows.append([of, FIGURES[name][0], _text(_least_shown(whole, unit)), *shown])
    return ["cloud", "figure", "U", *known], rows


def _budgets(
    report: GaugeReport,
) -> Iterator[tuple[str, str, float, Mapping[Source, float]]]:
    """Which cloud or statistic, the figure, its expanded uncertainty, and its budget."""
    shown = _figure_names(report)
    for cloud in report.clouds:
        for name in shown:
            if name in cloud.budget:
                yield cloud.file, name, cloud.expanded_uncertainty[name], cloud.budget[name]
    for statistic, title in STATISTICS.items():
        for name, spread in report.spread.items():
            if statistic in spread.budget:
                whole = spread.expanded_uncertainty[statistic]
                yield title, name, whole, spread.budget[statistic]


def _figure_names(report: GaugeReport) -> Sequence[str]:
    return [name for name in FIGURES if getattr(report.clouds[0], name) is not None]


def _show_figure(shape: Shape, cloud: CloudReport, name: str) -> str:
    value: float | None = getattr(cloud, name)
    if value is None:
        return ""
    decimals = FIGURES[name][1]
    uncertainty = cloud.expanded_uncertainty.get(name)
    if name in DISPERSIONS and value < 10.0**-decimals / 2 and cloud.used > PARAMETERS[shape]:
        return f"< {_show(10.0**-decimals, uncertainty, name)}"
    return _show(value, uncertainty, name)


def _show(value: float, uncertainty: float | None, name: str) -> str:
    text = f"{value:.{FIGURES[name][1]}f}"
    if uncertainty is None:
        return text
    return f"{text} ± {_text(_least_shown(uncertainty, _unit(name)))}"


def _least_shown(uncertainty: float, unit: Unit) -> Quantity:
    """Also points without any scatter are not known exactly."""
    return uncertainty_quantity(max(uncertainty, SMALLEST), unit)


def _unit(name: str) -> Unit:
    return "mm" if name == "radius_mm" else "µm"


def _text(shown: Quantity) -> str:
    return f"{shown.value:.{shown.decimals}f}"
