"""Aids for exposure, focus, framing and distance: figures with their limits.

Each has its value, its target, and a direction in words.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from crenel.findings import Quality
from crenel.messages.limits import beside_limit, decimals_beside, limit_quantity
from crenel.messages.message import Text, Unit, message, quantity
from crenel.metrology.detection.image_quality import CLIPPED, DIM, EDGE_WIDTH, Image, ImageQuality
from crenel.metrology.image import saturation_level
from crenel.metrology.stripe import Stripe
from crenel.station.working_distance import Distance

# Share of the picture that the object's outline should cover, and its maximum offset from the
# middle.
FILLS, MIDDLE = (0.35, 0.97), 0.2
# For the laser line: maximum share of clipped points, and share of full scale that it should reach.
LINE_CLIPPED, LINE_DIM = 0.05, 0.3
LINE_QUANTILE = 0.9
Segment = tuple[float, float, float, float]


@dataclass(frozen=True)
class CaptureAid:
    """One figure and its target in its unit; ``words`` says which way to move, empty if all is
    well."""

    name: Literal["exposure", "focus", "framing", "distance"]
    title: Text
    value: float
    unit: Unit
    decimals: int
    wanted: Text
    quality: Quality
    words: Text = ""


def exposure_aid(picture: ImageQuality) -> CaptureAid:
    """For a picture of the object: the overexposed share, or the level of the bright parts."""
    if picture.overexposed:
        share = 100 * picture.saturated
        shown, limit = beside_limit(share, 100 * CLIPPED, "%")
        too_bright = message("too-bright-saturated", share=shown)
        title, most = message("saturated"), message("at-most-limit", limit=limit)
        places = shown.decimals
        return CaptureAid("exposure", title, share, "%", places, most, "attention", too_bright)
    level = 100 * picture.high
    words: Text = ""
    if picture.dim:
        words = message("too-dark-brightest-parts", level=quantity(level, "%"))
    elif picture.dark:
        words = message("nothing-seen-no-contrast")
    quality: Quality = "attention" if words else "good"
    least = 100 * DIM
    places, wanted = decimals_beside(level, [least]), _at_least(least)
    return CaptureAid("exposure", message("brightness"), level, "%", places, wanted, quality, words)


def line_aid(image: Image, stripe: Stripe) -> CaptureAid | None:
    """The same for the laser line; None if no line is detected."""
    if not len(stripe.u):
        return None
    full = saturation_level(image)
    rows = np.clip(np.rint(stripe.v).astype(int), 0, image.shape[0] - 1)
    columns = np.clip(np.rint(stripe.u).astype(int), 0, image.shape[1] - 1)
    clipped = 100 * float(np.mean(image[rows, columns] >= full))
    if clipped > 100 * LINE_CLIPPED:
        shown, limit = beside_limit(clipped, 100 * LINE_CLIPPED, "%")
        too_bright = message("line-too-bright-saturated", clipped=shown)
        title, most = message("line-saturated"), message("at-most-limit", limit=limit)
        places = shown.decimals
        return CaptureAid("exposure", title, clipped, "%", places, most, "attention", too_bright)
    level = 100 * float(np.quantile(stripe.intensity, LINE_QUANTILE)) / full
    dim = level < 100 * LINE_DIM
    words = message("line-too-dark", level=quantity(level, "%")) if dim else ""
    quality: Quality = "attention" if dim else "good"
    wanted, places = _at_least(100 * LINE_DIM), decimals_beside(level, [100 * LINE_DIM])
    title = message("line-brightness")
    return CaptureAid("exposure", title, level, "%", places, wanted, quality, words)


def focus_aid(picture: ImageQuality) -> CaptureAid | None:
    """Width of the edges in the picture; None if unknown."""
    if picture.blur_px is None:
        return None
    width, wanted = EDGE_WIDTH * picture.blur_px, EDGE_WIDTH * picture.soft_px
    soft = width > wanted
    shown, limit = beside_limit(width, wanted, "px", 1)
    words: Text = ""
    if soft:
        words = message("out-focus-edges-wide-wanted", width=shown, wanted=limit)
    quality: Quality = "attention" if soft else "good"
    most = message("at-most-limit", limit=limit)
    return CaptureAid(
        "focus", message("edge-width"), width, "px", shown.decimals, most, quality, words
    )


def framing_aid(outline: Sequence[Segment], width_px: int, height_px: int) -> CaptureAid | None:
    """Share of the picture that the object covers, and its position; None if it is not detected."""
    if not outline:
        return None
    ends = np.array(outline).reshape(-1, 2)
    size = np.array([width_px, height_px])
    low, high = ends.min(axis=0) / size, ends.max(axis=0) / size
    fills = float((high - low).max())
    across, down = (low + high) / 2 - 0.5
    least, most = FILLS
    words: Text = ""
    if fills < least:
        shown, wanted = beside_limit(100 * fills, 100 * least, "%")
        words = message("come-nearer-object-fills-wanted", fills=shown, least=wanted)
    elif fills > most:
        words = message("go-further-away-object-does-fit")
    elif max(abs(across), abs(down)) > MIDDLE:
        words = message("object-too-far", side=_side(float(across), float(down)))
    quality: Quality = "attention" if words else "good"
    range_text = message("from-to", low=quantity(100 * least, "%"), high=quantity(100 * most, "%"))
    places = decimals_beside(100 * fills, (100 * least, 100 * most))
    return CaptureAid(
        "framing", message("object-fills"), 100 * fills, "%", places, range_text, quality, words
    )


def _side(across: float, down: float) -> Literal["right", "left", "down", "up"]:
    if abs(across) >= abs(down):
        return "right" if across > 0 else "left"
    return "down" if down > 0 else "up"


def distance_aid(distance: Distance) -> CaptureAid:
    """Distance from the camera to what it sees, relative to the calibrated range."""
    limits = distance.near_mm, distance.far_mm
    places = decimals_beside(distance.mm, limits)
    low, high = (limit_quantity(one, "mm", places) for one in limits)
    words: Text = ""
    if distance.state != "in":
        shown = quantity(distance.mm, "mm", places)
        words = message(
            "distance-out-of-range", side=distance.state, distance=shown, low=low, high=high
        )
    quality: Quality = "attention" if words else "good"
    title, wanted = message("distance"), message("from-to", low=low, high=high)
    return CaptureAid("distance", title, distance.mm, "mm", places, wanted, quality, words)


def _at_least(limit_percent: float) -> Text:
    return message("at-least-limit", limit=quantity(limit_percent, "%"))
