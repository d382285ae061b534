"""Sessions on a bent chessboard as its detection would give them, with the truth behind them:
corners and line points are computed, not rendered, so that many can be made."""

from dataclasses import dataclass, field, replace

import numpy as np
from scipy.spatial.transform import Rotation

from crenel.metrology.adjustment.board.calibrate import BoardCalibration
from crenel.metrology.adjustment.board.initial_guess import BoardObservation
from crenel.metrology.adjustment.board.observations import intersect_surface
from crenel.metrology.adjustment.board.problem import BoardInputs
from crenel.metrology.adjustment.board.surface import board_prior, corners_at
from crenel.metrology.chessboard.board_detection import BoardDetection
from crenel.metrology.sensor.camera import Camera, project
from crenel.metrology.sensor.laser_plane import LaserPlane
from crenel.metrology.sensor.triangulation import sensor_points
from crenel.metrology.stripe import Stripe
from crenel.metrology.targets.chessboard import Chessboard, pattern_centre
from crenel.metrology.transforms import Floats, apply, inverse, rigid
from tests.metrology.boards import (
    K1,
    NORMAL,
    OFFSET_MM,
    POSES,
    ROBOT,
    SIZE,
    T_ARM_OBJ,
    T_FLANGE_CAM,
    K,
)

PAPER_BOARD = Chessboard("paper board", "", (7, 6), 10.0, 0.02, 0.2)
ROUNDS = 12


@dataclass(frozen=True)
class BoardErrors:
    """Standard deviations of everything that errs; ``drift_mm`` is by pose, of the laser."""

    turn_rad: float = 3e-4
    shift_mm: float = 0.05
    tilt_rad: float = 0.0
    line_mm: float = 0.05
    line_rad: float = 1e-3
    corner_px: float = 0.03
    stripe_px: float = 0.08
    drift_mm: tuple[float, ...] = field(default=())


def session(
    seed: int,
    errors: BoardErrors | None = None,
    board: Chessboard = PAPER_BOARD,
    poses: tuple[Floats, ...] = POSES,
    normal: Floats = NORMAL,
    offset_mm: float = OFFSET_MM,
    rows_apart: int = 1,
) -> BoardInputs:
    """One session of a robot, all errors drawn again; poses ``T_cam_obj`` a little different, the
    line with a point in every ``rows_apart``-th row."""
    errors = errors or BoardErrors()
    rng = np.random.default_rng(seed)
    prior = board_prior(board)
    bend_coordinates = prior.coordinates + prior.sd * rng.normal(0, 1, len(prior.sd))
    seen, flange = [], []
    for k, usual in enumerate(poses):
        turn = Rotation.from_rotvec(rng.normal(0, 0.05, 3)).as_matrix()
        T = rigid(usual[:3, :3] @ turn, usual[:3, 3] + rng.normal(0, 5, 3))
        drift = errors.drift_mm[k] if k < len(errors.drift_mm) else 0.0
        plane = LaserPlane(normal, offset_mm + drift + rng.normal(0, errors.line_mm))
        shown = _simulate_on_surface(
            rng, k + 1, board, bend_coordinates, T, plane, errors, rows_apart
        )
        seen.append(shown)
        flange.append(_flange(rng, board, T, errors))
    return BoardInputs(ROBOT, board, tuple(seen), np.array(flange), SIZE)


def simulate_detection(
    rng: np.random.Generator,
    number: int,
    board: Chessboard,
    T_cam_obj: Floats,
    plane: LaserPlane,
    errors: BoardErrors,
) -> BoardObservation:
    """A flat board as its certificate has it, seen at ``T_cam_obj`` (4, 4)."""
    moved = replace(plane, offset_mm=plane.offset_mm + rng.normal(0, errors.line_mm))
    bend_coordinates = board_prior(board).coordinates
    return _simulate_on_surface(rng, number, board, bend_coordinates, T_cam_obj, moved, errors)


def _simulate_on_surface(
    rng: np.random.Generator,
    number: int,
    board: Chessboard,
    bend_coordinates: Floats,
    T_cam_obj: Floats,
    plane: LaserPlane,
    errors: BoardErrors,
    rows_apart: int = 1,
) -> BoardObservation:
    camera = camera_at(T_cam_obj)
    uv = project(camera, corners_at(board, bend_coordinates))
    inside = ((uv > 3) & (uv < np.array(SIZE) - 4)).all(axis=1)
    uv = uv[inside] + rng.normal(0, errors.corner_px, (int(inside.sum()), 2))
    covariance = np.tile(np.eye(2) * errors.corner_px**2, (len(uv), 1, 1))
    detection = BoardDetection(uv, covariance, np.flatnonzero(inside))
    n, t = plane.normal, T_cam_obj[:3, 3]
    in_obj = LaserPlane(T_cam_obj[:3, :3].T @ n, float(plane.offset_mm - n @ t))
    turned = rng.normal(0, errors.line_rad)
    v = np.arange(0, SIZE[1], rows_apart, dtype=np.float64)

    def off(u: Floats) -> Floats:
        points = intersect_surface(board, camera, bend_coordinates, np.column_stack([u, v]))
        along = points[:, 1] - pattern_centre(board)[1]
        return np.asarray(points @ in_obj.normal - in_obj.offset_mm - turned * along)

    low, high = np.zeros(len(v)), np.full(len(v), SIZE[0] - 1.0)
    at_low, at_high = off(low), off(high)
    crossed = at_low * at_high < 0
    # nearly straight along a row, so that each round of false position gains a digit
    for _ in range(ROUNDS):
        u = np.where(crossed, low + (high - low) * at_low / (at_low - at_high), low)
        at_u = off(u)
        before = at_u * at_low > 0
        low, at_low = np.where(before, u, low), np.where(before, at_u, at_low)
        high, at_high = np.where(before, high, u), np.where(before, at_high, at_u)
    u = u[crossed]
    sigma = np.full(len(u), errors.stripe_px)
    stripe = Stripe(u + rng.normal(0, sigma), v[crossed], np.full(len(u), 200.0), sigma, "v")
    return BoardObservation(number, detection, stripe)


def _flange(
    rng: np.random.Generator, board: Chessboard, T_cam_obj: Floats, errors: BoardErrors
) -> Floats:
    """What the robot reports where it truly sees the board, perhaps tilted, at ``T_cam_obj``."""
    tilt = Rotation.from_rotvec([*rng.normal(0, errors.tilt_rad, 2), 0.0]).as_matrix()
    middle = pattern_centre(board)
    tilted = rigid(tilt, middle - tilt @ middle)
    true = T_ARM_OBJ @ tilted @ inverse(T_cam_obj) @ inverse(T_FLANGE_CAM)
    turn = Rotation.from_rotvec(rng.normal(0, errors.turn_rad, 3)).as_matrix()
    return rigid(true[:3, :3] @ turn, true[:3, 3] + rng.normal(0, errors.shift_mm, 3))


def camera_at(T_cam_frame: Floats) -> Camera:
    """The true camera, placed in a frame."""
    distortion = np.array([K1, 0, 0, 0, 0])
    return Camera(K, T_cam_frame[:3, :3], T_cam_frame[:3, 3], *SIZE, distortion)


def error_um(found: BoardCalibration) -> float:
    """Rms error of reconstructed points over the measuring volume, in the flange frame."""
    state, uv = found.adjustment.state, found.uncertainty.volume.uv_px
    ours = apply(state.T_flange_cam, sensor_points(state.camera, state.plane, uv))
    true = sensor_points(camera_at(np.eye(4)), LaserPlane(NORMAL, OFFSET_MM), uv)
    off = ours - apply(T_FLANGE_CAM, true)
    return float(1e3 * np.sqrt(np.mean(np.sum(off**2, axis=1))))
