"""Colour pictures: the laser's channel, weights, and raw pixels, which are recognised as such."""

from pathlib import Path

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray

from crenel.errors import OperationError
from crenel.metrology.bayer import BAYER_PATTERNS, BayerPattern, BayerPlane
from crenel.metrology.channel import Channel, describe_channel, is_grey, select_channel
from crenel.metrology.chessboard.detect_board import detect_board
from crenel.metrology.colour import PLANES, ColourWeights, LaserColour, find_weights
from crenel.metrology.detection.failure_evidence import DetectionError
from crenel.metrology.detection.image_quality import image_findings
from crenel.metrology.image import Image
from crenel.metrology.mosaic import shows_mosaic
from crenel.metrology.stripe import Stripe, StripeSettings, extract_stripe
from crenel.metrology.targets.chessboard import Chessboard
from crenel.metrology.transforms import Floats
from tests.colours import HEIGHT, ROOM, SHOT, WIDTH, expose, line_rows, mosaic, render_colours
from tests.pictures import compressed
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
SENSITIVITY = np.array([0.65, 1.0, 0.5])
"""Of a camera's blue, green and red pixels in daylight."""


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


@pytest.mark.slow
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


def read_colours(path: Path) -> NDArray[np.uint8]:
    return np.asarray(cv2.imread(str(path), cv2.IMREAD_COLOR), np.uint8)


def raw_of(colours: NDArray[np.uint8], pattern: BayerPattern) -> NDArray[np.uint8]:
    """What a camera without white balance would have sent."""
    return mosaic((colours * SENSITIVITY).astype(np.uint8), pattern)


@pytest.mark.slow
@pytest.mark.parametrize("pattern", BAYER_PATTERNS)
@pytest.mark.parametrize("colour", ["red", "green", "blue"])
@pytest.mark.parametrize("width_px", [3.0, 20.0])
def test_a_line_shows_a_mosaic(pattern: BayerPattern, colour: LaserColour, width_px: float) -> None:
    light = render_colours(colour, width_px)
    assert shows_mosaic(mosaic(expose(light, seed=1), pattern))
    assert shows_mosaic(mosaic(expose(4.0 * light, seed=1), pattern))  # clipped
    dark = light - light.min(axis=(0, 1)) + 2.0
    assert shows_mosaic(mosaic(expose(dark, seed=1), pattern))
    plane = BayerPlane(pattern, colour).select(mosaic(expose(light, seed=1), pattern))
    assert not shows_mosaic(plane)


def test_real_scenes_show_a_mosaic_only_if_raw(real: Path) -> None:
    for path in sorted((real / "boards/wide").iterdir())[:4]:
        colours = read_colours(path)
        for pattern in BAYER_PATTERNS:
            raw = raw_of(colours, pattern)
            assert shows_mosaic(raw)
            assert shows_mosaic((raw.astype(np.uint16) * 16).astype(np.uint16))
            assert shows_mosaic(compressed(raw, 75))
        interpolated = cv2.cvtColor(raw_of(colours, "RGGB"), cv2.COLOR_BayerRGGB2GRAY)
        assert not shows_mosaic(np.asarray(interpolated, np.uint8))


def harder(grey: NDArray[np.uint8]) -> dict[str, Image]:
    """Pictures that alternate in their own ways."""
    noise = np.random.default_rng(0).normal(0, 20, grey.shape)
    soft = cv2.GaussianBlur(grey, (0, 0), 1)
    rows = grey.copy()
    rows[1::2] = np.roll(rows[1::2], 4, axis=1) * 0.9
    return {
        "as it is": grey,
        "JPEG": compressed(grey, 30),
        "noisy": np.clip(grey + noise, 0, 255).astype(np.uint8),
        "sharpened": np.asarray(cv2.addWeighted(grey, 3, soft, -2, 0), np.uint8),
        "every second pixel": np.ascontiguousarray(grey[::2, ::2]),
        "each pixel twice": np.kron(grey, np.ones((2, 2), np.uint8)),
        "interlaced": rows,
    }


@pytest.mark.parametrize("kind", ["boards/*/*2*.jpg", "lines/weld/*.png", "robot*/calib1/*2.png"])
def test_real_grey_pictures_show_none(real: Path, kind: str) -> None:
    files = sorted(real.glob(kind))[:6]
    assert files
    for path in files:
        grey = np.asarray(cv2.imread(str(path), cv2.IMREAD_GRAYSCALE), np.uint8)
        for name, picture in harder(grey).items():
            assert not shows_mosaic(picture), (path.name, name)


def test_noise_and_small_pictures_show_none() -> None:
    rng = np.random.default_rng(3)
    for shape in ((8, 8), (16, 16), (128, 160), (480, 640)):
        assert not shows_mosaic(rng.normal(60, 15, shape).clip(0, 255).astype(np.uint8))
        assert not shows_mosaic(np.zeros(shape, np.uint16))


@pytest.mark.slow
def test_a_board_in_a_raw_picture_is_refused_for_that(real: Path) -> None:
    board = Chessboard("B", "1", (8, 6), 10.0, 0.01)
    raw = raw_of(read_colours(sorted((real / "boards/wide").iterdir())[0]), "GRBG")
    assert [finding.code for finding in image_findings(raw)] == ["image-raw"]
    with pytest.raises(DetectionError, match=r"raw picture of a colour camera.*--bayer") as refused:
        detect_board(raw, board)
    assert refused.value.fault == "camera"
    assert len(detect_board(BayerPlane("GRBG", "green").select(raw), board).number) >= 40
