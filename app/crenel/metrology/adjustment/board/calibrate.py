"""The calibration on a flat chessboard: pictures, and contact points if any, in one adjustment.

Without contact points, the board's pose in the arm frame is estimated with everything else.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from crenel.errors import OperationError
from crenel.messages.message import Text, message, quantity
from crenel.metrology.adjustment.board.faults.explain import explain_poses, refuse_misread_poses
from crenel.metrology.adjustment.board.findings import ROBOT_ROW, BoardEvidence, board_findings
from crenel.metrology.adjustment.board.initial_guess import BoardObservation
from crenel.metrology.adjustment.board.laser_lines import (
    estimate_line_scatter,
    line_scatter,
    refuse_few_lines,
    with_line_scatter,
)
from crenel.metrology.adjustment.board.problem import (
    BoardInputs,
    BoardStart,
    board_problem,
    number_boards,
    place_board,
)
from crenel.metrology.adjustment.board.results import (
    BoardContacts,
    board_contacts,
    board_pose_results,
    board_worst_points,
)
from crenel.metrology.adjustment.board.surface import corners_at
from crenel.metrology.adjustment.core.gauss_newton import AdjustmentResult, solve_adjustment
from crenel.metrology.adjustment.core.hand_eye import Mounting
from crenel.metrology.adjustment.core.kept_sensor import KeptSensor
from crenel.metrology.adjustment.core.observations import PICTURE_TWICE, require_observations
from crenel.metrology.adjustment.core.uncertainty import (
    CalibrationUncertainty,
    estimate_uncertainty,
    express_in_sensor_frame,
)
from crenel.metrology.adjustment.outliers.contacts import remove_outlier_contacts
from crenel.metrology.adjustment.outliers.poses import remove_outlier_poses
from crenel.metrology.adjustment.results.calibration import AdjustedCalibration, first_view
from crenel.metrology.adjustment.results.poses import (
    PoseResult,
    Readings,
    line_exclusion_reason,
    outlier_pose_results,
)
from crenel.metrology.adjustment.results.stripes import (
    depth_range_mm,
    object_depths_mm,
    reclassify_stripes,
    stripe_rms_mm,
)
from crenel.metrology.arm.kinematics import Arm, RobotArm
from crenel.metrology.chessboard.detect_board import detect_board
from crenel.metrology.chessboard.lit_line import detect_lit_board
from crenel.metrology.detection.image_quality import pose_findings
from crenel.metrology.image import Image
from crenel.metrology.sensor.camera import rays
from crenel.metrology.sensor.laser_plane import refuse_edge_on
from crenel.metrology.stripe import (
    ANYWHERE,
    ONE_OF_TWO,
    FoundLine,
    LineSearch,
    empty_stripe,
    has_second_line,
    picture_with_line,
    shows_two_lasers,
)
from crenel.metrology.targets.chessboard import Chessboard
from crenel.metrology.transforms import Floats
from crenel.progress import Progress, no_progress

# The offset of whole lines from their plane is estimated until it changes by less than this factor.
SCATTER_CONVERGED, SCATTER_ROUNDS = 1.2, 5


@dataclass(frozen=True, kw_only=True)
class BoardCalibration(AdjustedCalibration):
    """On a chessboard, and how that truly is."""

    corners_mm: Floats
    """(N, 3) where they truly are, in the board's frame."""
    contacts: BoardContacts | None
    free_scatter_px: Floats
    """(P,) scatter of the corners of each picture before the adjustment, whatever the camera."""


def observe_board(
    number: int,
    board: Chessboard,
    ambient: Image,
    laser: Image | None,
    axis: str,
    laser_on: bool = True,
    search: LineSearch = ANYWHERE,
) -> BoardObservation:
    """What the images of one pose show of a chessboard, each pose on its own.

    Args:
        number: of the pose.
        board: the board by its certificate.
        ambient: (H, W) grey with ambient light; with both lights where ``laser`` is None.
        laser: (H, W) grey with the laser; a lit room is taken off by ``ambient``.
        axis: along which stripe points are counted, see ``extract_stripe``.
        laser_on: False if the laser was off in ``ambient`` and there is no other picture.
        search: what is said of the line.

    Returns:
        Detection and stripe in px; the stripe may be empty.

    Raises:
        OperationError: as ``detect_board`` and ``extract_stripe``.
    """
    alone = picture_with_line(ambient, laser)
    image = alone.image
    if laser is None and laser_on:
        detection, line, image = detect_lit_board(ambient, board, axis, search)
    else:
        detection = detect_board(ambient, board)
        line = FoundLine(empty_stripe(axis)) if laser is None else search.find(alone, axis)
    is_one_of_two = search.settings.choice in ONE_OF_TWO
    two_lines = not is_one_of_two and has_second_line(image, line, search.where)
    findings = tuple(pose_findings(ambient, alone))
    stripe = alone.in_levels(line.stripe)
    return BoardObservation(number, detection, stripe, findings, two_lines=two_lines)


def calibrate_board(
    inputs: BoardInputs, progress: Progress = no_progress, kept: KeptSensor | None = None
) -> BoardCalibration:
    """Camera, laser plane and probe matrix from images of a chessboard, probed or not; without
    the laser, camera and probe matrix alone.

    One adjustment by maximum likelihood, as ``calibrate_block``; the bent surface of the board
    and its pose in the arm frame are estimated with everything else.

    Args:
        inputs: P poses, as joint angles or flange poses, and contact points if there are any.
        progress: called with the share done, 0 to 1, and the current step.
        kept: camera and mounting of an earlier calibration that are held; see ``add_laser``.

    Returns:
        The calibration with uncertainty budget (k = 1, µm), residuals and findings. Its sensor
        frame is the frame of the board as the first used pose saw it, or that of ``kept``.

    Raises:
        OperationError: inputs that do not belong together (``joint-count``,
            ``angles-not-finite``, ``tip-missing``); ``no-images``, or the commonest error
            where none shows the board; too few images or too similar poses
            (``too-few-images``, ``boards-parallel``, ``too-few-poses``, ``poses-alike``,
            ``poses-about-one-axis``); data that contradict each other (``poses-contradict``,
            ``poses-reversed``, ``board-ambiguous``, ``square-size``, ``lines-contradict``,
            ``contacts-off-board``); a laser that gives no plane (``two-lasers``,
            ``stripe-not-found``, ``stripe-one-line``, ``laser-along-board``,
            ``laser-through-camera``); or ``too-few-edges``, ``adjustment-failed``.
    """
    require_observations(inputs.observations, inputs.failed_poses, "board")
    if inputs.with_laser:
        _refuse_two_lasers(inputs.observations)
    progress(0.0, message("finding-start"))
    try:
        numbered = number_boards(inputs)
        placed = place_board(numbered)
    except OperationError as error:
        raise explain_poses(inputs, error) from error
    refuse_misread_poses(inputs, placed.mounting)
    inputs = numbered
    start = board_problem(inputs, placed)
    if kept is not None:
        held = replace(start.problem, keeps_sensor=True)
        start = replace(start, problem=held, state=kept.apply_to(start.state))
    progress(0.3, message("adjusting-all-poses-together"))
    found, mounting = _adjust_robustly(inputs, start)
    progress(0.8, message("working-out-uncertainty"))
    result = _assemble_result(inputs, found, replace(start, mounting=mounting), kept)
    progress(1.0, message("done"))
    return result


def _refuse_two_lasers(seen: Sequence[BoardObservation]) -> None:
    with_line = [one for one in seen if len(one.stripe.u)]
    if shows_two_lasers(one.two_lines for one in with_line):
        poses = ", ".join(str(one.number) for one in with_line if one.two_lines)
        raise OperationError(
            "two-lasers",
            message("two-lines-in-the-pictures-of-poses", poses=poses),
            message("a-laser-plane-is-of-one-laser"),
            message("switch-one-laser-off-or-cover-it"),
        )


def _adjust_robustly(inputs: BoardInputs, start: BoardStart) -> tuple[AdjustmentResult, Mounting]:
    """Adjusts twice. The first result decides outlier poses and contact points, the line points and
    their weights, all other weights and the significant lens terms, because the start values are
    too coarse for that."""
    found = solve_adjustment(start.problem, start.state)
    found, mounting = remove_outlier_poses(found, start.mounting, inputs.board.size_mm)
    numbers = found.problem.numbers
    if inputs.with_laser:
        refuse_few_lines(len(start.crossed.intersection(numbers)), len(numbers))
    found = remove_outlier_contacts(found)
    again = reclassify_stripes(found)
    if start.laser_moved or not inputs.with_laser:
        return solve_adjustment(again, found.state), mounting
    # With the start values, a line can be so far off that none of its points is usable at first.
    for _ in range(SCATTER_ROUNDS):
        before, now = line_scatter(found), estimate_line_scatter(found)
        found = solve_adjustment(with_line_scatter(again, now), found.state)
        if np.all(np.abs(np.log(now / before)) < np.log(SCATTER_CONVERGED)):
            break
    return found, mounting


def _assemble_result(
    inputs: BoardInputs, found: AdjustmentResult, start: BoardStart, kept: KeptSensor | None
) -> BoardCalibration:
    state, with_laser = found.state, inputs.with_laser
    if with_laser:
        stripes = np.concatenate([view.stripe_px() for view in found.problem.views])
        refuse_edge_on(state.plane, rays(state.camera, stripes)[1])
    T_cam_sensor = first_view(found) if kept is None else kept.sensor_pose
    found = found if kept is None else kept.carry_into(found)
    worth = _uncertainty_budget(inputs, estimate_uncertainty(found, T_cam_sensor))
    camera, plane, T_flange_sensor = express_in_sensor_frame(state, T_cam_sensor)
    poses = _pose_results(inputs, found, start)
    contacts = board_contacts(found)
    corners_mm = corners_at(inputs.board, state.coordinates)
    evidence = BoardEvidence(
        inputs.board,
        inputs.observations,
        found,
        worth,
        poses,
        inputs.limits,
        start.excluded_lines_mm if start.laser_moved else {},
        start.contradicting_lines_mm,
        contacts,
        tuple(one.number for one in inputs.failed_poses if one.error.code == PICTURE_TWICE),
    )
    return BoardCalibration(
        adjustment=found,
        camera=camera,
        plane=plane if with_laser else None,
        T_flange_sensor=T_flange_sensor,
        T_arm_obj=state.T_arm_obj,
        corners_mm=corners_mm,
        poses=poses,
        uncertainty=worth,
        contacts=contacts,
        stripe_rms_um=1e3 * stripe_rms_mm(found) if with_laser else None,
        depth_range_mm=depth_range_mm(found) if with_laser else object_depths_mm(found, corners_mm),
        findings=board_findings(evidence),
        worst=board_worst_points(found, poses, contacts),
        free_scatter_px=start.scatter_px,
    )


def _uncertainty_budget(
    inputs: BoardInputs, worth: CalibrationUncertainty
) -> CalibrationUncertainty:
    """The budget without empty contributions, with a robot's own contribution under its name."""
    robot = isinstance(inputs.arm, RobotArm)
    touched = inputs.contact_readings is not None and len(inputs.contact_readings) > 0
    rows = tuple(
        replace(row, source=ROBOT_ROW) if robot and row.source == "arm encoders" else row
        for row in worth.rows
        if not (robot and row.source == "arm geometry")
        and (touched or row.source != "contact points")
        and (inputs.with_laser or row.source != "stripe")
    )
    return replace(worth, rows=rows)


def _pose_results(
    inputs: BoardInputs, found: AdjustmentResult, start: BoardStart
) -> tuple[PoseResult, ...]:
    """The results of poses that were used, that contradict, and that show no board."""
    results = [PoseResult(one.number, False, one.error.text) for one in inputs.failed_poses]
    numbers = [pose.number for pose in inputs.observations]
    readings: Readings = "angles" if isinstance(inputs.arm, Arm) else "pose"
    results += outlier_pose_results(numbers, start.mounting, readings)
    unreadable = {one.number: one.laser_error for one in inputs.observations}
    for pose in board_pose_results(found, inputs.observations, inputs.board):
        error = unreadable[pose.number]
        reason = _line_problem(pose.number, start) if error is None else error.text
        results.append(replace(pose, reason=reason))
    return tuple(sorted(results, key=lambda pose: pose.number))


def _line_problem(number: int, start: BoardStart) -> Text:
    """Problems with the laser line of a pose that was used, if any."""
    if number in start.excluded_lines_mm:
        return line_exclusion_reason(start.excluded_lines_mm[number])
    if number in start.contradicting_lines_mm:
        off_mm = start.contradicting_lines_mm[number]
        return message("laser-line-lies-off-plane-others", off=quantity(off_mm, "mm", 1))
    return ""
