"""OpenCV's ways to find where a camera sits on a flange."""

from collections.abc import Iterator, Sequence

import cv2
import numpy as np

from crenel.metrology.transforms import Floats, inverse, rigid

HAND_EYE = ("Tsai", "Park", "Horaud", "Andreff", "Daniilidis")
ROBOT_WORLD = ("Shah", "Li")
# calibrateCamera with the first radial term alone.
K1_ONLY = cv2.CALIB_FIX_K2 | cv2.CALIB_FIX_K3 | cv2.CALIB_ZERO_TANGENT_DIST


def hand_eye_methods(
    T_arm_flange: Sequence[Floats], T_cam_obj: Sequence[Floats]
) -> Iterator[tuple[str, Floats]]:
    """``T_flange_cam`` (4, 4) by every method of OpenCV, with its name."""
    R, t = [T[:3, :3] for T in T_arm_flange], [T[:3, 3] for T in T_arm_flange]
    board_R, board_t = [T[:3, :3] for T in T_cam_obj], [T[:3, 3] for T in T_cam_obj]
    for name in HAND_EYE:
        method = getattr(cv2, f"CALIB_HAND_EYE_{name.upper()}")
        turn, shift = cv2.calibrateHandEye(R, t, board_R, board_t, method=method)
        yield name, rigid(np.asarray(turn, np.float64), np.ravel(shift))
    back = [inverse(T) for T in T_arm_flange]
    back_R, back_t = [T[:3, :3] for T in back], [T[:3, 3] for T in back]
    for name in ROBOT_WORLD:
        method = getattr(cv2, f"CALIB_ROBOT_WORLD_HAND_EYE_{name.upper()}")
        _, _, turn, shift = cv2.calibrateRobotWorldHandEye(
            board_R, board_t, back_R, back_t, method=method
        )
        yield name, inverse(rigid(np.asarray(turn, np.float64), np.ravel(shift)))
