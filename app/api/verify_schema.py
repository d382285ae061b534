"""Verifications as the server lists them; field for field the shapes of verifyTypes.ts."""

from collections.abc import Mapping
from dataclasses import dataclass

from app.files.gauge import Shape
from app.files.verification import Result


@dataclass(frozen=True)
class VerificationSummary:
    id: str
    accepted_at: str
    calibration_id: str
    calibration: str
    """Its name."""
    result: Result
    text: str
    shape: Shape
    gauge: str
    clouds: int
    touched: bool
    operator: str


@dataclass(frozen=True)
class StudyState:
    """Of the clouds rebuilt with every calibration: under way, or done, or neither."""

    running: bool
    text: str
    fraction: float | None
    accepted: int
    """How many calibrations there are by now."""
    study: Mapping[str, object] | None
    """``study.json``."""
