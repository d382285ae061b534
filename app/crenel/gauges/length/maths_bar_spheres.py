"""The spheres of a scanned ball bar: found by their diameter, and their centres."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from crenel.gauges.plan.maths_gate import SphereGate, gate_sphere
from crenel.metrology.fitting.reference_sphere import sphere_centre
from crenel.metrology.transforms import Floats

BAR_CONE_DEG = 30.0
"""Points within this angle of the bar's direction, on either side of a sphere, are of the bar."""
MOST_SPHERES = 12
SEARCHED_POINTS = 20_000
"""The points of a cloud that are searched, evenly over it: enough to find spheres."""
TRIALS, NEIGHBOURS = 400, 2000
"""Spheres that are tried, and the points, evenly over a cloud, from which neighbours are taken."""
NEAR_MM = 0.3
"""Points this near to the surface of a sphere count for it while it is searched for."""
LEAST_FOUND, LEAST_SHARE = 60, 0.6
"""How many of the searched points are on a sphere at least, and what share of those up to 2 mm
about it."""
ABOUT_MM = 2.0
LEAST_POINTS, LEAST_FRAMES = 200, 5
LEAST_SPREAD = 0.045
"""The least spread of the normals that were scanned, in their narrowest direction; a cap of 25° has
as much."""


@dataclass(frozen=True, eq=False)
class ScannedSphere:
    """One sphere of a scanned bar."""

    centre_mm: Floats
    """(3,) by all points within the gate, with the calibrated diameter."""
    points: int
    frames: int
    spread: float
    """Smallest eigenvalue of the mean of ``n nᵀ`` over the normals ``n`` of its points."""
    scatter_mm: float
    """Rms distance of its points from the calibrated sphere."""

    @property
    def is_covered(self) -> bool:
        """Whether its centre is fixed in every direction."""
        return (
            self.points >= LEAST_POINTS
            and self.frames >= LEAST_FRAMES
            and self.spread >= LEAST_SPREAD
        )


def find_spheres(points_mm: Floats, views: Floats, diameter_mm: float) -> Floats:
    """About where the spheres of a diameter are in a cloud, those with more points first.

    Spheres through three points near one another are tried; the one with most points on it is a
    sphere if they are many, and most of what is about it.

    Args:
        points_mm: (N, 3), N >= 1.
        views: (N, 3) unit directions from each point to the camera.

    Returns:
        (K, 3), K up to ``MOST_SPHERES``.
    """
    step = max(1, len(points_mm) // SEARCHED_POINTS)
    points, towards = points_mm[::step], views[::step]
    radius_mm, random = diameter_mm / 2, np.random.default_rng(0)
    found: list[Floats] = []
    while len(points) >= LEAST_FOUND and len(found) < MOST_SPHERES:
        centre = _best_sphere(points, towards, radius_mm, random)
        if centre is None:
            break
        found.append(centre)
        left = np.linalg.norm(points - centre, axis=1) > radius_mm + ABOUT_MM
        points, towards = points[left], towards[left]
    return np.array(found).reshape(-1, 3)


def measure_sphere(
    points_mm: Floats,
    views: Floats,
    frames: NDArray[np.int64],
    diameter_mm: float,
    start_mm: Floats,
    along: Floats,
    gate: SphereGate,
) -> ScannedSphere:
    """The centre of one sphere, by all points of it within the gate.

    Args:
        points_mm: (N, 3), arm frame.
        views: (N, 3) unit directions from each point to the camera.
        frames: (N,) in which each was seen.
        start_mm: (3,) about where its centre is.
        along: (3,) unit, of the bar.
        gate: its cone does not apply: a bar has no holder, but goes on at both sides.
    """
    away = points_mm - start_mm
    on_bar = np.abs(away @ along) >= np.cos(np.radians(BAR_CONE_DEG)) * np.linalg.norm(away, axis=1)
    off_bar = np.flatnonzero(~on_bar)
    anywhere = SphereGate(gate.shell_mm, gate.incidence_deg, 180.0)
    gated = gate_sphere(points_mm[off_bar], views[off_bar], diameter_mm, along, start_mm, anywhere)
    inside = off_bar[gated.inside]
    if len(inside) < LEAST_POINTS:
        return ScannedSphere(np.asarray(start_mm), len(inside), 0, 0.0, 0.0)
    centre = sphere_centre(points_mm[inside], diameter_mm)
    normals = points_mm[inside] - centre
    distances = np.linalg.norm(normals, axis=1)
    normals /= distances[:, None]
    spread = float(np.linalg.eigvalsh(normals.T @ normals / len(normals))[0])
    scatter_mm = float(np.sqrt(np.mean((distances - diameter_mm / 2) ** 2)))
    frames_seen = len(np.unique(frames[inside]))
    return ScannedSphere(centre, len(inside), frames_seen, spread, scatter_mm)


def _best_sphere(
    points: Floats, towards: Floats, radius_mm: float, random: np.random.Generator
) -> Floats | None:
    """The centre (3,) of the sphere with most points on it; None if that is none."""
    chosen = _choose_threes(points, radius_mm, random)
    centres = _centres_through(points[chosen], towards[chosen[:, 0]], radius_mm)
    if not len(centres):
        return None
    tree = cKDTree(points)

    def count_within(distance_mm: float) -> NDArray[np.int64]:
        return np.asarray(tree.query_ball_point(centres, distance_mm, return_length=True))

    on = count_within(radius_mm + NEAR_MM) - count_within(radius_mm - NEAR_MM)
    about = count_within(radius_mm + ABOUT_MM)
    on[on < np.maximum(LEAST_FOUND, LEAST_SHARE * about)] = 0
    if not on.any():
        return None
    best = centres[np.argmax(on)]
    near = np.abs(np.linalg.norm(points - best, axis=1) - radius_mm) <= NEAR_MM
    return sphere_centre(points[near], 2 * radius_mm)


def _choose_threes(
    points: Floats, radius_mm: float, random: np.random.Generator
) -> NDArray[np.int64]:
    """The numbers (T, 3) of points near one another: any, and two of a part of the others."""
    part = np.arange(0, len(points), max(1, len(points) // NEIGHBOURS))
    first = random.integers(0, len(points), TRIALS)
    near = cKDTree(points[part]).query_ball_point(points[first], radius_mm)
    threes = [
        (index, *part[random.choice(others, 2, replace=False)])
        for index, others in zip(first, near, strict=True)
        if len(others) >= 2
    ]
    return np.array(threes, dtype=np.int64).reshape(-1, 3)


def _centres_through(threes: Floats, towards: Floats, radius_mm: float) -> Floats:
    """The centres of the spheres through three points each, on the side away from the camera.

    Args:
        threes: (T, 3, 3).
        towards: (T, 3) unit, from each first point to the camera.

    Returns:
        (K, 3), K <= T: none of points almost on a line, or too far apart.
    """
    a, b = threes[:, 1] - threes[:, 0], threes[:, 2] - threes[:, 0]
    normals = np.cross(a, b)
    squares = np.sum(normals**2, axis=1)
    apart = squares >= (0.05 * radius_mm**2) ** 2
    a, b, normals, squares = a[apart], b[apart], normals[apart], squares[apart]
    to_middles = np.cross(normals, a) * np.sum(b**2, axis=1)[:, None]
    to_middles += np.cross(b, normals) * np.sum(a**2, axis=1)[:, None]
    to_middles /= 2 * squares[:, None]
    height_squares = radius_mm**2 - np.sum(to_middles**2, axis=1)
    sides = np.sign(np.sum(normals * towards[apart], axis=1))
    heights = sides * np.sqrt(np.maximum(height_squares, 0.0) / squares)
    centres = threes[apart, 0] + to_middles - normals * heights[:, None]
    return np.asarray(centres[height_squares >= 0])
