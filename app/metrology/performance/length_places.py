"""Where a length standard is set up: seven places within an arm's reach."""

from dataclasses import dataclass

import numpy as np

from app.metrology.arm.kinematics import AnyArm, Arm
from app.metrology.performance.lengths import PLACES
from app.metrology.transforms import Floats

USUAL_REACH_MM, USUAL_SHOULDER_MM = 1200.0, 300.0
"""Of an arm that reports poses, whose links are unknown."""
FULL_SHARE, COLUMN_SHARE = 0.85, 0.2
"""Of the reach: so far out the arm still turns its stylus; the column of the arm is not crossed."""
CLEAR_MM = 60.0
"""Of the table that the arm stands on."""
BAR_POINTS = 9
NEAR, MIDDLE, FAR = 0.4, 0.5, 0.65
"""Distance of a standard's middle from the shoulder as a share of the reach."""
WANTED: tuple[tuple[float, float, tuple[float, float, float]], ...] = (
    (0.0, MIDDLE, (1.0, 0.0, 0.0)),
    (50.0, NEAR, (0.0, 1.0, 0.0)),
    (-50.0, FAR, (0.0, 1.0, 0.0)),
    (20.0, MIDDLE, (0.0, 0.0, 1.0)),
    (35.0, MIDDLE, (0.0, 1.0, 1.0)),
    (-35.0, MIDDLE, (1.0, 0.0, 1.0)),
    (0.0, MIDDLE, (1.0, 1.0, 1.0)),
)
"""Bearing in degrees, distance, and direction seen from there: away from the arm, to the left, up.

Source: ISO 10360-2 and -12 ask for seven positions over the octants of the volume."""


@dataclass(frozen=True, eq=False)
class ArmReach:
    """What an arm reaches, about its shoulder."""

    shoulder_mm: Floats  # (3,), arm frame
    radius_mm: float
    """With the arm stretched out."""
    known: bool
    """Whether it follows from the arm's links."""


def arm_reach(arm: AnyArm) -> ArmReach:
    """The reach by the arm's links and its tip; a usual one if the links are unknown."""
    if not isinstance(arm, Arm):
        return ArmReach(np.array([0.0, 0.0, USUAL_SHOULDER_MM]), USUAL_REACH_MM, known=False)
    first, *others = arm.joints
    links_mm = abs(first.a_mm) + sum(float(np.hypot(one.a_mm, one.d_mm)) for one in others)
    radius_mm = links_mm + float(np.linalg.norm(arm.tip.centre_mm))
    return ArmReach(np.array([0.0, 0.0, first.d_mm]), radius_mm, known=True)


def propose_places(reach: ArmReach, bar_mm: float) -> Floats:
    """Seven placements (7, 2, 3) mm of a standard's ends, arm frame.

    Horizontal away from the arm, crosswise near on the left and far on the right, vertical, two
    inclined by 45°, and the diagonal of the volume: each as near to where it is wanted as it has
    all of the standard within the reach, above the table, and beside the arm's column.

    Args:
        bar_mm: length of the standard.
    """
    along = np.linspace(-0.5, 0.5, BAR_POINTS)[:, None]
    places = []
    for bearing_deg, share, seen in WANTED:
        turn = np.radians(bearing_deg)
        R = np.array(
            [[np.cos(turn), -np.sin(turn), 0], [np.sin(turn), np.cos(turn), 0], [0, 0, 1.0]]
        )
        direction = R @ (np.array(seen) / np.linalg.norm(seen))
        middles = _middles(reach, R, share)
        bars = middles[:, None] + along * bar_mm * direction
        best = middles[int(np.argmin(_misfit_mm(reach, bars, middles)))]
        places.append([best - 0.5 * bar_mm * direction, best + 0.5 * bar_mm * direction])
    assert len(places) == PLACES
    return np.array(places)


def _middles(reach: ArmReach, R: Floats, share: float) -> Floats:
    """(M, 3) places of a standard's middle, the wanted one first."""
    r = reach.radius_mm
    grid = np.meshgrid(
        r * np.array([share, *np.linspace(0.2, 0.7, 11)]),
        r * np.array([0.0, 0.15, -0.15, 0.3, -0.3]),
        r * np.array([0.0, -0.1, 0.1, -0.2, 0.2, 0.3, 0.4]),
        indexing="ij",
    )
    return np.asarray(np.column_stack([axis.ravel() for axis in grid]) @ R.T + reach.shoulder_mm)


def _misfit_mm(reach: ArmReach, bars_mm: Floats, middles_mm: Floats) -> Floats:
    """(M,) how far each bar (M, P, 3) is from where it may be, above all, and from the wanted."""
    far = np.linalg.norm(bars_mm - reach.shoulder_mm, axis=2) - FULL_SHARE * reach.radius_mm
    column = COLUMN_SHARE * reach.radius_mm - np.linalg.norm(bars_mm[:, :, :2], axis=2)
    low = CLEAR_MM - bars_mm[:, :, 2]
    outside = np.maximum(np.max([far, column, low], axis=(0, 2)), 0.0)
    return np.asarray(1e3 * outside + np.linalg.norm(middles_mm - middles_mm[0], axis=1))
