"""Colour pictures: the laser's channel, weights from two pictures, and raw pixels of one colour."""

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray

from app.errors import OperationError
from app.metrology.bayer import BAYER_PATTERNS, BayerPattern, BayerPlane
from app.metrology.channel import Channel, describe_channel, is_grey, select_channel
from app.metrology.colour import PLANES, ColourWeights, LaserColour, find_weights
from app.metrology.image import Image
from app.metrology.stripe import Stripe, StripeSettings, extract_stripe
from app.metrology.transforms import Floats
from tests.colours import HEIGHT, ROOM, SHOT, WIDTH, expose, line_rows, mosaic, render_colours
from tests.uncertainty_ratio import UncertaintyRatio

FRAMES = 4
FRAME_SCATTER, FRAME_SCATTER_6_PX = 0.08, 0.05
"""Of the ratio of claimed to observed uncertainty by one frame, whose neighbours err together:
standard deviation over twelve frames each of several colours, where the ratio is 0.95 to 1.00."""
DEMOSAIC = {
    "RGGB": cv2.COLOR_BayerRGGB2BGR,
    "BGGR": cv2.COLOR_BayerBGGR2BGR,
    "GRBG": cv2.COLOR_BayerGRBG2BGR,
    "GBRG": cv2.COLOR_BayerGBRG2BGR,
}


def errors(stripe: Stripe) -> Floats:
    """Measured minus true row of each point."""
    return np.asarray(stripe.v - line_rows(stripe.u))


def selected(picture: NDArray[np.uint8], channel: Channel | None) -> Image:
    grey = select_channel(picture, channel)
    assert grey is not None
    return grey


def rms(values: Floats) -> float:
    return float(np.sqrt(np.mean(values**2)))


@pytest.mark.parametrize("pattern", BAYER_PATTERNS)
@pytest.mark.parametrize("colour", ["red", "green", "blue"])
def test_raw_pixels_are_those_under_the_filter(pattern: BayerPattern, colour: LaserColour) -> None:
    levels = {"blue": 10, "green": 20, "red": 30}
    colours = np.zeros((7, 9, 3), np.uint8)
    for name, index in PLANES.items():
        colours[..., index] = levels[name]
    plane = BayerPlane(pattern, colour)
    selected = plane.select(mosaic(colours, pattern))
    assert selected.shape == (3, 4)
    assert (selected == levels[colour]).all()
    u, v = plane.places[0]
    where = np.ones((7, 9), np.bool_)
    where[v, u] = False
    assert np.argwhere(~plane.select_mask(where)).tolist() == [[0, 0]]


@pytest.mark.parametrize("width_px", [3.0, 6.0, 20.0])
@pytest.mark.parametrize("pattern", ["RGGB", "GBRG"])
@pytest.mark.parametrize("colour", ["red", "green", "blue"])
def test_a_line_in_raw_pixels_is_where_it_is_and_as_sure_as_stated(
    pattern: BayerPattern, colour: LaserColour, width_px: float
) -> None:
    plane, colours, squares = BayerPlane(pattern, colour), render_colours(colour, width_px), []
    for seed in range(3, 3 + FRAMES):
        raw = mosaic(expose(colours, seed), pattern)
        stripe = plane.raw_stripe(extract_stripe(plane.select(raw)))
        off = errors(stripe)
        assert len(off) > 0.97 * WIDTH / 2
        assert abs(off.mean()) < 0.01
        assert rms(off) < (0.06 if width_px < 10 else 0.11)
        squares.append(np.mean((off / stripe.sigma_px) ** 2))
    ratio = float(1 / np.sqrt(np.mean(squares)))
    error = (FRAME_SCATTER_6_PX if width_px == 6.0 else FRAME_SCATTER) / np.sqrt(FRAMES)
    UncertaintyRatio(ratio, error).assert_within(0.95, 1.0, k=2.5)


def test_raw_pixels_are_closer_to_the_truth_than_interpolated_ones() -> None:
    """The narrower the line, the more the shape of interpolated ones is that of the filter."""
    raw = mosaic(expose(render_colours("red", 3.0), seed=3), "RGGB")
    full = cv2.cvtColor(raw, DEMOSAIC["RGGB"])
    interpolated = extract_stripe(np.ascontiguousarray(full[..., PLANES["red"]], np.uint8))
    plane = BayerPlane("RGGB", "red")
    own = plane.raw_stripe(extract_stripe(plane.select(raw)))
    assert rms(errors(own)) < rms(errors(interpolated))


def test_settings_are_stated_in_pixels_of_the_raw_picture() -> None:
    settings = StripeSettings(threshold=9.0, min_width_px=4.0, choice="first", smoothing_px=3.0)
    of_plane = BayerPlane("RGGB", "red").select_settings(settings)
    assert (of_plane.min_width_px, of_plane.max_width_px) == (2.0, None)
    assert (of_plane.threshold, of_plane.choice) == (9.0, "first")
    assert of_plane.smoothing_px == 1.5


@pytest.mark.parametrize("kind", [np.uint8, np.uint16])
def test_a_clipped_green_pixel_leaves_no_half_clipped_mean(kind: type[np.generic]) -> None:
    full = 255 if kind is np.uint8 else 4095
    raw = np.array([[0, full], [full - 100, 0], [0, 10], [13, 0]]).astype(kind)
    selected = BayerPlane("RGGB", "green").select(np.hstack([raw, raw]))
    assert selected.dtype == kind
    assert selected[:, 0].tolist() == [full, 12]


def test_weights_bring_out_the_laser_better_than_any_channel() -> None:
    """A laser of 590 nm, which red and green see, in pictures with a noisier red."""
    noise: dict[LaserColour, float] = {"blue": 2.0, "green": 2.0, "red": 4.0}
    laser: dict[LaserColour, float] = {"blue": 0.02, "green": 0.6, "red": 1.0}
    lit = expose(render_colours(laser, 5.0), seed=1, noise=noise)
    unlit = expose(render_colours({}, 5.0), seed=2, noise=noise)
    weights = find_weights(lit, unlit)
    light = {name: SHOT * level for name, level in ROOM.items()}
    expected = np.array([0.6 / (2.0**2 + light["green"]), 1.0 / (4.0**2 + light["red"])])
    expected /= expected.sum()
    assert weights.blue == pytest.approx(0.02, abs=0.02)
    assert weights.green == pytest.approx(expected[0], abs=0.06)
    assert weights.red == pytest.approx(expected[1], abs=0.06)
    best = rms(errors(extract_stripe(selected(lit, weights))))
    channels: tuple[LaserColour, ...] = ("green", "red")
    for channel in channels:
        assert best < 0.97 * rms(errors(extract_stripe(selected(lit, channel)))), channel


def test_weights_are_those_of_the_laser_where_the_room_is_dark_behind_it() -> None:
    laser: dict[LaserColour, float] = {"green": 0.5, "red": 1.0}
    light = render_colours(laser, 5.0) - render_colours({}, 5.0)
    weights = find_weights(expose(light, seed=1), expose(render_colours({}, 5.0), seed=2))
    assert weights.red == pytest.approx(2 / 3, abs=0.04)
    assert weights.green == pytest.approx(1 / 3, abs=0.04)


def test_a_sum_is_clipped_where_a_channel_of_it_is() -> None:
    picture = np.zeros((2, 2, 3), np.uint8)
    picture[0, 0] = (0, 10, 255)
    picture[0, 1] = (255, 0, 0)
    picture[1, 1] = (0, 100, 200)
    summed = ColourWeights(0.0, 0.25, 0.75).sum_channels(picture)
    assert summed.tolist() == [[255, 0], [0, 175]]


def test_weights_need_light_and_pictures_of_one_size() -> None:
    unlit = expose(render_colours({}, 5.0), seed=2)
    with pytest.raises(OperationError, match="not brighter"):
        find_weights(expose(render_colours({}, 5.0), seed=1), unlit)
    with pytest.raises(OperationError, match="differ"):
        find_weights(unlit[:-2], unlit)


def test_channels_are_selected_by_one_rule() -> None:
    grey: NDArray[np.uint8] = np.arange(HEIGHT * WIDTH).reshape(HEIGHT, WIDTH).astype(np.uint8)
    alike = np.dstack([grey] * 3)
    assert is_grey(alike)
    channels: tuple[Channel | None, ...] = (None, "red", ColourWeights(0.0, 0.5, 0.5))
    for channel in channels:
        np.testing.assert_array_equal(selected(alike, channel), grey)
    colours = np.dstack([grey, grey, np.uint8(255) - grey])
    assert select_channel(colours, None) is None
    assert select_channel(colours, BayerPlane("RGGB", "red")) is None
    assert str(describe_channel(ColourWeights(0.04, 0.0, 0.96))) == "0.04 blue + 0.96 red"
