"""What an adjustment shows about itself, in words, the gravest first."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from app.metrology.adjustment.core.gauss_newton import AdjustmentResult
from app.metrology.adjustment.core.observations import BlockObservation
from app.metrology.adjustment.core.uncertainty import CalibrationUncertainty
from app.metrology.adjustment.core.variance_components import Scales
from app.metrology.adjustment.outliers.fault_hypotheses import block_fault_findings
from app.metrology.adjustment.results.poses import PoseResult
from app.metrology.calibration.findings import (
    AGREEING,
    EDGE_RMS_PX,
    STRIPE_RMS_PX,
    CalibrationFinding,
    contact_findings,
    pixel_aspect_findings,
    sensor_distance_findings,
    size_coverage_findings,
    sort_by_severity,
    uncertainty_verdict,
)
from app.metrology.limits import Limits
from app.metrology.probing.alignment import Alignment
from app.metrology.targets.crenellated_block import Crenellated
from app.metrology.transforms import Floats, inverse, vector_from_rotation

# The arm reads worse than its sheet by this factor.
NOISY = 2.5
# One pose may fit its edges so much worse than all together should.
WORST_POSE = 1.5
# Turns between the poses below which they tell little more than one.
ALIKE_DEG = 8.0


@dataclass(frozen=True)
class BlockEvidence:
    """All that a calibration over many poses can be judged by."""

    block: Crenellated
    alignment: Alignment
    features: Sequence[str]
    observations: Sequence[BlockObservation]
    result: AdjustmentResult
    uncertainty: CalibrationUncertainty
    poses: Sequence[PoseResult]
    excluded_lines_mm: dict[int, float]  # mm off the plane of the others, by the poses' numbers
    limits: Limits


def block_findings(evidence: BlockEvidence) -> tuple[CalibrationFinding, ...]:
    """By the uncertainty of a point, and every reason for or against it; the gravest first."""
    state, covariance = evidence.result.state, evidence.result.covariance
    found = (
        uncertainty_verdict(
            evidence.uncertainty.total_um, evidence.uncertainty.rows, evidence.limits
        ),
        *contact_findings(evidence.alignment, evidence.features, evidence.limits),
        *block_fault_findings(evidence.result, evidence.limits),
        *_pose_findings(evidence),
        *_arm_findings(evidence),
        *_image_findings(evidence),
        *size_coverage_findings([pose.detection for pose in evidence.observations]),
        *pixel_aspect_findings(state.camera, covariance[:2, :2]),
        *_line_findings(evidence),
        _stripe_finding(evidence),
    )
    return sort_by_severity(found)


def _pose_findings(evidence: BlockEvidence) -> list[CalibrationFinding]:
    used = [pose for pose in evidence.poses if pose.used]
    out = [pose for pose in evidence.poses if not pose.used]
    seen = {pose.number for pose in evidence.observations}  # others' reasons say what to do
    found = [
        CalibrationFinding(
            "attention",
            "pose-left-out",
            f"Pose {pose.number} was left out: {pose.reason}.",
            "Check that picture and joint angles are of one moment, or take the pose again."
            if pose.number in seen
            else "",
            pose.number,
        )
        for pose in out
    ]
    if len(used) == 1:
        text = (
            "One pose alone was used: errors of the arm's links show in the contacts only; joint "
            "angles that are not the picture's, and an object moved since it was touched, do not "
            "show."
        )
        return [
            *found,
            CalibrationFinding("neutral", "one-pose", text, "Take more poses, tilted and turned."),
        ]
    off = [pose.off_um for pose in used]
    furthest = used[int(np.argmax(off))]
    found.append(
        CalibrationFinding(
            "good",
            "poses",
            f"{len(used)} poses agree on the object's place to {np.median(off):.0f} µm; pose "
            f"{furthest.number} is furthest off, by {furthest.off_um:.0f} µm.",
            pose=furthest.number,
        )
    )
    turn = largest_turn_deg(evidence.result.problem.motion.T_arm_flange)
    if turn < ALIKE_DEG:
        found.append(
            CalibrationFinding(
                "attention",
                "poses-alike",
                f"The sensor turned by {turn:.1f}° at most between the poses (wanted: "
                f"{ALIKE_DEG:.0f}° and more), so that they tell little more than one.",
                "Take poses tilted to the left, right, front and back, and turned about the view.",
            )
        )
    return found


def largest_turn_deg(T_arm_flange: Floats) -> float:
    """The largest angle between any two of P poses (P, 4, 4)."""
    turns = [
        float(np.linalg.norm(vector_from_rotation((inverse(a) @ b)[:3, :3])))
        for i, a in enumerate(T_arm_flange)
        for b in T_arm_flange[i + 1 :]
    ]
    return float(np.degrees(max(turns, default=0.0)))


def _arm_findings(evidence: BlockEvidence) -> list[CalibrationFinding]:
    scales: Scales = evidence.result.scales
    links_um = next(
        (row.value_um for row in evidence.uncertainty.rows if row.source == "arm geometry"), 0.0
    )
    poor = 1e3 * scales.links_mm > evidence.limits.good_um
    found = [
        CalibrationFinding(
            "attention" if poor else "neutral",
            "arm-links",
            f"The data speak for errors of the arm's links of {1e3 * scales.links_mm:.0f} µm and "
            f"{np.degrees(scales.links_rad) * 3600:.1f}″ each; what is left of them makes "
            f"{links_um:.0f} µm of a point's uncertainty.",
            "Check the tip that is mounted against the arm's file, and that nothing moved; have "
            "the arm's model identified anew."
            if poor
            else "",
        )
    ]
    if scales.noise > NOISY:
        found.append(
            CalibrationFinding(
                "attention",
                "arm-scatter",
                f"The poses and contacts scatter {scales.noise:.1f} times more than the arm's "
                f"encoders explain (limit {NOISY:.1f}).",
                "Check the arm for play, the tip and the sensor for a loose mount; hold still.",
            )
        )
    remedy = "Check that the pictures' joint angles are those of their poses."
    found += sensor_distance_findings(evidence.uncertainty.pivot_mm, remedy)
    return found


def _image_findings(evidence: BlockEvidence) -> list[CalibrationFinding]:
    used = [pose for pose in evidence.poses if pose.used]
    points = sum(pose.edge_points for pose in used)
    square = sum(pose.edges_rms_px**2 * pose.edge_points for pose in used) / max(points, 1)
    worst = max(used, key=lambda pose: pose.edges_rms_px)
    rms_px = float(np.sqrt(square))
    good = rms_px <= EDGE_RMS_PX and worst.edges_rms_px <= WORST_POSE * EDGE_RMS_PX
    found = [
        CalibrationFinding(
            "good" if good else "attention",
            "edges",
            f"{points} points on the block's edges fit the camera to {rms_px:.2f} px rms, "
            f"worst in pose {worst.number} ({worst.edges_rms_px:.2f} px); the limit is "
            f"{EDGE_RMS_PX:.1f} px.",
            "" if good else "Clean the block's edges; check focus, lighting and certificate.",
            worst.number,
        )
    ]
    told: set[str] = set()
    for pose in evidence.observations:
        for item in pose.image_findings:
            if item.code not in told:
                told.add(item.code)
                text = f"Pose {pose.number}: {item.text}"
                found.append(
                    CalibrationFinding("attention", item.code, text, item.remedy, pose.number)
                )
    return found


def _line_findings(evidence: BlockEvidence) -> list[CalibrationFinding]:
    moved = [
        CalibrationFinding(
            "attention",
            "laser-moved",
            f"The laser's line of pose {number} lies {1e3 * off_mm:.0f} µm off the plane of the "
            "others, and was left out.",
            "Check that its laser picture is of this pose, that the sensor was held still between "
            "its two pictures, and that the laser sits firmly; take the pose again.",
            number,
        )
        for number, off_mm in sorted(evidence.excluded_lines_mm.items())
    ]
    missing = [
        CalibrationFinding(
            "attention",
            "line-missing",
            f"Pose {pose.number} shows no laser line on the object: used without it.",
            "Check that the laser was on, that its line crossed the object, and the exposure; take "
            "the pose again.",
            pose.number,
        )
        for pose in evidence.poses
        if pose.used and not pose.stripe_points and pose.number not in evidence.excluded_lines_mm
    ]
    return [*moved, *missing]


def _stripe_finding(evidence: BlockEvidence) -> CalibrationFinding:
    used = [
        pose
        for pose in evidence.poses
        if pose.used and pose.number not in evidence.excluded_lines_mm
    ]
    points = sum(pose.stripe_points for pose in used)
    square = sum(pose.stripe_rms_px**2 * pose.stripe_points for pose in used) / max(points, 1)
    numbers = {pose.number for pose in used}
    extracted = sum(len(pose.stripe.u) for pose in evidence.observations if pose.number in numbers)
    share, rms_px = points / max(extracted, 1), float(np.sqrt(square))
    remedy = ""
    if rms_px > STRIPE_RMS_PX:
        remedy = (
            "Check that each laser picture is of its own pose, taken without moving the sensor, "
            "and that the laser sits firmly; then its focus."
        )
    elif share < AGREEING:
        remedy = "Keep reflections out of the grooves: matt spray, lower exposure."
    return CalibrationFinding(
        "attention" if remedy else "good",
        "laser-plane",
        f"{points} stripe points fit one laser plane to {rms_px:.2f} px rms (limit "
        f"{STRIPE_RMS_PX:.1f} px), {100 * share:.0f} % of those on the object (limit "
        f"{100 * AGREEING:.0f} %).",
        remedy,
    )
