"""What the browser is shown of a calibration's result.

Parts of ``calibration.json`` are shown as they are; a class of its own has what the file puts
differently: names in words, the place where a point is drawn, one row for each pixel or pose.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from crenel.findings import Quality
from crenel.formats.results.calibration import FacePart, PlanePart
from crenel.messages.message import Text


@dataclass(frozen=True)
class BudgetLine:
    source: Text
    value_um: float


@dataclass(frozen=True)
class WorstPointLine:
    """One of the points with the largest residuals: ``point`` is the index of the contact point,
    ``at_px`` the position in the picture of ``pose``."""

    kind: Literal["contact", "corner", "stripe"]
    name: Text
    value: float
    unit: str
    point: int | None = None
    pose: int | None = None
    at_px: tuple[float, float] | None = None


@dataclass(frozen=True)
class MovedPoint:
    """Displacement, between two calibrations, of the point that a pixel shows."""

    u: float
    v: float
    moved_um: float


@dataclass(frozen=True)
class Comparison:
    """Displacement of points of the measuring volume since another calibration."""

    with_name: str
    max_um: float
    rms_um: float
    map: Sequence[MovedPoint] = ()


@dataclass(frozen=True)
class MapPoint:
    """Standard uncertainty of the point that a pixel shows, k = 1; ``inside`` the depths that the
    stripe covered."""

    u: float
    v: float
    u_um: float
    inside: bool


@dataclass(frozen=True)
class PoseRow:
    """The result of one pose; ``reason`` if it, or its laser line, was excluded."""

    number: int
    used: bool
    reason: Text
    edges_rms_px: float
    stripe_rms_px: float | None
    """None without a laser line."""
    off_um: float


@dataclass(frozen=True)
class CalibrationResult:
    verdict: Quality
    verdict_text: Text
    reprojection_rms_px: float
    laser_plane_rms_um: float | None
    """None where camera and mounting alone were calibrated."""
    alignment_rms_um: float | None
    """The rms of the contacts; None where the object was not touched."""
    depth_range_mm: tuple[float, float]
    probe_matrix: Sequence[Sequence[float]]
    faces: Sequence[FacePart]
    budget: Sequence[BudgetLine]
    total_um: float
    worst: Sequence[WorstPointLine]
    comparison: Comparison | None
    distortion: Sequence[float]
    plane: PlanePart | None = None
    map: Sequence[MapPoint] = ()
    poses: Sequence[PoseRow] = ()
    shown_pose: int = 0
    """The pose whose picture is shown first: its edges fit worst."""
    good_um: float | None = None
    usable_um: float | None = None
    """The limits that the verdict went by."""
