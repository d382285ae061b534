"""What a profile camera sends: the rows of the laser line, one profile for each exposure."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from hardware.simulator.devices.gige_camera.pixels import RawImage
from hardware.simulator.devices.gige_camera.profile_features import (
    EXTRACTION,
    INVALID,
    OFFSET_PX,
    SCALE_PX,
    SOURCE,
    STANDARD,
    UNCALIBRATED,
)
from hardware.simulator.devices.gige_camera.registers import RegisterMap

FindRows = Callable[[RawImage], NDArray[np.float64]]
"""The row of the line in each column (W,) of an image (H, W); NaN without a line."""
_MOST = 0xFFFF


class ProfileBuffer:
    """Collects profiles until a buffer is full."""

    def __init__(self, registers: RegisterMap, find_rows: FindRows) -> None:
        self._registers, self._find_rows = registers, find_rows
        self._profiles: list[bytes] = []

    def clear(self) -> None:
        """A new acquisition begins."""
        self._profiles.clear()

    def add(self, image: RawImage) -> bytes | None:
        """Finds the line in an image (H, W) of the whole sensor; returns a buffer that is full."""
        x, y, width_px, height_px = self._registers.region(SOURCE)
        rows = self._find_rows(image[y : y + height_px, x : x + width_px])
        self._profiles.append(self._encode(rows, height_px))
        if len(self._profiles) < self._registers.integer("Height", EXTRACTION):
            return None
        data = b"".join(self._profiles)
        self._profiles.clear()
        return data

    def _encode(self, rows: NDArray[np.float64], height_px: int) -> bytes:
        numbers = np.full(len(rows), INVALID, "<u2")
        if self._registers.integer("Scan3dOutputMode") != UNCALIBRATED:
            return numbers.tobytes()  # it has no calibration of its own
        if self._registers.integer("RangeAxis") != STANDARD:
            rows = height_px - 1 - rows
        found = np.isfinite(rows)
        steps = np.rint((rows[found] - OFFSET_PX) / SCALE_PX)
        numbers[found] = np.clip(steps, INVALID + 1, _MOST)
        return numbers.tobytes()
