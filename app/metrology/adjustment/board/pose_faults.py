"""What the poses of another program are, if they do not agree with the pictures as they are given:
inverted, with their rotations in another convention, or those of the next pictures."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal, get_args

import numpy as np

from app.errors import OperationError
from app.messages.message import message, quantity
from app.metrology.adjustment.block.initial_guess import solve_pnp
from app.metrology.adjustment.board.initial_guess import (
    BoardObservation,
    board_camera,
    number_corners,
    refuse_other_size,
    size_by_motion,
)
from app.metrology.adjustment.board.misread_rotations import MisreadRotations, list_rereadings
from app.metrology.adjustment.board.problem import BoardInputs
from app.metrology.adjustment.core.arm_readings import flange_motion
from app.metrology.adjustment.core.hand_eye import (
    CONTRADICTS_MM,
    Mounting,
    mounting_by_motion,
)
from app.metrology.arm.kinematics import RobotArm
from app.metrology.robust import median
from app.metrology.sensor.camera import Camera
from app.metrology.targets.chessboard import Chessboard, corner_points
from app.metrology.transforms import Floats, inverse, rigid

PoseFault = Literal[
    "inverted", "scalar-first", "scalar-first-inverted", "turns-inverted", "before", "after",
    "rotations",
]  # fmt: skip
POSE_CODES = frozenset({"poses-contradict", "poses-reversed", "square-size", "board-ambiguous"})
"""Refusals whose cause may be one of these faults."""
FEWEST_PAIRS = 4
"""Poses that show a fault: any three agree with something."""
AGREES_MM = 5.0
"""Poses that are read rightly place the board this closely, by the median."""
NEARLY_ALL = 0.8
"""Share of the poses that then agree."""
CLOSER = 3.0
"""Another reading is right if more poses agree, and this many times as closely."""


@dataclass(frozen=True)
class OtherReading:
    """How many poses agree with the pictures, and how closely, if they are read otherwise.

    ``given_mm`` is their scatter as they are given, with squares of the size that suits them best.
    """

    fault: PoseFault
    agree: int
    apart_mm: float
    given_mm: float
    rotations: MisreadRotations | None = None
    """What the rotations were taken for, if the fault is in them."""


def explain_poses(inputs: BoardInputs, error: OperationError) -> OperationError:
    """The error with the fault of the poses that explains it, or the same error if none does.

    Args:
        inputs: as they were given.
        error: why they were refused.
    """
    other = find_other_reading(inputs) if error.code in POSE_CODES else None
    if other is None or other.apart_mm * CLOSER > other.given_mm:
        return error  # squares of another size explain it as well
    return _read_otherwise(inputs, other)


def refuse_misread_poses(inputs: BoardInputs, mounting: Mounting) -> None:
    """Refuses poses of which some agree with the pictures, if all do when they are read otherwise.

    Pictures that are only tilted about the middle of the board nearly agree with inverted poses.

    Args:
        inputs: as they were given.
        mounting: what they agree on.

    Raises:
        OperationError: ``poses-read-otherwise``.
    """
    apart_mm, agree = median(mounting.off_mm), int(np.sum(~mounting.contradicts))
    if agree == len(mounting.contradicts) and apart_mm < CONTRADICTS_MM:
        return
    other = find_other_reading(inputs)
    if other is not None and other.agree > agree and other.apart_mm * CLOSER < apart_mm:
        raise _read_otherwise(inputs, other)


def find_other_reading(inputs: BoardInputs) -> OtherReading | None:
    """The reading of the poses that agrees best with the pictures, if any other does."""
    T_arm_flange = flange_motion(inputs.arm, inputs.readings).T_arm_flange
    try:
        camera, _ = board_camera(inputs.observations, inputs.board, inputs.size_px)
    except OperationError:
        return None
    given = _mounting(inputs.observations, inputs.board, camera, T_arm_flange)
    given_mm = np.inf if given is None else size_by_motion(given).scatter_mm
    found: list[OtherReading] = []
    for fault, rotations, pictures, poses in _readings(inputs, camera, T_arm_flange):
        if rotations and any(one.rotations is None for one in found):
            break  # a simpler fault explains it
        seen = tuple(inputs.observations[p] for p in pictures)
        mounting = _agreement(seen, inputs.board, camera, poses)
        if mounting is not None:
            agree, apart_mm = int(np.sum(~mounting.contradicts)), median(mounting.off_mm)
            found.append(OtherReading(fault, agree, apart_mm, given_mm, rotations))
    return min(found, key=lambda other: other.apart_mm, default=None)


def _readings(
    inputs: BoardInputs, camera: Camera, T_arm_flange: Floats
) -> Iterator[tuple[PoseFault, MisreadRotations | None, list[int], Floats]]:
    """Each other reading, with the pictures that then have a pose, and these poses."""
    for fault in get_args(PoseFault):
        if fault == "rotations":
            continue
        if isinstance(inputs.arm, RobotArm) or fault in ("before", "after"):
            yield fault, None, *reread(T_arm_flange, fault)
    if isinstance(inputs.arm, RobotArm):
        turns = _board_turns(inputs, camera)
        for rotations, poses in list_rereadings(T_arm_flange, turns):
            yield "rotations", rotations, list(range(len(poses))), poses


def _board_turns(inputs: BoardInputs, camera: Camera) -> Floats | None:
    """(P, 3, 3) rotations of the board before the camera; None where its corners could be numbered
    in several ways."""
    seen = [one.detection for one in inputs.observations]
    if any(one.other_numbers for one in seen):
        return None
    points = corner_points(inputs.board)
    return np.array([solve_pnp(camera, points[one.number], one.uv_px)[:3, :3] for one in seen])


def _read_otherwise(inputs: BoardInputs, other: OtherReading) -> OperationError:
    rotations = other.rotations or MisreadRotations("", "")
    return OperationError(
        "poses-read-otherwise",
        message(
            "poses-agree-read-otherwise",
            name=inputs.board.name,
            fault=other.fault,
            agree=other.agree,
            count=len(inputs.observations),
            apart=quantity(other.apart_mm, "mm", 1),
            right=rotations.right,
        ),
        message("so-poses-are-not-what-is-expected", fault=other.fault, given=rotations.given),
        message(
            "convert-poses-read-otherwise",
            fault=other.fault,
            controllers=", ".join(rotations.controllers),
        ),
    )


def reread(T_arm_flange: Floats, fault: PoseFault) -> tuple[list[int], Floats]:
    """The pictures (K of P) that have a pose if the fault is undone, and these poses.

    Args:
        T_arm_flange: (P, 4, 4) as given.
    """
    count = len(T_arm_flange)
    if fault == "before":
        return list(range(1, count)), T_arm_flange[:-1]
    if fault == "after":
        return list(range(count - 1)), T_arm_flange[1:]
    poses = T_arm_flange
    if fault in ("scalar-first", "scalar-first-inverted"):
        poses = np.array([_scalar_first(T) for T in poses])
    if fault == "turns-inverted":
        poses = np.array([rigid(T[:3, :3].T, T[:3, 3]) for T in poses])
    if fault in ("inverted", "scalar-first-inverted"):
        poses = inverse(poses)
    return list(range(count)), poses


def _scalar_first(T_arm_flange: Floats) -> Floats:
    """The pose whose quaternion was written with the scalar first."""
    from scipy.spatial.transform import Rotation  # slow to import; needed after a refusal only

    w, x, y, z = Rotation.from_matrix(T_arm_flange[:3, :3]).as_quat()
    return rigid(Rotation.from_quat([x, y, z, w]).as_matrix(), T_arm_flange[:3, 3])


def _agreement(
    seen: tuple[BoardObservation, ...], board: Chessboard, camera: Camera, T_arm_flange: Floats
) -> Mounting | None:
    """The mounting by these poses (P, 4, 4), if nearly all agree with the pictures."""
    if len(seen) < FEWEST_PAIRS:
        return None
    mounting = _mounting(seen, board, camera, T_arm_flange)
    if mounting is None or median(mounting.off_mm) > AGREES_MM:
        return None
    if np.sum(~mounting.contradicts) < NEARLY_ALL * len(seen):
        return None
    try:
        refuse_other_size(mounting, board)
    except OperationError:
        return None
    return mounting


def _mounting(
    seen: tuple[BoardObservation, ...], board: Chessboard, camera: Camera, T_arm_flange: Floats
) -> Mounting | None:
    """The mounting by these poses (P, 4, 4); None if they do not even number the corners."""
    points = corner_points(board)
    try:
        numbered = number_corners(seen, board, camera, T_arm_flange)
        kept = [p for p, one in enumerate(numbered) if isinstance(one, BoardObservation)]
        boards = [one.detection for one in numbered if isinstance(one, BoardObservation)]
        T_cam_obj = np.array([solve_pnp(camera, points[one.number], one.uv_px) for one in boards])
        return mounting_by_motion(T_arm_flange[kept], T_cam_obj, board.size_mm)
    except OperationError:
        return None
