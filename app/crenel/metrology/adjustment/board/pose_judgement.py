"""Which poses contradict the others, by what the others can predict of them."""

from dataclasses import replace

import numpy as np

from crenel.metrology.adjustment.board.bundle import Bundle
from crenel.metrology.adjustment.core.hand_eye import Mounting, pose_offsets_mm
from crenel.metrology.adjustment.core.robot_noise import (
    PosePairs,
    RobotNoise,
    estimate_robot_noise,
    find_predicted_pose,
    find_robot_outlier,
)
from crenel.metrology.targets.chessboard import Chessboard, pattern_centre


def readmit_predicted_poses(found: Bundle, mounting: Mounting, board: Chessboard) -> Mounting:
    """The mounting with those poses again that contradict the others by no more than these can
    predict of them."""
    every = _pose_pairs(found, mounting, board)
    contradicts = mounting.contradicts
    start = mounting.T_flange_cam, mounting.T_arm_obj
    while (pose := find_predicted_pose(every, ~contradicts, *start)) is not None:
        contradicts = contradicts.copy()
        contradicts[pose] = False
        estimate = estimate_robot_noise(every.select(np.flatnonzero(~contradicts)), *start)
        start = estimate.X, estimate.Z
    if contradicts is mounting.contradicts:
        return mounting
    off_mm = pose_offsets_mm(every.T_arm_flange, every.T_cam_obj, *start, board.size_mm)
    return replace(
        mounting,
        T_flange_cam=start[0],
        T_arm_obj=start[1],
        off_mm=off_mm,
        contradicts=contradicts,
    )


def _pose_pairs(found: Bundle, mounting: Mounting, board: Chessboard) -> PosePairs:
    return PosePairs(
        mounting.T_arm_flange, mounting.T_cam_obj, found.covariance, pattern_centre(board)
    )


def judge_robot_poses(
    found: Bundle, mounting: Mounting, board: Chessboard
) -> tuple[Mounting, RobotNoise]:
    """The noise of a robot, estimated without poses that contradict; outliers are marked as
    such."""
    start = mounting.T_flange_cam, mounting.T_arm_obj
    every = _pose_pairs(found, mounting, board)
    while True:
        agree = np.flatnonzero(~mounting.contradicts)
        seen = every.select(agree)
        estimate = estimate_robot_noise(seen, *start)
        outlier = find_robot_outlier(seen, estimate)
        if outlier is None or 2 * (len(agree) - 1) <= len(mounting.contradicts):
            return mounting, estimate.noise
        contradicts = mounting.contradicts.copy()
        contradicts[agree[outlier]] = True
        mounting = replace(mounting, contradicts=contradicts)
