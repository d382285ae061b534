"""What is wrong with an arm or its coordinates if the two do not fit: one joint, the instrument's
axes, its frame, or the order of the rows."""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from app.errors import OperationError
from app.messages.message import Text, message, quantity, signed
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
OWN_FRAME = "instrument"
MIRROR = np.array([-1.0, 1.0, 1.0])


@dataclass(frozen=True)
class Misfit:
    """A fault of the arm or its coordinates, in words, and the coordinates without it."""

    reason: Text
    remedy: Text
    coordinates: tuple[Coordinates, ...]


def explain_misfit(
    arm: Arm, coordinates: tuple[Coordinates, ...], error: OperationError
) -> OperationError:
    """The error with the fault that explains it, or the same error if none does.

    Args:
        error: ``arm-does-not-fit`` or ``coordinates-unit``; another one is returned as it is.
    """
    if error.code not in ("arm-does-not-fit", "coordinates-unit"):
        return error
    least_mm = typical_distance_mm(arm, coordinates) * FITS_SHARE
    best: tuple[float, Misfit] | None = None
    for fault in possible_faults(arm, coordinates):
        off_mm = typical_distance_mm(arm, fault.coordinates)
        if off_mm < min(least_mm, FITS_MM) and (best is None or off_mm < best[0]):
            best = off_mm, fault
    if best is None:
        return error
    off_mm, fault = best
    off = quantity(off_mm, "mm", 1)
    why = message("coordinates-fit-otherwise", reason=fault.reason, off=off)
    return OperationError("arm-does-not-fit", error.what, why, fault.remedy)


def possible_faults(arm: Arm, coordinates: tuple[Coordinates, ...]) -> Iterator[Misfit]:
    """Every fault that is looked for, with the coordinates as they are without it."""
    names = [joint.name for joint in arm.joints]
    for k, name in enumerate(names):
        signs = np.ones(len(names))
        signs[k] = -1.0
        yield Misfit(
            message("if-joint-turned-other-way", joint=name),
            message("reverse-sign-of-joint", joint=name),
            tuple(replace(one, q_rad=one.q_rad * signs) for one in coordinates),
        )
        for turn_deg in TURNS_DEG:
            offset = np.zeros(len(names))
            offset[k] = np.deg2rad(turn_deg)
            turn = signed(turn_deg, "°")
            yield Misfit(
                message("if-joint-zero-elsewhere", joint=name, turn=turn),
                message("change-theta-of-joint", joint=name, turn=turn),
                tuple(replace(one, q_rad=one.q_rad + offset) for one in coordinates),
            )
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
