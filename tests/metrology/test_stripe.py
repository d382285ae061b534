"""Stripe extraction against stripes whose place is known."""

from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from crenel.errors import OperationError
from crenel.metrology.image import Image, saturation_level
from crenel.metrology.stripe import (
    Stripe,
    empty_stripe,
    extract_stripe,
    find_stripe,
    has_second_line,
    shows_two_lasers,
    usual_steepness,
)
from crenel.metrology.transforms import Floats
from tests.pictures import read_picture
from tests.uncertainty_ratio import ratio_of_pulls, rows_of

WIDTH, HEIGHT = 640, 256


def rendered(
    width_px: float = 2.0,
    amplitude: float = 150.0,
    read: float = 2.0,
    gain: float = 0.03,
    tilt: float = 0.03,
    seed: int = 0,
    white: float = 255.0,
) -> tuple[Image, Floats]:
    """An image with a slightly bent stripe, and where its centre is in each column."""
    rng = np.random.default_rng(seed)
    u = np.arange(WIDTH)
    centre = 125 + tilt * (u - 320) + 4 * np.sin(u / 150)
    height = amplitude * (0.7 + 0.3 * np.sin(u / 41))
    signal = height * np.exp(-0.5 * ((np.arange(HEIGHT)[:, None] - centre) / width_px) ** 2)
    grey = signal + 6 + rng.normal(0, 1, signal.shape) * np.sqrt(read**2 + gain * signal)
    kind = np.uint8 if white == 255 else np.uint16
    return np.clip(np.rint(grey), 0, white).astype(kind), centre


def measured(image: Image, centre: Floats) -> tuple[Stripe, Floats]:
    """The stripe, and how far each of its points is off."""
    stripe = extract_stripe(image)
    return stripe, np.asarray(stripe.v - centre[stripe.u.astype(int)])


def bound(width_px: float, amplitude: float, read: float, gain: float) -> float:
    """Cramer-Rao bound of one point's centre, in px, for the mean height of ``rendered``."""
    r = np.arange(-40, 41)
    inverse = []
    for phase in np.linspace(0, 6.28, 50):
        signal = amplitude * (0.7 + 0.3 * np.sin(phase)) * np.exp(-0.5 * (r / width_px) ** 2)
        variance = read**2 + gain * signal + 1 / 12
        inverse.append(1 / np.sum((signal * r / width_px**2) ** 2 / variance))
    return float(np.sqrt(np.mean(inverse)))


@pytest.mark.parametrize(
    ("width_px", "amplitude"), [(1.2, 150), (2.0, 150), (2.0, 30), (3.5, 150), (2.0, 60)]
)
def test_points_scatter_as_noise_allows_and_as_they_say(width_px: float, amplitude: float) -> None:
    drawn = [rendered(width_px, amplitude, tilt=0.08 * seed, seed=seed) for seed in range(4)]
    found = [measured(*one) for one in drawn]
    error = np.concatenate([off for _, off in found])
    sigma = np.concatenate([stripe.sigma_px for stripe, _ in found])
    assert len(error) > 0.98 * 4 * WIDTH
    assert np.std(error) < 1.06 * bound(width_px, amplitude, 2.0, 0.03)
    assert abs(np.mean(error)) < 4 * np.std(error) / np.sqrt(len(error))
    assert np.sqrt(np.mean((error / sigma) ** 2)) == pytest.approx(1, abs=0.12)


@given(st.integers(0, 2**32 - 1), st.floats(1.1, 4.0), st.floats(75, 220), st.floats(-0.2, 0.25))
@settings(max_examples=25, deadline=None)
def test_any_stripe_is_unbiased(seed: int, width_px: float, amplitude: float, tilt: float) -> None:
    image, centre = rendered(width_px, amplitude, tilt=tilt, seed=seed)
    stripe, error = measured(image, centre)
    assert len(stripe.u) > 0.97 * WIDTH
    assert np.all(np.diff(stripe.u) > 0)
    assert abs(np.mean(error)) < 5 * np.std(error) / np.sqrt(len(error)) + 1e-4
    assert np.max(np.abs(error) / stripe.sigma_px) < 6


def test_an_overexposed_stripe_is_placed_by_its_flanks() -> None:
    image, centre = rendered(2.0, amplitude=900)
    assert np.mean(image.max(axis=0) == 255) > 0.99
    stripe, error = measured(image, centre)
    assert len(error) > 0.98 * WIDTH
    assert np.std(error) < 0.03
    assert abs(np.mean(error)) < 0.003
    ratio_of_pulls(rows_of(error / stripe.sigma_px, 32)).assert_within()


@pytest.mark.parametrize(("width_px", "amplitude"), [(2.0, 1000), (3.0, 1000), (4.5, 2000)])
def test_an_overexposed_stripe_scatters_as_it_says(width_px: float, amplitude: float) -> None:
    error, pull = [], []
    for seed in range(6):
        drawn = rendered(width_px, amplitude, gain=0.15, tilt=0.03 * seed, seed=seed)
        stripe, off = measured(*drawn)
        assert len(stripe.u) > 0.98 * WIDTH
        error.append(off)
        pull.append(off / stripe.sigma_px)
    # a single column resolves 0.022 px; as many as the core is wide, a third of that
    assert np.std(np.concatenate(error)) < 0.016
    # neighbours share an average
    ratio_of_pulls(rows_of(np.concatenate(pull), 32)).assert_within(k=2.5)


def test_an_overexposed_stripe_is_followed_to_the_images_border() -> None:
    image, centre = rendered(3.0, 1500, tilt=0.05)
    first = int(centre.min()) - 12
    stripe = extract_stripe(image[first:].copy())
    error = stripe.v + first - centre[stripe.u.astype(int)]
    assert len(stripe.u) > 0.98 * WIDTH
    assert np.max(np.abs(error)) < 0.1


@pytest.mark.parametrize("height", [150, 1200])
def test_rows_and_columns_are_treated_alike(height: float) -> None:
    image, _ = rendered(amplitude=height)  # the second is clipped
    along_u, along_v = extract_stripe(image, "u"), extract_stripe(image.T, "v")
    np.testing.assert_array_equal(along_u.u, along_v.v)
    np.testing.assert_array_equal(along_u.v, along_v.u)
    np.testing.assert_array_equal(along_u.sigma_px, along_v.sigma_px)


@pytest.mark.parametrize("slope", [0.0, 0.3, 2.5, 5.0])
@pytest.mark.parametrize("axis", ["u", "v"])
def test_a_line_along_the_other_axis_is_steep(slope: float, axis: str) -> None:
    v, u = np.mgrid[0:400, 0:400]
    across = (v - 200 - slope * (u - 200)) / np.hypot(1, slope)
    noise = np.random.default_rng(0).normal(0, 1.0, across.shape)
    picture = (20 + 150 * np.exp(-(across**2) / 8) + noise).round().clip(0).astype(np.uint8)
    stripe = extract_stripe(picture if axis == "u" else np.ascontiguousarray(picture.T), axis)
    assert len(stripe.u) > 50
    assert usual_steepness(stripe) == pytest.approx(slope, abs=0.1)
    assert np.isnan(usual_steepness(empty_stripe(axis)))


def test_twelve_bits_say_more_than_eight() -> None:
    fine, centre = rendered(2.0, 2400, read=2, gain=0.0, white=4095)
    coarse = (fine >> 4).astype(np.uint8)
    error_fine, error_coarse = (measured(i, centre)[1] for i in (fine, coarse))
    assert np.std(error_fine) < 0.8 * np.std(error_coarse) < 0.01


@pytest.mark.parametrize(
    ("top", "level"), [(1023, 1023), (4095, 4095), (65520, 65520), (4000, 65535), (65535, 65535)]
)
def test_the_level_of_clipping_is_the_sensors_own(top: int, level: int) -> None:
    image = np.zeros((64, 64), dtype=np.uint16)
    image[30:33, 5:40] = top
    assert saturation_level(image) == level


def test_hot_pixels_and_small_reflections_are_no_stripe() -> None:
    image, centre = rendered(2.0, 120)
    clean = extract_stripe(image)
    rng = np.random.default_rng(5)
    spoiled = image.copy()
    spoiled[rng.integers(0, HEIGHT, 300), rng.integers(0, WIDTH, 300)] = 255
    cv2.circle(spoiled, (300, 210), 2, 250, -1)
    stripe, error = measured(spoiled, centre)
    assert len(stripe.u) > len(clean.u) - 40
    assert np.mean(np.abs(error) > 1) < 0.005
    assert not np.any(np.abs(stripe.v - 210) < 5)


def test_a_lit_face_behind_the_stripe_does_not_draw_it_away() -> None:
    image, centre = rendered(2.0, 90)
    lit = image.astype(int)
    lit[:, 100:] += 60
    lit[180:, 200:400] += 90
    stripe, error = measured(np.clip(lit, 0, 255).astype(np.uint8), centre)
    assert len(stripe.u) > 0.97 * WIDTH
    assert np.max(np.abs(error)) < 0.4


SECOND = {
    "another laser": (60.0, 1.2, 0.9, (0, WIDTH), True),
    "a crossing laser": (0.0, 1.0, 1.0, (0, WIDTH), True),
    "a faint reflection": (50.0, 1.3, 0.3, (0, WIDTH), False),
    "a short reflection": (50.0, 1.0, 0.8, (200, 330), False),
    "a broad reflection": (60.0, 4.0, 0.7, (0, WIDTH), False),
}


@pytest.mark.parametrize("name", SECOND)
def test_a_second_laser_is_no_reflection(name: str) -> None:
    off_px, broader, higher, (first, last), expected = SECOND[name]
    image, centre = rendered()
    u = np.arange(WIDTH)
    beside = centre + off_px + (0.4 * (u - 320) if off_px == 0 else 0.0)
    height = 150 * higher * ((u >= first) & (u < last))
    away = (np.arange(HEIGHT)[:, None] - beside) / (2 * broader)
    both = np.clip(image + height * np.exp(-0.5 * away**2), 0, 255).astype(np.uint8)
    for grey, axis in ((both, "u"), (np.ascontiguousarray(both.T), "v")):
        assert has_second_line(grey, find_stripe(grey, axis)) == expected


@pytest.mark.parametrize("step_px", [0.0, 40.0, -90.0])
def test_a_line_with_gaps_and_a_step_is_one(step_px: float) -> None:
    image, _ = rendered()
    image[:, 150:220] = 6
    image[:, 360:] = np.roll(image[:, 360:], int(step_px), axis=0)
    assert not has_second_line(image, find_stripe(image))


def test_two_lasers_are_in_most_pictures() -> None:
    assert shows_two_lasers([True])
    assert shows_two_lasers([True, False, True])
    assert not shows_two_lasers([True, False])
    assert not shows_two_lasers([True, True, False, False, False])
    assert not shows_two_lasers([])


@pytest.mark.parametrize("seed", range(3))
def test_noise_alone_holds_no_stripe(seed: int) -> None:
    noise = np.random.default_rng(seed).normal(20, 3, (512, 640)).clip(0, 255)
    assert len(extract_stripe(noise.astype(np.uint8)).u) == 0


def test_images_without_a_stripe_yield_an_empty_one() -> None:
    for grey in (0, 255):
        stripe = extract_stripe(np.full((200, 300), grey, dtype=np.uint8))
        assert [len(x) for x in (stripe.u, stripe.v, stripe.intensity, stripe.sigma_px)] == [0] * 4
    assert len(extract_stripe(np.zeros((8, 300), dtype=np.uint8)).u) == 0


def test_what_is_no_grey_image_is_refused() -> None:
    wrongs: list[NDArray[Any]] = [np.zeros((10, 10, 3), np.uint8), np.zeros((90, 90))]
    for wrong in wrongs:
        with pytest.raises(OperationError, match="grey"):
            extract_stripe(wrong)
    with pytest.raises(OperationError, match="axis"):
        extract_stripe(np.zeros((90, 90), np.uint8), "x")


@pytest.mark.parametrize("session", ["one-pose", "many-poses", "metal"])
def test_the_samples_stripes_lie_on_straight_segments(samples: Path, session: str) -> None:
    """Merlons and grooves are flat, so each level's points scatter about a line as they say."""
    stripe = extract_stripe(read_picture(samples / session / "images" / "pose00_laser.png"))
    assert len(stripe.u) > 1000
    jumps = (np.diff(stripe.u) > 2) | (np.abs(np.diff(stripe.v)) > 1.5)
    normalised = []
    for segment in np.split(np.arange(len(stripe.u)), np.flatnonzero(jumps) + 1):
        if len(segment) < 60:
            continue
        inner = segment[5:-5]
        u, v, sigma = stripe.u[inner], stripe.v[inner], stripe.sigma_px[inner]
        normalised.append((v - np.polyval(np.polyfit(u, v, 2), u)) / sigma)
    assert len(normalised) >= 7
    assert np.sqrt(np.mean(np.concatenate(normalised) ** 2)) == pytest.approx(0.97, abs=0.12)
