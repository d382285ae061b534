"""The scatter of the points about a fit, and the degrees of freedom that determine it."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from crenel.errors import OperationError
from crenel.messages.message import message
from crenel.metrology.arm.identification.coordinate_rows import coordinate_residuals, predict_poses
from crenel.metrology.arm.identification.least_squares import (
    ReducedSystem,
    length_deviations,
    length_uncertainties_mm,
    mahalanobis,
    predict_tips,
    residuals,
)
from crenel.metrology.arm.identification.observations import StackedObservations
from crenel.metrology.arm.identification.parameter_selection import system_covariance
from crenel.metrology.arm.identification.scatter import Scatter
from crenel.metrology.arm.identification.unknowns import Unknowns
from crenel.metrology.robust import MEDIAN_OF_NORMAL, median
from crenel.metrology.transforms import Floats

MEDIAN_OF_THREE = 1.5382
"""The median of the chi distribution with three degrees of freedom; of one it is
``MEDIAN_OF_NORMAL``."""
LEAST_SPARE = 0.05
"""Share of the coordinates' redundancy that is assumed at least."""
LARGEST_GROWTH = 100.0
"""The largest growth of the scatter in one step."""


def median_scatter(data: StackedObservations, at: Unknowns, parameters: int) -> Scatter:
    """Scatter per coordinate beyond what is stated for which the median point has the expected
    distance.

    Args:
        parameters: number of parameters that follow the points. Coordinates, which may be few,
            then deviate less than they scatter.
    """
    found = data.coordinates
    rows = 3 * (data.points - len(data.places) + int(found.has_rotation.sum()))
    spare = max(1.0 - (parameters + data.others.count) / max(rows, 1), LEAST_SPARE)
    deviations = residuals(data, at, Scatter()).distances_mm
    by_encoders = np.trace(predict_tips(data, at).covariances, axis1=1, axis2=2) / 3
    measured = coordinate_residuals(data, at, Scatter())
    variances = measured.variances
    typical = np.where(data.on_sphere, MEDIAN_OF_NORMAL, MEDIAN_OF_THREE)
    turned = found.has_rotation
    kinds = (
        (deviations[: data.touches] / typical, by_encoders),
        (_lengths(measured.off[:, :3]) / MEDIAN_OF_THREE, variances[:, :3].mean(axis=1)),
        (
            _lengths(measured.off[turned, 3:]) / MEDIAN_OF_THREE,
            variances[turned, 3:].mean(axis=1),
        ),
    )
    values = [
        max(_median(distances) ** 2 / share - _median(explained), least**2)
        for (distances, explained), share, least in zip(
            kinds, (1.0, spare, spare), Scatter().floors, strict=True
        )
    ]
    return Scatter(*np.sqrt(values).tolist())


def _median(values: Floats) -> float:
    return median(values) if len(values) else 0.0


def _lengths(vectors: Floats) -> Floats:
    return np.asarray(np.linalg.norm(vectors, axis=1))


def redundancies(
    data: StackedObservations, kept: NDArray[np.bool_], system: ReducedSystem
) -> Floats:
    """(3,) degrees of freedom of touches and certified lengths, coordinates, and rotations.

    Each unknown takes its share of those kinds of rows that determine it.
    """
    touched, measured = kept[: data.touches], kept[data.touches :]
    bars = sum(group.bar is not None for group in data.groups)
    lengths = int(np.isfinite(length_uncertainties_mm(data)).sum())
    turned = data.coordinates.has_rotation & measured
    rows = np.array(
        [
            np.sum(np.where(data.on_sphere[touched], 1, 3)) + bars + lengths - 3 * len(data.places),
            3 * int(measured.sum()),
            3 * int(turned.sum()),
        ]
    )
    covariance = system_covariance(system.rows)
    taken = [np.einsum("ij,jk,ik->", own, covariance, own) for own in system.kinds]
    return np.asarray(rows - taken)


def require_redundancy(
    data: StackedObservations, kept: NDArray[np.bool_], system: ReducedSystem
) -> Floats:
    """The same; raises ``OperationError`` if nothing checks the fit."""
    freedoms = redundancies(data, kept, system)
    if np.sum(freedoms) < 1:
        columns = system.rows.shape[1] - system.others
        raise OperationError(
            "too-few-points",
            message("points-places", points=int(kept.sum()), places=len(data.places)),
            message("they-leave-nothing-over-check-parameters", columns=columns),
            message("take-more-points-more-places"),
        )
    return freedoms


def match_scatter(
    data: StackedObservations,
    at: Unknowns,
    kept: NDArray[np.bool_],
    scatter: Scatter,
    freedoms: Floats,
) -> Scatter:
    """The scatter beyond what is stated for which the chi-squared of each kind is as expected."""
    sight, poses = predict_tips(data, at), predict_poses(data, at)
    touched, measured = kept[: data.touches], kept[data.touches :]

    by_lengths = float(np.sum(length_deviations(data, at) ** 2))

    def touches(scatter_mm: float) -> float:
        return float(np.sum(mahalanobis(data, at, sight, scatter_mm)[touched] ** 2)) + by_lengths

    def coordinates(tried: Scatter, rows: slice) -> float:
        whitened = coordinate_residuals(data, at, tried, poses).whitened
        return float(np.sum(whitened[measured, rows] ** 2))

    def points(scatter_mm: float) -> float:
        return coordinates(replace(scatter, point_mm=scatter_mm), slice(3))

    def turns(scatter_rad: float) -> float:
        return coordinates(replace(scatter, turn_rad=scatter_rad), slice(3, 6))

    values = [
        _find_scatter(squares, float(freedom), float(least), float(now))
        for squares, freedom, least, now in zip(
            (touches, points, turns), freedoms, scatter.floors, scatter.values, strict=True
        )
    ]
    if freedoms[0] < 1:  # touches that nothing checks scatter as the coordinates do
        values[0] = max(values[0], values[1])
    return Scatter(*values)


def _find_scatter(
    squares: Callable[[float], float], freedom: float, least: float, now: float
) -> float:
    """The scatter for which the squared deviations sum up to the freedom, at least ``least``.

    Where lengths deviate that a larger scatter lets deviate less after the next fit, it grows step
    by step from ``now``.
    """
    from scipy.optimize import brentq  # slow to import, and seldom needed

    if freedom < 1 or squares(least) <= freedom:
        return least
    if squares(LARGEST_GROWTH * now) > freedom:
        return now * float(np.sqrt(min(squares(now) / freedom, LARGEST_GROWTH)))
    return float(
        brentq(lambda value: squares(value) - freedom, least, LARGEST_GROWTH * now, rtol=1e-3)
    )
