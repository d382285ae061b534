"""Camera and mounting without a laser, judged by pictures that the calibration did not see.

    python -m tests.bench held-out REAL [--simulated N] [--json]

REAL holds recordings of a robot and a chessboard; a laser's line in their pictures is ignored.
Every picture is left out once, with the next ones of its fold. The rest gives camera, mounting and
the board's place; with the robot's pose, these say where the corners of the picture left out must
lie. The simulated sessions are of a robot and a bent board, with other noise in each. OpenCV is
calibrateCamera, solvePnP, each of the hand-eye methods, and the mean of the board's places.
"""

import tempfile
from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from crenel.formats.session.calibration_session import BoardSession, read_any_session
from crenel.metrology.adjustment.board.calibrate import calibrate_board
from crenel.metrology.adjustment.board.problem import BoardInputs
from crenel.metrology.sensor.camera import Camera, project
from crenel.metrology.targets.chessboard import corner_points
from crenel.metrology.transforms import Floats, inverse, nearest_rotation, rigid
from tests.bench.board_measures import calibrate_camera, move_camera, solve_pose
from tests.bench.hand_eye import K1_ONLY, hand_eye_methods
from tests.bench.peers import read_recording
from tests.bench.rows import Rows, bench_parser, measured_rows
from tests.metrology.boards import POSES
from tests.metrology.numerics import rms_length
from tests.metrology.seen_boards import BoardErrors, session
from tests.real_sessions import write_real_session

FOLDS = 4
CRENEL, OPENCV = "Crenel", "OpenCV"


def held_out_px(inputs: BoardInputs) -> dict[str, float]:
    """Rms distance of held-out corners, by way to calibrate; of OpenCV, each method by itself."""
    off: dict[str, list[Floats]] = {}
    every = np.arange(len(inputs.observations))
    for fold in range(FOLDS):
        out = every % FOLDS == fold
        for name, px in _fold_errors_px(_select(inputs, every[~out]), _select(inputs, every[out])):
            off.setdefault(name, []).append(px)
    return {name: rms_length(np.concatenate(parts)) for name, parts in off.items()}


def _select(inputs: BoardInputs, kept: NDArray[np.int64]) -> BoardInputs:
    seen = tuple(inputs.observations[k] for k in kept)
    return replace(inputs, observations=seen, readings=inputs.readings[kept], with_laser=False)


def _fold_errors_px(train: BoardInputs, test: BoardInputs) -> list[tuple[str, Floats]]:
    found = calibrate_board(train)
    state = found.adjustment.state
    errors = [
        (
            CRENEL,
            _errors_px(test, state.camera, state.T_flange_cam, state.T_arm_obj, found.corners_mm),
        )
    ]
    points = corner_points(train.board)
    seen = [(points[one.detection.number], one.detection.uv_px) for one in train.observations]
    for terms, flags in (("k1", K1_ONLY), ("5 terms", 0)):
        camera = calibrate_camera(seen, train.size_px, np.eye(3), flags)
        T_cam_obj = [solve_pose(camera, *one) for one in seen]
        for name, T_flange_cam in hand_eye_methods(list(train.readings), T_cam_obj):
            places = np.array(
                [A @ T_flange_cam @ B for A, B in zip(train.readings, T_cam_obj, strict=True)]
            )
            mean = places.mean(axis=0)
            T_arm_obj = rigid(nearest_rotation(mean[:3, :3]), mean[:3, 3])
            px = _errors_px(test, camera, T_flange_cam, T_arm_obj, points)
            errors.append((f"{OPENCV}, {terms}, {name}", px))
    return errors


def _errors_px(
    test: BoardInputs, camera: Camera, T_flange_cam: Floats, T_arm_obj: Floats, corners_mm: Floats
) -> Floats:
    """(N, 2) corners of the pictures beside where camera, mounting and place put them."""
    off = []
    for one, T_arm_flange in zip(test.observations, test.readings, strict=True):
        T_cam_obj = inverse(T_arm_flange @ T_flange_cam) @ T_arm_obj
        at = corners_mm[one.detection.number]
        off.append(project(move_camera(camera, T_cam_obj), at) - one.detection.uv_px)
    return np.concatenate(off)


def _add(rows: Rows, name: str, found: dict[str, float]) -> None:
    opencv = {key: px for key, px in found.items() if key != CRENEL}
    best = min(opencv, key=lambda key: opencv[key])
    rows.say(f"{name}: the best of OpenCV is {best}")
    rows.add(name, {"Crenel px": found[CRENEL], "OpenCV px": opencv[best]})


def main() -> None:
    parser = bench_parser(__doc__)
    parser.add_argument("real", type=Path)
    parser.add_argument("--simulated", type=int, default=12)
    given = parser.parse_args()
    with measured_rows(given.json) as rows, tempfile.TemporaryDirectory() as scratch:
        for folder in sorted({frame.parent for frame in given.real.rglob("frame*.png")}):
            read = read_any_session(write_real_session(folder, Path(scratch) / folder.name))
            assert isinstance(read, BoardSession)
            made = read_recording(read)
            readings = np.array([frame.T_arm_flange for frame in made.frames])
            inputs = BoardInputs(read.arm, made.board, made.detections, readings, made.size_px)
            _add(rows, folder.name, held_out_px(inputs))
        for seed in range(given.simulated):
            larger = 3.0 ** (seed % 3)
            errors = BoardErrors(turn_rad=1e-4 * larger, shift_mm=0.02 * larger)
            made_up = session(seed, errors, poses=(*POSES, *POSES[1:]))
            _add(rows, f"simulated {seed}, robot ± {errors.shift_mm:.2f} mm", held_out_px(made_up))


if __name__ == "__main__":
    main()
