"""The exposure settles within a few frames, wherever it begins."""

import numpy as np
import pytest

from app.station.devices.auto_exposure import TARGET, better_exposure_us, brightness
from hardware.interfaces import Frame
from tests.pictures import of_depth

RANGE_US = (20.0, 100_000.0)
RIGHT_US = 2000.0


def frame_of(exposure_us: float, bits: int, shift: int, stripe_only: bool) -> Frame:
    """A laser line on black, or a lit scene, that is right at ``RIGHT_US``."""
    white = (1 << bits) - 1
    rows, columns = np.arange(256)[:, None], np.arange(320)
    light = np.exp(-0.5 * ((rows - 120 - 0.05 * columns) / 2.0) ** 2)
    if not stripe_only:
        light = 0.3 + 0.7 * np.abs(np.sin(columns / 50) * np.sin(rows / 40))
    noise = np.random.default_rng(0).normal(0, 0.004, light.shape)
    grey = white * (0.02 + TARGET * light * exposure_us / RIGHT_US + noise)
    kind = np.uint8 if bits == 8 else np.uint16
    image = np.clip(np.rint(grey), 0, white).astype(np.uint16) << shift
    return Frame(0, 0, of_depth(image, kind), exposure_us, True)


@pytest.mark.parametrize("stripe_only", [True, False])
@pytest.mark.parametrize(("bits", "shift"), [(8, 0), (10, 0), (12, 4), (16, 0)])
@pytest.mark.parametrize("off", [1 / 60, 1 / 8, 1.5, 12, 45])
def test_the_exposure_settles_within_five_frames(
    bits: int, shift: int, off: float, stripe_only: bool
) -> None:
    exposure_us = RIGHT_US * off
    for _ in range(5):
        better = better_exposure_us(frame_of(exposure_us, bits, shift, stripe_only), RANGE_US)
        if better is None:
            break
        exposure_us = better
    settled = frame_of(exposure_us, bits, shift, stripe_only)
    assert better_exposure_us(settled, RANGE_US) is None
    assert brightness(settled) == pytest.approx(TARGET, rel=0.11)


def test_a_black_picture_goes_to_the_longest_exposure_and_a_white_one_to_the_shortest() -> None:
    for grey, end in ((0, RANGE_US[1]), (255, RANGE_US[0])):
        exposure_us = RIGHT_US
        for _ in range(5):
            image = np.full((100, 100), grey, np.uint8)
            frame = Frame(0, 0, image, exposure_us, True)
            exposure_us = better_exposure_us(frame, RANGE_US) or exposure_us
        assert exposure_us == end
