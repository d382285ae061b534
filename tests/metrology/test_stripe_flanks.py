"""Overexposed lines: placed by their flanks, wherever the clipped core lies."""

import numpy as np
import pytest
from numpy.typing import NDArray

from crenel.metrology.stripe import AUTOMATIC, Stripe, extract_stripe, find_stripe
from crenel.metrology.stripe.found_line import FoundLine
from crenel.metrology.stripe.one_scale import extract_at
from crenel.metrology.stripe.scales import THIN_FACTOR, wide_factors
from crenel.metrology.transforms import Floats
from tests.bench.stripe.clipped import KINDS, simulate_clipped_frame
from tests.uncertainty_ratio import ratio_of_pulls, rows_of

WIDTH, HEIGHT = 640, 320
U = np.arange(WIDTH)
CENTRE = 150 + 30 * np.sin(U / 130) + 0.05 * U


def taken(signal: Floats, background: Floats | float = 20.0, seed: int = 0) -> NDArray[np.uint8]:
    """What an 8-bit sensor makes of light: read and shot noise, clipped at 255."""
    rng = np.random.default_rng(seed)
    grey = signal + background
    noisy = grey + rng.normal(0, 1, grey.shape) * np.sqrt(4 + 0.1 * grey)
    return np.clip(np.rint(noisy), 0, 255).astype(np.uint8)


def away() -> Floats:
    """(HEIGHT, WIDTH) distance of every pixel from the line's middle."""
    return np.asarray(np.arange(HEIGHT)[:, None] - CENTRE)


def beam(width_px: float, height: float | Floats) -> Floats:
    return np.asarray(height * np.exp(-0.5 * (away() / width_px) ** 2))


def errors(stripe: Stripe) -> Floats:
    return np.asarray(stripe.v - CENTRE[stripe.u.astype(int)])


@pytest.mark.parametrize(
    ("name", "signal"),
    [
        ("a little", beam(3.0, 600)),
        ("much", beam(2.0, 3000)),
        ("broad", beam(5.0, 2000)),
        ("scattered in paper", 4000 * np.exp(-np.abs(away()) / 2.2)),
        ("textured", beam(2.5, 700 * np.exp(0.5 * np.sin(U / 5)))),
    ],
)
def test_an_overexposed_line_lies_between_its_flanks(name: str, signal: Floats) -> None:
    image = taken(signal)
    assert np.median((image >= 255).sum(axis=0)) >= 5, name
    stripe = extract_stripe(image)
    error = errors(stripe)
    assert len(stripe.u) > 0.98 * WIDTH
    assert np.sqrt(np.mean(error**2)) < 0.03
    assert abs(np.mean(error)) < 0.01
    ratio_of_pulls(rows_of(error / stripe.sigma_px, 32)).assert_within()


def test_a_patch_that_is_overexposed_goes_on_where_the_line_ends() -> None:
    height = 120 + 1500 * np.exp(-0.5 * ((U - 300) / 70) ** 2)
    stripe = extract_stripe(taken(beam(2.5, height)))
    error, clipped = errors(stripe), height[stripe.u.astype(int)] > 400
    assert len(stripe.u) > 0.98 * WIDTH
    assert clipped.sum() > 200
    assert np.sqrt(np.mean(error[clipped] ** 2)) < 0.03
    assert np.max(np.abs(error)) < 0.3


def test_a_highlight_beside_the_line_is_none_of_it() -> None:
    ring = np.hypot(U[None] - 400, np.arange(HEIGHT)[:, None] - 290)
    signal = beam(2.0, 150) + 900 * np.exp(-0.5 * ((ring - 60) / 4) ** 2)
    stripe = extract_stripe(taken(signal))
    beside = (stripe.u < 320) | (stripe.u > 480)
    assert beside.sum() > 0.95 * (WIDTH - 160)
    assert np.max(np.abs(errors(stripe)[beside])) < 0.3


def test_half_on_black_half_on_white_a_point_says_that_it_is_unsure() -> None:
    """Light scattered in the white half carries that flank further out."""
    light = np.exp(-np.abs(away()) / 2.0)
    white = np.ones((HEIGHT, WIDTH))
    white[:, 250:330] = np.where(away()[:, 250:330] > 0, 1.0, 0.2)
    stripe = extract_stripe(taken(4000 * light * white, 60 * white))
    error, uneven = errors(stripe), (stripe.u > 245) & (stripe.u < 335)
    within = (stripe.u > 255) & (stripe.u < 325)
    assert np.median(np.abs(error[within])) > 0.3
    assert np.mean(np.abs(error[within]) < 3 * stripe.sigma_px[within]) > 0.9
    assert np.median(stripe.sigma_px[within]) > 5 * np.median(stripe.sigma_px[~uneven])
    far = (stripe.u < 230) | (stripe.u > 350)
    assert np.sqrt(np.mean(error[far] ** 2)) < 0.03


def test_a_step_of_the_surface_stays_a_step() -> None:
    line = np.where(U < 300, 150.0, 190.0)
    far = np.arange(HEIGHT)[:, None] - line
    stripe = extract_stripe(taken(np.asarray(1500 * np.exp(-0.5 * (far / 3) ** 2))))
    assert np.max(np.abs(stripe.v - line[stripe.u.astype(int)])) < 0.2


BROKEN = {kind.behind - kind.first: kind for kind in KINDS if kind.broken}


@pytest.mark.parametrize("columns", [40, 80, 480])
@pytest.mark.parametrize("bits", [8, 16])
def test_a_narrow_line_with_gaps_and_a_clipped_run_needs_no_other_scale(
    columns: int, bits: int
) -> None:
    kind = BROKEN[columns]
    image, centre = simulate_clipped_frame(kind, 1, bits)
    found, plain = find_stripe(image), find_stripe(simulate_clipped_frame(BROKEN[0], 1, bits)[0])
    assert found.core_rows
    assert found.is_certain
    best = max(
        extract_at(image, "u", None, AUTOMATIC, factor).evidence
        for factor in (THIN_FACTOR, *wide_factors(len(image)))
    )
    assert best < 1.05 * found.evidence
    assert list(found.stripe.u) == list(plain.stripe.u)
    clipped = (found.stripe.u >= kind.first) & (found.stripe.u < kind.behind)
    beside = np.abs(found.stripe.v - plain.stripe.v)[~clipped]
    assert beside.max() < 0.02
    off = found.stripe.v - centre[found.stripe.u.astype(int)]
    assert np.abs(off[clipped] / found.stripe.sigma_px[clipped]).max() < 5


def test_the_flanks_of_a_wide_clipped_line_leave_its_scale_open() -> None:
    line = FoundLine(extract_stripe(np.zeros((80, 80), np.uint8)), 99.0, 0.5, core_rows=20.0)
    line.fall_rows = 1.5
    assert line.is_certain
    line.fall_rows = 6.0
    assert not line.is_long


def test_the_core_places_a_line_whose_halo_is_uneven() -> None:
    """What is scattered to one side carries that flank along; the deviations say so."""
    beside = away() - 25 - 4 * np.sin(U / 40)
    halo = 150 * np.exp(-0.5 * (beside / 25) ** 2)
    even = extract_stripe(taken(beam(4.0, 900)))
    uneven = extract_stripe(taken(beam(4.0, 900) + halo))
    assert len(uneven.u) > 0.95 * WIDTH
    assert np.sqrt(np.mean(errors(uneven) ** 2)) < 0.6
    assert np.abs(errors(uneven) / uneven.sigma_px).mean() < 1.5
    assert np.median(uneven.sigma_px) > 10 * np.median(even.sigma_px)
