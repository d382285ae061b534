"""Finding an exposure from the pictures themselves."""

import numpy as np

from hardware.interfaces import Frame

TARGET = 0.7
TOLERANCE = 0.1
MOST_STEPS = 8
# The brightest part of the picture is this quantile: a hot pixel does not count,
# a stripe of a thousand columns and a few rows does.
BRIGHT_QUANTILE = 0.998


def full_scale(frame: Frame) -> int:
    """The largest grey value that the frame's pixels can hold."""
    return int(np.iinfo(frame.image.dtype).max)


def brightness(frame: Frame) -> float:
    """The level of the picture's bright parts, as a share of full scale."""
    return float(np.quantile(frame.image[::2, ::2], BRIGHT_QUANTILE)) / full_scale(frame)


def better_exposure_us(frame: Frame, exposure_range_us: tuple[float, float]) -> float | None:
    """The exposure that would bring the bright parts to 70 %; None when they are there.

    A saturated picture does not say by how much, so it is cut to a third.
    """
    level = brightness(frame)
    if abs(level - TARGET) <= TOLERANCE * TARGET:
        return None
    factor = 1 / 3 if level > 0.98 else float(np.clip(TARGET / max(level, 0.02), 0.25, 4.0))
    shortest, longest = exposure_range_us
    wanted = float(np.clip(frame.exposure_us * factor, shortest, longest))
    return None if abs(wanted - frame.exposure_us) < 0.01 * frame.exposure_us else wanted
