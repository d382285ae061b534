"""Why the block was not detected in a picture, and where the picture shows it."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import cv2
import numpy as np
from numpy.typing import NDArray

from crenel.errors import OperationError
from crenel.messages.message import join
from crenel.metrology.detection.edges.measure_all import EdgeMeasurements
from crenel.metrology.detection.image_quality import RAW, ImageFinding
from crenel.metrology.detection.rejection import RejectionReason
from crenel.metrology.detection.search.coarse_pose import SearchResult
from crenel.metrology.detection.visibility import find_visible_edges
from crenel.metrology.sensor.camera import Camera, project
from crenel.metrology.transforms import Floats

Fault = Literal["camera", "exposure", "focus", "framing", "object", "lighting"]
AnnotationKind = Literal["clipped", "segment", "outline", "disagrees", "outside"]

_FAULTS: dict[str, Fault] = {
    "image-dark": "exposure",
    "image-saturated": "exposure",
    "image-blurred": "focus",
    "object-cut-off": "framing",
    "object-not-found": "framing",
    "object-unclear": "lighting",
    "object-does-not-match": "object",
    "object-mirrored": "object",
    "object-ambiguous": "object",
}
# A dim or soft picture is reported before anything that was not detected in it.
_FINDING_FAULTS: dict[str, Fault] = {
    RAW: "camera",
    "image-dim": "exposure",
    "image-dark": "exposure",
    "image-saturated": "exposure",
    "image-soft": "focus",
    "image-blurred": "focus",
}
# Clipped regions smaller than this share of the picture are glints; maximum number shown.
_GLINT, _REGIONS = 5e-4, 12
_SEGMENTS = 60


@dataclass(frozen=True)
class ImageAnnotation:
    """A line to draw on the picture, from (u0, v0) to (u1, v1) in px, and its meaning.

    ``clipped``: the border of an overexposed region; ``segment``: a straight edge that was
    detected; ``outline``: an edge of the closest hypothesis that the picture shows; ``disagrees``:
    one that it does not show, or shows elsewhere; ``outside``: out of the frame.
    """

    kind: AnnotationKind
    u0: float
    v0: float
    u1: float
    v1: float


class DetectionError(OperationError):
    """A picture in which the object was not detected, with the cause and the evidence."""

    def __init__(
        self, refusal: OperationError, fault: Fault, marks: tuple[ImageAnnotation, ...]
    ) -> None:
        super().__init__(refusal.code, refusal.what, refusal.why, refusal.remedy)
        self.fault: Fault = fault
        self.marks = marks


def with_evidence(
    refusal: OperationError,
    findings: list[ImageFinding],
    clipped: NDArray[np.bool_],
    found: SearchResult | None,
    nearest: EdgeMeasurements | None,
    against: RejectionReason | None,
) -> DetectionError:
    """The error with its cause, and with marks in the pixels of the picture.

    Args:
        refusal: why the picture was refused.
        findings: problems of the picture as such.
        clipped: (H, W) overexposed pixels.
        found: straight edges and hypotheses that were found, if any.
        nearest: the hypothesis that the picture supports most, measured.
        against: the evidence against it.
    """
    fault = _FAULTS.get(refusal.code, "object")
    by_light = against is not None and against.alone
    unseen = refusal.code in ("object-not-found", "object-unclear") and not by_light
    if unseen or is_raw(findings):
        fault, refusal = prefer_image_fault(fault, refusal, findings)
    marks = mark_clipped_regions(clipped) if fault == "exposure" else []
    if nearest is not None:
        marks += _mark_outline(nearest, against)
    elif found is not None:
        marks += _mark_segments(found, clipped.shape)
    return DetectionError(refusal, fault, tuple(marks))


def prefer_image_fault(
    fault: Fault, refusal: OperationError, findings: list[ImageFinding], guessed: bool = False
) -> tuple[Fault, OperationError]:
    """The cause: problems of the picture as such before anything that was not detected in it.

    Args:
        fault, refusal: the cause if the picture as such has no problem.
        findings: its problems.
        guessed: the reason only lists possible causes, so that a finding replaces it instead
            of preceding it. Nothing that was seen in a raw picture is a reason.
    """
    named = next((one for one in findings if one.code in _FINDING_FAULTS), None)
    if named is None:
        return fault, refusal
    kept = ("", "") if guessed or named.code == RAW else (refusal.why, refusal.remedy)
    why = join([part for part in (named.text, kept[0]) if part], "; ")
    remedy = join([part for part in (named.remedy, kept[1]) if part], "; ")
    return _FINDING_FAULTS[named.code], OperationError(refusal.code, refusal.what, why, remedy)


def is_raw(findings: Sequence[ImageFinding]) -> bool:
    """Whether a picture is in truth a raw one of a colour camera."""
    return any(one.code == RAW for one in findings)


def mark_clipped_regions(clipped: NDArray[np.bool_]) -> list[ImageAnnotation]:
    """The borders of the largest overexposed regions, as boxes."""
    count, _, stats, _ = cv2.connectedComponentsWithStats(clipped.astype(np.uint8))
    order = np.argsort(-stats[1:count, cv2.CC_STAT_AREA])[:_REGIONS] + 1
    marks: list[ImageAnnotation] = []
    for k in order:
        left, top, width, height, area = (float(value) for value in stats[k])
        if area < _GLINT * clipped.size:
            break
        right, low = left + width - 1, top + height - 1
        corners = ((left, top), (right, top), (right, low), (left, low))
        for one, other in zip(corners, (*corners[1:], corners[0]), strict=True):
            marks.append(ImageAnnotation("clipped", *one, *other))
    return marks


def _mark_segments(found: SearchResult, shape: tuple[int, ...]) -> list[ImageAnnotation]:
    """The most significant straight edges that were detected."""
    height, width = shape
    lines = found.segments[:_SEGMENTS] * max(width, height)
    lines = lines + np.tile([(width - 1) / 2, (height - 1) / 2], 2)
    return [ImageAnnotation("segment", *(float(value) for value in line)) for line in lines]


def _mark_outline(
    nearest: EdgeMeasurements, against: RejectionReason | None
) -> list[ImageAnnotation]:
    """The visible edges as the hypothesis predicts them: agreeing, disagreeing, out of the
    frame."""
    camera, frame = nearest.camera, nearest.frame
    parts = find_visible_edges(frame, camera.centre_mm)
    begin = frame.starts_mm[parts.edge]
    along = frame.ends_mm[parts.edge] - begin
    first = project(camera, begin + parts.start[:, None] * along)
    last = project(camera, begin + parts.end[:, None] * along)
    wrong = set(against.edges) if against is not None else set()
    marks = []
    for edge, one, other in zip(parts.edge, first, last, strict=True):
        kind: AnnotationKind = "disagrees" if int(edge) in wrong else "outline"
        if _is_outside(camera, one) and _is_outside(camera, other):
            kind = "outside"
        marks.append(
            ImageAnnotation(kind, float(one[0]), float(one[1]), float(other[0]), float(other[1]))
        )
    return marks


def _is_outside(camera: Camera, uv: Floats) -> bool:
    return bool((uv < 0).any() or uv[0] > camera.width_px - 1 or uv[1] > camera.height_px - 1)
