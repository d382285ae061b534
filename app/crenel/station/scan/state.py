"""The state of a scan: while it runs, its load, and once it is finished."""

from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from crenel.findings import Finding
from crenel.formats.recording.completeness import NONE_MISSING, MissingFrames
from crenel.formats.results.scan_record import NO_PART, PartNames
from crenel.messages.message import Text

State = Literal["idle", "running", "stopping", "blocked"]


@dataclass(frozen=True)
class ScanState:
    """A scan as the browser shows it; the numbers of the last one stay until the next."""

    state: State
    why_not: Text
    scan_id: str | None
    points: int
    points_shown: int
    rate_points_s: float
    frames: int
    lost_frames: int
    frames_without_joints: int
    frames_still: int
    """The frames of a line that stood still; they gave no points beyond the first ones."""
    incomplete: bool
    """So many frames gave no points that the cloud must not be taken for the part."""
    seconds: float
    blur_mm: float | None
    """The way of the surface under the stripe during the newest exposure."""
    step_mm: float | None
    """From one stripe to the next: the points' spacing along the pass."""
    blur_limit_mm: float | None
    frames_too_fast: int
    pictures: int
    """Recorded beside their stripes."""
    findings: tuple[Finding, ...]


NO_SCAN = ScanState("idle", "", None, 0, 0, 0.0, 0, 0, 0, 0, False, 0.0, None, None, None, 0, 0, ())


@dataclass(frozen=True)
class ScanResult:
    """A finished scan; its folder holds ``scan.mcap`` and mostly ``cloud.ply``."""

    id: str
    name: Text
    folder: Path
    started_at: str
    points: int
    frames: int
    seconds: float
    calibration_id: str
    lost_frames: int = 0
    interrupted: Text = ""
    """Why it ended before the operator ended it; empty where it did not."""
    recording_bytes: int = 0
    suspended_s: float = 0.0
    """For how long the program was suspended meanwhile, and nothing was recorded."""
    left_out: MissingFrames = NONE_MISSING
    part: PartNames = NO_PART
    frames_too_fast: int = 0


@dataclass(frozen=True)
class ScanLoad:
    """What a scan asks of the machine."""

    backlog: float
    """How full its fullest queue is, 0 to 1."""
    bytes_written: int
    """The bytes of the recording."""
    seconds: float
