"""Errors of scanned points and of touches, to first order, and their sums over many points.

A point errs by ``S dtheta + K dphi + E_f eps_f + t eta``: by the sensor and by arm and tip, which
are shared by everything that was measured, by the reading of the arm, which is common to a frame
or a touch, and by its own noise. Only the error along the surface normal n matters: what a
quantity takes from each point is a gain times that.
"""

from dataclasses import dataclass
from functools import cached_property
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.adjustment.core.arm_errors import FlangeMotion
from crenel.metrology.adjustment.core.uncertainty import NAMES, link_names
from crenel.metrology.sensor.camera import Camera
from crenel.metrology.sensor.laser_plane import LaserPlane
from crenel.metrology.transforms import Floats, adjoint, inverse, pivot_adjoint
from crenel.parts.maths.sensor_errors import (
    SENSOR_COUNT,
    pixel_and_plane_equations,
    points_by_pixel,
)

TIP_NAMES = ("tip_x", "tip_y", "tip_z", "tip_radius")
PROBE = slice(SENSOR_COUNT, SENSOR_COUNT + 6)
LINKS_FROM = PROBE.stop
SHARED_SOURCES = {
    "calibration": slice(0, LINKS_FROM),
    "arm": slice(LINKS_FROM, -len(TIP_NAMES)),
    "tip": slice(-len(TIP_NAMES), None),
}
"""What ``name_shared_errors`` has of each source of uncertainty."""
CHUNK = 50_000
"""Points whose derivatives are in memory at a time."""


def name_shared_errors(joint_count: int) -> tuple[str, ...]:
    """The errors that everything shares: sensor (23), links (6n), tip and its radius (4)."""
    return (*NAMES, *link_names(joint_count), *TIP_NAMES)


@dataclass(frozen=True)
class ErrorSums:
    """What m quantities take from errors of their points.

    ``shared`` (m, P) are derivatives by ``name_shared_errors``; ``by_readings`` (K, m, n) are by
    one standard deviation of each number of the readings of ``frames`` (K,).
    """

    shared: Floats
    frames: NDArray[np.int64]
    by_readings: Floats


class FramePoints(Protocol):
    """Points of frames or touches."""

    @property
    def points_mm(self) -> Floats:
        """(N, 3) in the arm frame; of touches, the centres of the tip."""

    @property
    def frame(self) -> NDArray[np.int64]:
        """(N,) the frame or touch of each point."""

    def select(self, kept: NDArray[np.int64]) -> "FramePoints":
        """Those of some of the points."""


@dataclass(frozen=True)
class ScanErrors:
    """Points of a scan.

    ``frame`` counts the frames of ``motion``, which has the arm at each of them; its noise is in
    ``reading_sd`` (n,), times one of the readings' unit. ``spread_mm`` (N,) is the standard
    uncertainty by the fit of the stripe, as a cloud has it.
    """

    points_mm: Floats
    frame: NDArray[np.int64]
    spread_mm: Floats
    camera: Camera
    plane: LaserPlane
    T_flange_sensor: Floats
    pivot_mm: Floats
    axis: str
    motion: FlangeMotion
    reading_sd: Floats

    @property
    def joint_count(self) -> int:
        return int(self.motion.by_links.shape[2]) // 6

    @cached_property
    def sensor_poses(self) -> Floats:
        """(F, 4, 4) ``T_arm_sensor`` of each frame."""
        return np.asarray(self.motion.T_arm_flange @ self.T_flange_sensor)

    def select(self, kept: NDArray[np.int64]) -> "ScanErrors":
        return ScanErrors(
            self.points_mm[kept],
            self.frame[kept],
            self.spread_mm[kept],
            self.camera,
            self.plane,
            self.T_flange_sensor,
            self.pivot_mm,
            self.axis,
            self.motion,
            self.reading_sd,
        )

    def points_sensor_mm(self) -> Floats:
        """(N, 3) in the sensor frame."""
        T = inverse(self.sensor_poses)[self.frame]
        return np.asarray(np.einsum("nij,nj->ni", T[:, :3, :3], self.points_mm) + T[:, :3, 3])

    def sums(self, gains: Floats, normals: Floats) -> ErrorSums:
        wrenches = wrench_sums(self.points_mm, normals, gains, self.frame, len(self.sensor_poses))
        frames = np.flatnonzero(np.bincount(self.frame, minlength=len(self.sensor_poses)))
        wrenches, motion = wrenches[frames], self.motion
        shared = np.zeros((gains.shape[1], LINKS_FROM + 6 * self.joint_count + len(TIP_NAMES)))
        for first in range(0, len(gains), CHUNK):
            part = slice(first, first + CHUNK)
            shared[:, :SENSOR_COUNT] += self._sensor_sums(part, gains[part], normals[part])
        to_arm = adjoint(motion.T_arm_flange[frames]) @ pivot_adjoint(self.pivot_mm)
        shared[:, PROBE] = np.einsum("fmi,fij->mj", wrenches, to_arm)
        links = np.einsum("fmi,fij->mj", wrenches, motion.by_links[frames])
        shared[:, LINKS_FROM : -len(TIP_NAMES)] = links
        return ErrorSums(shared, frames, wrenches @ (motion.by_noise[frames] * self.reading_sd))

    def own_sd_mm(self, normals: Floats) -> Floats:
        across = points_by_pixel(self.camera, self.plane, self.points_sensor_mm(), self.axis)
        along = np.sum(across * self._in_sensor(slice(None), normals), axis=1)
        return np.asarray(self.spread_mm * np.abs(along) / np.linalg.norm(across, axis=1))

    def rows(self, normals: Floats) -> Floats:
        """(N, P) derivatives of each point along its normal (N, 3) by the shared errors."""
        moves, count = self.motion, len(self.points_mm)
        twists = normal_twists(self.points_mm, normals)
        found = np.zeros((count, LINKS_FROM + 6 * self.joint_count + len(TIP_NAMES)))
        left, right = pixel_and_plane_equations(self.camera, self.plane, self.points_sensor_mm())
        n = self._in_sensor(slice(None), normals)
        pulled = -np.linalg.solve(np.swapaxes(left, 1, 2), n[:, :, None])[:, :, 0]
        found[:, :SENSOR_COUNT] = np.einsum("ni,nij->nj", pulled, right)
        to_arm = (adjoint(moves.T_arm_flange) @ pivot_adjoint(self.pivot_mm))[self.frame]
        found[:, PROBE] = np.einsum("ni,nij->nj", twists, to_arm)
        links = np.einsum("ni,nij->nj", twists, moves.by_links[self.frame])
        found[:, LINKS_FROM : -len(TIP_NAMES)] = links
        return found

    def draw_readings(self, normals: Floats, rng: np.random.Generator) -> Floats:
        """(N,) an error of each point along its normal (N, 3) by readings drawn at random."""
        noise = rng.normal(size=(len(self.motion.T_arm_flange), len(self.reading_sd)))
        moved = np.einsum("fij,fj->fi", self.motion.by_noise, noise * self.reading_sd)
        twists = normal_twists(self.points_mm, normals)
        return np.asarray(np.sum(twists * moved[self.frame], axis=1))

    def _in_sensor(self, part: slice, normals: Floats) -> Floats:
        """Directions (N, 3) in the sensor frame."""
        R = self.sensor_poses[self.frame[part], :3, :3]
        return np.asarray(np.einsum("nji,nj->ni", R, normals))

    def _sensor_sums(self, part: slice, gains: Floats, normals: Floats) -> Floats:
        """(m, 17)"""
        T = self.sensor_poses[self.frame[part]]
        away = self.points_mm[part] - T[:, :3, 3]
        points = np.einsum("nji,nj->ni", T[:, :3, :3], away)
        left, right = pixel_and_plane_equations(self.camera, self.plane, points)
        n = self._in_sensor(part, normals)
        pulled = -np.linalg.solve(np.swapaxes(left, 1, 2), n[:, :, None])[:, :, 0]
        weighted = (gains.T[:, :, None] * pulled).reshape(gains.shape[1], -1)
        return np.asarray(weighted @ right.reshape(-1, SENSOR_COUNT))


@dataclass(frozen=True)
class TouchErrors:
    """Touches: centres of the tip, each with a reading of its own.

    ``side`` (N,) is +1 where the centre is on the side to which the normal points, and -1 on the
    other; the point of contact is ``radius`` away from the centre. ``touch_sd_mm`` is the noise of
    a touch beyond the reading.
    """

    points_mm: Floats
    side: Floats
    motion: FlangeMotion
    reading_sd: Floats
    touch_sd_mm: float

    @property
    def frame(self) -> NDArray[np.int64]:
        return np.arange(len(self.points_mm))

    @property
    def joint_count(self) -> int:
        return int(self.motion.by_links.shape[2]) // 6

    def select(self, kept: NDArray[np.int64]) -> "TouchErrors":
        moves = self.motion
        some = FlangeMotion(
            moves.T_arm_flange[kept], moves.by_links[kept], moves.by_noise[kept], moves.noise_sd
        )
        return TouchErrors(
            self.points_mm[kept], self.side[kept], some, self.reading_sd, self.touch_sd_mm
        )

    def sums(self, gains: Floats, normals: Floats) -> ErrorSums:
        count, moves = len(gains), self.motion
        wrenches = wrench_sums(self.points_mm, normals, gains, self.frame, count)
        shared = np.zeros((gains.shape[1], LINKS_FROM + 6 * self.joint_count + len(TIP_NAMES)))
        links = np.einsum("fmi,fij->mj", wrenches, moves.by_links)
        shared[:, LINKS_FROM : -len(TIP_NAMES)] = links
        in_flange = np.einsum("nji,nj->ni", moves.T_arm_flange[:, :3, :3], normals)
        shared[:, -4:-1] = gains.T @ in_flange
        shared[:, -1] = -gains.T @ self.side
        by_readings = wrenches @ (moves.by_noise * self.reading_sd)
        return ErrorSums(shared, self.frame, by_readings)

    def own_sd_mm(self, normals: Floats) -> Floats:
        return np.full(len(normals), self.touch_sd_mm)

    def reading_noise_mm(self, normals: Floats) -> Floats:
        """(N,) standard deviation of each touch along its normal (N, 3) by its reading."""
        twists = normal_twists(self.points_mm, normals)
        moved = np.einsum("ni,nij->nj", twists, self.motion.by_noise) * self.reading_sd
        return np.asarray(np.linalg.norm(moved, axis=1))


def normal_twists(points_mm: Floats, normals: Floats) -> Floats:
    """(N, 6) what points (N, 3) move along their normals (N, 3) by a small motion, rad and mm,
    about the origin."""
    found = np.empty((len(points_mm), 6))
    x, y, z = points_mm.T
    a, b, c = normals.T
    found[:, 0], found[:, 1], found[:, 2] = y * c - z * b, z * a - x * c, x * b - y * a
    found[:, 3:] = normals
    return found


def wrench_sums(
    points_mm: Floats, normals: Floats, gains: Floats, frame: NDArray[np.int64], frames: int
) -> Floats:
    """What m quantities take from a small motion of each frame, arm frame.

    Args:
        points_mm, normals: (N, 3), arm frame.
        gains: (N, m).
        frame: (N,) below ``frames``.

    Returns:
        (frames, m, 6) derivatives by a left twist (rad, mm) of each frame.
    """
    twists = normal_twists(points_mm, normals)
    taken = (gains[:, :, None] * twists[:, None, :]).reshape(len(gains), -1)
    order = np.argsort(frame, kind="stable")
    starts = np.flatnonzero(np.diff(frame[order], prepend=-1))
    found = np.zeros((frames, taken.shape[1]))
    if len(order):
        found[frame[order][starts]] = np.add.reduceat(taken[order], starts, axis=0)
    return found.reshape(frames, gains.shape[1], 6)
