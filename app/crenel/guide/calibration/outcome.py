"""What was found in the calibration pictures, as the journal keeps it. Pure."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from pydantic import TypeAdapter

from crenel.findings import Finding
from crenel.guide.common.result_view import CalibrationResult
from crenel.guide.common.view import ImageCorner, Segment, TouchedPoint, Vec3
from crenel.metrology.detection.failure_evidence import ImageAnnotation


@dataclass(frozen=True)
class PoseDrawing:
    """What a solve found in one pose's picture, each corner with its residual."""

    number: int
    corners: Sequence[ImageCorner]
    outline: Sequence[Segment]
    stripe: Sequence[tuple[float, float]]
    stripe_off: Sequence[Vec3] = ()


@dataclass(frozen=True)
class CalibrationOutcome:
    """The object and the stripe in a fresh picture; or a solve's result, and each pose's.

    Of a picture that was declined, ``fault`` names what of it is at fault (exposure, focus,
    framing, object or lighting) and ``marks`` shows it. ``points`` are a board's, which only
    the pictures put in their place.
    """

    corners: Sequence[ImageCorner]
    outline: Sequence[Segment]
    stripe: Sequence[tuple[float, float]]
    findings: Sequence[Finding]
    result: CalibrationResult | None
    marks: tuple[ImageAnnotation, ...] = ()
    poses: tuple[PoseDrawing, ...] = ()
    fault: str = ""
    points: tuple[TouchedPoint, ...] = ()


_ADAPTER = TypeAdapter(CalibrationOutcome)


def to_payload(outcome: CalibrationOutcome) -> dict[str, object]:
    """The outcome as a journal row carries it."""
    payload: dict[str, object] = _ADAPTER.dump_python(outcome)
    return payload


def from_payload(payload: Mapping[str, object]) -> CalibrationOutcome:
    """The outcome back from a journal row."""
    return _ADAPTER.validate_python(payload)
