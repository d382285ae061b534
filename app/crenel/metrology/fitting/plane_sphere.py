"""Planes and spheres fitted to clouds, with the article's filter on the distances."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from crenel.errors import OperationError
from crenel.messages.message import message
from crenel.metrology.robust import sigma_from_median
from crenel.metrology.transforms import Floats

FILTER_SIGMAS = 3.0
"""Points further than this many standard deviations from the fit are excluded."""
# A plane's normal (3,) and offset, a sphere's centre (3,) and radius, or a cylinder's axis
# (6,), a point and the direction, and radius; in mm.
ShapeParameters = tuple[Floats, float]
START_TRIALS = 200
START_POINTS = 2000


@dataclass(frozen=True)
class PlaneFit:
    """A least-squares plane, ``normal . x = offset_mm``."""

    normal: Floats
    """(3,) unit length; the sign is arbitrary."""
    offset_mm: float
    centre_mm: Floats
    """(3,) centroid of the points used."""
    rms_mm: float
    form_mm: float
    """Largest minus smallest distance of the points used."""
    used: NDArray[np.bool_]
    """(N,) points that passed the filter."""


@dataclass(frozen=True)
class SphereFit:
    """A least-squares sphere."""

    centre_mm: Floats
    """(3,)"""
    radius_mm: float
    rms_mm: float
    form_mm: float
    """Largest minus smallest radial distance of the points used."""
    used: NDArray[np.bool_]
    """(N,) points that passed the filter."""


def fit_plane(points_mm: Floats) -> PlaneFit:
    """Least-squares plane through a cloud, with a filter on the distances.

    The start is robust: the sample plane with the least median distance. Points beyond
    ``FILTER_SIGMAS`` standard deviations of the distances are excluded, and the plane is fitted
    again, until the selection no longer changes.

    Args:
        points_mm: (N, 3) in any frame, N >= 3; NaN points are never used.

    Returns:
        The plane in the same frame; the sign of its normal is arbitrary.

    Raises:
        OperationError: ``too-few-points``, or all ``points-on-a-line``.

    Source:
        The filter is that of the article, section 4; the start is a least median of squares
        (Rousseeuw, 1984).

    Example:
        >>> x, y = (axis.ravel() for axis in np.meshgrid(np.arange(9.0), np.arange(9.0)))
        >>> cloud = np.column_stack([x, y, np.full(81, 5.0)])
        >>> cloud[0, 2] = 7.0  # an outlier
        >>> fit = fit_plane(cloud)
        >>> round(abs(fit.offset_mm), 9), round(fit.rms_mm, 9), int(fit.used.sum())
        (5.0, 0.0, 80)
    """
    points, finite = finite_points(points_mm, 3, "plane")
    start = _start_plane(points)
    (normal, offset_mm), keep = filter_outliers(points, start, _plane_distances, _plane_through)
    inside = _plane_distances(points, (normal, offset_mm))[keep]
    used = finite.copy()
    used[finite] = keep
    return PlaneFit(
        normal=normal,
        offset_mm=offset_mm,
        centre_mm=points[keep].mean(axis=0),
        rms_mm=float(np.sqrt(np.mean(inside**2))),
        form_mm=float(np.ptp(inside)),
        used=used,
    )


def fit_sphere(points_mm: Floats) -> SphereFit:
    """Least-squares sphere (radial distances) through a cloud, filtered as in ``fit_plane``.

    Args:
        points_mm: (N, 3) in any frame, N >= 4; NaN points are never used.

    Returns:
        The sphere in the same frame.

    Raises:
        OperationError: ``too-few-points``; ``points-in-a-plane`` or ``points-fix-no-sphere``.

    Source:
        The filter is that of the article, section 4.

    Example:
        >>> outward = np.random.default_rng(0).normal(size=(200, 3))
        >>> outward /= np.linalg.norm(outward, axis=1)[:, None]
        >>> fit = fit_sphere(12.7 * outward + [100.0, 0.0, 0.0])
        >>> round(fit.radius_mm, 6), fit.centre_mm.round(6)[0].item()
        (12.7, 100.0)
    """
    points, finite = finite_points(points_mm, 4, "sphere")
    start = _start_sphere(points)
    (centre_mm, radius_mm), keep = filter_outliers(
        points, start, _sphere_distances, _least_squares_sphere
    )
    inside = _sphere_distances(points, (centre_mm, radius_mm))[keep]
    used = finite.copy()
    used[finite] = keep
    return SphereFit(
        centre_mm=centre_mm,
        radius_mm=radius_mm,
        rms_mm=float(np.sqrt(np.mean(inside**2))),
        form_mm=float(np.ptp(inside)),
        used=used,
    )


def finite_points(points_mm: Floats, least: int, shape: str) -> tuple[Floats, NDArray[np.bool_]]:
    """The usable points (N, 3) of a cloud (M, 3), and their mask (M,).

    Raises:
        OperationError: fewer than ``least``.
    """
    points = np.asarray(points_mm, dtype=np.float64)
    finite = np.all(np.isfinite(points), axis=1)
    if finite.sum() < least:
        raise OperationError(
            "too-few-points",
            message("cloud-holds-usable-points", points=int(finite.sum())),
            message("needs-least", shape=shape, least=least),
        )
    return points[finite], finite


def filter_outliers(
    points: Floats,
    start: ShapeParameters,
    distances_of: Callable[[Floats, ShapeParameters], Floats],
    least_squares: Callable[[Floats, ShapeParameters], ShapeParameters],
) -> tuple[ShapeParameters, NDArray[np.bool_]]:
    """Fits a shape and excludes points that are too far off, until the selection is stable.

    Args:
        points: (N, 3) mm.
        start: a robust start shape.
        distances_of: signed distances (N,) in mm of points from a shape.
        least_squares: the least-squares shape of points, from a start shape.

    Returns:
        The shape, and (N,) the points within ``FILTER_SIGMAS`` standard deviations of it.

    Source:
        The article, section 4.
    """
    shape, off = start, distances_of(points, start)
    # first, the points close to the start, by a scale that outliers do not affect
    keep = np.abs(off) <= 5 * max(sigma_from_median(np.abs(off)), 1e-9)
    for _ in range(50):
        shape = least_squares(points[keep], shape)
        off = distances_of(points, shape)
        kept = np.abs(off) <= FILTER_SIGMAS * max(float(np.std(off[keep])), 1e-9)
        if np.array_equal(kept, keep):
            break
        keep = kept
    return shape, keep


def _plane_distances(points: Floats, plane: ShapeParameters) -> Floats:
    normal, offset_mm = plane
    return np.asarray(points @ normal - offset_mm)


def _sphere_distances(points: Floats, sphere: ShapeParameters) -> Floats:
    centre_mm, radius_mm = sphere
    return np.asarray(np.linalg.norm(points - centre_mm, axis=1) - radius_mm)


def _plane_through(points: Floats, _: ShapeParameters | None = None) -> ShapeParameters:
    """The plane through the centroid, perpendicular to the direction of least spread."""
    centre = points.mean(axis=0)
    values, vectors = np.linalg.eigh((points - centre).T @ (points - centre))
    if values[1] <= 1e-12 * values[2]:
        raise OperationError(
            "points-on-a-line", message("points-lie-one-line"), message("they-fix-no-plane")
        )
    normal = vectors[:, 0]
    return normal, float(normal @ centre)


def _start_plane(points: Floats) -> ShapeParameters:
    """The plane through three points that has the least median distance to a sample."""
    sample, chosen = draw_samples(points, 3)
    normals = np.cross(chosen[:, 1] - chosen[:, 0], chosen[:, 2] - chosen[:, 0])
    lengths = np.linalg.norm(normals, axis=1)
    proper = lengths > 1e-9 * float(np.max(lengths, initial=1e-12))
    if not proper.any():
        return _plane_through(points)
    normals = normals[proper] / lengths[proper, None]
    offsets = np.einsum("ij,ij->i", normals, chosen[proper, 0])
    misfit = np.median(np.abs(sample @ normals.T - offsets), axis=0)
    best = int(np.argmin(misfit))
    return normals[best], float(offsets[best])


def _start_sphere(points: Floats) -> ShapeParameters:
    """The sphere through four points that has the least median distance to a sample."""
    origin = points[0]  # squares of far coordinates would lose the digits of the radius
    sample, chosen = draw_samples(points - origin, 4)
    systems = 2 * (chosen[:, 1:] - chosen[:, :1])
    proper = np.linalg.cond(systems) <= 1e8
    if not proper.any():
        raise OperationError(
            "points-in-a-plane", message("points-lie-one-plane"), message("they-fix-no-sphere")
        )
    squares, first = np.sum(chosen[proper] ** 2, axis=2), chosen[proper, 0]
    right = squares[:, 1:] - squares[:, :1]
    centres = np.linalg.solve(systems[proper], right[..., None])[..., 0]
    radii = np.linalg.norm(first - centres, axis=1)
    away = np.linalg.norm(sample - centres[:, None], axis=2)
    misfit = np.median(np.abs(away - radii[:, None]), axis=1)
    best = int(np.argmin(misfit))
    return centres[best] + origin, float(radii[best])


def draw_samples(points: Floats, size: int) -> tuple[Floats, Floats]:
    """A sample of the points, and ``START_TRIALS`` draws of ``size`` of them; repeatable."""
    rng = np.random.default_rng(0)
    sample = points[rng.permutation(len(points))[:START_POINTS]]
    return sample, sample[rng.integers(0, len(sample), (START_TRIALS, size))]


def _least_squares_sphere(points: Floats, start: ShapeParameters) -> ShapeParameters:
    """Gauss-Newton on the radial distances."""
    centre_mm, radius_mm = start
    for _ in range(50):
        away = points - centre_mm
        distance = np.linalg.norm(away, axis=1)
        J = np.column_stack([-away / distance[:, None], -np.ones(len(points))])
        normal_matrix = J.T @ J
        if np.linalg.cond(normal_matrix) > 1e12:
            raise OperationError(
                "points-fix-no-sphere",
                message("points-lie-too-small-piece-sphere"),
                message("centre-radius-cannot-be-separated"),
                message("scan-more-sphere"),
            )
        change = np.linalg.solve(normal_matrix, -J.T @ (distance - radius_mm))
        centre_mm, radius_mm = centre_mm + change[:3], radius_mm + float(change[3])
        if np.max(np.abs(change)) < 1e-10:
            break
    return centre_mm, radius_mm
