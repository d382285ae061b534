"""What a calibration by one pose shows about itself, in words: findings, and the worst points."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from app.metrology.calibration.camera_refinement import CameraFit
from app.metrology.calibration.findings import (
    AGREEING,
    EDGE_RMS_PX,
    WORST_OF_A_KIND,
    CalibrationFinding,
    WorstResidual,
    contact_findings,
    pixel_aspect_findings,
    sensor_distance_findings,
    size_coverage_findings,
    size_finding,
    sort_by_severity,
    uncertainty_verdict,
)
from app.metrology.calibration.laser_plane_fit import LaserPlaneFit
from app.metrology.calibration.uncertainty_budget import Budget
from app.metrology.detection.detect_block import ObjectDetection
from app.metrology.detection.image_quality import ImageFinding
from app.metrology.probing.alignment import Alignment
from app.metrology.sensor.faugeras import LARGEST_CONDITION, FaugerasSolution
from app.metrology.stripe import Stripe
from app.metrology.targets.crenellated_block import Crenellated
from app.metrology.transforms import Floats

# The arm's contacts scatter by this factor beyond what its encoders explain.
EXCESS = 5.0
CONDITION = 15.0
# Share of the block's width that the stripe spans.
SPANNED = 0.5


@dataclass(frozen=True)
class Evidence:
    """All that a calibration can be judged by."""

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


def collect_one_pose_findings(seen: Evidence) -> tuple[CalibrationFinding, ...]:
    """By the uncertainty of a point, and every reason for or against it; the gravest first."""
    found = (
        uncertainty_verdict(seen.budget.total_um, seen.budget.rows),
        *contact_findings(seen.alignment, seen.features),
        *_scatter_findings(seen),
        size_finding(seen.alignment, seen.features, seen.block),
        *_arm_findings(seen),
        *_picture_findings(seen),
        *_stripe_findings(seen),
    )
    return sort_by_severity(found)


def _scatter_findings(seen: Evidence) -> list[CalibrationFinding]:
    if seen.arm_excess <= EXCESS:
        return []
    return [
        CalibrationFinding(
            "attention",
            "arm-scatter",
            f"The contacts scatter by {1e3 * seen.alignment.sigma_mm:.0f} µm, "
            f"{seen.arm_excess:.0f} times what the arm's encoders explain "
            f"(limit {EXCESS:.0f}).",
            "Check the tip for play and the faces for dirt; have the arm's model checked.",
        )
    ]


def _arm_findings(seen: Evidence) -> list[CalibrationFinding]:
    found = [
        CalibrationFinding(
            "neutral",
            "arm-unseen",
            "Errors of the arm's own model, joint angles that are not the picture's, and an object "
            "moved since it was touched cannot be seen from one picture in one pose, and are not "
            "in this figure.",
        )
    ]
    found += sensor_distance_findings(
        seen.budget.pivot_mm, "Check that the picture's joint angles are its own."
    )
    return found


def _picture_findings(seen: Evidence) -> list[CalibrationFinding]:
    edges = seen.fit.edges
    text = (
        f"{int(edges.inliers.sum())} points on {len(seen.detection.edges)} edges fit the camera to "
        f"{edges.rms_px:.2f} px rms; the limit is {EDGE_RMS_PX:.1f} px."
    )
    good = edges.rms_px <= EDGE_RMS_PX
    remedy = "" if good else "Clean the block's edges; check focus, lighting and certificate."
    found = [CalibrationFinding("good" if good else "attention", "edges", text, remedy)]
    found += [
        CalibrationFinding("attention", item.code, item.text, item.remedy) for item in seen.picture
    ]
    found += size_coverage_findings([seen.detection])
    found += pixel_aspect_findings(seen.fit.camera, seen.fit.covariance[:2, :2])
    condition = seen.faugeras.condition_number
    if condition > CONDITION:
        found.append(
            CalibrationFinding(
                "attention",
                "condition",
                f"The corners fix the camera weakly: condition number {condition:.0f} "
                f"(good below {CONDITION:.0f}, refused above {LARGEST_CONDITION:.0f}).",
                "Show more of the block, crests and floors, front and back.",
            )
        )
    return found


def _stripe_findings(seen: Evidence) -> list[CalibrationFinding]:
    laser = seen.laser
    on = laser.level != ""
    share = float(laser.used.sum() / max(on.sum(), 1))
    good = share >= AGREEING
    text = (
        f"{int(laser.used.sum())} stripe points on crests and floors fit one plane to "
        f"{1e3 * laser.rms_mm:.1f} µm rms, {100 * share:.0f} % of those seen there "
        f"(limit {100 * AGREEING:.0f} %)."
    )
    remedy = "" if good else "Keep reflections out of the grooves: matt spray, lower exposure."
    found = [CalibrationFinding("good" if good else "attention", "laser-plane", text, remedy)]
    width = seen.block.edges_x_mm[-1] - seen.block.edges_x_mm[0]
    for level in ("crest", "floor"):
        x = laser.points_mm[laser.used & (laser.level == level), 0]
        if np.ptp(x) < SPANNED * width:
            found.append(
                CalibrationFinding(
                    "attention",
                    "stripe-span",
                    f"On the {level}s the stripe spans {np.ptp(x):.0f} mm of the block's "
                    f"{width:.0f} mm.",
                    "Bring the block to the middle of the stripe.",
                )
            )
    return found


def worst_points(seen: Evidence, corner_residuals_px: Floats) -> tuple[WorstResidual, ...]:
    """The few worst contacts, corners and stripe points."""
    contacts = 1e3 * np.abs(seen.alignment.residuals_mm)
    worst = [
        WorstResidual("contact", f"{seen.features[i]} {i + 1}", float(contacts[i]), "µm")
        for i in _largest(contacts)
    ]
    off = np.linalg.norm(corner_residuals_px, axis=1)
    worst += [
        WorstResidual("corner", seen.detection.corners[i].name, float(off[i]), "px")
        for i in _largest(off)
    ]
    heights = 1e3 * np.abs(np.nan_to_num(seen.laser.residuals_mm))
    along, place = (seen.stripe.u, "column") if seen.stripe.axis == "u" else (seen.stripe.v, "row")
    worst += [
        WorstResidual("stripe", f"{place} {along[i]:.0f}", float(heights[i]), "µm")
        for i in _largest(heights)
    ]
    return tuple(worst)


def _largest(values: Floats) -> list[int]:
    return [int(i) for i in np.argsort(-values)[:WORST_OF_A_KIND]]
