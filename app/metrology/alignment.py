"""Where the object lies in the arm: ``T_arm_obj`` from contact points (the paper's M_CAL->CMA).

Every contact gives one equation: the tip's centre lies one tip radius outside the
face that was touched. All faces are fitted at once by least squares.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from app.metrology.crenellated import FACES, Crenellated, probing_face
from app.metrology.frames import (
    Floats,
    apply,
    inverse,
    nearest_rotation,
    rigid,
    rotation_from_vector,
)
from app.metrology.refusal import Refusal

DIRECTIONS = (("crest", "floor"), ("front", "back"), ("left", "right"))
MIN_CONTACTS = 3
"""On each of three non-parallel faces: fewer leave no residual to judge by."""
MIN_SPREAD_MM = 0.5
"""Contacts whose rms distance from their best line is less count as lying on it."""
CONTACT_SD_MM = 0.001
"""Repeatability of the touch itself, beside the encoders' noise."""
OUTLIER_SIGMAS = 4.0
BESIDE_FACE_MM = 1.5
"""How far beside its face a contact may seem to lie before it counts as off it."""


@dataclass(frozen=True)
class FaceFit:
    """How well the contacts of one face lie on it; outliers are left out."""

    face: str
    points: int
    rms_mm: float
    form_mm: float
    """Largest minus smallest residual."""


@dataclass(frozen=True)
class Alignment:
    """The object's frame in the arm, and how well the contacts agree with it."""

    T_arm_obj: Floats
    """(4, 4)"""
    residuals_mm: Floats
    """(N,) distance of each contact from its face, positive outward."""
    outliers: NDArray[np.bool_]
    """(N,) contacts that were left out of the fit."""
    faces: tuple[FaceFit, ...]
    sigma_mm: float
    """A-posteriori standard deviation of one contact."""
    covariance: Floats
    """(6, 6) of a left perturbation (rx, ry, rz in rad; tx, ty, tz in mm) about ``centre_mm``."""
    centre_mm: Floats
    """(3,) pivot of that perturbation, in the arm frame: the contacts' centroid."""
    points_obj_mm: Floats
    """(N, 3) contact points, tip radius taken off, in the object frame."""

    @property
    def rms_mm(self) -> float:
        """Of the residuals of all contacts in the fit."""
        kept = self.residuals_mm[~self.outliers]
        return float(np.sqrt(np.mean(kept**2)))


@dataclass(frozen=True)
class Contacts:
    """Contact points with the planes that they touch."""

    features: tuple[str, ...]
    tips_mm: Floats  # (N, 3) tip centres in the arm frame
    normals: Floats  # (N, 3) outward normal of each contact's face, object frame
    reach_mm: Floats  # (N,) face offset plus tip radius
    tip_covariances_mm2: Floats  # (N, 3, 3) of the tip centres; equal where nothing is known

    def residuals_mm(self, T_arm_obj: Floats) -> Floats:
        """(N,) distance of each contact from its face, positive outward."""
        in_obj = apply(inverse(T_arm_obj), self.tips_mm)
        return np.asarray(np.einsum("ij,ij->i", self.normals, in_obj) - self.reach_mm)

    def sds_mm(self, T_arm_obj: Floats) -> Floats:
        """(N,) expected standard deviation of each contact along its face's normal."""
        normals_arm = self.normals @ T_arm_obj[:3, :3].T
        variances = np.einsum("ij,ijk,ik->i", normals_arm, self.tip_covariances_mm2, normals_arm)
        return np.asarray(np.sqrt(variances + CONTACT_SD_MM**2))


def what_is_missing(features: Sequence[str]) -> str:
    """What must still be probed before an alignment is possible; empty when nothing is.

    Args:
        features: the face of each contact taken so far.
    """
    wanted = []
    for faces in DIRECTIONS:
        taken = sum(features.count(face) for face in faces)
        if taken < MIN_CONTACTS:
            names = f"the {faces[0]} or the {faces[1]} face"
            wanted.append(f"{MIN_CONTACTS - taken} more on {names}")
    return "Touch " + ", ".join(wanted) if wanted else ""


def align(
    features: Sequence[str],
    tip_centres_mm: Floats,
    tip_radius_mm: float,
    block: Crenellated,
    tip_covariances_mm2: Floats | None = None,
) -> Alignment:
    """Fits the block's faces to contact points, all at once (paper, section 3.2, Fig. 3).

    Contacts that disagree with all others are left out and named by ``outliers``.

    Args:
        features: N faces, each one of ``FACES``.
        tip_centres_mm: (N, 3) centres of the probe's sphere, arm frame.
        tip_radius_mm: radius of that sphere, taken off along each face's normal.
        tip_covariances_mm2: (N, 3, 3) noise of each centre by the arm's encoders
            (``arm.tip_covariances``), which weighs the contacts; None: all alike.

    Raises:
        Refusal: unknown face, too few contacts, contacts on one line, or contacts
            that do not fit on the block as they are labelled.
    """
    contacts = _contacts(tuple(features), tip_centres_mm, tip_radius_mm, block, tip_covariances_mm2)
    _refuse_lines(contacts)
    start = _best_start(contacts, tip_radius_mm, block)
    T_arm_obj, kept = _fit_without_outliers(contacts, start)
    points_obj = _surface_points(contacts, T_arm_obj, tip_radius_mm)
    off_face = beside_face(contacts.features, points_obj, block) & kept
    if off_face.sum() > max(1, len(kept) // 10):
        raise _mislabelled(contacts.features, off_face)
    residuals = contacts.residuals_mm(T_arm_obj)
    J, centre_mm = _jacobian(contacts, T_arm_obj)
    sds_mm = contacts.sds_mm(T_arm_obj)
    scaled = residuals[kept] / sds_mm[kept]
    variance_factor = float(scaled @ scaled) / max(int(kept.sum()) - 6, 1)
    if tip_covariances_mm2 is not None:
        # few contacts may agree by luck: never claim less than the encoders' noise
        variance_factor = max(variance_factor, 1.0)
    J_scaled = J[kept] / sds_mm[kept, None]
    return Alignment(
        T_arm_obj=T_arm_obj,
        residuals_mm=residuals,
        outliers=~kept,
        faces=_face_fits(contacts.features, residuals, kept),
        sigma_mm=float(np.sqrt(variance_factor * np.mean(sds_mm[kept] ** 2))),
        covariance=np.asarray(variance_factor * np.linalg.inv(J_scaled.T @ J_scaled)),
        centre_mm=centre_mm,
        points_obj_mm=points_obj,
    )


def refuse_wrong_faces(alignment: Alignment, features: Sequence[str], block: Crenellated) -> None:
    """Refuses contacts that were labelled with one face and lie on another.

    A contact that merely slipped is an outlier and stays one; a contact that
    misses its own face by millimetres and lies on another is a mistake in the
    data that the operator must know of.

    Raises:
        Refusal: names the first such contact and the face that it lies on.
    """
    for i in map(int, np.flatnonzero(alignment.outliers)):
        if abs(alignment.residuals_mm[i]) < BESIDE_FACE_MM:
            continue
        point = alignment.points_obj_mm[i]
        found = [face for face in FACES if face != features[i] and _lies_on(point, face, block)]
        place = f"it lies on the {found[0]} face" if found else "it lies on no face at all"
        raise Refusal(
            "contact-on-wrong-face",
            f"contact {i + 1} is labelled {features[i]}, but misses that face by "
            f"{abs(alignment.residuals_mm[i]):.1f} mm",
            place,
            "Take it out, or label it with the face that was touched",
        )


def beside_face(
    features: Sequence[str], points_obj_mm: Floats, block: Crenellated
) -> NDArray[np.bool_]:
    """(N,) which contact points (N, 3) lie beside the bounds of the face they belong to."""
    x, y, z = points_obj_mm.T
    edges = np.array(block.edges_x_mm)
    slack = BESIDE_FACE_MM
    in_x = (x > edges[0] - slack) & (x < edges[-1] + slack)
    in_y = (y > block.front_y_mm - slack) & (y < block.back_y_mm + slack)
    in_z = (z > block.base_z_mm - slack) & (z < block.crest_z_mm + slack)
    within = {"x": in_y & in_z, "y": in_x & in_z, "z": in_x & in_y}
    axis = {"crest": "z", "floor": "z", "front": "y", "back": "y", "left": "x", "right": "x"}
    return np.array([not within[axis[face]][i] for i, face in enumerate(features)], dtype=bool)


def _contacts(
    features: tuple[str, ...],
    tip_centres_mm: Floats,
    tip_radius_mm: float,
    block: Crenellated,
    tip_covariances_mm2: Floats | None,
) -> Contacts:
    tips = np.asarray(tip_centres_mm, dtype=np.float64)
    for i, face in enumerate(features):
        if face not in FACES:
            raise Refusal(
                "unknown-face",
                f"contact {i + 1} is on an unknown face '{face}'",
                f"the faces are {', '.join(FACES)}",
            )
    if tips.shape != (len(features), 3) or not np.all(np.isfinite(tips)):
        raise Refusal(
            "bad-contacts", f"{len(features)} contacts were given with positions {tips.shape}"
        )
    missing = what_is_missing(features)
    if missing:
        raise Refusal(
            "too-few-contacts",
            f"{len(features)} contacts do not fix the object's position",
            f"at least {MIN_CONTACTS} are needed on each of three non-parallel faces",
            missing,
        )
    planes = [probing_face(block, face) for face in features]
    return Contacts(
        features=features,
        tips_mm=tips,
        normals=np.array([normal for normal, _ in planes]),
        reach_mm=np.array([offset for _, offset in planes]) + tip_radius_mm,
        tip_covariances_mm2=(
            np.zeros((len(features), 3, 3)) if tip_covariances_mm2 is None else tip_covariances_mm2
        ),
    )


def _refuse_lines(contacts: Contacts) -> None:
    labels = np.array(contacts.features)
    for faces in DIRECTIONS:
        own = [face for face in faces if face in contacts.features]
        spreads = {face: _in_plane_spread(contacts.tips_mm[labels == face]) for face in own}
        if max(spread for spread, _ in spreads.values()) < MIN_SPREAD_MM:
            face = max(own, key=lambda name: spreads[name][0])
            raise Refusal(
                "contacts-on-a-line",
                f"the {int((labels == face).sum())} contacts on the {face} face lie on one line",
                "the face can turn about that line",
                f"Touch the {face} face also beside that line",
            )


def _in_plane_spread(points_mm: Floats) -> tuple[float, Floats]:
    """Rms distance of points (N, 3) from their best line, and their plane's normal (3,).

    The plane is that of most of the points (least median of squares over triples),
    so that a contact on a wrong face does not tilt it.
    """
    if len(points_mm) < 3:
        return 0.0, np.zeros(3)
    triples = np.array(list(combinations(range(len(points_mm)), 3)))
    corners = points_mm[triples[:: max(1, len(triples) // 500)]]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    lengths = np.linalg.norm(normals, axis=1)
    proper = lengths > 1e-9 * np.max(lengths, initial=1e-9)
    if not proper.any():
        return 0.0, np.zeros(3)
    normals, corners = normals[proper] / lengths[proper, None], corners[proper]
    offsets = np.einsum("ij,ij->i", normals, corners[:, 0])
    distances = np.abs(points_mm @ normals.T - offsets)
    best = int(np.argmin(np.median(distances, axis=0)))
    near = distances[:, best] <= np.maximum(3 * np.median(distances[:, best]), 0.1)
    _, s, Vt = np.linalg.svd(points_mm[near] - points_mm[near].mean(axis=0))
    return float(s[1] / np.sqrt(near.sum())), Vt[2]


def _best_start(contacts: Contacts, tip_radius_mm: float, block: Crenellated) -> Floats:
    """The pose that puts most contacts onto their faces, among the four that fit as planes.

    Three perpendicular planes are matched equally well by four orientations of the
    block; only one of them has the contacts within the faces' bounds.
    """
    found: list[tuple[int, float, Floats]] = []
    for rotation in _start_rotations(contacts):
        T = _start_translation(contacts, rotation)
        for _ in range(20):
            T, step = _step(contacts, T, _huber(contacts.residuals_mm(T)))
            if step < 1e-9:
                break
        off_face = beside_face(
            contacts.features, _surface_points(contacts, T, tip_radius_mm), block
        )
        misfit = float(np.median(np.abs(contacts.residuals_mm(T))))
        found.append((int(off_face.sum()), misfit, T))
    return min(found, key=lambda start: start[:2])[2]


def _start_rotations(contacts: Contacts) -> list[Floats]:
    """The four rotations ``R_arm_obj`` that turn the block's axes into the planes touched."""
    labels = np.array(contacts.features)
    axes: list[Floats] = []
    for faces in DIRECTIONS:
        spreads = [_in_plane_spread(contacts.tips_mm[labels == face]) for face in faces]
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


def _start_translation(contacts: Contacts, rotation: Floats) -> Floats:
    """Least-squares ``T_arm_obj`` for a given ``R_arm_obj``: linear in the translation."""
    normals_arm = contacts.normals @ rotation.T
    along = np.einsum("ij,ij->i", normals_arm, contacts.tips_mm) - contacts.reach_mm
    translation, *_ = np.linalg.lstsq(normals_arm, along, rcond=None)
    return rigid(rotation, translation)


def _jacobian(contacts: Contacts, T_arm_obj: Floats) -> tuple[Floats, Floats]:
    """(N, 6) derivative of the residuals by a left perturbation of ``T_arm_obj``, and its pivot."""
    centre_mm = contacts.tips_mm.mean(axis=0)
    normals_arm = contacts.normals @ T_arm_obj[:3, :3].T
    arms = contacts.tips_mm - centre_mm
    return np.column_stack([-np.cross(arms, normals_arm), -normals_arm]), centre_mm


def _step(contacts: Contacts, T_arm_obj: Floats, weights: Floats) -> tuple[Floats, float]:
    """One weighted Gauss-Newton step; returns the new pose and the step's size in mm."""
    J, centre_mm = _jacobian(contacts, T_arm_obj)
    root = np.sqrt(weights)
    residuals = contacts.residuals_mm(T_arm_obj)
    change, *_ = np.linalg.lstsq(J * root[:, None], -residuals * root, rcond=None)
    turn = rotation_from_vector(np.asarray(change[:3]))
    moved = rigid(turn, centre_mm - turn @ centre_mm + change[3:])
    size = float(np.linalg.norm(change[3:]) + 100.0 * np.linalg.norm(change[:3]))
    return moved @ T_arm_obj, size


def _huber(residuals_mm: Floats) -> Floats:
    scale = 1.4826 * float(np.median(np.abs(residuals_mm))) + 1e-6
    return np.minimum(1.0, 1.5 * scale / np.maximum(np.abs(residuals_mm), 1e-12))


def _fit_without_outliers(
    contacts: Contacts, T_arm_obj: Floats
) -> tuple[Floats, NDArray[np.bool_]]:
    """Least squares on the contacts that agree; (N,) mask of those kept.

    One contact at a time is dropped, the one whose residual is largest against
    its own standard deviation (its leverage taken into account), as long as it
    exceeds the limit and enough contacts remain.
    """
    kept = np.ones(len(contacts.features), dtype=bool)
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


def _worst_outlier(contacts: Contacts, T_arm_obj: Floats, kept: NDArray[np.bool_]) -> int | None:
    """Index of the contact that most exceeds the limit, by its deleted (studentised) residual."""
    J, _ = _jacobian(contacts, T_arm_obj)
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
    # Student's t has heavier tails than the normal when few contacts remain
    limit = OUTLIER_SIGMAS * (1 + 4.0 / freedom)
    for worst in np.argsort(-deleted):
        if deleted[worst] <= limit:
            return None
        face = contacts.features[int(own[worst])]
        remaining = [contacts.features[int(i)] for i in own if i != own[worst]]
        if face in remaining and not what_is_missing(remaining):
            return int(own[worst])
    return None


def _surface_points(contacts: Contacts, T_arm_obj: Floats, tip_radius_mm: float) -> Floats:
    return np.asarray(
        apply(inverse(T_arm_obj), contacts.tips_mm) - tip_radius_mm * contacts.normals
    )


def _face_fits(
    features: Sequence[str], residuals_mm: Floats, kept: NDArray[np.bool_]
) -> tuple[FaceFit, ...]:
    labels = np.array(features)
    fits = []
    for face in FACES:
        own = residuals_mm[(labels == face) & kept]
        if len(own):
            rms = float(np.sqrt(np.mean(own**2)))
            fits.append(FaceFit(face, len(own), rms, float(np.ptp(own))))
    return tuple(fits)


def _lies_on(point_mm: Floats, face: str, block: Crenellated) -> bool:
    normal, offset_mm = probing_face(block, face)
    near = abs(float(normal @ point_mm) - offset_mm) < 2 * BESIDE_FACE_MM
    return near and not bool(beside_face([face], point_mm[None], block)[0])


def _mislabelled(features: Sequence[str], off_face: NDArray[np.bool_]) -> Refusal:
    faces = sorted({features[int(i)] for i in np.flatnonzero(off_face)})
    return Refusal(
        "contacts-do-not-fit",
        f"{int(off_face.sum())} of {len(features)} contacts lie beside the face they are labelled "
        f"with ({', '.join(faces)})",
        "no position of this block brings them onto it",
        "Check which face each contact was taken on, the tip, and the object's certificate",
    )
