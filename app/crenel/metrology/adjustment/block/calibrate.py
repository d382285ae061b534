"""The calibration over many poses: contact points and pictures of one block in one adjustment.

With one pose alone, this is the article's method (Eq. 5-8) with the arm's errors included.
"""

from dataclasses import dataclass, replace

from crenel.messages.message import Text, message
from crenel.metrology.adjustment.block.findings import BlockEvidence, block_findings
from crenel.metrology.adjustment.block.laser_lines import remove_outlier_lines
from crenel.metrology.adjustment.block.problem import (
    BlockInputs,
    block_problem,
    refuse_unusable,
)
from crenel.metrology.adjustment.core.gauss_newton import (
    AdjustmentResult,
    no_convergence_error,
    solve_adjustment,
)
from crenel.metrology.adjustment.core.hand_eye import Mounting
from crenel.metrology.adjustment.core.observations import AdjustmentProblem, BlockObservation
from crenel.metrology.adjustment.core.parameters import AdjustmentState
from crenel.metrology.adjustment.core.uncertainty import (
    estimate_uncertainty,
    express_in_sensor_frame,
)
from crenel.metrology.adjustment.outliers.poses import remove_outlier_poses
from crenel.metrology.adjustment.results.calibration import AdjustedCalibration, first_view
from crenel.metrology.adjustment.results.poses import (
    NO_LINE,
    PoseResult,
    block_worst_points,
    line_exclusion_reason,
    outlier_pose_results,
    pose_results,
)
from crenel.metrology.adjustment.results.stripes import (
    depth_range_mm,
    reclassify_stripes,
    stripe_rms_mm,
)
from crenel.metrology.calibration.laser_plane_fit import stripe_on_levels
from crenel.metrology.detection.detect_block import detect_object
from crenel.metrology.detection.image_quality import pose_findings
from crenel.metrology.detection.stripe_mask import stripe_in_the_way
from crenel.metrology.image import Image
from crenel.metrology.probing.alignment import Alignment, align_contacts
from crenel.metrology.stripe import ANYWHERE, LineSearch, picture_with_line
from crenel.metrology.targets.crenellated_block import Crenellated
from crenel.progress import Progress, no_progress

# Larger values are treated as unknown.
HOPELESS_UM = 1e6


@dataclass(frozen=True, kw_only=True)
class BlockCalibration(AdjustedCalibration):
    """On a block, and where the contacts have that."""

    alignment: Alignment


def observe_block(
    number: int,
    block: Crenellated,
    ambient: Image,
    laser: Image | None,
    axis: str,
    search: LineSearch = ANYWHERE,
) -> BlockObservation:
    """What the images of one pose show, each pose on its own.

    Args:
        number: of the pose.
        block: the block by its certificate.
        ambient: (H, W) grey with ambient light; with both lights where ``laser`` is None.
        laser: (H, W) grey with the laser; a lit room is taken off by ``ambient``.
        axis: along which stripe points are counted, see ``extract_stripe``.
        search: what is said of the line.

    Returns:
        Detection and stripe in px; the stripe may be empty.

    Raises:
        OperationError: as ``detect_object`` and ``extract_stripe``.
    """
    in_the_way = stripe_in_the_way(ambient, axis, search) if laser is None else None
    detection = detect_object(ambient, block, in_the_way)
    alone = picture_with_line(ambient, laser)
    stripe = stripe_on_levels(detection.camera, block, alone, axis, search)
    findings = tuple(pose_findings(ambient, alone))
    return BlockObservation(number, detection, stripe, findings)


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
            ``angles-not-finite``, ``image-size``); ``no-images``, or the commonest error
            where none shows the block; ``poses-contradict``, ``lines-contradict``;
            ``too-few-corners``, ``object-not-placed``, ``too-few-edges``, ``adjustment-failed``;
            and as ``align``, ``refuse_wrong_faces``, ``fit_laser_plane`` and ``fit_camera``.

    Source:
        With one pose, Eq. 5 to 8 of the article, with the errors of the arm taken into account.
    """
    refuse_unusable(inputs)
    progress(0.0, message("fitting-contact-points"))
    alignment = align_contacts(inputs.arm, inputs.block, inputs.features, inputs.contact_q_rad)
    progress(0.1, message("finding-start"))
    start = block_problem(inputs, alignment)
    progress(0.3, message("adjusting-all-poses-together"))
    found = _adjust_twice(start.problem, start.state)
    found, mounting = remove_outlier_poses(found, start.mounting, inputs.block.size_mm)
    found, outlier_lines_mm = remove_outlier_lines(found)
    progress(0.8, message("working-out-uncertainty"))
    result = _assemble_result(
        inputs, alignment, found, mounting, start.excluded_lines_mm | outlier_lines_mm
    )
    progress(1.0, message("done"))
    return result


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
    T_cam_sensor = first_view(found)
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
        adjustment=found,
        alignment=alignment,
        camera=camera,
        plane=plane,
        T_flange_sensor=T_flange_sensor,
        T_arm_obj=state.T_arm_obj,
        poses=poses,
        uncertainty=worth,
        stripe_rms_um=1e3 * stripe_rms_mm(found),
        depth_range_mm=depth_range_mm(found),
        findings=block_findings(evidence),
        worst=block_worst_points(found, alignment, inputs.features, used),
    )


def _line_problem(pose: PoseResult, lines_out: dict[int, float]) -> Text:
    """Problems with the laser line of a pose that was used, if any."""
    if pose.number in lines_out:
        return line_exclusion_reason(lines_out[pose.number])
    return "" if pose.stripe_points else NO_LINE
