"""The points of a scan: made of stripes by a calibration, to the cloud and to the display."""

import math
import time
from collections import deque
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from crenel.formats.clouds.files import CloudWriter, pack_points
from crenel.formats.clouds.points import Points, positions_of
from crenel.metrology.arm.kinematics import AnyArm, Arm, flange_poses
from crenel.metrology.sensor.camera import Camera
from crenel.metrology.sensor.laser_plane import LaserPlane
from crenel.metrology.sensor.line_range import find_line_bounds
from crenel.metrology.sensor.line_thinning import LineThinning
from crenel.metrology.sensor.triangulation import scan_points
from crenel.metrology.stripe import LineBounds, Stripe
from crenel.metrology.transforms import Floats

RATE_WINDOW_S = 1.0
DISTANCE_AGE_S = 0.5


@dataclass(frozen=True, eq=False)
class NewPoints:
    """Points of some frames of a scan, as they come."""

    records: Points
    """(N,) arm frame."""
    frames: NDArray[np.int64]
    """(K,) numbers in the scan, ascending."""
    cameras_mm: Floats
    """(K, 3) where the camera was, arm frame."""
    too_fast: bool = False
    """Whether the sensor passed too fast."""

    @property
    def points_mm(self) -> Floats:
        """(N, 3) arm frame."""
        return positions_of(self.records)

    @property
    def views(self) -> Floats:
        """(N, 3) unit directions from the points to the camera."""
        away = self.cameras_mm[np.searchsorted(self.frames, self.records["frame"])] - self.points_mm
        return np.asarray(away / np.linalg.norm(away, axis=1)[:, None])


Show = Callable[[NewPoints], None]


@dataclass(frozen=True)
class ScanCalibration:
    """What a scan needs of a calibration, and whose it is."""

    id: str
    name: str
    arm: AnyArm
    camera: Camera
    plane: LaserPlane
    T_flange_sensor: Floats
    stripe_axis: Literal["u", "v"]
    arm_serial: str
    sensor_serial: str
    depth_range_mm: tuple[float, float]

    @cached_property
    def line_bounds(self) -> LineBounds | None:
        """Where in its pictures the line can be; None where that is anywhere."""
        return find_line_bounds(self.camera, self.plane, self.depth_range_mm, self.stripe_axis)

    @property
    def joint_names(self) -> tuple[str, ...] | None:
        """The names of the arm's joints; None for an arm that states poses."""
        if not isinstance(self.arm, Arm):
            return None
        return tuple(joint.name for joint in self.arm.joints)

    def sensor_poses(self, readings: Floats) -> Floats:
        """(N, 4, 4) ``T_arm_sensor`` at readings (N, k) of the arm."""
        return flange_poses(self.arm, readings) @ self.T_flange_sensor

    def points(self, stripes: Sequence[Stripe], poses: Floats) -> tuple[Floats, Floats]:
        """Points (N, 3) of stripes by the sensor's poses (Eq. 9), and how well each is known."""
        u, v, sigma_px = (
            np.concatenate([getattr(stripe, name) for stripe in stripes])
            for name in ("u", "v", "sigma_px")
        )
        count = np.array([len(stripe.u) for stripe in stripes])
        return scan_points(self.camera, self.plane, u, v, sigma_px, self.stripe_axis, count, poses)


class PointMaker:
    """Makes points, and knows how many and how far away the newest ones are."""

    def __init__(self, calibration: ScanCalibration, show: Show) -> None:
        self._calibration = calibration
        self._show = show
        self._made: deque[tuple[float, int]] = deque()
        self._distance = (-math.inf, 0.0)
        self._thinning = LineThinning(
            calibration.camera, calibration.plane, calibration.stripe_axis
        )
        self.frames_still = 0
        """Frames of a line that stood still, which gave no points."""

    @property
    def is_still(self) -> bool:
        """Whether the line that is seen just now stands still, so that it gives no points."""
        return self._thinning.is_still and self.distance_mm is not None

    @property
    def rate_per_s(self) -> float:
        """Points of the last second."""
        now = time.monotonic()
        return sum(count for at, count in tuple(self._made) if now - at <= RATE_WINDOW_S)

    @property
    def distance_mm(self) -> float | None:
        """The distance of the newest stripe from the camera; None where none was seen just now."""
        at_s, distance_mm = self._distance
        return distance_mm if time.monotonic() - at_s <= DISTANCE_AGE_S else None

    def add(
        self,
        cloud: CloudWriter,
        stripes: Sequence[Stripe],
        readings: Floats,
        numbers: NDArray[np.int64],
        too_fast: bool = False,
    ) -> Floats:
        """Points of some frames, to the cloud and to the display.

        Args:
            readings: (K, k) of the arm at the K frames.
            numbers: (K,) of the frames in the scan.
            too_fast: whether the sensor passed too fast.

        Returns:
            (K, 3) where the sensor was, mm, arm frame.
        """
        T_arm_sensor = self._calibration.sensor_poses(readings)
        points, spread = self._calibration.points(stripes, T_arm_sensor)
        count = [len(stripe.u) for stripe in stripes]
        intensity = np.concatenate([stripe.intensity for stripe in stripes])
        records = pack_points(points, intensity, spread, np.repeat(numbers, count))
        centre_mm = self._calibration.camera.centre_mm
        cameras_mm = T_arm_sensor[:, :3, :3] @ centre_mm + T_arm_sensor[:, :3, 3]
        self._note_distance(points[len(points) - count[-1] :], cameras_mm[-1])
        kept = self._thinning.keep(T_arm_sensor, np.array(count) > 0)
        self.frames_still += int((~kept).sum())
        records = records[np.repeat(kept, count)]
        cloud.append(records)
        self._count_points(len(records))
        if kept.any():
            self._show(NewPoints(records, numbers, cameras_mm, too_fast))
        return np.asarray(T_arm_sensor[:, :3, 3])

    def _count_points(self, count: int) -> None:
        now = time.monotonic()
        self._made.append((now, count))
        while self._made and now - self._made[0][0] > RATE_WINDOW_S:
            self._made.popleft()

    def _note_distance(self, stripe_mm: Floats, camera_mm: Floats) -> None:
        """Notes the distance of the last frame's points (N, 3) from its camera (3,), arm frame."""
        distances = np.linalg.norm(stripe_mm - camera_mm, axis=1)
        distances = distances[np.isfinite(distances)]
        if len(distances):
            self._distance = (time.monotonic(), float(np.median(distances)))
