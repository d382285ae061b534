"""What is wrong with an arm or its coordinates if the two do not fit: one joint or two, the
instrument's axes, its frame, or the order of the rows."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np

from app.errors import OperationError
from app.messages.message import Text, join, message, quantity, signed
from app.metrology.arm.identification.initial_unknowns import TYPICAL, initial_unknowns
from app.metrology.arm.identification.least_squares import residuals
from app.metrology.arm.identification.observations import BASE, ArmObservations, Coordinates
from app.metrology.arm.identification.scatter import Scatter
from app.metrology.arm.kinematics import Arm
from app.metrology.transforms import Floats

FITS_MM, FITS_SHARE = 20.0, 0.2
"""With its fault undone, an arm lies this close to its coordinates, and at this share at most of
the distance with it."""
TURNS_DEG = (90, 180, -90)
"""Zero positions of joints differ by these."""
MOST_OF_NEXT = 0.5
"""Two faults are named if the arm lies at this share at most of the distance that any two others
leave."""
OWN_FRAME = "instrument"
MIRROR = np.array([-1.0, 1.0, 1.0])


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
    most_mm = min(typical_distance_mm(arm, coordinates) * FITS_SHARE, FITS_MM)
    found = _distances(arm, possible_faults(arm, coordinates))
    if not found or found[0][0] >= most_mm:
        if error.code == "coordinates-unit":  # another unit rather than two joints
            return error
        found = _distances(arm, pairs_of_faults(arm, coordinates))
        if not found or found[0][0] >= most_mm or found[0][0] > MOST_OF_NEXT * found[1][0]:
            return error
    off_mm, fault = found[0]
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
    if any(one.frame == BASE for one in coordinates):
        yield Misfit(
            message("if-frame-is-not-base"),
            message("name-frame-otherwise-than-base"),
            tuple(replace(one, frame=OWN_FRAME) for one in coordinates),
        )


def typical_distance_mm(arm: Arm, coordinates: tuple[Coordinates, ...]) -> float:
    """How far (mm) most points lie from where the arm has them."""
    data = ArmObservations(coordinates=coordinates).stacked
    off_mm: Floats = residuals(data, initial_unknowns(arm, data), Scatter()).distances_mm
    return float(np.quantile(off_mm, TYPICAL))
