"""Features by least squares, with what they take from every error of their points.

The associated feature belongs to the surface: points are gathered in cells of equal area, each of
which weighs the same. With H the solution of the weighted equations, the parameters err by
``A`` times the shared errors, by ``B`` of each frame, and by ``V`` by the points' own noise; ``F``
is what residuals of runs of frames show beyond that: form and vibration.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.special import chdtri

from crenel.errors import OperationError
from crenel.messages.message import message
from crenel.metrology.fitting.shape import parameter_covariance
from crenel.metrology.robust import median, sigma_from_median
from crenel.metrology.transforms import Floats
from crenel.parts.maths.excess_scatter import RunScatter, sums_of_runs
from crenel.parts.maths.point_errors import ErrorSums, FramePoints, ScanErrors, TouchErrors
from crenel.parts.maths.shapes import Shape, cells_of, surface_coordinates

ROUNDS = 40
CLOSE = 1e-12
"""A step of the parameters, in mm at the edge of the points, below which nothing changes."""
ROBUST_SDS = 3.5
WORST_CONDITION = 1e10
"""Of the scaled equations: beyond it, points do not determine a feature."""
FILTER_ROUNDS = 6
SAMPLE = 20_000
"""So many points show which of them are outliers, and where the feature is about."""
TOUCH_CHANCE = 0.01


@dataclass(frozen=True)
class FeaturePoints:
    """Points of one feature from one source.

    ``offset_mm`` (N,) is where they should lie: 0, or a tip's radius, positive on the side to
    which the normal points.
    """

    errors: FramePoints
    offset_mm: Floats

    def select(self, kept: NDArray[np.int64]) -> "FeaturePoints":
        return FeaturePoints(self.errors.select(kept), self.offset_mm[kept])

    def distances(self, shape: Shape) -> Floats:
        """(N,) how far the surface points lie off a feature, mm."""
        return np.asarray(shape.distances(self.errors.points_mm) - self.offset_mm)


@dataclass(frozen=True)
class FittedFeature:
    """An associated feature in the arm frame, and what makes it err."""

    shape: Shape
    sums: ErrorSums
    own: Floats
    """(m, m) covariance by the points' own noise."""
    form: Floats
    """(m, m) covariance by what residuals of touches show beyond all noise that is known."""
    runs: RunScatter | None
    """What residuals of a scan show; None of touches, and of too few frames."""
    points: int
    used: NDArray[np.int64]
    """Indices of the points used."""
    off_mm: Floats
    """Residuals of the points used."""
    cell: NDArray[np.int64]
    """The cell of each point used."""
    outliers: int
    scatter: Floats | None = None
    """(m, m) covariance by the scatter of the points alone; None where they are too few."""

    @property
    def rms_mm(self) -> float:
        return float(np.sqrt(np.mean(self.off_mm**2)))

    @property
    def form_mm(self) -> float:
        """The range of the means of the cells."""
        count = np.bincount(self.cell)
        means = np.bincount(self.cell, self.off_mm) / count
        return float(np.ptp(means))


@dataclass(frozen=True)
class ShapeWithPoints:
    """A feature, the indices of the points used, and the cell of each of them."""

    shape: Shape
    used: NDArray[np.int64]
    cell: NDArray[np.int64]


def fit_feature(
    name: str,
    start: Shape,
    points: FeaturePoints,
    cell_mm: float,
    form_allowance_mm: float = 0.0,
) -> FittedFeature:
    """The least-squares feature through points, as ``fit_shape``, and what makes it err."""
    found = fit_shape(name, start, points, cell_mm, form_allowance_mm)
    count = len(points.offset_mm)
    if len(found.used) < count:
        points = points.select(found.used)
    return _propagate(found.shape, points, count, found.used, found.cell)


def fit_shape(
    name: str,
    start: Shape,
    points: FeaturePoints,
    cell_mm: float,
    form_allowance_mm: float = 0.0,
) -> ShapeWithPoints:
    """The least-squares feature through points, from a start nearby.

    Args:
        name: its id, for errors.
        cell_mm: edge of the cells of equal area; touches have one each.
        form_allowance_mm: points nearer than this are never outliers.

    Raises:
        OperationError: ``feature-not-determined``.
    """
    count = len(points.errors.points_mm)
    kept = np.arange(count)
    if isinstance(points.errors, TouchErrors):
        cell = kept
        shape = adjust_shape(name, start, points, np.ones(count))
    else:
        shape, limit, middle = _fit_sample(name, start, points, cell_mm, form_allowance_mm)
        kept = np.flatnonzero(np.abs(points.distances(shape) - middle) <= limit)
        points = points.select(kept)
        cell = cells_of(surface_coordinates(shape, points.errors.points_mm), cell_mm)[0]
        shape = adjust_shape(name, shape, points, cell_weights(cell))
    return ShapeWithPoints(shape, kept, cell)


def adjust_shape(name: str, start: Shape, points: FeaturePoints, weights: Floats) -> Shape:
    """Weighted least squares of orthogonal distances by Gauss-Newton.

    Raises:
        OperationError: ``feature-not-determined``.
    """
    shape = start.centre_on(points.errors.points_mm)
    x = points.errors.points_mm
    extent = max(float(np.ptp(x, axis=0).max()), 1e-6)
    scale = np.where(shape.freedom.are_angles, 1 / extent, 1.0)
    for _ in range(ROUNDS):
        off, _, J = shape.linearise(x)
        Js = J * scale
        N = Js.T @ (Js * weights[:, None])
        if len(x) < len(scale) or not np.linalg.cond(N) < WORST_CONDITION:
            raise _not_determined(name, len(x))
        step = -np.linalg.solve(N, Js.T @ (weights * (off - points.offset_mm)))
        shape = shape.apply_step(scale * step)
        if not np.isfinite(shape.T).all() or np.abs(step).max() > 10 * extent:
            raise _not_determined(name, len(x))
        if np.abs(step).max() < CLOSE * max(1.0, extent):
            break
    return shape


def _fit_sample(
    name: str, start: Shape, points: FeaturePoints, cell_mm: float, allowance_mm: float
) -> tuple[Shape, float, float]:
    """The feature by a part of the points, the largest distance that is no outlier, and the middle
    of the distances."""
    stride = -(-len(points.offset_mm) // SAMPLE)
    some = points.select(np.arange(0, len(points.offset_mm), stride))
    shape = start
    for _ in range(FILTER_ROUNDS):
        cell = cells_of(surface_coordinates(shape, some.errors.points_mm), cell_mm)[0]
        shape = adjust_shape(name, shape, some, cell_weights(cell))
        off = some.distances(shape)
        middle = median(off)
        away = np.abs(off - middle)
        limit = max(ROBUST_SDS * sigma_from_median(away), allowance_mm)
        good = away <= limit
        if good.all():
            break
        some = some.select(np.flatnonzero(good))
    return shape, limit, middle


def cell_weights(cell: NDArray[np.int64]) -> Floats:
    """(N,) the same for each cell, and all of them about 1."""
    count = np.bincount(cell)
    return np.asarray(len(cell) / len(count) / count[cell])


def _propagate(
    shape: Shape,
    points: FeaturePoints,
    count: int,
    kept: NDArray[np.int64],
    cell: NDArray[np.int64],
) -> FittedFeature:
    """What a feature takes from the errors of its points."""
    errors = points.errors
    assert isinstance(errors, (ScanErrors, TouchErrors))
    weights = cell_weights(cell)
    off, normals, J = shape.linearise(errors.points_mm)
    off = off - points.offset_mm
    inverse = np.linalg.inv(J.T @ (J * weights[:, None]))
    gains = -(J * weights[:, None]) @ inverse
    sd = errors.own_sd_mm(normals)
    own = np.asarray((gains * sd[:, None] ** 2).T @ gains)
    form = np.zeros_like(own)
    free = len(off) - J.shape[1]
    scatter = runs = None
    if isinstance(errors, TouchErrors):
        sums = errors.sums(gains, normals)
        by_readings = np.einsum("kmi,kni->mn", sums.by_readings, sums.by_readings)
        if free > 0:
            square = float(off @ off)
            scatter = square / free * inverse
            form = _touch_excess(square, free, normals, errors, own + by_readings, scatter)
    else:
        root = np.sqrt(weights)
        scatter = parameter_covariance(J * root[:, None], off * root, errors.frame)
        sums, runs = sums_of_runs(errors, J, normals, weights, off, sd)
    return FittedFeature(
        shape,
        sums,
        own,
        form,
        runs,
        count,
        kept,
        off,
        cell,
        count - len(kept),
        scatter,
    )


def _touch_excess(
    square: float,
    free: int,
    normals: Floats,
    errors: TouchErrors,
    noise: Floats,
    scatter: Floats,
) -> Floats:
    """The same of touches, by their residuals."""
    by_reading = errors.reading_noise_mm(normals)
    expected = float(np.mean(by_reading**2 + errors.touch_sd_mm**2))
    if expected == 0:
        return scatter
    ratio = square / free / expected
    if square / expected < chdtri(free, TOUCH_CHANCE):
        return np.zeros_like(noise)
    return np.asarray((ratio - 1) * noise)


def _not_determined(name: str, points: int) -> OperationError:
    return OperationError(
        "feature-not-determined",
        message("part-feature-not-determined", feature=name, count=points),
        message("part-points-on-too-small-piece"),
        message("part-measure-more-of-feature"),
    )
