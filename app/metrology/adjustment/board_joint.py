"""The calibration on a flat chessboard: all pictures, and contacts if any, in one adjustment.

Without contacts the board's place in the arm's frame is found with everything else.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from app.metrology.adjustment.board_findings import BoardEvidence, board_findings
from app.metrology.adjustment.board_start import (
    FEWEST_STRIPE_POINTS,
    SeenBoard,
    board_camera,
    laser_start,
    numbered,
    plane_of_most,
    refuse_other_size,
)
from app.metrology.adjustment.board_view import (
    AROUND_SQUARES,
    BoardView,
    around_pattern,
    on_sheet,
)
from app.metrology.adjustment.evidence import Problem, Touches
from app.metrology.adjustment.joint import NotSeen, sorted_anew
from app.metrology.adjustment.mounting import Mounting, mounting_by_motion, refuse_alike
from app.metrology.adjustment.pose_results import PoseResult
from app.metrology.adjustment.readings import motion_of, plane_touches
from app.metrology.adjustment.sheet import board_papers
from app.metrology.adjustment.solve import Adjusted, adjust
from app.metrology.adjustment.state import State, pose_scene
from app.metrology.adjustment.uncertainty import Known, known, sensor_of
from app.metrology.arm import Arm, RobotArm
from app.metrology.camera import Camera
from app.metrology.chessboard.board import Chessboard
from app.metrology.chessboard.corners import detect_board
from app.metrology.detection.picture import picture_findings
from app.metrology.findings import LIMITS, Finding, Limits
from app.metrology.frames import Floats, inverse
from app.metrology.laser_plane import LaserPlane
from app.metrology.reconstruct import sensor_points
from app.metrology.refusal import Refusal
from app.metrology.stripe import Image, extract_stripe

Progress = Callable[[str, float], None]

# The one feature that is touched: the plane of the sheet.
FEATURE = "board"
# The laser's line lies beside the pattern, where a wrong bend carries it far off: at first,
# the corners alone tell the bend, and the line counts for no more than this, px.
FAINT_PX = 30.0
# Adjusted, the stripes sorted anew, until these are the same, and no more often than this.
MOST_SORTINGS = 3


@dataclass(frozen=True)
class BoardInputs:
    """What a calibration over P poses is made from: one board that has not moved.

    ``readings`` (P, ...) belong to ``seen`` and ``contact_readings`` (N, ...) to contacts on
    the board's plane; both as in ``readings.py``.
    """

    arm: Arm | RobotArm
    board: Chessboard
    seen: tuple[SeenBoard, ...]
    readings: Floats
    size_px: tuple[int, int]
    contact_readings: Floats | None = None
    unseen: tuple[NotSeen, ...] = ()
    limits: Limits = LIMITS


@dataclass(frozen=True)
class BoardCalibration:
    """A calibration and what it rests on.

    The sensor frame is the board's frame as the first used pose saw it.
    """

    adjusted: Adjusted
    camera: Camera
    plane: LaserPlane
    T_flange_sensor: Floats
    T_arm_obj: Floats
    poses: tuple[PoseResult, ...]
    known: Known
    depth_range_mm: tuple[float, float]
    findings: tuple[Finding, ...]


def see_board(
    number: int, board: Chessboard, ambient: Image, laser: Image | None, axis: str
) -> SeenBoard:
    """What the pictures of one pose show, by themselves.

    Args:
        ambient: (H, W) with room light; with both lights where ``laser`` is None.
        axis: along which stripe points are counted, see ``extract_stripe``.

    Raises:
        Refusal: the board is not to be found.
    """
    stripe = extract_stripe(ambient if laser is None else laser, axis)
    detection = detect_board(ambient, board, stripe if laser is None else None)
    return SeenBoard(number, detection, stripe, tuple(picture_findings(ambient)))


def calibrate_board(inputs: BoardInputs, progress: Progress | None = None) -> BoardCalibration:
    """Camera, laser plane and probe matrix from all poses, and contacts where there are any.

    Raises:
        Refusal: whatever makes the calibration impossible, by its reason.
    """
    say = progress or (lambda _what, _share: None)
    if not inputs.seen:
        raise (
            inputs.unseen[0].refusal
            if inputs.unseen
            else Refusal("no-images", "no pose was given", "", "take a picture of the board")
        )
    say("Finding a start", 0.0)
    problem, start, mounting = _start(inputs)
    say("Adjusting all poses together", 0.3)
    found = _adjusted(problem, start)
    say("Working out the uncertainty", 0.8)
    result = _assembled(inputs, found, mounting)
    say("Done", 1.0)
    return result


def _start(inputs: BoardInputs) -> tuple[Problem, State, Mounting]:
    board = inputs.board
    moves = motion_of(inputs.arm, inputs.readings)
    refuse_alike(moves.T_arm_flange)
    camera, _ = board_camera(inputs.seen, board, inputs.size_px)
    seen = numbered(inputs.seen, board, camera, moves.T_arm_flange)
    camera, T_cam_obj = board_camera(seen, board, inputs.size_px)
    mounting = mounting_by_motion(moves.T_arm_flange, T_cam_obj, board.size_mm)
    refuse_other_size(mounting, board)
    _refuse_contradictions(mounting, [pose.number for pose in seen])
    kept = np.flatnonzero(~mounting.contradicts)
    plane = laser_start([seen[k] for k in kept], board, camera, T_cam_obj[kept])
    papers = board_papers(board)
    views = tuple(
        _view(pose, board, camera, plane, T, papers.coordinates)
        for pose, T in zip(seen, T_cam_obj, strict=True)
    )
    problem = Problem(
        tuple(pose.number for pose in seen),
        views,
        moves,
        _touches(inputs, len(papers.names)),
        papers,
        *inputs.size_px,
    ).without_poses(mounting.contradicts)
    start = State(
        camera,
        plane,
        mounting.T_flange_cam,
        mounting.T_arm_obj,
        papers.coordinates,
        np.zeros(moves.by_links.shape[2]),
        np.zeros((len(problem.views), moves.by_noise.shape[2])),
    )
    return problem, start, mounting


def _touches(inputs: BoardInputs, coordinates: int) -> Touches | None:
    if inputs.contact_readings is None or not len(inputs.contact_readings):
        return None
    return plane_touches(inputs.arm, FEATURE, inputs.contact_readings, coordinates)


def _view(
    pose: SeenBoard,
    board: Chessboard,
    camera: Camera,
    plane: LaserPlane,
    T_cam_obj: Floats,
    coordinates: Floats,
) -> BoardView:
    """The pose's picture, the stripe sorted as the pose itself saw the board."""
    R, t = T_cam_obj[:3, :3], T_cam_obj[:3, 3]
    in_obj = LaserPlane(R.T @ plane.normal, float(plane.offset_mm - plane.normal @ t))
    none = np.zeros(len(pose.stripe.u), dtype=np.bool_)
    view = BoardView(board, pose.detection, pose.stripe, none)
    return view.sorted_anew(replace(camera, rotation=R, translation_mm=t), in_obj, coordinates)


def _refuse_contradictions(mounting: Mounting, numbers: list[int]) -> None:
    out = mounting.contradicts
    if out.sum() * 2 < len(out):
        return
    raise Refusal(
        "poses-contradict",
        f"poses {', '.join(map(str, numbers))} put the board up to"
        f" {mounting.off_mm.max():.1f} mm apart",
        "with half of them or more contradicting the others, none can be trusted",
        "check that the board was not moved, and that every picture has its own pose",
    )


def _adjusted(problem: Problem, start: State) -> Adjusted:
    """Adjusted by the corners first, then with the stripes, sorted anew until nothing changes."""
    by_corners = adjust(_faint(problem), start)
    state = replace(by_corners.state, plane=laser_plane(by_corners))
    found = adjust(_sorted_by(problem, by_corners, state), state)
    for _ in range(MOST_SORTINGS):
        again = sorted_anew(found)
        if all(
            np.array_equal(a.stripe_px(), b.stripe_px())
            for a, b in zip(found.problem.views, again.views, strict=True)
        ):
            break
        found = adjust(again, found.state)
    return found


def _faint(problem: Problem) -> Problem:
    """With stripes that hardly count."""
    views = tuple(
        replace(view, stripe=replace(view.stripe, sigma_px=np.full(len(view.used), FAINT_PX)))
        for view in _board_views(problem)
    )
    return replace(problem, views=views)


def _sorted_by(problem: Problem, found: Adjusted, state: State) -> Problem:
    """With the stripes sorted by another adjustment's places and a plane."""
    views = []
    for p, view in enumerate(problem.views):
        scene = pose_scene(state, problem, found.layout, p)
        views.append(view.sorted_anew(scene.camera, scene.plane, state.coordinates))
    return replace(problem, views=tuple(views))


def laser_plane(found: Adjusted) -> LaserPlane:
    """The plane, in the camera's frame, of the stripes where an adjustment puts the sheet."""
    state, problem = found.state, found.problem
    per_pose = []
    for p, view in enumerate(_board_views(problem)):
        camera = pose_scene(state, problem, found.layout, p).camera
        points = on_sheet(view.board, camera, state.coordinates, view.stripe.uv_px)
        points = points[around_pattern(view.board, points, AROUND_SQUARES)]
        if len(points) >= FEWEST_STRIPE_POINTS:
            per_pose.append(points @ camera.rotation.T + camera.translation_mm)
    return plane_of_most(per_pose)


def _board_views(problem: Problem) -> list[BoardView]:
    return [view for view in problem.views if isinstance(view, BoardView)]


def _assembled(inputs: BoardInputs, found: Adjusted, mounting: Mounting) -> BoardCalibration:
    state = found.state
    T_cam_sensor = inverse(found.problem.motion.T_arm_flange[0] @ state.T_flange_cam)
    T_cam_sensor = T_cam_sensor @ state.T_arm_obj
    worth = known(found, T_cam_sensor)
    camera, plane, T_flange_sensor = sensor_of(state, T_cam_sensor)
    poses = _pose_results(inputs, found, mounting)
    stripe = np.concatenate([view.stripe_px() for view in found.problem.views])
    points = sensor_points(state.camera, state.plane, stripe)
    distance = np.linalg.norm(points[np.isfinite(points).all(axis=1)], axis=1)
    evidence = BoardEvidence(inputs.board, inputs.seen, found, worth, poses, inputs.limits)
    return BoardCalibration(
        found,
        camera,
        plane,
        T_flange_sensor,
        state.T_arm_obj,
        poses,
        worth,
        (float(distance.min()), float(distance.max())),
        board_findings(evidence),
    )


def _pose_results(
    inputs: BoardInputs, found: Adjusted, mounting: Mounting
) -> tuple[PoseResult, ...]:
    """Of the poses used, of those that contradict, and of those that show no board."""
    results = [PoseResult(one.number, False, str(one.refusal)) for one in inputs.unseen]
    for out in map(int, np.flatnonzero(mounting.contradicts)):
        off = f"it puts the board {mounting.off_mm[out]:.1f} mm from where the others put it"
        results.append(PoseResult(inputs.seen[out].number, False, off))
    state, motion = found.state, found.problem.motion
    for p, number in enumerate(found.problem.numbers):
        corners, stripe = found.linear.rows[p]
        kept_corners, kept_stripe = (one.kept for one in found.judgements[p])
        twist = motion.by_links[p] @ state.links + motion.by_noise[p] @ state.noise[p]
        at = state.T_arm_obj[:3, 3]
        results.append(
            PoseResult(
                number,
                True,
                "",
                _rms(corners.residuals[kept_corners]) * np.sqrt(2),
                int(kept_corners.sum()) // 2,
                _rms(stripe.residuals[kept_stripe]),
                int(kept_stripe.sum()),
                1e3 * float(np.linalg.norm(np.cross(twist[:3], at) + twist[3:])),
            )
        )
    return tuple(sorted(results, key=lambda pose: pose.number))


def _rms(values: Floats) -> float:
    return float(np.sqrt(np.mean(values**2))) if len(values) else 0.0
