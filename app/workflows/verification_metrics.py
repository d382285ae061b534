"""A gauge's clouds against its nominal, the probe and the limits: figures and verdict."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import Literal

import numpy as np

from app.formats.datasheets.gauge import GaugeFile, VerificationLimits
from app.formats.results.verification import (
    FIGURE_TITLES,
    FigureName,
    FigurePart,
    JudgedBy,
    Result,
    VerificationVerdict,
)
from app.messages.message import Text, message
from app.metrology.decision import GUARDED_95, DecisionRule, decide
from app.metrology.gauges.errors import ARCSEC_PER_RAD, angle_between_rad, compare_plane
from app.metrology.gauges.probed_gauge import ProbedPlane, ProbedSphere
from app.workflows.judgement.reasons import Judgement, describe_judgement
from app.workflows.judgement.value_uncertainty import gauge_test_uncertainty
from app.workflows.measure_gauge import GaugeFit

ProbedGauge = ProbedPlane | ProbedSphere
K = 2.0
UNIFORM = float(np.sqrt(12.0))
ANGLES: tuple[FigureName, ...] = ("angle", "angle_range")
PLACES: tuple[FigureName, ...] = ("angle", "offset", "z_error", "centre_error")
"""Figures of where the gauge was found; they are judged by their measurement uncertainty."""
SIGNED: tuple[FigureName, ...] = ("offset", "z_error", "radius_error")
ORDER = ("fail", "uncertain", "pass", "none")


@dataclass(frozen=True)
class CloudErrors:
    """Of one cloud against the probe and the nominal; None where there is nothing to compare."""

    angle_arcsec: float | None = None
    z_error_um: float | None = None
    offset_error_um: float | None = None
    radius_error_um: float | None = None
    centre_error_um: float | None = None


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
    """Every figure that these clouds allow, each with its uncertainties and its limit.

    Figures of the instrument's performance (form, rms, radius, ranges) are judged by the test
    value uncertainty, those of where the gauge was found by the measurement uncertainty.

    Source:
        ISO 14253-5 for the difference of the two.
    """
    if not fits:
        return ()
    errors = [cloud_errors(fit, gauge, touched) for fit in fits]
    test = gauge_test_uncertainty(gauge, fits)
    nominal_sd_um = float(np.hypot(gauge.standard_uncertainty_um, gauge.form_um / UNIFORM))
    found: list[FigurePart] = []

    def add(name: FigureName, values: Sequence[float | None], measured: float) -> None:
        known = [value for value in values if value is not None]
        if len(known) == len(fits):
            found.append(_figure(name, known, measured, test, limits, rule))

    add("form", [fit.form_um for fit in fits], nominal_sd_um)
    add("form_all", [fit.form_all_um for fit in fits], nominal_sd_um)
    add("range_all", [fit.range_all_um for fit in fits], nominal_sd_um)
    add("rms", [fit.rms_um for fit in fits], nominal_sd_um)
    if gauge.shape == "plane":
        _add_plane(add, fits, errors, touched, nominal_sd_um)
    else:
        of_fit = max(fit.sd(slice(3, 4)) for fit in fits) * 1e3
        add(
            "radius_error",
            [e.radius_error_um for e in errors],
            float(np.hypot(of_fit, nominal_sd_um)),
        )
        of_fit = max(fit.sd(slice(0, 3)) for fit in fits) * 1e3
        of_touch = touched.centre_sd_mm * 1e3 if isinstance(touched, ProbedSphere) else 0.0
        add("centre_error", [e.centre_error_um for e in errors], float(np.hypot(of_fit, of_touch)))
    ranges = [
        _judge(name, value, measured, test, limits, rule)
        for name, value, measured in _ranges(fits, gauge)
    ]
    return (*found, *ranges)


def _add_plane(
    add: Callable[[FigureName, Sequence[float | None], float], None],
    fits: Sequence[GaugeFit],
    errors: Sequence[CloudErrors],
    touched: ProbedGauge | None,
    nominal_sd_um: float,
) -> None:
    if not isinstance(touched, ProbedPlane):
        return
    tilt = max(_tilt_sd(fit) for fit in fits)
    add(
        "angle",
        [e.angle_arcsec for e in errors],
        float(np.hypot(tilt, touched.angle_sd_rad)) * ARCSEC_PER_RAD,
    )
    variances = [
        fit.sd(slice(0, 1)) ** 2 + touched.height_sd_mm(np.array(fit.centre_mm)) ** 2
        for fit in fits
    ]
    height = float(np.hypot(np.sqrt(max(variances)) * 1e3, nominal_sd_um))
    add("offset", [e.offset_error_um for e in errors], height)
    add("z_error", [e.z_error_um for e in errors], height)


def _tilt_sd(fit: GaugeFit) -> float:
    """Rad, in the worst direction; by the points' scatter where the fit has no covariance."""
    if fit.covariance:
        return fit.sd(slice(1, 3))
    return fit.rms_um / 1e3 / 10.0


def _ranges(fits: Sequence[GaugeFit], gauge: GaugeFile) -> list[tuple[FigureName, float, float]]:
    """How far the clouds lie apart, of any two the largest, with its measurement uncertainty."""
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
    tilt = two * max(_tilt_sd(fit) for fit in fits) * ARCSEC_PER_RAD
    shift = two * max(fit.sd(slice(0, 1)) for fit in fits) * 1e3
    return [
        ("angle_range", turned * ARCSEC_PER_RAD, tilt),
        ("offset_range", float(np.ptp(heights)) * 1e3, shift),
    ]


def _figure(
    name: FigureName,
    values: Sequence[float],
    measured: float,
    test: Mapping[FigureName, float],
    limits: VerificationLimits,
    rule: DecisionRule,
) -> FigurePart:
    figure = _judge(name, max(values, key=abs), measured, test, limits, rule)
    several = len(values) > 1
    return figure.model_copy(
        update={
            "clouds": tuple(values),
            "mean": float(np.mean(values)) if several else None,
            "standard_deviation": float(np.std(values, ddof=1)) if several else None,
        }
    )


def _judge(
    name: FigureName,
    value: float,
    measured: float,
    test: Mapping[FigureName, float],
    limits: VerificationLimits,
    rule: DecisionRule,
) -> FigurePart:
    """One figure against its limit; the uncertainties ``measured`` and ``test``: k = 1."""
    unit: Literal["µm", "″"] = "″" if name in ANGLES else "µm"
    by: JudgedBy = "measurement" if name in PLACES else "test"
    standard = measured if by == "measurement" else test[name]
    limit: float | None = getattr(limits, name, None)
    decision = decide(value, limit, standard, rule, signed=name in SIGNED)
    words = Judgement(FIGURE_TITLES[name], value, limit, standard, unit, decision, name in SIGNED)
    return FigurePart(
        name=name,
        title=FIGURE_TITLES[name],
        unit=unit,
        value=value,
        expanded_uncertainty=K * measured,
        test_uncertainty=test[name],
        judged_by=by,
        limit=limit,
        decision=decision,
        reason=describe_judgement(words, rule),
    )


WORDS: dict[Result, Text] = {
    "pass": message("every-figure-keeps-limit"),
    "fail": message("every-figure-keeps-limit-2"),
    "uncertain": message("every-figure-known-well-enough-judged"),
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
