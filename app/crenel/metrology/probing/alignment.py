"""The pose of the object in the arm frame: ``T_arm_obj`` from contact points (the article's
M_CAL->CMA).

Every contact point gives one equation: the tip centre is one tip radius outside the face that was
probed. All faces are fitted together by least squares.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from crenel.errors import OperationError
from crenel.messages.message import join, message, quantity, word
from crenel.metrology.adjustment.core.arm_errors import tip_errors_by_links
from crenel.metrology.arm.kinematics import Arm, tip_centres, tip_covariances
from crenel.metrology.fitting.touched_shape import refuse_doubt
from crenel.metrology.probing.contact_fit import best_start, fit_without_outliers, jacobian
from crenel.metrology.probing.contacts import (
    FACE_SLACK_MM,
    build_contacts,
    off_face_mask,
    refuse_lines,
    surface_points,
)
from crenel.metrology.targets.crenellated_block import FACES, Crenellated, on_face, probing_face
from crenel.metrology.transforms import Floats

# If contact points fit worse than this, and some not at all, no single one is the cause.
POOR_FIT_MM = 0.3
# More contact points than this beside the faces are no slip of the hand but wrong labels.
FEW_IN_AIR = 2
# With fewer others, the place of the block is not certain enough to say so.
LEAST_KEPT = 9
ARM_OFF_MM = 0.02
"""Rms error of the tip over the arm's reach, as is usual."""
CHECK_THE_ARM = message("check-arms-file-lengths-angles-signs")


@dataclass(frozen=True)
class FaceFit:
    """How well the contact points of one face fit it; outliers are excluded."""

    face: str
    points: int
    rms_mm: float
    form_mm: float
    """Largest minus smallest residual."""


@dataclass(frozen=True)
class Alignment:
    """The object's frame in the arm frame, and how well the contact points agree with it."""

    T_arm_obj: Floats
    """(4, 4)"""
    residuals_mm: Floats
    """(N,) distance of each contact point from its face, positive outward."""
    outliers: NDArray[np.bool_]
    """(N,) contact points that were excluded from the fit."""
    faces: tuple[FaceFit, ...]
    doubtful: NDArray[np.bool_]
    """(N,) contact points of which one contradicts the others; the data cannot tell which."""
    sigma_mm: float
    """A-posteriori standard deviation of one contact point."""
    covariance: Floats
    """(6, 6) of a left perturbation (rx, ry, rz in rad; tx, ty, tz in mm) about ``centre_mm``."""
    centre_mm: Floats
    """(3,) pivot of that perturbation, in the arm frame: the centroid of the contact points."""
    points_obj_mm: Floats
    """(N, 3) contact points, with the tip radius subtracted, in the object frame."""
    tips_obj_mm: Floats
    """(N, 3) tip centres in the object frame."""
    face_offsets_mm: dict[str, float] = field(default_factory=dict)
    """How much further out than certified the contacts put each face, where the certificate leaves
    that open; the residuals are then from the faces as found."""

    @property
    def rms_mm(self) -> float:
        """Rms residual of all contact points in the fit."""
        kept = self.residuals_mm[~self.outliers]
        return float(np.sqrt(np.mean(kept**2)))


def align(
    features: Sequence[str],
    tip_centres_mm: Floats,
    tip_radius_mm: float,
    block: Crenellated,
    tip_covariances_mm2: Floats | None = None,
    tip_shared_mm: Floats | None = None,
) -> Alignment:
    """Fits all faces of the block to the contact points together.

    Faces that the certificate leaves open by more than ``OPEN_MM`` are found with the pose. Contact
    points that contradict the others are excluded and marked in ``outliers``.

    Args:
        features: the face of each of the N contact points, one of ``FACES``.
        tip_centres_mm: (N, 3) centres of the tip's sphere, arm frame.
        tip_radius_mm: radius of that sphere, subtracted along the normal of each face.
        tip_covariances_mm2: (N, 3, 3) noise of each centre by the arm's encoders
            (``kinematics.tip_covariances``), which weights the contact points; None: equal
            weights.
        tip_shared_mm: (N, 3, L) what shared errors (the arm's links) may move each centre by,
            k = 1: contacts that differ by no more do not contradict each other; None: nothing.

    Returns:
        ``T_arm_obj`` with its covariance, and the residual of each contact point.

    Raises:
        OperationError: ``unknown-face``, ``bad-contacts``; ``too-few-contacts`` or
            ``contacts-on-a-line`` if they do not determine the pose; ``contacts-mirrored`` or
            ``contacts-do-not-fit`` if the block does not fit them as labelled.

    Source:
        The article, section 3.2 and Fig. 3.
    """
    contacts = build_contacts(
        tuple(features), tip_centres_mm, tip_radius_mm, block, tip_covariances_mm2, tip_shared_mm
    )
    refuse_lines(contacts, block)
    start = best_start(contacts, tip_radius_mm, block)
    fit, kept, doubtful = fit_without_outliers(contacts, start)
    T_arm_obj = fit.T_arm_obj
    points_obj = surface_points(contacts, T_arm_obj, tip_radius_mm)
    off_face = off_face_mask(contacts.features, points_obj, block) & kept
    if 0 < off_face.sum() <= FEW_IN_AIR and len(kept) - off_face.sum() >= LEAST_KEPT:
        # there is nothing that it could have touched: it was taken in the air
        fit, kept, doubtful = fit_without_outliers(contacts, T_arm_obj, ~off_face)
        T_arm_obj = fit.T_arm_obj
        points_obj = surface_points(contacts, T_arm_obj, tip_radius_mm)
        off_face = off_face_mask(contacts.features, points_obj, block) & kept
    if off_face.sum() > max(1, len(kept) // 10):
        mirrored = points_obj * [-1, 1, 1] + [block.edges_x_mm[0] + block.edges_x_mm[-1], 0, 0]
        if not (off_face_mask(contacts.features, mirrored, block) & kept).any():
            raise _mirror_error(int(off_face.sum()), len(kept))
        raise _label_error(contacts.features, off_face)
    residuals = contacts.with_faces_at(fit.offsets_mm).residuals_mm(T_arm_obj)
    J, centre_mm = jacobian(contacts, T_arm_obj)
    sds_mm = contacts.sds_mm(T_arm_obj)
    scaled = residuals[kept] / sds_mm[kept]
    unknowns = 6 + len(contacts.faces)
    variance_factor = float(scaled @ scaled) / max(int(kept.sum()) - unknowns, 1)
    if tip_covariances_mm2 is not None:
        # few contact points may agree by chance: never claim less than the encoder noise
        variance_factor = max(variance_factor, 1.0)
    J_scaled = J[kept] / sds_mm[kept, None]
    return Alignment(
        T_arm_obj=T_arm_obj,
        residuals_mm=residuals,
        outliers=~kept,
        faces=_face_fits(contacts.features, residuals, kept),
        doubtful=doubtful,
        sigma_mm=float(np.sqrt(variance_factor * np.mean(sds_mm[kept] ** 2))),
        covariance=np.asarray(variance_factor * np.linalg.inv(J_scaled.T @ J_scaled)),
        centre_mm=centre_mm,
        points_obj_mm=points_obj,
        tips_obj_mm=points_obj + tip_radius_mm * contacts.normals,
        face_offsets_mm=dict(zip(contacts.faces, fit.offsets_mm.tolist(), strict=True)),
    )


def align_by_arm(
    arm: Arm, block: Crenellated, features: Sequence[str], contact_q_rad: Floats
) -> Alignment:
    """``align`` of contact points by the arm's angles (N, n), weighted by its encoders' noise.

    Links that are off move the tip otherwise where elbow or wrist are turned over: what they may
    do, contacts may differ by.

    Raises:
        OperationError: as ``align``.
    """
    noise = tip_covariances(arm, contact_q_rad)
    return align(
        features,
        tip_centres(arm, contact_q_rad),
        arm.tip.radius_mm,
        block,
        noise if np.any(noise) else None,
        tip_errors_by_links(arm, contact_q_rad, ARM_OFF_MM),
    )


def align_contacts(
    arm: Arm, block: Crenellated, features: Sequence[str], contact_q_rad: Floats
) -> Alignment:
    """``align_by_arm``, refused where contact points are labelled with a wrong face.

    Raises:
        OperationError: as ``align`` and ``refuse_wrong_faces``.
    """
    alignment = align_by_arm(arm, block, features, contact_q_rad)
    refuse_wrong_faces(alignment, features, block)
    return alignment


def refuse_wrong_faces(alignment: Alignment, features: Sequence[str], block: Crenellated) -> None:
    """Refuses contact points that are labelled with one face and lie on another.

    A contact point that slipped is an outlier and remains one. A contact point that misses its own
    face by millimetres is a mistake in the data, which the operator must know about. If the others
    do not agree either, no single contact point is the cause.

    Args:
        alignment: the result of ``align`` for these contact points.
        features: the face of each of the N contact points.

    Raises:
        OperationError: ``contact-on-wrong-face`` names the first such contact point and the face on
            which it lies; ``contacts-do-not-fit``; as ``refuse_doubt``.
    """
    refuse_doubt(alignment.doubtful)
    missing = np.abs(alignment.residuals_mm) >= FACE_SLACK_MM
    far = alignment.outliers & missing
    count = int((alignment.outliers | missing).sum())
    if count and alignment.rms_mm > POOR_FIT_MM:
        raise OperationError(
            "contacts-do-not-fit",
            message(
                "contacts-fit-block-rms-only-all",
                rms=quantity(alignment.rms_mm, "mm", 2),
                beside=count,
                count=len(far),
            ),
            message("no-single-contact-fault"),
            CHECK_THE_ARM,
        )
    for i in map(int, np.flatnonzero(far)):
        found = other_face(alignment, i, features[i], block)
        place = message("lies-face", where=on_face(found)) if found else message("lies-no-face-all")
        raise OperationError(
            "contact-on-wrong-face",
            message(
                "contact-labelled-but-misses-face",
                number=i + 1,
                face=word(features[i]),
                distance=quantity(abs(alignment.residuals_mm[i]), "mm", 1),
            ),
            place,
            message("take-out-label-face-touched"),
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


def other_face(alignment: Alignment, contact: int, labelled: str, block: Crenellated) -> str:
    """The face next to the labelled one that a contact's tip touches; empty if there is none."""
    tip = alignment.tips_obj_mm[contact]
    radius_mm = float(np.linalg.norm(tip - alignment.points_obj_mm[contact]))
    found = (face for face in FACES if _touches(tip, radius_mm, face, block))
    return next((face for face in found if face != labelled), "")


def _touches(tip_mm: Floats, radius_mm: float, face: str, block: Crenellated) -> bool:
    normal, offset_mm = probing_face(block, face)
    point = tip_mm - radius_mm * normal
    near = abs(float(normal @ point) - offset_mm) < FACE_SLACK_MM
    return near and not bool(off_face_mask([face], point[None], block)[0])


def _mirror_error(off_face: int, contacts: int) -> OperationError:
    return OperationError(
        "contacts-mirrored",
        message("contacts-lie-beside-crests-floors-were", off_face=off_face, contacts=contacts),
        message("merlons-stand-mirrored-order"),
        message("check-objects-certificate-which-sides-front"),
    )


def _label_error(features: Sequence[str], off_face: NDArray[np.bool_]) -> OperationError:
    faces = sorted({features[int(i)] for i in np.flatnonzero(off_face)})
    remedy = message("check-which-face-each-contact-taken")
    if 2 * off_face.sum() > len(features):
        remedy = CHECK_THE_ARM
    return OperationError(
        "contacts-do-not-fit",
        message(
            "contacts-lie-beside-face-they-labelled",
            beside=int(off_face.sum()),
            count=len(features),
            faces=join([word(face) for face in faces]),
        ),
        message("no-position-block-brings-them-onto"),
        remedy,
    )
