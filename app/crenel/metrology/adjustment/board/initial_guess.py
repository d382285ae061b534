"""Start values for the chessboard's adjustment: the camera, the corner numbering of each picture,
and whether the arm's motion agrees with the size of the squares."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import cv2
import numpy as np

from crenel.errors import OperationError
from crenel.messages.message import message, quantity, rounded
from crenel.metrology.adjustment.block.initial_guess import solve_pnp
from crenel.metrology.adjustment.core.hand_eye import Mounting
from crenel.metrology.adjustment.core.observations import FailedPose
from crenel.metrology.chessboard.board_detection import BoardDetection
from crenel.metrology.detection.image_quality import ImageFinding
from crenel.metrology.sensor.camera import Camera
from crenel.metrology.stripe import Stripe
from crenel.metrology.targets.chessboard import Chessboard, corner_points
from crenel.metrology.transforms import Floats, inverse, vector_from_rotation
from crenel.units import mistaken_unit

FEWEST_POSES = 3
# Pictures of a flat board determine the focal length only if the board is tilted by at least this.
LEAST_TILT_DEG = 5.0
# Deviation of the arm's motion from the square size that is refused: relative, and in standard
# deviations.
SIZE_SHARE, SIZE_SIGMAS = 0.03, 5.0
# A ratio this far from that of two units is of no unit.
UNIT_SHARE = 0.2
# Agreement of the rotation angles of board and flange if a numbering is correct.
TURN_DEG = 3.0


@dataclass(frozen=True)
class BoardObservation:
    """The detection in the picture of one pose, by itself.

    The stripe is empty if no picture of the pose shows the laser's line; ``laser_error`` says why
    its laser picture could not be read. With ``two_lines``, the stripe may jump between two.
    """

    number: int
    detection: BoardDetection
    stripe: Stripe
    image_findings: tuple[ImageFinding, ...] = ()
    laser_error: OperationError | None = None
    two_lines: bool = False

    @property
    def fingerprint(self) -> bytes:
        """Equal for pictures with the same pixels, and for these alone."""
        return self.detection.uv_px.tobytes()


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
            message("flat-board-one-direction-does-not-tell-focal-length"),
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
) -> tuple[BoardObservation | FailedPose, ...]:
    """Numbers the corners of all pictures alike, if colours alone are ambiguous.

    The board must turn relative to the camera by as much as the flange turns. The first picture
    to which most others can be compared gives the numbering, and these number the others; those
    that they cannot number are left out.

    Raises:
        OperationError: the poses of the arm do not decide the numbering of most either.
    """
    if not any(pose.detection.other_numbers for pose in seen):
        return tuple(seen)
    points = corner_points(board)
    ways = [(pose.detection.number, *pose.detection.other_numbers) for pose in seen]
    T_cam_obj = [
        np.array([solve_pnp(camera, points[number], pose.detection.uv_px) for number in numbers])
        for pose, numbers in zip(seen, ways, strict=True)
    ]
    error: OperationError | None = None
    for first in range(len(seen)):
        chosen = [
            _choose_numbering(T_cam_obj[first][0], here, T_arm_flange[first], T_arm_flange[p])
            if p != first
            else 0
            for p, here in enumerate(T_cam_obj)
        ]
        undecided = [p for p, way in enumerate(chosen) if way is None]
        if 2 * len(undecided) < len(seen):
            chosen = _number_by_all(T_cam_obj, T_arm_flange, chosen)
            return tuple(
                FailedPose(pose.number, _ambiguous(pose, board))
                if way is None
                else replace(pose, detection=replace(pose.detection, number=numbers[way]))
                for pose, numbers, way in zip(seen, ways, chosen, strict=True)
            )
        error = error or _ambiguous(seen[undecided[0]], board)
    assert error is not None
    raise error


def _choose_numbering(
    first: Floats, ways: Floats, T_first: Floats, T_arm_flange: Floats
) -> int | None:
    """Which of the board's poses (W, 4, 4) agrees with the flange's turn since the first picture;
    None where none does, or another one nearly does."""
    turns = np.concatenate([(inverse(T_first) @ T_arm_flange)[None], first @ inverse(ways)])
    angles = np.degrees(np.linalg.norm(vector_from_rotation(turns[:, :3, :3]), axis=1))
    off = np.abs(angles[1:] - angles[0])
    best = int(np.argmin(off))
    rival = np.delete(off, best).min(initial=np.inf)
    return None if off[best] > TURN_DEG or rival < 2 * TURN_DEG else best


def _number_by_all(
    T_cam_obj: Sequence[Floats], T_arm_flange: Floats, chosen: Sequence[int | None]
) -> list[int | None]:
    """The numbering (P,) also of those pictures that turn by as much either way since the first:
    the one that most of the numbered pictures agree with."""
    numbered = [(p, T_cam_obj[p][way]) for p, way in enumerate(chosen) if way is not None]
    result = list(chosen)
    for p, way in enumerate(chosen):
        if way is None:
            votes = [
                _choose_numbering(T, T_cam_obj[p], T_arm_flange[q], T_arm_flange[p])
                for q, T in numbered
            ]
            ways = range(len(T_cam_obj[p]))
            result[p] = next((w for w in ways if 2 * votes.count(w) > len(votes)), None)
    return result


def _ambiguous(pose: BoardObservation, board: Chessboard) -> OperationError:
    return OperationError(
        "board-ambiguous",
        message("pose-looks-same-turned-round", number=pose.number, name=board.name),
        message("neither-colours-nor-arms-poses-tell"),
        message("use-board-even-odd-count-inner"),
    )


@dataclass(frozen=True)
class SizeByMotion:
    """The size of the squares by the arm's motion over that of the certificate, its standard
    deviation, and the scatter (mm) of the poses with this size."""

    scale: float
    scale_sd: float
    scatter_mm: float


def size_by_motion(mounting: Mounting) -> SizeByMotion:
    """The size of the squares on which arm and pictures agree best.

    With known rotations, the translations and a common scale of all distances follow linearly.
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
    return SizeByMotion(float(found[6]), sd, float(np.sqrt(variance)))


def refuse_other_size(mounting: Mounting, board: Chessboard) -> None:
    """Refuses squares whose size clearly differs from the arm's motion.

    Raises:
        OperationError: ``square-size``, or poses that contradict each other.
    """
    size = size_by_motion(mounting)
    if size.scale <= 0:
        raise OperationError(
            "poses-reversed",
            message("arms-motion-moves-other-way-than", name=board.name),
            message("no-size-squares-makes-them-agree"),
            message("check-pictures-not-mirrored-poses-of-flange"),
        )
    off = max(SIZE_SHARE, SIZE_SIGMAS * size.scale_sd / size.scale)
    if unit := mistaken_unit(1 / size.scale, min(off, UNIT_SHARE)):
        raise OperationError(
            "poses-in-other-unit",
            message("poses-move-too-little", ratio=quantity(1 / size.scale, "", 1)),
            message("lengths-of-unit-expected-mm", unit=unit),
            message("convert-columns-x-mm-y-mm"),
        )
    unit = mistaken_unit(size.scale, min(off, UNIT_SHARE))
    if unit or abs(size.scale - 1) > max(SIZE_SHARE, SIZE_SIGMAS * size.scale_sd):
        why = message("certificate-says", square=rounded(board.square_mm, "mm"))
        remedy = message("measure-squares-correct-certificate-check-every")
        if unit:
            why = message("lengths-of-unit-expected-mm", unit=unit)
            remedy = message("give-square-in-mm")
        width = quantity(size.scale * board.square_mm, "mm", 2)
        raise OperationError(
            "square-size",
            message("arms-motion-squares-wide", name=board.name, width=width),
            why,
            remedy,
        )
