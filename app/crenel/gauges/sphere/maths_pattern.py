"""The 25 places on a hemisphere at which a sphere is probed, and the patches about them."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from crenel.gauges.plan.maths_gate import SphereGate, within_gate
from crenel.metrology.fitting.cylinder import perpendicular_axes
from crenel.metrology.transforms import Floats

RINGS = ((0.0, 1, 0.0), (22.5, 4, 0.0), (45.0, 8, 22.5), (67.5, 4, 45.0), (90.0, 8, 22.5))
"""Angle from the pole, number of places, and rotation against the first, in degrees."""
COUNT = 25
RIM_DEG = 85.0
"""Where the stylus' shaft would touch at 90°."""
PATCH_DEG = 8.0
"""Half-angle of a patch; patches do not overlap, the least spacing is 22.5°."""
MISSED_DEG = 15.0
"""A place without a touch within this was missed."""
CATCH_DEG = 12.0
"""A touch belongs to the nearest free place within this."""


def pattern_directions(pole: Floats, rim_deg: float = 90.0) -> Floats:
    """Unit directions (25, 3) from the sphere's centre.

    Args:
        pole: (3,) direction of the pole, away from the holder.
        rim_deg: angle of the last ring from the pole; ``RIM_DEG`` for a stylus with a shaft.

    Source:
        The pattern that ISO 10360-5 recommends.

    Example:
        >>> pattern_directions(np.array([0.0, 0.0, 2.0])).shape
        (25, 3)
    """
    axis = np.asarray(pole) / np.linalg.norm(pole)
    a, b = perpendicular_axes(axis)
    directions = []
    for tilt_deg, count, turn_deg in RINGS:
        tilt = np.radians(min(tilt_deg, rim_deg))
        for i in range(count):
            turn = np.radians(turn_deg + 360.0 * i / count)
            side = np.cos(turn) * a + np.sin(turn) * b
            directions.append(np.cos(tilt) * axis + np.sin(tilt) * side)
    return np.array(directions)


def assign_touches(touches_mm: Floats, centre_mm: Floats, directions: Floats) -> NDArray[np.int64]:
    """Which place each touch belongs to: (N,) indices of ``directions``, -1 of none.

    Touches are taken in order; each gets the nearest place within ``CATCH_DEG`` that is still free.

    Args:
        touches_mm: (N, 3) contact points or tip centres.
        centre_mm: (3,) of the sphere.
        directions: (P, 3).
    """
    outward = _unit(touches_mm - centre_mm)
    angles_deg = np.degrees(np.arccos(np.clip(outward @ directions.T, -1, 1)))
    free = np.ones(len(directions), dtype=np.bool_)
    found = np.full(len(touches_mm), -1, dtype=np.int64)
    for i, row in enumerate(angles_deg):
        nearest = int(np.argmin(np.where(free, row, np.inf)))
        if free[nearest] and row[nearest] <= CATCH_DEG:
            found[i], free[nearest] = nearest, False
    return found


def find_missed_places(touches_mm: Floats, centre_mm: Floats, directions: Floats) -> list[int]:
    """Indices of the places near which there is no touch.

    Args:
        touches_mm: (N, 3) contact points or tip centres.
        centre_mm: (3,) of the sphere.
        directions: (P, 3).
    """
    nearness = directions @ _unit(touches_mm - centre_mm).T
    missed = nearness.max(axis=1) < np.cos(np.radians(MISSED_DEG))
    return [int(i) for i in np.flatnonzero(missed)]


@dataclass(frozen=True)
class Patches:
    """The points of a scan by the patch that they belong to."""

    points: NDArray[np.int64]
    """(25,) number of points of each."""
    frames: NDArray[np.int64]
    """(25,) number of frames of each."""
    radii_mm: Floats
    """(25,) mean distance from the centre; NaN of a patch without points."""


def within_patches(points_mm: Floats, centre_mm: Floats, directions: Floats) -> NDArray[np.bool_]:
    """(N, 25) whether each point (N, 3) is within ``PATCH_DEG`` of each direction (25, 3)."""
    outward = _unit(points_mm - centre_mm)
    return np.asarray(outward @ directions.T >= np.cos(np.radians(PATCH_DEG)))


def scan_patches(
    points_mm: Floats, frame: NDArray[np.int64], centre_mm: Floats, directions: Floats
) -> Patches:
    """The patches of a scan, within ``PATCH_DEG`` of each direction.

    Args:
        points_mm: (N, 3) of the sphere alone.
        frame: (N,) frame number of each point.
        centre_mm: (3,) centre of the least-squares sphere of all points.
        directions: (25, 3).
    """
    distances = np.linalg.norm(points_mm - centre_mm, axis=1)
    within = within_patches(points_mm, centre_mm, directions)
    counts = within.sum(axis=0)
    frames = np.array([len(np.unique(frame[patch])) for patch in within.T], dtype=np.int64)
    with np.errstate(invalid="ignore", divide="ignore"):
        radii = (within * distances[:, None]).sum(axis=0) / counts
    return Patches(counts.astype(np.int64), frames, np.asarray(radii))


class PatchCoverage:
    """Counts points and frames of the patches while a scan runs, about a centre that is known.

    The counts are those of ``scan_patches`` of all points within the gate, about this centre.
    """

    def __init__(
        self, centre_mm: Floats, diameter_mm: float, pole: Floats, gate: SphereGate
    ) -> None:
        """Begins with no points.

        Args:
            centre_mm: (3,) of the sphere, by its touches.
            diameter_mm: calibrated.
            pole: (3,) away from the holder.
        """
        self._centre_mm, self._diameter_mm, self._pole = centre_mm, diameter_mm, pole
        self._gate = gate
        self._directions = pattern_directions(pole)
        self._points = np.zeros(len(self._directions), dtype=np.int64)
        self._frames: list[set[int]] = [set() for _ in self._directions]
        self.points_inside = 0
        """Counts the points of the sphere within the gate."""

    @property
    def points(self) -> NDArray[np.int64]:
        """(25,) number of points of each patch."""
        return self._points.copy()

    @property
    def frames(self) -> NDArray[np.int64]:
        """(25,) number of frames of each patch."""
        return np.array([len(frames) for frames in self._frames], dtype=np.int64)

    def add(self, points_mm: Floats, views: Floats, frame: NDArray[np.integer]) -> None:
        """Counts points of new frames; of one frame, they may come in parts.

        Args:
            points_mm: (N, 3), arm frame.
            views: (N, 3) unit directions from each point to the camera.
            frame: (N,) frame number of each point.
        """
        inside = within_gate(
            points_mm, views, self._diameter_mm, self._pole, self._centre_mm, self._gate
        )
        self.points_inside += int(inside.sum())
        within = within_patches(points_mm[inside], self._centre_mm, self._directions)
        self._points += within.sum(axis=0)
        frame = frame[inside]
        for patch in np.flatnonzero(within.any(axis=0)):
            self._frames[patch].update(np.unique(frame[within[:, patch]]).tolist())


def representative_points(patches: Patches, centre_mm: Floats, directions: Floats) -> Floats:
    """One point (P, 3) for each patch with points: its direction at its mean distance.

    Source:
        ISO 10360-8 lets points be averaged by the user's usual means; the mean is not robust, so
        that no point is excluded.
    """
    known = patches.points > 0
    return np.asarray(centre_mm + patches.radii_mm[known, None] * directions[known])


def _unit(vectors: Floats) -> Floats:
    return np.asarray(vectors / np.linalg.norm(vectors, axis=1, keepdims=True))
