"""The inner corners of a chessboard in a picture, each known by its place on the board."""

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from app.errors import OperationError
from app.messages.message import message
from app.metrology.chessboard.corner_fit import fit_corner
from app.metrology.chessboard.failure_evidence import with_board_evidence
from app.metrology.chessboard.grid import Lattice, fit_perspective, largest_lattice, map_places
from app.metrology.chessboard.saddle_points import Saddles, find_saddles
from app.metrology.image import Image, saturation_level
from app.metrology.stripe import Stripe, empty_stripe
from app.metrology.targets.chessboard import Chessboard
from app.metrology.transforms import Floats

# Pixels this near to clipped ones or to the stripe's middle show laser light.
CLIPPED_MARGIN_PX, STRIPE_MARGIN_PX = 8, 12
# Weaker points than this share of the stripe's usual brightness are none of it.
STRIPE_SHARE = 0.5
# The laser's line outshines the board by this, and the board's white this share of a picture.
OUTSHINES, DARKER_SHARE = 1.15, 0.95
# Share of the corners that must be seen, and on each side of the pattern.
LEAST_VISIBLE, LEAST_ON_A_SIDE = 0.5, 2
# Corners further than this off a perspective of all, and this often the usual, are left out.
MISFIT_PX, MISFIT_TIMES = 0.5, 6.0


@dataclass(frozen=True)
class BoardDetection:
    """N corners of the board in one picture.

    ``number`` (N,) says which of ``corner_points`` each is; where the colours leave a
    choice, ``other_numbers`` holds the others, each as good. ``covariance_px2`` is by
    the picture's noise around each corner.
    """

    uv_px: Floats  # (N, 2)
    covariance_px2: Floats  # (N, 2, 2)
    number: NDArray[np.int64]  # (N,)
    other_numbers: tuple[NDArray[np.int64], ...] = ()

    def __len__(self) -> int:
        return len(self.number)


def detect_board(image: Image, board: Chessboard, stripe: Stripe | None = None) -> BoardDetection:
    """Every inner corner of the board that can be measured, without a starting guess.

    Corners under the laser stripe are left out.

    Args:
        image: (H, W) grey, 8 to 16 bits.
        board: the board by its certificate.
        stripe: the laser stripe in the same image, where the laser was on.

    Returns:
        Pixels (N, 2) with their covariance, and which corner each one is. Where the colours of
        the board leave a choice, all numberings are given.

    Raises:
        DetectionError: ``board-not-found``, ``another-board``, ``board-partly-seen`` or
            ``board-blurred``, with what is at fault and what was found of the board.
    """
    blocked = _laser_mask(image, stripe)
    saddles = find_saddles(image, blocked)
    columns, rows = board.inner_corners
    lattice = largest_lattice(saddles, columns * rows)
    try:
        return _number_corners(image, blocked, board, saddles, lattice)
    except OperationError as refusal:
        raise with_board_evidence(refusal, image, saddles, lattice) from refusal


def _number_corners(
    image: Image,
    blocked: NDArray[np.bool_],
    board: Chessboard,
    saddles: Saddles,
    lattice: Lattice,
) -> BoardDetection:
    columns, rows = board.inner_corners
    _refuse_other_board(lattice, board)
    ways = _numberings(saddles, lattice, board)
    uv, covariance, taken = _measure_corners(image, blocked, saddles, lattice)
    if len(taken) < LEAST_VISIBLE * columns * rows:
        raise OperationError(
            "board-blurred",
            message(
                "corners-can-measured", found=len(taken), corners=columns * rows, name=board.name
            ),
            message("picture-blurred-noisy-lasers-line-lies"),
            message("focus-light-board-evenly"),
        )
    numbers = [way[taken] for way in ways]
    kept = _agreeing(board, uv, numbers[0])
    return BoardDetection(
        uv[kept], covariance[kept], numbers[0][kept], tuple(other[kept] for other in numbers[1:])
    )


def drop_faint_stripe(image: Image, stripe: Stripe) -> Stripe:
    """The stripe, or an empty one where it is not brighter than the white squares.

    Bright squares between black ones look like a stripe where the laser line is outside the
    image.

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
    """(H, W) pixels that the laser's line has spoilt."""
    size = 2 * CLIPPED_MARGIN_PX + 1
    spoilt = (image >= saturation_level(image)).astype(np.uint8)
    spoilt = np.asarray(cv2.dilate(spoilt, np.ones((size, size), np.uint8)), np.uint8)
    if stripe is not None and len(stripe.u):
        own = stripe.intensity > STRIPE_SHARE * float(np.median(stripe.intensity))
        middle = np.zeros(image.shape, np.uint8)
        u, v = (np.round(x[own]).astype(np.int64) for x in (stripe.u, stripe.v))
        middle[np.clip(v, 0, image.shape[0] - 1), np.clip(u, 0, image.shape[1] - 1)] = 1
        size = 2 * STRIPE_MARGIN_PX + 1
        spoilt |= np.asarray(cv2.dilate(middle, np.ones((size, size), np.uint8)), np.uint8)
    return spoilt.astype(np.bool_)


def _refuse_other_board(lattice: Lattice, board: Chessboard) -> None:
    """Refuses what cannot be numbered for certain."""
    columns, rows = board.inner_corners
    if len(lattice) < 4:
        raise OperationError(
            "board-not-found",
            message("no-chessboard-x-inner-corners-found", columns=columns, rows=rows),
            message("out-picture-covered-blurred-another-object"),
            message("bring-whole-board-into-picture-sharp"),
        )
    places = np.array(list(lattice))
    # given in the certificate's order, whichever way the picture lies
    found = sorted((int(n) for n in np.ptp(places, axis=0) + 1), reverse=columns >= rows)
    if sorted(found) != sorted((columns, rows)):
        more = max(found) > max(columns, rows) or min(found) > min(columns, rows)
        raise OperationError(
            "another-board" if more else "board-partly-seen",
            message("chessboard-x-inner-corners-found", columns=found[0], rows=found[1]),
            message("board-has-corners", name=board.name, columns=columns, rows=rows)
            if more
            else message(
                "board-has-corners-outermost-missing", name=board.name, columns=columns, rows=rows
            ),
            message("give-certificate-board-picture")
            if more
            else message("bring-whole-board-into-picture-outermost"),
        )
    low, high = places.min(axis=0), places.max(axis=0)
    on_sides = [int(np.sum(places[:, k] == end[k])) for k in (0, 1) for end in (low, high)]
    if len(lattice) < LEAST_VISIBLE * columns * rows or min(on_sides) < LEAST_ON_A_SIDE:
        raise OperationError(
            "board-partly-seen",
            message(
                "corners-were-found", found=len(lattice), corners=columns * rows, name=board.name
            ),
            message("others-covered-lost-lasers-light"),
            message("bring-whole-board-into-picture-sharp"),
        )


def _numberings(saddles: Saddles, lattice: Lattice, board: Chessboard) -> list[NDArray[np.int64]]:
    """Each way to number the lattice's corners that turns and colours allow.

    Z points to the camera, so that Y is to the left of X in the picture; the square
    outside the first corner is black where any at such a corner is.
    """
    columns, rows = board.inner_corners
    places = np.array(list(lattice))
    places = places - places.min(axis=0)
    uv = saddles.uv_px[list(lattice.values())]
    phase = saddles.phase[list(lattice.values())]
    black: list[NDArray[np.int64]] = []
    white: list[NDArray[np.int64]] = []
    for turned in _grid_orientations(places):
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
) -> tuple[Floats, Floats, NDArray[np.int64]]:
    """Pixels, covariances, and which of the lattice's corners these are."""
    uv, covariance, taken = [], [], []
    for k, (place, saddle) in enumerate(lattice.items()):
        at = saddles.uv_px[saddle]
        spacing = _spacing(saddles, lattice, place)
        found = fit_corner(image, blocked, at, float(saddles.phase[saddle]), spacing)
        if found is not None:
            uv.append(found.uv_px)
            covariance.append(found.covariance_px2)
            taken.append(k)
    return (
        np.array(uv).reshape(-1, 2),
        np.array(covariance).reshape(-1, 2, 2),
        np.array(taken, dtype=np.int64),
    )


def _spacing(saddles: Saddles, lattice: Lattice, place: tuple[int, int]) -> float:
    """Pixels to the nearest of a corner's neighbours."""
    i, j = place
    beside = [lattice.get((i + a, j + b)) for a, b in ((1, 0), (-1, 0), (0, 1), (0, -1))]
    at = saddles.uv_px[lattice[place]]
    away = [float(np.linalg.norm(saddles.uv_px[k] - at)) for k in beside if k is not None]
    return min(away, default=0.0)


def _agreeing(board: Chessboard, uv: Floats, number: NDArray[np.int64]) -> NDArray[np.bool_]:
    """Which corners lie where a perspective of all puts them, to a lens's distortion."""
    columns = board.inner_corners[0]
    places = np.column_stack([number % columns, number // columns])
    H = fit_perspective(places, uv, cv2.LMEDS)
    off = np.linalg.norm(map_places(H, places) - uv, axis=1)
    return np.asarray(off < max(MISFIT_PX, MISFIT_TIMES * float(np.median(off))))
