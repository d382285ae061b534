"""A pass of the sensor over a plane: its frames, and the line of the plane in each."""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.arm.reading_interpolation import Stamps
from crenel.metrology.transforms import Floats

LEAST_POINTS = 20
"""Minimum number of points on the plane for a frame to count."""


@dataclass(frozen=True)
class PlanePass:
    """The frames of a plane, and a function for the poses of the arm."""

    stamps_ns: Stamps
    """(F,) increasing time stamps of the frames."""
    first: NDArray[np.int64]
    """(F + 1,) index of the first point of each frame, and N at the end."""
    points_mm: Floats
    """(N, 3) in the sensor frame."""
    sigma_mm: Floats
    """(N,) standard uncertainty of a point (k = 1) from its own fit."""
    poses_at: Callable[[Stamps], Floats]
    """``T_arm_sensor`` (F, 4, 4) at the arm's time stamps (F,); NaN if unknown."""
    number_sharing_noise: float = 1.0
    """How many neighbouring points of a frame share their noise."""

    @property
    def frame(self) -> NDArray[np.int64]:
        """(N,) frame of each point."""
        return np.repeat(np.arange(len(self.stamps_ns)), np.diff(self.first))

    def points_in_arm(self, delays_ns: Stamps | int) -> Floats:
        """(N, 3) the points in the arm frame; NaN if the pose of the arm is unknown.

        ``delays_ns`` is one delay, or (F,) those of the frames."""
        T = self.poses_at(self.stamps_ns + delays_ns)[self.frame]
        return np.asarray(np.einsum("nij,nj->ni", T[:, :3, :3], self.points_mm) + T[:, :3, 3])

    def frames_on_plane(
        self, off_mm: Floats, gate_mm: float
    ) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
        """(F,) frames with a pose, and frames with enough points nearer to the plane than a gate.

        ``off_mm``: (N,) distances of the points; infinite without a pose.
        """
        known = np.isfinite(np.maximum.reduceat(off_mm, self.first[:-1]))
        counts = np.bincount(self.frame, off_mm < gate_mm, len(self.stamps_ns))
        return known, counts >= LEAST_POINTS

    def select(self, frames: NDArray[np.int64]) -> "PlanePass":
        """Some of the frames, in order."""
        counts = np.diff(self.first)[frames]
        first = np.concatenate([[0], np.cumsum(counts)])
        at = np.repeat(self.first[frames] - first[:-1], counts) + np.arange(first[-1])
        return replace(
            self,
            stamps_ns=self.stamps_ns[frames],
            first=first,
            points_mm=self.points_mm[at],
            sigma_mm=self.sigma_mm[at],
        )


@dataclass(frozen=True)
class StripeLines:
    """The stripe of each frame as a line."""

    stamps_ns: Stamps
    """(F,)"""
    centre_mm: Floats
    """(F, 3) in the sensor frame."""
    half_mm: Floats
    """(F, 3) along the line; its length is the rms distance of the points from the centre."""
    variance: Floats
    """(F,) mm², variance of the distance of centre and end from the plane, due to the points
    alone."""

    def select(self, rows: NDArray[np.int64]) -> "StripeLines":
        """Some of the lines."""
        return StripeLines(
            self.stamps_ns[rows], self.centre_mm[rows], self.half_mm[rows], self.variance[rows]
        )

    @property
    def height(self) -> Floats:
        """(F,) position of the plane in the range of the sensor, in units of the spread."""
        off = self.centre_mm - self.centre_mm.mean(axis=0)
        along = off @ np.linalg.svd(off, full_matrices=False)[2][0]
        return np.asarray(along / max(float(np.std(along)), 1e-9))


def fit_stripe_lines(passed: PlanePass, on_plane: NDArray[np.bool_]) -> StripeLines:
    """The line through the points of each frame that lie on the plane.

    Args:
        passed: the pass.
        on_plane: (N,) mask of points that count.

    Returns:
        Lines of the F frames with at least ``LEAST_POINTS`` such points, weighted by the
        uncertainty of the points; sensor frame, mm.
    """
    frame, count = passed.frame[on_plane], len(passed.stamps_ns)
    points, weight = passed.points_mm[on_plane], passed.sigma_mm[on_plane] ** -2.0

    def summed(values: Floats) -> Floats:
        return np.asarray(np.bincount(frame, weights=values, minlength=count))

    enough = np.bincount(frame, minlength=count) >= LEAST_POINTS
    total = np.where(enough, summed(weight), 1.0)
    centre = np.column_stack([summed(weight * points[:, i]) for i in range(3)]) / total[:, None]
    off = points - centre[frame]
    moments = np.empty((count, 3, 3))
    for i, j in np.ndindex(3, 3):
        moments[:, i, j] = summed(weight * off[:, i] * off[:, j]) / total
    spread, axes = np.linalg.eigh(moments[enough])
    half = axes[:, :, 2] * np.sqrt(spread[:, 2])[:, None]
    variance = passed.number_sharing_noise / total[enough]
    return StripeLines(passed.stamps_ns[enough], centre[enough], half, variance)
