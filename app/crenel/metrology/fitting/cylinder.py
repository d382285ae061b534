"""Cylinders fitted to clouds, with the same robust start and filter as for planes and spheres."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from crenel.errors import OperationError
from crenel.messages.message import Text, message
from crenel.metrology.fitting.plane_sphere import (
    ShapeParameters,
    draw_samples,
    filter_outliers,
    finite_points,
)
from crenel.metrology.robust import median
from crenel.metrology.transforms import Floats

NEIGHBOURS = 24
"""Number of adjacent sample points whose plane gives the normal of the surface."""
ITERATIONS = 50
# Two normals at a smaller angle than this do not determine an axis.
LEAST_CROSS = 0.05


@dataclass(frozen=True)
class CylinderFit:
    """A least-squares cylinder."""

    point_mm: Floats
    """(3,) on the axis, nearest to the centroid of the points used."""
    direction: Floats
    """(3,) unit length along the axis; the sign is arbitrary."""
    radius_mm: float
    rms_mm: float
    form_mm: float
    """Largest minus smallest radial distance of the points used."""
    used: NDArray[np.bool_]
    """(N,) points that passed the filter."""


def fit_cylinder(points_mm: Floats) -> CylinderFit:
    """Least-squares cylinder (radial distances) through a cloud, filtered as in ``fit_plane``.

    The start is the best of many cylinders, each through two points with the surface normals there:
    the axis is perpendicular to both normals.

    Args:
        points_mm: (N, 3) in any frame, N >= 5; NaN points are never used.

    Returns:
        The cylinder in the same frame; the sign of its direction is arbitrary.

    Raises:
        OperationError: ``too-few-points`` or ``points-fix-no-cylinder``.

    Source:
        The start is that of Schnabel, Wahl and Klein (2007), the filter that of the article,
        section 4.

    Example:
        >>> turn, z = np.linspace(0.0, np.pi, 40), np.arange(10.0)
        >>> turn, z = (axis.ravel() for axis in np.meshgrid(turn, z))
        >>> fit = fit_cylinder(np.column_stack([8.0 * np.cos(turn), 8.0 * np.sin(turn), z]))
        >>> round(fit.radius_mm, 6), abs(fit.direction).round(6).tolist()
        (8.0, [0.0, 0.0, 1.0])
    """
    points, finite = finite_points(points_mm, 5, "cylinder")
    centre = points.mean(axis=0)
    local = points - centre
    (axis, radius_mm), keep = filter_outliers(
        local, _start(local), cylinder_distances, _least_squares_cylinder
    )
    inside = cylinder_distances(local[keep], (axis, radius_mm))
    used = finite.copy()
    used[finite] = keep
    point, direction = axis[:3], axis[3:]
    middle = local[keep].mean(axis=0)
    nearest = point + direction * float((middle - point) @ direction)
    return CylinderFit(
        point_mm=nearest + centre,
        direction=direction,
        radius_mm=radius_mm,
        rms_mm=float(np.sqrt(np.mean(inside**2))),
        form_mm=float(np.ptp(inside)),
        used=used,
    )


def cylinder_distances(points_mm: Floats, cylinder: ShapeParameters) -> Floats:
    """Signed radial distances (N,) in mm of points (N, 3); outside is positive."""
    axis, radius_mm = cylinder
    away = points_mm - axis[:3]
    away = away - np.outer(away @ axis[3:], axis[3:])
    return np.asarray(np.linalg.norm(away, axis=1) - radius_mm)


def perpendicular_axes(direction: Floats) -> tuple[Floats, Floats]:
    """Two unit vectors perpendicular to a direction and to each other.

    Args:
        direction: (3,) unit length.

    Returns:
        (3,) and (3,); with the direction they are right-handed: ``cross(direction, a) == b``.

    Example:
        >>> a, b = perpendicular_axes(np.array([0.0, 0.0, 1.0]))
        >>> float(a @ b), np.allclose(np.cross([0.0, 0.0, 1.0], a), b)
        (0.0, True)
    """
    aside = np.cross(direction, np.eye(3)[np.argmin(np.abs(direction))])
    aside /= np.linalg.norm(aside)
    return aside, np.cross(direction, aside)


def cylinder_jacobian(points_mm: Floats, axis: Floats) -> Floats:
    """Derivatives (N, 5) of radial distances by the axis and the radius.

    By a shift of the axis along ``perpendicular_axes(direction)``, mm, a rotation about its point
    towards them, rad, and the radius.
    """
    point, direction = axis[:3], axis[3:]
    a, b = perpendicular_axes(direction)
    away = points_mm - point
    along = away @ direction
    u, v = away @ a, away @ b
    distance = np.maximum(np.hypot(u, v), 1e-12)
    u, v = u / distance, v / distance
    return np.column_stack([-u, -v, -u * along, -v * along, -np.ones(len(u))])


def _start(points: Floats) -> ShapeParameters:
    """The cylinder through two points and their normals with the least median distance."""
    sample, pairs = draw_samples(points, 2)
    nearest = cKDTree(sample).query(pairs.reshape(-1, 3), min(NEIGHBOURS, len(sample)))[1]
    normals = _normals(sample[nearest]).reshape(-1, 2, 3)
    best: tuple[float, ShapeParameters] | None = None
    for (p, q), (n, m) in zip(pairs, normals, strict=True):
        cylinder = _cylinder_through(p, q, n, m)
        if cylinder is None:
            continue
        misfit = median(np.abs(cylinder_distances(sample, cylinder)))
        if best is None or misfit < best[0]:
            best = (misfit, cylinder)
    if best is None:
        raise _no_cylinder_error(message("surface-not-curved"))
    return best[1]


def _normals(near: Floats) -> Floats:
    """Normals (K, 3) of the surface through groups of points (K, k, 3)."""
    off = near - near.mean(axis=1, keepdims=True)
    return np.asarray(np.linalg.eigh(np.einsum("kij,kil->kjl", off, off))[1][:, :, 0])


def _cylinder_through(p: Floats, q: Floats, n: Floats, m: Floats) -> ShapeParameters | None:
    """The cylinder through ``p`` and ``q`` with these normals; None if there is none."""
    direction = np.cross(n, m)
    length = float(np.linalg.norm(direction))
    if length < LEAST_CROSS:
        return None
    direction /= length
    # in the plane perpendicular to the axis, the two normals meet on it: p + s n = q + t m
    gap = q - p
    s = float(np.linalg.det(np.array([gap, m, direction]))) / length
    point = p + s * n
    away = p - point
    radius = float(np.linalg.norm(away - direction * (away @ direction)))
    return np.concatenate([point, direction]), radius


def _least_squares_cylinder(points: Floats, start: ShapeParameters) -> ShapeParameters:
    """Gauss-Newton on the radial distances."""
    axis, radius = start
    largest = 2 * float(np.ptp(points, axis=0).max()) + 1e-9
    for _ in range(ITERATIONS):
        # about the middle of the points, a rotation and a shift of the axis are distinguishable
        middle = points.mean(axis=0)
        axis = np.concatenate(
            [axis[:3] + axis[3:] * float((middle - axis[:3]) @ axis[3:]), axis[3:]]
        )
        J = cylinder_jacobian(points, axis)
        scale = np.array([1.0, 1.0, 1.0 / largest, 1.0 / largest, 1.0])
        normal_matrix = (J * scale).T @ (J * scale)
        if np.linalg.cond(normal_matrix) > 1e12:
            raise _no_cylinder_error(message("points-lie-too-small-piece"))
        off = cylinder_distances(points, (axis, radius))
        change = -scale * np.linalg.solve(normal_matrix, (J * scale).T @ off)
        a, b = perpendicular_axes(axis[3:])
        direction = axis[3:] + change[2] * a + change[3] * b
        axis = np.concatenate(
            [axis[:3] + change[0] * a + change[1] * b, direction / np.linalg.norm(direction)]
        )
        radius += float(change[4])
        if not np.isfinite(radius) or radius > 1e3 * largest:
            raise _no_cylinder_error(message("points-lie-too-small-piece"))
        if np.max(np.abs(change)) < 1e-10:
            break
    return axis, radius


def _no_cylinder_error(why: Text) -> OperationError:
    return OperationError(
        "points-fix-no-cylinder",
        message("points-fix-no-cylinder"),
        why,
        message("pick-more-way-round-fit-plane"),
    )
