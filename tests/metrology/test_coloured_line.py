"""Laser lines of lit rooms, found by their colour; and coloured things that are none."""

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray

from crenel.metrology.colour import PLANES, LaserColour
from crenel.metrology.coloured_line import ColouredLine, find_coloured_line
from crenel.metrology.stripe import find_stripe
from crenel.metrology.transforms import Floats

COLOURS: tuple[LaserColour, ...] = tuple(PLANES)
HEIGHT, WIDTH = 240, 400
SQUARE = 80
"""Side of the squares of a board, black and white."""


def line_rows(u: Floats) -> Floats:
    return np.asarray(118 + 0.02 * u + 6 * np.sin(u / 60))


def lit_room(seed: int = 0) -> Floats:
    """(H, W, 3) A board on a table of wood, with a white strip above and warm light."""
    v, u = np.mgrid[:HEIGHT, :WIDTH]
    grey = np.where((v // SQUARE + u // SQUARE) % 2, 200.0, 50.0)
    room = grey[..., None] * np.array([0.85, 0.95, 1.0])
    room[:, 250:] = np.array([70.0, 110.0, 150.0])
    room[20:32, :250] = 250.0
    room += np.random.default_rng(seed).normal(0, 3, (HEIGHT, WIDTH, 1))
    return np.asarray(cv2.GaussianBlur(room, (0, 0), 0.8))


def with_line(
    room: Floats, colour: LaserColour, width_px: float, height: float = 160.0, leak: float = 0.2
) -> Floats:
    away = np.arange(HEIGHT)[:, None] - line_rows(np.arange(WIDTH, dtype=np.float64))
    beam = height * np.exp(-4 * np.log(2) * (away / width_px) ** 2)
    sees = np.full(3, leak)
    sees[PLANES[colour]] = 1.0
    return np.asarray(room + beam[..., None] * sees * (0.2 + 0.8 * room / 255))


def expose(light: Floats, seed: int = 1) -> NDArray[np.uint8]:
    noisy = light + np.random.default_rng(seed).normal(0, 1.5, light.shape)
    return np.clip(np.rint(noisy), 0, 255).astype(np.uint8)


def found_share(line: ColouredLine | None, off_px: float) -> float:
    """The share of the columns with a point no further off than that."""
    assert line is not None
    stripe = line.found.stripe
    return float((np.abs(stripe.v - line_rows(stripe.u)) <= off_px).sum() / WIDTH)


@pytest.mark.parametrize("colour", COLOURS)
@pytest.mark.parametrize("width_px", [3.0, 6.0, 12.0])
def test_lines_of_any_colour_are_found_in_a_lit_room(colour: LaserColour, width_px: float) -> None:
    picture = expose(with_line(lit_room(), colour, width_px))
    line = find_coloured_line(picture, "u", COLOURS)
    assert line is not None
    assert line.colour == colour
    assert found_share(line, max(1.5, width_px / 5)) >= 0.9
    stripe = line.found.stripe
    assert (np.abs(stripe.v - line_rows(stripe.u)) > max(3, width_px / 2)).mean() < 0.01


def test_the_channel_alone_shows_less_there() -> None:
    picture = expose(with_line(lit_room(), "red", 8.0, height=80.0))
    grey = np.ascontiguousarray(picture[..., PLANES["red"]])
    assert len(find_stripe(grey).stripe.u) < 0.7 * WIDTH
    assert found_share(find_coloured_line(picture, "u", COLOURS), 2.0) >= 0.9


def test_a_core_that_clips_to_white_is_joined_to_its_flanks() -> None:
    picture = expose(with_line(lit_room(), "green", 9.0, height=1500.0, leak=0.3))
    white = (picture == 255).all(axis=2)
    assert white[:, :250].any(axis=0).mean() > 0.5
    assert found_share(find_coloured_line(picture, "u", COLOURS), 3.0) >= 0.9


def test_jpeg_leaves_the_line() -> None:
    picture = expose(with_line(lit_room(), "red", 5.0))
    raw = cv2.imencode(".jpg", picture, [cv2.IMWRITE_JPEG_QUALITY, 80])[1]
    stored = np.asarray(cv2.imdecode(raw, cv2.IMREAD_COLOR), np.uint8)
    assert found_share(find_coloured_line(stored, "u", COLOURS), 2.0) >= 0.9


def test_lines_run_along_either_axis_and_in_16_bits() -> None:
    picture = expose(with_line(lit_room(), "blue", 6.0))
    upright = np.ascontiguousarray(picture.transpose(1, 0, 2)).astype(np.uint16) * 16
    upright[0, 0] = 4095
    line, other = (
        find_coloured_line(one, axis, COLOURS) for one, axis in ((picture, "u"), (upright, "v"))
    )
    assert line is not None
    assert other is not None
    u, v = other.found.stripe.along_across
    assert np.abs(v - line_rows(u)).max() < 6
    assert len(u) == pytest.approx(len(line.found.stripe.u), abs=8)


def test_nothing_is_found_without_a_line() -> None:
    assert find_coloured_line(expose(lit_room()), "u", COLOURS) is None


def test_a_dark_red_cable_is_no_line() -> None:
    """It takes the light of the other channels away, and adds none of its own."""
    room = lit_room()
    away = np.arange(HEIGHT)[:, None] - line_rows(np.arange(WIDTH, dtype=np.float64))
    on_cable = np.abs(away) <= 3
    room[on_cable] = np.array([20.0, 20.0, 140.0])
    room[:, :250][on_cable[:, :250]] = np.array([15.0, 15.0, 45.0])
    assert find_coloured_line(expose(room), "u", COLOURS) is None


def test_a_mask_says_where_the_line_may_lie() -> None:
    picture = expose(with_line(lit_room(), "red", 6.0))
    where = np.zeros((HEIGHT, WIDTH), np.bool_)
    where[:80] = True
    assert find_coloured_line(picture, "u", COLOURS, where) is None
    where[80:] = True
    assert found_share(find_coloured_line(picture, "u", COLOURS, where), 2.0) >= 0.9


def test_stated_noise_is_what_points_scatter_by() -> None:
    room = np.full((HEIGHT, WIDTH, 3), 120.0)
    line = find_coloured_line(expose(with_line(room, "green", 8.0)), "u", COLOURS)
    assert line is not None
    stripe = line.found.stripe
    off = (stripe.v - line_rows(stripe.u)) / stripe.sigma_px
    assert 0.7 < float(np.sqrt(np.mean(off**2))) < 1.3
