"""Where a contact can be at all, by those taken before and by the size of what is touched."""

from dataclasses import dataclass

import numpy as np

from crenel.metrology.fitting.reference_sphere import sphere_centre
from crenel.metrology.fitting.touched_shape import (
    CONTACT_SD_MM,
    agree_on_plane,
    agree_on_sphere,
    distances_from_plane_mm,
)
from crenel.metrology.targets.chessboard import Chessboard
from crenel.metrology.targets.crenellated_block import block_size_mm, face_size_mm
from crenel.metrology.targets.target import CalibrationTarget
from crenel.metrology.transforms import Floats

SLACK_MM = 3.0
"""Two contacts are no farther apart than the object is long, and by this: the tip hangs over."""
OFF_SPHERE_MM = 2.0
"""A contact that lies farther off the sphere of the certified diameter is on something else."""
OFF_PLANE_MM = 1.0
"""The same of a plane."""
FEWEST_ON_PLANE, FEWEST_ON_SPHERE = 6, 7
"""With fewer contacts, another one may be the wrong one."""
BOARD_MARGIN = 1.5
"""A board is larger than its pattern, by no more than this factor."""


@dataclass(frozen=True)
class TooFar:
    """A contact too far from an earlier one to be on the same object."""

    other: int
    """Index of the earlier one."""
    apart_mm: float
    limit_mm: float


def too_far(before_mm: Floats, tip_mm: Floats, limits_mm: Floats) -> TooFar | None:
    """The earlier contact that a new one cannot share the object with; None if there is none.

    Args:
        before_mm: (N, 3) tip centres of the earlier contacts.
        tip_mm: (3,) of the new one.
        limits_mm: (N,) how far apart the two can be.
    """
    if not len(before_mm):
        return None
    apart_mm = np.linalg.norm(before_mm - tip_mm, axis=1)
    worst = int(np.argmax(apart_mm - limits_mm))
    if apart_mm[worst] <= limits_mm[worst]:
        return None
    return TooFar(worst, float(apart_mm[worst]), float(limits_mm[worst]))


def farthest_apart_mm(
    item: CalibrationTarget, face: str, other: str, tip_diameter_mm: float
) -> float:
    """How far apart two tip centres that touch these faces can be."""
    if isinstance(item, Chessboard):
        return BOARD_MARGIN * float(np.linalg.norm(item.extent_mm)) + SLACK_MM
    if face == other:
        return float(np.linalg.norm(face_size_mm(item, face))) + SLACK_MM
    return float(np.linalg.norm(block_size_mm(item) + tip_diameter_mm)) + SLACK_MM


def off_sphere_mm(before_mm: Floats, tip_mm: Floats, reach_mm: float) -> float:
    """By how much a contact misses the sphere that others touched; 0 while that is not known.

    Args:
        before_mm: (N, 3) tip centres of the earlier contacts.
        tip_mm: (3,) of the new one.
        reach_mm: radius of the sphere and of the tip together.
    """
    tips = np.vstack([before_mm, tip_mm])
    if len(tips) < FEWEST_ON_SPHERE:
        apart_mm = float(np.linalg.norm(tips[:-1] - tip_mm, axis=1).max(initial=0.0)) - 2 * reach_mm
        return apart_mm if apart_mm > OFF_SPHERE_MM else 0.0
    found = agree_on_sphere(tips, _contact_covariances_mm2(len(tips)), reach_mm)
    if found.kept[-1]:
        return 0.0
    centre = sphere_centre(tips[found.kept], 2 * reach_mm)
    off_mm = abs(float(np.linalg.norm(tip_mm - centre)) - reach_mm)
    return off_mm if off_mm > OFF_SPHERE_MM else 0.0


def off_plane_mm(before_mm: Floats, tip_mm: Floats) -> float:
    """By how much a contact misses the plane that others touched; 0 while that is not known.

    Args:
        before_mm: (N, 3) tip centres of the earlier contacts.
        tip_mm: (3,) of the new one.
    """
    tips = np.vstack([before_mm, tip_mm])
    if len(tips) < FEWEST_ON_PLANE:
        return 0.0
    found = agree_on_plane(tips, _contact_covariances_mm2(len(tips)))
    off_mm = abs(float(distances_from_plane_mm(tips, found.kept)[-1]))
    return 0.0 if found.kept[-1] or off_mm <= OFF_PLANE_MM else off_mm


def _contact_covariances_mm2(count: int) -> Floats:
    return np.tile(CONTACT_SD_MM**2 * np.eye(3), (count, 1, 1))
