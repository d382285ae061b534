"""Frames whose line is clipped, until their stages are in C."""

import math

import numpy as np
from numpy.typing import NDArray

from app.metrology import stripe_choice as choice
from app.metrology import stripe_kernels as kernels
from app.metrology.frames import Floats
from app.metrology.image import Image, saturation_level
from app.metrology.stripe.settings import StripeSettings
from app.metrology.stripe_flanks import clipped_cores, fit_flanks
from app.metrology.stripe_noise import read_noise
from app.metrology.stripe_overexposed import joined, of_the_line
from app.metrology.stripe_room import Room
from app.metrology.stripe_search import search

STANDS_OUT = 4.0
SCORE_VARIANCE = 7 / 12
HALF_HEIGHT = 2.3548
CLIPPED_CORE = 4
RULES = {
    "continuity": choice.CONTINUITY,
    "strength": choice.STRENGTH,
    "first": choice.FIRST,
    "last": choice.LAST,
}


def clipped_points(
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
