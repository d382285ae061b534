"""Sessions of a robot before a board, simulated at the level of corners and line points."""

from dataclasses import dataclass, field

import numpy as np
from scipy.spatial.transform import Rotation

from crenel.metrology.adjustment.board.initial_guess import BoardObservation
from crenel.metrology.adjustment.board.problem import BoardInputs
from crenel.metrology.arm.kinematics import RobotArm
from crenel.metrology.chessboard.board_detection import BoardDetection
from crenel.metrology.stripe import Stripe
from crenel.metrology.targets.chessboard import Chessboard, corner_points
from crenel.metrology.transforms import Floats, apply, inverse, rigid, rotation_from_vector
from tests.metrology.numerics import unit

SIZE_PX = (1280, 1024)
LINE_POINTS = 120


@dataclass(frozen=True)
class SessionPlan:
    """What is drawn of a session; tilts (P,) of the views in degrees."""

    tilts_deg: Floats
    shift_mm: float
    """Standard deviation of the robot's position along each axis."""
    turn_rad: float
    corners_px: float = 0.1
    inner_corners: tuple[int, int] = (9, 6)
    square_mm: float = 10.0


@dataclass(frozen=True)
class DrawnSession:
    """P pictures, and the true poses (P, 4, 4)."""

    inputs: BoardInputs
    T_arm_flange: Floats
    T_flange_cam: Floats
    T_arm_obj: Floats
    rng: np.random.Generator = field(repr=False)


def draw_session(plan: SessionPlan, rng: np.random.Generator) -> DrawnSession:
    """The true session with the robot's noise in its readings."""
    board = Chessboard("board", "B-1", plan.inner_corners, plan.square_mm, 0.02, 0.05)
    focal_px = rng.uniform(1500, 2600)
    centre = np.array(SIZE_PX) / 2 + rng.normal(0, 10, 2)
    k1 = rng.uniform(-0.1, 0.1)
    away_mm = board.size_mm * focal_px / rng.uniform(600, 850)
    lean = unit([rng.uniform(0.5, 0.9), rng.uniform(-0.2, 0.2), 0.6])
    laser = lean, away_mm * lean[2] + rng.uniform(-2, 2)
    T_flange_cam = _any_pose(rng, 100.0)
    T_arm_obj = _any_pose(rng, 600.0)
    observations, flange = [], []
    for number, tilt_deg in enumerate(plan.tilts_deg):
        T_cam_obj = _view(board, float(tilt_deg), away_mm, rng)
        flange.append(T_arm_obj @ inverse(T_cam_obj) @ inverse(T_flange_cam))
        points = apply(T_cam_obj, corner_points(board))
        uv = _project(points, focal_px, centre, k1)
        uv = uv + rng.normal(0, plan.corners_px, uv.shape)
        detection = _detection(board, uv, plan.corners_px)
        line = _project(_laser_line(board, T_cam_obj, *laser), focal_px, centre, k1)
        line = line + rng.normal(0, 0.05, line.shape) * np.array([1.0, 0.0])
        stripe = Stripe(
            line[:, 0], line[:, 1], np.full(len(line), 150.0), np.full(len(line), 0.05), "v"
        )
        observations.append(BoardObservation(number, detection, stripe))
    true = np.array(flange)
    inputs = BoardInputs(
        RobotArm("Robot", "R-1"), board, tuple(observations), with_noise(true, plan, rng), SIZE_PX
    )
    return DrawnSession(inputs, true, T_flange_cam, T_arm_obj, rng)


def with_noise(T_arm_flange: Floats, plan: SessionPlan, rng: np.random.Generator) -> Floats:
    """(P, 4, 4) as the robot states its poses."""
    return np.array(
        [
            moved(T, rng.normal(0, plan.turn_rad, 3), rng.normal(0, plan.shift_mm, 3))
            for T in T_arm_flange
        ]
    )


def moved(T: Floats, turn: Floats, shift_mm: Floats) -> Floats:
    """A pose (4, 4) turned about its own axes by a vector (rad), and shifted."""
    return rigid(T[:3, :3] @ rotation_from_vector(turn), T[:3, 3] + shift_mm)


def _any_pose(rng: np.random.Generator, reach_mm: float) -> Floats:
    return rigid(Rotation.random(random_state=rng).as_matrix(), rng.uniform(-1, 1, 3) * reach_mm)


def _view(board: Chessboard, tilt_deg: float, away_mm: float, rng: np.random.Generator) -> Floats:
    """``T_cam_obj`` (4, 4) of a camera that looks at the middle of the board, about upright."""
    about = rng.uniform(0, 2 * np.pi)
    R = (
        Rotation.from_rotvec(np.radians(tilt_deg) * np.array([np.cos(about), np.sin(about), 0]))
        * Rotation.from_rotvec([0, 0, rng.normal(0, 0.35)])
        * Rotation.from_rotvec([np.pi, 0, 0])
    ).as_matrix()
    middle = np.append(board.extent_mm / 2, 0.0)
    offset = rng.normal(0, 0.02 * away_mm, 3)
    return rigid(R, np.array([0, 0, away_mm]) + offset - R @ middle)


def _project(points: Floats, focal_px: float, centre: Floats, k1: float) -> Floats:
    xy = points[:, :2] / points[:, 2:]
    bent = xy * (1 + k1 * np.sum(xy**2, axis=1, keepdims=True))
    return np.asarray(focal_px * bent + centre)


def _detection(board: Chessboard, uv: Floats, sd_px: float) -> BoardDetection:
    """With the board turned round as other numbering where its colours allow it."""
    columns, rows = board.inner_corners
    number = np.arange(columns * rows)
    turned = (number[::-1].copy(),) if (columns + rows) % 2 == 0 else ()
    return BoardDetection(uv, np.tile(sd_px**2 * np.eye(2), (len(uv), 1, 1)), number, turned)


def _laser_line(board: Chessboard, T_cam_obj: Floats, normal: Floats, offset_mm: float) -> Floats:
    """(N, 3) points of the board's plane on the laser's, camera frame."""
    upright, origin = T_cam_obj[:3, 2], T_cam_obj[:3, 3]
    middle = apply(T_cam_obj, np.append(board.extent_mm / 2, 0.0)[None])[0]
    along = unit(np.cross(upright, normal))
    start = np.linalg.lstsq(
        np.array([upright, normal, along]),
        np.array([upright @ origin, offset_mm, along @ middle]),
        rcond=None,
    )[0]
    reach_mm = board.extent_mm.min() / 2
    return np.asarray(start + np.linspace(-reach_mm, reach_mm, LINE_POINTS)[:, None] * along)
