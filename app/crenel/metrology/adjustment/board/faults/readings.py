"""Other readings of poses, by which nearly all of them agree with the pictures of a board."""

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Literal, get_args

import numpy as np

from crenel.metrology.adjustment.board.faults.agreement import (
    FEWEST_CLOSE,
    FEWEST_PAIRS,
    SeenBoard,
    agreement,
    agreement_with_other_size,
    mounting_of,
    scale_translations,
)
from crenel.metrology.adjustment.board.faults.changed_midway import ChangeFault, list_changes
from crenel.metrology.adjustment.board.faults.misread_rotations import (
    MisreadRotations,
    list_rereadings,
)
from crenel.metrology.adjustment.board.faults.pairing import Pairing, PairingFault, list_pairings
from crenel.metrology.adjustment.board.initial_guess import size_by_motion
from crenel.metrology.adjustment.board.problem import BoardInputs
from crenel.metrology.adjustment.core.hand_eye import Mounting
from crenel.metrology.arm.kinematics import RobotArm
from crenel.metrology.robust import median
from crenel.metrology.transforms import Floats, inverse, rigid
from crenel.units import MISTAKEN_UNITS, MM_PER

Convention = Literal["inverted", "scalar-first", "scalar-first-inverted", "turns-inverted"]
PoseFault = Literal[
    Convention, PairingFault, ChangeFault, "mirrored", "unit", "rotations", "certificate"
]
POSITION_UNITS = (*MISTAKEN_UNITS, "dm", "µm")
"""In which positions are stated by mistake."""
WITHIN = 0.1
"""By which the size of squares may differ from one in another unit."""
FEWEST_MOVED = 2
"""Pictures that must agree with another pose than their own: else the others explain nothing."""
SQUARES_MM = 1.0, 300.0
"""Squares of a board that a camera sees."""


@dataclass(frozen=True)
class OtherReading:
    """How many poses agree with the pictures, and how closely, if they are read otherwise."""

    fault: PoseFault
    agree: int
    apart_mm: float
    rotations: MisreadRotations = field(default_factory=lambda: MisreadRotations("", ""))
    """What the rotations were taken for, if the fault is in them."""
    pairing: Pairing | None = None
    first: int = 0
    """Number of the pose from which something changed or slipped."""
    other: int = 0
    """Number of the pose with which that one was swapped."""
    unit: str = ""


def list_other_readings(
    inputs: BoardInputs, seen: SeenBoard, T_arm_flange: Floats
) -> Iterator[list[OtherReading]]:
    """The readings by which nearly all poses agree, the simplest first."""
    robot = isinstance(inputs.arm, RobotArm)
    mirrored = _reading("mirrored", agreement(seen.mirror(), T_arm_flange))
    yield [] if mirrored is None else [mirrored]
    yield [*_conventions(seen, T_arm_flange), *_units(seen, T_arm_flange)] if robot else []
    ways = seen.ways()
    yield list(_pairings(inputs, seen, T_arm_flange, ways))
    if robot:
        turns = None if max(map(len, ways)) > 1 else np.array([one[0, :3, :3] for one in ways])
        rereadings = [
            _reading("rotations", agreement(seen, poses), rotations=rotations)
            for rotations, poses in list_rereadings(T_arm_flange, turns)
        ]
        yield [one for one in rereadings if one is not None]
    numbers = [one.number for one in inputs.observations]
    changes = [
        OtherReading(one.fault, one.agree, median(one.off_mm), first=numbers[one.first])
        for one in list_changes(seen, T_arm_flange)
    ]
    given = mounting_of(seen, T_arm_flange)
    resized = None if given is None else agreement_with_other_size(given, seen.board)
    certificate = _reading("certificate", resized)
    # a few poses nearly agree with a board of any size: these two are compared
    yield changes if certificate is None else [*changes, certificate]


def _reading(
    fault: PoseFault,
    mounting: Mounting | None,
    *,
    rotations: MisreadRotations | None = None,
    unit: str = "",
) -> OtherReading | None:
    """A reading by what the poses agree on, if they do."""
    if mounting is None:
        return None
    agree, apart_mm = int(np.sum(~mounting.contradicts)), median(mounting.off_mm)
    return OtherReading(
        fault, agree, apart_mm, rotations=rotations or MisreadRotations("", ""), unit=unit
    )


def _conventions(seen: SeenBoard, T_arm_flange: Floats) -> Iterator[OtherReading]:
    for fault in get_args(Convention):
        one = _reading(fault, agreement(seen, reread(T_arm_flange, fault)))
        if one is not None:
            yield one


def _units(seen: SeenBoard, T_arm_flange: Floats) -> Iterator[OtherReading]:
    """Positions in another unit; not where they would make squares of a size that no board has."""
    given = mounting_of(seen, T_arm_flange)
    if given is None:
        return
    square_mm, scale = seen.board.square_mm, size_by_motion(given).scale
    least, most = SQUARES_MM
    for unit in POSITION_UNITS:
        factor = MM_PER[unit]
        # squares ten times larger are squares of another board
        possible = least <= square_mm <= most and (factor > 1 or scale * square_mm > most)
        if possible and abs(scale * factor - 1) < WITHIN:
            one = _reading(
                "unit", agreement(seen, scale_translations(T_arm_flange, factor)), unit=unit
            )
            if one is not None:
                yield one


def _pairings(
    inputs: BoardInputs, seen: SeenBoard, T_arm_flange: Floats, ways: list[Floats]
) -> Iterator[OtherReading]:
    """Pictures and poses that slipped, where fewer poses would agree with one pairing less."""
    observations = inputs.observations
    numbers = [one.number for one in observations]
    table = sorted([*numbers, *(one.number for one in inputs.failed_poses)])
    rows = [table.index(number) for number in numbers]
    turns = [one[:, :3, :3] for one in ways]
    for one in list_pairings(T_arm_flange[:, :3, :3], turns, rows):
        in_place = int(np.sum(one.picture == one.pose))
        fewest = FEWEST_PAIRS if in_place else FEWEST_CLOSE
        mounting = agreement(seen.select(one.picture.tolist()), T_arm_flange[one.pose], fewest)
        if mounting is None:
            continue
        if np.sum(~mounting.contradicts) >= in_place + FEWEST_MOVED:
            yield OtherReading(
                one.fault,
                int(np.sum(~mounting.contradicts)),
                median(mounting.off_mm),
                pairing=one,
                first=observations[one.first].number,
                other=observations[one.other].number,
            )


def reread(T_arm_flange: Floats, fault: Convention) -> Floats:
    """The poses (P, 4, 4) if the fault is undone."""
    poses = T_arm_flange
    if fault in ("scalar-first", "scalar-first-inverted"):
        poses = np.array([_scalar_first(T) for T in poses])
    if fault == "turns-inverted":
        poses = np.array([rigid(T[:3, :3].T, T[:3, 3]) for T in poses])
    if fault in ("inverted", "scalar-first-inverted"):
        poses = inverse(poses)
    return poses


def _scalar_first(T_arm_flange: Floats) -> Floats:
    """The pose whose quaternion was written with the scalar first."""
    from scipy.spatial.transform import Rotation  # slow to import; needed after a refusal only

    w, x, y, z = Rotation.from_matrix(T_arm_flange[:3, :3]).as_quat()
    return rigid(Rotation.from_quat([x, y, z, w]).as_matrix(), T_arm_flange[:3, 3])
