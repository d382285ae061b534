"""What a calibration on a chessboard shows about itself, in words: the verdict first."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from app.metrology.adjustment.board_start import SeenBoard
from app.metrology.adjustment.joint_findings import ALIKE_DEG, about_tip, largest_turn_deg
from app.metrology.adjustment.pose_results import PoseResult
from app.metrology.adjustment.sheet import EXTENT, surface
from app.metrology.adjustment.solve import Adjusted
from app.metrology.adjustment.uncertainty import Known
from app.metrology.chessboard.board import Chessboard, corner_points
from app.metrology.findings import Finding, Limits, about_pixels, verdict

# The pattern is another size beyond this many deviations of what is known of it.
SIZE_SIGMAS = 3.0
# A sheet that bends by more than this times its flatness does not lie as it should.
BENT_TIMES, FLATTEST_MM = 2.0, 0.01
FEW_POSES = 6


@dataclass(frozen=True)
class BoardEvidence:
    """All that a calibration on a board can be judged by."""

    board: Chessboard
    seen: Sequence[SeenBoard]
    found: Adjusted
    known: Known
    poses: Sequence[PoseResult]
    limits: Limits
    lines_apart: dict[int, float]  # mm by pose number


def board_findings(evidence: BoardEvidence) -> tuple[Finding, ...]:
    """The verdict first, then every reason for or against it."""
    found = evidence.found
    return (
        verdict(evidence.known.total_um, evidence.known.rows, evidence.limits),
        *_about_size(evidence),
        _about_bend(evidence),
        *about_tip(found),
        *_about_poses(evidence),
        *_about_pictures(evidence.seen),
        *about_pixels(found.state.camera, found.covariance[:2, :2]),
        *_about_lines(evidence.lines_apart),
        _about_stripe(evidence),
    )


def _about_size(evidence: BoardEvidence) -> list[Finding]:
    found, board = evidence.found, evidence.board
    off = found.state.coordinates[EXTENT] - board.extent_mm
    sd = np.maximum(found.problem.papers.sd[EXTENT], 1e-6)
    if np.max(np.abs(off) / sd) < SIZE_SIGMAS:
        return []
    width, height = found.state.coordinates[EXTENT]
    given = board.extent_mm
    return [
        Finding(
            "attention",
            "board-size",
            f"Poses and pictures agree better with a pattern of {width:.2f} x {height:.2f} mm "
            f"than with {given[0]:.2f} x {given[1]:.2f} mm of the certificate.",
            "Measure the pattern, and correct square_mm or its standard uncertainty.",
        )
    ]


def _about_bend(evidence: BoardEvidence) -> Finding:
    found, board = evidence.found, evidence.board
    bend = surface(board, found.state.coordinates, corner_points(board)[:, :2]).height_mm
    rms_mm = float(np.sqrt(np.mean(bend**2)))
    if rms_mm > BENT_TIMES * max(board.flatness_mm, FLATTEST_MM):
        return Finding(
            "attention",
            "board-bent",
            f"The sheet bends by {np.ptp(bend):.2f} mm over the pattern; flat to "
            f"{board.flatness_mm:.2f} mm was expected.",
            "Fix the board to a flat plate.",
        )
    text = f"The sheet bends by {1e3 * np.ptp(bend):.0f} µm over the pattern: allowed for."
    return Finding("neutral", "board-bend", text)


def _about_poses(evidence: BoardEvidence) -> list[Finding]:
    used = [pose for pose in evidence.poses if pose.used]
    said = [
        Finding(
            "attention",
            "pose-left-out",
            f"Pose {pose.number}: {pose.reason}.",
            "Check that laser, board and camera kept still, and that picture and pose are of one"
            " moment.",
        )
        for pose in evidence.poses
        if pose.reason
    ]
    off = [pose.off_um for pose in used]
    furthest = used[int(np.argmax(off))]
    said.append(
        Finding(
            "attention" if len(used) < FEW_POSES else "good",
            "poses",
            f"{len(used)} poses agree on the board's place to {np.median(off):.0f} µm; pose "
            f"{furthest.number} is furthest off, by {furthest.off_um:.0f} µm.",
            "Take more pictures, tilted to all sides." if len(used) < FEW_POSES else "",
        )
    )
    turn = largest_turn_deg(evidence.found.problem.motion.T_arm_flange)
    if turn < ALIKE_DEG:
        said.append(
            Finding(
                "attention",
                "poses-alike",
                f"The sensor turned by {turn:.1f}° at most between the poses (wanted: "
                f"{ALIKE_DEG:.0f}° and more).",
                "Take poses tilted to the left, right, front and back, and turned about the view.",
            )
        )
    return said


def _about_pictures(seen: Sequence[SeenBoard]) -> list[Finding]:
    """What a single picture suffers from, each kind once, by the first pose that shows it."""
    first = {item.code: (pose.number, item) for pose in reversed(seen) for item in pose.picture}
    return [
        Finding("attention", code, f"Pose {number}: {item.text}", item.remedy)
        for code, (number, item) in first.items()
    ]


def _about_lines(apart: dict[int, float]) -> list[Finding]:
    """Lines that contradict the others, and are too many to be mistakes."""
    if not apart:
        return []
    listed = ", ".join(map(str, apart))
    return [
        Finding(
            "bad",
            "laser-moved",
            f"The laser's lines of poses {listed} lie {max(apart.values()):.1f} mm off the plane "
            "of the others: the laser moved against the camera, and all lines were made to count.",
            "Let the laser warm up, check its mount, and take the pictures again.",
        )
    ]


def _about_stripe(evidence: BoardEvidence) -> Finding:
    used = [pose for pose in evidence.poses if pose.used]
    points = sum(pose.stripe_points for pose in used)
    without = [str(pose.number) for pose in used if not pose.stripe_points]
    rms = np.sqrt(sum(pose.stripe_rms_px**2 * pose.stripe_points for pose in used) / max(points, 1))
    text = f"{points} points of the laser's line lie on the board, {rms:.2f} px rms off the plane."
    if without:
        text += f" Pose{'s' if len(without) > 1 else ''} {', '.join(without)} show none."
    return Finding("good" if not without else "neutral", "stripe", text)
