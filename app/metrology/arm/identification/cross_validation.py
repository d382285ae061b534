"""Tests whether the identified arm is better on data outside the fit: held-out points, before and
after."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from app.metrology.arm.identification.least_squares import (
    Unknowns,
    initial_unknowns,
    mahalanobis,
    predict_tips,
    residuals,
    settle_centres,
)
from app.metrology.arm.identification.observations import (
    ArmObservations,
    Bar,
    Seat,
    Sphere,
    StackedObservations,
)
from app.metrology.arm.identification.parameter_selection import candidates
from app.metrology.arm.identification.robust_solve import fit_arm
from app.metrology.arm.kinematics import Arm
from app.metrology.transforms import Floats

FOLDS = 5


@dataclass(frozen=True)
class Deviations:
    """How far measured places disagree with an arm; None for kinds of places that were not
    measured."""

    seats_um: float | None
    """Rms distance of the tips from the centre of their seat, including ends of bars."""
    spheres_um: float | None
    """Rms distance of the tips from their sphere."""
    lengths_um: float | None
    """Rms error of the bar lengths."""
    normalised: float
    """Rms of all deviations relative to their standard deviations: 1 if the noise explains
    everything."""


@dataclass(frozen=True)
class Validation:
    """Deviations at places outside the fit."""

    before: Deviations
    after: Deviations
    places: int
    """Seats, spheres and bar positions that were held out, in folds or as a separate set."""
    separate: bool
    """True if the places are a separate set, False if each fold was held out in turn."""

    @property
    def ratio(self) -> float:
        """The factor by which the deviations, in standard deviations, were reduced."""
        return self.before.normalised / max(self.after.normalised, 1e-12)


@dataclass(frozen=True)
class _DeviationSquares:
    """Sums of squared deviations, to be pooled over folds."""

    seats: Floats
    spheres: Floats
    lengths: Floats
    normalised: Floats


def cross_validate(arm: Arm, observations: ArmObservations, scatter_mm: float) -> Validation:
    """Holds out every k-th place in turn and repeats the fit on the remaining places.

    Raises:
        OperationError: the remaining places of a fold are too few to identify the arm.
    """
    count = observations.groups_count
    folds = min(FOLDS, count)
    before: list[_DeviationSquares] = []
    after: list[_DeviationSquares] = []
    for fold in range(folds):
        out = [i for i in range(count) if i % folds == fold]
        rest = observations.part([i for i in range(count) if i % folds != fold])
        fit = fit_arm(arm, rest.stacked, candidates(arm, bool(rest.bars)))
        held_out = observations.part(out).stacked
        before.append(_deviation_squares(arm, 0.0, held_out, scatter_mm))
        after.append(_deviation_squares(fit.at.arm, fit.at.radius_excess_mm, held_out, scatter_mm))
    return Validation(_pool_deviations(before), _pool_deviations(after), count, False)


def compare_arms(
    before: Arm, after: Arm, radius_excess_mm: float, check: ArmObservations, scatter_mm: float
) -> Validation:
    """Both arms on a separate set of places."""
    data = check.stacked
    return Validation(
        _pool_deviations([_deviation_squares(before, 0.0, data, scatter_mm)]),
        _pool_deviations([_deviation_squares(after, radius_excess_mm, data, scatter_mm)]),
        check.groups_count,
        True,
    )


def without_points(observations: ArmObservations, kept: NDArray[np.bool_]) -> ArmObservations:
    """The observations with only the points of a mask (N,) over ``stacked``."""
    at = 0

    def own(q_rad: Floats) -> Floats:
        nonlocal at
        at += len(q_rad)
        return np.asarray(q_rad[kept[at - len(q_rad) : at]])

    seats = tuple(Seat(seat.name, own(seat.q_rad)) for seat in observations.seats)
    spheres = tuple(
        Sphere(sphere.name, sphere.diameter_mm, own(sphere.q_rad))
        for sphere in observations.spheres
    )
    bars = tuple(
        Bar(
            bar.name,
            bar.position,
            bar.length_mm,
            bar.standard_uncertainty_mm,
            bar.ends,
            (own(bar.q_rad[0]), own(bar.q_rad[1])),
        )
        for bar in observations.bars
    )
    return ArmObservations(seats, spheres, bars)


def fit_centres(
    arm: Arm, data: StackedObservations, radius_excess_mm: float, scatter_mm: float
) -> Unknowns:
    """The places as an arm measures them, by their own points alone."""
    at = initial_unknowns(arm, data)
    at = Unknowns(arm, at.centres_mm, radius_excess_mm, at.bar_errors_mm)
    return settle_centres(data, at, np.ones(len(data.q_rad)), scatter_mm)


def _deviation_squares(
    arm: Arm, radius_excess_mm: float, data: StackedObservations, scatter_mm: float
) -> _DeviationSquares:
    at = fit_centres(arm, data, radius_excess_mm, scatter_mm)
    sight = predict_tips(data, at)
    counts = np.bincount(data.place_of)[data.place_of]
    # the centre of a place uses up three of its coordinates
    spare = np.where(data.on_sphere, 1 - 3.0 / counts, 1 - 1.0 / counts)
    has_spare = spare > 1e-9
    found = residuals(data, at, scatter_mm)
    squares = found.distances_mm**2
    normalised = mahalanobis(data, at, sight, scatter_mm) ** 2
    normalised /= np.where(data.on_sphere, 1.0, 3.0)
    sds = _length_sds(data, sight.covariances, scatter_mm)
    scale = np.where(has_spare, 1 / np.where(has_spare, spare, 1.0), 0.0)
    return _DeviationSquares(
        (squares * scale)[has_spare & ~data.on_sphere],
        (squares * scale)[has_spare & data.on_sphere],
        found.bars_mm**2,
        np.concatenate([(normalised * scale)[has_spare], (found.bars_mm / sds) ** 2]),
    )


def _length_sds(data: StackedObservations, covariances: Floats, scatter_mm: float) -> Floats:
    """(G,) standard deviation of the measured length of each bar position."""
    by_point = np.trace(covariances, axis1=1, axis2=2) / 3 + scatter_mm**2
    sds: list[float] = []
    for group in data.groups:
        if group.bar is None:
            continue
        variance = data.bars[group.bar].standard_uncertainty_mm ** 2
        for number in group.places:
            own = by_point[data.places[number].rows]
            variance += float(np.mean(own)) / len(own)
        sds.append(float(np.sqrt(variance)))
    return np.array(sds)


def _pool_deviations(parts: Sequence[_DeviationSquares]) -> Deviations:
    def rms_um(name: str) -> float | None:
        squares = np.concatenate([getattr(part, name) for part in parts])
        return 1e3 * float(np.sqrt(np.mean(squares))) if len(squares) else None

    normalised = np.concatenate([part.normalised for part in parts])
    return Deviations(
        rms_um("seats"),
        rms_um("spheres"),
        rms_um("lengths"),
        float(np.sqrt(np.mean(normalised))) if len(normalised) else 0.0,
    )
