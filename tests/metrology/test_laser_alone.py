"""The laser's light alone: a picture with it less one without it, in a lit room."""

from dataclasses import replace

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray

from crenel.metrology.adjustment.board.calibrate import observe_board
from crenel.metrology.stripe import Stripe, find_stripe, take_off_room_light
from crenel.metrology.transforms import Floats
from tests.metrology.boards import POSES, Look, picture
from tests.pictures import compressed

Picture = NDArray[np.uint8]
SIZE = (360, 480)
SIGMA_PX = 2.0


def furnished_room(seed: int) -> Floats:
    """Grey levels (H, W) of bright and dark things with edges in all directions, and of texture."""
    rng = np.random.default_rng(seed)
    levels = np.full(SIZE, 150.0)
    for _ in range(40):
        centre = rng.uniform((0, 0), SIZE[::-1])
        box = (tuple(centre), tuple(rng.uniform(20, 120, 2)), rng.uniform(0, 90))
        corners = cv2.boxPoints(box).astype(np.int32)
        cv2.fillConvexPoly(levels, corners, float(rng.uniform(40, 210)))
    levels += cv2.GaussianBlur(rng.normal(0, 30, SIZE), (0, 0), 2.0)
    return np.asarray(cv2.GaussianBlur(levels, (0, 0), 1.0))


def line_rows() -> Floats:
    columns = np.arange(SIZE[1])
    return np.asarray(180.3 + 25 * np.sin(columns / 90))


def photograph(levels: Floats, rng: np.random.Generator, depth: int = 8) -> NDArray[np.uint16]:
    noisy = (levels + rng.normal(0, 1.5, SIZE)) * 2.0 ** (depth - 8)
    return np.clip(np.round(noisy), 0, 2.0**depth - 1).astype(np.uint16)


def pair(seed: int, contrast: float, moved_px: float = 0.0, gain: float = 1.0) -> list[Picture]:
    """A picture with a line dimmer than its surroundings, and one without, of 8 bits."""
    rng, room = np.random.default_rng(seed + 100), furnished_room(seed)
    off = (np.arange(SIZE[0])[:, None] - line_rows()) / SIGMA_PX
    lit = room * (1 + contrast / 150 * np.exp(-0.5 * off**2))
    move = np.array([[1.0, 0.0, moved_px], [0.0, 1.0, moved_px]])
    unlit = gain * cv2.warpAffine(room, move, SIZE[::-1], borderMode=cv2.BORDER_REPLICATE)
    return [photograph(np.asarray(one), rng).astype(np.uint8) for one in (lit, unlit)]


def share_found(stripe: Stripe) -> float:
    """Columns whose point lies on the line."""
    off = np.abs(stripe.v - line_rows()[stripe.u.astype(int)])
    return float(np.sum(off < 1.0)) / SIZE[1]


@pytest.mark.parametrize("gain", [1.0, 0.9])
@pytest.mark.parametrize("seed", [1, 2, 3])
def test_a_line_that_a_lit_room_hides_is_found_in_the_difference(seed: int, gain: float) -> None:
    lit, unlit = pair(seed, 30.0, gain=gain)
    alone = take_off_room_light(lit, unlit)
    assert alone.is_difference
    assert share_found(find_stripe(lit).stripe) < 0.1
    stripe = find_stripe(alone.image).stripe
    assert share_found(stripe) > 0.85  # on the darkest things, the line is as high as the noise
    assert len(stripe.u) - SIZE[1] * share_found(stripe) < 0.01 * SIZE[1]
    height = np.median(alone.in_levels(stripe).intensity)
    assert 15 < height < 45


def test_pictures_of_twelve_bits_are_subtracted_too() -> None:
    room, rng = furnished_room(4), np.random.default_rng(4)
    off = (np.arange(SIZE[0])[:, None] - line_rows()) / SIGMA_PX
    levels = (room + 40.0 * np.exp(-0.5 * off**2), room)
    alone = take_off_room_light(*(photograph(one, rng, depth=12) for one in levels))
    assert alone.is_difference
    stripe = find_stripe(alone.image).stripe
    assert share_found(stripe) > 0.95
    assert np.median(alone.in_levels(stripe).intensity) == pytest.approx(16 * 40, rel=0.1)


@pytest.mark.parametrize("moved_px", [0.25, 1.0, 4.0])
def test_motion_between_the_pictures_is_noticed(moved_px: float) -> None:
    lit, unlit = pair(5, 30.0, moved_px)
    alone = take_off_room_light(lit, unlit)
    assert alone.shifted > 0.2
    assert alone.image is lit


@pytest.mark.parametrize("quality", [95, 60])
def test_compression_is_no_motion(quality: int) -> None:
    lit, unlit = (compressed(one, quality) for one in pair(6, 40.0))
    assert take_off_room_light(lit, unlit).is_difference


def test_a_picture_of_the_laser_in_the_dark_stands_for_itself() -> None:
    room, rng = furnished_room(7), np.random.default_rng(7)
    off = (np.arange(SIZE[0])[:, None] - line_rows()) / SIGMA_PX
    dark = photograph(0.02 * room + 200.0 * np.exp(-0.5 * off**2), rng)
    for unlit in (photograph(room, rng), photograph(0.02 * room, rng), dark[:, :-1]):
        alone = take_off_room_light(dark, unlit)
        assert (alone.image is dark, alone.is_difference, alone.shifted) == (True, False, 0.0)


def test_a_line_on_a_lit_board_is_found_by_the_picture_without_it() -> None:
    look = Look(line_level=20.0, offset_mm=150.0)
    for number, T in enumerate(POSES[:3], 1):
        lit, unlit = picture(T, look, number), picture(T, replace(look, laser=False), number + 50)
        seen = observe_board(number, look.board, unlit, lit, "v")
        assert len(seen.stripe.v) > 500
        assert seen.image_findings == ()
        moved = np.roll(lit, 2, axis=1)
        (finding,) = observe_board(number, look.board, unlit, moved, "v").image_findings
        assert finding.code == "image-moved"
