"""What helps to expose, to focus, to frame and to keep the distance: figures with their limits.

Each says its value, what is wanted, and in words which way to go.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from app.findings import Quality
from app.metrology.detection.image_quality import CLIPPED, DIM, EDGE_WIDTH, Image, ImageQuality
from app.metrology.image import saturation_level
from app.metrology.stripe import Stripe
from app.station.working_distance import Distance

# Shares of the picture that the object's outline takes, and how far off the middle it may lie.
FILLS, MIDDLE = (0.35, 0.97), 0.2
# Of the laser's line: shares of its points that may be clipped, and of full scale it should reach.
LINE_CLIPPED, LINE_DIM = 0.05, 0.3
LINE_QUANTILE = 0.9
Segment = tuple[float, float, float, float]


@dataclass(frozen=True)
class CaptureAid:
    """One figure; ``words`` is which way to go, empty where all is well."""

    name: Literal["exposure", "focus", "framing", "distance"]
    title: str
    value: float
    unit: str
    decimals: int
    wanted: str
    quality: Quality
    words: str = ""


def exposure_aid(picture: ImageQuality) -> CaptureAid:
    """Of a picture of the object: what is lost in white, or how far the bright parts reach."""
    if picture.overexposed:
        share = 100 * picture.saturated
        words = f"Too bright: {share:.0f} % saturated"
        wanted = f"≤ {100 * CLIPPED:.0f}"
        return CaptureAid("exposure", "Saturated", share, "%", 0, wanted, "attention", words)
    level = 100 * picture.high
    words = ""
    if picture.dim:
        words = f"Too dark: brightest parts at {level:.0f} %"
    elif picture.dark:
        words = "Nothing is seen: no contrast"
    quality: Quality = "attention" if words else "good"
    return CaptureAid("exposure", "Brightness", level, "%", 0, f"≥ {100 * DIM:.0f}", quality, words)


def line_aid(image: Image, stripe: Stripe) -> CaptureAid | None:
    """The same of the laser's line; None where no line is seen."""
    if not len(stripe.u):
        return None
    full = saturation_level(image)
    rows = np.clip(np.rint(stripe.v).astype(int), 0, image.shape[0] - 1)
    columns = np.clip(np.rint(stripe.u).astype(int), 0, image.shape[1] - 1)
    clipped = 100 * float(np.mean(image[rows, columns] >= full))
    if clipped > 100 * LINE_CLIPPED:
        words = f"Line too bright: {clipped:.0f} % saturated"
        wanted = f"≤ {100 * LINE_CLIPPED:.0f}"
        return CaptureAid("exposure", "Line saturated", clipped, "%", 0, wanted, "attention", words)
    level = 100 * float(np.quantile(stripe.intensity, LINE_QUANTILE)) / full
    dim = level < 100 * LINE_DIM
    words = f"Line too dark: {level:.0f} %" if dim else ""
    quality: Quality = "attention" if dim else "good"
    wanted = f"≥ {100 * LINE_DIM:.0f}"
    return CaptureAid("exposure", "Line brightness", level, "%", 0, wanted, quality, words)


def focus_aid(picture: ImageQuality) -> CaptureAid | None:
    """How wide the picture's edges are; None where that cannot be told."""
    if picture.blur_px is None:
        return None
    width, wanted = EDGE_WIDTH * picture.blur_px, EDGE_WIDTH * picture.soft_px
    soft = width > wanted
    words = f"Out of focus: edges {width:.1f} px wide, {wanted:.1f} wanted" if soft else ""
    quality: Quality = "attention" if soft else "good"
    return CaptureAid("focus", "Edge width", width, "px", 1, f"≤ {wanted:.1f}", quality, words)


def framing_aid(outline: Sequence[Segment], width_px: int, height_px: int) -> CaptureAid | None:
    """How much of the picture the object takes, and where it lies; None where it is not seen."""
    if not outline:
        return None
    ends = np.array(outline).reshape(-1, 2)
    size = np.array([width_px, height_px])
    low, high = ends.min(axis=0) / size, ends.max(axis=0) / size
    fills = float((high - low).max())
    across, down = (low + high) / 2 - 0.5
    least, most = FILLS
    words = ""
    if fills < least:
        words = f"Come nearer: the object fills {100 * fills:.0f} %, {100 * least:.0f} wanted"
    elif fills > most:
        words = "Go further away: the object does not fit"
    elif max(abs(across), abs(down)) > MIDDLE:
        words = f"The object is too far {_side(float(across), float(down))}"
    quality: Quality = "attention" if words else "good"
    wanted = f"{100 * least:.0f} to {100 * most:.0f}"
    return CaptureAid("framing", "Object fills", 100 * fills, "%", 0, wanted, quality, words)


def _side(across: float, down: float) -> str:
    if abs(across) >= abs(down):
        return "right" if across > 0 else "left"
    return "down" if down > 0 else "up"


def distance_aid(distance: Distance) -> CaptureAid:
    """How far the camera is from what it sees, against what was calibrated."""
    wanted = f"{distance.near_mm:.0f} to {distance.far_mm:.0f}"
    told = f"{distance.mm:.0f} mm, {wanted} wanted"
    words = {"in": "", "near": f"Too near: {told}", "far": f"Too far: {told}"}[distance.state]
    quality: Quality = "attention" if words else "good"
    return CaptureAid("distance", "Distance", distance.mm, "mm", 0, wanted, quality, words)
