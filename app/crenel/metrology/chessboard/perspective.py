"""From places on a board to pixels: by one perspective for all corners, or by the nearest alone.

A wide-angle lens bends a board's lines so much that no perspective fits all of it; over a few
squares a polynomial of second order does.
"""

from functools import lru_cache

import cv2
import numpy as np
from numpy.typing import NDArray

from crenel.metrology.transforms import Floats

# Corners of a neighbourhood: at most, at least, and to tell how its lines bend.
NEIGHBOURHOOD, FEWEST, FEWEST_BENT = 14, 6, 8
# Of a perspective that says something: the depth of a place, and the distance to the next one.
LEAST_DEPTH, LEAST_SPACING_PX = 1e-6, 1.0


def fit_perspective(places: NDArray[np.int64], uv_px: Floats, method: int = 0) -> Floats:
    """The homography from places on a board to pixels.

    Args:
        places: (N, 2) columns and rows, N >= 4.
        uv_px: (N, 2) distorted pixels.
        method: of ``cv2.findHomography``; 0 is least squares.

    Returns:
        (3, 3).
    """
    H, _ = cv2.findHomography(places.astype(np.float64), uv_px, method)
    return np.asarray(H, dtype=np.float64)


def map_places(H: Floats, places: NDArray[np.int64] | Floats) -> Floats:
    """Pixels of places on a board.

    Args:
        H: (3, 3) as of ``fit_perspective``.
        places: (N, 2) columns and rows; fractions are allowed.

    Returns:
        (N, 2) px.
    """
    at = np.column_stack([places, np.ones(len(places))]) @ H.T
    return np.asarray(at[:, :2] / at[:, 2:])


def perspective_steps_px(H: Floats, place: Floats) -> Floats:
    """How wide a square appears in the direction in which it is widest, and across.

    Args:
        H: (3, 3) as of ``fit_perspective``.
        place: (2,) column and row of the square.

    Returns:
        (2,) px; their ratio is the cosine of the tilt where the lens is long.
    """
    ways = np.array([[0.5, 0.0], [-0.5, 0.0], [0.0, 0.5], [0.0, -0.5]])
    right, left, up, down = map_places(H, place + ways)
    return np.asarray(np.linalg.svd(np.array([right - left, up - down]), compute_uv=False))


def predict_corner(
    places: NDArray[np.int64],
    uv_px: Floats,
    place: NDArray[np.int64],
    *,
    certain: bool = False,
) -> tuple[Floats, float] | None:
    """Where a corner should lie, by the nearest others, and the distance to the next corner.

    Args:
        places: (N, 2) columns and rows of known corners.
        uv_px: (N, 2) their pixels.
        place: (2,) of the corner; a known corner at this place is not used.
        certain: the known corners are numbered for certain, so that a perspective of them tells
            where neighbours in one row and one column alone do not.

    Returns:
        (2,) px and px, or None where its neighbours lie in one row or are too few.
    """
    away = np.abs(places - place).sum(axis=1)
    near = np.argsort(away, kind="stable")[: NEIGHBOURHOOD + 1]
    near = near[away[near] > 0][:NEIGHBOURHOOD]
    if len(near) < FEWEST or min(np.ptp(places[near], axis=0)) < 1:
        return None
    away_from = places[near] - place
    weights, determined = _weights_of_neighbours(away_from.tobytes(), len(near))
    if certain and not determined:
        return _predict_by_perspective(away_from, uv_px[near])
    found = weights @ uv_px[near]
    return found[0], float(np.linalg.norm(found[1:], axis=1).min())


@lru_cache(maxsize=4096)
def _weights_of_neighbours(places: bytes, count: int) -> tuple[Floats, bool]:
    """The weights (3, N) of neighbours' pixels in the pixel of the place (0, 0) and in its steps
    along both axes, by least squares; and whether the neighbours (N, 2) determine them."""
    x, y = np.frombuffer(places, np.int64).reshape(count, 2).T.astype(np.float64)
    terms = [np.ones(count), x, y, x * y]
    for one in (x, y):
        if count > FEWEST_BENT and np.ptp(one) >= 2:
            terms.append(one**2)
    A = np.column_stack(terms)
    weights, _, rank, _ = np.linalg.lstsq(A, np.eye(count), rcond=None)
    return np.asarray(weights[:3], np.float64), bool(rank == len(terms))


def _predict_by_perspective(
    places: NDArray[np.int64], uv_px: Floats
) -> tuple[Floats, float] | None:
    """The pixel of the place (0, 0), and the distance to the next, by a perspective of others."""
    H, _ = cv2.findHomography(places.astype(np.float64), uv_px)
    if H is None:
        return None
    at = np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 1.0], [0.0, 1.0, 1.0]]) @ np.asarray(H).T
    if not (np.abs(at[:, 2]) > LEAST_DEPTH).all():
        return None  # on the horizon
    here, right, up = at[:, :2] / at[:, 2:]
    spacing = float(min(np.linalg.norm(right - here), np.linalg.norm(up - here)))
    return (here, spacing) if spacing > LEAST_SPACING_PX else None
