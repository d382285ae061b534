"""The inner corners of a chessboard in a picture, each identified by its position on the board."""

from collections.abc import Iterator
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from app.metrology.chessboard.corner_fit import fit_corner
from app.metrology.chessboard.failure_evidence import BoardFailure, explain_failure, is_larger
from app.metrology.chessboard.lattice import Lattice, find_lattices
from app.metrology.chessboard.missing_corners import CornerGrid
from app.metrology.chessboard.opencv_finders import find_by_opencv
from app.metrology.chessboard.perspective import fit_perspective, map_places, predict_corner
from app.metrology.chessboard.saddle_points import Saddles, find_saddles
from app.metrology.chessboard.window import find_window
from app.metrology.image import Image, saturation_level
from app.metrology.stripe import Stripe, empty_stripe
from app.metrology.targets.chessboard import Chessboard
from app.metrology.transforms import Floats

# Pixels this close to clipped ones or to the middle of the stripe show laser light.
CLIPPED_MARGIN_PX, STRIPE_MARGIN_PX = 8, 12
# Clipped pixels this near to the stripe's middle are its own, and not a white square's.
CLIPPED_REACH_PX = 30
# Weaker points than this share of the stripe's usual brightness are none of it.
STRIPE_SHARE = 0.5
# Ratio of the laser line's brightness to the board's, and share of the picture that the white of
# the board covers.
OUTSHINES, DARKER_SHARE = 1.15, 0.95
# A board that covers less than this of one that cannot be numbered is a picture of it, or far off.
SMALLER = 0.5
# Share of the corners that must be seen; and by which more than it has show a larger board.
LEAST_VISIBLE, SURELY_MORE = 0.5, 0.08
# Sizes in which the board is looked for, by the picture's longer side, where they differ from
# the picture's own by more than this; and how many grids of each are considered.
LONGER_SIDES_PX = (1280, 640, 2560)
ALIKE, MOST_ENLARGED = 1.45, 2.0
GRIDS = 2
# Corners further than this off a perspective of all, and this often the usual, are left out.
MISFIT_PX, MISFIT_TIMES = 0.5, 6.0


@dataclass(frozen=True)
class BoardDetection:
    """N corners of the board in one picture.

    ``number`` (N,) is the index of each in ``corner_points``; if the colours are ambiguous,
    ``other_numbers`` holds the other numberings, each equally good. ``covariance_px2`` follows from
    the picture noise around each corner.
    """

    uv_px: Floats  # (N, 2)
    covariance_px2: Floats  # (N, 2, 2)
    number: NDArray[np.int64]  # (N,)
    other_numbers: tuple[NDArray[np.int64], ...] = ()

    def __len__(self) -> int:
        return len(self.number)


@dataclass(frozen=True)
class _Measured:
    """Corners that could be measured: pixels, covariances, and which of the grid's they are."""

    uv_px: Floats  # (M, 2)
    covariance_px2: Floats  # (M, 2, 2)
    index: NDArray[np.int64]  # (M,)


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
            ``board-too-small`` or ``board-blurred``, with the cause, and with the parts of the
            board that were detected.
    """
    columns, rows = board.inner_corners
    blocked = _laser_mask(image, stripe)
    nearest: _Refused | None = None
    for saddles, lattice in _find_grids(image, blocked, board, thorough):
        measured = _measure_corners(image, blocked, saddles, lattice)
        seen, area_px2 = len(measured.index), _hull_area_px2(measured.uv_px)
        if nearest is not None and area_px2 <= SMALLER * nearest.area_px2:
            continue
        detection = _number_corners(board, saddles, lattice, measured)
        if detection is not None:
            return detection
        failure = _failure(image, blocked, saddles, lattice, measured, board)
        if nearest is None or seen > nearest.seen:
            area_px2 = area_px2 if seen > LEAST_VISIBLE * columns * rows else 0.0
            nearest = _Refused(seen, area_px2, failure)
        if seen > (1 + SURELY_MORE) * columns * rows and is_larger(board, failure.grid):
            break
    assert nearest is not None
    raise explain_failure(board, nearest.failure)


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
    if thorough:
        if unscaled is None:
            unscaled = find_saddles(image, blocked)
        yield from find_by_opencv(image, board.inner_corners, unscaled)


def _number_corners(
    board: Chessboard, saddles: Saddles, lattice: Lattice, measured: _Measured
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
    kept = _agreeing(board, uv, numbers[0])
    return BoardDetection(
        uv[kept], covariance[kept], numbers[0][kept], tuple(other[kept] for other in numbers[1:])
    )


def _failure(
    image: Image,
    blocked: NDArray[np.bool_],
    saddles: Saddles,
    lattice: Lattice,
    measured: _Measured,
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


def drop_faint_stripe(image: Image, stripe: Stripe) -> Stripe:
    """The stripe, or an empty one if it is not brighter than the white squares.

    Bright squares between black ones look like a stripe if the laser line is outside the image.

    Args:
        image: (H, W) grey, 8 to 16 bits, with ambient light and laser.
        stripe: as extracted from this image.
    """
    if not len(stripe.u):
        return stripe
    u, v = (np.round(x).astype(np.int64) for x in (stripe.u, stripe.v))
    at = image[np.clip(v, 0, image.shape[0] - 1), np.clip(u, 0, image.shape[1] - 1)]
    white = float(np.quantile(image, DARKER_SHARE))
    if np.median(at) >= min(OUTSHINES * white, saturation_level(image)):
        return stripe
    return empty_stripe(stripe.axis)


def _laser_mask(image: Image, stripe: Stripe | None) -> NDArray[np.bool_]:
    """(H, W) pixels that the laser's line has spoilt: its own, and the clipped ones about it."""
    if stripe is None or not len(stripe.u):
        return np.zeros(image.shape, dtype=np.bool_)
    own = stripe.intensity > STRIPE_SHARE * float(np.median(stripe.intensity))
    middle = np.zeros(image.shape, np.uint8)
    u, v = (np.round(x[own]).astype(np.int64) for x in (stripe.u, stripe.v))
    middle[np.clip(v, 0, image.shape[0] - 1), np.clip(u, 0, image.shape[1] - 1)] = 1
    near = _dilate(middle, CLIPPED_REACH_PX)
    clipped = (image >= saturation_level(image)).astype(np.uint8) & near
    return (_dilate(middle, STRIPE_MARGIN_PX) | _dilate(clipped, CLIPPED_MARGIN_PX)) > 0


def _dilate(mask: NDArray[np.uint8], margin_px: int) -> NDArray[np.uint8]:
    size = 2 * margin_px + 1
    return np.asarray(cv2.dilate(mask, np.ones((size, size), np.uint8)), np.uint8)


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
        if float(np.median(right[:, 0] * up[:, 1] - right[:, 1] * up[:, 0])) > 0:
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
) -> _Measured:
    uv, covariance, index = [], [], []
    for k, (place, saddle) in enumerate(lattice.items()):
        at = saddles.uv_px[saddle]
        spacing = _spacing(saddles, lattice, place)
        found = fit_corner(image, blocked, at, float(saddles.phase[saddle]), spacing)
        if found is not None:
            uv.append(found.uv_px)
            covariance.append(found.covariance_px2)
            index.append(k)
    return _Measured(
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


def _agreeing(board: Chessboard, uv: Floats, number: NDArray[np.int64]) -> NDArray[np.bool_]:
    """Which corners lie where a perspective of those around puts them, to a lens's distortion."""
    columns = board.inner_corners[0]
    places = np.column_stack([number % columns, number // columns])
    predicted = [predict_corner(places, uv, place) for place in places]
    off = np.array(
        [
            0.0 if one is None else float(np.linalg.norm(one[0] - at))
            for one, at in zip(predicted, uv, strict=True)
        ]
    )
    return np.asarray(off < max(MISFIT_PX, MISFIT_TIMES * float(np.median(off))))
