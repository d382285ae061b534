"""What browsers send and receive of the library of scans."""

from dataclasses import dataclass
from typing import Annotated

from pydantic import Field

from crenel.formats.results.scan_record import LONGEST_NAME, PartNames
from crenel.messages.message import Text
from crenel.wire.schema import RequestBody
from crenel.workflows.clouds.compare_clouds import CloudDeviation

ShortName = Annotated[str, Field(max_length=LONGEST_NAME)]


class NewPart(RequestBody):
    """The part of a scan, and for whom it is; what is not stated is empty."""

    part: ShortName = ""
    serial_number: ShortName = ""
    order: ShortName = ""
    customer: ShortName = ""


class RecordReplay(RequestBody):
    """How the opened record is played; ``at_s`` null: on from where it is."""

    at_s: Annotated[float, Field(ge=0, allow_inf_nan=False, strict=False)] | None = None
    playing: bool
    speed: Annotated[float, Field(gt=0, le=1000, strict=False)] = 1.0


class RecordReference(RequestBody):
    reference: Annotated[str, Field(max_length=128)]


class ScansToMerge(RequestBody):
    ids: Annotated[list[Annotated[str, Field(max_length=128)]], Field(min_length=2, max_length=50)]
    name: ShortName = ""


@dataclass(frozen=True)
class ScanSummary:
    id: str
    name: Text
    started_at: str
    points: int
    changed_ns: str
    """When its cloud or what is cut away of it changed: another one has another picture."""
    frames: int
    seconds: float
    calibration_id: str
    note: Text
    """What is wrong with its recording, or why it ended early; usually empty."""
    incomplete: bool
    """So much gave no points that the cloud must not be taken for the part; the note says what."""
    away: bool
    """Only the archive has its files."""
    part: PartNames
    calibration: str
    """Name of its calibration; empty if that is not known here."""
    frames_too_fast: int | None
    """Null, like the next: not counted, as by earlier versions."""
    frames_lost: int | None
    frames_without_points: int
    sources: tuple[Text, ...]
    """The names of the scans that a merged cloud is made of."""


@dataclass(frozen=True)
class ReplayTime:
    """Where the replay of a record is."""

    at_s: float
    playing: bool
    speed: float


@dataclass(frozen=True)
class RecordComparison:
    """The opened record against another one."""

    reference_id: str
    reference: Text
    """Its name."""
    same_calibration: bool
    deviation: CloudDeviation


@dataclass(frozen=True)
class OpenedRecord:
    """What the view shows instead of the live scan."""

    id: str
    name: Text
    seconds: float
    replay: ReplayTime | None
    """None: the whole cloud is shown."""
    comparison: RecordComparison | None
    busy: Text
    """What is computed of it now; empty if nothing is."""


@dataclass(frozen=True)
class ContinuedRecord:
    """The record to which the next scans are added."""

    id: str
    name: Text
    scans: int
    """How many it has so far."""


@dataclass(frozen=True)
class LibraryState:
    """What browsers show of the library beside the list of scans."""

    part: PartNames
    """The part of the scan that runs, or of the next one."""
    continued: ContinuedRecord | None
    opened: OpenedRecord | None
