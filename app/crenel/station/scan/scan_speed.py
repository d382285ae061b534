"""Whether the sensor passes too fast over the part."""

import time
from dataclasses import dataclass

import numpy as np

from crenel.metrology.sensor.motion_blur import PassSpeed, pass_speed
from crenel.metrology.transforms import Floats
from crenel.station.devices.arm_device import StationArm

CHORD_NS = 10_000_000
"""Velocities are estimated over so much before the frame."""
AGE_S = 0.7


@dataclass(frozen=True)
class CurrentSpeed:
    """The speed of the newest frame with a stripe."""

    blur_mm: float
    """The way of the surface under the stripe during the exposure."""
    step_mm: float
    """From one frame's stripe to the next one's."""
    limit_mm: float
    """The limit of the blur."""

    @property
    def too_fast(self) -> bool:
        return self.blur_mm > self.limit_mm


class ScanSpeed:
    """Judges some frames of a scan, and counts for all."""

    def __init__(self, arm: StationArm, limit_mm: float | None) -> None:
        self.limit_mm = limit_mm
        """None: by the points themselves."""
        self.frames_too_fast = 0
        self.worst_mm = 0.0
        """The largest blur so far."""
        self._arm = arm
        self._last_ns: int | None = None
        self._newest: tuple[float, CurrentSpeed] | None = None

    @property
    def now(self) -> CurrentSpeed | None:
        """None where no stripe was seen just now."""
        newest = self._newest
        return newest[1] if newest and time.monotonic() - newest[0] <= AGE_S else None

    def reading_before(self, stamp_ns: int) -> Floats | None:
        """The arm's reading (k,) a little before a frame; None where it is unknown."""
        return self._arm.at(stamp_ns - CHORD_NS, 0.0)

    def judge(
        self,
        stripe_mm: Floats,
        spread_um: Floats,
        poses: tuple[Floats, Floats],
        stamp_ns: int,
        exposure_us: float,
        frames: int,
    ) -> bool:
        """Takes the last of some frames; whether it was too fast, False if that is unknown.

        Args:
            stripe_mm: (N, 3) its points in their order, sensor frame.
            spread_um: (N,) of the points.
            poses: ``T_arm_sensor`` a little before the frame (``before``), and at it.
            frames: how many there are, which are taken to be alike.
        """
        last_ns, self._last_ns = self._last_ns, stamp_ns
        if last_ns is None or stamp_ns <= last_ns:
            return False
        speed = pass_speed(
            stripe_mm,
            *poses,
            CHORD_NS / 1e9,
            exposure_us / 1e6,
            (stamp_ns - last_ns) / 1e9 / frames,
        )
        return speed is not None and self._note(speed, float(np.median(spread_um)) / 1e3, frames)

    def _note(self, speed: PassSpeed, uncertainty_mm: float, frames: int) -> bool:
        automatic_mm = speed.limit_mm(uncertainty_mm)
        limit_mm = automatic_mm if self.limit_mm is None else self.limit_mm
        now = CurrentSpeed(speed.blur_mm, speed.step_mm, limit_mm)
        self._newest = (time.monotonic(), now)
        self.worst_mm = max(self.worst_mm, speed.blur_mm)
        self.frames_too_fast += frames if now.too_fast else 0
        return now.too_fast
