"""OpenCV's ways to find where a camera sits on a flange."""

from collections.abc import Iterator, Sequence

import cv2
import numpy as np

from app.metrology.transforms import Floats, inverse, rigid

HAND_EYE = {
    "Tsai": cv2.CALIB_HAND_EYE_TSAI,
    "Park": cv2.CALIB_HAND_EYE_PARK,
    "Horaud": cv2.CALIB_HAND_EYE_HORAUD,
    "Andreff": cv2.CALIB_HAND_EYE_ANDREFF,
    "Daniilidis": cv2.CALIB_HAND_EYE_DANIILIDIS,
}
ROBOT_WORLD = {
    "Shah": cv2.CALIB_ROBOT_WORLD_HAND_EYE_SHAH,
    "Li": cv2.CALIB_ROBOT_WORLD_HAND_EYE_LI,
}
# calibrateCamera with the first radial term alone.
K1_ONLY = cv2.CALIB_FIX_K2 | cv2.CALIB_FIX_K3 | cv2.CALIB_ZERO_TANGENT_DIST


def hand_eye_methods(
    T_arm_flange: Sequence[Floats], T_cam_obj: Sequence[Floats]
) -> Iterator[tuple[str, Floats]]:
    """``T_flange_cam`` (4, 4) by every method of OpenCV, with its name."""
    R, t = [T[:3, :3] for T in T_arm_flange], [T[:3, 3] for T in T_arm_flange]
    board_R, board_t = [T[:3, :3] for T in T_cam_obj], [T[:3, 3] for T in T_cam_obj]
    for name, method in HAND_EYE.items():
        turn, shift = cv2.calibrateHandEye(R, t, board_R, board_t, method=method)
        yield name, rigid(np.asarray(turn, np.float64), np.ravel(shift))
    back = [inverse(T) for T in T_arm_flange]
    back_R, back_t = [T[:3, :3] for T in back], [T[:3, 3] for T in back]
    for name, method in ROBOT_WORLD.items():
        _, _, turn, shift = cv2.calibrateRobotWorldHandEye(
            board_R, board_t, back_R, back_t, method=method
        )
        yield name, inverse(rigid(np.asarray(turn, np.float64), np.ravel(shift)))
