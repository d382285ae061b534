"""Whether contacts and pictures speak for other sizes than the papers have: the tip's
diameter, and the block's from one face to the one opposite.

Unlike the contacts alone (``findings.about_size``), the adjustment knows how the errors of the
arm's links move the faces: it does not take these for a size.
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from app.metrology.adjustment.solve import Adjusted, adjust
from app.metrology.findings import (
    OPENING_MM,
    OPPOSITE,
    Finding,
    Limits,
    grave,
    size_agrees,
    size_off,
    size_unchecked,
)
from app.metrology.frames import Floats
from app.metrology.refusal import Refusal

# A size is doubted beyond this many deviations; the tip's diameter beyond this much, too.
SIGMAS, TIP_MM = 4.0, 0.02
# A wrong size makes the arm look noisy, and then hides in that noise: from so many deviations
# on it is looked at with the noise that is left with the size that suits best.
SUSPECTED_SIGMAS = 2.5
# A share of the contacts' information below which they tell nothing of a size: the tip's
# radius goes with the block's place on three faces, and what is left is rounding.
UNSEEN = 1e-6


@dataclass(frozen=True)
class SizeTold:
    """How much further out than the papers say the tip's centre lies on all the faces that a
    size is about, and the standard deviation of that; for a size from face to face twice as
    much is missing or too much."""

    outward_mm: float
    sd_mm: float

    def beyond(self, sigmas: float, least_mm: float) -> bool:
        return abs(self.outward_mm) >= max(sigmas * self.sd_mm, least_mm)


def about_tip(found: Adjusted, limits: Limits) -> list[Finding]:
    """Whether contacts and pictures would agree better with a tip of another diameter."""
    touches = found.problem.touches
    if touches is None:
        return []
    told = _doubted(found, np.ones(len(touches)), TIP_MM / 2)
    return [] if told is None else [_tip_off(found, told, limits)]


def about_sizes(found: Adjusted, limits: Limits) -> list[Finding]:
    """The same, and the sizes between opposite faces of the block that were touched.

    A wrong tip looks like a wrong size between each two faces, and the other way round: what
    stands out most is named.
    """
    touches = found.problem.touches
    assert touches is not None
    labels = np.array(touches.features)
    pairs = {
        pair: np.isin(labels, pair).astype(np.float64)
        for pair in OPPOSITE
        if all((touches.kept & (labels == face)).any() for face in pair)
    }
    doubted = [
        (told, pair)
        for pair, moved, least_mm in (
            (None, np.ones(len(labels)), TIP_MM / 2),
            *((pair, moved, OPENING_MM / 2) for pair, moved in pairs.items()),
        )
        if (told := _doubted(found, moved, least_mm)) is not None
    ]
    if not doubted:
        return [_agreeing(found, pairs)]
    told, pair = max(doubted, key=lambda one: abs(one[0].outward_mm) / one[0].sd_mm)
    if pair is None:
        return [_tip_off(found, told, limits), *([] if pairs else [size_unchecked()])]
    limit_mm = max(2 * SIGMAS * told.sd_mm, OPENING_MM)
    return [size_off(pair, 2 * told.outward_mm, limit_mm, limits)]


def _agreeing(found: Adjusted, pairs: Mapping[tuple[str, str], Floats]) -> Finding:
    openings_mm = {
        pair: 2 * told.outward_mm
        for pair, moved in pairs.items()
        if (told := size_told(found, moved)) is not None
    }
    return size_agrees(openings_mm) if openings_mm else size_unchecked()


def _tip_off(found: Adjusted, told: SizeTold, limits: Limits) -> Finding:
    assert found.problem.touches is not None
    given = 2 * found.problem.touches.radius_mm
    told_mm = given + 2 * told.outward_mm
    return Finding(
        grave(told.outward_mm, limits),
        "tip-diameter",
        f"Contacts and pictures agree better with a tip of {told_mm:.3f} mm "
        f"(± {2 * told.sd_mm:.3f}) than with {given:.3f} mm.",
        "Check which tip is mounted, its diameter, and that this is the block.",
    )


def _doubted(found: Adjusted, moved: Floats, least_mm: float) -> SizeTold | None:
    """What is told of a size where that is not the papers', with the noise that it leaves."""
    told = size_told(found, moved)
    if told is None or not told.beyond(SUSPECTED_SIGMAS, least_mm):
        return None
    touches = found.problem.touches
    assert touches is not None
    suited = replace(touches, outward_mm=touches.outward_mm + told.outward_mm * moved)
    try:
        again = adjust(replace(found.problem, touches=suited), found.state)
    except Refusal:
        return None
    left = size_told(again, moved)
    if left is None:
        return None
    told = SizeTold(told.outward_mm + left.outward_mm, left.sd_mm)
    return told if told.beyond(SIGMAS, least_mm) else None


def size_told(found: Adjusted, moved: Floats) -> SizeTold | None:
    """What the adjustment tells of a size that moves the contacts (N,) out by ``moved`` times
    itself; None where nothing tells it.

    The size is added to the adjustment as one more unknown, in one step.
    """
    contacts, touches = found.linear.contacts, found.problem.touches
    if contacts is None or touches is None:
        return None
    weight = 1 / contacts.variances(found.scales)
    by_size = -moved[touches.kept]
    J = contacts.jacobian
    pulled = J.T @ (weight * by_size)
    whole = float(weight @ by_size**2)
    free = whole - float(pulled @ found.covariance @ pulled)
    if free <= UNSEEN * whole:
        return None
    return SizeTold(-float(by_size @ (weight * contacts.residuals_mm)) / free, free**-0.5)
