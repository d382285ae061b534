"""How closely a block has to be made, or measured."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from crenel.messages.message import message
from crenel.metrology.design.expected_accuracy import Expectation, ExpectedAccuracy
from crenel.progress import Progress, no_progress

MEASURED_MM = 0.002
"""Standard uncertainty of a size that a laboratory has measured."""
TOLERANCES_MM = (0.005, 0.01, 0.02, 0.05, 0.1)
"""Tolerances (±) that are compared."""
WORTH_MEASURING = 1.25
"""A block that is used as drawn may be worse than a measured one by this factor."""


@dataclass(frozen=True)
class ToleranceEffect:
    """The accuracy of calibrations with a block that is used as drawn, made to ± a tolerance.

    Standard uncertainties of a point over the measuring range in µm, k = 1. Without a tolerance,
    the block is measured to ``MEASURED_MM``.
    """

    tolerance_mm: float | None
    one_pose_um: float
    eight_poses_um: float


def tolerance_effects(
    sessions: tuple[Expectation, Expectation],
    measured: tuple[ExpectedAccuracy, ExpectedAccuracy],
    given_mm: float | None = None,
    progress: Progress = no_progress,
) -> tuple[ToleranceEffect, ...]:
    """A measured block, then blocks made to each of ``TOLERANCES_MM`` and to a given tolerance.

    The size of a block that was made to a tolerance lies anywhere within, with the standard
    uncertainty of a rectangular distribution.

    Args:
        sessions: with one pose and with eight.
        measured: their accuracies with a measured block.
        given_mm: a tolerance beside the usual ones.
        progress: called with the share done, 0 to 1, and the current step.

    Source:
        JCGM 100:2008 (GUM), 4.3.7.
    """
    effects = [ToleranceEffect(None, *(one.total_um for one in measured))]
    own = () if given_mm is None else (given_mm,)
    made = sorted({*TOLERANCES_MM, *own})
    for done, tolerance_mm in enumerate(made):
        progress(done / len(made), message("design-predicts-accuracy"))
        sd_mm = float(tolerance_mm / np.sqrt(3))
        as_drawn = (one.accuracy(sd_mm).total_um for one in sessions)
        effects.append(ToleranceEffect(tolerance_mm, *as_drawn))
    return tuple(effects)


def widest_tolerance_mm(effects: Sequence[ToleranceEffect]) -> float:
    """The widest tolerance with which a block need not be measured; the narrowest, if none.

    Args:
        effects: as ``tolerance_effects`` returns them.
    """
    measured, *as_drawn = effects
    limit_um = WORTH_MEASURING * measured.eight_poses_um
    good = [one.tolerance_mm for one in as_drawn if one.eight_poses_um <= limit_um]
    return max((mm for mm in good if mm is not None), default=TOLERANCES_MM[0])
