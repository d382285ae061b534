"""The adjustment problem of a calibration on a chessboard, and its start values."""

from dataclasses import dataclass, replace

import numpy as np

from crenel.errors import OperationError
from crenel.messages.limits import beside_limit
from crenel.messages.message import message
from crenel.metrology.adjustment.board.bundle import Bundle, adjust_bundle, with_identity_pose
from crenel.metrology.adjustment.board.initial_guess import (
    BoardObservation,
    board_camera,
    number_corners,
    refuse_other_size,
)
from crenel.metrology.adjustment.board.laser_lines import (
    NO_LINES,
    LaserLines,
    fit_laser_lines,
    refuse_few_lines,
)
from crenel.metrology.adjustment.board.observations import BoardView
from crenel.metrology.adjustment.board.pose_judgement import (
    judge_robot_poses,
    readmit_predicted_poses,
)
from crenel.metrology.adjustment.board.surface import bend_modes, bend_slice, board_prior
from crenel.metrology.adjustment.core.arm_errors import FlangeMotion
from crenel.metrology.adjustment.core.arm_readings import flange_motion, plane_contacts
from crenel.metrology.adjustment.core.focal_differences import refuse_focal_differences
from crenel.metrology.adjustment.core.hand_eye import (
    Mounting,
    mounting_by_motion,
    refuse_alike,
    refuse_contradictions,
)
from crenel.metrology.adjustment.core.observations import (
    AdjustmentProblem,
    ContactObservations,
    FailedPose,
)
from crenel.metrology.adjustment.core.parameters import AdjustmentState
from crenel.metrology.adjustment.core.robot_noise import RobotNoise, with_noise
from crenel.metrology.arm.kinematics import Arm, RobotArm
from crenel.metrology.limits import LIMITS, Limits
from crenel.metrology.robust import median
from crenel.metrology.sensor.laser_plane import LaserPlane
from crenel.metrology.targets.chessboard import Chessboard, corner_points, pattern_centre
from crenel.metrology.transforms import Floats, apply, inverse, rigid

# The only face for probing: the plane of the board.
FEATURE = "board"
# Largest distance of contact points from the board of the pictures before these are adjusted, and
# of a single contact point from the others.
CONTACTS_OFF_MM, CONTACT_OUTLIER_MM = 3.0, 1.0


@dataclass(frozen=True)
class BoardInputs:
    """The input of a calibration over P poses of one board that has not moved.

    ``readings`` (P, ...) belong to ``observations``, ``contact_readings`` (N, ...) to contact
    points on the plane of the board; both are as in ``arm_readings.py``. Without ``with_laser``,
    camera and mounting alone are calibrated, whatever line the pictures show.
    """

    arm: Arm | RobotArm
    board: Chessboard
    observations: tuple[BoardObservation, ...]
    readings: Floats
    size_px: tuple[int, int]
    contact_readings: Floats | None = None
    failed_poses: tuple[FailedPose, ...] = ()
    limits: Limits = LIMITS
    with_laser: bool = True


@dataclass(frozen=True)
class BoardStart:
    """The problem, its start values, and what was found while building it.

    ``crossed`` are the numbers of the poses whose laser line counts. ``excluded_lines_mm`` gives
    the distance of excluded lines by pose number, ``contradicting_lines_mm`` that of lines that
    contradict but count. ``laser_moved`` says that these are too many to be mistakes.
    ``scatter_px`` is that of the corners of each picture, before any pose is left out.
    """

    problem: AdjustmentProblem
    state: AdjustmentState
    mounting: Mounting
    crossed: frozenset[int]
    excluded_lines_mm: dict[int, float]
    contradicting_lines_mm: dict[int, float]
    laser_moved: bool
    scatter_px: Floats


@dataclass(frozen=True)
class PlacedBoard:
    """The pictures, adjusted alone, and the mounting on which they and the arm's poses agree."""

    views: list[BoardView]
    found: Bundle
    moves: FlangeMotion
    mounting: Mounting


def place_board(inputs: BoardInputs) -> PlacedBoard:
    """What pictures and poses say without the laser.

    Args:
        inputs: numbered alike, as from ``number_boards``.

    Raises:
        OperationError: the poses or the pictures are insufficient or contradict each other.
    """
    board = inputs.board
    moves = flange_motion(inputs.arm, inputs.readings)
    numbers = tuple(pose.number for pose in inputs.observations)
    views, found = adjust_pictures(inputs)
    T_cam_obj = np.array([rigid(one.rotation, one.translation_mm) for one in found.cameras])
    mounting = mounting_by_motion(moves.T_arm_flange, T_cam_obj, board.size_mm)
    refuse_focal_differences(mounting, corner_points(board)[[0, -1]], numbers)
    refuse_other_size(mounting, board)
    mounting = readmit_predicted_poses(found, mounting, board)
    refuse_contradictions(mounting, numbers, "board")
    return PlacedBoard(views, found, moves, mounting)


def board_problem(inputs: BoardInputs, placed: PlacedBoard) -> BoardStart:
    """The problem without data that contradict the rest, and its start values.

    Args:
        inputs: numbered alike, as from ``number_boards``.
        placed: from the same inputs.

    Raises:
        OperationError: the lines are insufficient or contradict each other.
    """
    board, arm = inputs.board, inputs.arm
    views, found, moves, mounting = placed.views, placed.found, placed.moves, placed.mounting
    numbers = tuple(pose.number for pose in inputs.observations)
    lines = fit_laser_lines(views, found, numbers) if inputs.with_laser else NO_LINES
    noise = None
    if isinstance(arm, RobotArm):
        mounting, noise = judge_robot_poses(found, mounting, board)
        moves = with_noise(moves, noise, mounting.T_arm_obj, pattern_centre(board))
    prior = replace(board_prior(board), sd=found.surface_prior.sd)
    problem = AdjustmentProblem(
        numbers,
        tuple(_with_line(view, found, p, lines) for p, view in enumerate(views)),
        moves,
        _contact_observations(inputs, mounting.T_arm_obj, len(prior.names), noise),
        prior,
        *inputs.size_px,
        inputs.with_laser,
    ).without_poses(mounting.contradicts)
    crossed = frozenset(numbers[p] for p in lines.counting)
    if inputs.with_laser:
        refuse_few_lines(len(crossed.intersection(problem.numbers)), len(problem.numbers))
    state = AdjustmentState(
        with_identity_pose(found.cameras[0]),
        lines.plane or _plane_across_view(mounting.T_cam_obj, pattern_centre(board)),
        mounting.T_flange_cam,
        mounting.T_arm_obj,
        found.coordinates,
        np.zeros(moves.by_links.shape[2]),
        np.zeros((len(problem.views), moves.by_noise.shape[2])),
    )
    lines_out = {numbers[p]: float(abs(lines.off_mm[p])) for p in lines.excluded}
    apart = {numbers[p]: float(abs(lines.off_mm[p])) for p in lines.contradicting}
    return BoardStart(
        problem,
        state,
        mounting,
        crossed,
        lines_out,
        apart,
        lines.laser_moved,
        found.scatter_px,
    )


def number_boards(inputs: BoardInputs) -> BoardInputs:
    """The input with the corners of all pictures numbered alike, without the pictures of which
    neither the board nor the arm tells the numbering.

    Raises:
        OperationError: as ``number_corners`` and ``board_camera``; poses that are all alike.
    """
    board, seen = inputs.board, inputs.observations
    T_arm_flange = flange_motion(inputs.arm, inputs.readings).T_arm_flange
    refuse_alike(T_arm_flange)
    camera, _ = board_camera(seen, board, inputs.size_px)
    numbered = number_corners(seen, board, camera, T_arm_flange)
    kept = [p for p, one in enumerate(numbered) if isinstance(one, BoardObservation)]
    return replace(
        inputs,
        observations=tuple(one for one in numbered if isinstance(one, BoardObservation)),
        readings=inputs.readings[kept],
        failed_poses=(
            *inputs.failed_poses,
            *(one for one in numbered if isinstance(one, FailedPose)),
        ),
    )


def adjust_pictures(inputs: BoardInputs) -> tuple[list[BoardView], Bundle]:
    """Bundle adjustment of the corners of all pictures, numbered alike."""
    board = inputs.board
    camera, T_cam_obj = board_camera(inputs.observations, board, inputs.size_px)
    views = [_view(pose, board) for pose in inputs.observations]
    found = adjust_bundle(
        views,
        [replace(camera, rotation=T[:3, :3], translation_mm=T[:3, 3]) for T in T_cam_obj],
    )
    pairs = zip(views, found.scatter_px, strict=True)
    return [replace(view, scatter_px=float(px)) for view, px in pairs], found


def _contact_observations(
    inputs: BoardInputs, T_arm_obj: Floats, coordinates: int, noise: RobotNoise | None
) -> ContactObservations | None:
    """Contact points on the bent surface, as the pictures place it.

    Args:
        noise: the noise of a robot; None for an arm with joints.

    Raises:
        OperationError: they do not lie on the surface.
    """
    if inputs.contact_readings is None or not len(inputs.contact_readings):
        return None
    touches = plane_contacts(inputs.arm, FEATURE, inputs.contact_readings, coordinates, noise)
    in_obj = apply(inverse(T_arm_obj), touches.tips_mm)
    off_mm = in_obj[:, 2] - touches.radius_mm
    usual = median(off_mm)
    if abs(usual) > CONTACTS_OFF_MM:
        off, limit = beside_limit(usual, CONTACTS_OFF_MM, "mm", 1, signed=True)
        raise OperationError(
            "contacts-off-board",
            message(
                "contacts-lie-off-board-pictures-show",
                touches=len(touches),
                usual=off,
            ),
            message("limit-is-value", limit=limit),
            message("check-square-tip-and-board-not-moved"),
        )
    by_bend = np.zeros((len(touches), coordinates))
    by_bend[:, bend_slice(inputs.board)] = bend_modes(inputs.board).by_strength(in_obj[:, :2])
    kept = np.abs(off_mm - usual) < CONTACT_OUTLIER_MM
    return replace(touches, offset_by_coordinates=by_bend, inliers=kept)


def _view(pose: BoardObservation, board: Chessboard) -> BoardView:
    none = np.zeros(len(pose.stripe.u), dtype=np.bool_)
    return BoardView(board, pose.detection, pose.stripe, none)


def _plane_across_view(T_cam_obj: Floats, middle_mm: Floats) -> LaserPlane:
    """The plane across the camera's view at the usual distance of the board's middle (3,)."""
    depth_mm = median(T_cam_obj[:, 2, :3] @ middle_mm + T_cam_obj[:, 2, 3])
    return LaserPlane(np.array([0.0, 0.0, 1.0]), depth_mm)


def _with_line(view: BoardView, found: Bundle, pose: int, lines: LaserLines) -> BoardView:
    """The problem with the line points judged by their plane, or without a line that is
    excluded."""
    if lines.plane is None:
        return view.without_line()
    view = replace(view, line_off_mm=lines.scatter_mm, line_off_rad=lines.scatter_rad)
    if pose in lines.excluded:
        return view.without_line()
    camera = found.cameras[pose]
    T_cam_obj = rigid(camera.rotation, camera.translation_mm)
    plane = lines.plane.in_frame(inverse(T_cam_obj))
    return view.reclassify_stripe(camera, plane, found.coordinates)
