"""Motion of a sensor on an arm between two calibrations, estimated from the points that they give.

Parameters are never compared: focal length and distance have such similar effects that each may
differ by much while every point stays.
"""

from dataclasses import dataclass

import numpy as np

from crenel.metrology.sensor.camera import Camera
from crenel.metrology.sensor.laser_plane import LaserPlane
from crenel.metrology.sensor.triangulation import sensor_points
from crenel.metrology.transforms import Floats, apply, rigid_fit, vector_from_rotation

ARCSEC = float(np.degrees(1.0) * 3600)
LEAST_POINTS = 6


@dataclass(frozen=True)
class MountedSensor:
    """A calibrated sensor; ``T_flange_sensor`` is its mounting."""

    camera: Camera
    plane: LaserPlane
    T_flange_sensor: Floats


@dataclass(frozen=True)
class Drift:
    """Changes from one calibration to the next, in the flange frame."""

    sensor_um: float
    """Shift of the middle of the measuring volume, by the rigid motion that fits all its points
    best."""
    sensor_arcsec: float
    """The angle of that motion."""
    plane_um: float
    """Shift of the laser plane in the middle of the volume, along its normal."""
    plane_arcsec: float
    """The angle between the laser planes."""
    points_um: float
    """Rms shift of the points, due to the motion and the change of shape."""


def measure_drift(before: MountedSensor, after: MountedSensor, uv_px: Floats) -> Drift | None:
    """How far the sensor moved between two calibrations, by the points that they give.

    Args:
        before, after: two calibrations of one sensor on one arm.
        uv_px: (N, 2) pixels of the measuring volume.

    Returns:
        Shifts in µm and angles in arcsec, flange frame; None if fewer than ``LEAST_POINTS`` pixels
        give a point with both.
    """
    old, new = (_points(sensor, uv_px) for sensor in (before, after))
    common = np.isfinite(old).all(axis=1) & np.isfinite(new).all(axis=1)
    if common.sum() < LEAST_POINTS:
        return None
    old, new = old[common], new[common]
    T_after_before = rigid_fit(new, old)
    turned = vector_from_rotation(T_after_before[:3, :3])
    was, now = (_normal(sensor) for sensor in (before, after))
    now = now if now @ was > 0 else -now
    middle = new.mean(axis=0) - old.mean(axis=0)
    return Drift(
        sensor_um=float(1e3 * np.linalg.norm(middle)),
        sensor_arcsec=float(ARCSEC * np.linalg.norm(turned)),
        plane_um=float(1e3 * abs(now @ middle)),
        plane_arcsec=float(ARCSEC * np.arctan2(np.linalg.norm(np.cross(was, now)), was @ now)),
        points_um=float(1e3 * np.sqrt(np.mean(np.sum((new - old) ** 2, axis=1)))),
    )


def _points(sensor: MountedSensor, uv_px: Floats) -> Floats:
    return apply(sensor.T_flange_sensor, sensor_points(sensor.camera, sensor.plane, uv_px))


def _normal(sensor: MountedSensor) -> Floats:
    return np.asarray(sensor.T_flange_sensor[:3, :3] @ sensor.plane.normal)
