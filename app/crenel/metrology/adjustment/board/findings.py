"""The findings of a calibration on a chessboard, most severe first."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from crenel.errors import sentence
from crenel.messages.limits import beside_limit
from crenel.messages.message import message, quantity
from crenel.metrology.adjustment.board.initial_guess import BoardObservation
from crenel.metrology.adjustment.board.results import BoardContacts
from crenel.metrology.adjustment.board.surface import coordinate_groups, surface_height_mm
from crenel.metrology.adjustment.core.gauss_newton import AdjustmentResult
from crenel.metrology.adjustment.core.uncertainty import KEPT, CalibrationUncertainty
from crenel.metrology.adjustment.outliers.fault_hypotheses import board_fault_findings
from crenel.metrology.adjustment.results.findings import alike_findings, joint_rms, picture_findings
from crenel.metrology.adjustment.results.poses import PoseResult
from crenel.metrology.calibration.findings import (
    CalibrationFinding,
    contact_outlier_findings,
    pixel_aspect_findings,
    sort_by_severity,
    uncertainty_verdict,
)
from crenel.metrology.limits import Limits
from crenel.metrology.robust import median
from crenel.metrology.stripe import usual_steepness
from crenel.metrology.targets.chessboard import Chessboard, corner_points

# Name of a robot's contribution in the budget.
ROBOT_ROW = "robot's poses"
REMEDIES = {
    KEPT: message("take-more-pictures-for-camera-and-mounting"),
    "contact points": message("touch-more-points-spread-wide-over"),
    "arm encoders": message("take-more-pictures-all-sides-hold"),
    "arm geometry": message("take-more-pictures-all-sides-have"),
    "object certificate": message("measure-patterns-width-height-fix-flat"),
    "edges and corners": message("light-board-evenly-sharp-large-picture"),
    "stripe": message("take-more-pictures-lasers-line-flat"),
    "distortion": message("take-more-pictures-board-all-corners"),
}
# Pixels across for one along, from which lines run along the other axis.
STEEPEST = 1.5
# Every pose adds the same information; at most this many are asked for.
MOST_ASKED = 60
# Robot and pictures disagree in the board's tilt by more than this, and by more than in rotation.
ROCKING_RAD, ROCKING_TIMES = 1e-3, 3.0
# A board that bends by more than this multiple of its flatness is not mounted correctly.
PRINT_TIMES = 3.0
BENT_TIMES, FLATTEST_MM = 2.0, 0.01
FEW_POSES = 6
# Parameters of a robot's noise: three rotations, three translations, two tilts.
TURNS_SHIFTS_TILTS = 8
NO_PLANE = CalibrationFinding(
    "attention",
    "no-laser-plane",
    message("no-laser-plane-yet"),
    sentence(message("add-the-laser-to-camera-and-mounting")),
)


@dataclass(frozen=True)
class BoardEvidence:
    """Everything by which a calibration on a board is judged."""

    board: Chessboard
    observations: Sequence[BoardObservation]
    result: AdjustmentResult
    uncertainty: CalibrationUncertainty
    poses: Sequence[PoseResult]
    limits: Limits
    excluded_lines_mm: dict[int, float]  # mm by pose number: lines of a laser that moved, excluded
    contradicting_lines_mm: dict[int, float]  # the same for lines that are kept
    contacts: BoardContacts | None
    repeated: tuple[int, ...]  # poses whose picture is that of another pose


def board_findings(evidence: BoardEvidence) -> tuple[CalibrationFinding, ...]:
    """The verdict by the uncertainty of a point, with all findings, most severe first."""
    result = evidence.result
    findings = (
        _verdict(evidence),
        *_contact_findings(evidence),
        *board_fault_findings(result, evidence.board.square_mm, evidence.limits),
        *_print_findings(evidence),
        _bend_finding(evidence),
        *_pose_findings(evidence),
        *_rocking_findings(result),
        *picture_findings((pose.number, pose.image_findings) for pose in evidence.observations),
        *pixel_aspect_findings(result.state.camera, result.covariance[:2, :2]),
        *(_laser_findings(evidence) if result.problem.has_lines else [NO_PLANE]),
    )
    return sort_by_severity(findings)


def _verdict(evidence: BoardEvidence) -> CalibrationFinding:
    """The verdict by the user's limits; the remedies are more pictures or a laser that stays in
    place."""
    known, limits = evidence.uncertainty, evidence.limits
    poses = len(evidence.result.problem.views)
    limit = limits.good_um if known.total_um <= limits.usable_um else limits.usable_um
    asked = int(np.ceil(poses * (known.total_um / limit) ** 2))
    remedies = dict(REMEDIES)
    remedies[ROBOT_ROW] = (
        message("take-more-pictures-like-these", asked=asked)
        if asked <= MOST_ASKED
        else message("take-more-pictures-robot-at-fault")
    )
    if evidence.excluded_lines_mm or evidence.contradicting_lines_mm:
        remedies["stripe"] = message("let-laser-come-rest-take-pictures")
    point: Literal["scanned", "seen"] = "scanned" if known.plane is not None else "seen"
    return uncertainty_verdict(known.total_um, known.rows, limits, remedies, point)


def _contact_findings(evidence: BoardEvidence) -> list[CalibrationFinding]:
    contacts, touches, limits = evidence.contacts, evidence.result.problem.contacts, evidence.limits
    if contacts is None or touches is None:
        return []
    count, rms_um = int((~contacts.excluded).sum()), contacts.rms_um
    text = message("contacts-lie-board-rms", count=count, rms=quantity(rms_um, "µm"))
    findings = [CalibrationFinding("good", "contacts", text)]
    if rms_um > limits.good_um:
        rms, good = beside_limit(rms_um, limits.good_um, "µm")
        text = message("contacts-lie-board-rms-up-good", count=count, rms=rms, good=good)
        remedy = message("check-tip-one-arms-file-board")
        findings = [CalibrationFinding("attention", "contacts", text, remedy)]
    left_out = contact_outlier_findings(touches.features, contacts.residuals_um, contacts.excluded)
    return [*findings, *left_out]


def _print_findings(evidence: BoardEvidence) -> list[CalibrationFinding]:
    """The measured corner positions against the certificate, which may not state them."""
    board, prior = evidence.board, evidence.result.problem.prior
    estimate_mm = float(prior.sd[coordinate_groups(board)[1]][0])
    if estimate_mm < PRINT_TIMES * board.standard_uncertainty_mm:
        return []
    return [
        CalibrationFinding(
            "attention",
            "board-print",
            message(
                "corners-lie-off-regular-pattern-certificate",
                off=quantity(1e3 * estimate_mm, "µm"),
                standard_uncertainty=quantity(1e3 * board.standard_uncertainty_mm, "µm"),
            ),
            message("check-board-how-exact-certificate-takes"),
        )
    ]


def _bend_finding(evidence: BoardEvidence) -> CalibrationFinding:
    result, board = evidence.result, evidence.board
    bend = surface_height_mm(board, result.state.coordinates, corner_points(board)[:, :2])
    rms_mm = float(np.sqrt(np.mean(bend**2)))
    if rms_mm > BENT_TIMES * max(board.flatness_mm, FLATTEST_MM):
        return CalibrationFinding(
            "attention",
            "board-bent",
            message(
                "board-bends-over-pattern-flat-expected",
                bend=quantity(np.ptp(bend), "mm", 2),
                flatness=quantity(board.flatness_mm, "mm", 2),
            ),
            message("fix-board-flat-plate"),
        )
    text = message("board-bends-over-pattern-allowed", bend=quantity(1e3 * np.ptp(bend), "µm"))
    return CalibrationFinding("neutral", "board-bend", text)


def _pose_findings(evidence: BoardEvidence) -> list[CalibrationFinding]:
    used = [pose for pose in evidence.poses if pose.used]
    observed = {pose.number for pose in evidence.observations}  # other findings have remedies
    unreadable = {one.number: one.laser_error for one in evidence.observations if one.laser_error}
    about_lines = (  # reported with the lines
        evidence.excluded_lines_mm | evidence.contradicting_lines_mm | unreadable
    )
    findings = [
        CalibrationFinding(
            "attention",
            "pose-left-out",
            message("pose-for-reason", number=pose.number, reason=pose.reason),
            message("check-laser-board-camera-not-moved") if pose.number in observed else "",
        )
        for pose in evidence.poses
        if pose.reason
        and not (pose.used and pose.number in about_lines)
        and pose.number not in evidence.repeated
    ]
    if evidence.repeated:
        text = message("identical-pictures-count-once", poses=_join_numbers(evidence.repeated))
        remedy = sentence(message("take-a-picture-in-each-pose"))
        findings.append(CalibrationFinding("attention", "picture-twice", text, remedy))
    off = [pose.off_um for pose in used]
    furthest = used[int(np.argmax(off))]
    findings.append(
        CalibrationFinding(
            "attention" if len(used) < FEW_POSES else "good",
            "poses",
            message(
                "poses-agree-boards-place-pose-furthest",
                used=len(used),
                median=quantity(median(off), "µm"),
                number=furthest.number,
                off=quantity(furthest.off_um, "µm"),
            ),
            message("take-more-pictures-tilted") if len(used) < FEW_POSES else "",
        )
    )
    return [*findings, *alike_findings(evidence.result.problem.motion.T_arm_flange)]


def _rocking_findings(result: AdjustmentResult) -> list[CalibrationFinding]:
    """Robot poses that agree on the board's position better than on its tilt."""
    sd = result.scales.noise * result.problem.motion.noise_sd
    if len(sd) != TURNS_SHIFTS_TILTS or len(result.problem.views) < FEW_POSES:
        return []
    turn, tilt = float(sd[0]), float(sd[-1])
    if tilt < max(ROCKING_RAD, ROCKING_TIMES * turn):
        return []
    return [
        CalibrationFinding(
            "attention",
            "board-rocks",
            message(
                "robot-pictures-agree-boards-place-but",
                tilt=quantity(1e3 * tilt, "mrad", 1),
                turn=quantity(1e3 * turn, "mrad", 1),
            ),
            message("fix-board-so-cannot-rock-warp"),
        )
    ]


def _laser_findings(evidence: BoardEvidence) -> list[CalibrationFinding]:
    return [
        *_line_findings(evidence),
        *_laser_picture_findings(evidence),
        _stripe_finding(evidence),
    ]


def _line_findings(evidence: BoardEvidence) -> list[CalibrationFinding]:
    """Lines that contradict the others and are too many to be mistakes, and the true reason."""
    steep = [usual_steepness(one.stripe) for one in evidence.observations]
    steep = [one for one in steep if np.isfinite(one)]
    if steep and median(steep) > STEEPEST:
        axis = evidence.observations[0].stripe.axis
        text = message("lines-run-along-other-axis", axis=axis)
        remedy = message("set-stripe-axis", axis="v" if axis == "u" else "u")
        return [CalibrationFinding("attention", "stripe-axis", text, remedy)]
    before, apart = evidence.excluded_lines_mm, evidence.contradicting_lines_mm
    remedy = message("let-laser-warm-up-check-mount")
    if before:
        text = message(
            "lasers-lines-poses-lie-off-plane",
            poses=_join_numbers(before),
            off=quantity(max(before.values()), "mm", 1),
        )
        return [CalibrationFinding("attention", "laser-moved", text, remedy)]
    if apart:
        text = message(
            "laser-moved-by-lines-off-plane",
            poses=_join_numbers(apart),
            off=quantity(max(apart.values()), "mm", 1),
        )
        return [CalibrationFinding("bad", "laser-moved", text, remedy)]
    return []


def _laser_picture_findings(evidence: BoardEvidence) -> list[CalibrationFinding]:
    """Laser pictures that could not be read."""
    return [
        CalibrationFinding(
            "attention",
            "laser-picture",
            message("pose-for-reason", number=one.number, reason=one.laser_error.reason),
            sentence(one.laser_error.remedy),
        )
        for one in evidence.observations
        if one.laser_error is not None
    ]


def _join_numbers(numbers: Iterable[int]) -> str:
    return ", ".join(map(str, numbers))


def _stripe_finding(evidence: BoardEvidence) -> CalibrationFinding:
    used = [pose for pose in evidence.poses if pose.used]
    points = sum(pose.stripe_points for pose in used)
    without = [pose.number for pose in used if not pose.stripe_points]
    rms = quantity(joint_rms((pose.stripe_rms_px, pose.stripe_points) for pose in used), "px", 2)
    text = message("points-lasers-line-lie-board-rms", points=points, rms=rms)
    if without:
        text = message(
            "points-lasers-line-lie-board-but-poses",
            points=points,
            rms=rms,
            count=len(without),
            poses=_join_numbers(without),
        )
    return CalibrationFinding("good" if not without else "neutral", "stripe", text)
