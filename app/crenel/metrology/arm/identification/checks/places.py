"""Checks of seats and spheres: did one move, or do its points belong to another place?

On few places a fit follows most of them and leaves its misfit to one. So a place is accused only if
it stands out from what the other places deviate by when they are held out.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from crenel.errors import OperationError
from crenel.messages.message import message, quantity
from crenel.metrology.arm.identification.cross_validation import deviations_held_out, without_points
from crenel.metrology.arm.identification.least_squares import residuals
from crenel.metrology.arm.identification.observations import (
    ArmObservations,
    ProbedPlace,
    StackedObservations,
)
from crenel.metrology.arm.identification.robust_solve import ArmFit
from crenel.metrology.arm.identification.scatter import deviation_limit
from crenel.metrology.arm.kinematics import Arm
from crenel.metrology.robust import median
from crenel.metrology.transforms import Floats

OUTLIER_SHARE = 0.25
"""A place with a larger share of excluded points is not trusted."""
MOVED_SIGMAS = 4.0
"""Distance of first and later points of a seat relative to the scatter of single points."""
LEAST_GAP_MM = 1e-2
LEAST_HEAP = 4
MEDIAN_SD = 1.25
"""Standard deviation of a median relative to that of a mean."""


@dataclass(frozen=True)
class _Suspicion:
    """A place that seems to have moved, or whose points disagree."""

    group: int
    off_mm: float
    """By how much."""
    error: OperationError


def check_places_fixed(
    arm: Arm, observations: ArmObservations, data: StackedObservations, fit: ArmFit
) -> None:
    """Refuses a place whose points disagree; reports if it moved in between."""
    found = sorted(_suspicions(data, fit), key=lambda one: -one.off_mm)
    good = without_points(observations, fit.inliers)
    for suspicion in found:
        others = [i for i in range(good.places_count) if i != suspicion.group]
        usual_mm = deviations_held_out(arm, good.part(others), fit.scatter).largest_mm
        if usual_mm is not None and suspicion.off_mm > MOVED_SIGMAS * usual_mm:
            raise suspicion.error


def _suspicions(data: StackedObservations, fit: ArmFit) -> Iterator[_Suspicion]:
    vectors = residuals(data, fit.at, fit.scatter).vectors_mm[: data.touches]
    sd = _typical_sd(data, fit, vectors)
    seats = sum(place.diameter_mm is None for place in data.places)
    for group, members in enumerate(data.groups):
        for number in members.places:
            place = data.places[number]
            points, kept = vectors[place.rows], fit.inliers[: data.touches][place.rows]
            out = int(np.sum(~kept))
            split, gap_mm = find_split(points) if place.diameter_mm is None else (0, 0.0)
            chance = _chance_gap(split, len(points), seats, fit.freedom)
            if gap_mm > max(max(MOVED_SIGMAS, chance) * sd, LEAST_GAP_MM):
                yield _Suspicion(group, gap_mm, _move_error(place, split, gap_mm, sd))
            elif out >= 3 and out > OUTLIER_SHARE * len(points):
                off_mm = median(np.linalg.norm(points[~kept], axis=1))
                yield _Suspicion(group, off_mm, _disagreement_error(place, out))


def _move_error(place: ProbedPlace, split: int, gap_mm: float, sd_mm: float) -> OperationError:
    return OperationError(
        "seat-moved",
        message(
            "points-1-lie-apart-while-single",
            label=place.label,
            split=split,
            next=split + 1,
            points=place.rows.stop - place.rows.start,
            gap=quantity(1e3 * gap_mm, "µm"),
            sd=quantity(1e3 * sd_mm, "µm"),
        ),
        message("seat-moved-between"),
        message("clamp-seat-take-place-again-delete"),
    )


def _disagreement_error(place: ProbedPlace, out: int) -> OperationError:
    points = place.rows.stop - place.rows.start
    return OperationError(
        "place-disagrees",
        message("points-disagree-rest", label=place.label, out=out, points=points),
        message("tip-not-seated-or-seat-loose"),
        message("take-place-again-delete-rows"),
    )


def _typical_sd(data: StackedObservations, fit: ArmFit, vectors: Floats) -> float:
    """Typical distance of a point in a seat from the centre, per coordinate, mm."""
    seated = fit.inliers[: data.touches] & ~data.on_sphere
    if not seated.any():
        return fit.scatter.touch_mm
    return float(np.sqrt(median(np.sum(vectors[seated] ** 2, axis=1))) / 1.5382)


def _chance_gap(split: int, points: int, seats: int, freedom: float) -> float:
    """Gap between the first ``split`` and the later points of a seat, in standard deviations of a
    point, that chance explains."""
    if not split:
        return 0.0
    sd = MEDIAN_SD * np.sqrt(1 / split + 1 / (points - split))
    return float(sd * deviation_limit(points * seats, freedom, 3))


def find_split(points: Floats) -> tuple[int, float]:
    """The index at which points (m, 3) split in time into two clusters, and the distance of these
    (mm).

    (0, 0) if they do not split: most points of each part must be close to their own cluster.
    Medians are used, so that a few bad points do not form a cluster.
    """
    heaps: tuple[Floats, Floats] | None = None
    strongest = 0.0
    for k in range(LEAST_HEAP, len(points) - LEAST_HEAP + 1):
        first, later = points[:k], points[k:]
        a, b = np.median(first, axis=0), np.median(later, axis=0)
        apart = float(np.linalg.norm(a - b))
        strength = apart * np.sqrt(k * (len(points) - k))
        if strength > strongest and _heap(first, a, apart) and _heap(later, b, apart):
            strongest, heaps = strength, (a, b)
    if heaps is None:
        return 0, 0.0
    a, b = heaps
    nearer_first = np.linalg.norm(points - a, axis=1) < np.linalg.norm(points - b, axis=1)
    # the split that assigns most points to their own cluster
    right = np.cumsum(np.where(nearer_first, 1, -1))
    return int(np.argmax(right)) + 1, float(np.linalg.norm(a - b))


def _heap(points: Floats, middle: Floats, apart_mm: float) -> bool:
    """Whether three quarters of the points are closer to their middle than to the other cluster."""
    off = np.linalg.norm(points - middle, axis=1)
    return float(np.mean(off < 0.5 * apart_mm)) >= 0.75
