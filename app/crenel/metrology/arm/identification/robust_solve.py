"""The robust fit: identifies outliers, estimates the scatter beyond the encoders, then least
squares."""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from crenel.errors import OperationError
from crenel.messages.message import Text, message, quantity
from crenel.metrology.arm.identification.coordinate_rows import (
    coordinate_rows,
)
from crenel.metrology.arm.identification.initial_unknowns import initial_unknowns
from crenel.metrology.arm.identification.least_squares import (
    ReducedSystem,
    group_disagreements,
    reduce_system,
    residuals,
    settle_centres,
    step,
)
from crenel.metrology.arm.identification.observations import TIP, StackedObservations
from crenel.metrology.arm.identification.parameter_selection import (
    Candidates,
    FixedReason,
    error_scale,
    parameter_limits,
    select_parameters,
    system_covariance,
)
from crenel.metrology.arm.identification.parameters import (
    Indices,
    parameter_values,
    tip_index,
    with_parameters,
)
from crenel.metrology.arm.identification.scatter import GOOD_POINTS, Scatter, distance_limit
from crenel.metrology.arm.identification.scatter_estimates import (
    match_scatter,
    median_scatter,
    redundancies,
    require_redundancy,
)
from crenel.metrology.arm.identification.unknowns import Unknowns
from crenel.metrology.arm.kinematics import Arm
from crenel.metrology.fitting.outlier_search import Outliers, find_outlier_points
from crenel.metrology.robust import huber_weights
from crenel.metrology.transforms import Floats

HUBER = 2.0
ROBUST_STEPS, STEPS = 12, 30
SMALL_STEP = 1e-4
"""The iteration ends at a step this small relative to the standard deviations."""
OUTLIER_ROUNDS = 20
ROUGH = Scatter(0.1, 0.1, 1e-3)
NEARLY_NOTHING = Scatter(0.02, 0.02, 1e-4)
SCATTER_STEPS = 12
"""Fits until the scatter is found."""
WORTH = 2.0
"""A parameter moves up to this uncertainty, in errors that it has by the datasheet: those of
correlated parameters compensate each other."""
MANY = 1e6
"""Degrees of freedom while it is not known how many there are."""
BACK_AGAIN = 0.9
"""An excluded point returns within this share of the limit, so that no point alternates."""


@dataclass(frozen=True)
class ArmFit:
    """A solution and its statistics. Parameters that are not among the moved ones have exactly the
    values of the given arm."""

    at: Unknowns
    moved: Indices
    fixed: dict[int, FixedReason]
    covariance: Floats
    """(p, p) covariance of the moved parameters, mm and rad, k = 1."""
    others_covariance: Floats
    """(o, o) covariance of the other unknowns, as ``data.others`` arranges them."""
    scatter: Scatter
    """Beyond what the encoders and the stated uncertainties explain."""
    inliers: NDArray[np.bool_]
    """(N + M,) points that are no outliers."""
    doubtful: tuple[tuple[int, ...], ...]
    """Touches of a seat, sphere or bar of which at least one is off while nothing tells which; they
    are used."""
    freedom: float
    """Degrees of freedom of all points."""
    error_scale: float
    """How much larger the errors of this arm are than those of a typical one."""


def fit_arm(
    arm: Arm, data: StackedObservations, choice: Candidates, moving: Indices | None = None
) -> ArmFit:
    """The best arm for the points.

    A robust fit of all parameters that good points could determine gives the scatter, and how far
    off the given arm is. By both it is decided which parameters move; the others return to their
    values before the final fit.

    Args:
        choice: the parameters that may move.
        moving: the parameters to move, if decided before.

    Raises:
        OperationError: too few points for the parameters, or a fit that diverges.
    """
    everything = np.ones(data.points)
    at = settle_centres(data, initial_unknowns(arm, data), everything, ROUGH)
    at = settle_frames(data, at)
    columns = _first_choice(data, at, choice) if moving is None else moving
    at, scatter = _robust(data, at, columns)
    kept = _enough_left(data, _agreeing(data, at, columns, scatter))
    held: dict[int, FixedReason] = {}
    scale = 1.0
    for _ in range(2):
        if moving is None:
            scale = _error_scale(arm, data, at, columns, kept, scatter)
            columns, held = _choose(data, at, choice, kept, scatter, scale)
            at = _at_given_values(arm, at, columns)
        at, scatter, kept, doubtful = _without_outliers(data, at, columns, kept, scatter)
    system = reduce_system(data, at, columns, kept.astype(float), scatter)
    covariance, others = system_covariance(system.rows), system.others
    return ArmFit(
        at,
        columns,
        {**choice.fixed, **held},
        covariance[others:, others:],
        covariance[:others, :others],
        scatter,
        kept,
        doubtful,
        float(np.sum(redundancies(data, kept, system))),
        scale,
    )


def _choose(
    data: StackedObservations,
    at: Unknowns,
    choice: Candidates,
    kept: NDArray[np.bool_],
    scatter: Scatter,
    scale: float,
) -> tuple[Indices, dict[int, FixedReason]]:
    """The parameters that move, in the order of the vector, and why the others do not."""
    system = reduce_system(data, at, choice.order, kept.astype(float), scatter)
    limits = parameter_limits(at.arm, choice.order, WORTH * scale)
    columns, held = select_parameters(system.rows, system.others, choice.order, limits)
    return np.sort(columns), held


def _error_scale(
    arm: Arm,
    data: StackedObservations,
    at: Unknowns,
    columns: Indices,
    kept: NDArray[np.bool_],
    scatter: Scatter,
) -> float:
    """By how much the links have moved; the tip may be another one."""
    system = reduce_system(data, at, columns, kept.astype(float), scatter)
    links = columns < tip_index(arm)
    own = np.flatnonzero(links) + system.others
    covariance = system_covariance(system.rows)[np.ix_(own, own)]
    moved = columns[links]
    changes = (parameter_values(at.arm) - parameter_values(arm))[moved]
    return error_scale(changes, covariance, parameter_limits(arm, moved))


def _at_given_values(arm: Arm, at: Unknowns, columns: Indices) -> Unknowns:
    """The unknowns with all parameters but these at the values of the given arm."""
    values = parameter_values(arm)
    values[columns] = parameter_values(at.arm)[columns]
    return replace(at, arm=with_parameters(arm, values))


def descend(
    data: StackedObservations, at: Unknowns, columns: Indices, weights: Floats, scatter: Scatter
) -> Unknowns:
    """Gauss-Newton to convergence, with fixed weights; ``OperationError`` if it does not
    converge."""
    start_of_search = at
    for _ in range(STEPS):
        system = reduce_system(data, at, columns, weights, scatter)
        at, size = step(data, at, columns, system)
        if not np.isfinite(size) or float(np.max(np.abs(at.centres_mm), initial=0.0)) > 1e6:
            break
        if size < SMALL_STEP:
            return at
    label, rms_mm = _worst_place(data, residuals(data, start_of_search, scatter).distances_mm)
    raise OperationError(
        "identification-diverges",
        message("no-arm-near-given-one-explains", label=label, rms=quantity(rms_mm, "mm", 1)),
        message("fit-does-not-converge"),
        message("check-arm-json-against-arm-signs"),
    )


def _worst_place(data: StackedObservations, off_mm: Floats) -> tuple[Text, float]:
    """The place or frame whose points deviate most, and their rms."""
    rms_mm: list[tuple[float, Text]] = [
        (float(np.sqrt(np.mean(off_mm[place.rows] ** 2))), place.label) for place in data.places
    ]
    measured = off_mm[data.touches :]
    for i, name in enumerate(data.coordinates.frames):
        own = measured[data.coordinates.frame_of == i]
        rms_mm.append((float(np.sqrt(np.mean(own**2))), message("frame-named", name=name)))
    worst, label = max(rms_mm, key=lambda one: one[0])
    return label, worst


def settle_frames(data: StackedObservations, at: Unknowns) -> Unknowns:
    """The best frames and markers for the given arm; of the arm, only the tip moves."""
    if not len(data.coordinates.q_rad):
        return at
    tip = tip_index(at.arm) + np.arange(3)
    seen = any(one.name == TIP for one in data.coordinates.markers) and not data.touches
    return _robust(data, at, tip if seen else tip[:0])[0]


def _first_choice(data: StackedObservations, at: Unknowns, choice: Candidates) -> Indices:
    """The parameters to move before the scatter is known: as if the encoders were almost the only
    noise."""
    everything = np.ones(data.points)
    return _choose(data, at, choice, everything > 0, NEARLY_NOTHING, 1.0)[0]


def _robust(data: StackedObservations, at: Unknowns, columns: Indices) -> tuple[Unknowns, Scatter]:
    """Huber's M-estimate with the scatter estimated on the way, so that outliers do not
    dominate."""
    for _ in range(ROBUST_STEPS):
        scatter = median_scatter(data, at, len(columns))
        off = residuals(data, at, scatter).whitened
        weights = huber_weights(off, HUBER)
        system = reduce_system(data, at, columns, weights, scatter)
        at, size = step(data, at, columns, system)
        if not np.isfinite(size) or size < 0.1:
            break
    return at, median_scatter(data, at, len(columns))


def _agreeing(
    data: StackedObservations, at: Unknowns, columns: Indices, scatter: Scatter
) -> NDArray[np.bool_]:
    """(N + M,) points that agree with a robust fit of all of them."""
    everything = np.ones(data.points)
    system = reduce_system(data, at, columns, everything, scatter)
    levers = _leverages(data, at, columns, system, scatter)
    freedoms = redundancies(data, everything > 0, system)
    freedoms[0] = MANY
    limits = _limits(data, everything > 0, levers, freedoms)
    return np.asarray(residuals(data, at, scatter).whitened < limits)


def _without_outliers(
    data: StackedObservations,
    at: Unknowns,
    columns: Indices,
    kept: NDArray[np.bool_],
    scatter: Scatter,
) -> tuple[Unknowns, Scatter, NDArray[np.bool_], tuple[tuple[int, ...], ...]]:
    """Least squares on the points that agree, and the touches in doubt, as of ``ArmFit``.

    Of each group the touches are excluded without which its others agree best, and every
    coordinate beyond the limit; an excluded point that agrees returns.
    """
    doubtful: tuple[tuple[int, ...], ...] = ()
    for _ in range(OUTLIER_ROUNDS):
        system = reduce_system(data, at, columns, kept.astype(float), scatter)
        freedoms = require_redundancy(data, kept, system)
        for _ in range(SCATTER_STEPS):
            at = descend(data, at, columns, kept.astype(float), scatter)
            found = match_scatter(data, at, kept, scatter, freedoms)
            done = found.is_close(scatter, 0.02)
            scatter = found
            if done:
                break
        levers = _leverages(data, at, columns, system, scatter)
        off = residuals(data, at, scatter).whitened / _limits(data, kept, levers, freedoms)
        chosen = kept | (off < BACK_AGAIN)
        judged = _judge_touches(data, at, columns, kept, scatter, freedoms[0])
        doubtful = tuple(group.doubtful for group in judged if group.doubtful)
        chosen[[i for group in judged for i in group.points]] = False
        chosen[data.touches :] &= off[data.touches :] <= 1.0
        chosen = _enough_left(data, chosen)
        if np.array_equal(chosen, kept):
            break
        kept = chosen
    return at, scatter, kept, doubtful


def _judge_touches(
    data: StackedObservations,
    at: Unknowns,
    columns: Indices,
    kept: NDArray[np.bool_],
    scatter: Scatter,
    freedom: float,
) -> list[Outliers]:
    """The touches that contradict the others of their seat, sphere or bar, or may do so.

    Args:
        freedom: degrees of freedom of the scatter of touches.
    """
    covariance = system_covariance(
        reduce_system(data, at, columns, kept.astype(float), scatter).rows
    )
    found: list[Outliers] = []
    for touches, one in group_disagreements(data, at, columns, kept, scatter, covariance):
        elsewhere = max(freedom - float(np.trace(one.information)), 0.0)
        judged = replace(one, elsewhere=elsewhere, alarms=GOOD_POINTS * one.count)
        outliers = find_outlier_points(judged)
        named, either = (touches[list(of)] for of in (outliers.points, outliers.doubtful))
        found.append(Outliers(tuple(named.tolist()), tuple(either.tolist())))
    return found


def _leverages(
    data: StackedObservations,
    at: Unknowns,
    columns: Indices,
    system: ReducedSystem,
    scatter: Scatter,
) -> Floats:
    """(M,) mean share of each coordinate's rows that the fit explains by them themselves."""
    if not len(data.coordinates.q_rad):
        return np.zeros(0)
    rows = coordinate_rows(data, at, columns, scatter)[:, :, :-1]
    covariance = system_covariance(system.rows)
    explained = np.einsum("nij,jk,nik->n", rows, covariance, rows)
    return np.asarray(explained / np.where(data.coordinates.has_rotation, 6.0, 3.0))


def _limits(
    data: StackedObservations, kept: NDArray[np.bool_], levers: Floats, freedoms: Floats
) -> Floats:
    """(N + M,) Mahalanobis distance beyond which a point is an outlier.

    A point pulls the centre of its own place, more so if there are few points; an excluded point
    does not, and lies further off.
    """
    touched = kept[: data.touches]
    counts = np.bincount(data.place_of[touched], minlength=len(data.places))[data.place_of]
    share = np.where(data.on_sphere, 4.0, 1.0) / np.maximum(counts, 1)
    share = np.concatenate([share, levers])
    spare = np.sqrt(np.where(kept, np.maximum(1 - share, 0.1), 1 + share))
    touches, coordinates = freedoms[0], freedoms[1]
    by_touch = np.where(data.on_sphere, distance_limit(1, touches), distance_limit(3, touches))
    by_coordinate = np.where(
        data.coordinates.has_rotation,
        distance_limit(6, coordinates),
        distance_limit(3, coordinates),
    )
    return np.asarray(np.concatenate([by_touch, by_coordinate]) * spare)


def _enough_left(data: StackedObservations, kept: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """No place is left without points: if it would be, all of its points count again."""
    counts = np.bincount(data.place_of[kept[: data.touches]], minlength=len(data.places))
    again = np.zeros(data.points, dtype=bool)
    again[: data.touches] = counts[data.place_of] == 0
    return np.asarray(kept | again)
