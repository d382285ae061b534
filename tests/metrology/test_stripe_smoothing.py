"""Smoothing along the line: what it leaves of the line's shape, and what it says of its noise."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.ndimage import gaussian_filter1d

from crenel.metrology.fitting.plane_sphere import PlaneFit
from crenel.metrology.fitting.shape import measure_shape
from crenel.metrology.sensor.triangulation import frame_points
from crenel.metrology.stripe import (
    HALF_HEIGHT_PERIOD,
    Stripe,
    StripeSettings,
    StripeTracker,
    extract_stripe,
    number_sharing_noise,
)
from crenel.metrology.stripe.smoothing import smooth_stripe
from crenel.metrology.transforms import Floats
from tests.bench.stripe.frames import GRAINS, simulate_frame, simulate_overexposure
from tests.metrology.test_reconstruct import CAMERA, PLANE
from tests.uncertainty_ratio import ratio_of_pulls, rows_of

pytestmark = pytest.mark.slow

COLUMNS = np.arange(1200.0)


def stripe_of(
    across: Floats, sigma_px: float = 0.1, along: Floats = COLUMNS, axis: str = "u"
) -> Stripe:
    u, v = (along, across) if axis == "u" else (across, along)
    return Stripe(u, v, np.full(len(along), 100.0), np.full(len(along), sigma_px), axis)


def correlated_noise(rng: np.random.Generator, alike_px: float) -> Floats:
    """(W,) of standard deviation 1, alike over neighbours as under speckle."""
    white = rng.standard_normal(len(COLUMNS))
    if not alike_px:
        return white
    spread = alike_px / (2 * np.sqrt(np.pi))
    return np.asarray(gaussian_filter1d(white, spread) * np.sqrt(alike_px))


def test_no_smoothing_is_the_stripe_as_it_is() -> None:
    image = simulate_frame(1).image
    plain = extract_stripe(image)
    smoothed = extract_stripe(image, settings=StripeSettings(smoothing_px=0.0))
    np.testing.assert_array_equal(smoothed.v, plain.v)
    np.testing.assert_array_equal(smoothed.sigma_px, plain.sigma_px)
    assert len(smooth_stripe(stripe_of(np.zeros(0), along=np.zeros(0)), 2.0).u) == 0


@pytest.mark.parametrize("smoothing_px", [1.0, 3.0, 12.0])
@pytest.mark.parametrize("periods", [0.7, 1.0, 2.5])
def test_structures_keep_their_share_of_their_height(smoothing_px: float, periods: float) -> None:
    period_px = periods * HALF_HEIGHT_PERIOD * smoothing_px
    wave = np.sin(2 * np.pi * COLUMNS / period_px)
    smoothed = smooth_stripe(stripe_of(300 + 0.2 * COLUMNS + wave), smoothing_px)
    inside = slice(60, -60)
    kept = (smoothed.v - 300 - 0.2 * COLUMNS)[inside] @ wave[inside] / (wave[inside] @ wave[inside])
    share = np.exp(-2 * (np.pi * smoothing_px / period_px) ** 2)
    assert kept == pytest.approx(share, abs=0.01)
    assert periods != 1.0 or share == pytest.approx(0.5)


def test_a_straight_line_stays_to_its_ends() -> None:
    line = stripe_of(100 + 1.7 * COLUMNS)
    smoothed = smooth_stripe(line, 5.0)
    np.testing.assert_allclose(smoothed.v, line.v, atol=1e-8)
    inside, end = np.median(smoothed.sigma_px), smoothed.sigma_px[0]
    assert inside == pytest.approx(0.1 / np.sqrt(number_sharing_noise(5.0)), rel=0.01)
    assert 1.5 * inside < end < 0.1


def test_pieces_of_the_line_do_not_reach_into_each_other() -> None:
    left = stripe_of(np.full(200, 50.0), along=np.arange(200.0))
    for beside, across in ((200.0, 54.5), (204.0, 50.5)):  # a step, and a gap
        along = np.concatenate([left.u, beside + np.arange(200.0)])
        rows = np.concatenate([left.v, np.full(200, across)])
        np.testing.assert_allclose(smooth_stripe(stripe_of(rows, along=along), 4.0).v, rows)


def test_points_without_neighbours_stay_as_they_are() -> None:
    rng = np.random.default_rng(0)
    apart = stripe_of(rng.normal(100, 0.1, 30), along=np.arange(0.0, 300.0, 10.0))
    for line, smoothing_px in ((apart, 2.0), (stripe_of(rng.normal(100, 0.1, 1200)), 1e-3)):
        smoothed = smooth_stripe(line, smoothing_px)
        np.testing.assert_allclose(smoothed.v, line.v)
        np.testing.assert_allclose(smoothed.sigma_px, line.sigma_px)


def test_uncertain_points_count_less() -> None:
    across = np.full(len(COLUMNS), 100.0)
    across[600] += 1.0
    sigma_px = np.full(len(COLUMNS), 0.1)
    sigma_px[600] = 10.0
    smoothed = smooth_stripe(replace(stripe_of(across), sigma_px=sigma_px), 3.0)
    np.testing.assert_allclose(smoothed.v, 100.0, atol=1e-3)


def test_rows_are_smoothed_like_columns() -> None:
    across = 200 + np.random.default_rng(0).normal(0, 0.1, len(COLUMNS))
    by_columns = smooth_stripe(stripe_of(across), 2.0)
    by_rows = smooth_stripe(stripe_of(across, axis="v"), 2.0)
    np.testing.assert_array_equal(by_rows.u, by_columns.v)
    np.testing.assert_array_equal(by_rows.v, by_columns.u)
    np.testing.assert_array_equal(by_rows.sigma_px, by_columns.sigma_px)


# Noise that is alike over more columns than the lags by which a frame tells it from the line's own
# shape is taken for shape in part: the more is smoothed, the smaller is the claim.
@pytest.mark.parametrize("smoothing_px", [0.7, 2.0, 5.0, 15.0])
@pytest.mark.parametrize(
    ("alike_px", "lowest"), [(0.0, 1.0), (3.0, 0.97), (7.0, 0.92), (12.0, 0.83)]
)
def test_repeats_scatter_as_stated(smoothing_px: float, alike_px: float, lowest: float) -> None:
    rng = np.random.default_rng(0)
    shape = 300 + 40 * np.sin(COLUMNS / 150)
    lines = [stripe_of(shape + 0.1 * correlated_noise(rng, alike_px)) for _ in range(40)]
    smoothed = [smooth_stripe(line, smoothing_px) for line in lines]
    stated = np.array([line.sigma_px for line in smoothed])
    across = np.array([line.v for line in smoothed])
    off = (across - across.mean(axis=0)) * np.sqrt(len(lines) / (len(lines) - 1))
    ratio_of_pulls(off / stated).assert_within(lowest)
    assert np.median(stated) < 0.1


@pytest.mark.parametrize("kind", list(GRAINS))
def test_smoothed_frames_scatter_as_stated(kind: str) -> None:
    frame = simulate_frame(3, GRAINS[kind])
    smoothing_px, off = 3.0, []
    for seed in (3, 7, 11, 15):
        frame = simulate_frame(seed, GRAINS[kind])
        found = extract_stripe(frame.image, settings=StripeSettings(smoothing_px=smoothing_px))
        truth = replace(found, v=frame.centre[found.u.astype(int)])
        lit = np.isfinite(truth.v) & (np.abs(found.v - truth.v) < 1)
        parts = (truth.u[lit], truth.v[lit], truth.intensity[lit], found.sigma_px[lit])
        true_line = smooth_stripe(Stripe(*parts), smoothing_px)
        off.append((found.v[lit] - true_line.v) / found.sigma_px[lit])
    ratio_of_pulls(rows_of(np.concatenate(off), 60)).assert_within()


def test_points_of_a_clipped_core_claim_no_more() -> None:
    image, _, _ = simulate_overexposure(0)
    plain = extract_stripe(image)
    smoothed = extract_stripe(image, settings=StripeSettings(smoothing_px=3.0))
    clipped = plain.intensity == 255
    assert clipped.sum() > 100
    np.testing.assert_array_equal(smoothed.sigma_px[clipped], plain.sigma_px[clipped])
    assert np.median((smoothed.sigma_px / plain.sigma_px)[~clipped]) < 0.5


def test_a_line_too_short_to_tell_is_taken_to_be_speckled() -> None:
    line = stripe_of(np.full(40, 100.0), along=np.arange(40.0))
    smoothed = smooth_stripe(line, 5.0)
    independent = 0.1 / np.sqrt(number_sharing_noise(5.0))
    assert np.median(smoothed.sigma_px) > 2 * independent
    assert smoothed.sigma_px.max() <= 0.1


def test_a_followed_line_is_smoothed_like_that_of_the_whole_frame() -> None:
    settings = StripeSettings(smoothing_px=3.0)
    tracker = StripeTracker(settings=settings)
    for seed in (1, 1, 1):
        image = simulate_frame(seed).image
        followed, whole = tracker.extract(image), extract_stripe(image, settings=settings)
        np.testing.assert_array_equal(followed.u, whole.u)
        np.testing.assert_allclose(followed.v, whole.v, atol=0.01)
    assert np.median(whole.sigma_px) < 0.5 * np.median(extract_stripe(image).sigma_px)


def scan_of_a_plane(smoothing_px: float) -> tuple[Floats, Floats]:
    """Points (N, 3) of forty frames, with noise of the stripes and of the arm; their frames."""
    rng = np.random.default_rng(0)
    frames = 40
    lines = [stripe_of(500 + rng.normal(0, 0.1, len(COLUMNS))) for _ in range(frames)]
    smoothed = [smooth_stripe(line, smoothing_px) for line in lines]
    poses = np.tile(np.eye(4), (frames, 1, 1))
    poses[:, 1, 3] = np.arange(frames)
    poses[:, 2, 3] = rng.normal(0, 1e-3, frames)
    u, v = (np.concatenate([getattr(line, name) for line in smoothed]) for name in "uv")
    count = np.full(frames, len(COLUMNS))
    return frame_points(CAMERA, PLANE, u, v, count, poses), np.repeat(np.arange(frames), count)


@pytest.mark.parametrize("smoothing_px", [2.0, 10.0])
def test_a_plane_is_known_no_better_from_smoothed_points(smoothing_px: float) -> None:
    claimed = []
    for one in (0.0, smoothing_px):
        points, frame = scan_of_a_plane(one)
        found = measure_shape("plane", points, frame.astype(np.int64))
        assert isinstance(found.fit, PlaneFit)
        assert found.covariance is not None
        claimed.append(np.sqrt(np.diag(found.covariance)))
    assert found.fit.rms_mm < 0.01
    assert (claimed[1] > 0.98 * claimed[0]).all()
