"""The simulated sensor's optics: a lens with distortion, and a plane of laser light."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from crenel.native.arguments import F32, F64, Array, Function
from crenel_hardware.simulator.devices.kinematics import Floats
from crenel_hardware.simulator.native import SIMULATOR

_sight_lines = Function(
    SIMULATOR, "sight_lines", Array(F64, 9), Array(F32, "height", "width", 2, written=True)
)


@dataclass(frozen=True)
class Optics:
    """A camera and where it sits in the sensor frame.

    ``distortion`` is k1, k2, p1, p2, k3 of Brown's model; pixel (0, 0) is the
    centre of the top-left one.
    """

    width_px: int
    height_px: int
    fx_px: float
    fy_px: float
    cx_px: float
    cy_px: float
    distortion: tuple[float, float, float, float, float]
    T_cam_sensor: Floats  # (4, 4)

    @property
    def centre_mm(self) -> Floats:
        """(3,) optical centre in the sensor frame."""
        return np.asarray(np.linalg.inv(self.T_cam_sensor)[:3, 3])

    @property
    def lens(self) -> Floats:
        """(9,) fx, fy, cx, cy and the distortion."""
        return np.array([self.fx_px, self.fy_px, self.cx_px, self.cy_px, *self.distortion])

    @property
    def matrix(self) -> Floats:
        """(3, 3) intrinsic matrix."""
        return np.array(
            [[self.fx_px, 0, self.cx_px], [0, self.fy_px, self.cy_px], [0, 0, 1]], dtype=np.float64
        )


@dataclass(frozen=True)
class LightPlane:
    """A thin fan of light; all in the sensor frame. ``normal . x = offset_mm``."""

    normal: tuple[float, float, float]
    offset_mm: float
    emitter_mm: tuple[float, float, float]
    """Where the fan comes from; lies in the light plane."""
    sigma_mm: float = 0.075
    """Half thickness of the light plane's Gaussian profile."""
    half_angle_rad: float = 0.42


def light_plane_through(
    normal: Floats, point_mm: Floats, emitter_mm: Floats, sigma_mm: float = 0.075
) -> LightPlane:
    """The light plane through a point with a normal; the emitter is moved into it."""
    n = np.asarray(normal) / np.linalg.norm(normal)
    offset = float(n @ point_mm)
    at = np.asarray(emitter_mm) - (n @ emitter_mm - offset) * n
    nx, ny, nz = (float(v) for v in n)
    ex, ey, ez = (float(v) for v in at)
    return LightPlane((nx, ny, nz), offset, (ex, ey, ez), sigma_mm)


def camera_looking_at(
    eye_mm: Floats, target_mm: Floats, right_hint: Floats, roll_rad: float
) -> Floats:
    """``T_cam_sensor`` (4, 4) of a camera at ``eye_mm`` that looks at ``target_mm``.

    The image's +u follows ``right_hint``; ``roll_rad`` then turns the camera about
    its own axis.
    """
    forward = np.asarray(target_mm) - np.asarray(eye_mm)
    forward = forward / np.linalg.norm(forward)
    down = np.cross(forward, right_hint)
    down = down / np.linalg.norm(down)
    right = np.cross(down, forward)
    c, s = np.cos(roll_rad), np.sin(roll_rad)
    R = np.stack([c * right + s * down, -s * right + c * down, forward])
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = R, -R @ np.asarray(eye_mm)
    return T


def distort(optics: Optics, x: Floats, y: Floats) -> tuple[Floats, Floats]:
    """What Brown's model makes of ideal image coordinates x/z, y/z."""
    k1, k2, p1, p2, k3 = optics.distortion
    r2 = x * x + y * y
    radial = 1 + k1 * r2 + k2 * r2**2 + k3 * r2**3
    return (
        x * radial + 2 * p1 * x * y + p2 * (r2 + 2 * x * x),
        y * radial + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y,
    )


def to_pixels(optics: Optics, points_mm: Floats) -> Floats:
    """Pixels (N, 2) that points (N, 3) of the sensor frame are seen at."""
    p = np.asarray(points_mm) @ optics.T_cam_sensor[:3, :3].T + optics.T_cam_sensor[:3, 3]
    x, y = distort(optics, p[:, 0] / p[:, 2], p[:, 1] / p[:, 2])
    return np.column_stack([optics.fx_px * x + optics.cx_px, optics.fy_px * y + optics.cy_px])


def sight_lines(optics: Optics) -> NDArray[np.float32]:
    """(H + 2, W + 2, 2): x/z and y/z of the ray through every pixel's centre, lens undone.

    One pixel wider on every side than the image, so that each pixel has neighbours.
    """
    lines = np.empty((optics.height_px + 2, optics.width_px + 2, 2), dtype=np.float32)
    _sight_lines(optics.lens, lines)
    return lines
