"""Places in a picture where four squares may meet: saddles of the brightness."""

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from crenel.metrology.image import Image
from crenel.metrology.robust import sigma_from_median
from crenel.metrology.transforms import Floats

# Blur for the saddle search, and the radii of the two rings on which each is tested.
BLURS_PX = (1.5, 3.0)
RINGS_PX = (5.0, 8.0)
RING_POINTS = 32
# Minimum share of a ring's variance that alternates twice around it: 0.81 for a perfect corner, 0
# for an edge; and minimum step between bright and dark, in standard deviations of the noise.
LEAST_ALTERNATING = 0.5
LEAST_STEP_SIGMAS = 4.0
MOST_CANDIDATES = 4000
# Rows that are looked at in one go, and the reach of a blur in times its width, as OpenCV has it.
BAND_PX, BLUR_REACH = 128, 4


@dataclass(frozen=True)
class Saddles:
    """N candidates: pixels (N, 2), and the phase (N,) in rad of their bright sectors.

    Neighbouring corners of a chessboard have opposite phases.
    """

    uv_px: Floats
    phase: Floats


def find_saddles(
    image: Image | NDArray[np.float32], blocked: NDArray[np.bool_], scale: float = 1.0
) -> Saddles:
    """Candidates outside the blocked pixels (H, W), each once.

    Args:
        scale: of the picture in which they are sought: below 1 for large squares, noise and
            blur, above 1 for small ones.
    """
    grey = image.astype(np.float32)
    if scale != 1.0:
        size = (round(image.shape[1] * scale), round(image.shape[0] * scale))
        method = cv2.INTER_AREA if scale < 1 else cv2.INTER_CUBIC
        grey = np.asarray(cv2.resize(grey, size, interpolation=method), np.float32)
        covered = cv2.resize(blocked.astype(np.uint8), size, interpolation=cv2.INTER_NEAREST)
        found = _find_in(grey, covered > 0)
        across = np.array(image.shape[::-1]) / size
        return Saddles((found.uv_px + 0.5) * across - 0.5, found.phase)
    return _find_in(grey, blocked)


def _find_in(grey: NDArray[np.float32], blocked: NDArray[np.bool_]) -> Saddles:
    noise = _noise(grey)
    smooth = np.asarray(cv2.GaussianBlur(grey, (0, 0), 1.0), np.float32)
    places: list[Floats] = []
    phases: list[Floats] = []
    for blur in BLURS_PX:
        uv = _peaks(grey, blur, blocked)
        phase = np.zeros(len(uv))
        for ring in RINGS_PX:
            share, amplitude, phase = _alternating(smooth, uv, ring * blur / BLURS_PX[0])
            good = (share > LEAST_ALTERNATING) & (amplitude > LEAST_STEP_SIGMAS * noise)
            uv, phase = uv[good], phase[good]
        places.append(uv)
        phases.append(phase)
    return drop_duplicates(np.concatenate(places), np.concatenate(phases))


def _noise(grey: NDArray[np.float32]) -> float:
    """Standard deviation of a pixel in the dark, uniform parts, in grey levels."""
    steps = np.abs(np.diff(grey[::4], axis=1))
    return max(sigma_from_median(steps) / 2**0.5, 0.3)


def _peaks(grey: NDArray[np.float32], blur: float, blocked: NDArray[np.bool_]) -> Floats:
    """(N, 2) local maxima of the saddle's strength, the strongest ``MOST_CANDIDATES``.

    Looked for in bands of rows, which stay in the processor's cache.
    """
    size = 2 * int(2 * blur) + 1
    beyond = size // 2 + 1 + int(np.ceil(BLUR_REACH * blur))
    places: list[NDArray[np.int64]] = []
    found: list[NDArray[np.float32]] = []
    for top in range(0, len(grey), BAND_PX):
        first, end = max(top - beyond, 0), top + BAND_PX + beyond
        smooth = cv2.GaussianBlur(grey[first:end], (0, 0), blur)
        xx = cv2.Sobel(smooth, cv2.CV_32F, 2, 0)
        yy = cv2.Sobel(smooth, cv2.CV_32F, 0, 2)
        xy = cv2.Sobel(smooth, cv2.CV_32F, 1, 1)
        strength = np.asarray(xy * xy - xx * yy, np.float32)
        highest = np.asarray(cv2.dilate(strength, np.ones((size, size), np.uint8)), np.float32)
        own = slice(top - first, top - first + BAND_PX)
        level = strength[own]
        peak = (level >= highest[own]) & (level > 0) & ~blocked[top : top + BAND_PX]
        at = np.flatnonzero(peak)  # ten times as fast as by rows and columns
        places.append(at + top * grey.shape[1])
        found.append(level.ravel()[at])
    order = np.argsort(-np.concatenate(found))[:MOST_CANDIDATES]
    rows, columns = np.divmod(np.concatenate(places)[order], grey.shape[1])
    return np.column_stack([columns, rows]).astype(np.float64)


def phases_at(image: Image, uv_px: Floats, ring_px: float) -> Floats:
    """The phase (N,) of the bright sectors about places (N, 2), on rings of a radius."""
    smooth = np.asarray(cv2.GaussianBlur(image.astype(np.float32), (0, 0), 1.0), np.float32)
    return _alternating(smooth, uv_px, ring_px)[2]


def _alternating(
    smooth: NDArray[np.float32], uv: Floats, ring_px: float
) -> tuple[Floats, Floats, Floats]:
    """Alternation, twice around a ring, at each place: share of variance, amplitude, phase."""
    if not len(uv):
        return np.zeros(0), np.zeros(0), np.zeros(0)
    angle = 2 * np.pi * np.arange(RING_POINTS) / RING_POINTS
    at = uv[:, None, :] + ring_px * np.column_stack([np.cos(angle), np.sin(angle)])
    at32 = at.astype(np.float32)
    values = cv2.remap(
        smooth, at32[..., 0], at32[..., 1], cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE
    ).reshape(len(uv), RING_POINTS)
    values = values - values.mean(axis=1, keepdims=True)
    twice = values @ np.exp(-2j * angle).astype(np.complex64)
    total = np.maximum(RING_POINTS * np.square(values).sum(axis=1), 1e-9)
    inside = ((uv >= ring_px) & (uv + ring_px < np.array(smooth.shape[::-1]) - 1)).all(axis=1)
    share = np.where(inside, 2 * np.abs(twice) ** 2 / total, 0.0)
    return share, 2 * np.abs(twice) / RING_POINTS, np.angle(twice)


def drop_duplicates(uv: Floats, phase: Floats) -> Saddles:
    """Keeps the first of candidates (N, 2) that lie on one another."""
    kept: list[int] = []
    for i, place in enumerate(uv):
        if not kept or np.min(np.sum((uv[kept] - place) ** 2, axis=1)) > 3.0**2:
            kept.append(i)
    return Saddles(uv[kept], phase[kept])
