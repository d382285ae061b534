"""Checks of the stated sizes of spheres, bars and the tip."""

from dataclasses import replace

import numpy as np

from app.errors import OperationError
from app.messages.message import Text, message, quantity, rounded, signed
from app.metrology.arm.identification.observations import (
    ArmObservations,
    ProbedPlace,
    StackedObservations,
)
from app.metrology.arm.identification.parameter_selection import LENGTH_MM, candidates
from app.metrology.arm.identification.parameters import tip_jacobian
from app.metrology.arm.identification.robust_solve import ArmFit, fit_arm
from app.metrology.arm.identification.volumetric_error import size_uncertainty_mm
from app.metrology.arm.kinematics import Arm
from app.metrology.transforms import Floats

LEAST_TO_SIZE, SPHERE_STEPS, OUTLIER_SDS = 8, 20, 5.0
"""Number of points that determine a sphere's size; points off by more than this number of sd are
outliers."""
FREE_MM = 1e3
"""Uncertainty of a bar's length that makes the length free."""
CONTRADICTION = 2.0
UNLIKELY = 5e-4
"""Share of its length by which the arm's measurement of a bar is hardly ever wrong."""
EXCESS_SIGMAS, EXCESS_MM, WRONG_TIP_MM = 5.0, 0.005, 0.025


def check_spheres(data: StackedObservations, fit: ArmFit) -> list[Text]:
    """Warns of a sphere whose measured size differs from the others; refuses one far off.

    Each sphere is measured by its own points and the fitted arm, regardless of what the fit
    excluded.
    """
    excesses = _sphere_excesses(data, fit)
    if len(excesses) < 2:
        return []
    excess, sd = np.array([own[1:] for own in excesses]).T
    weights = 1 / sd**2
    rest = weights.sum() - weights
    off = excess - (np.sum(weights * excess) - weights * excess) / rest
    off_sd = np.sqrt(sd**2 + 1 / rest)
    # of several, the one with the most significant difference; of two, neither can be named
    worst = int(np.argmax(np.abs(off) / off_sd))
    if abs(off[worst]) <= max(EXCESS_SIGMAS * off_sd[worst], EXCESS_MM):
        return []
    finding = message(
        "seen-than-against-diameters-given",
        label=excesses[worst][0].label,
        off=quantity(2e3 * abs(off[worst]), "µm"),
        uncertainty=quantity(2e3 * off_sd[worst]),
        sign="larger" if off[worst] > 0 else "smaller",
        others=len(excesses) - 1,
    )
    if abs(off[worst]) > WRONG_TIP_MM:
        raise OperationError(
            "sphere-diameter",
            finding,
            message("one-diameter-spheres-sphere-clean"),
            message("check-diameter-mm-spheres-take-sphere"),
        )
    return [message("check-diameter", finding=finding)]


def _sphere_excesses(
    data: StackedObservations, fit: ArmFit
) -> list[tuple[ProbedPlace, float, float]]:
    """For each sphere with enough points: radius excess and its standard deviation, mm."""
    tips = tip_jacobian(fit.at.arm, data.q_rad)[0]
    found: list[tuple[ProbedPlace, float, float]] = []
    for number, place in enumerate(data.places):
        if place.diameter_mm is None or place.rows.stop - place.rows.start < LEAST_TO_SIZE:
            continue
        expected = place.diameter_mm / 2 + fit.at.arm.tip.radius_mm
        own = _fit_sphere_radius(tips[place.rows], fit.at.centres_mm[number], expected)
        if own is not None:
            found.append((place, own[0] - expected, own[1]))
    return found


def _fit_sphere_radius(
    points: Floats, centre: Floats, radius_mm: float
) -> tuple[float, float] | None:
    """Radius of the points (m, 3), without outliers, and its standard deviation."""
    at = np.append(centre, radius_mm)
    kept = np.ones(len(points), bool)
    sd, J = 0.0, np.ones((len(points), 4))
    for _ in range(SPHERE_STEPS):
        away = points - at[:3]
        far = np.linalg.norm(away, axis=1)
        off = far - at[3]
        J = np.column_stack([away / far[:, None], np.ones(len(points))])
        at = at + np.linalg.lstsq(J[kept], off[kept], rcond=None)[0]
        left = np.abs(off - np.median(off))
        sd = max(1.4826 * float(np.median(left)), 1e-6)
        kept = left < OUTLIER_SDS * sd
        if kept.sum() < LEAST_TO_SIZE:
            return None
    spare = int(kept.sum()) - 4
    off = np.linalg.norm(points - at[:3], axis=1) - at[3]
    sd = float(np.sqrt(np.sum(off[kept] ** 2) / spare))
    shape = np.linalg.pinv(J[kept].T @ J[kept])
    return float(at[3]), max(sd, 1e-6) * float(np.sqrt(shape[3, 3]))


def check_bars(arm: Arm, observations: ArmObservations, fit: ArmFit) -> list[Text]:
    """Warns of bars whose measured length differs; refuses lengths that contradict the other data.

    The comparison is a fit in which the length of every bar is free.
    """
    if not observations.bars:
        return []
    free = replace(
        observations,
        bars=tuple(replace(bar, standard_uncertainty_mm=FREE_MM) for bar in observations.bars),
    )
    try:
        loose = fit_arm(arm, free.stacked, candidates(arm, with_lengths=False))
    except OperationError:  # without the lengths, too little data is left to contradict them
        return []
    lengths = {bar.name: bar.length_mm for bar in observations.bars}
    errors = dict(zip(free.stacked.bar_names, loose.at.bar_errors_mm.tolist(), strict=True))
    worst = max(errors, key=lambda name: abs(errors[name]) / lengths[name])
    finding = message(
        "arm-sees-bar-given",
        bar=worst,
        measured=quantity(lengths[worst] + errors[worst], "mm", 3),
        given=quantity(lengths[worst], "mm", 3),
    )
    if fit.scatter_mm > CONTRADICTION * max(loose.scatter_mm, 2e-3):
        raise OperationError(
            "bar-length",
            finding,
            message(
                "bars-lengths-points-scatter-without-them",
                scatter=quantity(1e3 * fit.scatter_mm, "µm"),
                without=quantity(1e3 * loose.scatter_mm, "µm"),
            ),
            message("check-length-mm-bar-ends", bar=worst),
        )
    if abs(errors[worst]) > UNLIKELY * lengths[worst]:
        if _spheres_contradict_bars(loose, fit):
            raise OperationError(
                "bar-length",
                finding,
                message(
                    "spheres-size-by-certificate-or-datasheet",
                    excess=quantity(2e3 * abs(fit.at.radius_excess_mm), "µm"),
                    sign="larger" if fit.at.radius_excess_mm > 0 else "smaller",
                ),
                message("check-length-mm-bar-ends", bar=worst),
            )
        return [message("check-length-unless-datasheet-is-as-far-off", finding=finding)]
    return []


def _spheres_contradict_bars(loose: ArmFit, fit: ArmFit) -> bool:
    """Whether spheres fit their diameters if no bar length determines the arm's scale."""
    excess, sd = fit.at.radius_excess_mm, float(np.sqrt(fit.others_covariance[0, 0]))
    plain = abs(excess) > max(EXCESS_SIGMAS * sd, EXCESS_MM)
    return plain and abs(loose.at.radius_excess_mm) < 0.5 * abs(excess)


def check_tip_diameter(arm: Arm, data: StackedObservations, fit: ArmFit) -> None:
    """Refuses a tip or spheres whose diameter clearly differs from the stated one.

    An arm that is scaled up by a wrong bar also measures them larger.
    """
    if not data.on_sphere.any():
        return
    excess, sd = fit.at.radius_excess_mm, float(np.sqrt(fit.others_covariance[0, 0]))
    if abs(excess) > max(EXCESS_SIGMAS * sd, WRONG_TIP_MM):
        diameter = arm.tip.diameter_mm
        fitted = quantity(diameter + 2 * excess, "mm", 3)
        raise OperationError(
            "tip-diameter",
            message(
                "spheres-seen-against-their-diameters-tips",
                excess=signed(2e3 * excess, "µm"),
                uncertainty=quantity(2e3 * sd),
                diameter=rounded(diameter, "mm"),
            ),
            message("tip-rather-has-or-bar-wrong", diameter=fitted)
            if data.bars
            else message("tip-rather-has", diameter=fitted),
            message("correct-tips-diameter-arm-json-what"),
        )


def size_warnings(arm: Arm, observations: ArmObservations, fit: ArmFit) -> list[Text]:
    """Sizes that are unknown or look slightly wrong."""
    warnings: list[Text] = []
    if not observations.bars:
        size_um = 1e3 * size_uncertainty_mm(arm)
        warnings.append(
            message(
                "no-ball-bar-measured-arms-size",
                error=rounded(LENGTH_MM, "mm"),
                size=quantity(size_um, "µm"),
            )
        )
    if observations.spheres:
        excess, sd = fit.at.radius_excess_mm, float(np.sqrt(fit.others_covariance[0, 0]))
        if abs(excess) > max(EXCESS_SIGMAS * sd, EXCESS_MM):
            warnings.append(
                message(
                    "spheres-seen-than-stated-tips-diameter",
                    excess=quantity(2e3 * abs(excess), "µm"),
                    sign="larger" if excess > 0 else "smaller",
                    diameter=quantity(arm.tip.diameter_mm + 2 * excess, "mm", 4),
                )
            )
    return warnings
