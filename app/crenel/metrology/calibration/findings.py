"""The findings of a calibration, and its worst points."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from crenel.messages.limits import beside_limit
from crenel.messages.message import Text, join, message, quantity, signed, word
from crenel.messages.uncertainty import POINT_DECIMALS
from crenel.metrology.calibration.uncertainty_budget import BudgetContribution, source_text
from crenel.metrology.detection.detect_block import ObjectDetection
from crenel.metrology.detection.edges.dimension_test import describe_plane
from crenel.metrology.limits import LIMITS, Limits
from crenel.metrology.probing.alignment import Alignment
from crenel.metrology.sensor.camera import Camera
from crenel.metrology.targets.crenellated_block import Crenellated
from crenel.metrology.transforms import Floats

Quality = Literal["good", "attention", "bad", "neutral"]
_SEVERITY = {"bad": 0, "attention": 1}

EDGE_RMS_PX = 0.3
# Even a wide line with strong speckle is located better than this.
STRIPE_RMS_PX = 1.0
# Limit for the additional distance between contact points on opposite faces: in standard
# deviations, and in any case.
OPENING_SIGMAS, OPENING_MM = 4.0, 0.03
OPPOSITE = (("front", "back"), ("left", "right"))
# Pixels of current sensors are square to this share, if the camera is known this well.
SQUARE, SQUARE_SIGMAS = 0.001, 4.0
# No hand-held sensor measures further than this from the arm's last joint.
FARTHEST_MM = 600.0
# Minimum share of the stripe on the levels that agrees with the plane.
AGREEING = 0.85
WORST_OF_A_KIND = 3


def offset_quality(off_mm: float, limits: Limits) -> Quality:
    """Limit for effects that move points without being part of their uncertainty."""
    return "bad" if 1e3 * abs(off_mm) > limits.usable_um else "attention"


@dataclass(frozen=True)
class CalibrationFinding:
    """One sentence with the value and the limit, and a remedy (may be empty).

    ``pose`` is the number of the pose concerned, if it concerns one.
    """

    quality: Quality
    code: str
    text: Text
    remedy: Text = ""
    pose: int | None = None


@dataclass(frozen=True)
class WorstResidual:
    """One of the points with the largest residuals: ``value`` in ``unit`` (µm or px).

    Its position is the row of a ``contact`` and its ``face``, or the ``pose`` whose picture shows
    it and the name of the ``corner`` or, on the stripe, the pixel.
    """

    kind: Literal["contact", "corner", "stripe"]
    name: Text
    value: float
    unit: str
    contact: int | None = None
    pose: int | None = None
    at_px: tuple[float, float] | None = None
    face: str = ""
    corner: str = ""


def contact_residual(contact: int, face: str, off_um: float) -> WorstResidual:
    """A contact point by its row and its face."""
    name = message("face-and-number", face=word(face), number=contact + 1)
    return WorstResidual("contact", name, off_um, "µm", contact, face=face)


def corner_text(corner: str) -> Text:
    """The name of a corner for display: "corner 3,4" for a chessboard; for ``crest:2:L:front`` of a
    block, "crest 3, front left"."""
    if corner.startswith("corner "):
        column, _, row = corner.removeprefix("corner ").partition(",")
        return message("corner", column=column, row=row)
    level, *place = corner.split(":")
    number = int(place.pop(0)) + 1 if place and place[0].isdecimal() else 0
    return message("block-corner", level=level, number=number, place="-".join(place))


REMEDIES = {
    "contact points": message("touch-more-points-on-all-faces"),
    "arm encoders": message("have-arms-calibration-checked-hold-compact"),
    "arm geometry": message("take-more-poses-tilted-turned-have"),
    "object certificate": message("use-block-better-certificate"),
    "edges and corners": message("light-block-evenly-sharp-large-picture"),
    "stripe": message("set-exposure-stripe-bright-not-clipped"),
    "distortion": message("bring-block-closer-so-fills-picture"),
}


def sort_by_severity(findings: Sequence[CalibrationFinding]) -> tuple[CalibrationFinding, ...]:
    """Bad findings first, then those that need attention, then the others, otherwise in their
    order: the first one is the reason of the verdict."""
    return tuple(sorted(findings, key=lambda one: _SEVERITY.get(one.quality, len(_SEVERITY))))


def uncertainty_verdict(
    total_um: float,
    rows: Sequence[BudgetContribution],
    limits: Limits = LIMITS,
    remedies: Mapping[str, Text] = REMEDIES,
    point: Literal["scanned", "seen"] = "scanned",
) -> CalibrationFinding:
    """Good, usable or bad, by the uncertainty of a point and the user's limits.

    Args:
        remedies: keyed by the names of the rows.
        point: what a point is: scanned, or without a laser plane seen at the object's distance.
    """
    if total_um <= limits.good_um:
        total, good = beside_limit(total_um, limits.good_um, "µm", POINT_DECIMALS)
        text = message("point-known-good", point=point, total=total, good=good)
        return CalibrationFinding("good", "uncertainty", text)
    largest = max(rows, key=lambda row: row.value_um)
    usable = total_um <= limits.usable_um
    broken_um = limits.good_um if usable else limits.usable_um
    total, limit = beside_limit(total_um, broken_um, "µm", POINT_DECIMALS)
    return CalibrationFinding(
        "attention" if usable else "bad",
        "uncertainty",
        message(
            "point-known-mostly-by",
            point=point,
            total=total,
            source=source_text(largest.source),
            value=quantity(largest.value_um, "µm"),
            limit=limit,
        ),
        remedies[largest.source],
    )


def contact_findings(
    alignment: Alignment, features: Sequence[str], limits: Limits = LIMITS
) -> list[CalibrationFinding]:
    """How well the contact points agree, and which were excluded.

    Even if many contact points determine the position of the block well, a scatter beyond the limit
    for a point has a cause that may affect only them.
    """
    count = int((~alignment.outliers).sum())
    rms_um = 1e3 * alignment.rms_mm
    findings = [
        CalibrationFinding(
            "good",
            "contacts",
            message("contacts-fit-block-rms", count=count, rms=quantity(rms_um, "µm")),
        )
    ]
    if rms_um > limits.good_um:
        rms, good = beside_limit(rms_um, limits.good_um, "µm")
        findings = [
            CalibrationFinding(
                "attention",
                "contacts",
                message(
                    "contacts-fit-block-rms-up-good",
                    count=count,
                    rms=rms,
                    good=good,
                ),
                message("check-tip-one-arms-file-block"),
            )
        ]
    return [
        *findings,
        *contact_outlier_findings(features, 1e3 * alignment.residuals_mm, alignment.outliers),
    ]


def contact_outlier_findings(
    features: Sequence[str], residuals_um: Floats, out: NDArray[np.bool_]
) -> list[CalibrationFinding]:
    """The contact points among N that disagree with the others, if any, and by how much."""
    left_out = np.flatnonzero(out)
    if not len(left_out):
        return []
    named = [
        message(
            "contact-off-by",
            number=int(i) + 1,
            face=word(features[i]),
            off=signed(residuals_um[i], "µm"),
        )
        for i in left_out[:4]
    ]
    return [
        CalibrationFinding(
            "attention",
            "contact-outliers",
            message(
                "contacts-disagree-others-were-left-out",
                left_out=len(left_out),
                count=len(out),
                named=join(named),
            ),
            message("take-these-points-again"),
        )
    ]


def stripe_finding(points: int, rms_px: float, share: float, remedy: Text) -> CalibrationFinding:
    """How well one plane fits so many points of the stripe, a share of those on the object;
    ``remedy`` is that of points that do not lie on it."""
    if rms_px <= STRIPE_RMS_PX:
        remedy = "" if share >= AGREEING else message("keep-reflections-out-grooves-matt-spray")
    return CalibrationFinding(
        "attention" if remedy else "good",
        "laser-plane",
        message(
            "stripe-points-fit-one-laser-plane",
            points=points,
            rms=quantity(rms_px, "px", 2),
            stripe_rms_px=quantity(STRIPE_RMS_PX, "px", 1),
            share=quantity(100 * share, "%"),
            agreeing=quantity(100 * AGREEING, "%"),
        ),
        remedy,
    )


def size_finding(
    alignment: Alignment, features: Sequence[str], block: Crenellated
) -> CalibrationFinding:
    """Whether the data show the block's size and the tip's diameter, and whether they are right:
    contact points on opposite faces determine their sum, others move with the block."""
    labels = np.array(features)
    openings_mm: dict[tuple[str, str], float] = {}
    for pair in OPPOSITE:
        own = [alignment.residuals_mm[(labels == face) & ~alignment.outliers] for face in pair]
        if not all(len(residuals) for residuals in own):
            continue
        opening_mm = sum(float(np.mean(residuals)) for residuals in own)
        opening_mm += sum(alignment.face_offsets_mm.get(face, 0.0) for face in pair)
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
    """Contact points on two opposite faces are this much further apart than the certificates
    state."""
    opening, limit = beside_limit(1e3 * abs(opening_mm), 1e3 * limit_mm, "µm")
    return CalibrationFinding(
        offset_quality(opening_mm / 2, limits),
        "size",
        message(
            "contacts-lie-than-blocks-size-tips",
            pair=pair[0],
            opening=opening,
            sign="apart" if opening_mm > 0 else "together",
            limit=limit,
        ),
        message("check-tips-diameter-block-then-arms"),
    )


def size_agreement_finding(openings_mm: Mapping[tuple[str, str], float]) -> CalibrationFinding:
    """Additional distance of contact points on opposite faces relative to the certificates, if all
    is well."""
    checked = [
        message(
            "faces-agree-to",
            first=word(first),
            second=word(second),
            opening=signed(1e3 * opening_mm, "µm"),
        )
        for (first, second), opening_mm in openings_mm.items()
    ]
    return CalibrationFinding(
        "good",
        "size",
        message("contacts-agree-blocks-size-tips-diameter", checked=join(checked)),
    )


def size_unchecked_finding() -> CalibrationFinding:
    """No two opposite faces were probed."""
    return CalibrationFinding(
        "neutral",
        "size-unchecked",
        message("no-two-opposite-sides-were-touched"),
        message("touch-front-back-left-right-face"),
    )


def sensor_distance_findings(pivot_mm: Floats, remedy: Text) -> list[CalibrationFinding]:
    """The sensor measures too far from the arm's last joint (3,)."""
    away_mm = float(np.linalg.norm(pivot_mm))
    if away_mm <= FARTHEST_MM:
        return []
    text = message(
        "sensor-measures-away-arms-last-joint",
        away=quantity(away_mm, "mm"),
        farthest_mm=quantity(FARTHEST_MM, "mm"),
    )
    return [CalibrationFinding("attention", "sensor-far", text, remedy)]


def size_coverage_findings(detections: Sequence[ObjectDetection]) -> list[CalibrationFinding]:
    """Dimensions of the block that no picture shows: errors in them would go unnoticed."""
    hidden = [
        describe_plane(*plane)
        for plane in detections[0].unobserved_planes
        if all(plane in one.unobserved_planes for one in detections[1:])
    ]
    if not hidden:
        return []
    return [
        CalibrationFinding(
            "neutral",
            "size-unseen",
            message(
                "picture-does-not-show-certificate-not-checked",
                detections=len(detections),
                hidden=join(hidden),
            ),
            message("turn-lamp-until-all-edges-block"),
        )
    ]


def pixel_aspect_findings(camera: Camera, covariance_px2: Floats) -> list[CalibrationFinding]:
    """A certificate that is wrong along the viewing direction looks like non-square pixels.

    ``covariance_px2`` (2, 2) is that of the two focal lengths.
    """
    fx, fy = camera.matrix[0, 0], camera.matrix[1, 1]
    gradient = np.array([-fy / fx**2, 1 / fx])
    sd = float(np.sqrt(gradient @ covariance_px2 @ gradient))
    limit = max(SQUARE, SQUARE_SIGMAS * sd)
    if abs(fy / fx - 1) <= limit:
        return []
    difference, most = beside_limit(100 * abs(fy / fx - 1), 100 * limit, "%", 2)
    return [
        CalibrationFinding(
            "attention",
            "pixels-oblong",
            message(
                "cameras-pixels-come-out-out-square",
                difference=difference,
                limit=most,
            ),
            message("compare-blocks-depth-heights-certificate"),
        )
    ]
