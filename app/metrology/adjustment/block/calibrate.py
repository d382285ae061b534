"""The calibration over many poses: contact points and pictures of one block in one adjustment.

With one pose alone, this is the article's method (Eq. 5-8) with the arm's errors included.
"""

from dataclasses import dataclass, replace

import numpy as np

from app.errors import OperationError
from app.messages.message import Text, message
from app.metrology.adjustment.block.findings import BlockEvidence, block_findings
from app.metrology.adjustment.block.initial_guess import common_camera, estimate_block_pose
from app.metrology.adjustment.block.laser_lines import (
    fit_common_plane,
    remove_outlier_lines,
    without_lines,
)
from app.metrology.adjustment.block.observations import BlockView, block_contacts, block_prior
from app.metrology.adjustment.core.arm_errors import arm_motion
from app.metrology.adjustment.core.gauss_newton import (
    AdjustmentResult,
    no_convergence_error,
    solve_adjustment,
)
from app.metrology.adjustment.core.hand_eye import (
    Mounting,
    mounting_by_contacts,
    refuse_contradictions,
)
from app.metrology.adjustment.core.observations import (
    AdjustmentProblem,
    BlockObservation,
    FailedPose,
    require_observations,
)
from app.metrology.adjustment.core.parameters import AdjustmentState
from app.metrology.adjustment.core.uncertainty import (
    CalibrationUncertainty,
    estimate_uncertainty,
    express_in_sensor_frame,
)
from app.metrology.adjustment.outliers.poses import remove_outlier_poses
from app.metrology.adjustment.results.poses import (
    NO_LINE,
    PoseResult,
    block_worst_points,
    line_exclusion_reason,
    outlier_pose_results,
    pose_results,
)
from app.metrology.adjustment.results.stripes import (
    depth_range_mm,
    reclassify_stripes,
    stripe_rms_mm,
)
from app.metrology.arm.kinematics import Arm, tip_centres, tip_covariances
from app.metrology.calibration.findings import CalibrationFinding, WorstResidual
from app.metrology.calibration.laser_plane_fit import stripe_on_levels
from app.metrology.detection.detect_block import detect_object
from app.metrology.detection.image_quality import image_findings
from app.metrology.image import Image
from app.metrology.limits import LIMITS, Limits
from app.metrology.probing.alignment import Alignment, align, refuse_wrong_faces
from app.metrology.sensor.camera import Camera
from app.metrology.sensor.laser_plane import LaserPlane, in_frame
from app.metrology.stripe import extract_stripe
from app.metrology.targets.crenellated_block import Crenellated
from app.metrology.transforms import Floats, inverse
from app.progress import Progress, no_progress

# Larger values are treated as unknown.
HOPELESS_UM = 1e6


@dataclass(frozen=True)
class BlockInputs:
    """The input of a calibration over P poses of one block that has not moved.

    ``q_rad`` (P, n) belongs to ``seen``; ``unseen`` are poses without a usable picture.
    """

    arm: Arm
    block: Crenellated
    features: tuple[str, ...]  # (N) face of each contact point
    contact_q_rad: Floats  # (N, n)
    observations: tuple[BlockObservation, ...]
    q_rad: Floats
    failed_poses: tuple[FailedPose, ...] = ()
    limits: Limits = LIMITS


@dataclass(frozen=True)
class BlockCalibration:
    """A calibration and the data it is based on.

    The sensor frame is the object frame as the first used pose saw it (Eq. 6). This choice makes
    one pose give the same frame as the article.
    """

    adjustment: AdjustmentResult
    alignment: Alignment
    camera: Camera
    plane: LaserPlane
    T_flange_sensor: Floats
    T_arm_obj: Floats
    poses: tuple[PoseResult, ...]
    uncertainty: CalibrationUncertainty
    stripe_rms_um: float  # of the stripe points to the laser plane
    depth_range_mm: tuple[float, float]
    findings: tuple[CalibrationFinding, ...]
    worst: tuple[WorstResidual, ...]


def observe_block(
    number: int, block: Crenellated, ambient: Image, laser: Image | None, axis: str
) -> BlockObservation:
    """What the images of one pose show, each pose on its own.

    Args:
        number: of the pose.
        block: the block by its certificate.
        ambient: (H, W) grey with ambient light; with both lights where ``laser`` is None.
        laser: (H, W) grey with the laser alone.
        axis: along which stripe points are counted, see ``extract_stripe``.

    Returns:
        Detection and stripe in px; the stripe may be empty.

    Raises:
        OperationError: as ``detect_object`` and ``extract_stripe``.
    """
    lit = ambient if laser is None else laser
    in_the_way = extract_stripe(lit, axis) if laser is None else None
    detection = detect_object(ambient, block, in_the_way)
    stripe = stripe_on_levels(detection.camera, block, lit, axis)
    return BlockObservation(number, detection, stripe, tuple(image_findings(ambient)))


def calibrate_block(inputs: BlockInputs, progress: Progress = no_progress) -> BlockCalibration:
    """Camera, laser plane and probe matrix from all poses and contact points together.

    One adjustment by maximum likelihood: the pose and the certificate of the block, the camera,
    the laser plane, the mounting, the errors of the arm's links and encoders. The noise levels
    are estimated from the data (variance components).

    Args:
        inputs: P >= 1 poses and N contact points of one block that has not moved.
        progress: called with the share done, 0 to 1, and the current step.

    Returns:
        The calibration with uncertainty budget (k = 1, µm), residuals and findings. Its sensor
        frame is the object frame as the first used pose saw it (Eq. 6).

    Raises:
        OperationError: inputs that do not belong together (``joint-count``,
            ``angles-not-finite``, ``image-size``); ``no-images``, or the error of the first pose
            where none shows the block; ``poses-contradict``, ``lines-contradict``;
            ``too-few-corners``, ``object-not-placed``, ``too-few-edges``, ``adjustment-failed``;
            and as ``align``, ``refuse_wrong_faces``, ``fit_laser_plane`` and ``fit_camera``.

    Source:
        With one pose, Eq. 5 to 8 of the article, with the errors of the arm taken into account.
    """
    _refuse_unusable(inputs)
    progress(0.0, message("fitting-contact-points"))
    alignment = _align_contacts(inputs)
    progress(0.1, message("finding-start"))
    start = _initial_problem(inputs, alignment)
    progress(0.3, message("adjusting-all-poses-together"))
    found = _adjust_twice(start.problem, start.state)
    found, mounting = remove_outlier_poses(found, start.mounting, block_size_mm(inputs.block))
    found, outlier_lines_mm = remove_outlier_lines(found)
    progress(0.8, message("working-out-uncertainty"))
    result = _assemble_result(
        inputs, alignment, found, mounting, start.excluded_lines_mm | outlier_lines_mm
    )
    progress(1.0, message("done"))
    return result


def _align_contacts(inputs: BlockInputs) -> Alignment:
    tips = tip_centres(inputs.arm, inputs.contact_q_rad)
    noise = tip_covariances(inputs.arm, inputs.contact_q_rad)
    weighed = noise if np.any(noise) else None
    alignment = align(inputs.features, tips, inputs.arm.tip.radius_mm, inputs.block, weighed)
    refuse_wrong_faces(alignment, inputs.features, inputs.block)
    return alignment


@dataclass(frozen=True)
class _Start:
    """The problem, its start values, and what was excluded before: poses that contradict the
    others, and laser lines by pose number with their distance (mm) from the laser plane."""

    problem: AdjustmentProblem
    state: AdjustmentState
    mounting: Mounting
    excluded_lines_mm: dict[int, float]


def _initial_problem(inputs: BlockInputs, alignment: Alignment) -> _Start:
    """The problem without poses that contradict the others, and its start values."""
    arm, block = inputs.arm, inputs.block
    camera, plane = common_camera(inputs.observations, block)
    T_cam_obj = np.array([estimate_block_pose(camera, pose, block) for pose in inputs.observations])
    plane, lines_out = fit_common_plane(inputs.observations, block, camera, T_cam_obj, plane)
    moves = arm_motion(arm, inputs.q_rad)
    mounting = mounting_by_contacts(
        moves.T_arm_flange, T_cam_obj, alignment.T_arm_obj, block_size_mm(block)
    )
    refuse_contradictions(mounting, [pose.number for pose in inputs.observations], "object")
    prior = block_prior(block)
    views = tuple(
        _view(pose, block, camera, plane, T)
        for pose, T in zip(inputs.observations, T_cam_obj, strict=True)
    )
    problem = AdjustmentProblem(
        tuple(pose.number for pose in inputs.observations),
        views,
        moves,
        block_contacts(arm, block, inputs.features, inputs.contact_q_rad, ~alignment.outliers),
        prior,
        camera.width_px,
        camera.height_px,
    )
    problem = without_lines(problem, lines_out).without_poses(mounting.contradicts)
    start = AdjustmentState(
        camera,
        plane,
        mounting.T_flange_cam,
        mounting.T_arm_obj,
        prior.coordinates,
        np.zeros(moves.by_links.shape[2]),
        np.zeros((len(problem.views), moves.by_noise.shape[2])),
    )
    return _Start(problem, start, mounting, lines_out)


def block_size_mm(block: Crenellated) -> float:
    """The diagonal of the block from floor to crest; converts angles into lengths."""
    return float(
        np.linalg.norm(
            [
                block.edges_x_mm[-1] - block.edges_x_mm[0],
                block.back_y_mm - block.front_y_mm,
                block.crest_z_mm - block.floor_z_mm,
            ]
        )
    )


def _view(
    pose: BlockObservation, block: Crenellated, camera: Camera, plane: LaserPlane, T_cam_obj: Floats
) -> BlockView:
    """The view of the pose, with the stripe points sorted by the pose's own detection of the
    block."""
    found = pose.detection
    view = BlockView(
        block, found.edges, found.corners, pose.stripe, np.full(len(pose.stripe.u), "", "<U5")
    )
    placed, in_obj = in_frame(camera, plane, inverse(T_cam_obj))
    return view.reclassify_stripe(placed, in_obj, block_prior(block).coordinates)


def _adjust_twice(problem: AdjustmentProblem, start: AdjustmentState) -> AdjustmentResult:
    """Adjusts, sorts the stripe points by the result, and adjusts again if the sorting changed."""
    found = solve_adjustment(problem, start)
    again = reclassify_stripes(found)
    same = all(
        len(a.stripe_px()) == len(b.stripe_px())
        for a, b in zip(problem.views, again.views, strict=True)
    )
    return found if same else solve_adjustment(again, found.state)


def _assemble_result(
    inputs: BlockInputs,
    alignment: Alignment,
    found: AdjustmentResult,
    mounting: Mounting,
    lines_out: dict[int, float],
) -> BlockCalibration:
    state = found.state
    T_arm_flange = found.problem.motion.T_arm_flange[0]
    T_cam_sensor = inverse(T_arm_flange @ state.T_flange_cam) @ state.T_arm_obj
    worth = estimate_uncertainty(found, T_cam_sensor)
    if not worth.total_um < HOPELESS_UM:
        raise no_convergence_error()
    camera, plane, T_flange_sensor = express_in_sensor_frame(state, T_cam_sensor)
    used = [
        replace(pose, reason=_line_problem(pose, lines_out))
        for pose in pose_results(found, inputs.observations, inputs.block)
    ]
    out = outlier_pose_results([pose.number for pose in inputs.observations], mounting)
    unseen = [PoseResult(one.number, False, one.error.text) for one in inputs.failed_poses]
    poses = tuple(sorted((*used, *out, *unseen), key=lambda pose: pose.number))
    evidence = BlockEvidence(
        inputs.block,
        alignment,
        inputs.features,
        inputs.observations,
        found,
        worth,
        poses,
        lines_out,
        inputs.limits,
    )
    return BlockCalibration(
        found,
        alignment,
        camera,
        plane,
        T_flange_sensor,
        state.T_arm_obj,
        poses,
        worth,
        1e3 * stripe_rms_mm(found),
        depth_range_mm(found),
        block_findings(evidence),
        block_worst_points(found, alignment, inputs.features, used),
    )


def _line_problem(pose: PoseResult, lines_out: dict[int, float]) -> Text:
    """Problems with the laser line of a pose that was used, if any."""
    if pose.number in lines_out:
        return line_exclusion_reason(lines_out[pose.number])
    return "" if pose.stripe_points else NO_LINE


def _refuse_unusable(inputs: BlockInputs) -> None:
    require_observations(inputs.observations, inputs.failed_poses, "object")
    joints = inputs.arm.joint_count
    for name, q in ((message("poses"), inputs.q_rad), (message("contacts"), inputs.contact_q_rad)):
        if q.ndim != 2 or q.shape[1] != joints:
            raise OperationError(
                "joint-count",
                message("joint-angles", name=name, count=q.shape[-1]),
                message("arm-has-joints", arm=inputs.arm.name, count=joints),
                message("check-session-taken-arm"),
            )
        if not np.isfinite(q).all():
            raise OperationError("angles-not-finite", message("joint-angle-number", name=name))
    sizes = {
        (p.detection.camera.width_px, p.detection.camera.height_px) for p in inputs.observations
    }
    if len(sizes) > 1:
        raise OperationError(
            "image-size",
            message(
                "pictures-different-sizes",
                sizes=", ".join(f"{width} × {height}" for width, height in sorted(sizes)),
            ),
            message("they-come-more-than-one-camera"),
            message("use-full-pictures-one-sensor"),
        )
