"""The findings of an adjustment, most severe first."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from crenel.messages.limits import beside_limit
from crenel.messages.message import message, quantity
from crenel.metrology.adjustment.block.nominal_block import nominal_findings
from crenel.metrology.adjustment.core.gauss_newton import AdjustmentResult
from crenel.metrology.adjustment.core.observations import BlockObservation
from crenel.metrology.adjustment.core.uncertainty import CalibrationUncertainty
from crenel.metrology.adjustment.core.variance_components import Scales
from crenel.metrology.adjustment.outliers.fault_hypotheses import block_fault_findings
from crenel.metrology.adjustment.results.findings import alike_findings, joint_rms, picture_findings
from crenel.metrology.adjustment.results.poses import PoseResult
from crenel.metrology.calibration.findings import (
    EDGE_RMS_PX,
    CalibrationFinding,
    contact_findings,
    pixel_aspect_findings,
    sensor_distance_findings,
    size_coverage_findings,
    sort_by_severity,
    stripe_finding,
    uncertainty_verdict,
)
from crenel.metrology.limits import Limits
from crenel.metrology.probing.alignment import Alignment
from crenel.metrology.robust import median
from crenel.metrology.targets.crenellated_block import Crenellated

# Ratio of the arm's reading noise to its datasheet from which it is reported.
NOISY = 2.5
# Ratio of a pose's edge residuals to those of all poses from which it is reported.
WORST_POSE = 1.5


@dataclass(frozen=True)
class BlockEvidence:
    """Everything by which a calibration over many poses is judged."""

    block: Crenellated
    alignment: Alignment
    features: Sequence[str]
    observations: Sequence[BlockObservation]
    result: AdjustmentResult
    uncertainty: CalibrationUncertainty
    poses: Sequence[PoseResult]
    excluded_lines_mm: dict[int, float]  # mm off the plane of the others, by pose number
    limits: Limits


def block_findings(evidence: BlockEvidence) -> tuple[CalibrationFinding, ...]:
    """The verdict by the uncertainty of a point, with all findings, most severe first."""
    state, covariance = evidence.result.state, evidence.result.covariance
    findings = (
        uncertainty_verdict(
            evidence.uncertainty.total_um, evidence.uncertainty.rows, evidence.limits
        ),
        *contact_findings(evidence.alignment, evidence.features, evidence.limits),
        *block_fault_findings(evidence.result, evidence.limits),
        *nominal_findings(evidence.block, evidence.result),
        *_pose_findings(evidence),
        *_arm_findings(evidence),
        *_image_findings(evidence),
        *size_coverage_findings([pose.detection for pose in evidence.observations]),
        *pixel_aspect_findings(state.camera, covariance[:2, :2]),
        *_line_findings(evidence),
        _stripe_finding(evidence),
    )
    return sort_by_severity(findings)


def _pose_findings(evidence: BlockEvidence) -> list[CalibrationFinding]:
    used = [pose for pose in evidence.poses if pose.used]
    out = [pose for pose in evidence.poses if not pose.used]
    observed = {pose.number for pose in evidence.observations}  # other findings have remedies
    findings = [
        CalibrationFinding(
            "attention",
            "pose-left-out",
            message("pose-left-out", number=pose.number, reason=pose.reason),
            message("check-picture-joint-angles-one-moment") if pose.number in observed else "",
            pose.number,
        )
        for pose in out
    ]
    if len(used) == 1:
        text = message("one-pose-alone-used-errors-arms")
        return [
            *findings,
            CalibrationFinding(
                "neutral", "one-pose", text, message("take-more-poses-tilted-turned")
            ),
        ]
    off = [pose.off_um for pose in used]
    furthest = used[int(np.argmax(off))]
    findings.append(
        CalibrationFinding(
            "good",
            "poses",
            message(
                "poses-agree-objects-place-pose-furthest",
                used=len(used),
                median=quantity(median(off), "µm"),
                number=furthest.number,
                off=quantity(furthest.off_um, "µm"),
            ),
            pose=furthest.number,
        )
    )
    return [*findings, *alike_findings(evidence.result.problem.motion.T_arm_flange)]


def _arm_findings(evidence: BlockEvidence) -> list[CalibrationFinding]:
    scales: Scales = evidence.result.scales
    links_um = next(
        (row.value_um for row in evidence.uncertainty.rows if row.source == "arm geometry"), 0.0
    )
    poor = 1e3 * scales.links_mm > evidence.limits.good_um
    findings = [
        CalibrationFinding(
            "attention" if poor else "neutral",
            "arm-links",
            message(
                "data-speak-errors-arms-links-each",
                links=quantity(1e3 * scales.links_mm, "µm"),
                turns=quantity(np.degrees(scales.links_rad) * 3600, "″", 1),
                share=quantity(links_um, "µm"),
            ),
            message("check-mounted-tip-and-nothing-moved") if poor else "",
        )
    ]
    if scales.noise > NOISY:
        noise, noisy = beside_limit(scales.noise, NOISY, "", 1)
        findings.append(
            CalibrationFinding(
                "attention",
                "arm-scatter",
                message(
                    "poses-contacts-scatter-times-more-than",
                    noise=noise,
                    noisy=noisy,
                ),
                message("check-arm-play-tip-sensor-loose"),
            )
        )
    remedy = message("check-pictures-joint-angles-those-their")
    findings += sensor_distance_findings(evidence.uncertainty.pivot_mm, remedy)
    return findings


def _image_findings(evidence: BlockEvidence) -> list[CalibrationFinding]:
    used = [pose for pose in evidence.poses if pose.used]
    points = sum(pose.edge_points for pose in used)
    rms_px = joint_rms((pose.edges_rms_px, pose.edge_points) for pose in used)
    worst = max(used, key=lambda pose: pose.edges_rms_px)
    worst_px = WORST_POSE * EDGE_RMS_PX
    good = rms_px <= EDGE_RMS_PX and worst.edges_rms_px <= worst_px
    rms, limit = beside_limit(rms_px, EDGE_RMS_PX, "px", 2)
    edges_rms, worst_limit = beside_limit(worst.edges_rms_px, worst_px, "px", 2)
    return [
        CalibrationFinding(
            "good" if good else "attention",
            "edges",
            message(
                "points-blocks-edges-fit-camera-rms",
                points=points,
                rms=rms,
                edge_rms_px=limit,
                number=worst.number,
                edges_rms=edges_rms,
                worst_limit=worst_limit,
            ),
            "" if good else message("clean-blocks-edges-check-focus-lighting"),
            worst.number,
        ),
        *picture_findings((pose.number, pose.image_findings) for pose in evidence.observations),
    ]


def _line_findings(evidence: BlockEvidence) -> list[CalibrationFinding]:
    moved = [
        CalibrationFinding(
            "attention",
            "laser-moved",
            message(
                "lasers-line-pose-lies-off-plane",
                number=number,
                off=quantity(1e3 * off_mm, "µm"),
            ),
            message("check-laser-picture-pose-sensor-held"),
            number,
        )
        for number, off_mm in sorted(evidence.excluded_lines_mm.items())
    ]
    missing = [
        CalibrationFinding(
            "attention",
            "line-missing",
            message("pose-shows-no-laser-line-object", number=pose.number),
            message("check-laser-line-crossed-object-exposure"),
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
    numbers = {pose.number for pose in used}
    extracted = sum(len(pose.stripe.u) for pose in evidence.observations if pose.number in numbers)
    rms_px = joint_rms((pose.stripe_rms_px, pose.stripe_points) for pose in used)
    remedy = message("check-each-laser-picture-own-pose-laser-not-moved")
    return stripe_finding(points, rms_px, points / max(extracted, 1), remedy)
