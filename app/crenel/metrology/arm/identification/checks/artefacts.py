"""Checks of the stated sizes of spheres, bars and the tip."""

from dataclasses import dataclass, replace

import numpy as np

from crenel.errors import OperationError
from crenel.messages.message import Text, message, quantity, rounded, signed
from crenel.metrology.arm.identification.cross_validation import deviations_held_out, without_points
from crenel.metrology.arm.identification.least_squares import CONSTRAINT_MM, reduce_system
from crenel.metrology.arm.identification.observations import (
    ArmObservations,
    ProbedPlace,
    StackedObservations,
)
from crenel.metrology.arm.identification.parameter_selection import (
    LENGTH_MM,
    candidates_of,
    parameter_limits,
    system_covariance,
)
from crenel.metrology.arm.identification.parameters import (
    parameter_values,
    tip_index,
)
from crenel.metrology.arm.identification.robust_solve import ArmFit, fit_arm
from crenel.metrology.arm.identification.scatter import Scatter, deviation_limit
from crenel.metrology.arm.identification.volumetric_error import size_uncertainty_mm
from crenel.metrology.arm.kinematics import Arm, tip_centres
from crenel.metrology.robust import median, sigma_from_median
from crenel.metrology.transforms import Floats

LEAST_TO_SIZE, SPHERE_STEPS, OUTLIER_SDS = 8, 20, 5.0
"""Number of points that determine a sphere's size; points off by more than this number of sd are
outliers."""
FREE_TIP_MM = 1e3
"""Uncertainty that leaves the place of the tip free."""
CONTRADICTION = 2.0
EXPLAINED_MM = 0.02
"""Deviation of a bar that its temperature explains."""
STANDS_OUT = 3.0
CERTAIN = 6.0
"""Twice the logarithm of the odds, 20 to 1, by which one bar rather than another is wrong."""
HARDLY_KNOWN = 5e-4
"""Standard uncertainty of a bar, over its length, that no calibration states."""
EXCESS_SIGMAS, EXCESS_MM, WRONG_TIP_MM = 5.0, 0.005, 0.025


def check_spheres(data: StackedObservations, fit: ArmFit) -> list[Text]:
    """Warns of a sphere whose measured size differs from the others; refuses one far off.

    Each sphere is measured by its own points and the fitted arm, regardless of what the fit
    excluded.
    """
    excesses = _sphere_excesses(data, fit)
    if len(excesses) < 2:
        return []
    excess, sd, freedom = np.array([own[1:] for own in excesses]).T
    weights = 1 / sd**2
    rest = weights.sum() - weights
    off = excess - (np.sum(weights * excess) - weights * excess) / rest
    off_sd = np.sqrt(sd**2 + 1 / rest)
    # of several, the one with the most significant difference; of two, neither can be named
    worst = int(np.argmax(np.abs(off) / off_sd))
    sigmas = max(EXCESS_SIGMAS, deviation_limit(len(off), float(freedom.min())))
    if abs(off[worst]) <= max(sigmas * off_sd[worst], EXCESS_MM):
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
            message("one-diameter-wrong-or-sphere-not-clean"),
            message("check-diameter-mm-spheres-take-sphere"),
        )
    return [message("check-diameter", finding=finding)]


def _sphere_excesses(
    data: StackedObservations, fit: ArmFit
) -> list[tuple[ProbedPlace, float, float, int]]:
    """For each sphere with enough points: radius excess and its standard deviation, mm, and the
    degrees of freedom of both."""
    tips = tip_centres(fit.at.arm, data.q_rad)
    found: list[tuple[ProbedPlace, float, float, int]] = []
    for number, place in enumerate(data.places):
        if place.diameter_mm is None or place.rows.stop - place.rows.start < LEAST_TO_SIZE:
            continue
        expected = place.diameter_mm / 2 + fit.at.arm.tip.radius_mm
        own = _fit_sphere_radius(tips[place.rows], fit.at.centres_mm[number], expected)
        if own is not None:
            found.append((place, own[0] - expected, *own[1:]))
    return found


def _fit_sphere_radius(
    points: Floats, centre: Floats, radius_mm: float
) -> tuple[float, float, int] | None:
    """Radius of the points (m, 3), without outliers, its standard deviation, and the degrees of
    freedom of this."""
    at = np.append(centre, radius_mm)
    kept = np.ones(len(points), bool)
    sd, J = 0.0, np.ones((len(points), 4))
    for _ in range(SPHERE_STEPS):
        away = points - at[:3]
        far = np.linalg.norm(away, axis=1)
        off = far - at[3]
        J = np.column_stack([away / far[:, None], np.ones(len(points))])
        at = at + np.linalg.lstsq(J[kept], off[kept], rcond=None)[0]
        left = np.abs(off - median(off))
        sd = max(sigma_from_median(left), 1e-6)
        kept = left < OUTLIER_SDS * sd
        if kept.sum() < LEAST_TO_SIZE:
            return None
    spare = int(kept.sum()) - 4
    off = np.linalg.norm(points - at[:3], axis=1) - at[3]
    sd = float(np.sqrt(np.sum(off[kept] ** 2) / spare))
    shape = np.linalg.pinv(J[kept].T @ J[kept])
    return float(at[3]), max(sd, 1e-6) * float(np.sqrt(shape[3, 3])), spare


@dataclass(frozen=True)
class BarJudgement:
    """How far each artefact's length is from its certificate, by everything else that was
    measured."""

    names: tuple[str, ...]
    deviations_mm: Floats
    """(B,) measured minus certified length."""
    significance: Floats
    """(B,) the same in standard deviations, which include those of certificate and datasheet."""
    limit: float
    """Significance that no sound bar of a session has."""

    @property
    def worst(self) -> int:
        return int(np.argmax(np.abs(self.significance)))

    @property
    def accuses(self) -> bool:
        """Whether a length is wrong beyond doubt, and by more than temperature explains."""
        return (
            abs(float(self.significance[self.worst])) > self.limit
            and abs(float(self.deviations_mm[self.worst])) > EXPLAINED_MM
        )

    @property
    def named(self) -> tuple[str, ...]:
        """The bar that explains the contradiction, or all bars that do so almost as well."""
        squares = self.significance**2
        equal = squares > squares.max() - CERTAIN
        return tuple(name for name, one in zip(self.names, equal, strict=True) if one)


def check_bars(arm: Arm, observations: ArmObservations, fit: ArmFit) -> list[Text]:
    """Warns of bars whose measured length differs; refuses lengths that contradict the other data.

    The comparison is a fit in which the length of every bar is free. Where this leaves too little
    redundancy, no bar is judged.
    """
    if not observations.bars:
        return []
    free = replace(
        observations,
        bars=tuple(replace(bar, standard_uncertainty_mm=np.inf) for bar in observations.bars),
    )
    choice = candidates_of(arm, replace(observations, bars=()))
    try:
        loose = fit_arm(arm, free.stacked, choice)
    except OperationError:  # without the lengths, too little data is left to contradict them
        return []
    judged = judge_bars(arm, observations, free.stacked, loose)
    if not judged.accuses or not _stands_out(arm, observations, fit, judged):
        return []
    finding = _bar_finding(observations, judged)
    contradicted = _contradiction_of_lengths(free.stacked, fit, loose, ", ".join(judged.named))
    if contradicted is None:
        return [message("check-length-unless-datasheet-is-as-far-off", finding=finding)]
    evidence, remedy = contradicted
    raise OperationError("bar-length", finding, evidence, remedy)


def _contradiction_of_lengths(
    data: StackedObservations, fit: ArmFit, loose: ArmFit, bars: str
) -> tuple[Text, Text] | None:
    """What the stated lengths do to the other data, and what to check; None if they bear them.

    Args:
        loose: the fit in which the lengths are free.
    """
    remedy = message("check-length-mm-bar-ends", bar=bars)
    if fit.scatter.touch_mm > CONTRADICTION * max(loose.scatter.touch_mm, 2e-3):
        evidence = message(
            "bars-lengths-points-scatter-without-them",
            scatter=quantity(1e3 * fit.scatter.touch_mm, "µm"),
            without=quantity(1e3 * loose.scatter.touch_mm, "µm"),
        )
        return evidence, remedy
    with_bars_mm = _coordinate_scatter_mm(data, fit.scatter)
    without_mm = _coordinate_scatter_mm(data, loose.scatter)
    if with_bars_mm > CONTRADICTION * without_mm:
        evidence = message(
            "bars-lengths-coordinates-scatter-without-them",
            scatter=quantity(1e3 * with_bars_mm, "µm"),
            without=quantity(1e3 * without_mm, "µm"),
        )
        return evidence, message("check-length-of-bar-and-coordinates", bar=bars)
    if _spheres_contradict_bars(loose, fit):
        evidence = message(
            "spheres-size-by-certificate-or-datasheet",
            excess=quantity(2e3 * abs(fit.at.radius_excess_mm), "µm"),
            sign="larger" if fit.at.radius_excess_mm > 0 else "smaller",
        )
        return evidence, remedy
    return None


def _coordinate_scatter_mm(data: StackedObservations, scatter: Scatter) -> float:
    """Standard deviation of the coordinates along each axis, as stated and beyond; 0 for none."""
    stated_mm = data.coordinates.standard_uncertainty_mm
    return float(np.hypot(scatter.point_mm, median(stated_mm))) if len(stated_mm) else 0.0


def _stands_out(arm: Arm, observations: ArmObservations, fit: ArmFit, judged: BarJudgement) -> bool:
    """Whether the worst bar deviates by more than what the other places do when held out.

    On few places the fit follows them and underestimates the errors of the arm.
    """
    good = without_points(observations, fit.inliers)
    others = replace(good, bars=tuple(bar for bar in good.bars if bar.name not in judged.named))
    usual_mm = deviations_held_out(arm, others, fit.scatter).largest_mm
    deviation_mm = abs(float(judged.deviations_mm[judged.worst]))
    return usual_mm is not None and deviation_mm > STANDS_OUT * usual_mm


def judge_bars(
    arm: Arm, observations: ArmObservations, free: StackedObservations, loose: ArmFit
) -> BarJudgement:
    """Each bar's length as all other bars, the other points and the datasheet predict it.

    Touches of one end share the error that the arm has in that posture: they count once.

    Args:
        free: the observations with bars of unknown length.
        loose: their fit.
    """
    order = candidates_of(arm, observations).order
    counts = np.bincount(free.place_of)[free.place_of]
    at_bars = np.isin(
        free.place_of, [i for g in free.groups if g.bar is not None for i in g.places]
    )
    weights = loose.inliers.astype(float)
    weights[: free.touches] /= np.where(at_bars, counts, 1)
    system = reduce_system(free, loose.at, order, weights, loose.scatter)
    by_datasheet = parameter_limits(arm, order, loose.error_scale)
    by_datasheet[order >= tip_index(arm)] = FREE_TIP_MM
    prior = np.zeros((len(order), system.rows.shape[1]))
    prior[:, system.others :] = np.diag(1 / by_datasheet)
    off = (parameter_values(arm) - parameter_values(loose.at.arm))[order] / by_datasheet
    rows = np.concatenate([system.rows, prior])
    change = np.linalg.lstsq(rows, np.concatenate([system.right, off]), rcond=None)[0]
    own = free.others.bars
    errors_mm = loose.at.bar_errors_mm + change[own]
    stated = {bar.name: bar.standard_uncertainty_mm for bar in observations.bars}
    certified = np.diag([max(stated[name], CONSTRAINT_MM) ** 2 for name in free.bar_names])
    weight = np.linalg.inv(system_covariance(rows)[own, own] + certified)
    own_weight = np.diag(weight)
    return BarJudgement(
        free.bar_names,
        weight @ errors_mm / own_weight,
        weight @ errors_mm / np.sqrt(own_weight),
        deviation_limit(len(errors_mm), loose.freedom),
    )


def _bar_finding(observations: ArmObservations, judged: BarJudgement) -> Text:
    if len(judged.named) > 1:
        return message(
            "lengths-of-bars-contradict",
            bars=", ".join(judged.named),
            off=quantity(1e3 * abs(float(judged.deviations_mm[judged.worst])), "µm"),
        )
    name = judged.names[judged.worst]
    given = next(bar.length_mm for bar in observations.bars if bar.name == name)
    return message(
        "arm-sees-bar-given",
        bar=name,
        measured=quantity(given + float(judged.deviations_mm[judged.worst]), "mm", 3),
        given=quantity(given, "mm", 3),
    )


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
    if not observations.knows_lengths:
        size_um = 1e3 * size_uncertainty_mm(arm)
        warnings.append(
            message(
                "no-ball-bar-measured-arms-size",
                error=rounded(LENGTH_MM, "mm"),
                size=quantity(size_um, "µm"),
            )
        )
    for bar in {bar.name: bar for bar in observations.bars}.values():
        if bar.standard_uncertainty_mm > HARDLY_KNOWN * bar.length_mm:
            sd_mm = rounded(bar.standard_uncertainty_mm, "mm")
            warnings.append(message("bars-length-hardly-known", bar=bar.name, uncertainty=sd_mm))
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
