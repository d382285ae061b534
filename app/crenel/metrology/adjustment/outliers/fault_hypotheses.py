"""Possible faults in all contact points together, or in the certificate: the diameter or the
position of the tip, the size of the object between faces or in total, or an object that moved
before the pictures were taken.

One fault can look like another, and like link errors: the fault with the strongest evidence is
reported.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np

from crenel.messages.message import message, quantity, rounded, signed
from crenel.metrology.adjustment.core.gauss_newton import AdjustmentResult
from crenel.metrology.adjustment.core.observations import ContactObservations
from crenel.metrology.adjustment.outliers.bayes_factors import (
    FaultEstimate,
    FaultHypothesis,
    estimate_faults,
)
from crenel.metrology.calibration.findings import (
    OPENING_MM,
    OPPOSITE,
    CalibrationFinding,
    offset_quality,
    size_agreement_finding,
    size_error_finding,
    size_unchecked_finding,
)
from crenel.metrology.limits import Limits
from crenel.metrology.transforms import Floats

# Twice the logarithm of the Bayes factor from which a fault is reported: strong evidence (Kass and
# Raftery 1995).
EVIDENCE = 6.0
# Diameters and displacements smaller than this are not reported.
DIAMETER_MM, LEAST_MM = 0.02, 0.03
# Typical sizes of faults, in either direction: worn, bent or nudged, or a different object.
SIZE_SDS_MM = (0.05, 0.5)
PLACE_SDS_MM = (0.1, 0.5)
MOVED_SDS_MM, MOVED_SDS_RAD = (0.1, 2.0), (1e-3, 2e-2)
SHARE_SDS = (0.003, 0.03)
# Typical distance of points from the axis of a rotation, and from the origin of a size.
LEVER_MM = 100.0

DescribeFault = Callable[[FaultEstimate], CalibrationFinding | None]


@dataclass(frozen=True)
class _Fault:
    hypothesis: FaultHypothesis
    describe: DescribeFault


def block_fault_findings(found: AdjustmentResult, limits: Limits) -> list[CalibrationFinding]:
    """The most likely fault, if any, and whether the data show the size of the block."""
    touches = found.problem.contacts
    assert touches is not None
    pairs = _pairs(touches)
    faces = [
        _Fault(
            _size_hypothesis(found, np.isin(touches.features, pair).astype(np.float64)),
            partial(_opening_finding, pair, limits),
        )
        for pair in pairs
    ]
    in_all = _Fault(_scale_hypothesis(found), partial(_block_size_finding, limits))
    named, estimates = _most_likely_fault(
        found, [*faces, in_all, *_contact_faults(found, touches, limits)]
    )
    if not pairs:
        return [*named, size_unchecked_finding()]
    openings = {
        pair: 2 * float(one.sizes[0])
        for pair, one in zip(pairs, estimates[: len(pairs)], strict=True)
    }
    return named or [size_agreement_finding(openings)]


def board_fault_findings(
    found: AdjustmentResult, square_mm: float, limits: Limits
) -> list[CalibrationFinding]:
    """The most likely fault, if any; the board need not have been probed."""
    touches = found.problem.contacts
    in_all = _Fault(_scale_hypothesis(found), partial(_board_size_finding, square_mm, limits))
    contacts = [] if touches is None else _contact_faults(found, touches, limits)
    return _most_likely_fault(found, [in_all, *contacts])[0]


def _contact_faults(
    found: AdjustmentResult, touches: ContactObservations, limits: Limits
) -> list[_Fault]:
    return [
        _Fault(
            _size_hypothesis(found, np.ones(len(touches))),
            partial(_diameter_finding, touches, limits),
        ),
        _Fault(_tip_hypothesis(found, touches), partial(_tip_finding, limits)),
        _Fault(_motion_hypothesis(found, touches), partial(_motion_finding, limits)),
    ]


def _most_likely_fault(
    found: AdjustmentResult, faults: Sequence[_Fault]
) -> tuple[list[CalibrationFinding], list[FaultEstimate]]:
    """The fault that stands out most, if any, and the estimate of each."""
    estimates = estimate_faults(found, [fault.hypothesis for fault in faults])
    doubted = [
        (one.evidence, finding)
        for one, fault in zip(estimates, faults, strict=True)
        if one.evidence >= EVIDENCE and (finding := fault.describe(one)) is not None
    ]
    return ([max(doubted, key=lambda one: one[0])[1]] if doubted else []), estimates


def _pairs(touches: ContactObservations) -> list[tuple[str, str]]:
    labels = np.array(touches.features)[touches.inliers]
    return [pair for pair in OPPOSITE if all(face in labels for face in pair)]


def _size_hypothesis(found: AdjustmentResult, outward: Floats) -> FaultHypothesis:
    """The tip centre further out on the faces for which ``outward`` (N,) is 1."""
    return _contact_hypothesis(
        found, -outward[:, None], tuple(np.array([sd]) for sd in SIZE_SDS_MM)
    )


def _tip_hypothesis(found: AdjustmentResult, touches: ContactObservations) -> FaultHypothesis:
    """The tip centre elsewhere, in the flange frame (mm)."""
    by = np.einsum("ni,nij->nj", _normals(found, touches), touches.R_arm_flange)
    return _contact_hypothesis(found, by, tuple(np.full(3, sd) for sd in PLACE_SDS_MM))


def _motion_hypothesis(found: AdjustmentResult, touches: ContactObservations) -> FaultHypothesis:
    """The object elsewhere during probing: rotated about the middle of the contact points (rad) and
    translated (mm), arm frame."""
    normals = _normals(found, touches)
    arms = touches.tips_mm - touches.tips_mm[touches.inliers].mean(axis=0)
    by = -np.column_stack([np.cross(arms, normals), normals])
    sds = tuple(np.repeat(pair, 3) for pair in zip(MOVED_SDS_RAD, MOVED_SDS_MM, strict=True))
    return _contact_hypothesis(found, by, sds)


def _scale_hypothesis(found: AdjustmentResult) -> FaultHypothesis:
    """The object larger than its certificate by a share of all its lengths."""
    prior, contacts = found.problem.prior.coordinates[:, None], found.linear.contacts
    nothing = np.zeros((0 if contacts is None else len(contacts.residuals_mm), 1))
    return FaultHypothesis(nothing, -prior, tuple(np.array([sd]) for sd in SHARE_SDS))


def _contact_hypothesis(
    found: AdjustmentResult, by: Floats, sds: tuple[Floats, ...]
) -> FaultHypothesis:
    """The hypothesis of a fault that changes the residuals of the contact points (N) by ``by`` (N,
    K)."""
    touches, prior = found.problem.contacts, found.problem.prior
    assert touches is not None
    return FaultHypothesis(
        by[touches.inliers], np.zeros((len(prior.coordinates), by.shape[1])), sds
    )


def _normals(found: AdjustmentResult, touches: ContactObservations) -> Floats:
    return np.asarray(touches.normals @ found.state.T_arm_obj[:3, :3].T)


def _diameter_finding(
    touches: ContactObservations, limits: Limits, estimate: FaultEstimate
) -> CalibrationFinding | None:
    outward_mm = float(estimate.sizes[0])
    if 2 * abs(outward_mm) < DIAMETER_MM:
        return None
    remedy = message("check-which-tip-mounted-diameter-object")
    if len(set(touches.features)) == 1:  # one plane alone does not distinguish the three
        remedy = message("check-mounted-tip-and-object-not-moved")
    given = 2 * touches.radius_mm
    fitted_mm, known_mm = given + 2 * outward_mm, 4 * float(np.sqrt(estimate.covariance[0, 0]))
    return CalibrationFinding(
        offset_quality(outward_mm, limits),
        "tip-diameter",
        message(
            "contacts-pictures-agree-better-tip-than",
            fitted=quantity(fitted_mm, "mm", 3),
            known=quantity(known_mm, "", 3),
            given=quantity(given, "mm", 3),
        ),
        remedy,
    )


def _opening_finding(
    pair: tuple[str, str], limits: Limits, estimate: FaultEstimate
) -> CalibrationFinding | None:
    opening_mm = 2 * float(estimate.sizes[0])
    if abs(opening_mm) < OPENING_MM:
        return None
    return size_error_finding(pair, opening_mm, OPENING_MM, limits)


def _tip_finding(limits: Limits, estimate: FaultEstimate) -> CalibrationFinding | None:
    off_mm = float(np.linalg.norm(estimate.sizes))
    if off_mm < LEAST_MM:
        return None
    x, y, z = estimate.sizes
    known_mm = 2 * float(np.sqrt(np.max(np.diag(estimate.covariance))))
    return CalibrationFinding(
        offset_quality(off_mm, limits),
        "tip-place",
        message(
            "contacts-pictures-agree-better-tips-centre",
            off=quantity(off_mm, "mm", 2),
            x=signed(x, "", 2),
            y=signed(y, "", 2),
            z=signed(z, "mm", 2),
            known=quantity(known_mm, "", 2),
        ),
        message("check-which-tip-mounted-stylus-straight"),
    )


def _motion_finding(limits: Limits, estimate: FaultEstimate) -> CalibrationFinding | None:
    turned_rad, off_mm = (float(np.linalg.norm(part)) for part in np.split(estimate.sizes, 2))
    if max(off_mm, LEVER_MM * turned_rad) < LEAST_MM:
        return None
    turned_deg = np.degrees(turned_rad)
    along = estimate.sizes[3:] / max(off_mm, 1e-9)
    known_mm = 2 * float(np.sqrt(along @ estimate.covariance[3:, 3:] @ along))
    text = message(
        "pictures-have-object-where-touched-turned",
        off=quantity(off_mm, "mm", 2),
        known=quantity(known_mm, "", 2),
        turned=quantity(turned_deg, "°", 2),
    )
    if off_mm < known_mm:
        text = message(
            "pictures-have-object-turned-how-touched", turned=quantity(turned_deg, "°", 2)
        )
    return CalibrationFinding(
        offset_quality(max(off_mm, LEVER_MM * turned_rad), limits),
        "object-moved",
        text,
        message("fix-object-arm-so-neither-can"),
    )


def _block_size_finding(limits: Limits, estimate: FaultEstimate) -> CalibrationFinding | None:
    share, known = float(estimate.sizes[0]), 200 * float(np.sqrt(estimate.covariance[0, 0]))
    if LEVER_MM * abs(share) < LEAST_MM:
        return None
    percent = 100 * abs(share)
    return CalibrationFinding(
        offset_quality(LEVER_MM * share, limits),
        "object-size",
        message(
            "arms-motion-object-than-certificate-says",
            share=quantity(percent, "%", 2),
            uncertainty=quantity(known, "", 2),
            sign="larger" if share > 0 else "smaller",
        ),
        message("check-object-certificate-lengths-mm"),
    )


def _board_size_finding(
    square_mm: float, limits: Limits, estimate: FaultEstimate
) -> CalibrationFinding | None:
    share, sd = float(estimate.sizes[0]), float(np.sqrt(estimate.covariance[0, 0]))
    if LEVER_MM * abs(share) < LEAST_MM:
        return None
    return CalibrationFinding(
        offset_quality(LEVER_MM * share, limits),
        "board-size",
        message(
            "arms-motion-squares-wide-certificate",
            width=quantity((1 + share) * square_mm, "mm", 3),
            uncertainty=quantity(2 * sd * square_mm, "", 3),
            nominal=rounded(square_mm, "mm"),
        ),
        message("measure-pattern-over-all-squares-correct"),
    )
