"""The findings of a calibration from one pose, and its worst points."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from crenel.messages.limits import beside_limit
from crenel.messages.message import message, quantity
from crenel.metrology.calibration.camera_refinement import CameraFit
from crenel.metrology.calibration.findings import (
    EDGE_RMS_PX,
    WORST_OF_A_KIND,
    CalibrationFinding,
    WorstResidual,
    contact_findings,
    contact_residual,
    corner_text,
    pixel_aspect_findings,
    sensor_distance_findings,
    size_coverage_findings,
    size_finding,
    sort_by_severity,
    stripe_finding,
    uncertainty_verdict,
)
from crenel.metrology.calibration.laser_plane_fit import LaserPlaneFit
from crenel.metrology.calibration.uncertainty_budget import Budget
from crenel.metrology.detection.detect_block import ObjectDetection
from crenel.metrology.detection.image_quality import ImageFinding
from crenel.metrology.probing.alignment import Alignment
from crenel.metrology.sensor.faugeras import LARGEST_CONDITION, FaugerasSolution
from crenel.metrology.stripe import Stripe
from crenel.metrology.targets.crenellated_block import Crenellated
from crenel.metrology.transforms import Floats

# The arm's contact points scatter by this factor beyond what its encoders explain.
EXCESS = 5.0
CONDITION = 15.0
# Share of the block's width that the stripe must span.
SPANNED = 0.5


@dataclass(frozen=True)
class Evidence:
    """Everything by which a calibration is judged."""

    block: Crenellated
    alignment: Alignment
    features: Sequence[str]
    detection: ObjectDetection
    picture: Sequence[ImageFinding]
    faugeras: FaugerasSolution
    fit: CameraFit
    stripe: Stripe
    laser: LaserPlaneFit
    budget: Budget
    arm_excess: float


def collect_one_pose_findings(evidence: Evidence) -> tuple[CalibrationFinding, ...]:
    """The verdict by the uncertainty of a point, with all findings, most severe first."""
    findings = (
        uncertainty_verdict(evidence.budget.total_um, evidence.budget.rows),
        *contact_findings(evidence.alignment, evidence.features),
        *_scatter_findings(evidence),
        size_finding(evidence.alignment, evidence.features, evidence.block),
        *_arm_findings(evidence),
        *_picture_findings(evidence),
        *_stripe_findings(evidence),
    )
    return sort_by_severity(findings)


def _scatter_findings(evidence: Evidence) -> list[CalibrationFinding]:
    if evidence.arm_excess <= EXCESS:
        return []
    excess, limit = beside_limit(evidence.arm_excess, EXCESS)
    return [
        CalibrationFinding(
            "attention",
            "arm-scatter",
            message(
                "contacts-scatter-times-what-arms-encoders",
                sigma=quantity(1e3 * evidence.alignment.sigma_mm, "µm"),
                arm_excess=excess,
                excess=limit,
            ),
            message("check-tip-play-faces-dirt-have"),
        )
    ]


def _arm_findings(evidence: Evidence) -> list[CalibrationFinding]:
    findings = [
        CalibrationFinding(
            "neutral",
            "arm-unseen",
            message("one-pose-does-not-show-arm-errors"),
        )
    ]
    findings += sensor_distance_findings(
        evidence.budget.pivot_mm, message("check-pictures-joint-angles-own")
    )
    return findings


def _picture_findings(evidence: Evidence) -> list[CalibrationFinding]:
    edges = evidence.fit.edges
    rms, limit = beside_limit(edges.rms_px, EDGE_RMS_PX, "px", 2)
    text = message(
        "points-edges-fit-camera-rms-limit",
        points=int(edges.inliers.sum()),
        edges=len(evidence.detection.edges),
        rms=rms,
        edge_rms_px=limit,
    )
    good = edges.rms_px <= EDGE_RMS_PX
    remedy = "" if good else message("clean-blocks-edges-check-focus-lighting")
    findings = [CalibrationFinding("good" if good else "attention", "edges", text, remedy)]
    findings += [
        CalibrationFinding("attention", item.code, item.text, item.remedy)
        for item in evidence.picture
    ]
    findings += size_coverage_findings([evidence.detection])
    findings += pixel_aspect_findings(evidence.fit.camera, evidence.fit.covariance[:2, :2])
    condition = evidence.faugeras.condition_number
    if condition > CONDITION:
        shown, good_limit = beside_limit(condition, CONDITION)
        findings.append(
            CalibrationFinding(
                "attention",
                "condition",
                message(
                    "corners-fix-camera-weakly-condition-number",
                    condition=shown,
                    good=good_limit,
                    limit=quantity(LARGEST_CONDITION),
                ),
                message("show-more-block-crests-floors-front"),
            )
        )
    return findings


def _stripe_findings(evidence: Evidence) -> list[CalibrationFinding]:
    laser = evidence.laser
    on = laser.level != ""
    share = float(laser.used.sum() / max(on.sum(), 1))
    remedy = message("check-laser-exposure-sensors-stripe-axis")
    findings = [stripe_finding(int(laser.used.sum()), laser.rms_px, share, remedy)]
    width = evidence.block.edges_x_mm[-1] - evidence.block.edges_x_mm[0]
    for level in ("crest", "floor"):
        x = laser.points_mm[laser.used & (laser.level == level), 0]
        if np.ptp(x) < SPANNED * width:
            findings.append(
                CalibrationFinding(
                    "attention",
                    "stripe-span",
                    message(
                        "s-stripe-spans-blocks",
                        level=level,
                        span=quantity(np.ptp(x), "mm"),
                        width=quantity(width, "mm"),
                    ),
                    message("bring-block-middle-stripe"),
                )
            )
    return findings


def worst_points(evidence: Evidence, corner_residuals_px: Floats) -> tuple[WorstResidual, ...]:
    """The worst contact points, corners and stripe points."""
    contacts = 1e3 * np.abs(evidence.alignment.residuals_mm)
    worst = [
        contact_residual(i, evidence.features[i], float(contacts[i])) for i in _largest(contacts)
    ]
    off = np.linalg.norm(corner_residuals_px, axis=1)
    worst += [
        WorstResidual(
            "corner",
            corner_text(evidence.detection.corners[i].name),
            float(off[i]),
            "px",
            corner=evidence.detection.corners[i].name,
        )
        for i in _largest(off)
    ]
    heights = 1e3 * np.abs(np.nan_to_num(evidence.laser.residuals_mm))
    along_u = evidence.stripe.axis == "u"
    along = evidence.stripe.u if along_u else evidence.stripe.v
    worst += [
        WorstResidual(
            "stripe",
            message("error-in-column", place=quantity(along[i]))
            if along_u
            else message("error-in-row", place=quantity(along[i])),
            float(heights[i]),
            "µm",
        )
        for i in _largest(heights)
    ]
    return tuple(worst)


def _largest(values: Floats) -> list[int]:
    return [int(i) for i in np.argsort(-values)[:WORST_OF_A_KIND]]
