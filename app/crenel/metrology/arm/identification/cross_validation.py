"""Tests whether the identified arm is better on data outside the fit: held-out points, before and
after."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from crenel.errors import OperationError
from crenel.metrology.arm.identification.initial_unknowns import align_frames, initial_unknowns
from crenel.metrology.arm.identification.least_squares import (
    predict_tips,
    residuals,
    settle_centres,
)
from crenel.metrology.arm.identification.observations import (
    ArmObservations,
    Bar,
    Seat,
    Sphere,
    StackedObservations,
)
from crenel.metrology.arm.identification.parameter_selection import candidates_of
from crenel.metrology.arm.identification.robust_solve import ArmFit, fit_arm, settle_frames
from crenel.metrology.arm.identification.scatter import Scatter
from crenel.metrology.arm.identification.unknowns import Unknowns
from crenel.metrology.arm.kinematics import Arm
from crenel.metrology.transforms import Floats

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
    coordinates_um: float | None
    """Rms distance of markers from where another instrument measured them."""
    rotations_deg: float | None
    """Rms angle between measured and predicted rotations of markers."""
    normalised: float
    """Rms of all deviations relative to their standard deviations: 1 if the noise explains
    everything."""

    @property
    def largest_mm(self) -> float | None:
        """The largest of the lengths above."""
        found = (self.seats_um, self.spheres_um, self.lengths_um, self.coordinates_um)
        return max((um / 1e3 for um in found if um is not None), default=None)


@dataclass(frozen=True)
class Validation:
    """Deviations at places outside the fit."""

    before: Deviations
    after: Deviations
    places: int
    """Seats, spheres, bar positions and coordinates that were held out, in folds or as a separate
    set."""
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
    coordinates: Floats
    rotations: Floats
    normalised: Floats


def cross_validate(arm: Arm, observations: ArmObservations, scatter: Scatter) -> Validation:
    """Holds out every k-th place in turn and repeats the fit on the remaining places.

    Raises:
        OperationError: the remaining places of a fold are too few to identify the arm.
    """
    count = observations.places_count
    folds = min(FOLDS, count)
    before: list[_DeviationSquares] = []
    after: list[_DeviationSquares] = []
    for fold in range(folds):
        held_out = observations.part([i for i in range(count) if i % folds == fold]).stacked
        rest = observations.part([i for i in range(count) if i % folds != fold])
        fit = fit_arm(arm, rest.stacked, candidates_of(arm, rest))
        given = settle_frames(rest.stacked, initial_unknowns(arm, rest.stacked))
        before.append(_deviation_squares(given, rest.stacked, held_out, scatter))
        after.append(_deviation_squares(fit.at, rest.stacked, held_out, scatter))
    return Validation(_pool_deviations(before), _pool_deviations(after), count, False)


NOTHING_HELD_OUT = Deviations(None, None, None, None, None, 0.0)


def deviations_held_out(arm: Arm, observations: ArmObservations, scatter: Scatter) -> Deviations:
    """How far places deviate that a fit did not see; of too few of them nothing is known."""
    if observations.places_count < FOLDS:
        return NOTHING_HELD_OUT
    try:
        return cross_validate(arm, observations, scatter).after
    except OperationError:
        return NOTHING_HELD_OUT


def compare_arms(
    arm: Arm, fit: ArmFit, data: StackedObservations, check: ArmObservations
) -> Validation:
    """The given and the fitted arm on a separate set of places.

    Args:
        data: what the arm was fitted to.
    """
    held_out = check.stacked
    given = settle_frames(data, initial_unknowns(arm, data))
    return Validation(
        _pool_deviations([_deviation_squares(given, data, held_out, fit.scatter)]),
        _pool_deviations([_deviation_squares(fit.at, data, held_out, fit.scatter)]),
        check.places_count,
        True,
    )


def without_points(observations: ArmObservations, kept: NDArray[np.bool_]) -> ArmObservations:
    """The observations with only the points of a mask (N + M,) over ``stacked``."""
    at = 0

    def own_mask(count: int) -> NDArray[np.bool_]:
        nonlocal at
        at += count
        return kept[at - count : at]

    def own(q_rad: Floats) -> Floats:
        return np.asarray(q_rad[own_mask(len(q_rad))])

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
    coordinates = tuple(one.part(own_mask(len(one.q_rad))) for one in observations.coordinates)
    coordinates = tuple(one for one in coordinates if len(one.q_rad))
    return ArmObservations(seats, spheres, bars, coordinates)


def fit_places(
    known: Unknowns, fitted: StackedObservations, data: StackedObservations, scatter: Scatter
) -> Unknowns:
    """Other places as an arm measures them: each by its own points alone, in frames and with
    markers that are known from the fit.

    Args:
        known: the arm, and what was found of ``fitted``.
    """
    at = replace(
        initial_unknowns(known.arm, data),
        radius_excess_mm=known.radius_excess_mm,
    )
    offsets, rotations = at.offsets_mm.copy(), at.R_flange_markers.copy()
    names = [marker.name for marker in fitted.coordinates.markers]
    for k, marker in enumerate(data.coordinates.markers):
        if marker.name in names:
            offsets[k] = known.offsets_mm[names.index(marker.name)]
            rotations[k] = known.R_flange_markers[names.index(marker.name)]
    at = align_frames(data, replace(at, offsets_mm=offsets, R_flange_markers=rotations))
    frames = at.T_arm_frames.copy()
    for i, name in enumerate(data.coordinates.frames):
        if name in fitted.coordinates.frames:
            frames[i] = known.T_arm_frames[fitted.coordinates.frames.index(name)]
    at = replace(at, T_arm_frames=frames)
    return settle_centres(data, at, np.ones(data.points), scatter)


def _deviation_squares(
    known: Unknowns, fitted: StackedObservations, data: StackedObservations, scatter: Scatter
) -> _DeviationSquares:
    at = fit_places(known, fitted, data, scatter)
    sight = predict_tips(data, at)
    counts = np.bincount(data.place_of)[data.place_of]
    # the centre of a place uses up three of its coordinates
    spare = np.where(data.on_sphere, 1 - 3.0 / counts, 1 - 1.0 / counts)
    has_spare = spare > 1e-9
    found = residuals(data, at, scatter)
    distances = found.distances_mm
    squares = distances[: data.touches] ** 2
    normalised = found.touches**2 / np.where(data.on_sphere, 1.0, 3.0)
    sds = _length_sds(data, sight.covariances, scatter.touch_mm)
    scale = np.where(has_spare, 1 / np.where(has_spare, spare, 1.0), 0.0)
    turned = data.coordinates.has_rotation
    measured = np.sum(found.coordinates**2, axis=1) / np.where(turned, 6.0, 3.0)
    return _DeviationSquares(
        (squares * scale)[has_spare & ~data.on_sphere],
        (squares * scale)[has_spare & data.on_sphere],
        found.bars_mm**2,
        distances[data.touches :] ** 2,
        found.angles_rad[turned] ** 2,
        np.concatenate([(normalised * scale)[has_spare], (found.bars_mm / sds) ** 2, measured]),
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
    def rms(name: str, scale: float = 1e3) -> float | None:
        squares = np.concatenate([getattr(part, name) for part in parts])
        return scale * float(np.sqrt(np.mean(squares))) if len(squares) else None

    return Deviations(
        rms("seats"),
        rms("spheres"),
        rms("lengths"),
        rms("coordinates"),
        rms("rotations", float(np.rad2deg(1.0))),
        rms("normalised", 1.0) or 0.0,
    )
