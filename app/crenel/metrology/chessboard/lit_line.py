"""The laser's line across a lit board: dimmer than the white squares, perhaps, but brighter than
each square that it crosses."""

import math
from dataclasses import dataclass, replace

import cv2
import numpy as np
from numpy.typing import NDArray

from crenel.metrology.chessboard.board_detection import BoardDetection
from crenel.metrology.chessboard.detect_board import detect_board
from crenel.metrology.chessboard.laser_light import drop_faint_stripe
from crenel.metrology.chessboard.perspective import predict_corner
from crenel.metrology.detection.failure_evidence import DetectionError
from crenel.metrology.image import Image, saturation_level
from crenel.metrology.stripe import ANYWHERE, FoundLine, LineSearch, Stripe, empty_stripe
from crenel.metrology.targets.chessboard import Chessboard
from crenel.metrology.transforms import Floats

# Margin at the edges of a square, in shares of its height and at least in px.
EDGE_SHARE, EDGE_PX = 0.08, 2.5
FEWEST_PIXELS = 20
# The square's own level is this quantile of it: the line covers less than the rest.
OWN_LEVEL = 0.35
# Level of the squares in the levelled picture, in shares of the full scale.
LEVELLED = 1 / 16
# A square shows a line if so large a share of the columns in which it crosses the square does. A
# line of the laser is shown by so many squares, and by this share of those that it crosses.
COLUMNS_SHARE, FEWEST_SQUARES, SQUARES_SHARE = 0.5, 4, 0.6
# Pixels of a point's column within so many standard deviations of the line's width show one
# square; of a line whose core is clipped, within so many of its flanks' falls to half; and within
# so many pixels, whatever the width.
REACH_SIGMAS, REACH_FALLS, LEAST_REACH_PX = 2.5, 3.0, 6.0
# A line of which so large a share is clipped is measured in the picture as it is, so near to where
# it is found on the levelled squares, which no longer show that it is clipped.
CLIPPED_SHARE, NEAR_PX = 0.05, 6
# There it has at least this share of the points, or it is something else.
MEASURED_SHARE = 0.5


@dataclass(frozen=True)
class LevelledBoard:
    """A picture of a board in which every square has the same level, as has all else.

    ``square`` (H, W) numbers the squares from 1, black ones odd; it is 0 at their edges, and beside
    the board.
    """

    image: Image
    square: NDArray[np.int32]


def detect_lit_board(
    image: Image, board: Chessboard, axis: str, search: LineSearch = ANYWHERE
) -> tuple[BoardDetection, FoundLine, Image]:
    """The board and the laser's line in one picture of both lights.

    A line that outshines the board is found in the picture as it is, any other one by the levels
    of the squares that it crosses.

    Args:
        image: (H, W) grey, 8 to 16 bits, with ambient light and laser.
        axis: as in ``find_stripe``.
        search: what is said of the line.

    Returns:
        The corners, of which none lies under the line; the line, which may be empty; and the
        picture in which it was found.

    Raises:
        DetectionError: as ``detect_board``.
    """
    line = search.find(image, axis)
    if len(drop_faint_stripe(image, line.stripe).u):
        seen = detect_board(image, board, line.stripe)
        if board.markers is None:
            line = _without_edges(line, level_squares(image, board, seen))
        return seen, line, image
    seen = detect_board(image, board)
    levelled = level_squares(image, board, seen)
    line = search.find(levelled.image, axis, levelled.square > 0)
    if _crosses_squares(line, levelled, board):
        try:
            return (
                detect_board(image, board, _without_gaps(line.stripe, image)),
                _measure_clipped(image, line, levelled, search),
                levelled.image,
            )
        except DetectionError:  # the line covers too much of it
            pass
    return seen, FoundLine(empty_stripe(axis)), image


def _measure_clipped(
    image: Image, line: FoundLine, levelled: LevelledBoard, search: LineSearch
) -> FoundLine:
    """The line without edges: as the picture shows it, if it is clipped; else as it was found."""
    stripe, found = line.stripe, _without_edges(line, levelled)
    u, v = np.rint(stripe.u).astype(int), np.rint(stripe.v).astype(int)
    if (image[v, u] >= saturation_level(image)).mean() < CLIPPED_SHARE:
        return found
    near = np.zeros(image.shape, np.uint8)
    near[v, u] = 1
    size = 2 * math.ceil(NEAR_PX + line.broadest_px) + 1
    near = cv2.dilate(near, np.ones((size, size), np.uint8)).astype(np.uint8)
    seen = search.find(image, stripe.axis, (near > 0) & (levelled.square > 0))
    measured = _without_edges(seen, levelled)
    enough = len(measured.stripe.u) >= MEASURED_SHARE * len(found.stripe.u)
    return measured if enough else found


def _without_edges(line: FoundLine, levelled: LevelledBoard) -> FoundLine:
    """The line without the points beside which an edge of a square lies, which draws them away."""
    stripe = line.stripe
    square = levelled.square if stripe.axis == "u" else levelled.square.T
    pattern = _pattern(levelled.square)
    pattern = pattern if stripe.axis == "u" else pattern.T
    along, across = (np.rint(each).astype(int) for each in stripe.along_across)
    if line.core_px:
        reach = line.core_px / 2 + REACH_FALLS * line.fall_rows * line.factor
    else:
        reach = REACH_SIGMAS * line.sigma_rows * line.factor
    reach = max(reach, LEAST_REACH_PX)
    own = square[across.clip(0, len(square) - 1), along]
    inside, beside = own > 0, np.ones(len(own), np.bool_)
    for off in range(-math.ceil(reach), math.ceil(reach) + 1):
        rows = (across + off).clip(0, len(square) - 1)
        inside &= square[rows, along] == own
        beside &= ~pattern[rows, along]
    kept = inside | beside
    u, v, heights, sigma_px = (
        one[kept] for one in (stripe.u, stripe.v, stripe.intensity, stripe.sigma_px)
    )
    return replace(line, stripe=Stripe(u, v, heights, sigma_px, stripe.axis))


def _pattern(square: NDArray[np.int32]) -> NDArray[np.bool_]:
    """(H, W) pixels that lie within the outermost squares, edges included."""
    pattern = np.zeros(square.shape, np.uint8)
    places = np.argwhere(square > 0)[:, ::-1].astype(np.int32)
    if len(places):
        cv2.fillConvexPoly(pattern, cv2.convexHull(places), 1)
    return pattern > 0


def _without_gaps(stripe: Stripe, image: Image) -> Stripe:
    """The stripe all over the picture: as it runs between its points, and straight beyond them."""
    along, across = stripe.along_across
    every = np.arange(float(image.shape[1 if stripe.axis == "u" else 0]))
    straight = np.polyval(np.polyfit(along, across, 1), every)
    inside = (every >= along[0]) & (every <= along[-1])
    rows = np.where(inside, np.interp(every, along, across), straight)
    u, v = (every, rows) if stripe.axis == "u" else (rows, every)
    return Stripe(u, v, np.ones(len(u)), np.ones(len(u)), stripe.axis)


def level_squares(image: Image, board: Chessboard, seen: BoardDetection) -> LevelledBoard:
    """The picture (H, W) with all squares at one level, and nothing but squares.

    Clipped pixels are levelled too, so that the line is about as high and as wide on white squares
    as on black ones. White squares with markers are left out.
    """
    full = saturation_level(image)
    level = LEVELLED * full
    levelled = np.full(image.shape, level)
    square = np.zeros(image.shape, np.int32)
    at = _corners_px(board, seen)
    columns, rows = board.inner_corners
    number = 0
    for i in range(-1, columns):
        for j in range(-1, rows):
            number += 2
            is_black = ((i + j) % 2 == 0) == board.first_is_black
            quad = [at.get(place) for place in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1))]
            corners = np.array([uv for uv in quad if uv is not None])
            if len(corners) < 4 or (board.markers is not None and not is_black):
                continue
            where, inside = _square_pixels(corners, image.shape)
            if inside.sum() < FEWEST_PIXELS:
                continue
            grey = image[where][inside].astype(np.float64)
            levelled[where][inside] = grey - np.quantile(grey, OWN_LEVEL) + level
            square[where][inside] = number - is_black
    return LevelledBoard(np.clip(np.rint(levelled), 0, full).astype(image.dtype), square)


def _corners_px(board: Chessboard, seen: BoardDetection) -> dict[tuple[int, int], Floats]:
    """Pixels (2,) of all corners of squares that are known or can be predicted, by column and row;
    those of the outermost squares have -1 or one more than the last inner corner."""
    columns, rows = board.inner_corners
    places = np.column_stack([seen.number % columns, seen.number // columns])
    at = {(int(i), int(j)): uv for (i, j), uv in zip(places, seen.uv_px, strict=True)}
    for i in range(-1, columns + 1):
        for j in range(-1, rows + 1):
            if (i, j) in at:
                continue
            found = predict_corner(places, seen.uv_px, np.array([i, j]), certain=True)
            if found is not None:
                at[i, j] = found[0]
    return at


def _square_pixels(
    corners: Floats, shape: tuple[int, ...]
) -> tuple[tuple[slice, slice], NDArray[np.bool_]]:
    """The part of a picture about a square with corners (4, 2), and its pixels away from edges."""
    middle = corners.mean(axis=0)
    area_px2 = abs(float(cv2.contourArea(corners.astype(np.float32))))
    longest = float(np.linalg.norm(corners - np.roll(corners, 1, axis=0), axis=1).max())
    height_px = area_px2 / max(longest, 1.0)
    share = 1 - 2 * max(EDGE_PX / max(height_px, 1.0), EDGE_SHARE)
    inner = middle + max(share, 0.0) * (corners - middle)
    low = np.clip(np.floor(inner.min(axis=0)), 0, [shape[1], shape[0]]).astype(int)
    high = np.clip(np.ceil(inner.max(axis=0)) + 1, low, [shape[1], shape[0]]).astype(int)
    inside = np.zeros((high[1] - low[1], high[0] - low[0]), np.uint8)
    if inside.size and share > 0:
        cv2.fillConvexPoly(inside, np.rint((inner - low) * 16).astype(np.int32), 1, shift=4)
    return np.s_[low[1] : high[1], low[0] : high[0]], inside > 0


def _crosses_squares(line: FoundLine, levelled: LevelledBoard, board: Chessboard) -> bool:
    """Whether most squares between the ends of a line show it, of either colour."""
    along, across = line.stripe.along_across
    if len(along) < 2:
        return False
    square = levelled.square if line.stripe.axis == "u" else levelled.square.T
    every = np.arange(int(along[0]), int(along[-1]) + 1)
    rows = np.interp(every, along, across)
    crossed = square[np.clip(np.rint(rows).astype(int), 0, square.shape[0] - 1), every]
    shown = np.isin(every, np.rint(along).astype(int))
    numbers = np.unique(crossed[crossed > 0])
    shows = np.array([shown[crossed == one].mean() >= COLUMNS_SHARE for one in numbers], bool)
    if shows.sum() < FEWEST_SQUARES or shows.mean() < SQUARES_SHARE:
        return False
    is_black = numbers % 2 == 1
    return board.markers is not None or (
        bool(shows[is_black].any()) and bool(shows[~is_black].any())
    )
