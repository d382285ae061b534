"""What a calibration on a chessboard shows about itself, in words, the gravest first."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from app.metrology.adjustment.block.findings import ALIKE_DEG, largest_turn_deg
from app.metrology.adjustment.board.initial_guess import BoardObservation
from app.metrology.adjustment.board.results import BoardContacts
from app.metrology.adjustment.board.surface import coordinate_groups, evaluate_surface
from app.metrology.adjustment.core.gauss_newton import AdjustmentResult
from app.metrology.adjustment.core.uncertainty import CalibrationUncertainty
from app.metrology.adjustment.outliers.fault_hypotheses import board_fault_findings
from app.metrology.adjustment.results.poses import PoseResult
from app.metrology.calibration.findings import (
    CalibrationFinding,
    contact_outlier_findings,
    pixel_aspect_findings,
    sort_by_severity,
    uncertainty_verdict,
)
from app.metrology.limits import Limits
from app.metrology.targets.chessboard import Chessboard, corner_points

# What a budget calls a robot's share.
ROBOT_ROW = "robot's poses"
REMEDIES = {
    "contact points": "Touch more points, spread wide over the board.",
    "arm encoders": "Take more pictures, from all sides; hold the arm in a compact posture.",
    "arm geometry": "Take more pictures, from all sides; have the arm's model identified anew.",
    "object certificate": "Measure the pattern's width and height, and fix it to a flat plate.",
    "edges and corners": "Light the board evenly, sharp and large in the picture.",
    "stripe": "Take more pictures, with the laser's line on the flat of the board.",
    "distortion": "Take more pictures, with the board in all corners of the picture.",
}
# Poses tell the same of everything: this many at most are asked for.
MOST_ASKED = 60
# Robot and pictures disagree in the board's tilt by more than this, and more than in turn.
ROCKING_RAD, ROCKING_TIMES = 1e-3, 3.0
# A sheet that bends by more than this times its flatness does not lie as it should.
PRINT_TIMES = 3.0
BENT_TIMES, FLATTEST_MM = 2.0, 0.01
FEW_POSES = 6
# Of a robot's noise: three turns, three shifts, two tilts.
TURNS_SHIFTS_TILTS = 8


@dataclass(frozen=True)
class BoardEvidence:
    """All that a calibration on a board can be judged by."""

    board: Chessboard
    observations: Sequence[BoardObservation]
    result: AdjustmentResult
    uncertainty: CalibrationUncertainty
    poses: Sequence[PoseResult]
    limits: Limits
    excluded_lines_mm: dict[int, float]  # mm by pose number: of a laser that moved, left out
    contradicting_lines_mm: dict[int, float]  # the same, where they count
    contacts: BoardContacts | None


def board_findings(evidence: BoardEvidence) -> tuple[CalibrationFinding, ...]:
    """By the uncertainty of a point, and every reason for or against it; the gravest first."""
    found = evidence.result
    told = (
        _verdict(evidence),
        *_contact_findings(evidence),
        *board_fault_findings(found, evidence.board.square_mm, evidence.limits),
        *_print_findings(evidence),
        _bend_finding(evidence),
        *_pose_findings(evidence),
        *_rocking_findings(found),
        *_image_findings(evidence.observations),
        *pixel_aspect_findings(found.state.camera, found.covariance[:2, :2]),
        *_line_findings(evidence),
        _stripe_finding(evidence),
    )
    return sort_by_severity(told)


def _verdict(evidence: BoardEvidence) -> CalibrationFinding:
    """By the user's limits; what helps is more pictures, or a laser that stays."""
    known, limits = evidence.uncertainty, evidence.limits
    poses = len(evidence.result.problem.views)
    limit = limits.good_um if known.total_um <= limits.usable_um else limits.usable_um
    asked = int(np.ceil(poses * (known.total_um / limit) ** 2))
    more = "Take more pictures, tilted to all sides"
    if asked <= MOST_ASKED:
        more = f"{more}: about {asked} like these, in all, would do"
    else:
        more += (
            "; so far off, the robot's own accuracy is at fault, or its poses are not the flange's"
            " in the arm's frame"
        )
    remedies = REMEDIES | {
        ROBOT_ROW: f"{more}. If that is all the robot can do, set the limits to what the scans need"
        " (--good-um, --usable-um).",
    }
    if evidence.excluded_lines_mm or evidence.contradicting_lines_mm:
        remedies["stripe"] = "Let the laser come to rest, and take the pictures again."
    return uncertainty_verdict(known.total_um, known.rows, limits, remedies)


def _contact_findings(evidence: BoardEvidence) -> list[CalibrationFinding]:
    contacts, touches, limits = evidence.contacts, evidence.result.problem.contacts, evidence.limits
    if contacts is None or touches is None:
        return []
    count, rms_um = int((~contacts.excluded).sum()), contacts.rms_um
    text = f"{count} contacts lie on the board to {rms_um:.0f} µm rms."
    found = [CalibrationFinding("good", "contacts", text)]
    if rms_um > limits.good_um:
        text = (
            f"{count} contacts lie on the board to {rms_um:.0f} µm rms; up to "
            f"{limits.good_um:.0f} µm is good."
        )
        remedy = (
            "Check that the tip is the one of the arm's file, and that board and arm stood firm."
        )
        found = [CalibrationFinding("attention", "contacts", text, remedy)]
    left_out = contact_outlier_findings(touches.features, contacts.residuals_um, contacts.excluded)
    return [*found, *left_out]


def _print_findings(evidence: BoardEvidence) -> list[CalibrationFinding]:
    """The corners' places one by one against the certificate, which may be silent on them."""
    board, papers = evidence.board, evidence.result.problem.prior
    told_mm = float(papers.sd[coordinate_groups(board)[1]][0])
    if told_mm < PRINT_TIMES * board.standard_uncertainty_mm:
        return []
    return [
        CalibrationFinding(
            "attention",
            "board-print",
            f"The corners lie {1e3 * told_mm:.0f} µm off a regular pattern, by the certificate "
            f"{1e3 * board.standard_uncertainty_mm:.0f} µm: allowed for.",
            "Check that this is the board, and how exact its certificate takes it to be.",
        )
    ]


def _bend_finding(evidence: BoardEvidence) -> CalibrationFinding:
    found, board = evidence.result, evidence.board
    bend = evaluate_surface(board, found.state.coordinates, corner_points(board)[:, :2]).height_mm
    rms_mm = float(np.sqrt(np.mean(bend**2)))
    if rms_mm > BENT_TIMES * max(board.flatness_mm, FLATTEST_MM):
        return CalibrationFinding(
            "attention",
            "board-bent",
            f"The sheet bends by {np.ptp(bend):.2f} mm over the pattern; flat to "
            f"{board.flatness_mm:.2f} mm was expected.",
            "Fix the board to a flat plate.",
        )
    text = f"The sheet bends by {1e3 * np.ptp(bend):.0f} µm over the pattern: allowed for."
    return CalibrationFinding("neutral", "board-bend", text)


def _pose_findings(evidence: BoardEvidence) -> list[CalibrationFinding]:
    used = [pose for pose in evidence.poses if pose.used]
    seen = {pose.number for pose in evidence.observations}  # others' reasons say what to do
    about_lines = (
        evidence.excluded_lines_mm | evidence.contradicting_lines_mm
    )  # are told with the lines
    said = [
        CalibrationFinding(
            "attention",
            "pose-left-out",
            f"Pose {pose.number}: {pose.reason}.",
            "Check that laser, board and camera kept still, and that picture and pose are of one"
            " moment."
            if pose.number in seen
            else "",
        )
        for pose in evidence.poses
        if pose.reason and not (pose.used and pose.number in about_lines)
    ]
    off = [pose.off_um for pose in used]
    furthest = used[int(np.argmax(off))]
    said.append(
        CalibrationFinding(
            "attention" if len(used) < FEW_POSES else "good",
            "poses",
            f"{len(used)} poses agree on the board's place to {np.median(off):.0f} µm; pose "
            f"{furthest.number} is furthest off, by {furthest.off_um:.0f} µm.",
            "Take more pictures, tilted to all sides." if len(used) < FEW_POSES else "",
        )
    )
    turn = largest_turn_deg(evidence.result.problem.motion.T_arm_flange)
    if turn < ALIKE_DEG:
        said.append(
            CalibrationFinding(
                "attention",
                "poses-alike",
                f"The sensor turned by {turn:.1f}° at most between the poses (wanted: "
                f"{ALIKE_DEG:.0f}° and more).",
                "Take poses tilted to the left, right, front and back, and turned about the view.",
            )
        )
    return said


def _rocking_findings(found: AdjustmentResult) -> list[CalibrationFinding]:
    """A robot's poses that agree on the board's place better than on its tilt."""
    sd = found.scales.noise * found.problem.motion.noise_sd
    if len(sd) != TURNS_SHIFTS_TILTS or len(found.problem.views) < FEW_POSES:
        return []
    turn, tilt = float(sd[0]), float(sd[-1])
    if tilt < max(ROCKING_RAD, ROCKING_TIMES * turn):
        return []
    return [
        CalibrationFinding(
            "attention",
            "board-rocks",
            f"Robot and pictures agree on the board's place, but on its tilt only to "
            f"{1e3 * tilt:.1f} mrad (the robot's own turns: {1e3 * turn:.1f} mrad).",
            "Fix the board so that it cannot rock or warp, and lock the camera's lens.",
        )
    ]


def _image_findings(seen: Sequence[BoardObservation]) -> list[CalibrationFinding]:
    """What a single picture suffers from, each kind once, by the first pose that shows it."""
    first = {
        item.code: (pose.number, item) for pose in reversed(seen) for item in pose.image_findings
    }
    return [
        CalibrationFinding(
            "attention",
            code,
            f"Pose {number}: {item.text}.",
            f"{item.remedy[:1].upper()}{item.remedy[1:]}.",
        )
        for code, (number, item) in first.items()
    ]


def _line_findings(evidence: BoardEvidence) -> list[CalibrationFinding]:
    """Lines that contradict the others, and are too many to be mistakes."""
    before, apart = evidence.excluded_lines_mm, evidence.contradicting_lines_mm
    remedy = "Let the laser warm up, check its mount, and take the pictures again."
    if before:
        text = (
            f"The laser's lines of poses {_join_numbers(before)} lie "
            f"{max(before.values()):.1f} mm off the plane of the others: "
            "the laser moved against the camera, and these lines were left out."
        )
        return [CalibrationFinding("attention", "laser-moved", text, remedy)]
    if apart:
        text = (
            f"The laser's lines of poses {_join_numbers(apart)} lie "
            f"{max(apart.values()):.1f} mm off the plane of the others: "
            "the laser moved against the camera, and all lines were made to count."
        )
        return [CalibrationFinding("bad", "laser-moved", text, remedy)]
    return []


def _join_numbers(numbers: Iterable[int]) -> str:
    return ", ".join(map(str, numbers))


def _stripe_finding(evidence: BoardEvidence) -> CalibrationFinding:
    used = [pose for pose in evidence.poses if pose.used]
    points = sum(pose.stripe_points for pose in used)
    without = [str(pose.number) for pose in used if not pose.stripe_points]
    rms = np.sqrt(sum(pose.stripe_rms_px**2 * pose.stripe_points for pose in used) / max(points, 1))
    text = f"{points} points of the laser's line lie on the board, {rms:.2f} px rms off the plane."
    if without:
        text += f" Pose{'s' if len(without) > 1 else ''} {', '.join(without)} show none."
    return CalibrationFinding("good" if not without else "neutral", "stripe", text)
