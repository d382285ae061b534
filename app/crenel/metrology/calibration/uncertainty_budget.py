"""Uncertainty of a reconstructed point in the flange frame, and its sources.

Small errors of the camera and the laser plane (the parameters of the scene), of the contact points,
of the arm in the calibration pose and of the certificate are propagated to points over the
measuring volume. An error of the certificate acts twice, through the picture and through the
contact points, and partly cancels.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from crenel.messages.message import Text, message, word
from crenel.metrology.arm.kinematics import Arm, flange_pose, geometric_jacobian, tip_centres
from crenel.metrology.calibration.camera_refinement import CameraFit
from crenel.metrology.calibration.observation_model import coordinates, with_coordinates
from crenel.metrology.probing.alignment import Alignment
from crenel.metrology.sensor.camera import Camera, project
from crenel.metrology.sensor.laser_plane import LaserPlane
from crenel.metrology.sensor.projection import COUNT
from crenel.metrology.sensor.triangulation import sensor_points
from crenel.metrology.targets.crenellated_block import Crenellated, probing_face
from crenel.metrology.transforms import Floats, apply, inverse, skew

SENSOR = COUNT + 3  # the camera's and the plane's parameters
PROBE = slice(SENSOR, SENSOR + 6)
PROBE_NAMES = ("probe_rx", "probe_ry", "probe_rz", "probe_tx", "probe_ty", "probe_tz")


@dataclass(frozen=True)
class BudgetContribution:
    """One source of uncertainty: standard uncertainty of a point, flange frame, k = 1."""

    source: str
    value_um: float


SOURCES: dict[str, Text] = {
    "camera and mounting": message("camera-and-mounting"),
    "contact points": message("contact-points"),
    "arm encoders": message("arm-encoders"),
    "arm geometry": message("arm-geometry"),
    "robot's poses": message("robots-poses"),
    "object certificate": message("object-certificate"),
    "edges and corners": message("edges-corners"),
    "stripe": word("stripe"),
    "distortion": word("distortion"),
}
"""Display names of the sources in budgets and files."""


def source_text(source: str) -> Text:
    """The display name of a budget's source; an unknown source keeps its name."""
    return SOURCES.get(source, source)


@dataclass(frozen=True)
class Budget:
    """The uncertainty of points over the measuring volume.

    ``total_um`` is the root of the summed squares of ``rows``: rms over the volume of
    the length of a point's error. ``covariance`` (23, 23) belongs to the parameters
    of ``names``: camera, laser plane, and a left perturbation of ``T_flange_sensor``
    (rad, mm) about ``pivot_mm`` (3,) in the flange frame.
    """

    rows: tuple[BudgetContribution, ...]
    total_um: float
    names: tuple[str, ...]
    covariance: Floats
    pivot_mm: Floats


@dataclass(frozen=True)
class Placement:
    """The inputs of the probe matrix."""

    arm: Arm
    block: Crenellated
    alignment: Alignment
    features: Sequence[str]
    contact_q_rad: Floats
    pose_q_rad: Floats
    arm_excess: float
    """Ratio of the scatter of the contact points to what the encoders explain, at least 1."""


def compute_budget(fit: CameraFit, placed: Placement) -> Budget:
    """The error budget of a one-pose calibration (sensor frame = object frame, Eq. 6-8)."""
    T_flange_arm = inverse(flange_pose(placed.arm, placed.pose_q_rad))
    T_flange_obj = T_flange_arm @ placed.alignment.T_arm_obj
    uv = volume_pixels(fit.camera, fit.plane, placed.block)
    points_obj = sensor_points(fit.camera, fit.plane, uv)
    grid = apply(T_flange_obj, points_obj)
    pivot = grid.mean(axis=0)
    by_alignment = _probe_by_alignment(placed, T_flange_arm, pivot)
    by_encoders = _probe_by_encoders(placed, T_flange_arm, pivot)
    encoders = np.diag((placed.arm.encoder_sd_rad * placed.arm_excess) ** 2)

    covariances = {
        "contact points": _embed_probe(by_alignment @ placed.alignment.covariance @ by_alignment.T),
        "arm encoders": _embed_probe(by_encoders @ encoders @ by_encoders.T),
        "object certificate": _certificate_covariance(fit, placed, by_alignment),
        "edges and corners": _embed_sensor(fit.sources["edges"]),
        "stripe": _embed_sensor(fit.sources["stripe"]),
        "distortion": _embed_sensor(fit.sources["distortion"]),
    }
    J = _point_jacobian(fit, uv, T_flange_obj, grid, pivot)
    squares = {source: _error_squares(J, C) for source, C in covariances.items()}
    rows = tuple(
        BudgetContribution(source, 1e3 * float(np.sqrt(np.mean(square))))
        for source, square in squares.items()
    )
    total = np.sum(list(squares.values()), axis=0)
    return Budget(
        rows,
        1e3 * float(np.sqrt(np.mean(total))),
        fit.scene.names[:SENSOR] + PROBE_NAMES,
        np.sum(list(covariances.values()), axis=0),
        pivot,
    )


def volume_pixels(camera: Camera, plane: LaserPlane, block: Crenellated) -> Floats:
    """Pixels (G, 2) of a grid over the laser plane between floor and crest, over the block's width.

    Only pixels inside the picture.
    """
    x = np.linspace(block.edges_x_mm[0], block.edges_x_mm[-1], 9)
    z = np.linspace(block.floor_z_mm, block.crest_z_mm, 5)
    grid_x, grid_z = (grid.ravel() for grid in np.meshgrid(x, z))
    n = plane.normal
    y = (plane.offset_mm - n[0] * grid_x - n[2] * grid_z) / n[1]
    uv = project(camera, np.column_stack([grid_x, y, grid_z]))
    inside = (uv > -0.5) & (uv < np.array([camera.width_px, camera.height_px]) - 0.5)
    return np.asarray(uv[inside.all(axis=1)])


def _error_squares(J: Floats, covariance: Floats) -> Floats:
    """Squared length (G,) of the errors of points, mm^2."""
    return np.asarray(np.maximum(np.einsum("gik,kl,gil->g", J, covariance, J), 0.0))


def _embed_probe(covariance: Floats) -> Floats:
    full = np.zeros((SENSOR + 6, SENSOR + 6))
    full[PROBE, PROBE] = covariance
    return full


def _embed_sensor(covariance: Floats) -> Floats:
    full = np.zeros((SENSOR + 6, SENSOR + 6))
    full[:SENSOR, :SENSOR] = covariance[:SENSOR, :SENSOR]
    return full


def _certificate_covariance(fit: CameraFit, placed: Placement, by_alignment: Floats) -> Floats:
    """Effect of errors of the certificate's coordinates, through picture and contact points
    together."""
    answer = np.zeros((SENSOR + 6, fit.by_certificate.shape[1]))
    answer[:SENSOR] = fit.by_certificate[:SENSOR]
    answer[PROBE] = by_alignment @ _alignment_by_certificate(placed)
    return np.asarray((answer * placed.block.sds_mm**2) @ answer.T)


def _alignment_by_certificate(placed: Placement) -> Floats:
    """(6, B): derivative of the alignment by each of the block's coordinates."""
    alignment = placed.alignment
    kept = np.flatnonzero(~alignment.outliers)
    tips = tip_centres(placed.arm, placed.contact_q_rad)[kept]
    values = coordinates(placed.block)
    normals = np.empty((len(kept), 3))
    offsets = np.zeros((len(kept), len(values)))
    for row, contact in enumerate(kept):
        face = placed.features[int(contact)]
        normals[row], base = probing_face(placed.block, face)
        for k in range(len(values)):
            moved = values.copy()
            moved[k] += 1.0
            offsets[row, k] = probing_face(with_coordinates(placed.block, moved), face)[1] - base
    normals_arm = normals @ alignment.T_arm_obj[:3, :3].T
    J = np.column_stack([np.cross(tips - alignment.centre_mm, normals_arm), normals_arm])
    # the object moves so that its displaced faces fit the same contact points again
    return np.asarray(-np.linalg.pinv(J) @ offsets)


def _probe_by_alignment(placed: Placement, T_flange_arm: Floats, pivot: Floats) -> Floats:
    """(6, 6): a rotation and translation of ``T_arm_obj`` as a left perturbation of the probe
    matrix."""
    R = T_flange_arm[:3, :3]
    pivot_arm = apply(inverse(T_flange_arm), pivot[None])[0]
    M = np.zeros((6, 6))
    M[:3, :3], M[3:, 3:] = R, R
    M[3:, :3] = -R @ skew(pivot_arm - placed.alignment.centre_mm)
    return M


def _probe_by_encoders(placed: Placement, T_flange_arm: Floats, pivot: Floats) -> Floats:
    """(6, n): effect of an error of each joint in the calibration pose on the probe matrix."""
    J = geometric_jacobian(placed.arm, placed.pose_q_rad, pivot)
    R = T_flange_arm[:3, :3]
    return -np.vstack([R @ J[3:], R @ J[:3]])


def _point_jacobian(
    fit: CameraFit, uv: Floats, T_flange_obj: Floats, grid: Floats, pivot: Floats
) -> Floats:
    """(G, 3, 23): derivatives of points in the flange frame by all parameters."""
    J = np.zeros((len(uv), 3, SENSOR + 6))
    R = T_flange_obj[:3, :3]
    for k in range(SENSOR):
        h = 1e-3 if k < 4 else 1e-6
        ahead, behind = (_points_after_step(fit, uv, k, sign * h) for sign in (1, -1))
        J[:, :, k] = (ahead - behind) / (2 * h) @ R.T
    for g, point in enumerate(grid):
        J[g, :, SENSOR : SENSOR + 3] = -skew(point - pivot)
    J[:, :, SENSOR + 3 :] = np.eye(3)
    return J


def _points_after_step(fit: CameraFit, uv: Floats, parameter: int, step: float) -> Floats:
    """The points (G, 3) of pixels, sensor frame, after a step of one parameter."""
    change = np.zeros(len(fit.scene.names))
    change[parameter] = step
    moved = fit.scene.apply_step(change)
    return sensor_points(moved.camera, moved.plane, uv)
