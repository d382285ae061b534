"""The calibration on a flat chessboard: all pictures, and contacts if any, in one adjustment.

Without contacts the board's place in the arm's frame is found with everything else.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from app.metrology.adjustment.board_bundle import Bundle, bundle, unplaced
from app.metrology.adjustment.board_findings import ROBOT_ROW, BoardEvidence, board_findings
from app.metrology.adjustment.board_lines import lines_of, scatter_told
from app.metrology.adjustment.board_results import (
    BoardContacts,
    board_contacts,
    board_pose_results,
    board_worst,
)
from app.metrology.adjustment.board_start import (
    SeenBoard,
    SizeByMotion,
    board_camera,
    numbered,
    size_by_motion,
)
from app.metrology.adjustment.board_view import BoardView, without_line
from app.metrology.adjustment.evidence import Problem, Touches
from app.metrology.adjustment.joint import NotSeen, sorted_anew, stripe_rms_mm
from app.metrology.adjustment.mounting import Mounting, mounting_by_motion, refuse_alike
from app.metrology.adjustment.pose_results import PoseResult, left_out
from app.metrology.adjustment.readings import motion_of, plane_touches
from app.metrology.adjustment.robot_noise import (
    PosesSeen,
    RobotNoise,
    astray,
    robot_noise,
    with_noise,
)
from app.metrology.adjustment.sheet import bend_of, board_papers, corners_at, shapes
from app.metrology.adjustment.solve import Adjusted, adjust
from app.metrology.adjustment.state import State
from app.metrology.adjustment.stray_poses import without_strays
from app.metrology.adjustment.uncertainty import Known, known, sensor_of
from app.metrology.arm import Arm, RobotArm
from app.metrology.camera import Camera
from app.metrology.chessboard.board import Chessboard, middle_of
from app.metrology.chessboard.corners import detect_board, outshining
from app.metrology.detection.picture import picture_findings
from app.metrology.findings import LIMITS, Finding, Limits, WorstPoint
from app.metrology.frames import Floats, apply, inverse, rigid
from app.metrology.laser_plane import LaserPlane
from app.metrology.reconstruct import sensor_points
from app.metrology.refusal import Refusal
from app.metrology.stripe import extract_stripe
from app.metrology.stripe_flanks import Image

Progress = Callable[[str, float], None]

# The one feature that is touched: the plane of the sheet.
FEATURE = "board"
# Contacts may lie so far off the board of the pictures before these have been adjusted, and
# single ones so far off the others.
CONTACTS_OFF_MM, CONTACT_STRAY_MM = 3.0, 1.0


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
class _Start:
    """``lines_out`` tells by pose number how far off (mm) the lines are that were left out, and
    ``apart`` the same of those that contradict but are too many to be mistakes."""

    problem: Problem
    state: State
    mounting: Mounting
    size: SizeByMotion
    lines_out: dict[int, float]
    apart: dict[int, float]


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
    corners_mm: Floats  # (N, 3) where they truly are, in the board's frame
    poses: tuple[PoseResult, ...]
    known: Known
    contacts: BoardContacts | None
    stripe_rms_um: float  # of the line's points to the laser plane
    depth_range_mm: tuple[float, float]
    findings: tuple[Finding, ...]
    worst: tuple[WorstPoint, ...]


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
    if laser is None:
        stripe = outshining(ambient, stripe)
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
    start = _start(inputs)
    say("Adjusting all poses together", 0.3)
    found, mounting = _adjusted(inputs, start)
    say("Working out the uncertainty", 0.8)
    result = _assembled(inputs, found, replace(start, mounting=mounting))
    say("Done", 1.0)
    return result


def _start(inputs: BoardInputs) -> _Start:
    board, arm = inputs.board, inputs.arm
    moves = motion_of(arm, inputs.readings)
    refuse_alike(moves.T_arm_flange)
    camera, _ = board_camera(inputs.seen, board, inputs.size_px)
    seen = numbered(inputs.seen, board, camera, moves.T_arm_flange)
    camera, T_cam_obj = board_camera(seen, board, inputs.size_px)
    views = [_view(pose, board) for pose in seen]
    numbers = tuple(pose.number for pose in seen)
    found = bundle(
        views,
        [replace(camera, rotation=T[:3, :3], translation_mm=T[:3, 3]) for T in T_cam_obj],
    )
    views = [
        replace(view, scatter_px=float(px))
        for view, px in zip(views, found.scatter_px, strict=True)
    ]
    T_cam_obj = np.array([rigid(one.rotation, one.translation_mm) for one in found.cameras])
    mounting = mounting_by_motion(moves.T_arm_flange, T_cam_obj, board.size_mm)
    size = size_by_motion(mounting, board)
    _refuse_contradictions(mounting, numbers)
    lines = lines_of(views, found, numbers)
    views = [
        replace(view, line_off_mm=lines.scatter_mm, line_off_rad=lines.scatter_rad)
        for view in views
    ]
    noise = None
    if isinstance(arm, RobotArm):
        mounting, noise = _robot_noise(found, mounting, board)
        moves = with_noise(moves, noise, mounting.T_arm_obj, middle_of(board))
    papers = board_papers(board)
    problem = Problem(
        numbers,
        tuple(
            without_line(view) if p in lines.left_out else _sorted(view, found, p, lines.plane)
            for p, view in enumerate(views)
        ),
        moves,
        _touches(inputs, mounting.T_arm_obj, len(papers.names), noise),
        papers,
        *inputs.size_px,
    ).without_poses(mounting.contradicts)
    start = State(
        unplaced(found.cameras[0]),
        lines.plane,
        mounting.T_flange_cam,
        mounting.T_arm_obj,
        found.coordinates,
        np.zeros(moves.by_links.shape[2]),
        np.zeros((len(problem.views), moves.by_noise.shape[2])),
    )
    lines_out = {numbers[p]: float(abs(lines.off_mm[p])) for p in lines.left_out}
    apart = {numbers[p]: float(abs(lines.off_mm[p])) for p in lines.apart}
    return _Start(problem, start, mounting, size, lines_out, apart)


def _robot_noise(
    found: Bundle, mounting: Mounting, board: Chessboard
) -> tuple[Mounting, RobotNoise]:
    """A robot's noise, told by the poses that do not contradict; those astray do not either."""
    start = mounting.T_flange_cam, mounting.T_arm_obj
    every = PosesSeen(mounting.T_arm_flange, mounting.T_cam_obj, found.covariance, middle_of(board))
    while True:
        agree = np.flatnonzero(~mounting.contradicts)
        seen = every.only(agree)
        stray = astray(seen, *start)
        if stray is None or 2 * (len(agree) - 1) <= len(mounting.contradicts):
            return mounting, robot_noise(seen, *start)
        contradicts = mounting.contradicts.copy()
        contradicts[agree[stray]] = True
        mounting = replace(mounting, contradicts=contradicts)


def _touches(
    inputs: BoardInputs, T_arm_obj: Floats, coordinates: int, noise: RobotNoise | None
) -> Touches | None:
    """Contacts on the bent sheet, where the pictures put it.

    Args:
        noise: of a robot; an arm with joints has its own.

    Raises:
        Refusal: they do not lie on it.
    """
    if inputs.contact_readings is None or not len(inputs.contact_readings):
        return None
    touches = plane_touches(inputs.arm, FEATURE, inputs.contact_readings, coordinates, noise)
    in_obj = apply(inverse(T_arm_obj), touches.tips_mm)
    off_mm = in_obj[:, 2] - touches.radius_mm
    usual = float(np.median(off_mm))
    if abs(usual) > CONTACTS_OFF_MM:
        raise Refusal(
            "contacts-off-board",
            f"the {len(touches)} contacts lie {usual:+.1f} mm off the board that the pictures show",
            f"the limit is {CONTACTS_OFF_MM:g} mm",
            "check square_mm, the tip in arm.json, and that the board was not moved",
        )
    by_bend = np.zeros((len(touches), coordinates))
    by_bend[:, bend_of(inputs.board)] = shapes(inputs.board).by_strength(in_obj[:, :2])
    kept = np.abs(off_mm - usual) < CONTACT_STRAY_MM
    return replace(touches, offset_by_coordinates=by_bend, kept=kept)


def _view(pose: SeenBoard, board: Chessboard) -> BoardView:
    none = np.zeros(len(pose.stripe.u), dtype=np.bool_)
    return BoardView(board, pose.detection, pose.stripe, none)


def _sorted(view: BoardView, found: Bundle, pose: int, in_cam: LaserPlane) -> BoardView:
    """With the line's points judged by a plane in the camera's frame."""
    camera = found.cameras[pose]
    n, t = in_cam.normal, camera.translation_mm
    plane = LaserPlane(camera.rotation.T @ n, float(in_cam.offset_mm - n @ t))
    return view.sorted_anew(camera, plane, found.coordinates)


def _refuse_contradictions(mounting: Mounting, numbers: Sequence[int]) -> None:
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


def _adjusted(inputs: BoardInputs, start: _Start) -> tuple[Adjusted, Mounting]:
    """Adjusted twice: poses that are astray, the lines' points and how much they count, all
    weights and the lens terms that are significant are told by the first result, as the start
    was too coarse."""
    found = adjust(start.problem, start.state)
    found, mounting = without_strays(found, start.mounting, inputs.board.size_mm)
    again = sorted_anew(found)
    if not start.apart:
        off_mm, off_rad = scatter_told(found)
        views = [
            replace(view, line_off_mm=float(off_mm), line_off_rad=float(off_rad))
            for view in again.views
            if isinstance(view, BoardView)
        ]
        again = replace(again, views=tuple(views))
    return adjust(again, found.state), mounting


def _assembled(inputs: BoardInputs, found: Adjusted, start: _Start) -> BoardCalibration:
    state = found.state
    T_cam_sensor = inverse(found.problem.motion.T_arm_flange[0] @ state.T_flange_cam)
    T_cam_sensor = T_cam_sensor @ state.T_arm_obj
    worth = _named_for(inputs.arm, known(found, T_cam_sensor))
    camera, plane, T_flange_sensor = sensor_of(state, T_cam_sensor)
    poses = _pose_results(inputs, found, start)
    contacts = board_contacts(found)
    stripe = np.concatenate([view.stripe_px() for view in found.problem.views])
    points = sensor_points(state.camera, state.plane, stripe)
    distance = np.linalg.norm(points[np.isfinite(points).all(axis=1)], axis=1)
    evidence = BoardEvidence(
        inputs.board,
        inputs.seen,
        found,
        worth,
        poses,
        inputs.limits,
        start.size,
        start.apart,
        contacts,
    )
    return BoardCalibration(
        found,
        camera,
        plane,
        T_flange_sensor,
        state.T_arm_obj,
        corners_at(inputs.board, state.coordinates),
        poses,
        worth,
        contacts,
        1e3 * stripe_rms_mm(found),
        (float(distance.min()), float(distance.max())),
        board_findings(evidence),
        board_worst(found, poses, contacts),
    )


def _named_for(arm: Arm | RobotArm, worth: Known) -> Known:
    """The budget with a robot's own share by its name."""
    if isinstance(arm, Arm):
        return worth
    rows = tuple(
        replace(row, source=ROBOT_ROW) if row.source == "arm encoders" else row
        for row in worth.rows
        if row.source != "arm geometry"
    )
    return replace(worth, rows=rows)


def _pose_results(inputs: BoardInputs, found: Adjusted, start: _Start) -> tuple[PoseResult, ...]:
    """Of the poses used, of those that contradict, and of those that show no board."""
    results = [PoseResult(one.number, False, str(one.refusal).rstrip(".")) for one in inputs.unseen]
    numbers = [pose.number for pose in inputs.seen]
    readings = "joint angles" if isinstance(inputs.arm, Arm) else "robot's pose"
    results += left_out(numbers, start.mounting, readings)
    for pose in board_pose_results(found, inputs.seen, inputs.board):
        off_mm = start.lines_out.get(pose.number)
        line_out = (
            ""
            if off_mm is None
            else f"its laser line was left out, {off_mm:.1f} mm off the plane on which the others"
            " agree"
        )
        results.append(replace(pose, reason=line_out))
    return tuple(sorted(results, key=lambda pose: pose.number))
