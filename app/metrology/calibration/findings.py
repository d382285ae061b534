"""What a calibration shows about itself, in words: findings, and the worst points."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from app.metrology.calibration.uncertainty_budget import BudgetContribution
from app.metrology.detection.detect_block import ObjectDetection
from app.metrology.limits import LIMITS, Limits
from app.metrology.probing.alignment import Alignment
from app.metrology.sensor.camera import Camera
from app.metrology.targets.crenellated_block import Crenellated
from app.metrology.transforms import Floats

Quality = Literal["good", "attention", "bad", "neutral"]
_SEVERITY = {"bad": 0, "attention": 1}

EDGE_RMS_PX = 0.3
# Even a wide line full of speckle is located better than this.
STRIPE_RMS_PX = 1.0
# Contacts on opposite faces may lie so much further apart than they should: this many
# standard deviations, and this much in any case.
OPENING_SIGMAS, OPENING_MM = 4.0, 0.03
OPPOSITE = (("front", "back"), ("left", "right"))
# Pixels of today's sensors are square to this share, and a camera is known so well.
SQUARE, SQUARE_SIGMAS = 0.001, 4.0
# Further than any hand-held sensor reaches from the arm's last joint.
FARTHEST_MM = 600.0
# Share of the stripe on the levels that agrees with the plane.
AGREEING = 0.85
WORST_OF_A_KIND = 3


def offset_quality(off_mm: float, limits: Limits) -> Quality:
    """Of what moves points by so much without being in their uncertainty."""
    return "bad" if 1e3 * abs(off_mm) > limits.usable_um else "attention"


@dataclass(frozen=True)
class CalibrationFinding:
    """One sentence with the number and the limit, and what to do about it (may be empty).

    ``pose`` is the number of the pose that it is about, where it is about one.
    """

    quality: Quality
    code: str
    text: str
    remedy: str = ""
    pose: int | None = None


@dataclass(frozen=True)
class WorstResidual:
    """One of the points that fit worst: ``value`` in ``unit`` (µm or px).

    Its place: the row of a ``contact``, or the ``pose`` whose picture shows it and, on the
    stripe, the pixel.
    """

    kind: Literal["contact", "corner", "stripe"]
    name: str
    value: float
    unit: str
    contact: int | None = None
    pose: int | None = None
    at_px: tuple[float, float] | None = None


REMEDIES = {
    "contact points": "Touch more points, spread wide over all six faces.",
    "arm encoders": "Have the arm's calibration checked; hold it in a compact posture.",
    "arm geometry": "Take more poses, tilted and turned; have the arm's model identified anew.",
    "object certificate": "Use a block with a better certificate.",
    "edges and corners": "Light the block evenly, sharp and large in the picture.",
    "stripe": "Set the exposure so that the stripe is bright but not clipped.",
    "distortion": "Bring the block closer, so that it fills the picture.",
}


def sort_by_severity(found: Sequence[CalibrationFinding]) -> tuple[CalibrationFinding, ...]:
    """Bad, then those that want attention, then the rest, each as they came: the first is why
    a calibration is judged as it is."""
    return tuple(sorted(found, key=lambda one: _SEVERITY.get(one.quality, len(_SEVERITY))))


def uncertainty_verdict(
    total_um: float,
    rows: Sequence[BudgetContribution],
    limits: Limits = LIMITS,
    remedies: Mapping[str, str] = REMEDIES,
) -> CalibrationFinding:
    """Good, usable or not, by the uncertainty of a point against the user's limits.

    ``remedies`` are by the names of the rows.
    """
    known = f"A scanned point is known to {total_um:.0f} µm (k = 1) in the flange frame"
    if total_um <= limits.good_um:
        return CalibrationFinding(
            "good", "uncertainty", f"{known}; up to {limits.good_um:.0f} µm is good."
        )
    largest = max(rows, key=lambda row: row.value_um)
    because = f"mostly by the {largest.source} ({largest.value_um:.0f} µm)"
    usable = total_um <= limits.usable_um
    limit = limits.good_um if usable else limits.usable_um
    return CalibrationFinding(
        "attention" if usable else "bad",
        "uncertainty",
        f"{known}, {because}; the limit is {limit:.0f} µm.",
        remedies[largest.source],
    )


def contact_findings(
    alignment: Alignment, features: Sequence[str], limits: Limits = LIMITS
) -> list[CalibrationFinding]:
    """How well the contacts agree, and which were left out.

    However well many of them place the block, contacts that scatter by more than what is good
    of a point have a cause that may be theirs alone.
    """
    count = int((~alignment.outliers).sum())
    rms_um = 1e3 * alignment.rms_mm
    found = [
        CalibrationFinding(
            "good", "contacts", f"{count} contacts fit the block to {rms_um:.0f} µm rms."
        )
    ]
    if rms_um > limits.good_um:
        found = [
            CalibrationFinding(
                "attention",
                "contacts",
                f"{count} contacts fit the block to {rms_um:.0f} µm rms; up to "
                f"{limits.good_um:.0f} µm is good.",
                "Check that the tip is the one of the arm's file, that block and arm stood firm, "
                "and the arm's model.",
            )
        ]
    return [
        *found,
        *contact_outlier_findings(features, 1e3 * alignment.residuals_mm, alignment.outliers),
    ]


def contact_outlier_findings(
    features: Sequence[str], residuals_um: Floats, out: NDArray[np.bool_]
) -> list[CalibrationFinding]:
    """Which of N contacts, if any, disagree with the others, and by how much."""
    left_out = np.flatnonzero(out)
    if not len(left_out):
        return []
    named = ", ".join(f"{i + 1} ({features[i]}, {residuals_um[i]:+.0f} µm)" for i in left_out[:4])
    return [
        CalibrationFinding(
            "attention",
            "contact-outliers",
            f"{len(left_out)} of {len(out)} contacts disagree with the "
            f"others and were left out: {named}.",
            "Take these points again.",
        )
    ]


def size_finding(
    alignment: Alignment, features: Sequence[str], block: Crenellated
) -> CalibrationFinding:
    """Whether the block's size and the tip's diameter were seen, and right: contacts on
    opposite faces tell their sum, others move with the block."""
    labels = np.array(features)
    openings_mm: dict[tuple[str, str], float] = {}
    for pair in OPPOSITE:
        own = [alignment.residuals_mm[(labels == face) & ~alignment.outliers] for face in pair]
        if not all(len(residuals) for residuals in own):
            continue
        opening_mm = sum(float(np.mean(residuals)) for residuals in own)
        spread = sum(float(np.var(residuals)) / len(residuals) for residuals in own)
        sd_mm = float(np.sqrt(spread + 2 * block.standard_uncertainty_mm**2))
        limit_mm = max(OPENING_SIGMAS * sd_mm, OPENING_MM)
        if abs(opening_mm) > limit_mm:
            return size_error_finding(pair, opening_mm, limit_mm)
        openings_mm[pair] = opening_mm
    return size_agreement_finding(openings_mm) if openings_mm else size_unchecked_finding()


def size_error_finding(
    pair: tuple[str, str], opening_mm: float, limit_mm: float, limits: Limits = LIMITS
) -> CalibrationFinding:
    """Contacts on two opposite faces lie so much further apart than the papers say."""
    between = f"{pair[0]} and {pair[1]}"
    return CalibrationFinding(
        offset_quality(opening_mm / 2, limits),
        "size",
        f"The contacts on {between} lie {1e3 * abs(opening_mm):.0f} µm "
        f"{'further apart' if opening_mm > 0 else 'closer together'} than the block's "
        f"size and the tip's diameter say (limit {1e3 * limit_mm:.0f} µm).",
        "Check the tip's diameter and that this is the block; then the arm's model.",
    )


def size_agreement_finding(openings_mm: Mapping[tuple[str, str], float]) -> CalibrationFinding:
    """How much further apart than the papers say contacts on opposite faces lie, all well."""
    checked = []
    for pair, opening_mm in openings_mm.items():
        between = f"{pair[0]} and {pair[1]}"
        checked.append(f"{between} to {1e3 * opening_mm:+.0f} µm")
    return CalibrationFinding(
        "good",
        "size",
        f"The contacts agree with the block's size and the tip's diameter: {', '.join(checked)}.",
    )


def size_unchecked_finding() -> CalibrationFinding:
    """No two opposite faces were touched."""
    return CalibrationFinding(
        "neutral",
        "size-unchecked",
        "No two opposite sides were touched: the tip's diameter and the block's size are as their "
        "papers say, unchecked.",
        "Touch the front and the back, or the left and the right face.",
    )


def sensor_distance_findings(pivot_mm: Floats, remedy: str) -> list[CalibrationFinding]:
    """What is said where the sensor measures too far from the arm's last joint (3,)."""
    away_mm = float(np.linalg.norm(pivot_mm))
    if away_mm <= FARTHEST_MM:
        return []
    text = (
        f"The sensor measures {away_mm:.0f} mm away from the arm's last joint "
        f"(limit {FARTHEST_MM:.0f} mm)."
    )
    return [CalibrationFinding("attention", "sensor-far", text, remedy)]


def size_coverage_findings(detections: Sequence[ObjectDetection]) -> list[CalibrationFinding]:
    """Sizes of the block that no picture shows: were they wrong, nothing would tell."""
    hidden = [
        name
        for name in detections[0].unobserved_planes
        if all(name in one.unobserved_planes for one in detections[1:])
    ]
    if not hidden:
        return []
    return [
        CalibrationFinding(
            "neutral",
            "size-unseen",
            f"{'The picture does' if len(detections) == 1 else 'The pictures do'} not show "
            f"{', '.join(hidden)}: whether the certificate is right there is not checked.",
            "Turn the lamp until all edges of the block show, and take another picture.",
        )
    ]


def pixel_aspect_findings(camera: Camera, covariance_px2: Floats) -> list[CalibrationFinding]:
    """A certificate that is wrong along the camera's view looks like oblong pixels.

    ``covariance_px2`` (2, 2) is that of the two focal lengths.
    """
    fx, fy = camera.matrix[0, 0], camera.matrix[1, 1]
    gradient = np.array([-fy / fx**2, 1 / fx])
    sd = float(np.sqrt(gradient @ covariance_px2 @ gradient))
    limit = max(SQUARE, SQUARE_SIGMAS * sd)
    if abs(fy / fx - 1) <= limit:
        return []
    return [
        CalibrationFinding(
            "attention",
            "pixels-oblong",
            f"The camera's pixels come out {100 * abs(fy / fx - 1):.2f} % out of square; those of "
            f"today's sensors are square (limit {100 * limit:.2f} %).",
            "Compare the block's depth and heights with its certificate.",
        )
    ]
