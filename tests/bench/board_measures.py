"""How well a calibration makes pictures of one resting chessboard agree.

Only what a calibration found comes in, beside the pictures' points and the arm's poses, so
that every way to calibrate is measured alike.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import cv2
import numpy as np
from numpy.typing import NDArray

from crenel.metrology.sensor.camera import Camera, project, rays
from crenel.metrology.sensor.laser_plane import LaserPlane
from crenel.metrology.sensor.triangulation import sensor_points
from crenel.metrology.transforms import Floats, apply, inverse, rigid
from tests.bench.rows import rms
from tests.metrology.numerics import rms_length

NEAR_PX = 170.0
TRIMMED_SIGMAS = 3.5


@dataclass(frozen=True)
class BoardFrame:
    """One picture: N corners by their number on the board, M points of the laser's line."""

    number: int
    T_arm_flange: Floats  # (4, 4)
    corner: NDArray[np.int64]  # (N,)
    uv_px: Floats  # (N, 2)
    stripe_px: Floats  # (M, 2)

    def near_pattern(self) -> NDArray[np.bool_]:
        """Which points of the line lie within ``NEAR_PX`` of the corners' convex hull."""
        if not len(self.stripe_px):
            return np.zeros(0, dtype=np.bool_)
        hull = cv2.convexHull(self.uv_px.astype(np.float32))
        off = [cv2.pointPolygonTest(hull, (float(u), float(v)), True) for u, v in self.stripe_px]
        return np.array(off) > -NEAR_PX


def flat(camera: Camera, uv_px: Floats) -> Floats:
    """Where pixels (N, 2) see the plane z = 0 of the frame that the camera is placed in."""
    origin, along = rays(camera, uv_px)
    return np.asarray(origin - (origin[2] / along[:, 2])[:, None] * along)


@dataclass(frozen=True)
class PeerCalibration:
    """What a calibration found: camera and laser plane in a sensor frame of its choice.

    ``corners_mm`` are the board's corners and ``board_surface`` brings pixels onto it, for a camera
    placed in the board's frame: flat, unless the calibration found out how it is bent.
    """

    name: str
    camera: Camera
    T_flange_sensor: Floats
    corners_mm: Floats
    plane: LaserPlane
    board_surface: Callable[[Camera, Floats], Floats] = flat


def calibrate_camera(
    seen: Sequence[tuple[Floats, Floats]], size_px: tuple[int, int], guess: Floats, flags: int
) -> Camera:
    """By points (N, 3) and their pixels (N, 2) in each picture (calibrateCamera)."""
    points, uv = ([one.astype(np.float32) for one in each] for each in zip(*seen, strict=True))
    _, K, distortion, _, _ = cv2.calibrateCamera(
        points, uv, size_px, guess, np.zeros(5), flags=flags
    )
    lens = np.ravel(distortion)[:5].astype(np.float64)
    return Camera(np.asarray(K, np.float64), np.eye(3), np.zeros(3), *size_px, lens)


def solve_pose(camera: Camera, points_mm: Floats, uv_px: Floats) -> Floats:
    """``T_cam_obj`` (4, 4) of points (N, 3) by their pixels in one picture (solvePnP)."""
    _, turn, shift = cv2.solvePnP(points_mm, uv_px, camera.matrix, camera.distortion)
    turn, shift = cv2.solvePnPRefineLM(
        points_mm, uv_px, camera.matrix, camera.distortion, turn, shift
    )
    return rigid(np.asarray(cv2.Rodrigues(turn)[0], np.float64), np.ravel(shift))


def board_from(solved: PeerCalibration, frame: BoardFrame) -> Camera:
    """The camera placed in the board's frame by the corners of one picture."""
    T = solve_pose(solved.camera, solved.corners_mm[frame.corner], frame.uv_px)
    return move_camera(solved.camera, T)


def move_camera(camera: Camera, T_cam_frame: Floats) -> Camera:
    return replace(camera, rotation=T_cam_frame[:3, :3], translation_mm=T_cam_frame[:3, 3])


def camera_pose_of(camera: Camera) -> Floats:
    return rigid(camera.rotation, camera.translation_mm)


def corner_rms_px(solved: PeerCalibration, frames: Sequence[BoardFrame]) -> float:
    """Corners of each picture to the board placed by them: rms over corners."""
    off_px = [
        project(board_from(solved, frame), solved.corners_mm[frame.corner]) - frame.uv_px
        for frame in frames
    ]
    return rms_length(np.concatenate(off_px))


def origin_scatter_mm(solved: PeerCalibration, frames: Sequence[BoardFrame]) -> float:
    """Rms distance of the board's first corner, in the arm's frame, from its mean."""
    return _scatter_mm(solved, frames, solved.corners_mm[:1])


def pattern_scatter_mm(solved: PeerCalibration, frames: Sequence[BoardFrame]) -> float:
    """The same of all corners: no choice of the first one makes it better or worse."""
    return _scatter_mm(solved, frames, solved.corners_mm)


def _scatter_mm(solved: PeerCalibration, frames: Sequence[BoardFrame], points_mm: Floats) -> float:
    T_flange_cam = solved.T_flange_sensor @ inverse(camera_pose_of(solved.camera))
    T_cam_board = [camera_pose_of(board_from(solved, frame)) for frame in frames]
    T_arm_board = [
        f.T_arm_flange @ T_flange_cam @ T for f, T in zip(frames, T_cam_board, strict=True)
    ]
    at = np.array([apply(T, points_mm) for T in T_arm_board])
    return rms_length((at - at.mean(axis=0)).reshape(-1, 3))


def line_on_board(solved: PeerCalibration, frame: BoardFrame) -> Floats:
    """(K, 3) where the line's points near the pattern lie on the board, sensor frame."""
    camera = board_from(solved, frame)
    points = solved.board_surface(camera, frame.stripe_px[frame.near_pattern()])
    return apply(inverse(camera_pose_of(solved.camera)) @ camera_pose_of(camera), points)


def laser_plane_rms_mm(solved: PeerCalibration, frames: Sequence[BoardFrame]) -> float:
    """The line's points on the board, each placed by its own picture, to the laser's plane."""
    points = np.concatenate([line_on_board(solved, frame) for frame in frames])
    return rms(points @ solved.plane.normal - solved.plane.offset_mm)


def common_plane_rms_mm(solved: PeerCalibration, frames: Sequence[BoardFrame]) -> float:
    """The line's points of all pictures, in the arm's frame, to the plane through them, without
    points beyond ``TRIMMED_SIGMAS``."""
    parts = []
    for frame in frames:
        near = frame.stripe_px[frame.near_pattern()]
        points = sensor_points(solved.camera, solved.plane, near)
        points = points[np.isfinite(points).all(axis=1)]
        parts.append(apply(frame.T_arm_flange @ solved.T_flange_sensor, points))
    points = np.concatenate(parts)
    while True:
        plane = plane_through(points)
        off = points @ plane.normal - plane.offset_mm
        kept = np.abs(off) < TRIMMED_SIGMAS * float(np.std(off))
        if kept.all():
            return rms(off)
        points = points[kept]


MEASURES = {
    "corners px": corner_rms_px,
    "origin mm": origin_scatter_mm,
    "pattern mm": pattern_scatter_mm,
}
OF_LINE = {"laser": laser_plane_rms_mm, "plane": common_plane_rms_mm}
"""In mm."""


def plane_through(points_mm: Floats) -> LaserPlane:
    """The plane of least squares through points (N, 3)."""
    centre = points_mm.mean(axis=0)
    normal = np.linalg.svd(points_mm - centre, full_matrices=False)[2][2]
    return LaserPlane(normal, float(normal @ centre))
