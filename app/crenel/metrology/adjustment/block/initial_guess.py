"""Start values for the block's adjustment: one camera for all poses, and the block in each view."""

from collections.abc import Sequence
from dataclasses import replace

import cv2
import numpy as np

from crenel.errors import OperationError
from crenel.messages.message import message
from crenel.metrology.adjustment.core.observations import BlockObservation
from crenel.metrology.calibration.camera_refinement import CameraFit, ImageObservations, fit_camera
from crenel.metrology.calibration.laser_plane_fit import fit_laser_plane
from crenel.metrology.sensor.camera import Camera
from crenel.metrology.sensor.laser_plane import LaserPlane
from crenel.metrology.targets.crenellated_block import Crenellated, corners
from crenel.metrology.transforms import Floats, rigid

FEWEST_CORNERS = 6


def common_camera(
    seen: Sequence[BlockObservation], block: Crenellated
) -> tuple[Camera, LaserPlane]:
    """Camera (its own frame as sensor frame) and laser plane from the most informative pose.

    Raises:
        OperationError: that of the best pose, if no pose is sufficient.
    """
    refusal: OperationError | None = None
    for pose in sorted(seen, key=_observation_weight, reverse=True):
        try:
            fit = _fit(pose, block)
            return express_in_camera_frame(fit.camera, fit.plane)
        except OperationError as declined:
            refusal = refusal or declined
    assert refusal is not None
    raise refusal


def _observation_weight(pose: BlockObservation) -> float:
    edges = sum(len(edge.uv_px) for edge in pose.detection.edges)
    return float(edges + len(pose.detection.corners)) * min(1.0, len(pose.stripe.u) / 200)


def _fit(pose: BlockObservation, block: Crenellated) -> CameraFit:
    found = pose.detection
    levels = fit_laser_plane(found.camera, block, pose.stripe)
    return fit_camera(
        found.camera, block, ImageObservations(found.edges, found.corners, pose.stripe, levels)
    )


def express_in_camera_frame(camera: Camera, plane: LaserPlane) -> tuple[Camera, LaserPlane]:
    """The camera without rotation and translation, and the plane in its frame."""
    own = replace(camera, rotation=np.eye(3), translation_mm=np.zeros(3))
    return own, plane.in_frame(rigid(camera.rotation, camera.translation_mm))


def estimate_block_pose(camera: Camera, pose: BlockObservation, block: Crenellated) -> Floats:
    """``T_cam_obj`` (4, 4) of a pose from its corners, with a known camera.

    Raises:
        OperationError: too few corners to determine the pose of the object.
    """
    at = corners(block)
    found = pose.detection.corners
    if len(found) < FEWEST_CORNERS:
        raise OperationError(
            "too-few-corners",
            message("pose-shows-corners", number=pose.number, found=len(found), name=block.name),
            message("needed-place", fewest_corners=FEWEST_CORNERS),
            message("bring-more-object-into-picture"),
        )
    points = np.array([at[corner.name] for corner in found])
    uv = np.array([[corner.u, corner.v] for corner in found])
    return solve_pnp(camera, points, uv)


def solve_pnp(camera: Camera, points_mm: Floats, uv_px: Floats) -> Floats:
    """``T_cam_obj`` (4, 4) from points (N, 3) of an object and their pixels (N, 2)."""
    found, turn, shift = cv2.solvePnP(
        points_mm, uv_px, camera.matrix, camera.distortion, flags=cv2.SOLVEPNP_SQPNP
    )
    if not found:
        raise OperationError("object-not-placed", message("object-points-do-not-fit-pixels"))
    turn, shift = cv2.solvePnPRefineLM(
        points_mm, uv_px, camera.matrix, camera.distortion, turn, shift
    )
    return rigid(
        np.asarray(cv2.Rodrigues(turn)[0], np.float64), np.asarray(shift, np.float64).ravel()
    )
