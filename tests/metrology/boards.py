"""Rendered chessboards crossed by a laser line, with the truth that made them.

The renderer shares nothing with the program: rays are cast at the board, colours looked up.
"""

from dataclasses import dataclass, field
from functools import cache

import cv2
import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from crenel.metrology.adjustment.board.calibrate import observe_board
from crenel.metrology.adjustment.board.problem import BoardInputs
from crenel.metrology.arm.kinematics import RobotArm, Tip
from crenel.metrology.targets.chessboard import Chessboard
from crenel.metrology.transforms import Floats, inverse, rigid
from tests.metrology.numerics import unit

SIZE = (640, 512)  # width, height
K = np.array([[1150.0, 0, 322.0], [0, 1150.0, 251.0], [0, 0, 1]])
K1 = -0.08
FINE = 2  # rays across a pixel
PRINTED_PX = 200
NORMAL, OFFSET_MM = unit([0.8, 0.1, 0.59]), 185.0
BOARD = Chessboard("rendered board", "", (7, 6), 10.0, 0.01, 0.05)
TIP = Tip(0.0, 0.0, 120.0, 6.0)
ROBOT = RobotArm("robot", "", TIP)
T_FLANGE_CAM = rigid(
    Rotation.from_rotvec([0.3, -0.2, 0.9]).as_matrix(), np.array([40.0, -25.0, 90.0])
)
T_ARM_OBJ = rigid(
    Rotation.from_rotvec([0.05, -0.08, 0.4]).as_matrix(), np.array([900.0, 150.0, 80.0])
)


@dataclass(frozen=True)
class Look:
    """What a picture is like."""

    laser: bool = True
    line_level: float = 400.0  # clipped at 255
    dark: float = 25.0
    bright: float = 110.0
    noise: float = 1.0
    blur_px: float = 1.0
    board: Chessboard = field(default=BOARD)
    normal: Floats = field(default_factory=lambda: NORMAL)
    offset_mm: float = OFFSET_MM


def camera_pose(tilt_deg: float, about_deg: float, turn_deg: float, away_mm: float) -> Floats:
    """``T_cam_obj`` (4, 4) of a camera that looks at the pattern's middle."""
    axis = np.array([np.cos(np.radians(about_deg)), np.sin(np.radians(about_deg)), 0.0])
    R = (
        Rotation.from_rotvec(np.radians(tilt_deg) * axis)
        * Rotation.from_rotvec([0, 0, np.radians(turn_deg)])
        * Rotation.from_rotvec([np.pi, 0, 0])
    ).as_matrix()
    return rigid(R, np.array([4.0, -2.0, away_mm]) - R @ np.array([30.0, 25.0, 0.0]))


POSES = tuple(
    camera_pose(tilt, about, turn, away)
    for tilt, about, turn, away in (
        (3, 60, 4, 230),
        (22, 10, 5, 240),
        (22, 100, -15, 225),
        (24, 190, 20, 235),
        (22, 280, -8, 245),
        (18, 45, 35, 215),
        (20, 225, -30, 250),
        (25, 330, 12, 228),
    )
)


def find_flange_pose(T_cam_obj: Floats) -> Floats:
    return T_ARM_OBJ @ inverse(T_cam_obj) @ inverse(T_FLANGE_CAM)


def picture(T_cam_obj: Floats, look: Look, seed: int = 0) -> NDArray[np.uint8]:
    """A grey picture (512, 640)."""
    rays = _rays()
    upright, origin = T_cam_obj[:3, 2], T_cam_obj[:3, 3]
    points = rays * ((upright @ origin) / (rays @ upright))[:, None]
    on = (points - origin) @ T_cam_obj[:3, :2] / look.board.square_mm
    columns, rows = look.board.inner_corners
    square = np.floor(on).astype(int)
    inside = (square >= -1).all(axis=1) & (square < [columns, rows]).all(axis=1)
    black = inside & (square.sum(axis=1) % 2 == 0)
    if look.board.markers is not None:
        black = inside & _is_marked_black(look.board, on)
    level = np.where(black, look.dark, look.bright)
    if look.laser:
        off = points @ look.normal - look.offset_mm
        level = level + look.line_level * np.exp(-0.5 * (off / 0.35) ** 2)
    image = level.reshape(SIZE[1], FINE, SIZE[0], FINE).mean(axis=(1, 3))
    image = cv2.GaussianBlur(image, (0, 0), look.blur_px)
    image += np.random.default_rng(seed).normal(0, look.noise, image.shape)
    return np.asarray(np.clip(np.round(image), 0, 255), dtype=np.uint8)


@cache
def _rays() -> Floats:
    """Directions (N, 3) of the rays of all pictures, ``FINE`` by ``FINE`` to the pixel."""
    v, u = np.mgrid[0 : SIZE[1] * FINE, 0 : SIZE[0] * FINE]
    uv = (np.column_stack([u.ravel(), v.ravel()]) + 0.5) / FINE - 0.5
    x, y = (uv[:, 0] - K[0, 2]) / K[0, 0], (uv[:, 1] - K[1, 2]) / K[1, 1]
    xu, yu = x.copy(), y.copy()
    for _ in range(8):
        radial = 1 + K1 * (xu**2 + yu**2)
        xu, yu = x / radial, y / radial
    return np.column_stack([xu, yu, np.ones(len(xu))])


def _is_marked_black(board: Chessboard, on: Floats) -> NDArray[np.bool_]:
    """What OpenCV prints of a ChArUco board at places (N, 2) in squares from the first corner."""
    printed, rows = _printed(board), board.inner_corners[1]
    u = np.floor((on[:, 0] + 1) * PRINTED_PX).clip(0, printed.shape[1] - 1).astype(int)
    v = np.floor((rows - on[:, 1]) * PRINTED_PX).clip(0, printed.shape[0] - 1).astype(int)
    return np.asarray(printed[v, u] < 128)


@cache
def _printed(board: Chessboard) -> NDArray[np.uint8]:
    """A ChArUco board as OpenCV prints it, ``PRINTED_PX`` to the square."""
    assert board.markers is not None
    columns, rows = board.inner_corners
    dictionary = cv2.aruco.getPredefinedDictionary(getattr(cv2.aruco, board.markers.dictionary))
    ids = board.markers.first_id + np.arange((columns + 1) * (rows + 1) // 2)
    made = cv2.aruco.CharucoBoard(
        (columns + 1, rows + 1), board.square_mm, board.markers.side_mm, dictionary, ids
    )
    made.setLegacyPattern(board.markers.legacy)
    size = ((columns + 1) * PRINTED_PX, (rows + 1) * PRINTED_PX)
    return np.asarray(made.generateImage(size), np.uint8)


def inputs(look: Look | None = None, robot_mm: float = 0.02) -> BoardInputs:
    """All poses, the robot's place off by ``robot_mm`` and its turns likewise."""
    look = look or Look()
    rng = np.random.default_rng(3)
    pictures = [picture(T, look, k) for k, T in enumerate(POSES)]
    seen = tuple(observe_board(k, look.board, one, None, "v") for k, one in enumerate(pictures, 1))
    flange = []
    for T in POSES:
        turn = Rotation.from_rotvec(rng.normal(0, robot_mm / 400, 3)).as_matrix()
        true = find_flange_pose(T)
        flange.append(rigid(true[:3, :3] @ turn, true[:3, 3] + rng.normal(0, robot_mm, 3)))
    return BoardInputs(ROBOT, look.board, seen, np.array(flange), SIZE)
