"""What is wrong with an arm or its coordinates if the two do not fit: one joint or two, the
instrument's axes, unit or frame, its place, or the order of the rows."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np

from crenel.errors import OperationError
from crenel.messages.message import Text, join, message, quantity, signed
from crenel.metrology.arm.identification.initial_unknowns import TYPICAL, initial_unknowns
from crenel.metrology.arm.identification.least_squares import residuals
from crenel.metrology.arm.identification.observations import (
    BASE,
    TIP,
    ArmObservations,
    Coordinates,
)
from crenel.metrology.arm.identification.scatter import Scatter
from crenel.metrology.arm.kinematics import Arm, flange_poses
from crenel.metrology.transforms import Floats, nearest_rotation
from crenel.units import MM_PER

FITS_MM, FITS_SHARE = 20.0, 0.2
"""With its fault undone, an arm lies this close to its coordinates, and at this share at most of
the distance with it."""
TURNS_DEG = (90, 180, -90)
"""Zero positions of joints differ by these."""
MOST_OF_NEXT = 0.5
"""Two faults are named if the arm lies at this share at most of the distance that any two others
leave."""
OWN_FRAME = "instrument"
ALL_BUT_FEW = 0.9
MIRROR = np.array([-1.0, 1.0, 1.0])
UNITS_MM = {"inches": MM_PER["inch"], "centimetres": MM_PER["cm"]}
LEAST_SET_UP, SET_UPS = 6, 200
"""Points of a set-up of its own, and number of rows at which it is taken to begin."""


@dataclass(frozen=True)
class Misfit:
    """A fault of the arm or its coordinates, in words, and the coordinates without it."""

    reason: Text
    remedy: Text
    coordinates: tuple[Coordinates, ...]


@dataclass(frozen=True)
class JointFault:
    """A joint whose readings are ``sign`` times what the arm states, and ``offset_rad`` more."""

    joint: int
    sign: float
    offset_rad: float
    reason: Text
    remedy: Text

    def undone(self, coordinates: tuple[Coordinates, ...]) -> tuple[Coordinates, ...]:
        """The coordinates with the joint's readings as the arm states them."""
        signs = np.ones(coordinates[0].q_rad.shape[1])
        offset = np.zeros(len(signs))
        signs[self.joint], offset[self.joint] = self.sign, self.offset_rad
        return tuple(replace(one, q_rad=one.q_rad * signs + offset) for one in coordinates)


def explain_misfit(
    arm: Arm, coordinates: tuple[Coordinates, ...], error: OperationError
) -> OperationError:
    """The error with the fault that explains it, or the same error if none does.

    Args:
        error: ``arm-does-not-fit`` or ``coordinates-unit``; another one is returned as it is.
    """
    if error.code not in ("arm-does-not-fit", "coordinates-unit"):
        return error
    moved = _move_of_instrument(arm, coordinates)
    if moved is not None:
        return _name_fault(error, *moved)
    most_mm = min(typical_distance_mm(arm, coordinates) * FITS_SHARE, FITS_MM)
    found = _distances(arm, possible_faults(arm, coordinates))
    if not found or found[0][0] >= most_mm:
        if error.code == "coordinates-unit":  # another unit rather than two joints
            return error
        found = _distances(arm, pairs_of_faults(arm, coordinates))
        if not found or found[0][0] >= most_mm or found[0][0] > MOST_OF_NEXT * found[1][0]:
            return error
    return _name_fault(error, *found[0])


def _name_fault(error: OperationError, off_mm: float, fault: Misfit) -> OperationError:
    off = quantity(off_mm, "mm", 1)
    why = message("coordinates-fit-otherwise", reason=fault.reason, off=off)
    return OperationError("arm-does-not-fit", error.what, why, fault.remedy)


def _distances(arm: Arm, faults: Iterator[Misfit]) -> list[tuple[float, Misfit]]:
    """How far (mm) most points lie off without each fault, the nearest first."""
    found = [(typical_distance_mm(arm, fault.coordinates), fault) for fault in faults]
    return sorted(found, key=lambda one: one[0])


def joint_faults(arm: Arm) -> Iterator[JointFault]:
    """Every fault of a joint that is looked for."""
    for k, joint in enumerate(arm.joints):
        name = joint.name
        yield JointFault(
            k,
            -1.0,
            0.0,
            message("if-joint-turned-other-way", joint=name),
            message("reverse-sign-of-joint", joint=name),
        )
        for turn_deg in TURNS_DEG:
            turn = signed(turn_deg, "°")
            yield JointFault(
                k,
                1.0,
                float(np.deg2rad(turn_deg)),
                message("if-joint-zero-elsewhere", joint=name, turn=turn),
                message("change-theta-of-joint", joint=name, turn=turn),
            )


def pairs_of_faults(arm: Arm, coordinates: tuple[Coordinates, ...]) -> Iterator[Misfit]:
    """Any two faults of two joints."""
    for one, other in combinations(joint_faults(arm), 2):
        if one.joint != other.joint:
            yield Misfit(
                message("two-reasons", first=one.reason, second=other.reason),
                join([one.remedy, other.remedy], "; "),
                other.undone(one.undone(coordinates)),
            )


def possible_faults(arm: Arm, coordinates: tuple[Coordinates, ...]) -> Iterator[Misfit]:
    """Every fault that is looked for, with the coordinates as they are without it."""
    for one in joint_faults(arm):
        yield Misfit(one.reason, one.remedy, one.undone(coordinates))
    yield Misfit(
        message("if-coordinates-mirrored"),
        message("check-order-and-signs-of-coordinates"),
        tuple(replace(one, points_mm=one.points_mm * MIRROR) for one in coordinates),
    )
    for step in (1, -1):
        yield Misfit(
            message("if-angles-of-next-row", row="before" if step > 0 else "after"),
            message("give-each-row-angles-of-its-pose"),
            tuple(replace(one, q_rad=np.roll(one.q_rad, step, axis=0)) for one in coordinates),
        )
    for unit, length_mm in UNITS_MM.items():
        yield Misfit(
            message("if-coordinates-in-unit", unit=unit),
            message("convert-columns-x-mm-y-mm"),
            tuple(replace(one, points_mm=one.points_mm * length_mm) for one in coordinates),
        )
    if any(one.rotations is not None for one in coordinates):
        yield Misfit(
            message("if-poses-inverted"),
            message("give-pose-of-marker-in-frame"),
            tuple(_invert(one) for one in coordinates),
        )
    if any(one.frame == BASE for one in coordinates):
        yield Misfit(
            message("if-frame-is-not-base"),
            message("name-frame-otherwise-than-base"),
            tuple(replace(one, frame=OWN_FRAME) for one in coordinates),
        )


def _move_of_instrument(
    arm: Arm, coordinates: tuple[Coordinates, ...]
) -> tuple[float, Misfit] | None:
    """How far (mm) all but a few points lie off if the instrument moved; None if it did not.

    Half of the points may fit as they are, so that what is typical of all shows nothing.
    """
    if typical_distance_mm(arm, coordinates, ALL_BUT_FEW) < FITS_MM / FITS_SHARE:
        return None
    found = [
        (typical_distance_mm(arm, fault.coordinates, ALL_BUT_FEW), fault)
        for fault in moves_of_instruments(arm, coordinates)
    ]
    nearest = min(found, key=lambda one: one[0], default=None)
    return nearest if nearest is not None and nearest[0] < FITS_MM else None


def moves_of_instruments(arm: Arm, coordinates: tuple[Coordinates, ...]) -> Iterator[Misfit]:
    """For the only marker of a frame: the instrument moved between two rows."""
    for k, found in enumerate(coordinates):
        alone = [other.frame for other in coordinates].count(found.frame) == 1
        if found.frame == BASE or not alone or len(found.q_rad) < 2 * LEAST_SET_UP:
            continue
        row = _row_of_move(arm, found)
        later = np.arange(len(found.q_rad)) >= row
        moved = replace(found.part(later), frame=f"{found.frame} ({OWN_FRAME})")
        yield Misfit(
            message("if-instrument-moved", line=found.lines[row]),
            message("name-frame-of-each-set-up"),
            (*coordinates[:k], found.part(~later), moved, *coordinates[k + 1 :]),
        )


def _invert(one: Coordinates) -> Coordinates:
    """The inverse of each pose; points without a rotation stay as they are."""
    if one.rotations is None:
        return one
    back = np.swapaxes(one.rotations, 1, 2)
    return replace(one, rotations=back, points_mm=-(back @ one.points_mm[:, :, None])[:, :, 0])


def _row_of_move(arm: Arm, one: Coordinates) -> int:
    """The first row after which the points lie best in a frame of their own."""
    poses, count = flange_poses(arm, one.q_rad), len(one.q_rad)
    # a marker that is to be estimated is near the flange
    place_mm = np.zeros(3) if one.offset_mm is None else one.offset_mm
    if one.marker == TIP:
        place_mm = arm.tip.centre_mm
    predicted_mm = poses[:, :3, :3] @ place_mm + poses[:, :3, 3]
    rows = range(LEAST_SET_UP, count - LEAST_SET_UP + 1, max(1, count // SET_UPS))

    def rest(own: slice) -> float:
        """Sum of squares (mm²) that a rigid motion of these points leaves."""
        a, b = (points[own] - points[own].mean(axis=0) for points in (one.points_mm, predicted_mm))
        return float(np.sum((a - b @ nearest_rotation(a.T @ b).T) ** 2))

    left = [rest(slice(row)) + rest(slice(row, None)) for row in rows]
    return rows[int(np.argmin(left))]


def typical_distance_mm(
    arm: Arm, coordinates: tuple[Coordinates, ...], share: float = TYPICAL
) -> float:
    """How far (mm) most points, or another share, lie from where the arm has them."""
    data = ArmObservations(coordinates=coordinates).stacked
    off_mm: Floats = residuals(data, initial_unknowns(arm, data), Scatter()).distances_mm
    return float(np.quantile(off_mm, share))
