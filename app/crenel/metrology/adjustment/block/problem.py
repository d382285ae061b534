"""What is to agree in a calibration on a block, and a start for it."""

from dataclasses import dataclass

import numpy as np

from crenel.errors import OperationError
from crenel.messages.message import message
from crenel.metrology.adjustment.block.initial_guess import common_camera, estimate_block_pose
from crenel.metrology.adjustment.block.laser_lines import fit_common_plane, without_lines
from crenel.metrology.adjustment.block.observations import BlockView, block_contacts, block_prior
from crenel.metrology.adjustment.core.arm_errors import arm_motion
from crenel.metrology.adjustment.core.hand_eye import (
    Mounting,
    mounting_by_contacts,
    refuse_contradictions,
)
from crenel.metrology.adjustment.core.observations import (
    AdjustmentProblem,
    BlockObservation,
    FailedPose,
    require_observations,
)
from crenel.metrology.adjustment.core.parameters import AdjustmentState
from crenel.metrology.arm.kinematics import (
    Arm,
    refuse_other_angles,
)
from crenel.metrology.limits import LIMITS, Limits
from crenel.metrology.probing.alignment import Alignment
from crenel.metrology.sensor.camera import Camera
from crenel.metrology.sensor.laser_plane import LaserPlane, in_frame
from crenel.metrology.targets.crenellated_block import Crenellated
from crenel.metrology.transforms import Floats, inverse


@dataclass(frozen=True)
class BlockInputs:
    """What a calibration over P poses is made from: one block that has not moved.

    ``q_rad`` (P, n) belongs to ``observations``; ``failed_poses`` show nothing usable.
    """

    arm: Arm
    block: Crenellated
    features: tuple[str, ...]  # (N) the face of each contact
    contact_q_rad: Floats  # (N, n)
    observations: tuple[BlockObservation, ...]
    q_rad: Floats
    failed_poses: tuple[FailedPose, ...] = ()
    limits: Limits = LIMITS


@dataclass(frozen=True)
class BlockStart:
    """The problem, a start for it, and what was set aside before.

    These are poses that contradict the others, and ``excluded_lines_mm``: laser lines by their
    poses' numbers, with how far off they lie.
    """

    problem: AdjustmentProblem
    state: AdjustmentState
    mounting: Mounting
    excluded_lines_mm: dict[int, float]


def refuse_unusable(inputs: BlockInputs) -> None:
    """Raises ``OperationError`` where the inputs do not belong together."""
    require_observations(inputs.observations, inputs.failed_poses, "object")
    refuse_other_angles(inputs.arm, inputs.q_rad, message("poses"))
    refuse_other_angles(inputs.arm, inputs.contact_q_rad, message("contacts"))
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


def block_problem(inputs: BlockInputs, alignment: Alignment) -> BlockStart:
    """All that is to agree without poses that contradict the others, and a start for it.

    Raises:
        OperationError: the poses or the lines are not enough, or contradict.
    """
    arm, block = inputs.arm, inputs.block
    camera, plane = common_camera(inputs.observations, block)
    T_cam_obj = np.array([estimate_block_pose(camera, pose, block) for pose in inputs.observations])
    plane, lines_out = fit_common_plane(inputs.observations, block, camera, T_cam_obj, plane)
    moves = arm_motion(arm, inputs.q_rad)
    mounting = mounting_by_contacts(
        moves.T_arm_flange, T_cam_obj, alignment.T_arm_obj, block.size_mm
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
    return BlockStart(problem, start, mounting, lines_out)


def _view(
    pose: BlockObservation, block: Crenellated, camera: Camera, plane: LaserPlane, T_cam_obj: Floats
) -> BlockView:
    """The pose's pictures, the stripe sorted as the pose itself saw the block."""
    found = pose.detection
    view = BlockView(
        block, found.edges, found.corners, pose.stripe, np.full(len(pose.stripe.u), "", "<U5")
    )
    placed, in_obj = in_frame(camera, plane, inverse(T_cam_obj))
    return view.reclassify_stripe(placed, in_obj, block_prior(block).coordinates)
