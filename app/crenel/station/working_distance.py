"""Distance of the stripe from the camera, relative to the calibrated range."""

from dataclasses import dataclass
from typing import Literal

import numpy as np

from crenel.metrology.sensor.camera import Camera
from crenel.metrology.sensor.laser_plane import LaserPlane
from crenel.metrology.sensor.triangulation import sensor_points
from crenel.metrology.stripe import Stripe
from crenel.metrology.transforms import Floats


@dataclass(frozen=True)
class Distance:
    """Working distance at the middle of the newest stripe."""

    mm: float
    near_mm: float
    far_mm: float
    state: Literal["in", "near", "far"]


def classify_distance(mm: float, range_mm: tuple[float, float]) -> Distance:
    """Whether a distance is within the calibrated range, or on which side of it."""
    near_mm, far_mm = range_mm
    state: Literal["in", "near", "far"] = "in"
    if mm < near_mm:
        state = "near"
    elif mm > far_mm:
        state = "far"
    return Distance(round(mm, 1), near_mm, far_mm, state)


ALONG, ACROSS = 17, 65
"""Number of points of each drawn line, and of the search for each."""
Line = tuple[tuple[float, float], ...]


@dataclass(frozen=True)
class Band:
    """``near`` and ``far`` are lines in the picture, empty if they are outside it."""

    near_mm: float
    far_mm: float
    near: Line
    far: Line


class WorkingRange:
    """From one calibration; unknown for a picture of another size."""

    def __init__(
        self,
        camera: Camera,
        plane: LaserPlane,
        range_mm: tuple[float, float],
        axis: Literal["u", "v"],
    ) -> None:
        self._camera, self._plane, self._range_mm = camera, plane, range_mm
        near_mm, far_mm = range_mm
        self.band = Band(near_mm, far_mm, *_lines(camera, plane, range_mm, axis))

    def fits(self, width_px: int, height_px: int) -> bool:
        return (width_px, height_px) == (self._camera.width_px, self._camera.height_px)

    def stripe_distance(self, stripe: Stripe) -> Distance | None:
        """At the middle of a line; None if it does not meet the plane."""
        if not len(stripe.u):
            return None
        away = _distances(self._camera, self._plane, stripe.uv_px[:: max(1, len(stripe.u) // 100)])
        away = away[np.isfinite(away)]
        return classify_distance(float(np.median(away)), self._range_mm) if len(away) else None


def _distances(camera: Camera, plane: LaserPlane, uv_px: Floats) -> Floats:
    points = sensor_points(camera, plane, uv_px)
    return np.asarray(np.linalg.norm(points - camera.centre_mm, axis=1))


def _lines(
    camera: Camera, plane: LaserPlane, range_mm: tuple[float, float], axis: Literal["u", "v"]
) -> tuple[Line, Line]:
    """The lines of each distance of the range, from one side of the picture to the other."""
    width, height = camera.width_px - 1.0, camera.height_px - 1.0
    along = np.linspace(0, width if axis == "u" else height, ALONG)
    across = np.linspace(0, height if axis == "u" else width, ACROSS)
    first, second = np.meshgrid(along, across, indexing="ij")
    u, v = (first, second) if axis == "u" else (second, first)
    away = _distances(camera, plane, np.column_stack([u.ravel(), v.ravel()])).reshape(u.shape)
    near, far = (
        tuple(
            (round(float(at), 1), round(place, 1))
            if axis == "u"
            else (round(place, 1), round(float(at), 1))
            for at, row in zip(along, away, strict=True)
            if (place := _crossing(across, row - mm)) is not None
        )
        for mm in range_mm
    )
    return near, far


def _crossing(places: Floats, off: Floats) -> float | None:
    """The position of the first change of sign; None if there is none."""
    known = np.isfinite(off)
    places, off = places[known], off[known]
    changes = np.flatnonzero(off[:-1] * off[1:] <= 0)
    if not len(changes):
        return None
    i = int(changes[0])
    step = off[i + 1] - off[i]
    return float(places[i] - off[i] * (places[i + 1] - places[i]) / step) if step else None
