"""The laser stripe in an image: its centre below a pixel, and how far to trust it."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal, cast

import cv2
import numpy as np
from numpy.typing import NDArray

from app.metrology import stripe_choice as choice
from app.metrology import stripe_kernels as kernels
from app.metrology.frames import Floats
from app.metrology.refusal import Refusal
from app.metrology.stripe_flanks import Image, clipped_cores, fit_flanks
from app.metrology.stripe_noise import read_noise
from app.metrology.stripe_overexposed import joined, of_the_line
from app.metrology.stripe_room import Room, give_back, take_room
from app.metrology.stripe_search import LEAST_ROWS, search

Choice = Literal["continuity", "strength", "first", "last"]

# A peak stands out of the noise by this many standard deviations of its score; what
# noise passes makes no run.
STANDS_OUT = 4.0
# The variance of the score, in those of a pixel.
SCORE_VARIANCE = 7 / 12
# A point belongs to a run of at least this many neighbouring points.
SHORTEST_RUN = 6
# Width at half height of a Gaussian, in standard deviations.
HALF_HEIGHT = 2.3548
# Clipped pixels in a column from which its flanks may tell more than its core.
CLIPPED_CORE = 4
RULES = {
    "continuity": choice.CONTINUITY,
    "strength": choice.STRENGTH,
    "first": choice.FIRST,
    "last": choice.LAST,
}


@dataclass(frozen=True)
class Stripe:
    """Points of the laser stripe, at most one a column (axis u) or a row (axis v).

    ``intensity`` is the height of the stripe over its background in grey levels,
    ``sigma_px`` the standard deviation of the point across the stripe's direction
    of counting: of v for axis u, of u for axis v.
    """

    u: Floats  # (N,)
    v: Floats  # (N,)
    intensity: Floats  # (N,)
    sigma_px: Floats  # (N,)
    axis: str = "u"

    @property
    def uv_px(self) -> Floats:
        """(N, 2)"""
        return np.column_stack([self.u, self.v])

    @property
    def along_across(self) -> tuple[Floats, Floats]:
        """(N,) each: the coordinate that is counted, and the measured one."""
        return (self.u, self.v) if self.axis == "u" else (self.v, self.u)

    @property
    def across(self) -> Floats:
        """(2,) the unit pixel direction in which ``sigma_px`` counts."""
        return np.array([0.0, 1.0]) if self.axis == "u" else np.array([1.0, 0.0])


@dataclass(frozen=True)
class StripeSettings:
    """What an operator may set; None leaves it to the image.

    ``threshold``: grey levels by which the stripe stands out of its surroundings (else four
    standard deviations of the noise). ``min_width_px``, ``max_width_px``: its width at half
    height (else 0.45 and 2.2 times the usual one). ``min_run``: points of a piece, which is
    always more than a round spot of its width would show.
    ``choice``: which of several peaks of a column is the stripe. ``continuity``: the one
    whose piece of line is the brightest on average, where pieces of less than 40 points
    count by the square of their length; ``strength``: the brightest; ``first`` and ``last``: the
    uppermost and the lowest (axis v: leftmost and rightmost) that belongs to a piece.
    """

    threshold: float | None = None
    min_width_px: float | None = None
    max_width_px: float | None = None
    min_run: int = SHORTEST_RUN
    choice: Choice = "continuity"


AUTOMATIC = StripeSettings()


def extract_stripe(
    image: Image,
    axis: str = "u",
    where: NDArray[np.bool_] | None = None,
    settings: StripeSettings = AUTOMATIC,
) -> Stripe:
    """One point per column (axis ``u``) or row (axis ``v``) where the stripe crosses it.

    A Gaussian on a constant background is fitted to each peak, weighted by the
    pixels' noise, which is estimated from the image itself; clipped pixels are left
    out. Where a broad core is clipped, the line is placed by its two flanks and smoothed
    along itself over the core's width (``stripe_flanks``).

    Args:
        image: (H, W) of uint8 or uint16 (9 to 16 significant bits).
        axis: the image axis along which points are counted.
        where: (H, W) pixels in which the stripe may lie; None: anywhere.

    Returns:
        The points in ascending order; none where the image holds no stripe.

    Raises:
        Refusal: not a grey image of whole numbers, a mask of another size, an unknown
            axis, or settings that contradict themselves.
    """
    grey = as_grey(image, axis)
    whole = np.array([[0, grey.shape[0], 0, grey.shape[1]]])
    return extract_from(grey, axis, whole, as_seen(where, grey, axis), settings)


def extract_from(
    grey: Image,
    axis: str,
    parts: NDArray[np.int64],
    where: NDArray[np.bool_],
    settings: StripeSettings,
    told: NDArray[np.float32] | None = None,
) -> Stripe:
    """The stripe in parts of an image that is turned already; see ``extract_stripe``.

    Args:
        grey: (H, W) with the stripe across its columns, as ``as_grey`` makes it.
        parts: (n, 4) first row and the one behind the last, first column and the one
            behind the last, of what is looked at.
        where: (H, W) pixels in which the stripe may lie, or (0, 0) for all.
        told: (4,) what frames before told of the noise and the usual width, see
            ``stripe_kernels.measure``; zeros are filled.
    """
    _check(settings)
    if grey.shape[0] <= LEAST_ROWS or grey.shape[1] < settings.min_run:
        return empty_stripe(axis)
    room = take_room(grey)
    try:
        return _as_stripe(_points(grey, room, parts, where, settings, told), axis)
    finally:
        give_back(room)


def _points(
    grey: Image,
    room: Room,
    parts: NDArray[np.int64],
    where: NDArray[np.bool_],
    settings: StripeSettings,
    told: NDArray[np.float32] | None,
) -> Floats:
    """The stripe's points (4, N): along, across, height, standard deviation."""
    saturated = saturation_level(grey)
    told = np.zeros(4, dtype=np.float32) if told is None else told
    highest = search(grey, where, parts, room.ring, room.score, room.at)
    # after the search, which has fetched the pixels
    read = float(told[0]) or float(read_noise(grey, room.counts))
    everywhere = np.zeros(0, dtype=np.bool_)
    overexposed = highest >= saturated
    if not overexposed:
        peaks, clipped = _peaks(grey, room, everywhere, read, saturated, settings, told)
        overexposed = clipped >= CLIPPED_CORE
    if overexposed:
        cores = clipped_cores(grey, saturated)
        if len(where):
            cores = cores.chosen(where[(cores.first + cores.last) // 2, cores.columns])
        peaks = _peaks(grey, room, cores.beside(grey.shape[1]), read, saturated, settings)[0]
        ours = of_the_line(cores, peaks, settings.min_run)
        if not ours.all():
            cores = cores.chosen(ours)
            beside = cores.beside(grey.shape[1])
            peaks = _peaks(grey, room, beside, read, saturated, settings)[0]
        if len(cores.columns):
            flanks = fit_flanks(grey, cores, saturated, read)
            return joined(peaks, flanks, cores, saturated, settings.min_run)
    return kernels.finish(peaks, settings.min_run, saturated)


def together(parts: Sequence[Stripe]) -> Stripe:
    """The points of stripes that were counted along the same axis, one after the other."""
    return Stripe(
        np.concatenate([part.u for part in parts]),
        np.concatenate([part.v for part in parts]),
        np.concatenate([part.intensity for part in parts]),
        np.concatenate([part.sigma_px for part in parts]),
        parts[0].axis,
    )


def no_stripe(axis: str) -> Stripe:
    """No points, counted along an axis."""
    none = np.zeros(0)
    return Stripe(none, none, none, none, axis)


def saturation_level(image: Image) -> float:
    """The grey level at which this image's pixels are clipped.

    255 for 8 bits; for 16-bit images the sensor's own depth where the brightest
    pixel shows it (1023, 4095, ..., also shifted to the upper bits), else 65535.
    """
    if image.dtype == np.uint8:
        return 255.0
    top = int(image.max())
    if top:
        significant = top >> ((top & -top).bit_length() - 1)
        if significant & (significant + 1) == 0 and 9 <= significant.bit_length() <= 16:
            return float(top)
    return 65535.0


def as_grey(image: Image, axis: str) -> Image:
    """The image with the stripe across its columns, rows contiguous in memory."""
    array = np.asarray(image)
    if array.ndim != 2 or array.dtype not in (np.uint8, np.uint16):
        raise Refusal(
            "image-not-grey",
            f"an image of shape {array.shape} and type {array.dtype}",
            "a stripe is extracted from grey images of 8 to 16 bits, height by width",
        )
    if axis not in ("u", "v"):
        raise Refusal("axis-unknown", f'stripe axis "{axis}"', 'it is "u" or "v"')
    if axis == "u":
        return np.ascontiguousarray(array)
    return cast(Image, cv2.transpose(cast(Image, array)))


def as_seen(where: NDArray[np.bool_] | None, grey: Image, axis: str) -> NDArray[np.bool_]:
    """The mask turned as the image was; (0, 0) for none."""
    if where is None:
        return np.zeros((0, 0), dtype=np.bool_)
    turned = np.ascontiguousarray(where if axis == "u" else where.T, dtype=np.bool_)
    if turned.shape != grey.shape:
        raise Refusal(
            "mask-size",
            f"a mask of {where.shape} pixels for an image of another size",
            "a mask says of every pixel whether the stripe may lie there",
        )
    return turned


def _check(settings: StripeSettings) -> None:
    """Refuses what cannot be meant."""
    least, most = settings.min_width_px, settings.max_width_px
    wrong = ""
    if settings.threshold is not None and not settings.threshold >= 0:
        wrong = f"a threshold of {settings.threshold}"
    elif least is not None and not least >= 0:
        wrong = f"a minimum width of {least} px"
    elif most is not None and not most > (least or 0):
        wrong = f"a maximum width of {most} px"
    elif settings.min_run < 1:
        wrong = f"pieces of {settings.min_run} points"
    elif settings.choice not in RULES:
        wrong = f'the choice "{settings.choice}"'
    if wrong:
        raise Refusal(
            "stripe-settings",
            f"{wrong} of the stripe",
            f"widths are positive and ascend; the choice is one of {', '.join(RULES)}",
        )


def _peaks(
    grey: Image,
    room: Room,
    sought: NDArray[np.bool_],
    read: float,
    saturated: float,
    settings: StripeSettings,
    told: NDArray[np.float32] | None = None,
) -> tuple[Floats, int]:
    """The fitted peaks (5, n) of the columns sought, and the most pixels clipped in one."""
    threshold = settings.threshold
    if threshold is None:
        threshold = STANDS_OUT * math.sqrt(SCORE_VARIANCE * read)
    least, most = settings.min_width_px, settings.max_width_px
    found, clipped = kernels.measure(
        grey,
        room.score,
        room.at,
        sought,
        RULES[settings.choice],
        settings.min_run,
        float(threshold),
        (
            np.nan if least is None else least / HALF_HEIGHT,
            np.nan if most is None else most / HALF_HEIGHT,
        ),
        read,
        saturated,
        room.places,
        room.chosen,
        room.raw,
        room.blocks,
        room.profiles,
        room.fits,
        room.peaks,
        np.zeros(4, dtype=np.float32) if told is None else told,
    )
    return room.peaks[:, :found].copy(), clipped


def _as_stripe(points: Floats, axis: str) -> Stripe:
    along, across, height, sigma = points
    return Stripe(*((along, across) if axis == "u" else (across, along)), height, sigma, axis)


def empty_stripe(axis: str) -> Stripe:
    """A stripe of no points."""
    return _as_stripe(np.zeros((4, 0)), axis)
