"""What the uncertainty of each figure of a cloud consists of: gauge, probe and points."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

import numpy as np

from crenel.gauges.quick.document import FigureName
from crenel.gauges.quick.evaluate_gauge import GaugeFit
from crenel.gauges.quick.maths.errors import ARCSEC_PER_RAD
from crenel.gauges.quick.maths.figure_budget import Budget, Source
from crenel.gauges.quick.maths.probed_gauge import ProbedGauge, ProbedPlane, ProbedSphere
from crenel.messages.limits import beside_limit
from crenel.messages.message import Text, message, quantity
from crenel.messages.uncertainty import uncertainty_quantity
from crenel.metrology.decision import EXPANDED_K2, Decision, DecisionRule

GaugeUncertainty = Mapping[FigureName, float]
"""The test value uncertainty of each figure, k = 1."""


def cloud_budgets(
    fit: GaugeFit, gauge: GaugeUncertainty, touched: ProbedGauge | None
) -> dict[FigureName, Budget]:
    """The budget of every figure that one cloud may have.

    Args:
        fit: of the cloud.
        gauge: of its gauge.
        touched: the gauge by its contact points.
    """
    points: dict[FigureName, float] = {
        "form": fit.form_sd_um,
        "form_all": fit.form_all_sd_um,
        "range_all": fit.range_all_sd_um,
        "rms": fit.rms_sd_um,
    }
    probe: dict[FigureName, float] = {}
    if fit.normal is None:
        points["radius_error"] = fit.sd(slice(3, 4)) * 1e3
        points["centre_error"] = fit.sd(slice(0, 3)) * 1e3
        if isinstance(touched, ProbedSphere):
            probe["centre_error"] = touched.centre_sd_mm * 1e3
    elif isinstance(touched, ProbedPlane):
        steepness = steepness_of(touched)
        height_um = touched.height_sd_mm(np.array(fit.centre_mm)) * 1e3
        points["angle"] = tilt_sd_rad(fit) * ARCSEC_PER_RAD
        points["offset"] = fit.sd(slice(0, 1)) * 1e3
        points["z_error"] = points["offset"] / steepness
        probe["angle"] = touched.angle_sd_rad * ARCSEC_PER_RAD
        probe["offset"] = height_um
        probe["z_error"] = height_um / steepness
    return {name: _budget(name, gauge, probe, points) for name in points}


def _budget(
    name: FigureName,
    gauge: GaugeUncertainty,
    probe: Mapping[FigureName, float],
    points: Mapping[FigureName, float],
) -> Budget:
    found: dict[Source, float] = {"gauge": gauge[name]}
    if name in probe:
        found["probe"] = probe[name]
    return {**found, "points": points[name]}


def steepness_of(touched: ProbedGauge | None) -> float:
    """The share of Z in a touched plane's normal: by so much less is a height along it."""
    if not isinstance(touched, ProbedPlane):
        return 1.0
    return max(abs(float(touched.nominal.normal[2])), 1e-9)


def tilt_sd_rad(fit: GaugeFit) -> float:
    """In the worst direction; by the points' scatter where the fit has no covariance."""
    if fit.covariance:
        return fit.sd(slice(1, 3))
    return fit.rms_um / 1e3 / 10.0


@dataclass(frozen=True)
class Judgement:
    """A figure and its decision."""

    title: Text
    value: float
    limit: float | None
    standard_uncertainty: float
    """The one that it is judged by, k = 1."""
    unit: Literal["µm", "″"]
    decision: Decision
    signed: bool


def describe_judgement(judged: Judgement, rule: DecisionRule) -> Text:
    """The sentence, by the size of the guard band.

    Args:
        judged: the figure.
        rule: by which it was judged.
    """
    unit, limit, title = judged.unit, judged.limit, judged.title
    size, guard = abs(judged.value), rule.guard_factor * judged.standard_uncertainty
    if limit is None:
        return message("there-no-limit", title=title, value=quantity(size, unit))
    shown, most = beside_limit(size, limit, unit)
    if guard == 0:
        how = "within" if size <= limit else "beyond"
        return message("figure-without-guard", title=title, value=shown, limit=most, how=how)
    band = uncertainty_quantity(guard, unit)
    if judged.signed and limit < 2 * judged.standard_uncertainty:
        return message(
            "figure-between-close-limits",
            title=title,
            value=shown,
            limit=most,
            guard=band,
            decision=judged.decision,
        )
    if size + guard <= limit:
        if rule.name == EXPANDED_K2.name:
            return message(
                "figure-within-limit", title=title, value=shown, limit=most, uncertainty=band
            )
        return message("figure-within-guard", title=title, value=shown, limit=most, guard=band)
    if size - guard > limit:
        if rule.name == EXPANDED_K2.name:
            return message(
                "figure-beyond-limit", title=title, value=shown, limit=most, uncertainty=band
            )
        return message("figure-beyond-guard", title=title, value=shown, limit=most, guard=band)
    if rule.name == EXPANDED_K2.name and judged.decision == "uncertain":
        return message("figure-near-limit", title=title, value=shown, limit=most, uncertainty=band)
    return message(
        "figure-near-guard",
        title=title,
        value=shown,
        limit=most,
        guard=band,
        decision=judged.decision,
    )
