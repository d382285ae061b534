"""Computes which pose would help most next."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from crenel.errors import OperationError
from crenel.formats.session.calibration_session import BlockSession, BoardSession, read_any_session
from crenel.guide.calibration.poses.advice import (
    ENOUGH_OF_A_BOARD,
    ENOUGH_POSES,
    FEWEST_OF_A_BOARD,
    FEWEST_POSES,
    Advice,
)
from crenel.guide.calibration.session_folder import SessionFolder
from crenel.metrology.adjustment.block.calibrate import calibrate_block
from crenel.metrology.adjustment.board.calibrate import calibrate_board
from crenel.metrology.adjustment.core.gauss_newton import AdjustmentResult
from crenel.metrology.adjustment.core.parameters import pose_scene
from crenel.metrology.adjustment.planning.next_pose import PoseAdvice, next_poses, pose_delta
from crenel.metrology.arm.kinematics import AnyArm
from crenel.metrology.limits import Limits
from crenel.metrology.targets.chessboard import Chessboard
from crenel.metrology.targets.target import CalibrationTarget
from crenel.metrology.transforms import Floats, inverse, rigid, vector_from_rotation
from crenel.workflows.calibrate import AnyDetection, board_inputs, joint_inputs

# Of advices that bring nearly as much, the one that asks for the least movement.
NEARLY = 1.06


@dataclass(frozen=True)
class _SoFar:
    """What the poses so far lead to."""

    arm: AnyArm
    item: CalibrationTarget
    adjusted: AdjustmentResult
    total_um: float  # of a scanned point, k = 1
    readings: Floats  # (P, ...) of the poses that were used


def advise(
    folder: SessionFolder, known: Mapping[int, AnyDetection | OperationError], limits: Limits
) -> Advice | None:
    """The pose that would help most after those taken; None where there is none.

    Raises:
        OperationError: no calibration follows from the poses so far.
    """
    so_far = _so_far(read_any_session(folder.path), known, limits)
    found, state = so_far.adjusted, so_far.adjusted.state
    best = _choose_pose(so_far)
    if best is None:
        return None
    on_board = isinstance(so_far.item, Chessboard)
    return Advice(
        poses=len(found.problem.views),
        now_um=so_far.total_um,
        then_um=best.total_um,
        words=pose_delta(best.T_obj_cam, _newest(found), so_far.item).words,
        outline=[(*a, *b) for a, b in best.outline_px],
        reading=best.reading.tolist(),
        T_obj_cam=best.T_obj_cam.tolist(),
        T_arm_obj=state.T_arm_obj.tolist(),
        T_flange_cam=state.T_flange_cam.tolist(),
        fewest=FEWEST_OF_A_BOARD if on_board else FEWEST_POSES,
        enough=ENOUGH_OF_A_BOARD if on_board else ENOUGH_POSES,
    )


def _so_far(
    session: BlockSession | BoardSession,
    known: Mapping[int, AnyDetection | OperationError],
    limits: Limits,
) -> _SoFar:
    if isinstance(session, BoardSession):
        of_board = board_inputs(session, limits, known=known)
        on_board = calibrate_board(of_board)
        numbers = [pose.number for pose in of_board.observations]
        used = _select_used(numbers, of_board.readings, on_board.adjustment)
        return _SoFar(
            of_board.arm, of_board.board, on_board.adjustment, on_board.uncertainty.total_um, used
        )
    of_block = joint_inputs(session, limits, known=known)
    on_block = calibrate_block(of_block)
    numbers = [pose.number for pose in of_block.observations]
    used = _select_used(numbers, of_block.q_rad, on_block.adjustment)
    return _SoFar(
        of_block.arm, of_block.block, on_block.adjustment, on_block.uncertainty.total_um, used
    )


def _select_used(numbers: list[int], readings: Floats, found: AdjustmentResult) -> Floats:
    used = set(found.problem.numbers)
    return np.asarray(readings[[i for i, number in enumerate(numbers) if number in used]])


def _choose_pose(so_far: _SoFar) -> PoseAdvice | None:
    offered = next_poses(so_far.adjusted, so_far.arm, so_far.item, so_far.readings)
    if not offered:
        return None
    newest = _newest(so_far.adjusted)
    good = [one for one in offered if one.total_um <= NEARLY * offered[0].total_um]
    return min(good, key=lambda one: _rotation_angle_rad(one.T_obj_cam, newest))


def _newest(found: AdjustmentResult) -> Floats:
    """``T_obj_cam`` (4, 4) of the pose that was taken last."""
    last = len(found.problem.views) - 1
    camera = pose_scene(found.state, found.problem, found.layout, last).camera
    return inverse(rigid(camera.rotation, camera.translation_mm))


def _rotation_angle_rad(T_a: Floats, T_b: Floats) -> float:
    return float(np.linalg.norm(vector_from_rotation(T_a[:3, :3] @ T_b[:3, :3].T)))
