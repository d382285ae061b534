"""Crenel beside what a competent user of OpenCV does with the same pictures.

    python -m tests.bench peers REAL [SAMPLES] [--json]

REAL holds recordings of a robot, a chessboard and a laser's line; SAMPLES the simulated
sessions with their truth. OpenCV: calibrateCamera on all pictures, solvePnP on each, the
hand-eye methods, and a plane through the line's points on the board (for Crenel too, so that
it is measured alike; the plane of its own calibration beside it). Beside it a joint
least-squares over camera, mounting and board, without noise model, bend or outliers.
"""

import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray
from scipy.optimize import least_squares

from crenel.formats.images import read_grey
from crenel.formats.session.calibration_session import BoardSession, read_any_session
from crenel.metrology.adjustment.board.calibrate import calibrate_board, observe_board
from crenel.metrology.adjustment.board.initial_guess import BoardObservation
from crenel.metrology.adjustment.board.observations import intersect_surface
from crenel.metrology.adjustment.board.problem import BoardInputs
from crenel.metrology.adjustment.board.surface import corners_at
from crenel.metrology.image import Image
from crenel.metrology.sensor.camera import Camera, project
from crenel.metrology.sensor.laser_plane import LaserPlane
from crenel.metrology.targets.chessboard import Chessboard, corner_points
from crenel.metrology.transforms import (
    Floats,
    apply,
    inverse,
    rigid,
    rotation_from_vector,
    vector_from_rotation,
)
from tests.bench.block_peers import measure_samples
from tests.bench.board_measures import (
    MEASURES,
    OF_LINE,
    BoardFrame,
    PeerCalibration,
    calibrate_camera,
    line_on_board,
    origin_scatter_mm,
    plane_through,
    solve_pose,
)
from tests.bench.hand_eye import K1_ONLY, hand_eye_methods
from tests.bench.rows import Rows, bench_parser, measured_rows
from tests.real_sessions import write_real_session

CRENEL = "Crenel"
NO_PLANE = LaserPlane(np.array([0.0, 0.0, 1.0]), 0.0)


@dataclass(frozen=True)
class PeerRecording:
    """A session's pictures by Crenel's corners, and by OpenCV's own where it finds all."""

    size_px: tuple[int, int]
    board: Chessboard
    detections: tuple[BoardObservation, ...]
    frames: tuple[BoardFrame, ...]
    cv_frames: tuple[BoardFrame, ...]


def read_recording(session: BoardSession) -> PeerRecording:
    board, size_px = session.board, (session.sensor.width_px, session.sensor.height_px)
    seen, frames, cv_frames = [], [], []
    for pose in session.poses:
        image = read_grey(pose.ambient)
        laser = None if pose.laser is None else read_grey(pose.laser)
        one = observe_board(pose.number, board, image, laser, session.sensor.stripe_axis)
        assert pose.T_arm_flange is not None
        found = one.detection
        frame = BoardFrame(
            pose.number, pose.T_arm_flange, found.number, found.uv_px, one.stripe.uv_px
        )
        corners = opencv_corners(image, board)
        seen.append(one)
        frames.append(frame)
        if corners is not None:
            number = match_numbers(corners, frame, board)
            cv_frames.append(replace(frame, corner=number, uv_px=corners))
    return PeerRecording(size_px, board, tuple(seen), tuple(frames), tuple(cv_frames))


def opencv_corners(image: Image, board: Chessboard) -> Floats | None:
    """All corners by OpenCV: the sector-based finder, else the older one with cornerSubPix."""
    flags = cv2.CALIB_CB_EXHAUSTIVE | cv2.CALIB_CB_ACCURACY
    found, uv = cv2.findChessboardCornersSB(image, board.inner_corners, flags=flags)
    if not found:
        flags = cv2.CALIB_CB_ADAPTIVE_THRESH | cv2.CALIB_CB_NORMALIZE_IMAGE
        found, uv = cv2.findChessboardCorners(image, board.inner_corners, flags=flags)
        if not found:
            return None
        uv = cv2.cornerSubPix(image, uv, (7, 7), (-1, -1), (3, 50, 1e-4))
    return np.asarray(uv, np.float64).reshape(-1, 2)


def match_numbers(uv_px: Floats, frame: BoardFrame, board: Chessboard) -> NDArray[np.int64]:
    """The board's numbers of OpenCV's corners, whose first one changes from picture to picture."""
    places = corner_points(board)[:, :2]
    H = np.asarray(cv2.findHomography(places[frame.corner], frame.uv_px)[0])
    seen = cv2.perspectiveTransform(places[:, None], H)[:, 0]
    return np.asarray(np.argmin(np.linalg.norm(seen - uv_px[:, None], axis=2), axis=1))


def calibrate_opencv(
    what: str, made: PeerRecording, frames: Sequence[BoardFrame]
) -> Iterator[PeerCalibration]:
    """calibrateCamera with k1 and with all five terms, then each of the hand-eye methods."""
    points = corner_points(made.board)
    for terms, flags in (("k1", K1_ONLY), ("5 terms", 0)):
        seen = [(points[frame.corner], frame.uv_px) for frame in frames]
        camera = calibrate_camera(seen, made.size_px, np.eye(3), flags)
        T_cam_obj = [solve_pose(camera, *one) for one in seen]
        T_arm_flange = [frame.T_arm_flange for frame in frames]
        start = PeerCalibration("", camera, np.eye(4), points, NO_PLANE)
        start = with_plane(start, frames)
        for name, T_flange_cam in hand_eye_methods(T_arm_flange, T_cam_obj):
            yield replace(start, name=f"{what}, {terms}, {name}", T_flange_sensor=T_flange_cam)


def with_plane(solved: PeerCalibration, frames: Sequence[BoardFrame]) -> PeerCalibration:
    """With the plane of least squares through all the line's points on the board."""
    points = [line_on_board(solved, frame) for frame in frames]
    return replace(solved, plane=plane_through(np.concatenate(points)))


def calibrate_least_squares(
    what: str, start: PeerCalibration, frames: Sequence[BoardFrame]
) -> PeerCalibration:
    """Camera with k1, mounting and board together by the pixels; the arm's poses as reported."""
    camera = start.camera
    T_obj = frames[0].T_arm_flange @ start.T_flange_sensor
    T_obj = T_obj @ solve_pose(camera, start.corners_mm[frames[0].corner], frames[0].uv_px)
    p0 = np.concatenate(
        [
            [1, 1, camera.matrix[0, 2], camera.matrix[1, 2], camera.distortion[0]],
            _vector(start.T_flange_sensor),
            _vector(T_obj),
        ]
    )

    def camera_of(p: Floats) -> Camera:
        K = camera.matrix.copy()
        K[0, 0], K[1, 1] = camera.matrix[0, 0] * p[0], camera.matrix[1, 1] * p[1]
        K[0, 2], K[1, 2] = p[2], p[3]
        return replace(camera, matrix=K, distortion=np.array([p[4], 0, 0, 0, 0]))

    def residuals(p: Floats) -> Floats:
        own, to_arm, board = camera_of(p), _transform(p[5:11]), _transform(p[11:17])
        off = [
            project(
                own, apply(inverse(f.T_arm_flange @ to_arm) @ board, start.corners_mm[f.corner])
            )
            - f.uv_px
            for f in frames
        ]
        return np.concatenate(off).ravel()

    p = least_squares(residuals, p0, x_scale="jac").x
    found = replace(start, name=what, camera=camera_of(p), T_flange_sensor=_transform(p[5:11]))
    return with_plane(found, frames)


def _vector(T: Floats) -> Floats:
    return np.concatenate([vector_from_rotation(T[:3, :3]), T[:3, 3]])


def _transform(vector: Floats) -> Floats:
    return rigid(rotation_from_vector(vector[:3]), vector[3:])


def calibrate_crenel(
    made: PeerRecording, arm_session: BoardSession
) -> tuple[PeerCalibration, set[int]]:
    """What Crenel found, and the pictures whose laser line it says contradicts the others."""
    readings = np.array([frame.T_arm_flange for frame in made.frames])
    result = calibrate_board(
        BoardInputs(arm_session.arm, made.board, made.detections, readings, made.size_px)
    )
    coordinates = result.adjustment.state.coordinates
    board = made.board
    said = {pose.number for pose in result.poses if "laser line" in str(pose.reason)}
    assert result.plane is not None
    solved = PeerCalibration(
        CRENEL,
        result.camera,
        result.T_flange_sensor,
        corners_at(board, coordinates),
        result.plane,
        lambda camera, uv: intersect_surface(board, camera, coordinates, uv),
    )
    return solved, said


def line_figures(
    solved: Sequence[PeerCalibration], by: Sequence[Sequence[BoardFrame]]
) -> dict[str, float]:
    """Of a calibration by all pictures, and of one by some of them."""
    return {
        f"{name}{end}": measure(one, frames)
        for one, frames, end in zip(solved, by, (" mm", "*"), strict=True)
        for name, measure in OF_LINE.items()
    }


def summary_figures(
    solved: PeerCalibration, frames: Sequence[BoardFrame], out: set[int]
) -> dict[str, float]:
    """Of all pictures; those of the line also without the pictures ``out``. The laser's plane is
    the one through the points, in either case."""
    both = (frames, [frame for frame in frames if frame.number not in out])
    found = {name: measure(solved, frames) for name, measure in MEASURES.items()}
    return found | line_figures([with_plane(solved, by) for by in both], both)


def measure_recording(folder: Path, scratch: Path, rows: Rows) -> None:
    """A row for each way to calibrate, by the recording's name."""
    session = read_any_session(write_real_session(folder, scratch / folder.name))
    assert isinstance(session, BoardSession)
    made = read_recording(session)
    crenel, out = calibrate_crenel(made, session)
    total = len(made.frames)
    rows.say(f"\n{folder.name}: {total} pictures, OpenCV finds the board in {len(made.cv_frames)}")
    rows.say(f"* without pictures {sorted(out) or 'none'}, whose lines contradict the others'")

    def add(name: str, frames: Sequence[BoardFrame], solved: PeerCalibration) -> None:
        rows.add(f"{folder.name}: {name}", summary_figures(solved, frames, out))

    for what, frames in (("OpenCV's corners", made.cv_frames), ("Crenel's corners", made.frames)):
        solved = list(calibrate_opencv(what, made, frames))
        best = min(solved, key=lambda one: origin_scatter_mm(one, frames))
        joint = calibrate_least_squares(f"{what}, least squares together", best, frames)
        for one in (*solved, joint):
            add(one.name, frames, one)
    add(crenel.name, made.frames, crenel)
    rest = [frame for frame in made.frames if frame.number not in out]
    own = line_figures((crenel, crenel), (made.frames, rest))
    rows.add(f"{folder.name}: Crenel, the plane of its calibration", own)
    as_flat = replace(
        crenel, corners_mm=corner_points(made.board), board_surface=PeerCalibration.board_surface
    )
    add("Crenel's camera and mounting, flat board", made.frames, as_flat)


def main() -> None:
    parser = bench_parser(__doc__)
    parser.add_argument("real", type=Path)
    parser.add_argument("samples", type=Path, nargs="?")
    given = parser.parse_args()
    with measured_rows(given.json) as rows, tempfile.TemporaryDirectory() as scratch:
        for folder in sorted({frame.parent for frame in given.real.rglob("frame*.png")}):
            measure_recording(folder, Path(scratch), rows)
        if given.samples is not None:
            measure_samples(given.samples, rows)


if __name__ == "__main__":
    main()
