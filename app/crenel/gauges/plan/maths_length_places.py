"""Where a length standard is set up: seven places within an arm's reach, or twenty placements."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from crenel.metrology.arm.kinematics import AnyArm, Arm
from crenel.metrology.transforms import Floats

USUAL_REACH_MM, USUAL_SHOULDER_MM = 1200.0, 300.0
"""The usual reach and shoulder of an arm that states poses, whose links are unknown."""
FULL_SHARE, COLUMN_SHARE = 0.85, 0.2
"""Shares of the reach: so far out the arm still turns its stylus; the column of the arm is not
crossed."""
CLEAR_MM = 60.0
"""The distance from the table that the arm stands on."""
BAR_POINTS = 9
NEAR, MIDDLE, FAR = 0.4, 0.5, 0.65
"""Distance of a standard's middle from the shoulder as a share of the reach."""
Wanted = Sequence[tuple[float, float, tuple[float, float, float]]]
"""Bearing in degrees, distance, and direction seen from there: away from the arm, left, up."""
SEVEN: Wanted = (
    (0.0, MIDDLE, (1.0, 0.0, 0.0)),
    (50.0, NEAR, (0.0, 1.0, 0.0)),
    (-50.0, FAR, (0.0, 1.0, 0.0)),
    (20.0, MIDDLE, (0.0, 0.0, 1.0)),
    (35.0, MIDDLE, (0.0, 1.0, 1.0)),
    (-35.0, MIDDLE, (1.0, 0.0, 1.0)),
    (0.0, MIDDLE, (1.0, 1.0, 1.0)),
)
"""Source: ISO 10360-2 and -12 ask for seven positions over the octants of the volume."""
TWENTY: Wanted = (
    *((bearing, NEAR, (0.0, 1.0, 0.0)) for bearing in (-60.0, 0.0, 60.0)),
    *((bearing, MIDDLE, (1.0, 0.0, 0.0)) for bearing in (-60.0, -20.0, 20.0, 60.0)),
    *((bearing, MIDDLE, (0.0, 0.0, 1.0)) for bearing in (-45.0, 0.0, 45.0)),
    *((bearing, MIDDLE, (1.0, 0.0, 1.0)) for bearing in (-30.0, 30.0)),
    *((bearing, MIDDLE, (0.0, 1.0, 1.0)) for bearing in (-70.0, 0.0, 70.0)),
    *((bearing, FAR, (0.0, 1.0, 0.0)) for bearing in (-50.0, 0.0, 50.0)),
    (-20.0, MIDDLE, (1.0, 1.0, 1.0)),
    (20.0, MIDDLE, (1.0, -1.0, 1.0)),
)
"""The placements of the volumetric test of ASME B89.4.22: near, middle and far, in every direction.
The placements are choices of this program."""


SEAT_SHARES = (0.2, 0.5, 0.8)
"""Shares of the reach: at most, between, and at least. Source: ASME B89.4.22-2004, by QIF 3.0."""


@dataclass(frozen=True, eq=False)
class ArmReach:
    """What an arm reaches, about its shoulder."""

    shoulder_mm: Floats  # (3,), arm frame
    radius_mm: float
    """With the arm stretched out."""
    known: bool
    """Whether it follows from the arm's links."""


def arm_reach(arm: AnyArm) -> ArmReach:
    """The reach by the arm's links and its tip; a usual one if the links are unknown, or have no
    length."""
    usual = ArmReach(np.array([0.0, 0.0, USUAL_SHOULDER_MM]), USUAL_REACH_MM, known=False)
    if not isinstance(arm, Arm):
        return usual
    first, *others = arm.joints
    links_mm = abs(first.a_mm) + sum(float(np.hypot(one.a_mm, one.d_mm)) for one in others)
    radius_mm = links_mm + float(np.linalg.norm(arm.tip.centre_mm))
    if radius_mm == 0:
        return usual
    return ArmReach(np.array([0.0, 0.0, first.d_mm]), radius_mm, known=True)


def propose_places(reach: ArmReach, bar_mm: float, wanted: Wanted = SEVEN) -> Floats:
    """Placements (P, 2, 3) mm of a standard's ends, arm frame.

    The seven are: horizontal away from the arm, crosswise near on the left and far on the right,
    vertical, two inclined by 45°, and the diagonal of the volume. Each is as near to where it is
    wanted as it has all of the standard within the reach, above the table, and beside the arm's
    column.

    Args:
        bar_mm: length of the standard.
    """
    along = np.linspace(-0.5, 0.5, BAR_POINTS)[:, None]
    places = []
    for bearing_deg, share, seen in wanted:
        turn = np.radians(bearing_deg)
        R = np.array(
            [[np.cos(turn), -np.sin(turn), 0], [np.sin(turn), np.cos(turn), 0], [0, 0, 1.0]]
        )
        direction = R @ (np.array(seen) / np.linalg.norm(seen))
        middles = _middles(reach, R, share)
        bars = middles[:, None] + along * bar_mm * direction
        best = middles[int(np.argmin(_misfit_mm(reach, bars, middles)))]
        places.append([best - 0.5 * bar_mm * direction, best + 0.5 * bar_mm * direction])
    return np.array(places)


def propose_seats(reach: ArmReach) -> Floats:
    """(3, 3) mm of the seats of ASME B89.4.22, near, in the middle and far: straight ahead, over
    the table, as far from the shoulder as the standard asks for."""
    z = 2 * CLEAR_MM
    down = reach.shoulder_mm[2] - z
    away = np.array(SEAT_SHARES) * reach.radius_mm
    ahead = np.sqrt(np.maximum(away**2 - down**2, (0.5 * away) ** 2))
    return np.column_stack([reach.shoulder_mm[0] + ahead, np.zeros(3), np.full(3, z)])


def reach_share(reach: ArmReach, place_mm: Floats) -> float:
    """Distance of a place (3,) from the shoulder as a share of the reach."""
    return float(np.linalg.norm(place_mm - reach.shoulder_mm)) / reach.radius_mm


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
