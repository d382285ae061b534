"""A gauge's clouds against its nominal, the probe and the limits: figures and verdict."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import Literal

import numpy as np

from crenel.gauges.plan.document_gauge import GaugeFile, VerificationLimits
from crenel.gauges.quick.document import (
    FIGURE_TITLES,
    FigureName,
    FigurePart,
    JudgedBy,
    Result,
    StatisticPart,
    VerificationVerdict,
)
from crenel.gauges.quick.evaluate_budgets import (
    Judgement,
    cloud_budgets,
    describe_judgement,
    steepness_of,
    tilt_sd_rad,
)
from crenel.gauges.quick.evaluate_gauge import GaugeFit
from crenel.gauges.quick.evaluate_value_uncertainty import (
    gauge_range_uncertainty,
    gauge_test_uncertainty,
)
from crenel.gauges.quick.maths.errors import ARCSEC_PER_RAD, angle_between_rad, compare_plane
from crenel.gauges.quick.maths.figure_budget import (
    Budget,
    K,
    Statistic,
    combine_budget,
    largest_budget,
    spread_statistics,
)
from crenel.gauges.quick.maths.probed_gauge import ProbedGauge, ProbedPlane, ProbedSphere
from crenel.messages.message import Text, message
from crenel.metrology.decision import GUARDED_95, DecisionRule, decide

ANGLES: tuple[FigureName, ...] = ("angle", "angle_range")
PLACES: tuple[FigureName, ...] = ("angle", "offset", "z_error", "centre_error")
"""Figures of where the gauge was found; they are judged by their measurement uncertainty."""
SIGNED: tuple[FigureName, ...] = ("offset", "z_error", "radius_error")
ORDER = ("fail", "uncertain", "pass", "none")


@dataclass(frozen=True)
class CloudErrors:
    """The errors of one cloud against the probe and the nominal; None where there is nothing to
    compare."""

    angle_arcsec: float | None = None
    z_error_um: float | None = None
    offset_error_um: float | None = None
    radius_error_um: float | None = None
    centre_error_um: float | None = None


VALUES: dict[FigureName, Callable[[GaugeFit, CloudErrors], float | None]] = {
    "form": lambda fit, _: fit.form_um,
    "form_all": lambda fit, _: fit.form_all_um,
    "range_all": lambda fit, _: fit.range_all_um,
    "rms": lambda fit, _: fit.rms_um,
    "angle": lambda _, errors: errors.angle_arcsec,
    "offset": lambda _, errors: errors.offset_error_um,
    "z_error": lambda _, errors: errors.z_error_um,
    "radius_error": lambda _, errors: errors.radius_error_um,
    "centre_error": lambda _, errors: errors.centre_error_um,
}
"""The values of one cloud, in the order of the report."""


def cloud_errors(fit: GaugeFit, gauge: GaugeFile, touched: ProbedGauge | None) -> CloudErrors:
    """One cloud's errors (Eq. 10-12; for a sphere as in the article's section 4)."""
    if gauge.shape == "plane":
        if not isinstance(touched, ProbedPlane):
            return CloudErrors()
        check = compare_plane(fit.plane, touched.nominal)
        return CloudErrors(check.angle_arcsec, check.z_error_um, check.offset_um)
    assert fit.radius_mm is not None
    assert gauge.radius_mm is not None
    radius = (gauge.radius_mm - fit.radius_mm) * 1e3
    if not isinstance(touched, ProbedSphere):
        return CloudErrors(radius_error_um=radius)
    away = np.array(fit.centre_mm) - touched.nominal.centre_mm
    centre = float(np.linalg.norm(away)) * 1e3
    return CloudErrors(radius_error_um=radius, centre_error_um=centre)


def gauge_figures(
    fits: Sequence[GaugeFit],
    gauge: GaugeFile,
    touched: ProbedGauge | None,
    limits: VerificationLimits,
    rule: DecisionRule = GUARDED_95,
) -> tuple[FigurePart, ...]:
    """Every figure that these clouds allow, each with its uncertainty budget and its limit.

    Figures of the instrument's performance (form, rms, radius, ranges) are judged by the test
    value uncertainty, those of where the gauge was found by the measurement uncertainty.

    Source:
        ISO 14253-5 for the difference of the two.
    """
    if not fits:
        return ()
    widths_mm = [fit.width_mm for fit in fits if fit.width_mm]
    test = gauge_test_uncertainty(gauge, widths_mm, steepness_of(touched))
    errors = [cloud_errors(fit, gauge, touched) for fit in fits]
    budgets = [cloud_budgets(fit, test, touched) for fit in fits]
    found: list[FigurePart] = []
    for name, value_of in VALUES.items():
        values = [value_of(fit, error) for fit, error in zip(fits, errors, strict=True)]
        known = [value for value in values if value is not None]
        if len(known) == len(fits):
            figure = _judge(
                name,
                max(known, key=abs),
                largest_budget([one[name] for one in budgets]),
                limits,
                rule,
            )
            spread = _spread(name, known, [one[name] for one in budgets], test)
            found.append(figure.model_copy(update={"clouds": tuple(known), "spread": spread}))
    ranges = [
        _judge(name, value, {"gauge": test[name], "points": points}, limits, rule)
        for name, value, points in _ranges(fits, gauge)
    ]
    return (*found, *ranges)


def _spread(
    name: FigureName,
    values: Sequence[float],
    budgets: Sequence[Budget],
    test: Mapping[FigureName, float],
) -> dict[Statistic, StatisticPart]:
    """Mean, standard deviation and range over the clouds, of two or more."""
    if len(values) < 2:
        return {}
    found = spread_statistics(values, budgets, gauge_range_uncertainty(name, test))
    return {
        statistic: StatisticPart(
            value=one.value,
            expanded_uncertainty=combine_budget(one.budget),
            budget=dict(one.budget),
        )
        for statistic, one in found.items()
    }


def _ranges(fits: Sequence[GaugeFit], gauge: GaugeFile) -> list[tuple[FigureName, float, float]]:
    """How far the clouds lie apart, of any two the largest, with the uncertainty by their
    points, k = 1."""
    if len(fits) < 2:
        return []
    two = float(np.sqrt(2.0))
    if gauge.shape == "sphere":
        centres = [np.array(fit.centre_mm) for fit in fits]
        apart = max(float(np.linalg.norm(a - b)) for a, b in combinations(centres, 2)) * 1e3
        sd = two * max(fit.sd(slice(0, 3)) for fit in fits) * 1e3
        return [("centre_range", apart, sd)]
    planes = [fit.plane for fit in fits]
    turned = max(angle_between_rad(a.normal, b.normal) for a, b in combinations(planes, 2))
    first = planes[0]
    middle = np.mean([plane.centre_mm for plane in planes], axis=0)
    heights = [
        (plane.offset_mm - plane.normal @ middle) / (plane.normal @ first.normal)
        for plane in planes
    ]
    tilt = two * max(tilt_sd_rad(fit) for fit in fits) * ARCSEC_PER_RAD
    shift = two * max(fit.sd(slice(0, 1)) for fit in fits) * 1e3
    return [
        ("angle_range", turned * ARCSEC_PER_RAD, tilt),
        ("offset_range", float(np.ptp(heights)) * 1e3, shift),
    ]


def _judge(
    name: FigureName,
    value: float,
    budget: Budget,
    limits: VerificationLimits,
    rule: DecisionRule,
) -> FigurePart:
    """One figure against its limit."""
    unit: Literal["µm", "″"] = "″" if name in ANGLES else "µm"
    by: JudgedBy = "measurement" if name in PLACES else "test"
    standard = combine_budget(budget) / K if by == "measurement" else budget["gauge"]
    limit: float | None = getattr(limits, name, None)
    decision = decide(value, limit, standard, rule, signed=name in SIGNED)
    words = Judgement(FIGURE_TITLES[name], value, limit, standard, unit, decision, name in SIGNED)
    return FigurePart(
        name=name,
        title=FIGURE_TITLES[name],
        unit=unit,
        value=value,
        expanded_uncertainty=combine_budget(budget),
        test_uncertainty=budget["gauge"],
        budget=dict(budget),
        spread={},
        judged_by=by,
        limit=limit,
        decision=decision,
        reason=describe_judgement(words, rule),
    )


WORDS: dict[Result, Text] = {
    "pass": message("every-figure-keeps-limit"),
    "fail": message("not-every-figure-keeps-limit"),
    "uncertain": message("not-every-figure-known-well-enough"),
}
WORDS_UNTOUCHED: dict[Result, Text] = {
    "pass": message("figures-keep-limits-not-compared"),
    "fail": message("figures-break-limits-not-compared"),
    "uncertain": message("figures-undecided-not-compared"),
}
"""Where the gauge was not touched."""


def verification_verdict(figures: Sequence[FigurePart], touched: bool) -> VerificationVerdict:
    """As bad as the worst of the figures."""
    decisions = [figure.decision for figure in figures]
    result: Result = "pass"
    if "fail" in decisions:
        result = "fail"
    elif "uncertain" in decisions or set(decisions) <= {"none"}:
        result = "uncertain"
    ordered = sorted(figures, key=lambda figure: ORDER.index(figure.decision))
    text = WORDS[result] if touched else WORDS_UNTOUCHED[result]
    return VerificationVerdict(
        result=result, text=text, reasons=tuple(figure.reason for figure in ordered)
    )
