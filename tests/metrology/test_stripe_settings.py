"""What an operator may set, which of several peaks is the stripe, and following it."""

from typing import get_args

import numpy as np
import pytest
from numpy.typing import NDArray

from crenel.errors import OperationError
from crenel.metrology.stripe import (
    PeakChoice,
    Stripe,
    StripeSettings,
    StripeTracker,
    extract_stripe,
)
from crenel.metrology.transforms import Floats
from tests.bench.stripe.extraction import measure_errors
from tests.bench.stripe.frames import simulate_frame, simulate_reflections
from tests.bench.stripe.methods import crenel_line

pytestmark = pytest.mark.usefixtures("variant")

WIDTH, HEIGHT = 512, 400
ROUND = 6
"""After so many frames the tracker has looked everywhere, as in ``tracking.c``."""
U = np.arange(WIDTH)
MAIN = 200 + 10 * np.sin(U / 60)


def picture(*lines: tuple[Floats, Floats], width_px: float = 2.0) -> NDArray[np.uint8]:
    """Lines of (row, height) by columns, with noise."""
    rows = np.arange(HEIGHT)[:, None]
    light = sum(height * np.exp(-0.5 * ((rows - row) / width_px) ** 2) for row, height in lines)
    noise = np.random.default_rng(0).normal(0, 2, (HEIGHT, WIDTH))
    return np.clip(np.rint(8 + light + noise), 0, 255).astype(np.uint8)


def share_on(stripe: Stripe, row: Floats) -> float:
    """The share of all columns that have a point on this line."""
    return float(np.mean(np.isin(U, stripe.u[np.abs(stripe.v - row[stripe.u.astype(int)]) < 1])))


def steady(height: float) -> Floats:
    return np.full(WIDTH, height)


# a reflection that is brighter than the line, but only over 40 columns, and dim beyond
REFLECTION = np.where(np.abs(U - 250) < 20, 160.0, np.where(np.abs(U - 250) < 150, 40.0, 0.0))


@pytest.mark.parametrize(
    ("rule", "on_main", "on_upper"),
    [("continuity", 1, 0), ("strength", 0.92, 0.08), ("first", 0.42, 0.58), ("last", 1, 0)],
)
def test_of_many_peaks_the_rule_chooses(rule: PeakChoice, on_main: float, on_upper: float) -> None:
    image = picture((MAIN, steady(100)), (MAIN - 70, REFLECTION))
    stripe = extract_stripe(image, settings=StripeSettings(choice=rule))
    assert share_on(stripe, MAIN) == pytest.approx(on_main, abs=0.03)
    assert share_on(stripe, MAIN - 70) == pytest.approx(on_upper, abs=0.03)


def test_every_rule_finds_a_line_that_is_alone() -> None:
    image = picture((MAIN, steady(100)))
    for rule in get_args(PeakChoice):
        assert share_on(extract_stripe(image, settings=StripeSettings(choice=rule)), MAIN) > 0.98


def test_peaks_below_the_threshold_are_none() -> None:
    image = picture((MAIN, np.where(U < 256, 120.0, 30.0)))
    assert share_on(extract_stripe(image), MAIN) > 0.98
    bright = extract_stripe(image, settings=StripeSettings(threshold=60))
    assert len(bright.u) > 250
    assert bright.u.max() < 257


def test_peaks_of_another_width_are_none() -> None:
    image = picture((MAIN, steady(100)), width_px=2.0)  # 4.7 px at half height
    assert len(extract_stripe(image, settings=StripeSettings(min_width_px=6.0)).u) == 0
    assert len(extract_stripe(image, settings=StripeSettings(max_width_px=4.0)).u) == 0
    both = StripeSettings(min_width_px=4.0, max_width_px=6.0)
    assert share_on(extract_stripe(image, settings=both), MAIN) > 0.98


def test_short_pieces_are_left_out_as_wished() -> None:
    image = picture((MAIN, np.where(U % 100 < 50, 100.0, 0.0)))
    assert share_on(extract_stripe(image), MAIN) == pytest.approx(0.5, abs=0.03)
    assert len(extract_stripe(image, settings=StripeSettings(min_run=60)).u) == 0


def test_masked_zones_hold_no_points() -> None:
    image = picture((MAIN, steady(100)), (MAIN - 70, steady(160)))
    where = np.ones(image.shape, dtype=bool)
    where[:165] = False
    stripe = extract_stripe(image, where=where)
    assert share_on(stripe, MAIN) > 0.98
    with pytest.raises(OperationError, match="another size"):
        extract_stripe(image, where=where[1:])


@pytest.mark.parametrize(
    "wrong",
    [
        StripeSettings(threshold=-1),
        StripeSettings(min_width_px=float("nan")),
        StripeSettings(min_width_px=5, max_width_px=4),
        StripeSettings(min_run=0),
        StripeSettings(choice="brightest"),  # type: ignore[arg-type]
        StripeSettings(smoothing_px=-1),
        StripeSettings(smoothing_px=float("nan")),
        StripeSettings(smoothing_px=float("inf")),
    ],
)
def test_settings_that_cannot_be_meant_are_refused(wrong: StripeSettings) -> None:
    with pytest.raises(OperationError, match="stripe"):
        extract_stripe(picture((MAIN, steady(100))), settings=wrong)


@pytest.mark.slow
def test_reflections_spots_and_hot_pixels_give_no_points() -> None:
    found = measure_errors([simulate_reflections(seed) for seed in range(4)], crenel_line)
    assert found.false < 0.5
    assert found.missed < 0.03


@pytest.mark.slow
@pytest.mark.parametrize("grains", [None, pytest.param((0.0, 2.0), marks=pytest.mark.soak)])
def test_stripes_of_any_width_reach_bounds_and_say_so(grains: tuple[float, float] | None) -> None:
    found = measure_errors([simulate_frame(seed, grains) for seed in range(8)], crenel_line)
    assert found.over_bound < (1.03 if grains is None else 1.08)
    assert found.pull == pytest.approx(1, abs=0.06)


@pytest.mark.parametrize("axis", ["u", "v"])
def test_a_followed_stripe_is_that_of_the_whole_frame(axis: str) -> None:
    tracker = StripeTracker(axis)
    for n in range(12):
        row = MAIN + 40 * np.sin(n / 4)
        image = picture((row, steady(100)))
        image = image if axis == "u" else np.ascontiguousarray(image.T)
        followed, whole = tracker.extract(image), extract_stripe(image, axis)
        np.testing.assert_array_equal(followed.along_across[0], whole.along_across[0])
        np.testing.assert_allclose(followed.along_across[1], whole.along_across[1], atol=0.02)


def test_a_stripe_that_jumps_is_found_in_the_same_frame() -> None:
    tracker = StripeTracker()
    for row in (MAIN, MAIN, MAIN + 150, MAIN - 150):
        assert share_on(tracker.extract(picture((row, steady(100)))), row) > 0.98
    dark = np.full((HEIGHT, WIDTH), 8, np.uint8)
    assert len(tracker.extract(dark).u) == 0
    assert share_on(tracker.extract(picture((MAIN, steady(100)))), MAIN) > 0.98


def test_a_second_piece_that_comes_into_view_is_found_within_a_round() -> None:
    tracker = StripeTracker()
    half = np.where(U < 256, 100.0, 0.0)
    tracker.extract(picture((MAIN, half)))
    image = picture((MAIN, half), (MAIN + 100, steady(100) - half))
    for _ in range(ROUND):
        stripe = tracker.extract(image)
    assert share_on(stripe, MAIN + 100) > 0.45


def test_the_edge_of_a_lit_face_that_moves_by_hides_the_stripe_in_no_frame() -> None:
    tracker = StripeTracker()
    image = picture((MAIN, steady(60)))
    for n in range(3 * ROUND):
        edge = 20 + n * 8
        lit = image.copy()
        lit[edge : edge + 60] = np.maximum(lit[edge : edge + 60], 150)
        if abs(edge + 30 - 200) < 90:
            continue
        assert share_on(tracker.extract(lit), MAIN) > 0.98
