"""Thins the lines of a sensor that stands still: their points repeat those that are there."""

from typing import Literal

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.sensor.camera import Camera
from crenel.metrology.sensor.laser_plane import LaserPlane
from crenel.metrology.sensor.triangulation import sensor_points
from crenel.metrology.transforms import Floats

LINES_AT_A_PLACE = 10
"""While no point of the line moves by as much as two neighbouring points lie apart, so many lines
are kept: enough for a mean with a third of the noise."""
ALONG, ACROSS = (0.1, 0.5, 0.9), tuple(np.linspace(0.1, 0.9, 9))
"""Where in the picture the motion is judged, along the line and across it."""


class LineThinning:
    """Judges the lines of one sensor in the order of their frames."""

    def __init__(self, camera: Camera, plane: LaserPlane, axis: Literal["u", "v"]) -> None:
        """``axis``: of the picture, along which the line has a point for each pixel."""
        self._places_mm, self._spacings_mm = _places(camera, plane, axis)
        self._anchor: Floats | None = None
        self._kept = 0
        self.is_still = False
        """The newest line was left out."""

    def keep(self, T_arm_sensor: Floats, has_line: NDArray[np.bool_]) -> NDArray[np.bool_]:
        """Which of the next frames (F,) are kept; those without a line or a pose are.

        Args:
            T_arm_sensor: (F, 4, 4), NaN where it is unknown.
            has_line: (F,)
        """
        kept = np.ones(len(T_arm_sensor), dtype=np.bool_)
        judged = np.flatnonzero(has_line & np.isfinite(T_arm_sensor[:, 0, 0]))
        if not len(self._spacings_mm):
            return kept
        rotation, shift = T_arm_sensor[judged, None, :3, :3], T_arm_sensor[judged, None, :3, 3]
        moved = (rotation @ self._places_mm[:, :, None])[..., 0] + shift
        for frame, places_mm in zip(judged.tolist(), moved, strict=True):
            kept[frame] = self._is_kept(places_mm)
        return kept

    def _is_kept(self, places_mm: Floats) -> bool:
        if self._anchor is None or self._has_left(self._anchor, places_mm):
            self._anchor, self._kept = places_mm, 0
        self._kept += 1
        self.is_still = self._kept > LINES_AT_A_PLACE
        return not self.is_still

    def _has_left(self, before_mm: Floats, now_mm: Floats) -> bool:
        square = np.square(now_mm - before_mm).sum(axis=1)
        return bool((square >= self._spacings_mm**2).any())


def _places(camera: Camera, plane: LaserPlane, axis: Literal["u", "v"]) -> tuple[Floats, Floats]:
    """Points (K, 3) of the laser plane in the sensor frame, and how far apart neighbouring points
    of a line lie there (K,), mm."""
    size = np.array([camera.width_px, camera.height_px])
    shares = [(a, b) if axis == "u" else (b, a) for a in ALONG for b in ACROSS]
    pixels = np.array(shares) * size
    step = np.array([1.0, 0.0] if axis == "u" else [0.0, 1.0])
    at, beside = (sensor_points(camera, plane, uv) for uv in (pixels, pixels + step))
    spacings = np.linalg.norm(beside - at, axis=1)
    seen = np.isfinite(spacings) & (spacings > 0)
    return at[seen], spacings[seen]
