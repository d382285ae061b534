"""What a profile camera sends: the rows of the laser line, one profile for each exposure."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from crenel_hardware.simulator.devices.gige_camera.gvsp_parts import IMAGE_2D, IMAGE_3D, BlockPart
from crenel_hardware.simulator.devices.gige_camera.pixels import CODES, ROWS_CODE, RawImage
from crenel_hardware.simulator.devices.gige_camera.profile_features import (
    EXTRACTION,
    INVALID,
    OFFSET_PX,
    REFLECTANCE,
    SCALE_PX,
    SOURCE,
    STANDARD,
    UNCALIBRATED,
)
from crenel_hardware.simulator.devices.gige_camera.registers import (
    MULTIPART,
    STREAM_CONFIGURATION,
    RegisterMap,
)

FindLine = Callable[[RawImage], tuple[NDArray[np.float64], NDArray[np.uint8]]]
"""The row of the line and its brightness in each column (W,) of an image (H, W); the row is NaN
without a line."""
_MOST = 0xFFFF


class ProfileBuffer:
    """Collects profiles until a buffer is full."""

    def __init__(self, registers: RegisterMap, find_line: FindLine) -> None:
        self._registers, self._find_line = registers, find_line
        self._profiles: list[tuple[bytes, bytes]] = []

    def clear(self) -> None:
        """A new acquisition begins."""
        self._profiles.clear()

    def add(self, image: RawImage) -> tuple[BlockPart, ...] | None:
        """Finds the line in an image (H, W) of the whole sensor; returns a buffer that is full: the
        rows, and their brightness if that is wanted."""
        x, y, width_px, height_px = self._registers.region(SOURCE)
        rows, brightness = self._find_line(image[y : y + height_px, x : x + width_px])
        self._profiles.append((self._encode(rows, height_px), brightness.tobytes()))
        if len(self._profiles) < self._registers.integer("Height", EXTRACTION):
            return None
        numbers, grey = (b"".join(each) for each in zip(*self._profiles, strict=True))
        self._profiles.clear()
        parts = (
            BlockPart(IMAGE_3D, ROWS_CODE, numbers),
            BlockPart(IMAGE_2D, CODES["Mono8"], grey),
        )
        return parts if self.sends_brightness else parts[:1]

    @property
    def sends_brightness(self) -> bool:
        """Whether it is enabled, and a block may have several parts."""
        enabled = self._registers.integer("ComponentEnable", REFLECTANCE) == 1
        return enabled and bool(self._registers.number(STREAM_CONFIGURATION) & MULTIPART)

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
