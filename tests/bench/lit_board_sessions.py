"""Sessions of a robot before a lit board that the laser's line crosses, rendered with the truth.

Every session has a camera, a board, a line and a robot of its own. The line is 50 to 150 grey
levels above the white squares, and dimmer on black ones; where that exceeds 255, it is clipped.
The renderer shares nothing with the program: rays are cast at the board, colours looked up.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from crenel.metrology.adjustment.board.calibrate import BoardCalibration
from crenel.metrology.arm.kinematics import RobotArm
from crenel.metrology.sensor.camera import Camera
from crenel.metrology.sensor.laser_plane import LaserPlane
from crenel.metrology.sensor.triangulation import sensor_points
from crenel.metrology.stripe import Stripe
from crenel.metrology.targets.chessboard import Chessboard, pattern_centre
from crenel.metrology.transforms import Floats, apply, inverse, rigid, rotation_from_vector
from tests.metrology.numerics import unit

Grey = NDArray[np.uint8]
Rays = NDArray[np.float32]

SIZES_PX = ((640, 512), (800, 600), (960, 768))
BOARDS = ((6, 5), (7, 6), (8, 7), (9, 6), (11, 8))
FINE = 2
"""Rays across a pixel."""
CONTRAST = (50.0, 150.0)
"""Grey levels of the line above white squares."""
UNDISTORTING_ROUNDS = 8


@dataclass(frozen=True)
class LitPlan:
    """What the pictures of a session look like: grey levels, and pixels."""

    white: float
    black: float
    table: float
    contrast: float
    on_black: float
    """The line's height on black squares, in shares of that on white ones."""
    line_px: float
    blur_px: float
    noise: float
    falloff: float
    """By which share the light falls to one side of the picture."""
    quality: int
    """Of JPEG; 100: as they are."""


@dataclass(frozen=True)
class LitSession:
    """What nature knows; P poses. ``axis`` as in ``extract_stripe``."""

    board: Chessboard
    rim: float
    """White about the outermost squares, in squares."""
    plan: LitPlan
    camera: Camera
    plane: LaserPlane
    axis: str
    T_cam_obj: Floats
    T_arm_flange: Floats
    readings: Floats
    T_flange_cam: Floats
    seed: int

    @property
    def arm(self) -> RobotArm:
        return RobotArm("Robot", "R-1")

    def pictures(self) -> Iterator[Grey]:
        """One for each pose, with both lights."""
        rng = np.random.default_rng([self.seed, 1])
        rays = _cast_rays(self.camera)
        for T in self.T_cam_obj:
            yield _render(self, rays, T, rng)

    def offsets_px(self, pose: int, stripe: Stripe) -> Floats:
        """(N,) how far points of the line in a picture lie off it, across the line's columns."""
        T, beside = self.T_cam_obj[pose], stripe.uv_px + 0.5 * stripe.across
        here, there = (self._off_plane_mm(T, uv) for uv in (stripe.uv_px, beside))
        return np.asarray(0.5 * here / (there - here))

    def _off_plane_mm(self, T_cam_obj: Floats, uv_px: Floats) -> Floats:
        """(N,) how far points of the board that are seen at pixels lie off the laser's plane."""
        xy = _undistort(self.camera, uv_px)
        rays = np.column_stack([xy, np.ones(len(xy))])
        upright, origin = T_cam_obj[:3, 2], T_cam_obj[:3, 3]
        points = rays * ((upright @ origin) / (rays @ upright))[:, None]
        return np.asarray(points @ self.plane.normal - self.plane.offset_mm)

    def errors_um(self, found: BoardCalibration) -> Floats:
        """(G,) how far reconstructed points over the measuring volume lie off, flange frame."""
        state, uv = found.adjustment.state, found.uncertainty.volume.uv_px
        ours = apply(state.T_flange_cam, sensor_points(state.camera, state.plane, uv))
        true = apply(self.T_flange_cam, sensor_points(self.camera, self.plane, uv))
        return np.asarray(1e3 * np.linalg.norm(ours - true, axis=1))


def draw_lit_session(seed: int) -> LitSession:
    """The session of a seed."""
    rng = np.random.default_rng(seed)
    width, height = SIZES_PX[rng.integers(len(SIZES_PX))]
    square_mm = float(rng.choice([6.0, 10.0, 15.0, 20.0]))
    inner = BOARDS[rng.integers(len(BOARDS))]
    board = Chessboard("board", f"B-{seed}", inner, square_mm, 0.01, 0.02)
    rim = rng.uniform(0.1, 1.2)
    focal_px = width * rng.uniform(1.4, 2.2)
    K = np.array([[focal_px, 0, width / 2 + 3], [0, focal_px, height / 2 - 2], [0, 0, 1.0]])
    distortion = np.array([rng.uniform(-0.1, 0.05), 0, 0, 0, 0])
    camera = Camera(K, np.eye(3), np.zeros(3), width, height, distortion)
    span_mm = board.extent_mm + 2 * square_mm
    fill = rng.uniform(0.55, 0.75)
    away_mm = float(focal_px * max(span_mm / np.array([width, height])) / fill)
    axis = str(rng.choice(["u", "v"]))
    lean = np.array([rng.uniform(0.5, 0.9), rng.uniform(-0.15, 0.15), 0.6])
    normal = unit(lean if axis == "v" else lean[[1, 0, 2]])
    plane = LaserPlane(normal, float(away_mm * normal[2]))
    T_flange_cam = _any_pose(rng, 100.0)
    T_arm_obj = _any_pose(rng, 600.0)
    poses = int(rng.integers(9, 14))
    T_cam_obj = np.array([_view(board, away_mm, rng) for _ in range(poses)])
    flange = np.array([T_arm_obj @ inverse(T) @ inverse(T_flange_cam) for T in T_cam_obj])
    shift_mm, turn_rad = rng.uniform(0.01, 0.06), rng.uniform(2e-5, 2e-4)
    readings = np.array(
        [
            rigid(
                T[:3, :3] @ rotation_from_vector(rng.normal(0, turn_rad, 3)),
                T[:3, 3] + rng.normal(0, shift_mm, 3),
            )
            for T in flange
        ]
    )
    return LitSession(
        board,
        rim,
        _draw_plan(rng),
        camera,
        plane,
        axis,
        T_cam_obj,
        flange,
        readings,
        T_flange_cam,
        seed,
    )


def _draw_plan(rng: np.random.Generator) -> LitPlan:
    white = rng.uniform(60, 170)
    return LitPlan(
        white=white,
        black=white * rng.uniform(0.08, 0.25),
        table=white * float(rng.choice([0.2, 0.5, 0.9])),
        contrast=rng.uniform(*CONTRAST),
        on_black=rng.uniform(0.3, 0.6),
        line_px=float(np.exp(rng.uniform(np.log(0.8), np.log(5.0)))),
        blur_px=rng.uniform(0.6, 1.2),
        noise=rng.uniform(0.8, 2.5),
        falloff=rng.uniform(0.0, 0.3),
        quality=int(rng.choice([100, 100, 95, 90])),
    )


def _any_pose(rng: np.random.Generator, reach_mm: float) -> Floats:
    return rigid(Rotation.random(random_state=rng).as_matrix(), rng.uniform(-1, 1, 3) * reach_mm)


def _view(board: Chessboard, away_mm: float, rng: np.random.Generator) -> Floats:
    """``T_cam_obj`` (4, 4) of a camera that looks about at the board's middle."""
    about, tilt = rng.uniform(0, 2 * np.pi), np.radians(rng.uniform(8, 28))
    R = (
        Rotation.from_rotvec(tilt * np.array([np.cos(about), np.sin(about), 0]))
        * Rotation.from_rotvec([0, 0, rng.normal(0, 0.35)])
        * Rotation.from_rotvec([np.pi, 0, 0])
    ).as_matrix()
    offset = rng.normal(0, [0.015, 0.015, 0.03]) * away_mm
    return rigid(R, np.array([0, 0, away_mm]) + offset - R @ pattern_centre(board))


def _cast_rays(camera: Camera) -> Rays:
    """Directions (3, N) of the rays of a picture, ``FINE`` by ``FINE`` to the pixel."""
    v, u = np.mgrid[0 : camera.height_px * FINE, 0 : camera.width_px * FINE]
    uv = (np.column_stack([u.ravel(), v.ravel()]) + 0.5) / FINE - 0.5
    xy = _undistort(camera, uv)
    return np.column_stack([xy, np.ones(len(xy))]).astype(np.float32).T.copy()


def _undistort(camera: Camera, uv_px: Floats) -> Floats:
    """Directions (N, 2) of pixels (N, 2), before the camera."""
    seen = (uv_px - camera.matrix[:2, 2]) / camera.matrix[0, 0]
    xy = seen.copy()
    for _ in range(UNDISTORTING_ROUNDS):
        xy = seen / (1 + camera.distortion[0] * np.sum(xy**2, axis=1, keepdims=True))
    return np.asarray(xy)


def _render(session: LitSession, rays: Rays, T_cam_obj: Floats, rng: np.random.Generator) -> Grey:
    plan, board, camera, plane = session.plan, session.board, session.camera, session.plane
    upright, origin = T_cam_obj[:3, 2], T_cam_obj[:3, 3]
    depth_mm = np.float32(upright @ origin) / (upright.astype(np.float32) @ rays)
    across = (T_cam_obj[:3, :2].T / board.square_mm).astype(np.float32)
    on = depth_mm * (across @ rays) - (across @ origin.astype(np.float32))[:, None]
    last = np.array(board.inner_corners)[:, None]
    inside = ((on >= -1) & (on < last)).all(axis=0)
    on_paper = ((on > -1 - session.rim) & (on < last + session.rim)).all(axis=0)
    black = inside & ((np.floor(on[0]) + np.floor(on[1])) % 2 == 0)
    light = 1 - plan.falloff * (rays[0] - rays[0].min()) / np.ptp(rays[0])
    level = light * np.where(black, plan.black, np.where(on_paper, plan.white, plan.table))
    reflected = np.where(black, plan.on_black, np.where(on_paper, 1.0, plan.table / plan.white))
    # as wide as stated in the picture's middle
    line_mm = plan.line_px * T_cam_obj[2, 3] / camera.matrix[0, 0] * np.hypot(*plane.normal[:2])
    off = depth_mm * (plane.normal.astype(np.float32) @ rays) - np.float32(plane.offset_mm)
    line = reflected * np.exp(-0.5 * (off / np.float32(line_mm)) ** 2)
    size = camera.height_px, FINE, camera.width_px, FINE
    seen, lit = (
        cv2.GaussianBlur(one.reshape(size).mean(axis=(1, 3)), (0, 0), plan.blur_px)
        for one in (level, line)
    )
    # the height is that of the seen line, however thin it was
    seen = seen + plan.contrast * lit / np.quantile(
        lit.max(axis=0 if session.axis == "u" else 1), 0.9
    )
    noisy = np.rint(seen + rng.normal(0, plan.noise, seen.shape))
    grey = np.asarray(np.clip(noisy, 0, 255), np.uint8)
    if plan.quality == 100:
        return grey
    coded = cv2.imencode(".jpg", grey, [cv2.IMWRITE_JPEG_QUALITY, plan.quality])[1]
    return np.asarray(cv2.imdecode(coded, cv2.IMREAD_GRAYSCALE), np.uint8)
