"""The spheres of a scanned ball bar: found by their diameter, and their centres."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from app.metrology.performance.gate import SphereGate, gate_sphere
from app.metrology.performance.sphere import sphere_centre
from app.metrology.transforms import Floats

BAR_CONE_DEG = 30.0
"""Points within this angle of the bar's direction, on either side of a sphere, are of the bar."""
MOST_SPHERES = 12
SEARCHED_POINTS = 20_000
"""Of a cloud, evenly over it: enough to find spheres."""
TRIALS = 400
NEAR_MM = 0.3
"""Points this near to the surface of a sphere count for it while it is searched for."""
LEAST_FOUND, LEAST_SHARE = 60, 0.6
"""Of the searched points, how many are on a sphere, and what share of those up to 2 mm about it."""
ABOUT_MM = 2.0
LEAST_POINTS, LEAST_FRAMES = 200, 5
LEAST_SPREAD = 0.045
"""Of the normals that were scanned, in their narrowest direction; a cap of 25° has as much."""


@dataclass(frozen=True, eq=False)
class ScannedSphere:
    """One sphere of a scanned bar."""

    centre_mm: Floats
    """(3,) by all points within the gate, with the calibrated diameter."""
    points: int
    frames: int
    spread: float
    """Smallest eigenvalue of the mean of ``n nᵀ`` over the normals ``n`` of its points."""

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
        return ScannedSphere(np.asarray(start_mm), len(inside), 0, 0.0)
    centre = sphere_centre(points_mm[inside], diameter_mm)
    normals = points_mm[inside] - centre
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    spread = float(np.linalg.eigvalsh(normals.T @ normals / len(normals))[0])
    return ScannedSphere(centre, len(inside), len(np.unique(frames[inside])), spread)


def _best_sphere(
    points: Floats, towards: Floats, radius_mm: float, random: np.random.Generator
) -> Floats | None:
    """The centre (3,) of the sphere with most points on it; None if that is none."""
    tree = cKDTree(points)
    best: tuple[int, Floats] | None = None
    for index in random.integers(0, len(points), TRIALS):
        near = np.array(tree.query_ball_point(points[index], radius_mm))
        if len(near) < 3:
            continue
        three = points[[index, *random.choice(near, 2, replace=False)]]
        centre = _centre_through(three, towards[index], radius_mm)
        if centre is None:
            continue
        about = points[tree.query_ball_point(centre, radius_mm + ABOUT_MM)]
        on = np.abs(np.linalg.norm(about - centre, axis=1) - radius_mm) <= NEAR_MM
        count = int(on.sum())
        if count < max(LEAST_FOUND, LEAST_SHARE * len(about)):
            continue
        if best is None or count > best[0]:
            best = count, sphere_centre(about[on], 2 * radius_mm)
    return None if best is None else best[1]


def _centre_through(three: Floats, towards: Floats, radius_mm: float) -> Floats | None:
    """The centre (3,) of the sphere through three points (3, 3), on the side away from the camera;
    None if there is none, or they are almost on a line."""
    a, b = three[1] - three[0], three[2] - three[0]
    normal = np.cross(a, b)
    square = float(normal @ normal)
    if square < (0.05 * radius_mm**2) ** 2:
        return None
    middle = (np.cross(normal, a) * (b @ b) + np.cross(b, normal) * (a @ a)) / (2 * square)
    height_square = radius_mm**2 - float(middle @ middle)
    if height_square < 0:
        return None
    normal /= np.sqrt(square) * np.sign(normal @ towards)
    return np.asarray(three[0] + middle - normal * np.sqrt(height_square))
