"""The robust fit: identifies outliers, estimates the scatter beyond the encoders, then least
squares."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from app.errors import OperationError
from app.messages.message import message, quantity
from app.metrology.arm.identification.least_squares import (
    LEAST_SCATTER_MM,
    Indices,
    Unknowns,
    initial_unknowns,
    mahalanobis,
    predict_tips,
    reduce_system,
    residuals,
    settle_centres,
    step,
)
from app.metrology.arm.identification.observations import StackedObservations
from app.metrology.arm.identification.parameter_selection import (
    Candidates,
    FixedReason,
    parameter_limits,
    select_parameters,
    system_covariance,
)
from app.metrology.arm.kinematics import Arm
from app.metrology.transforms import Floats

HUBER = 2.0
ROBUST_STEPS, STEPS = 12, 30
SMALL_STEP = 1e-4
"""The iteration ends at a step this small relative to the standard deviations."""
# One in a million good points lies beyond: in one direction, and in space.
SPHERE_SIGMAS, SEAT_SIGMAS = 4.9, 5.5
OUTLIER_ROUNDS = 20
BACK_AGAIN = 0.9
"""An excluded point returns within this share of the limit, so that no point alternates."""


@dataclass(frozen=True)
class ArmFit:
    """A solution and its statistics."""

    at: Unknowns
    moved: Indices
    fixed: dict[int, FixedReason]
    covariance: Floats
    """(p, p) covariance of the moved parameters, mm and rad, k = 1."""
    others_covariance: Floats
    """(o, o) covariance of the spheres' radius excess (if there are spheres) and the bars'
    errors."""
    scatter_mm: float
    """Scatter of the points per coordinate, beyond what the encoders explain."""
    inliers: NDArray[np.bool_]
    """(N,) points that are no outliers."""


def fit_arm(
    arm: Arm, data: StackedObservations, choice: Candidates, moving: Indices | None = None
) -> ArmFit:
    """The best arm for the points.

    Args:
        choice: the parameters that may move.
        moving: the parameters to move, if decided before.

    Raises:
        OperationError: too few points for the parameters, or a fit that diverges.
    """
    at, scatter = initial_unknowns(arm, data), LEAST_SCATTER_MM
    everything = np.ones(len(data.q_rad))
    at = settle_centres(data, at, everything, 0.1)
    columns = _first_choice(data, at, choice) if moving is None else moving
    at, scatter = _robust(data, at, columns)
    kept = residuals(data, at, scatter).whitened < _limits(data, everything > 0)
    kept = _enough_left(data, kept)
    held: dict[int, FixedReason] = {}
    for _ in range(2):
        if moving is None:
            system = reduce_system(data, at, choice.order, kept.astype(float), scatter)
            worth = parameter_limits(arm, choice.order)
            columns, held = select_parameters(system.rows, system.others, choice.order, worth)
            columns = np.sort(columns)
        at, scatter, kept = _without_outliers(data, at, columns, kept, scatter)
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
    )


def descend(
    data: StackedObservations, at: Unknowns, columns: Indices, weights: Floats, scatter_mm: float
) -> Unknowns:
    """Gauss-Newton to convergence, with fixed weights; ``OperationError`` if it does not
    converge."""
    start_of_search = at
    for _ in range(STEPS):
        system = reduce_system(data, at, columns, weights, scatter_mm)
        at, size = step(data, at, columns, system)
        if not np.isfinite(size) or float(np.max(np.abs(at.centres_mm))) > 1e6:
            break
        if size < SMALL_STEP:
            return at
    off = residuals(data, start_of_search, scatter_mm).distances_mm
    rms = [float(np.sqrt(np.mean(off[place.rows] ** 2))) for place in data.places]
    worst = int(np.argmax(rms))
    raise OperationError(
        "identification-diverges",
        message(
            "no-arm-near-given-one-explains",
            label=data.places[worst].label,
            rms=quantity(rms[worst], "mm", 1),
        ),
        message("fit-does-settle"),
        message("check-arm-json-against-arm-signs"),
    )


def _first_choice(data: StackedObservations, at: Unknowns, choice: Candidates) -> Indices:
    """The parameters to move before the scatter is known: as if the encoders were almost the only
    noise."""
    everything = np.ones(len(data.q_rad))
    system = reduce_system(data, at, choice.order, everything, 0.02)
    columns, _ = select_parameters(
        system.rows, system.others, choice.order, parameter_limits(at.arm, choice.order)
    )
    return columns


def _robust(data: StackedObservations, at: Unknowns, columns: Indices) -> tuple[Unknowns, float]:
    """Huber's M-estimate with the scatter estimated on the way, so that outliers do not
    dominate."""
    scatter = LEAST_SCATTER_MM
    for _ in range(ROBUST_STEPS):
        scatter = _median_scatter(data, at)
        off = residuals(data, at, scatter).whitened
        weights = np.minimum(1.0, HUBER / np.maximum(off, 1e-9))
        system = reduce_system(data, at, columns, weights, scatter)
        at, size = step(data, at, columns, system)
        if not np.isfinite(size) or size < 0.1:
            break
    return at, _median_scatter(data, at)


def _median_scatter(data: StackedObservations, at: Unknowns) -> float:
    """Scatter per coordinate beyond the encoders for which the median point has the expected
    distance."""
    found = residuals(data, at, LEAST_SCATTER_MM)
    by_encoders = np.trace(predict_tips(data, at).covariances, axis1=1, axis2=2) / 3
    # medians of the chi distributions with one and three degrees of freedom
    typical = np.where(data.on_sphere, 0.6745, 1.5382)
    scale = float(np.median(found.distances_mm / typical))
    return float(np.sqrt(max(scale**2 - float(np.median(by_encoders)), LEAST_SCATTER_MM**2)))


def _without_outliers(
    data: StackedObservations,
    at: Unknowns,
    columns: Indices,
    kept: NDArray[np.bool_],
    scatter: float,
) -> tuple[Unknowns, float, NDArray[np.bool_]]:
    """Least squares on the points that agree.

    The worst point of each place is excluded in turn; an excluded point that agrees returns.
    """
    for _ in range(OUTLIER_ROUNDS):
        for _ in range(3):
            at = descend(data, at, columns, kept.astype(float), scatter)
            found = _scatter(data, at, columns, kept)
            done = abs(found - scatter) < 0.02 * scatter
            scatter = found
            if done:
                break
        off = residuals(data, at, scatter).whitened / _limits(data, kept)
        chosen = kept | (off < BACK_AGAIN)
        for number in range(len(data.places)):
            own = np.flatnonzero(kept & (data.place_of == number))
            if len(own) and off[worst := own[np.argmax(off[own])]] > 1.0:
                chosen[worst] = False
        chosen = _enough_left(data, chosen)
        if np.array_equal(chosen, kept):
            break
        kept = chosen
    return at, scatter, kept


def _limits(data: StackedObservations, kept: NDArray[np.bool_]) -> Floats:
    """(N,) Mahalanobis distance beyond which a point is an outlier.

    A point pulls the centre of its own place, more so if there are few points; an excluded point
    does not, and lies further off.
    """
    counts = np.bincount(data.place_of[kept], minlength=len(data.places))[data.place_of]
    share = np.where(data.on_sphere, 4.0, 1.0) / np.maximum(counts, 1)
    spare = np.sqrt(np.where(kept, np.maximum(1 - share, 0.1), 1 + share))
    return np.asarray(np.where(data.on_sphere, SPHERE_SIGMAS, SEAT_SIGMAS) * spare)


def _enough_left(data: StackedObservations, kept: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """No place is left without points: if it would be, all of its points count again."""
    counts = np.bincount(data.place_of[kept], minlength=len(data.places))
    return np.asarray(kept | (counts[data.place_of] == 0))


def _freedom(data: StackedObservations, kept: NDArray[np.bool_], unknowns: int) -> int:
    """Degrees of freedom of the points."""
    rows = int(np.sum(np.where(data.on_sphere[kept], 1, 3)))
    bars = sum(group.bar is not None for group in data.groups)
    return rows + bars + len(data.bar_names) - 3 * len(data.places) - unknowns


def _scatter(
    data: StackedObservations, at: Unknowns, columns: Indices, kept: NDArray[np.bool_]
) -> float:
    """The scatter beyond the encoders for which the chi-squared of the points is as expected."""
    freedom = _freedom(data, kept, len(columns) + 1)
    if freedom < 1:
        raise OperationError(
            "too-few-points",
            message("points-places", points=int(kept.sum()), places=len(data.places)),
            message("they-leave-nothing-over-check-parameters", columns=len(columns)),
            message("take-more-points-more-places"),
        )

    from scipy.optimize import brentq  # slow to import, and seldom needed

    sight = predict_tips(data, at)

    def excess(scatter_mm: float) -> float:
        return float(np.sum(mahalanobis(data, at, sight, scatter_mm)[kept] ** 2)) - freedom

    if excess(LEAST_SCATTER_MM) <= 0:
        return LEAST_SCATTER_MM
    largest = LEAST_SCATTER_MM
    while excess(largest) > 0:
        largest *= 10
    return float(brentq(excess, LEAST_SCATTER_MM, largest, rtol=1e-3))
