"""The article's one-step calibration: contact points and one picture pose (section 3.2).

The sensor frame is the object frame in the calibration pose (Eq. 6), so that the
probe matrix follows from the alignment and the arm's pose alone (Eq. 8).
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from crenel.errors import OperationError
from crenel.messages.message import message
from crenel.metrology.arm.kinematics import (
    Arm,
    flange_pose,
    refuse_other_angles,
    tip_covariances,
)
from crenel.metrology.calibration.camera_refinement import CameraFit, ImageObservations, fit_camera
from crenel.metrology.calibration.findings import CalibrationFinding, WorstResidual
from crenel.metrology.calibration.laser_plane_fit import (
    LaserPlaneFit,
    fit_laser_plane,
    stripe_on_levels,
)
from crenel.metrology.calibration.one_pose_findings import (
    Evidence,
    collect_one_pose_findings,
    worst_points,
)
from crenel.metrology.calibration.uncertainty_budget import (
    Budget,
    BudgetContribution,
    Placement,
    compute_budget,
    volume_pixels,
)
from crenel.metrology.detection.detect_block import ObjectDetection, detect_object
from crenel.metrology.detection.image_quality import ImageFinding, pose_findings
from crenel.metrology.detection.stripe_mask import stripe_in_the_way
from crenel.metrology.image import Image
from crenel.metrology.probing.alignment import Alignment, align_contacts
from crenel.metrology.sensor.camera import Camera, project
from crenel.metrology.sensor.faugeras import FaugerasSolution, solve_faugeras
from crenel.metrology.sensor.laser_plane import LaserPlane
from crenel.metrology.sensor.triangulation import sensor_points
from crenel.metrology.stripe import ANYWHERE, LineSearch, Stripe, picture_with_line
from crenel.metrology.targets.crenellated_block import Crenellated, corners, probing_face
from crenel.metrology.transforms import Floats, inverse
from crenel.progress import Progress, no_progress

# Repeatability with which a person brings the tip onto a ground face.
PROBING_SD_MM = 0.005


@dataclass(frozen=True)
class OnePoseInputs:
    """The input of a one-pose calibration.

    ``laser`` is None if ``ambient`` shows the stripe too (lighting ``both``). ``size_px`` is the
    width and height of the sensor, if known: pictures of another size are refused.
    """

    arm: Arm
    block: Crenellated
    features: tuple[str, ...]  # (N) face of each contact point
    contact_q_rad: Floats  # (N, n)
    pose_q_rad: Floats  # (n,)
    ambient: Image
    laser: Image | None = None
    stripe_axis: str = "u"
    search: LineSearch = ANYWHERE
    size_px: tuple[int, int] | None = None


@dataclass(frozen=True)
class OnePoseCalibration:
    """A calibration and the data it is based on; the sensor frame is the object frame (Eq. 6)."""

    alignment: Alignment
    detection: ObjectDetection
    faugeras: FaugerasSolution
    fit: CameraFit
    stripe: Stripe
    laser: LaserPlaneFit
    T_flange_sensor: Floats  # (4, 4), the probe matrix (Eq. 8)
    corner_residuals_px: Floats  # (C, 2) measured minus projected, of detection.corners
    full_budget: Budget
    depth_range_mm: tuple[float, float]
    """Nearest and furthest distance from the camera centre between crests and floors."""
    findings: tuple[CalibrationFinding, ...]
    worst: tuple[WorstResidual, ...]

    @property
    def camera(self) -> Camera:
        return self.fit.camera

    @property
    def plane(self) -> LaserPlane:
        return self.fit.plane

    @property
    def budget(self) -> tuple[BudgetContribution, ...]:
        return self.full_budget.rows

    @property
    def total_um(self) -> float:
        return self.full_budget.total_um

    @property
    def covariance(self) -> Floats:
        """(23, 23) of ``full_budget.names``: camera, laser plane, probe matrix."""
        return self.full_budget.covariance

    @property
    def reprojection_rms_px(self) -> float:
        """Rms residual, across them, of the edges to which the camera was fitted."""
        return self.fit.edges.rms_px


def calibrate_one_pose(
    inputs: OnePoseInputs, progress: Progress = no_progress
) -> OnePoseCalibration:
    """Camera, laser plane and probe matrix from contact points and one pose.

    Args:
        inputs: contact points and images of one block that has not moved in between.
        progress: called with the share done, 0 to 1, and the current step.

    Returns:
        The calibration; its sensor frame is the object frame (Eq. 6). Uncertainties are standard
        uncertainties, k = 1.

    Raises:
        OperationError: inputs that do not belong together (``joint-count``,
            ``angles-not-finite``, ``contacts-malformed``, ``image-size``); ``stripe-not-found``;
            and as ``align``, ``refuse_wrong_faces``, ``detect_object``, ``solve_faugeras``,
            ``fit_laser_plane`` and ``fit_camera``.

    Source:
        Eq. 6 to 8 and section 3.2 of the article; the refinement is not in the article.
    """
    _check(inputs)
    progress(0.0, message("fitting-contact-points"))
    alignment = align_contacts(inputs.arm, inputs.block, inputs.features, inputs.contact_q_rad)
    progress(0.1, message("finding-objects-edges"))
    ambient, axis = inputs.ambient, inputs.stripe_axis
    alone = picture_with_line(ambient, inputs.laser)
    in_the_way = None
    if inputs.laser is None:
        in_the_way = stripe_in_the_way(ambient, axis, inputs.search)
    detection = detect_object(ambient, inputs.block, in_the_way)
    progress(0.5, message("extracting-laser-stripe"))
    stripe = stripe_on_levels(detection.camera, inputs.block, alone, axis, inputs.search)
    if len(stripe.u) == 0:
        raise OperationError(
            "stripe-not-found",
            message("no-laser-stripe-found-object"),
            message("laser-off-covered-beside-object-too"),
            message("check-laser-exposure-sensors-stripe-axis"),
        )
    progress(0.6, message("solving-camera"))
    faugeras = _faugeras(detection, inputs.block)
    progress(0.7, message("refining-camera-lens-laser-plane"))
    fit, laser = refine_camera(detection, inputs.block, stripe)
    progress(0.9, message("working-out-error-budget"))
    seen = pose_findings(ambient, alone)
    result = _assemble_calibration(inputs, alignment, detection, seen, faugeras, fit, stripe, laser)
    progress(1.0, message("done"))
    return result


def refine_camera(
    detection: ObjectDetection, block: Crenellated, stripe: Stripe
) -> tuple[CameraFit, LaserPlaneFit]:
    """The adjusted camera and plane, with the stripe sorted again by the adjusted camera."""
    laser = fit_laser_plane(detection.camera, block, stripe)
    fit = fit_camera(
        detection.camera,
        block,
        ImageObservations(detection.edges, detection.corners, stripe, laser),
    )
    sorted_again = fit_laser_plane(fit.camera, block, stripe)
    if not np.array_equal(sorted_again.used, laser.used):
        laser = sorted_again
        fit = fit_camera(
            fit.camera, block, ImageObservations(detection.edges, detection.corners, stripe, laser)
        )
    return fit, fit_laser_plane(fit.camera, fit.scene.block, stripe, fit.plane)


def probe_matrix(T_arm_flange: Floats, T_arm_sensor: Floats) -> Floats:
    """The mounting of the sensor from flange and sensor in the calibration pose.

    Args:
        T_arm_flange, T_arm_sensor: (4, 4).

    Returns:
        (4, 4) ``T_flange_sensor``.

    Source:
        Eq. 8 of the article.
    """
    return np.asarray(inverse(T_arm_flange) @ T_arm_sensor)


def _assemble_calibration(
    inputs: OnePoseInputs,
    alignment: Alignment,
    detection: ObjectDetection,
    findings: Sequence[ImageFinding],
    faugeras: FaugerasSolution,
    fit: CameraFit,
    stripe: Stripe,
    laser: LaserPlaneFit,
) -> OnePoseCalibration:
    """Probe matrix, budget and verdict of the fit."""
    placed = Placement(
        inputs.arm,
        inputs.block,
        alignment,
        inputs.features,
        inputs.contact_q_rad,
        inputs.pose_q_rad,
        arm_excess(inputs, alignment),
    )
    budget = compute_budget(fit, placed)
    at = corners(inputs.block)
    predicted = project(fit.camera, np.array([at[corner.name] for corner in detection.corners]))
    measured = np.array([[corner.u, corner.v] for corner in detection.corners])
    evidence = Evidence(
        inputs.block,
        alignment,
        inputs.features,
        detection,
        list(findings),
        faugeras,
        fit,
        stripe,
        laser,
        budget,
        placed.arm_excess,
    )
    return OnePoseCalibration(
        alignment=alignment,
        detection=detection,
        faugeras=faugeras,
        fit=fit,
        stripe=stripe,
        laser=laser,
        T_flange_sensor=probe_matrix(
            flange_pose(inputs.arm, inputs.pose_q_rad), alignment.T_arm_obj
        ),
        corner_residuals_px=measured - predicted,
        full_budget=budget,
        depth_range_mm=_depth_range(fit, inputs.block),
        findings=collect_one_pose_findings(evidence),
        worst=worst_points(evidence, measured - predicted),
    )


def arm_excess(inputs: OnePoseInputs, alignment: Alignment) -> float:
    """Ratio of the scatter of the contact points to what the arm's encoders explain; at least 1.

    The scatter beyond the repeatability of touching is due to the arm's geometry, so the
    calibration pose is assumed to be worse than its encoders by the same ratio.
    """
    noise = tip_covariances(inputs.arm, inputs.contact_q_rad)
    if not np.any(noise):
        return 1.0
    normals = np.array([probing_face(inputs.block, face)[0] for face in inputs.features])
    normals = normals @ alignment.T_arm_obj[:3, :3].T
    variances = np.einsum("ij,ijk,ik->i", normals, noise, normals)[~alignment.outliers]
    unexplained = (alignment.sigma_mm**2 - PROBING_SD_MM**2) / float(np.mean(variances))
    return float(np.sqrt(max(unexplained, 1.0)))


def _faugeras(detection: ObjectDetection, block: Crenellated) -> FaugerasSolution:
    at = corners(block)
    points = np.array([at[corner.name] for corner in detection.corners]).reshape(-1, 3)
    uv = np.array([[corner.u, corner.v] for corner in detection.corners]).reshape(-1, 2)
    camera = detection.camera
    return solve_faugeras(points, uv, camera.width_px, camera.height_px)


def _depth_range(fit: CameraFit, block: Crenellated) -> tuple[float, float]:
    uv = volume_pixels(fit.camera, fit.plane, block)
    points = sensor_points(fit.camera, fit.plane, uv)
    distance = np.linalg.norm(points - fit.camera.centre_mm, axis=1)
    return float(distance.min()), float(distance.max())


def _check(inputs: OnePoseInputs) -> None:
    """Refuses inputs that do not belong together."""
    pose_q_rad = np.atleast_2d(inputs.pose_q_rad)
    refuse_other_angles(inputs.arm, pose_q_rad, message("calibration-pose"))
    refuse_other_angles(inputs.arm, inputs.contact_q_rad, message("contacts"))
    if len(inputs.features) != len(inputs.contact_q_rad):
        raise OperationError(
            "contacts-malformed",
            message(
                "faces-contacts",
                faces=len(inputs.features),
                contacts=len(inputs.contact_q_rad),
            ),
        )
    pictures = {"ambient": inputs.ambient, "laser": inputs.laser}
    size = inputs.size_px or (inputs.ambient.shape[1], inputs.ambient.shape[0])
    for lighting, picture in pictures.items():
        if picture is not None and picture.shape[:2] != (size[1], size[0]):
            raise OperationError(
                "image-size",
                message(
                    "picture-has-size",
                    picture=lighting,
                    width=picture.shape[1],
                    height=picture.shape[0],
                ),
                message("size-expected", width=size[0], height=size[1]),
                message("use-full-pictures-one-sensor-neither"),
            )
