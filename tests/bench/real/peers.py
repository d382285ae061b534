"""Three common ways to find a laser line, each with the scale of the line that it looks for.

Each gives the line's row in every column, NaN where it finds none. What they share is the least
height of a line: six times the pixels' noise, and 2 % of full scale. The scale comes from the
pictures themselves, not from Crenel: ``measure_width_px``.
"""

from collections.abc import Callable, Iterable, Sequence

import cv2
import numpy as np
from numpy.typing import NDArray

from crenel.metrology.image import Image, saturation_level
from crenel.metrology.robust import sigma_from_median
from crenel.metrology.transforms import Floats
from tests.bench.real.agreement import find_runs

Grey = NDArray[np.float32]
Peer = Callable[[Grey, float, float], Floats]
"""Of a picture, the line's standard deviation in px, and the least height: its rows (W,)."""

PER_FULL_WIDTH = 1 / 2.3548
"""Standard deviation of a Gaussian whose width at half height is one."""
LEAST_HEIGHT, LEAST_NOISES = 0.02, 6.0
LEAST_SCALE_PX = 1.0
SCALES_PX = tuple(2.0**step for step in np.arange(0.0, 7.5, 0.5))
WIDEST_SHARE = 1 / 8
"""Of the picture's height, the widest line that is looked for."""
ROUNDS = 3
STEEPEST = 0.3
"""Least share of a line's normal that points along the columns."""
OFF_PIXEL = 0.6
"""Farthest from a pixel's centre that its ridge may lie, in px (Steger's 0.5, with a margin)."""


def find_centroid(image: Grey, scale_px: float, least: float) -> Floats:
    """Centre of gravity of the column's brightest part, over its surroundings."""
    size = 2 * round(scale_px / PER_FULL_WIDTH / 2) + 1
    top = cv2.blur(image, (1, size)).argmax(axis=0)
    reach = int(np.ceil(3 * scale_px)) + 1
    along = np.arange(image.shape[1])
    offsets = np.arange(-reach, reach + 1)[:, None]
    padded = np.pad(image, ((reach, reach), (0, 0)), mode="edge")
    rows = top.astype(np.float64)
    for _ in range(2):  # the second time about the first centre
        near = np.clip(np.rint(rows), 0, image.shape[0] - 1).astype(np.int64) + offsets
        window = padded[near + reach, along]
        edge = max(1, reach // 4)
        around = np.median(np.concatenate([window[:edge], window[-edge:]]), axis=0)
        light = np.maximum(window - around - 0.1 * (window.max(axis=0) - around), 0.0)
        total = light.sum(axis=0)
        rows = (light * near).sum(axis=0) / np.maximum(total, 1e-9)
    return np.where((window.max(axis=0) - around >= least) & (total > 0), rows, np.nan)


def find_blurred_parabola(image: Grey, scale_px: float, least: float) -> Floats:
    """Vertex of the parabola through the column's highest pixel after Gaussian blur."""
    size = 2 * int(np.ceil(3 * scale_px)) + 1
    smooth = cv2.GaussianBlur(image, (1, size), sigmaX=0.1, sigmaY=scale_px)
    along = np.arange(image.shape[1])
    top = np.clip(smooth.argmax(axis=0), 1, image.shape[0] - 2)
    a, b, c = (smooth[top + k, along].astype(np.float64) for k in (-1, 0, 1))
    bend = a - 2 * b + c
    vertex = np.where(bend < 0, 0.5 * (a - c) / np.where(bend < 0, bend, 1.0), 0.0)
    high = np.sqrt(2.0) * (b - np.median(smooth, axis=0)) >= least
    return np.where(high & (bend < 0), top + np.clip(vertex, -1, 1), np.nan)


def find_ridge(image: Grey, scale_px: float, least: float) -> Floats:
    """Steger's ridge of the picture under a two-dimensional Gaussian, in connected pieces."""
    smooth, slope, bend = (_kernel(scale_px, order) for order in range(3))
    du, dv = _filter(image, slope, smooth), _filter(image, smooth, slope)
    duu, dvv = _filter(image, bend, smooth), _filter(image, smooth, bend)
    duv = _filter(image, slope, slope)
    spread = np.sqrt(0.25 * (duu - dvv) ** 2 + duv**2)
    curvature = 0.5 * (duu + dvv) - spread  # the lower eigenvalue, across a bright line
    angle = 0.5 * np.arctan2(2 * duv, duu - dvv) + np.pi / 2
    nu, nv = np.cos(angle), np.sin(angle)
    # the extremum along the normal
    t = -(du * nu + dv * nv) / np.where(curvature < 0, curvature, -1.0)
    height = -curvature * 2 * np.sqrt(2.0) * scale_px**2
    ridge = (
        (curvature < 0)
        & (height >= least)
        & (np.abs(t * nu) <= OFF_PIXEL)
        & (np.abs(t * nv) <= OFF_PIXEL)
        & (np.abs(nv) >= STEEPEST)
    )
    height = np.where(_long_pieces(ridge, scale_px), height, 0.0)
    rows, along = height.argmax(axis=0), np.arange(image.shape[1])
    crossing = t[rows, along] / np.where(ridge[rows, along], nv[rows, along], 1.0)
    return np.where(height[rows, along] > 0, rows + crossing, np.nan)


PEERS: dict[str, Peer] = {
    "centroid": find_centroid,
    "parabola": find_blurred_parabola,
    "steger": find_ridge,
}


def find_by_peers(image: Image, width_px: float) -> dict[str, Floats]:
    """The line's row in every column by each peer, (W,), NaN where it finds none."""
    scale_px = max(LEAST_SCALE_PX, width_px * PER_FULL_WIDTH)
    grey = image.astype(np.float32)
    return {name: find(grey, scale_px, least_height(image)) for name, find in PEERS.items()}


def least_height(image: Image) -> float:
    """The least height of a line above its surroundings, in grey levels."""
    steps = np.abs(np.diff(image.astype(np.float32), axis=0))
    noise = sigma_from_median(steps) / np.sqrt(2.0)
    return float(max(LEAST_NOISES * noise, LEAST_HEIGHT * saturation_level(image)))


def measure_width_px(images: Iterable[Image]) -> float | None:
    """The line's usual width at half its height, in px; None where there is no line.

    In each picture, the scale is taken at which the columns' strongest places make the
    strongest long lines; the width is that of the median profile across those.
    """
    widths = [width for width in map(_width_px, images) if width is not None]
    return float(np.median(widths)) if widths else None


def _width_px(image: Image) -> float | None:
    grey = image.astype(np.float32)
    least = least_height(image)
    strongest, best = 0.0, None
    for scale_px in SCALES_PX:
        if scale_px / PER_FULL_WIDTH > WIDEST_SHARE * image.shape[0]:
            break
        response = -_filter(grey, np.ones(1), _kernel(scale_px, 2)) * scale_px**2
        rows, along = response.argmax(axis=0), np.arange(image.shape[1])
        heights = response[rows, along] * 2 * np.sqrt(2.0)
        kept = find_runs(np.where(heights >= least, rows, np.nan), round(8 * scale_px))
        # by the scale's root, a Gaussian's response is greatest at its own scale
        strength = float(heights[kept].sum() / np.sqrt(scale_px))
        if strength > strongest:
            strongest, best = strength, (scale_px, rows, along[kept])
    if best is None:
        return None
    scale_px, rows, along = best
    width_px: float | None = None
    for _ in range(ROUNDS):  # a profile that ends on a wider line makes it too narrow
        width_px = _profile_width_px(grey, scale_px, rows, along)
        if width_px is None or width_px * PER_FULL_WIDTH < 1.1 * scale_px:
            break
        scale_px = width_px * PER_FULL_WIDTH
    return width_px


def _profile_width_px(
    grey: Grey, scale_px: float, rows: NDArray[np.int64], along: NDArray[np.int64]
) -> float | None:
    """The width at half height of the median profile of some columns about their rows."""
    reach = int(np.ceil(4 * scale_px)) + 2
    padded = np.pad(grey, ((reach, reach), (0, 0)), mode="edge")
    offsets = np.arange(2 * reach + 1)[:, None]
    profile = np.median(padded[rows[along] + offsets, along], axis=1)
    profile = profile - min(float(profile[:reach].min()), float(profile[reach + 1 :].min()))
    half = 0.5 * float(profile[reach - 1 : reach + 2].max())
    if half <= 0:
        return None
    return _half_reach_px(profile[reach:], half) + _half_reach_px(profile[reach::-1], half)


def _half_reach_px(falling: Floats, half: float) -> float:
    """How far from the first value a profile falls to half, between pixels."""
    below = np.flatnonzero(falling < half)
    if not len(below) or below[0] == 0:
        return float(len(falling) if not len(below) else 0)
    at = int(below[0])
    return at - 1 + float((falling[at - 1] - half) / (falling[at - 1] - falling[at]))


def _long_pieces(ridge: NDArray[np.bool_], scale_px: float) -> NDArray[np.bool_]:
    """The pixels of connected ridges that are twice as long as the line is wide."""
    _, labels, stats, _ = cv2.connectedComponentsWithStats(ridge.astype(np.uint8), connectivity=8)
    longest = np.maximum(stats[:, cv2.CC_STAT_WIDTH], stats[:, cv2.CC_STAT_HEIGHT])
    kept = longest >= max(6.0, 2 * scale_px / PER_FULL_WIDTH)
    kept[0] = False
    return np.asarray(kept[labels])


def _kernel(scale_px: float, order: int) -> Floats:
    """Samples of a Gaussian or of its first or second derivative, to correlate with."""
    reach = int(np.ceil(4 * scale_px))
    x = np.arange(-reach, reach + 1, dtype=np.float64)
    gauss = np.exp(-0.5 * (x / scale_px) ** 2)
    gauss /= gauss.sum()
    if order == 0:
        return gauss
    if order == 1:
        return np.asarray(gauss * x / scale_px**2)
    bend = gauss * (x**2 - scale_px**2) / scale_px**4
    return np.asarray(bend - bend.mean())


def _filter(image: Grey, along_u: Sequence[float] | Floats, along_v: Floats) -> Grey:
    kernels = np.asarray(along_u, np.float64), np.asarray(along_v, np.float64)
    filtered = cv2.sepFilter2D(image, cv2.CV_32F, *kernels, borderType=cv2.BORDER_REPLICATE)
    return np.asarray(filtered, np.float32)
