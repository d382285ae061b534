"""What the server tells of its records; field for field frontend/src/api/recordTypes.ts."""

from collections.abc import Sequence
from dataclasses import dataclass

from app.api.schema import CalibrationSummary
from app.guide.view import ResultPicture
from app.station.findings import Finding, Quality


@dataclass(frozen=True)
class RecordedCalibration:
    """An accepted calibration; ``operator`` and ``station`` are empty where not written down."""

    summary: CalibrationSummary
    operator: str
    station: str
    temperature_c: float | None
    picture: ResultPicture
    findings: Sequence[Finding]


@dataclass(frozen=True)
class CalibrationPoint:
    """One calibration of the history, and what moved since the one before of the same arm and
    sensor (null for the first); ``expected_…`` is what their uncertainties let expect of a
    sensor that did not move, k = 2."""

    id: str
    name: str
    accepted_at: str
    total_um: float
    verdict: Quality
    good_um: float | None
    temperature_c: float | None
    arm_serial: str
    sensor_serial: str
    sensor_um: float | None
    sensor_arcsec: float | None
    plane_um: float | None
    plane_arcsec: float | None
    points_um: float | None
    expected_um: float | None
    expected_arcsec: float | None
