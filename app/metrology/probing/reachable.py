"""Where a contact can be at all, by those taken before and by the size of what is touched."""

from dataclasses import dataclass

import numpy as np

from app.metrology.probing.contacts import MIN_SPREAD_MM
from app.metrology.targets.chessboard import Chessboard
from app.metrology.targets.crenellated_block import Crenellated
from app.metrology.targets.target import CalibrationTarget
from app.metrology.transforms import Floats

SLACK_MM = 3.0
"""Two contacts are no farther apart than the object is long, and by this: the tip hangs over."""
OFF_SPHERE_MM = 2.0
"""A contact that lies farther off the sphere of the certified diameter is on something else."""
OFF_PLANE_MM = 1.0
"""The same of a plane."""
CONTACT_SD_MM = 0.1
"""Generously, of one contact: by this a plane through a few is known beside them."""
SDS = 4.0
BOARD_MARGIN = 1.5
"""A board is larger than its pattern, by no more than this factor."""


@dataclass(frozen=True)
class TooFar:
    """A contact too far from an earlier one to be on the same object."""

    other: int
    """Index of the earlier one."""
    apart_mm: float
    limit_mm: float


@dataclass(frozen=True)
class OddContact:
    """A contact that is not on the plane of the others of its face."""

    index: int
    off_mm: float
    is_certain: bool
    """False where another one of them may be the wrong one."""


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
        return float(np.linalg.norm(_face_size_mm(item, face))) + SLACK_MM
    return float(np.linalg.norm(_size_mm(item) + tip_diameter_mm)) + SLACK_MM


def off_sphere_mm(
    before_mm: Floats, tip_mm: Floats, centre_mm: Floats | None, reach_mm: float
) -> float:
    """By how much a contact misses the sphere that others touched; 0 while that is not known.

    Args:
        before_mm: (N, 3) tip centres of the earlier contacts.
        tip_mm: (3,) of the new one.
        centre_mm: (3,) of the sphere, None while they do not say it.
        reach_mm: radius of the sphere and of the tip together.
    """
    if centre_mm is not None:
        off_mm = abs(float(np.linalg.norm(tip_mm - centre_mm)) - reach_mm)
    elif len(before_mm):
        off_mm = float(np.max(np.linalg.norm(before_mm - tip_mm, axis=1))) - 2 * reach_mm
    else:
        return 0.0
    return off_mm if off_mm > OFF_SPHERE_MM else 0.0


def off_plane_mm(before_mm: Floats, tip_mm: Floats) -> float:
    """By how much a contact misses the plane that others touched; 0 while that is not known.

    Args:
        before_mm: (N, 3) tip centres of the earlier contacts.
        tip_mm: (3,) of the new one.
    """
    if len(before_mm) < 3:
        return 0.0
    centre = before_mm.mean(axis=0)
    _, s, Vt = np.linalg.svd(before_mm - centre)
    if s[1] / np.sqrt(len(before_mm)) < MIN_SPREAD_MM:
        return 0.0
    along_1, along_2, off = Vt @ (tip_mm - centre)
    lever = 1 / len(before_mm) + (along_1 / s[0]) ** 2 + (along_2 / s[1]) ** 2
    known_mm = SDS * CONTACT_SD_MM * float(np.sqrt(1 + lever))
    return abs(float(off)) if abs(off) > OFF_PLANE_MM + known_mm else 0.0


def odd_one_out(tips_mm: Floats) -> OddContact | None:
    """The contact that is off the plane of the others; None of fewer than four, or if all are on
    one plane. Where several are such that the others are on a plane without them, as of four, the
    last of these.

    Args:
        tips_mm: (N, 3) tip centres on one face, in the order in which they were taken.
    """
    count = len(tips_mm)
    if count < 4 or _unevenness_mm(tips_mm) <= CONTACT_SD_MM:
        return None
    rest = [np.delete(tips_mm, i, axis=0) for i in range(count)]
    uneven_mm = np.array([_unevenness_mm(one) for one in rest])
    possible = np.flatnonzero(uneven_mm <= max(SDS * CONTACT_SD_MM, float(uneven_mm.min())))
    index = int(possible[-1])
    off_mm = off_plane_mm(rest[index], tips_mm[index])
    return OddContact(index, off_mm, len(possible) == 1) if off_mm > 0 else None


def _unevenness_mm(points_mm: Floats) -> float:
    """Root mean square distance from the best plane."""
    off_mm = np.linalg.svd(points_mm - points_mm.mean(axis=0), compute_uv=False)[2]
    return float(off_mm / np.sqrt(len(points_mm)))


def _size_mm(block: Crenellated) -> Floats:
    """(3,) of the whole block along its axes."""
    x = block.edges_x_mm
    return np.array(
        [x[-1] - x[0], block.back_y_mm - block.front_y_mm, block.crest_z_mm - block.base_z_mm]
    )


def _face_size_mm(block: Crenellated, face: str) -> Floats:
    along, across, up = _size_mm(block)
    if face in ("crest", "floor"):
        return np.array([along, across])
    return np.array([along if face in ("front", "back") else across, up])
