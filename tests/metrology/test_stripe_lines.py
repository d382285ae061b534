"""Lines as cameras of others see them: of any width, flat, broken, reflected, compressed, tinted,
before a room full of things; and rooms without a line."""

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray

from crenel.metrology.stripe import (
    Stripe,
    StripeSettings,
    StripeTracker,
    extract_stripe,
    find_stripe,
)
from crenel.metrology.stripe.scales import follow_scale, scale_of
from crenel.metrology.transforms import Floats
from tests.pictures import compressed
from tests.running.usual import usual
from tests.uncertainty_ratio import ratio_of_pulls, rows_of

pytestmark = pytest.mark.slow

WIDTH, HEIGHT = 960, 720
PER_FULL_WIDTH = 1 / 2.3548
Grey = NDArray[np.uint8]


def room(seed: int, brightest: float) -> Floats:
    """Boxes, edges and thin bars of any direction, softened as by a lens."""
    rng = np.random.default_rng(seed)
    image = np.full((HEIGHT, WIDTH), 0.2 * brightest, np.float32)
    for _ in range(60):
        x, y = rng.integers(0, WIDTH), rng.integers(0, HEIGHT)
        size = tuple(int(value) for value in rng.integers(10, 200, 2))
        box = cv2.boxPoints(((float(x), float(y)), size, float(rng.uniform(0, 180))))
        cv2.fillPoly(image, [box.astype(np.int32)], float(rng.uniform(0, brightest)))
    for _ in range(40):
        begin = rng.integers(0, (WIDTH, HEIGHT))
        end = begin + rng.integers(-200, 200, 2)
        level, thick = float(rng.uniform(0, brightest)), int(rng.integers(1, 6))
        cv2.line(image, begin.tolist(), end.tolist(), level, thick)
    return np.asarray(cv2.GaussianBlur(image, (0, 0), 1.0), dtype=np.float64)


def course(seed: int) -> Floats:
    """(W,) the rows of a line over a bent surface with a step."""
    rng = np.random.default_rng(seed)
    u = np.arange(WIDTH)
    rows = HEIGHT * rng.uniform(0.4, 0.6) + 25 * np.sin(u / rng.uniform(100, 300))
    rows[rng.integers(300, 600) :] += rng.choice((-1, 1)) * 40
    return np.asarray(rows)


def beam(
    rows: Floats, width_px: Floats | float, height: Floats | float, power: float = 2
) -> Floats:
    """(H, W) light of a line: a bell, or flatter with a higher power."""
    half = width_px / 2 / np.log(2) ** (1 / power)
    off = np.abs(np.arange(HEIGHT)[:, None] - rows) / half
    return np.asarray(height * np.exp(-(off**power)))


def expose(light: Floats, seed: int, full: float = 255) -> Grey:
    noise = np.random.default_rng(seed).standard_normal(light.shape)
    seen = light + noise * np.sqrt(4 + 0.02 * light)
    return np.clip(np.rint(np.minimum(seen, full)), 0, 255).astype(np.uint8)


def shares(stripe: Stripe, rows: Floats, width_px: float) -> tuple[float, float]:
    """Of the columns: those with a point on the line, and those with another one."""
    along, across = stripe.along_across
    near = np.abs(across - rows[along.astype(int)]) < max(3, 0.35 * width_px)
    seen = np.isfinite(rows)
    return float(np.mean(seen) and near.sum() / seen.sum()), float((~near).sum() / len(rows))


def check_shares(
    stripe: Stripe, rows: Floats, width_px: float, least_on: float, most_beside: float = 0.0
) -> None:
    """At least so many of the columns have a point on the line, and at most so many another."""
    on, beside = shares(stripe, rows, width_px)
    assert on > least_on
    assert beside <= most_beside


def errors(stripe: Stripe, rows: Floats) -> Floats:
    """(N,) how far points lie off the rows of a line, counted along u."""
    return np.asarray(stripe.v - rows[stripe.u.astype(int)])


@pytest.mark.parametrize(
    ("height", "power", "light", "width_px"),
    [(150, 2, 50, width_px) for width_px in (2, 3, 5, 10, 20, 35, 50, 70)]
    + [(600, 2, 50, width_px) for width_px in (3, 5, 10, 20, 35, 50, 70)]
    + [(150, 8, 15, width_px) for width_px in (2, 3, 5, 10, 20, 35, 50, 70)],
)
def test_any_width_is_found(height: float, power: float, light: float, width_px: float) -> None:
    for seed in range(3):
        rows = course(seed)
        image = expose(room(seed, light) + beam(rows, width_px, height, power), seed)
        check_shares(extract_stripe(image), rows, width_px, 0.95, 0.005)


@pytest.mark.parametrize("width_px", [1.2, 1.5])
def test_a_line_of_hardly_a_pixel_is_found_with_a_true_uncertainty(width_px: float) -> None:
    pulls = []
    for seed in range(4):
        rows = course(seed)
        stripe = extract_stripe(expose(15 + beam(rows, width_px, 120), seed))
        check_shares(stripe, rows, width_px, 0.98)
        pulls.append(errors(stripe, rows) / stripe.sigma_px)
    ratio_of_pulls(rows_of(np.concatenate(pulls), 32)).assert_within()


def test_the_width_is_stated() -> None:
    rows = course(0)
    for width_px in (4.0, 12.0, 40.0):
        line = find_stripe(expose(20 + beam(rows, width_px, 120), 0))
        assert line.width_px == pytest.approx(width_px, rel=0.1)


@pytest.mark.parametrize("seed", usual(range(12), 2, pytest.mark.soak))
@pytest.mark.parametrize("brightest", [60, 200, 400])
def test_a_room_without_a_line_shows_none(seed: int, brightest: float) -> None:
    image = expose(room(seed, brightest), seed)
    for axis in ("u", "v"):
        assert not len(extract_stripe(image, axis).u)


def test_what_the_operator_says_of_the_line_overrides_that() -> None:
    image = expose(room(1, 200), 1)
    assert not len(extract_stripe(image).u)
    assert len(extract_stripe(image, settings=StripeSettings(threshold=15)).u)


def test_a_wide_line_is_found_by_the_widths_that_the_operator_sets() -> None:
    rows = course(3)
    image = expose(room(3, 100) + beam(rows, 45, 150), 3)
    settings = StripeSettings(min_width_px=30, max_width_px=80)
    on, _ = shares(extract_stripe(image, settings=settings), rows, 45)
    assert on > 0.7


@pytest.mark.parametrize("width_px", [6, 20])
def test_a_short_line_over_a_small_part_is_found(width_px: float) -> None:
    rows = course(2)
    rows[:420], rows[540:] = np.nan, np.nan
    light = np.nan_to_num(beam(rows, width_px, 180))
    check_shares(extract_stripe(expose(room(2, 50) + light, 2)), rows, width_px, 0.9, 0.03)


def test_clutter_does_not_make_the_width() -> None:
    """Many thin bright bars, and one line 20 px wide on a small part."""
    rng = np.random.default_rng(5)
    light = np.full((HEIGHT, WIDTH), 15.0)
    for u in range(0, WIDTH, 24):
        v = int(rng.integers(40, 250))
        light[v : v + 3, u : u + 20] += 110
    rows = np.full(WIDTH, np.nan)
    rows[300:700] = 500
    light += np.nan_to_num(beam(rows, 20, 170))
    check_shares(extract_stripe(expose(light, 5)), rows, 20, 0.95, 0.005)


@pytest.mark.parametrize("there_px", [2.3, 16.0])
def test_a_line_of_another_width_for_a_few_columns_goes_on_there(there_px: float) -> None:
    """As rough surfaces and compression make it; not at its end, where it may be anything."""
    rows = np.linspace(300.0, 490.0, WIDTH)
    width_px = np.full(WIDTH, 6.0)
    width_px[400:424] = width_px[:40] = there_px
    stripe = extract_stripe(expose(20 + beam(rows, width_px, 120), 0))
    assert set(range(400, 424)) <= set(stripe.u.astype(int))
    assert not set(range(36)) & set(stripe.u.astype(int))


def test_a_reflection_in_a_gap_of_the_line_is_none() -> None:
    rows = course(4)
    light = beam(rows, 6, 180)
    light[:, 450:520] = 0
    light += beam(rows + 60, 6, 63)
    lit = rows.copy()
    lit[450:520] = np.nan
    check_shares(extract_stripe(expose(10 + light, 4)), lit, 6, 0.98)


def test_a_piece_of_line_before_an_edge_of_the_room_is_no_reflection() -> None:
    """The edge goes on where the piece ends, but a reflection would not fade there."""
    u = np.arange(WIDTH)
    rows = np.where(u < 200, 300.0, 420.0)
    edge = beam(np.full(WIDTH, 300.0), 5.0, np.where(u < 200, 0.0, 40.0))
    light = 20 + beam(rows, 5.0, 180.0) + edge
    check_shares(extract_stripe(expose(light, 1)), rows, 5.0, 0.98)


def test_a_dimmer_half_of_the_line_is_line() -> None:
    rows = course(6)
    height = np.where(np.arange(WIDTH) < 500, 200.0, 70.0)
    on, _ = shares(extract_stripe(expose(10 + beam(rows, 6, height), 6)), rows, 6)
    assert on > 0.98


@pytest.mark.parametrize("full", [255, 204, 120])
def test_a_top_that_is_cut_off_below_full_scale_is_clipped_too(full: float) -> None:
    rows = course(7)
    stripe = extract_stripe(expose(8 + beam(rows, 14, 900), 7, full))
    error = np.sort(np.abs(errors(stripe, rows)))
    assert len(error) > 0.97 * WIDTH
    assert np.sqrt(np.mean(error[: int(0.97 * len(error))] ** 2)) < 0.1


@pytest.mark.parametrize("quality", [80, 40])
@pytest.mark.parametrize("width_px", [5, 18])
def test_a_compressed_saturated_line_is_found(quality: int, width_px: float) -> None:
    rows = course(8)
    image = expose(room(8, 50) + beam(rows, width_px, 700), 8)
    check_shares(extract_stripe(compressed(image, quality)), rows, width_px, 0.95, 0.01)


@pytest.mark.parametrize(("width_px", "height", "power"), [(30.0, 220, 8.0), (40.0, 150, 6.0)])
def test_the_scatter_of_a_flat_top_is_stated(width_px: float, height: float, power: float) -> None:
    rows = np.asarray(300 + 0.03 * np.arange(WIDTH) + 8 * np.sin(np.arange(WIDTH) / 200))
    stripe = extract_stripe(expose(20 + beam(rows, width_px, height, power), 3))
    off = errors(stripe, rows) / stripe.sigma_px
    assert 0.6 < float(1.4826 * np.median(np.abs(off - np.median(off)))) < 1.25


@pytest.mark.parametrize("seed", usual(range(12), 2, pytest.mark.soak))
@pytest.mark.parametrize("slope", [0.0, 1.0, -3.0])
def test_the_noise_on_a_flat_top_with_sharp_edges_is_no_thin_line(slope: float, seed: int) -> None:
    rows = np.asarray(HEIGHT / 2 + slope * (np.arange(float(WIDTH)) - WIDTH / 2), np.float64)
    rows[(rows < 40) | (rows > HEIGHT - 40)] = np.nan
    light = np.nan_to_num(cv2.GaussianBlur(beam(rows, 40, 120, 60), (0, 0), 1.5))
    check_shares(extract_stripe(expose(np.asarray(20 + light, np.float64), seed)), rows, 40, 0.9)


def test_a_wide_line_is_followed_and_a_narrow_one_after_it() -> None:
    tracker = StripeTracker()
    for turn in range(40):
        width_px = 45 if turn < 20 else 4
        rows = course(9) + 3 * turn
        stripe = tracker.extract(expose(10 + beam(rows, width_px, 150), turn))
        on, beside = shares(stripe, rows, width_px)
        if turn % 20 > 8:
            assert on > 0.97
        assert beside < 0.01


@pytest.mark.parametrize("first", [1, 4, 7])
def test_what_comes_into_view_beside_a_wide_line_is_found_within_a_round(first: int) -> None:
    """Once in six frames the complete image is read, see ``tracking.c``."""
    tracker = StripeTracker()
    rows = np.full(WIDTH, 150.0)
    below = rows + 400
    columns = np.arange(WIDTH)
    left, right = (np.where(side, 150.0, 0.0) for side in (columns < 480, columns >= 480))
    for turn in range(first):
        tracker.extract(expose(10 + beam(rows, 45, left), turn))
    both = 10 + beam(rows, 45, left) + beam(below, 45, right)
    found = [shares(tracker.extract(expose(both, turn)), below, 45)[0] for turn in range(7)]
    assert found[-1] > 0.45
    jumped = shares(tracker.extract(expose(10 + beam(below - 150, 45, 150), 0)), below - 150, 45)
    assert jumped[0] > 0.97


@pytest.mark.parametrize("shift", [2, 4, 6])
def test_pictures_of_more_bits_are_scaled_alike(shift: int) -> None:
    rows = course(10)
    light = 10 + beam(rows, 40, 150)
    image = np.left_shift(expose(light, 10).astype(np.uint16), np.uint16(shift))
    check_shares(extract_stripe(image), rows, 40, 0.98)


def test_the_full_scale_of_a_followed_wide_line_is_that_of_its_sensor() -> None:
    """By what is read of each image: a lamp elsewhere says nothing, what was seen once stays."""
    scale = scale_of(np.full((600, 300), 900, np.uint16), 3.0)
    parts = np.array([[60, 90, 0, 200], [100, 120, 100, 300]])
    image = np.full((600, 300), 900, np.uint16)
    image[0, 0] = 4095
    image[190, 250] = 3000
    assert follow_scale(scale, image, parts) == scale
    image[359, 299] = 4095
    deeper = follow_scale(scale, image, parts)
    assert (deeper.saturated, deeper.gain) == (4095, 16)
    image[359, 299] = 900
    assert follow_scale(deeper, image, parts) == deeper
    image[200, 100] = 5000
    assert follow_scale(deeper, image, parts).saturated == 65535


def test_a_followed_wide_line_of_16_bits_is_that_of_whole_images() -> None:
    """Also where single frames clip, and their noise is stated in the same levels."""
    tracker = StripeTracker()
    for frame in range(6):
        rows = np.asarray(300 + 2.0 * frame + 0.05 * np.arange(WIDTH), dtype=np.float64)
        height = np.where(np.arange(WIDTH) < 60 * (frame % 2), 5000, 2000.0)
        light = 300 + beam(rows, 52.0, height)
        noise = np.random.default_rng(frame).standard_normal(light.shape)
        image = np.clip(np.rint(light + 20 * noise), 0, 4095).astype(np.uint16)
        followed, whole = tracker.extract(image), extract_stripe(image)
        common = np.intersect1d(followed.u, whole.u).astype(np.int64)
        assert len(common) > 0.97 * WIDTH
        for one in (followed, whole):
            assert float(np.median(np.abs(errors(one, rows)))) < 0.1
        ratio = np.median(followed.sigma_px) / np.median(whole.sigma_px)
        assert 0.7 < ratio < 1.4


@pytest.mark.parametrize(("turn_deg", "slope"), [(5, 0.127), (10, 0.136), (20, 0.324)])
def test_a_line_with_gaps_along_a_marked_board_is_found(turn_deg: float, slope: float) -> None:
    """The edge of a square under the line leaves a gap, where its own peaks are no clutter."""
    dictionary = cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_4X4_50)
    board = cv2.aruco.CharucoBoard((8, 7), 10.0, 7.5, dictionary).generateImage((1120, 980))
    turned = cv2.getRotationMatrix2D((560, 490), turn_deg, 0.5) + [[0, 0, 80], [0, 0, -10]]
    size, paper = (1280, 960), 170
    board = cv2.warpAffine(board, turned, size, flags=cv2.INTER_AREA, borderValue=(paper,))
    rows, columns = np.mgrid[: size[1], : size[0]]
    line = 640 + slope * (rows - 480)
    lit = 20 + 0.45 * board + 220 * np.exp(-0.5 * ((columns - line) / 2.0) ** 2)
    noisy = cv2.GaussianBlur(lit, (0, 0), 0.8) + np.random.default_rng(3).normal(0, 2, lit.shape)
    grey = np.clip(np.rint(noisy), 0, 255).astype(np.uint8)
    stripe = extract_stripe(compressed(grey, 60), "v")
    assert len(stripe.v) > 0.6 * size[1]
    off_px = np.abs(stripe.u - line[stripe.v.astype(int), 0])
    assert float(np.median(off_px)) < 0.1
    assert float(np.mean(off_px < 4)) > 0.98
