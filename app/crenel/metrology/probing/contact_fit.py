"""The best pose of the block for its contact points: start values, then least squares."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.fitting.outlier_search import find_agreement
from crenel.metrology.probing.contacts import (
    CONTACT_SD_MM,
    DIRECTIONS,
    FACE_SLACK_MM,
    MIN_CONTACTS,
    FaceContacts,
    in_plane_spread,
    missing_contacts,
    off_face_mask,
    surface_points,
)
from crenel.metrology.robust import MEDIAN_OF_NORMAL, median
from crenel.metrology.targets.crenellated_block import Crenellated
from crenel.metrology.transforms import (
    Floats,
    nearest_rotation,
    rigid,
    rotations_from_vectors,
    skews,
)

# Residuals beyond this many standard deviations of most have no weight at the start.
START_CUT = 6.0
# Share of the contact points that a start must fit.
START_SHARE = 0.75
# A start that fits so well needs no other.
GOOD_START_MM = 0.2
# With so few contact points on a face, an outlier may be taken for part of its plane.
FEW_ON_FACE = 7


def best_start(contacts: FaceContacts, tip_radius_mm: float, block: Crenellated) -> Floats:
    """The pose that puts most contact points onto their faces, among the four that fit as planes.

    Four orientations of the block fit three perpendicular planes equally well; only one of them has
    the contact points within the bounds of the faces.
    """
    rotations = _start_rotations(contacts)
    found = _fit_starts(contacts, rotations[:4], tip_radius_mm, block)
    # where the planes of all contact points fit, there is no need to try them without one
    if len(rotations) > 4 and not _best(found)[:2] < (0, GOOD_START_MM):
        found += _fit_starts(contacts, rotations[4:], tip_radius_mm, block)
    return _best(found)[2]


Start = tuple[int, float, Floats]
"""How many contact points lie beside their faces, how far most lie off them, and the pose."""


def _best(found: list[Start]) -> Start:
    return min(found, key=lambda start: start[:2])


def _fit_starts(
    contacts: FaceContacts, rotations: list[Floats], tip_radius_mm: float, block: Crenellated
) -> list[Start]:
    """What becomes of each rotation, with weights of several kinds."""
    found: list[Start] = []
    T_arm_obj = np.array([_start_translation(contacts, rotation) for rotation in rotations])
    for weigh in (_biweight, _huber, _biweight):
        T_arm_obj = _iterate(contacts, T_arm_obj, weigh)
        off_mm = np.abs(contacts.residuals_mm(T_arm_obj))
        misfits = np.quantile(off_mm, START_SHARE, axis=-1)
        for T, misfit in zip(T_arm_obj, misfits, strict=True):
            points = surface_points(contacts, T, tip_radius_mm)
            off_face = off_face_mask(contacts.features, points, block)
            found.append((int(off_face.sum()), float(misfit), T))
    return found


def _start_rotations(contacts: FaceContacts) -> list[Floats]:
    """Rotations ``R_arm_obj`` that align the block's axes with the probed planes, four of each."""
    labels = np.array(contacts.features)
    choices = [_normals(contacts.tips_mm, labels, faces) for faces in DIRECTIONS]
    usual = [normals[0] for normals in choices]
    triples = [usual]
    for axis, normals in enumerate(choices):
        triples += [[*usual[:axis], normal, *usual[axis + 1 :]] for normal in normals[1:]]
    return [rotation for z, y, x in triples for rotation in _rotations_along(x, y, z)]


def _normals(tips_mm: Floats, labels: NDArray[np.str_], faces: tuple[str, ...]) -> list[Floats]:
    """The normal of the best probed face of a direction, and those without one of few contacts."""
    found = [(in_plane_spread(tips_mm[labels == face]), face) for face in faces]
    (_, normal), face = max(found, key=lambda spread: spread[0][0])
    own = tips_mm[labels == face]
    if not MIN_CONTACTS < len(own) <= FEW_ON_FACE:
        return [normal]
    without = [in_plane_spread(np.delete(own, i, axis=0))[1] for i in range(len(own))]
    return [normal, *(other for other in without if np.any(other))]


def _rotations_along(x: Floats, y: Floats, z: Floats) -> list[Floats]:
    """The four rotations whose axes lie along three normals of unknown signs."""
    rotations = []
    for sign_y in (1.0, -1.0):
        for sign_x in (1.0, -1.0):
            matrix = np.column_stack([sign_x * x, sign_y * y, z])
            if np.linalg.det(matrix) < 0:
                matrix[:, 2] *= -1
            rotations.append(nearest_rotation(matrix))
    return rotations


def _start_translation(contacts: FaceContacts, rotation: Floats) -> Floats:
    """``T_arm_obj`` for a given ``R_arm_obj``: along each axis what most of its contact points
    say."""
    sides = contacts.normals.round()
    along = np.einsum("ij,ij->i", contacts.normals @ rotation.T, contacts.tips_mm)
    along -= contacts.reach_mm
    offsets = [median((sides[:, k] * along)[sides[:, k] != 0]) for k in range(3)]
    return rigid(rotation, rotation @ np.array(offsets))


def jacobian(contacts: FaceContacts, T_arm_obj: Floats) -> tuple[Floats, Floats]:
    """(..., N, 6) derivatives of the residuals by a left perturbation of ``T_arm_obj``
    (..., 4, 4), and its pivot."""
    centre_mm = contacts.tips_mm.mean(axis=0)
    normals_arm = contacts.normals @ T_arm_obj[..., :3, :3].mT
    levers = (skews(contacts.tips_mm - centre_mm) @ normals_arm[..., None])[..., 0]
    return np.concatenate([-levers, -normals_arm], axis=-1), centre_mm


def _move(T_arm_obj: Floats, changes: Floats, centre_mm: Floats) -> Floats:
    """Poses (..., 4, 4) after left perturbations (..., 6) about a pivot (3,)."""
    turns = rotations_from_vectors(changes[..., :3])
    moved = T_arm_obj.copy()
    moved[..., :3, :3] = turns @ T_arm_obj[..., :3, :3]
    away = T_arm_obj[..., :3, 3] - centre_mm
    moved[..., :3, 3] = centre_mm + (turns @ away[..., None])[..., 0] + changes[..., 3:6]
    return moved


def _size(changes: Floats) -> float:
    """The size in mm of the largest of steps (..., 6)."""
    shifts, turns = (np.linalg.norm(part, axis=-1) for part in (changes[..., 3:], changes[..., :3]))
    return float(np.max(shifts + 100.0 * turns))


def _iterate(
    contacts: FaceContacts, T_arm_obj: Floats, weigh: Callable[[Floats], Floats]
) -> Floats:
    """Poses (S, 4, 4), each of which weighs its own residuals, by up to 20 Gauss-Newton steps."""
    for _ in range(20):
        residuals = contacts.residuals_mm(T_arm_obj)
        J, centre_mm = jacobian(contacts, T_arm_obj)
        root = np.sqrt(weigh(residuals))[..., None]
        changes = (np.linalg.pinv(J * root) @ (-residuals[..., None] * root))[..., 0]
        T_arm_obj = _move(T_arm_obj, changes, centre_mm)
        if _size(changes) < 1e-9:
            break
    return T_arm_obj


def _huber(residuals_mm: Floats) -> Floats:
    scale = _scales_mm(residuals_mm)
    return np.minimum(1.0, 1.5 * scale / np.maximum(np.abs(residuals_mm), 1e-12))


def _scales_mm(residuals_mm: Floats) -> Floats:
    """(..., 1) the scatter of most of (..., N)."""
    return np.median(np.abs(residuals_mm), axis=-1, keepdims=True) / MEDIAN_OF_NORMAL + 1e-6


def _biweight(residuals_mm: Floats) -> Floats:
    """Weights that vanish for residuals far beyond the scatter of most (Tukey's biweight): a
    contact point far beside the block would tilt the pose by its leverage, however little it
    weighs."""
    scale = _scales_mm(residuals_mm)
    return np.asarray(np.maximum(1 - (residuals_mm / (START_CUT * scale)) ** 2, 0.0) ** 2)


@dataclass(frozen=True)
class ContactFit:
    """The pose for the contacts, and how far out its ``faces`` lie beside the certificate (F,)."""

    T_arm_obj: Floats
    offsets_mm: Floats


def fit_without_outliers(
    contacts: FaceContacts, T_arm_obj: Floats, eligible: NDArray[np.bool_] | None = None
) -> tuple[ContactFit, NDArray[np.bool_], NDArray[np.bool_]]:
    """Least squares on the contact points that agree, of those (N,) that are eligible.

    Contact points that miss their face by millimetres at the robust start lie on another face and
    would tilt the fit: they are excluded at once. ``find_agreement`` judges the others.

    Returns:
        The fit, (N,) the contact points kept, and (N,) those of which one contradicts the others
        while the data cannot tell which.
    """
    allowed = np.ones(len(contacts.features), np.bool_) if eligible is None else eligible
    kept = allowed & (np.abs(contacts.residuals_mm(T_arm_obj)) < FACE_SLACK_MM)
    if missing_contacts([contacts.features[int(i)] for i in np.flatnonzero(kept)]):
        kept = allowed.copy()
    start = ContactFit(T_arm_obj, np.zeros(len(contacts.faces)))
    found = find_agreement(
        lambda some: _whiten_with_shared(contacts, _settle(contacts, start, some), some),
        kept,
        allowed,
        given=len(contacts.faces) + contacts.tip_shared_mm.shape[2],
    )
    return _settle(contacts, start, found.kept), found.kept, found.doubtful


def _settle(contacts: FaceContacts, start: ContactFit, kept: NDArray[np.bool_]) -> ContactFit:
    """The least-squares pose for the contact points kept, with the faces that are to be found."""
    T_arm_obj, offsets_mm = start.T_arm_obj, start.offsets_mm
    for _ in range(20):
        J, residuals = _whiten(contacts, ContactFit(T_arm_obj, offsets_mm))
        counts = np.append(kept, np.ones(len(offsets_mm), np.bool_))
        change, *_ = np.linalg.lstsq(J[counts], -residuals[counts], rcond=None)
        _, centre_mm = jacobian(contacts, T_arm_obj)
        T_arm_obj = _move(T_arm_obj, np.asarray(change), centre_mm)
        offsets_mm = offsets_mm + change[6:]
        if _size(np.asarray(change)) < 1e-10:
            break
    return ContactFit(T_arm_obj, offsets_mm)


def _whiten_with_shared(
    contacts: FaceContacts, at: ContactFit, kept: NDArray[np.bool_]
) -> tuple[Floats, Floats]:
    """``_whiten`` with the errors that all contacts share as L more unknowns and given rows, at the
    best fit to the contact points kept."""
    J, residuals = _whiten(contacts, at)
    count = contacts.tip_shared_mm.shape[2]
    normals_arm = contacts.normals @ at.T_arm_obj[:3, :3].T
    moved = np.einsum("ij,ijl->il", normals_arm, contacts.tip_shared_mm)
    moved /= contacts.sds_mm(at.T_arm_obj)[:, None]
    shared = np.vstack([moved, np.zeros((len(at.offsets_mm), count))])
    rows = np.block([[J, shared], [np.zeros((count, J.shape[1])), np.eye(count)]])
    residuals = np.append(residuals, np.zeros(count))
    counts = np.append(kept, np.ones(len(rows) - len(kept), np.bool_))
    change, *_ = np.linalg.lstsq(rows[counts], -residuals[counts], rcond=None)
    return rows, residuals + rows @ change


def _whiten(contacts: FaceContacts, at: ContactFit) -> tuple[Floats, Floats]:
    """(N + F, 6 + F) derivatives and (N + F,) residuals, divided by the standard deviations; the
    faces' offsets by the certificate last."""
    sds_mm = contacts.sds_mm(at.T_arm_obj)
    placed = contacts.with_faces_at(at.offsets_mm)
    J, _ = jacobian(contacts, at.T_arm_obj)
    rows = np.column_stack([J, contacts.by_faces()]) / sds_mm[:, None]
    known = np.eye(len(at.offsets_mm)) / max(contacts.made_mm, CONTACT_SD_MM)
    return (
        np.vstack([rows, np.column_stack([np.zeros((len(known), 6)), known])]),
        np.concatenate([placed.residuals_mm(at.T_arm_obj) / sds_mm, known @ at.offsets_mm]),
    )
