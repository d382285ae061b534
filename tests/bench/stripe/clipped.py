"""Frames whose line is clipped in places: rates beside those of plain frames, and the error.

All of them show the same kind of line, which is clipped nowhere, along a patch, half of it or
all of it; one has a clipped spot far from the line. In others the line has two gaps, and a core of
five rows that is clipped along a run. 16 bits hold 12 significant ones.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from crenel.metrology.image import Image
from crenel.metrology.stripe import StripeTracker, extract_stripe
from crenel.metrology.transforms import Floats
from crenel.progress import Progress
from tests.bench.stripe.frames import BASE, GAIN, HEIGHT, READ, WIDTH, beam
from tests.bench.stripe.methods import Method, crenel_line, fit_blurred_parabola
from tests.bench.stripe.speed import median_seconds

SEEDS, POOL = 8, 24
WIDTH_PX, HEIGHT_LEVELS = 2.5, 120.0
CLIPPED_LEVELS, SLIGHTLY_CLIPPED_LEVELS = 1620.0, 410.0
"""Heights whose clipped core is ten rows high, and five."""
GAPS = ((300, 325), (900, 925))
SPOT_PX, SPOT_ROW = 12, 120
SWAY_PX = 60
"""A followed line goes up and down by so many rows, a few a frame."""
DEPTH_BITS = (8, 16)
LEVELS_OF_12_BITS = 4095 / 255
COLUMNS = (
    *("clipped", "Crenel", "share of plain", "followed", "share of plain"),
    *("OpenCV Gauss + parabola", "rms, clipped columns: Crenel", "OpenCV"),
)


@dataclass(frozen=True)
class ClippingKind:
    """What is clipped: columns of the line from the first to before the last, or a spot.

    ``broken``: the line has gaps, and clipped columns are only a little too bright.
    """

    name: str
    first: int = 0
    behind: int = 0
    spot: bool = False
    broken: bool = False


KINDS = (
    ClippingKind("nothing"),
    ClippingKind("a spot of 12 × 12 pixels", spot=True),
    ClippingKind("80 columns of the line", 600, 680),
    ClippingKind("half of the line", WIDTH // 2, WIDTH),
    ClippingKind("all of the line", 0, WIDTH),
    ClippingKind("nothing of a broken line", broken=True),
    *(
        ClippingKind(f"{columns} columns of a broken line", 345, 345 + columns, broken=True)
        for columns in (30, 40, 80, 480)
    ),
)


@dataclass(frozen=True)
class ClippingResult:
    """Frames of one kind and depth: frames a second, shares of plain frames' with the same line,
    errors in px."""

    kind: str
    bits: int
    full_search: float
    full_search_share: float
    followed: float
    followed_share: float
    opencv: float
    error_px: float | None
    """Rms on the clipped columns; None where there are none."""
    opencv_error_px: float | None


def run(progress: Progress) -> list[ClippingResult]:
    """Measures all kinds in turn, depth by depth."""
    threads = cv2.getNumThreads()
    cv2.setNumThreads(1)
    try:
        found: list[ClippingResult] = []
        for number, bits in enumerate(DEPTH_BITS):
            progress(number / len(DEPTH_BITS), f"{bits} bits")
            found += _measure_depth(bits)
        return found
    finally:
        cv2.setNumThreads(threads)


def table(rows: Sequence[ClippingResult]) -> list[list[str]]:
    """Rows for ``COLUMNS``."""
    return [
        [
            f"{one.kind}, {one.bits} bit",
            *(f"{one.full_search:.0f} /s", f"{100 * one.full_search_share:.0f} %"),
            *(f"{one.followed:.0f} /s", f"{100 * one.followed_share:.0f} %"),
            f"{one.opencv:.0f} /s",
            *(
                "" if error is None else f"{error:.4f} px"
                for error in (one.error_px, one.opencv_error_px)
            ),
        ]
        for one in rows
    ]


def simulate_clipped_frame(kind: ClippingKind, seed: int, bits: int) -> tuple[Image, Floats]:
    """A frame, and the line's row in every column (W,)."""
    rng = np.random.default_rng(seed)
    u = np.arange(WIDTH)
    centre = HEIGHT / 2 + 40 * np.sin(u / 200 + seed) + 0.05 * u
    height = np.full(WIDTH, HEIGHT_LEVELS)
    height[kind.first : kind.behind] = SLIGHTLY_CLIPPED_LEVELS if kind.broken else CLIPPED_LEVELS
    for first, behind in GAPS if kind.broken else ():
        height[first:behind] = 0
    light = beam(centre, height, WIDTH_PX)
    grey = BASE + light + rng.standard_normal(light.shape) * np.sqrt(READ**2 + GAIN * light)
    if kind.spot:
        left = WIDTH // 2
        grey[SPOT_ROW : SPOT_ROW + SPOT_PX, left : left + SPOT_PX] = CLIPPED_LEVELS
    if bits == 8:
        return np.clip(np.rint(grey), 0, 255).astype(np.uint8), centre
    return np.clip(np.rint(LEVELS_OF_12_BITS * grey), 0, 4095).astype(np.uint16), centre


def _measure_depth(bits: int) -> list[ClippingResult]:
    base = [[simulate_clipped_frame(kind, seed, bits) for seed in range(SEEDS)] for kind in KINDS]
    methods = [method for frames in base for method in _methods([image for image, _ in frames])]
    rates = 1 / np.array(median_seconds(methods)).reshape(len(KINDS), 3)
    plain = {kind.broken: rate for kind, rate in reversed(list(zip(KINDS, rates, strict=True)))}
    return [
        ClippingResult(
            kind.name,
            bits,
            *(float(whole), float(whole / plain[kind.broken][0])),
            *(float(followed), float(followed / plain[kind.broken][1]), float(opencv)),
            *(_error_px(kind, frames, method) for method in (crenel_line, fit_blurred_parabola)),
        )
        for kind, frames, (whole, followed, opencv) in zip(KINDS, base, rates, strict=True)
    ]


def _methods(images: list[Image]) -> list[tuple[Callable[[Image], object], Sequence[Image]]]:
    """What is timed on frames of one kind: extraction, the line followed, and OpenCV."""
    pool = [images[i % SEEDS].copy() for i in range(POOL)]
    rows = [round(SWAY_PX * np.sin(2 * np.pi * i / POOL)) for i in range(POOL)]
    moved = [np.roll(images[0], row, axis=0) for row in rows]
    tracker = StripeTracker()
    return [(extract_stripe, pool), (tracker.extract, moved), (fit_blurred_parabola, pool)]


def _error_px(
    kind: ClippingKind, frames: list[tuple[Image, Floats]], method: Method
) -> float | None:
    """Rms error on the clipped columns."""
    if kind.first == kind.behind:
        return None
    errors: list[NDArray[np.float64]] = []
    for image, centre in frames:
        along, across = method(image)
        column = along.astype(int)
        clipped = (column >= kind.first) & (column < kind.behind)
        errors.append((across - centre[column])[clipped])
    return float(np.sqrt(np.mean(np.concatenate(errors) ** 2)))
