"""Rows of the adjustment for coordinates that a tracker or measuring machine took of markers.

A measured pose is compared in the arm's frame: predicted minus measured position, then the rotation
from the measured to the predicted orientation.
"""

from dataclasses import dataclass

import numpy as np

from crenel.metrology.arm.identification.observations import TIP, StackedObservations
from crenel.metrology.arm.identification.parameters import (
    TERMS,
    THETA,
    Indices,
    PoseJacobian,
    pose_jacobian,
)
from crenel.metrology.arm.identification.scatter import Scatter
from crenel.metrology.arm.identification.unknowns import Unknowns
from crenel.metrology.transforms import Floats, apply, skews, vector_from_rotation


@dataclass(frozen=True)
class CoordinateResiduals:
    """Deviations of the coordinates at given unknowns, arm frame."""

    off: Floats
    """(M, 6) mm and rad: predicted minus measured; no rotation where none was measured."""
    whitened: Floats
    """(M, 6) the same in standard deviations, independent of each other."""
    whiten: Floats
    """(M, 6, 6) the lower triangle that does this."""
    variances: Floats
    """(M, 6) mm² and rad², of the deviations."""
    poses: PoseJacobian
    measured_mm: Floats
    """(M, 3) measured points, arm frame."""


def coordinate_residuals(
    data: StackedObservations, at: Unknowns, scatter: Scatter, poses: PoseJacobian | None = None
) -> CoordinateResiduals:
    """Position of every coordinate relative to the arm's prediction.

    Args:
        poses: from ``predict_poses``, if they are known already.
    """
    found = data.coordinates
    poses = poses or predict_poses(data, at)
    T = at.T_arm_frames[found.frame_of]
    measured = apply(T, found.points_mm)
    off = np.zeros((len(measured), 6))
    off[:, :3] = poses.tips_mm - measured
    turned = found.has_rotation
    if turned.any():
        predicted = poses.rotations[turned] @ at.R_flange_markers[found.marker_of[turned]]
        seen = T[turned][:, :3, :3] @ found.rotations[turned]
        off[turned, 3:] = vector_from_rotation(predicted @ np.swapaxes(seen, 1, 2))
    covariances = _covariances(data, at, poses, scatter)
    whiten = np.linalg.inv(np.linalg.cholesky(covariances))
    whiten[~turned, 3:] = 0.0
    variances = np.einsum("nii->ni", covariances)
    whitened = np.einsum("nij,nj->ni", whiten, off)
    return CoordinateResiduals(off, whitened, whiten, variances, poses, measured)


def coordinate_rows(
    data: StackedObservations, at: Unknowns, columns: Indices, scatter: Scatter
) -> Floats:
    """(M, 6, o + p + 1) whitened rows: other unknowns, parameters in ``columns``, right side."""
    found, others = data.coordinates, data.others
    now = coordinate_residuals(data, at, scatter)
    body = np.zeros((len(now.off), 6, others.count + len(columns) + 1))
    for i, own in enumerate(others.frames):
        if own is not None:
            mine = found.frame_of == i
            turns = slice(own.start, own.start + 3)
            body[mine, :3, turns] = skews(now.measured_mm[mine])
            body[mine, :3, own.start + 3 : own.stop] = -np.eye(3)
            body[mine, 3:, turns] = -np.eye(3)
    for k, (offset, rotation) in enumerate(zip(others.offsets, others.rotations, strict=True)):
        mine = found.marker_of == k
        if offset is not None:
            body[mine, :3, offset] = now.poses.rotations[mine]
        if rotation is not None:
            body[mine, 3:, rotation] = now.poses.rotations[mine]
    arm = slice(others.count, others.count + len(columns))
    body[:, :3, arm] = now.poses.by_parameters[:, :, columns]
    body[:, 3:, arm] = now.poses.turns[:, :, columns]
    body[:, :, -1] = -now.off
    return np.asarray(now.whiten @ body)


def predict_poses(data: StackedObservations, at: Unknowns) -> PoseJacobian:
    """Predicts the poses at every coordinate, its marker for the tip; another marker does not move
    with the tip."""
    found = data.coordinates
    count, width = len(found.q_rad), at.arm.joint_count * TERMS + 3
    poses = PoseJacobian(
        np.zeros((count, 3)),
        np.zeros((count, 3, 3)),
        np.zeros((count, 3, width)),
        np.zeros((count, 3, width)),
    )
    for k, marker in enumerate(found.markers):
        mine = found.marker_of == k
        own = pose_jacobian(at.arm_with(k, marker), found.q_rad[mine])
        poses.tips_mm[mine], poses.rotations[mine] = own.tips_mm, own.rotations
        poses.by_parameters[mine], poses.turns[mine] = own.by_parameters, own.turns
        if marker.name != TIP:
            poses.by_parameters[mine, :, -3:] = 0.0
    return poses


def _covariances(
    data: StackedObservations, at: Unknowns, poses: PoseJacobian, scatter: Scatter
) -> Floats:
    """(M, 6, 6) by the encoders, the stated uncertainty and the scatter beyond both."""
    found = data.coordinates
    by_theta = slice(THETA, at.arm.joint_count * TERMS, TERMS)
    by_encoders = np.concatenate(
        [poses.by_parameters[:, :, by_theta], poses.turns[:, :, by_theta]], axis=1
    )
    by_encoders = by_encoders * at.arm.encoder_sd_rad
    by_encoders[~found.has_rotation, 3:] = 0.0
    covariances = by_encoders @ np.swapaxes(by_encoders, 1, 2)
    points = found.standard_uncertainty_mm**2 + scatter.point_mm**2
    turns = found.rotation_uncertainty_rad**2 + scatter.turn_rad**2
    for i in range(3):
        covariances[:, i, i] += points
        covariances[:, 3 + i, 3 + i] += turns
    return np.asarray(covariances)
