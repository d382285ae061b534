"""Pictures of any size and content: points lie in the picture, in ascending order, with a
deviation; nothing is read or written beside it (see ``.ci/sanitize``)."""

from typing import get_args

import numpy as np
import pytest
from numpy.typing import NDArray

from crenel.metrology.stripe import (
    PeakChoice,
    Stripe,
    StripeSettings,
    StripeTracker,
    extract_stripe,
)
from tests.running.usual import usual

Picture = NDArray[np.uint8] | NDArray[np.uint16]


def any_picture(rng: np.random.Generator) -> Picture:
    """Noise, lines of any width, plateaus and lit halves, in 8 or 16 bits."""
    height, width = int(rng.integers(1, 400)), int(rng.integers(1, 500))
    light = rng.uniform(0, 60) * rng.standard_normal((height, width)) + rng.uniform(0, 100)
    for _ in range(int(rng.integers(0, 4))):
        rows = rng.uniform(0, height) + rng.uniform(-2, 2) * np.arange(width)
        half = rng.uniform(0.2, 60)
        off = np.abs(np.arange(height)[:, None] - rows) / half
        light += rng.uniform(0, 900) * np.exp(-(off ** float(rng.choice([1.0, 2.0, 8.0]))))
    if rng.random() < 0.3:
        light[: height // 2] += 200
    if rng.random() < 0.5:
        return np.clip(light, 0, rng.integers(60, 256)).astype(np.uint8)
    gain = float(rng.choice([4.0, 16.0, 257.0]))
    return np.clip(gain * light, 0, 255 * gain).astype(np.uint16)


def any_settings(rng: np.random.Generator) -> StripeSettings:
    least = None if rng.random() < 0.7 else float(rng.uniform(0, 5))
    return StripeSettings(
        threshold=None if rng.random() < 0.7 else float(rng.uniform(0, 100)),
        min_width_px=least,
        max_width_px=None if rng.random() < 0.7 else (least or 0) + float(rng.uniform(1, 90)),
        choice=str(rng.choice(get_args(PeakChoice))),  # type: ignore[arg-type]
        smoothing_px=0.0 if rng.random() < 0.7 else float(rng.uniform(0.1, 20)),
    )


def check_points(stripe: Stripe, image: Picture, axis: str) -> None:
    along, across = stripe.along_across
    height, width = image.shape if axis == "u" else image.shape[::-1]
    assert np.all(np.diff(along) > 0)
    assert np.all((along >= 0) & (along < width))
    assert np.all((across > -height) & (across < 2 * height))
    assert np.isfinite(across).all()
    assert np.all(np.isfinite(stripe.sigma_px) & (stripe.sigma_px >= 0))


@pytest.mark.parametrize("seed", usual(range(60), 12, pytest.mark.soak))
def test_points_of_any_picture_lie_in_it(seed: int) -> None:
    rng = np.random.default_rng(seed)
    image, settings = any_picture(rng), any_settings(rng)
    where = rng.random(image.shape) < 0.9 if rng.random() < 0.3 else None
    for axis in ("u", "v"):
        check_points(extract_stripe(image, axis, where, settings), image, axis)
        tracker = StripeTracker(axis, where, settings)
        for turn in range(10):
            moved = np.roll(image, 3 * turn, axis=0 if axis == "u" else 1)
            check_points(tracker.extract(moved), image, axis)
