"""The best pose of the block for its contact points: start values, then least squares."""

import numpy as np
from numpy.typing import NDArray

from app.metrology.probing.contacts import (
    DIRECTIONS,
    FACE_SLACK_MM,
    FaceContacts,
    in_plane_spread,
    missing_contacts,
    off_face_mask,
    surface_points,
)
from app.metrology.robust import median, sigma_from_median
from app.metrology.targets.crenellated_block import Crenellated
from app.metrology.transforms import Floats, nearest_rotation, rigid, rotation_from_vector

OUTLIER_SIGMAS = 4.0


def best_start(contacts: FaceContacts, tip_radius_mm: float, block: Crenellated) -> Floats:
    """The pose that puts most contact points onto their faces, among the four that fit as planes.

    Four orientations of the block fit three perpendicular planes equally well; only one of them has
    the contact points within the bounds of the faces.
    """
    found: list[tuple[int, float, Floats]] = []
    for rotation in _start_rotations(contacts):
        T = _start_translation(contacts, rotation)
        for _ in range(20):
            T, step = _step(contacts, T, _huber(contacts.residuals_mm(T)))
            if step < 1e-9:
                break
        off_face = off_face_mask(
            contacts.features, surface_points(contacts, T, tip_radius_mm), block
        )
        misfit = median(np.abs(contacts.residuals_mm(T)))
        found.append((int(off_face.sum()), misfit, T))
    return min(found, key=lambda start: start[:2])[2]


def _start_rotations(contacts: FaceContacts) -> list[Floats]:
    """The four rotations ``R_arm_obj`` that align the block's axes with the probed planes."""
    labels = np.array(contacts.features)
    axes: list[Floats] = []
    for faces in DIRECTIONS:
        spreads = [in_plane_spread(contacts.tips_mm[labels == face]) for face in faces]
        axes.append(max(spreads, key=lambda found: found[0])[1])
    z, y, x = axes
    rotations = []
    for sign_y in (1.0, -1.0):
        for sign_x in (1.0, -1.0):
            matrix = np.column_stack([sign_x * x, sign_y * y, z])
            if np.linalg.det(matrix) < 0:
                matrix[:, 2] *= -1
            rotations.append(nearest_rotation(matrix))
    return rotations


def _start_translation(contacts: FaceContacts, rotation: Floats) -> Floats:
    """Least-squares ``T_arm_obj`` for a given ``R_arm_obj``: linear in the translation."""
    normals_arm = contacts.normals @ rotation.T
    along = np.einsum("ij,ij->i", normals_arm, contacts.tips_mm) - contacts.reach_mm
    translation, *_ = np.linalg.lstsq(normals_arm, along, rcond=None)
    return rigid(rotation, translation)


def jacobian(contacts: FaceContacts, T_arm_obj: Floats) -> tuple[Floats, Floats]:
    """(N, 6) derivatives of the residuals by a left perturbation of ``T_arm_obj``, and its
    pivot."""
    centre_mm = contacts.tips_mm.mean(axis=0)
    normals_arm = contacts.normals @ T_arm_obj[:3, :3].T
    arms = contacts.tips_mm - centre_mm
    return np.column_stack([-np.cross(arms, normals_arm), -normals_arm]), centre_mm


def _step(contacts: FaceContacts, T_arm_obj: Floats, weights: Floats) -> tuple[Floats, float]:
    """One weighted Gauss-Newton step; returns the new pose and the step's size in mm."""
    J, centre_mm = jacobian(contacts, T_arm_obj)
    root = np.sqrt(weights)
    residuals = contacts.residuals_mm(T_arm_obj)
    change, *_ = np.linalg.lstsq(J * root[:, None], -residuals * root, rcond=None)
    turn = rotation_from_vector(np.asarray(change[:3]))
    moved = rigid(turn, centre_mm - turn @ centre_mm + change[3:])
    size = float(np.linalg.norm(change[3:]) + 100.0 * np.linalg.norm(change[:3]))
    return moved @ T_arm_obj, size


def _huber(residuals_mm: Floats) -> Floats:
    scale = sigma_from_median(np.abs(residuals_mm)) + 1e-6
    return np.minimum(1.0, 1.5 * scale / np.maximum(np.abs(residuals_mm), 1e-12))


def fit_without_outliers(
    contacts: FaceContacts, T_arm_obj: Floats
) -> tuple[Floats, NDArray[np.bool_]]:
    """Least squares on the contact points that agree; (N,) mask of those kept.

    Contact points that miss their face by millimetres at the robust start lie on another face and
    would tilt the fit: they are excluded at once. Then one contact point at a time is removed, the
    one with the largest residual relative to its own standard deviation (including its leverage),
    as long as it exceeds the limit and enough contact points remain.
    """
    kept = np.abs(contacts.residuals_mm(T_arm_obj)) < FACE_SLACK_MM
    if missing_contacts([contacts.features[int(i)] for i in np.flatnonzero(kept)]):
        kept[:] = True
    while True:
        for _ in range(20):
            weights = np.where(kept, contacts.sds_mm(T_arm_obj) ** -2.0, 0.0)
            T_arm_obj, step = _step(contacts, T_arm_obj, weights)
            if step < 1e-10:
                break
        worst = _worst_outlier(contacts, T_arm_obj, kept)
        if worst is None:
            return T_arm_obj, kept
        kept[worst] = False


def _worst_outlier(
    contacts: FaceContacts, T_arm_obj: Floats, kept: NDArray[np.bool_]
) -> int | None:
    """Index of the contact point that most exceeds the limit, by its deleted (studentised)
    residual."""
    J, _ = jacobian(contacts, T_arm_obj)
    own = np.flatnonzero(kept)
    sds_mm = contacts.sds_mm(T_arm_obj)[own]
    J_kept = J[own] / sds_mm[:, None]
    leverage = np.einsum("ij,ji->i", J_kept, np.linalg.pinv(J_kept))
    residuals = contacts.residuals_mm(T_arm_obj)[own] / sds_mm
    freedom = len(own) - 7
    if freedom < 1:
        return None
    spare = np.maximum(1 - leverage, 1e-9)
    sum_without = np.maximum(np.sum(residuals**2) - residuals**2 / spare, 0.0)
    deleted = np.abs(residuals) / np.sqrt(spare * np.maximum(sum_without / freedom, 1e-12))
    deleted[leverage > 0.99] = 0.0
    # Student's t has heavier tails than the normal distribution if few contact points remain
    limit = OUTLIER_SIGMAS * (1 + 4.0 / freedom)
    for worst in np.argsort(-deleted):
        if deleted[worst] <= limit:
            return None
        remaining = [contacts.features[int(i)] for i in own if i != own[worst]]
        if not missing_contacts(remaining):
            return int(own[worst])
    return None
