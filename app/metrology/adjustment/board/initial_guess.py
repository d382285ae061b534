"""Start values for the chessboard's adjustment: the camera, the corner numbering of each picture,
and whether the arm's motion agrees with the size of the squares."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import cv2
import numpy as np

from app.errors import OperationError
from app.messages.message import message, quantity, rounded
from app.metrology.adjustment.block.initial_guess import solve_pnp
from app.metrology.adjustment.core.hand_eye import Mounting
from app.metrology.chessboard.detect_board import BoardDetection
from app.metrology.detection.image_quality import ImageFinding
from app.metrology.sensor.camera import Camera
from app.metrology.stripe import Stripe
from app.metrology.targets.chessboard import Chessboard, corner_points
from app.metrology.transforms import Floats, inverse, vector_from_rotation

FEWEST_POSES = 3
# Pictures of a flat board determine the focal length only if the board is tilted by at least this.
LEAST_TILT_DEG = 5.0
# Deviation of the arm's motion from the square size that is refused: relative, and in standard
# deviations.
SIZE_SHARE, SIZE_SIGMAS = 0.03, 5.0
# Agreement of the rotation angles of board and flange if a numbering is correct.
TURN_DEG = 3.0


@dataclass(frozen=True)
class BoardObservation:
    """The detection in the picture of one pose, by itself."""

    number: int
    detection: BoardDetection
    stripe: Stripe
    image_findings: tuple[ImageFinding, ...] = ()


def board_camera(
    seen: Sequence[BoardObservation], board: Chessboard, size_px: tuple[int, int]
) -> tuple[Camera, Floats]:
    """The camera (its own frame as sensor frame), and ``T_cam_obj`` (P, 4, 4).

    Raises:
        OperationError: too few pictures, or all taken from straight above.
    """
    if len(seen) < FEWEST_POSES:
        raise OperationError(
            "too-few-images",
            message("pictures-show", seen=len(seen), name=board.name),
            message("flat-board-tells-cameras-focal-length", fewest_poses=FEWEST_POSES),
            message("take-more-pictures-8-more-them"),
        )
    points = corner_points(board)
    K, distortion = _calibrate_camera(seen, points, size_px)
    camera = Camera(K, np.eye(3), np.zeros(3), *size_px, distortion)
    T = np.array(
        [solve_pnp(camera, points[pose.detection.number], pose.detection.uv_px) for pose in seen]
    )
    normals = T[:, :3, 2]
    apart = np.degrees(np.arccos(np.clip(np.abs(normals @ normals.T), 0, 1)))
    if apart.max() < LEAST_TILT_DEG:
        raise OperationError(
            "boards-parallel",
            message(
                "board-tilted-most-between-pictures",
                tilt=quantity(apart.max(), "°", 1),
                seen=len(seen),
            ),
            message("pictures-flat-board-one-direction-do"),
            message("take-pictures-tilted-20-more-two"),
        )
    return camera, T


def _calibrate_camera(
    seen: Sequence[BoardObservation], points: Floats, size_px: tuple[int, int]
) -> tuple[Floats, Floats]:
    """Camera matrix (3, 3) and distortion (5,), of which only k1 is estimated."""
    flags = (
        cv2.CALIB_FIX_K2
        | cv2.CALIB_FIX_K3
        | cv2.CALIB_ZERO_TANGENT_DIST
        | cv2.CALIB_FIX_ASPECT_RATIO
        | cv2.CALIB_USE_INTRINSIC_GUESS
    )
    middle = (np.array(size_px) - 1) / 2
    guess = np.array([[size_px[0], 0, middle[0]], [0, size_px[0], middle[1]], [0, 0, 1.0]])
    object_points = [points[pose.detection.number].astype(np.float32) for pose in seen]
    pixels = [pose.detection.uv_px.astype(np.float32).reshape(-1, 1, 2) for pose in seen]
    guess[:2, :2] = cv2.initCameraMatrix2D(object_points, pixels, size_px, 1.0)[:2, :2]
    found = cv2.calibrateCamera(object_points, pixels, size_px, guess, np.zeros(5), flags=flags)
    return np.asarray(found[1], np.float64), np.asarray(found[2], np.float64).ravel()[:5]


def number_corners(
    seen: Sequence[BoardObservation], board: Chessboard, camera: Camera, T_arm_flange: Floats
) -> tuple[BoardObservation, ...]:
    """Numbers the corners of each picture like those of the first, if colours alone are ambiguous.

    The board must turn relative to the camera by as much as the flange turns.

    Raises:
        OperationError: the poses of the arm do not decide the numbering either.
    """
    if not any(pose.detection.other_numbers for pose in seen):
        return tuple(seen)
    points = corner_points(board)
    chosen = [seen[0]]
    first = solve_pnp(camera, points[seen[0].detection.number], seen[0].detection.uv_px)
    for pose, T in zip(seen[1:], T_arm_flange[1:], strict=True):
        wanted = _angle_deg(inverse(T_arm_flange[0]) @ T)
        ways = (pose.detection.number, *pose.detection.other_numbers)
        off = []
        for number in ways:
            here = solve_pnp(camera, points[number], pose.detection.uv_px)
            off.append(abs(_angle_deg(first @ inverse(here)) - wanted))
        order = np.argsort(off)
        if off[order[0]] > TURN_DEG or off[order[1]] < 2 * TURN_DEG:
            raise OperationError(
                "board-ambiguous",
                message("pose-looks-same-turned-round", number=pose.number, name=board.name),
                message("neither-colours-nor-arms-poses-tell"),
                message("use-board-even-odd-count-inner"),
            )
        detection = replace(pose.detection, number=ways[order[0]])
        chosen.append(replace(pose, detection=detection))
    return tuple(chosen)


def _angle_deg(T: Floats) -> float:
    return float(np.degrees(np.linalg.norm(vector_from_rotation(T[:3, :3]))))


def refuse_other_size(mounting: Mounting, board: Chessboard) -> None:
    """Refuses squares whose size clearly differs from the arm's motion.

    With known rotations, the translations and a common scale of all distances follow linearly.

    Raises:
        OperationError: ``square-size``, or poses that contradict each other.
    """
    kept = np.flatnonzero(~mounting.contradicts)
    # one wrong size makes all poses contradict each other, so all of them are used
    kept = kept if len(kept) >= FEWEST_POSES else np.arange(len(mounting.off_mm))
    A, B = mounting.T_arm_flange[kept], mounting.T_cam_obj[kept]
    turn = mounting.T_flange_cam[:3, :3]
    rows = np.concatenate(
        [
            np.column_stack([a[:3, :3], -np.eye(3), a[:3, :3] @ turn @ b[:3, 3]])
            for a, b in zip(A, B, strict=True)
        ]
    )
    right = -A[:, :3, 3].ravel()
    found = np.linalg.lstsq(rows, right, rcond=None)[0]
    left = rows @ found - right
    variance = float(left @ left) / max(len(right) - 7, 1)
    sd = float(np.sqrt(variance * np.linalg.pinv(rows.T @ rows)[6, 6]))
    scale = float(found[6])
    if scale <= 0:
        raise OperationError(
            "poses-reversed",
            message("arms-motion-moves-other-way-than", name=board.name),
            message("no-size-squares-makes-them-agree"),
            message("check-pictures-mirrored-poses-those-flange"),
        )
    if abs(scale - 1) > max(SIZE_SHARE, SIZE_SIGMAS * sd):
        raise OperationError(
            "square-size",
            message(
                "arms-motion-squares-wide",
                name=board.name,
                width=quantity(scale * board.square_mm, "mm", 2),
            ),
            message("certificate-says", square=rounded(board.square_mm, "mm")),
            message("measure-squares-correct-certificate-check-every"),
        )
