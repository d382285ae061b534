"""Sub-pixel corners of a chessboard: two blurred edges fitted to the picture around each."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.image import Image
from crenel.metrology.transforms import Floats

# Size of the window as a share of the distance to the next corner; minimum and maximum in px.
WINDOW_SHARE, LEAST_WINDOW_PX, MOST_WINDOW_PX = 0.35, 4.0, 20.0
# Share of the window that must be free of laser light, and inside the picture.
LEAST_FREE = 0.85
# Nine unknowns and the noise are estimated from at least so many pixels.
FEWEST_PIXELS = 24
MOST_SHIFT_PX = 3.0
ROUNDS = 30
SETTLED_PX = 1e-3
BLUR_PX = (0.3, 6.0)
# Minimum share of the picture's variance in the window that a fit must explain.
LEAST_EXPLAINED = 0.8
# How far each of the four squares lies above or below their middle, of half the step between
# bright and dark: about 1 at a corner, 0 where a square ends at the board's outline.
LEAST_SQUARE = 0.4
# Grey levels are whole numbers.
ROUNDING = 1 / 12


@dataclass(frozen=True)
class FittedCorner:
    """Where two edges cross, px, and its covariance (2, 2) by the noise around it."""

    uv_px: Floats
    covariance_px2: Floats
    blur_px: float


def fit_corner(
    image: Image,
    blocked: NDArray[np.bool_],
    uv_px: Floats,
    phase: float,
    spacing_px: float,
    marked: NDArray[np.bool_] | None = None,
) -> FittedCorner | None:
    """The corner next to a saddle; None if none can be measured.

    The brightness is ``base + slope . x + step f(d1) f(d2)`` with the signed distances d from two
    straight lines and f the integral of a Gaussian blur: nine unknowns, estimated by least squares.

    Args:
        blocked: (H, W) pixels that do not count.
        phase: phase of the bright sectors, as in ``Saddles``.
        spacing_px: distance to the next corner.
        marked: (H, W) pixels of markers in the white squares, which are left out.
    """
    radius = window_radius_px(spacing_px)
    window = _window(image, blocked, marked, uv_px, radius)
    if window is None:
        return None
    places, values = window
    bright = -phase / 2
    start = np.array([0.0, 0.0, bright - np.pi / 4, bright + np.pi / 4, 1.2, 0.0, 0.0, 0.0, 0.0])
    start[5:] = _brightness(places, values, start)
    p = _settle(places, values, start)
    if p is None:
        return None
    model, J = _model(places, p)
    left = values - model
    variance = float(left @ left) / (len(values) - len(p))
    if variance > (1 - LEAST_EXPLAINED) * float(np.var(values)) or p[5] <= 0:
        return None
    if not _has_four_squares(places, values, p, near_edges=marked is not None):
        return None
    covariance = np.asarray(np.linalg.inv(J.T @ J)[:2, :2], np.float64)
    return FittedCorner(uv_px + p[:2], covariance * max(variance, ROUNDING), float(p[4]))


def window_radius_px(spacing_px: float) -> float:
    """What is looked at around a corner, by the distance to the next one."""
    return float(np.clip(WINDOW_SHARE * spacing_px, LEAST_WINDOW_PX, MOST_WINDOW_PX))


def _settle(places: Floats, values: Floats, start: Floats) -> Floats | None:
    """The unknowns (9,) by least squares; None where they run away or do not settle.

    Sharp edges between few pixels make a whole step go too far: it is halved until it helps.
    """
    p, least = start, np.inf
    step: Floats = np.zeros(len(start))
    for _ in range(ROUNDS):
        model, J = _model(places, p + step)
        left = values - model
        if float(left @ left) > least:
            step = np.asarray(step / 2)
        else:
            p, least = p + step, float(left @ left)
            step = np.asarray(np.linalg.lstsq(J, left, rcond=None)[0], np.float64)
            step[:2] = np.clip(step[:2], -1.0, 1.0)
            step[2:4] = np.clip(step[2:4], -0.3, 0.3)
            step[4] = float(np.clip(p[4] + step[4], *BLUR_PX)) - p[4]
        if np.linalg.norm(p[:2]) > MOST_SHIFT_PX:
            return None
        if np.max(np.abs(step[:2])) < SETTLED_PX:
            return p
    return None


def _has_four_squares(places: Floats, values: Floats, p: Floats, near_edges: bool) -> bool:
    """Whether each of the four sectors (M pixels in all) is as bright or dark as is due.

    Args:
        near_edges: most of a sector's pixels may lie on its blurred edges, as beside a marker.
    """
    f1, f2, _, _ = _edges(places, p)
    due = f1 * f2 if near_edges else np.sign(f1 * f2)
    sectors = (f1 > 0).astype(np.int64) + 2 * (f2 > 0)
    expected = np.bincount(sectors, due**2, minlength=4)
    found = np.bincount(sectors, due * (p[6] - values) / p[5], minlength=4)
    return bool((found[expected > 0] > LEAST_SQUARE * expected[expected > 0]).all())


def _window(
    image: Image,
    blocked: NDArray[np.bool_],
    marked: NDArray[np.bool_] | None,
    uv_px: Floats,
    radius: float,
) -> tuple[Floats, Floats] | None:
    """Positions (M, 2) around the saddle and their grey levels (M,), within a circle."""
    height, width = image.shape
    u0, v0 = (int(x) for x in np.floor(uv_px - radius))
    u1, v1 = (int(x) for x in np.ceil(uv_px + radius) + 1)
    if u0 < 0 or v0 < 0 or u1 > width or v1 > height:
        return None
    v, u = np.mgrid[v0:v1, u0:u1]
    places = np.column_stack([u.ravel(), v.ravel()]) - uv_px
    inside = np.sum(places**2, axis=1) <= radius**2
    if marked is not None:
        inside &= ~marked[v0:v1, u0:u1].ravel()
    free = inside & ~blocked[v0:v1, u0:u1].ravel()
    if free.sum() < max(LEAST_FREE * inside.sum(), FEWEST_PIXELS):
        return None
    return places[free], image[v0:v1, u0:u1].ravel()[free].astype(np.float64)


def _edges(places: Floats, p: Floats) -> tuple[Floats, Floats, Floats, Floats]:
    """Both blurred steps (M,) from -1 to 1, and both signed distances over the blur."""
    from scipy.special import erf  # slow to import, and needed for boards only

    away = places - p[:2]
    first, second = (-np.sin(a) * away[:, 0] + np.cos(a) * away[:, 1] for a in p[2:4])
    d1, d2 = first / p[4], second / p[4]
    return erf(d1 / np.sqrt(2)), erf(d2 / np.sqrt(2)), d1, d2


def _brightness(places: Floats, values: Floats, p: Floats) -> Floats:
    """Step, base and slope (4,) that fit the edges best."""
    f1, f2, _, _ = _edges(places, p)
    terms = np.column_stack([-f1 * f2, np.ones(len(values)), places])
    return np.asarray(np.linalg.lstsq(terms, values, rcond=None)[0])


def _model(places: Floats, p: Floats) -> tuple[Floats, Floats]:
    """Grey levels (M,) and their derivatives (M, 9) by the unknowns."""
    blur, step = p[4], p[5]
    f1, f2, d1, d2 = _edges(places, p)
    g1, g2 = (np.sqrt(2 / np.pi) * np.exp(-(d**2) / 2) for d in (d1, d2))
    away = places - p[:2]
    by_d1, by_d2 = -step * g1 * f2 / blur, -step * f1 * g2 / blur
    J = np.empty((len(places), 9))
    J[:, 0] = by_d1 * np.sin(p[2]) + by_d2 * np.sin(p[3])
    J[:, 1] = -by_d1 * np.cos(p[2]) - by_d2 * np.cos(p[3])
    for k, by_d in ((2, by_d1), (3, by_d2)):
        J[:, k] = by_d * (-np.cos(p[k]) * away[:, 0] - np.sin(p[k]) * away[:, 1])
    J[:, 4] = -(by_d1 * d1 + by_d2 * d2)
    J[:, 5] = -f1 * f2
    J[:, 6] = 1.0
    J[:, 7:9] = places
    return -step * f1 * f2 + p[6] + places @ p[7:9], J
