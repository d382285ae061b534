"""The plane of the laser light, in the sensor frame."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from crenel.errors import OperationError
from crenel.messages.limits import beside_limit
from crenel.messages.message import message
from crenel.metrology.robust import median
from crenel.metrology.sensor.camera import Camera, rays
from crenel.metrology.transforms import Floats

LEAST_ANGLE_DEG = 3.0


@dataclass(frozen=True)
class LaserPlane:
    """``normal . x = offset_mm`` in the sensor frame, the normal (3,) of unit length."""

    normal: Floats
    offset_mm: float

    def in_frame(self, T_new_old: Floats) -> "LaserPlane":
        """The same plane in another frame."""
        normal = T_new_old[:3, :3] @ self.normal
        return LaserPlane(normal, float(self.offset_mm + normal @ T_new_old[:3, 3]))

    def apply_step(self, step: Floats) -> "LaserPlane":
        """The plane after a step (3,): tilts along ``tangents(normal)`` (rad), then the offset
        (mm)."""
        normal = self.normal + step[:2] @ tangents(self.normal)
        length = float(np.linalg.norm(normal))
        return LaserPlane(normal / length, (self.offset_mm + float(step[2])) / length)


def in_frame(camera: Camera, plane: LaserPlane, T_new_old: Floats) -> tuple[Camera, LaserPlane]:
    """The same camera and laser plane in another sensor frame.

    Args:
        camera, plane: in the old sensor frame.
        T_new_old: (4, 4).

    Returns:
        Camera and plane in the new sensor frame; intrinsics and distortion are unchanged.
    """
    rotation = camera.rotation @ T_new_old[:3, :3].T
    shift_mm = camera.translation_mm - rotation @ T_new_old[:3, 3]
    moved = replace(camera, rotation=rotation, translation_mm=shift_mm)
    return moved, plane.in_frame(T_new_old)


def tangents(normal: Floats) -> Floats:
    """Two unit vectors in a plane, perpendicular to each other.

    Args:
        normal: (3,) unit length.

    Returns:
        (2, 3); tilts of a laser plane are stated along these two.
    """
    least = int(np.argmin(np.abs(normal)))
    axis = [float(k == least) for k in range(3)]
    x, y, z = _cross([float(value) for value in normal], axis)
    length = math.sqrt(x * x + y * y + z * z)
    first = [x / length, y / length, z / length]
    return np.array([first, _cross([float(value) for value in normal], first)])


def _cross(a: Sequence[float], b: Sequence[float]) -> list[float]:
    """Cross product of two single vectors; the library function takes twenty times as long."""
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def meet_levels(camera: Camera, uv_px: Floats, z_mm: Floats | float) -> Floats:
    """Intersections of the rays of pixels with planes of constant z of the sensor frame.

    Args:
        uv_px: (N, 2) distorted pixels.
        z_mm: one height, or (N,) heights.

    Returns:
        (N, 3) mm in the sensor frame; not finite if a ray is parallel to the plane.
    """
    origin, along = rays(camera, uv_px)
    with np.errstate(divide="ignore", invalid="ignore"):
        depth = (z_mm - origin[2]) / along[:, 2]
    return np.asarray(origin + depth[:, None] * along)


def refuse_edge_on(plane: LaserPlane, sight: Floats) -> None:
    """Refuses a laser plane that contains the line of sight.

    Args:
        sight: (M, 3) lines of sight to the stripe, sensor frame.

    Raises:
        OperationError: ``laser-through-camera``, if the median angle between the lines of
            sight and the plane is less than ``LEAST_ANGLE_DEG``.
    """
    sine = np.abs(sight @ plane.normal) / np.linalg.norm(sight, axis=1)
    angle = float(np.degrees(np.arcsin(median(sine))))
    if angle < LEAST_ANGLE_DEG:
        shown, least = beside_limit(angle, LEAST_ANGLE_DEG, "°", 1)
        raise OperationError(
            "laser-through-camera",
            message(
                "camera-looks-along-laser-plane-deg",
                angle=shown,
                limit=least,
            ),
            message("plane-through-cameras-centre-gives-no"),
            message("camera-must-look-stripe-side-check"),
        )
