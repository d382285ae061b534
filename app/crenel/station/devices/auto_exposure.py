"""Determines an exposure from the pictures themselves."""

import numpy as np

from crenel.metrology.stripe import Stripe
from crenel_hardware.interfaces import Frame

TARGET = 0.7
TOLERANCE = 0.1
MOST_STEPS = 8
# The brightest part of the picture is this quantile: it ignores a hot pixel, but not a stripe of a
# thousand columns and a few rows.
BRIGHT_QUANTILE = 0.998
# Share of full scale from which a pixel is overexposed; if this share of pixels is, the exposure is
# reduced to an eighth, otherwise to a third.
LINE_QUANTILE = 0.9
OVEREXPOSED, MANY = 0.98, 0.05
LITTLE, MUCH = 1 / 3, 1 / 8
# An underexposed picture is mostly black level, so it does not show the full correction.
LONGEST_STEP = 16.0
DEPTHS = (10, 12, 14, 16)
"""Numbers of bits that a sensor may use of 16."""


def full_scale(frame: Frame) -> int:
    """The largest grey value of the frame's pixels.

    In 16-bit pixels, a sensor may use fewer bits, the upper or the lower ones: the smallest number
    that can hold the picture is assumed.
    """
    image = frame.image
    if image.dtype == np.uint8:
        return 255
    used = int(np.bitwise_or.reduce(image, axis=None))
    lowest = (used & -used).bit_length() - 1 if used else 0
    if used.bit_length() == 16 and 16 - lowest in DEPTHS:
        return ((1 << (16 - lowest)) - 1) << lowest
    return int((1 << next(depth for depth in DEPTHS if used < 1 << depth)) - 1)


def brightness(frame: Frame) -> float:
    """Level of the bright parts of the picture, as a share of full scale."""
    return float(np.quantile(frame.image[::2, ::2], BRIGHT_QUANTILE)) / full_scale(frame)


def better_exposure_us(frame: Frame, exposure_range_us: tuple[float, float]) -> float | None:
    """The exposure that would bring the bright parts to 70 %; None if they are there.

    A saturated picture does not show the amount, so the exposure is reduced more if more of it is
    saturated.
    """
    return _exposure_towards_us(brightness(frame), frame, exposure_range_us)


def better_line_exposure_us(
    frame: Frame, stripe: Stripe, exposure_range_us: tuple[float, float]
) -> float | None:
    """The same for the laser line, however small its part of the picture.

    Its bright tenth counts. If no line is detected, the picture counts.
    """
    if not len(stripe.u):
        return better_exposure_us(frame, exposure_range_us)
    level = float(np.quantile(stripe.intensity, LINE_QUANTILE)) / full_scale(frame)
    return _exposure_towards_us(level, frame, exposure_range_us)


def _exposure_towards_us(
    level: float, frame: Frame, exposure_range_us: tuple[float, float]
) -> float | None:
    """The exposure that brings a level of the frame to the target; None if it is there."""
    if abs(level - TARGET) <= TOLERANCE * TARGET:
        return None
    if level > OVEREXPOSED:
        clipped = np.mean(frame.image[::2, ::2] > OVEREXPOSED * full_scale(frame))
        factor = MUCH if clipped > MANY else LITTLE
    else:
        factor = min(TARGET / max(level, 1e-6), LONGEST_STEP)
    shortest, longest = exposure_range_us
    wanted = float(np.clip(frame.exposure_us * factor, shortest, longest))
    return None if abs(wanted - frame.exposure_us) < 0.01 * frame.exposure_us else wanted
