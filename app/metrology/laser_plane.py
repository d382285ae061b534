"""The plane of the laser's light, in the sensor frame."""

from dataclasses import dataclass

from app.metrology.frames import Floats


@dataclass(frozen=True)
class LaserPlane:
    """``normal . x = offset_mm`` in the sensor frame, the normal (3,) of unit length."""

    normal: Floats
    offset_mm: float
