"""Lines that are clipped broadly, with the light that the surface scatters about them; and bright
bands with sharp edges beside a line, or alone."""

import cv2
import numpy as np
import pytest

from crenel.metrology.stripe import StripeTracker, extract_stripe
from crenel.metrology.transforms import Floats
from tests.metrology.test_stripe_lines import (
    HEIGHT,
    WIDTH,
    beam,
    check_shares,
    errors,
    expose,
    room,
)

U = np.arange(WIDTH, dtype=np.float64)


def band(light: Floats, width_px: float, level: float, tilt: float = 0.05) -> Floats:
    """A band over the light of a scene, with edges as sharp as a lens draws them."""
    rows = 160 + tilt * U
    inside = np.abs(np.arange(HEIGHT)[:, None] - rows) <= width_px / 2
    cover = cv2.GaussianBlur(inside.astype(np.float32), (0, 0), 1.0)
    return np.asarray(light * (1 - cover) + level * cover)


def scattered(rows: Floats, height: float, reach_px: float, seed: int) -> Floats:
    """Speckled light about a line that fades slowly: its edge is ragged where it is clipped."""
    rng = np.random.default_rng(seed)
    off = np.abs(np.arange(HEIGHT)[:, None] - rows)
    grain = cv2.GaussianBlur(rng.exponential(1.0, off.shape), (0, 0), 1.5)
    return np.asarray(height * np.exp(-off / reach_px) * (0.5 + 0.5 * grain / grain.mean()))


@pytest.mark.parametrize("reach_px", [12.0, 30.0])
def test_a_line_whose_scattered_light_is_clipped_is_found(reach_px: float) -> None:
    for seed in range(3):
        rows = HEIGHT / 2 + 0.2 * (U - WIDTH / 2)
        light = 20 + beam(rows, 8, 2000) + scattered(rows, 520, reach_px, seed)
        stripe = extract_stripe(expose(light, seed))
        check_shares(stripe, rows, 30, 0.97)
        assert float(np.median(np.abs(errors(stripe, rows)))) < 1.0


def test_a_clipped_line_whose_flanks_no_pixel_shows_lies_between_its_edges() -> None:
    rows = HEIGHT / 2 + 0.3 * (U - WIDTH / 2)
    light = np.where(np.abs(np.arange(HEIGHT)[:, None] - rows) <= 5, 255.0, 0.0)
    stripe = extract_stripe(light.astype(np.uint8))
    assert len(stripe.u) > 0.98 * WIDTH
    off = errors(stripe, rows)
    assert np.sqrt(np.mean(off**2)) < 0.3
    assert 0.5 < np.sqrt(np.mean((off / stripe.sigma_px) ** 2)) < 1.5


@pytest.mark.parametrize("level", [200.0, 400.0])
@pytest.mark.parametrize("width_px", [20.0, 25.0, 50.0])
def test_a_line_is_found_beside_a_brighter_band(width_px: float, level: float) -> None:
    for seed, line_px in enumerate((4.0, 8.0)):
        rows = 450 + 30 * np.sin(U / 200)
        light = band(room(seed, 50) + beam(rows, line_px, 150), width_px, level)
        check_shares(extract_stripe(expose(light, seed)), rows, line_px, 0.95, 0.005)


def test_a_saturated_line_is_found_beside_a_clipped_band() -> None:
    rows = 450 + 30 * np.sin(U / 200)
    light = band(20 + beam(rows, 10, 900), 40, 400)
    check_shares(extract_stripe(expose(light, 1)), rows, 20, 0.97)


def test_a_wide_band_alone_is_no_line() -> None:
    for width_px in (45.0, 70.0):
        image = expose(band(np.full((HEIGHT, WIDTH), 30.0), width_px, 400), 2)
        assert not len(extract_stripe(image).u)


def test_a_line_is_followed_beside_a_band() -> None:
    tracker = StripeTracker()
    for turn in range(12):
        rows = 450 + 2.0 * turn + 30 * np.sin(U / 200)
        light = band(20 + beam(rows, 10, 900), 20, 400)
        check_shares(tracker.extract(expose(light, turn)), rows, 20, 0.97)
