"""The inner corners of a chessboard in a picture, each identified by its position on the board."""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import cv2
import numpy as np
from numpy.typing import NDArray

from crenel.metrology.chessboard.board_detection import (
    BoardDetection,
    MeasuredCorners,
    agreeing_corners,
)
from crenel.metrology.chessboard.charuco_board.detect_charuco import detect_charuco
from crenel.metrology.chessboard.corner_fit import fit_corner
from crenel.metrology.chessboard.failure_evidence import (
    BoardFailure,
    explain_failure,
    is_larger,
    refuse_slanted,
)
from crenel.metrology.chessboard.laser_light import laser_mask
from crenel.metrology.chessboard.lattice import Lattice, find_lattices
from crenel.metrology.chessboard.missing_corners import CornerGrid
from crenel.metrology.chessboard.opencv_finders import find_by_opencv
from crenel.metrology.chessboard.perspective import fit_perspective, map_places
from crenel.metrology.chessboard.saddle_points import Saddles, find_saddles
from crenel.metrology.chessboard.slanted_board import find_slanted_board
from crenel.metrology.chessboard.two_boards import (
    is_cut_off_board,
    refuse_two_boards,
    saddles_outside,
)
from crenel.metrology.chessboard.window import find_window
from crenel.metrology.image import Image
from crenel.metrology.mosaic import shows_mosaic
from crenel.metrology.robust import median
from crenel.metrology.stripe import Stripe
from crenel.metrology.targets.chessboard import Chessboard
from crenel.metrology.transforms import Floats

# A board that covers less than this of one that cannot be numbered is a picture of it, or far off.
SMALLER = 0.5
# Share of the corners that must be seen; and by which more than it has show a larger board.
LEAST_VISIBLE, SURELY_MORE = 0.5, 0.08
# Sizes in which the board is looked for, by the picture's longer side, where they differ from
# the picture's own by more than this; and how many grids of each are considered.
LONGER_SIDES_PX = (1280, 640, 2560)
ALIKE, MOST_ENLARGED = 1.45, 2.0
GRIDS = 2


@dataclass(frozen=True)
class _Refused:
    """A grid that cannot be numbered: corners measured, and the area of one that is a board."""

    seen: int
    area_px2: float
    failure: BoardFailure


def detect_board(
    image: Image, board: Chessboard, stripe: Stripe | None = None, *, thorough: bool = True
) -> BoardDetection:
    """Every inner corner of the board that can be measured, without a starting guess.

    The board's size is what is looked for: corners of outlines, shadows and patterns beside it
    are left out, and so is each corner that is covered, glared over or under the laser stripe.

    Args:
        image: (H, W) grey, 8 to 16 bits.
        board: the board by its certificate.
        stripe: the laser stripe in the same image, where the laser was on.
        thorough: also in other sizes of the picture and by OpenCV's finders, which a live
            picture has no time for.

    Returns:
        Pixels (N, 2) with their covariance, and the number of each corner. If the colours of the
        board are ambiguous, all numberings are returned.

    Raises:
        DetectionError: ``board-not-found``, ``another-board``, ``board-partly-seen``,
            ``board-too-small``, ``board-blurred`` or ``two-boards``, with the cause, and with the
            parts of the board that were detected.
    """
    columns, rows = board.inner_corners
    blocked = laser_mask(image, stripe)
    if board.markers is not None:
        return detect_charuco(image, board, board.markers, blocked, thorough=thorough)
    nearest: _Refused | None = None
    refused: list[CornerGrid] = []
    for saddles, lattice in _find_grids(image, blocked, board, thorough):
        measured = _measure_corners(image, blocked, saddles, lattice)
        seen, area_px2 = len(measured.index), _hull_area_px2(measured.uv_px)
        if nearest is not None and area_px2 <= SMALLER * nearest.area_px2:
            continue
        detection = _number_corners(board, saddles, lattice, measured)
        if detection is not None:
            return _only_board(image, blocked, board, saddles, detection)
        failure = _failure(image, blocked, saddles, lattice, measured, board)
        refused += [failure.grid, failure.measurable_grid()]
        if nearest is None or seen > nearest.seen:
            area_px2 = area_px2 if seen > LEAST_VISIBLE * columns * rows else 0.0
            nearest = _Refused(seen, area_px2, failure)
        if seen > (1 + SURELY_MORE) * columns * rows and is_larger(board, failure.grid):
            break
    assert nearest is not None
    if thorough and nearest.failure.within is None:
        slanted = find_slanted_board(image, blocked, board)
        if slanted is not None:
            raise refuse_slanted(board, slanted)
    raise explain_failure(board, replace(nearest.failure, refused=tuple(refused)))


def _hull_area_px2(uv: Floats) -> float:
    return float(cv2.contourArea(cv2.convexHull(uv.astype(np.float32)))) if len(uv) > 2 else 0.0


def _find_grids(
    image: Image, blocked: NDArray[np.bool_], board: Chessboard, thorough: bool
) -> Iterator[tuple[Saddles, Lattice]]:
    """What may be the board's corners, the likeliest first; at least one, if an empty one."""
    columns, rows = board.inner_corners
    longer_px = max(image.shape)
    scales = [1.0] if longer_px < 2 * LONGER_SIDES_PX[0] else []
    for wanted_px in LONGER_SIDES_PX:
        scale = min(wanted_px / longer_px, MOST_ENLARGED)
        if all(max(scale, one) / min(scale, one) > ALIKE for one in scales):
            scales.append(scale)
    unscaled: Saddles | None = None
    for scale in scales if thorough else scales[:1]:
        saddles = find_saddles(image, blocked, scale)
        unscaled = saddles if scale == 1.0 else unscaled
        lattices = find_lattices(saddles, columns * rows)
        for lattice in lattices[:GRIDS] or [{}]:
            yield saddles, lattice
    # in raw pixels OpenCV's finder sees many thousands of squares, and takes half a minute
    if thorough and not shows_mosaic(image):
        if unscaled is None:
            unscaled = find_saddles(image, blocked)
        yield from find_by_opencv(image, board.inner_corners, unscaled)


def _number_corners(
    board: Chessboard, saddles: Saddles, lattice: Lattice, measured: MeasuredCorners
) -> BoardDetection | None:
    """The corners of the one window of the board's size; None where none is certain."""
    columns, rows = board.inner_corners
    places = np.array(list(lattice), dtype=np.int64).reshape(-1, 2)
    within = find_window(places[measured.index], board.inner_corners)
    if within is None or within.sum() < LEAST_VISIBLE * columns * rows:
        return None
    index = measured.index[within]
    uv, covariance = measured.uv_px[within], measured.covariance_px2[within]
    numbers = _numberings(places[index], saddles.phase[list(lattice.values())][index], uv, board)
    kept = agreeing_corners(board, uv, numbers[0])
    return BoardDetection(
        uv[kept], covariance[kept], numbers[0][kept], tuple(other[kept] for other in numbers[1:])
    )


def _only_board(
    image: Image,
    blocked: NDArray[np.bool_],
    board: Chessboard,
    saddles: Saddles,
    found: BoardDetection,
) -> BoardDetection:
    """The board found, or a much larger one beside it; raises where two are about as large.

    Raises also beside one that is partly out of the picture, unless that one is much smaller.
    """
    beside = saddles_outside(image, saddles, found.uv_px)
    for lattice in find_lattices(beside, int(np.prod(board.inner_corners)))[:GRIDS]:
        measured = _measure_corners(image, blocked, beside, lattice)
        other = _number_corners(board, beside, lattice, measured)
        if other is None:
            places = np.array(list(lattice), dtype=np.int64)[measured.index]
            part = CornerGrid(image, blocked, places, measured.uv_px)
            if is_cut_off_board(board, part) and _is_as_near(part, found, board):
                corners = [found.uv_px, part.uv_px]
                raise refuse_two_boards(board, image, corners, second_is_whole=False)
            continue
        areas_px2 = [_hull_area_px2(one.uv_px) for one in (found, other)]
        if min(areas_px2) > SMALLER * max(areas_px2):
            raise refuse_two_boards(board, image, [found.uv_px, other.uv_px])
        found = max(found, other, key=lambda one: _hull_area_px2(one.uv_px))
    return found


def _is_as_near(part: CornerGrid, found: BoardDetection, board: Chessboard) -> bool:
    """Whether the squares of a part of a board are not much smaller than those of one found."""
    number, columns = found.number, board.inner_corners[0]
    places = np.column_stack([number % columns, number // columns])
    whole = CornerGrid(part.image, part.laser, places, found.uv_px)
    return part.spacing_px() ** 2 > SMALLER * whole.spacing_px() ** 2


def _failure(
    image: Image,
    blocked: NDArray[np.bool_],
    saddles: Saddles,
    lattice: Lattice,
    measured: MeasuredCorners,
    board: Chessboard,
) -> BoardFailure:
    places = np.array(list(lattice), dtype=np.int64).reshape(-1, 2)
    can_be_measured = np.zeros(len(places), dtype=np.bool_)
    can_be_measured[measured.index] = True
    within = find_window(places, board.inner_corners)
    if within is not None and within.sum() < LEAST_VISIBLE * np.prod(board.inner_corners):
        within = None
    grid = CornerGrid(image, blocked, places, saddles.uv_px[list(lattice.values())])
    return BoardFailure(grid, can_be_measured, within)


def _numberings(
    places: NDArray[np.int64], phase: Floats, uv: Floats, board: Chessboard
) -> list[NDArray[np.int64]]:
    """Each way to number the corners (N,) that turns and colours allow.

    Z points to the camera, so that Y is to the left of X in the picture; the square outside the
    first corner is black if the square outside any such corner is.
    """
    columns, rows = board.inner_corners
    black: list[NDArray[np.int64]] = []
    white: list[NDArray[np.int64]] = []
    for turned in _grid_orientations(places - places.min(axis=0)):
        if tuple(turned.max(axis=0) + 1) != (columns, rows):
            continue
        H = fit_perspective(turned, uv)
        right, up = (map_places(H, turned + np.array(way)) - uv for way in ((1, 0), (0, 1)))
        if median(right[:, 0] * up[:, 1] - right[:, 1] * up[:, 0]) > 0:
            continue  # seen from behind
        across = map_places(H, turned + 1) - uv
        angle = np.arctan2(across[:, 1], across[:, 0])
        sign = 1 - 2 * (turned.sum(axis=1) % 2)
        bright = float(np.mean(sign * np.cos(2 * angle + phase))) > 0
        (white if bright else black).append(turned[:, 1] * columns + turned[:, 0])
    return black or white


def _grid_orientations(places: NDArray[np.int64]) -> list[NDArray[np.int64]]:
    """The eight ways to count columns and rows (N, 2) from a corner of the grid."""
    high = places.max(axis=0)
    ways = []
    for flip in ((0, 0), (1, 0), (0, 1), (1, 1)):
        flipped = np.where(np.array(flip, dtype=np.bool_), high - places, places)
        ways += [flipped, flipped[:, ::-1]]
    return ways


def _measure_corners(
    image: Image, blocked: NDArray[np.bool_], saddles: Saddles, lattice: Lattice
) -> MeasuredCorners:
    uv, covariance, index = [], [], []
    for k, (place, saddle) in enumerate(lattice.items()):
        at = saddles.uv_px[saddle]
        spacing = _spacing(saddles, lattice, place)
        found = fit_corner(image, blocked, at, float(saddles.phase[saddle]), spacing)
        if found is not None:
            uv.append(found.uv_px)
            covariance.append(found.covariance_px2)
            index.append(k)
    return MeasuredCorners(
        np.array(uv).reshape(-1, 2),
        np.array(covariance).reshape(-1, 2, 2),
        np.array(index, dtype=np.int64),
    )


def _spacing(saddles: Saddles, lattice: Lattice, place: tuple[int, int]) -> float:
    """Pixels to the nearest neighbour of a corner."""
    i, j = place
    beside = [lattice.get((i + a, j + b)) for a, b in ((1, 0), (-1, 0), (0, 1), (0, -1))]
    at = saddles.uv_px[lattice[place]]
    away = [float(np.linalg.norm(saddles.uv_px[k] - at)) for k in beside if k is not None]
    return min(away, default=0.0)
