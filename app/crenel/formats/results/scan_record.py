"""``scan.json``: what a scan is of and what is known of it, beside its recording and its cloud."""

from collections.abc import Mapping
from pathlib import Path
from typing import Annotated, ClassVar

from pydantic import BeforeValidator, Field

from crenel.formats.json_document import Document, DocumentPart, Software
from crenel.messages.message import Text

SCAN, CLOUD = "scan.json", "cloud.ply"
"""In the folder of a scan."""
LONGEST_NAME = 120


def _on_one_line(value: object) -> object:
    return " ".join(value.split()) if isinstance(value, str) else value


Name = Annotated[str, BeforeValidator(_on_one_line), Field(max_length=LONGEST_NAME)]
"""On one line, without spaces around it; empty: not stated."""


class PartNames(DocumentPart):
    """The part that was scanned, and for whom."""

    part: Name = ""
    serial_number: Name = ""
    order: Name = ""
    customer: Name = ""

    def metadata(self) -> dict[str, str]:
        """As a recording states it, under ``scan_part`` and the like."""
        return {f"scan_{name}": value for name, value in self.model_dump().items()}


NO_PART = PartNames()


def part_from_metadata(metadata: Mapping[str, str]) -> PartNames:
    """What a recording states of its part; what is longer than a name is cut."""
    names = {name: metadata.get(f"scan_{name}", "") for name in PartNames.model_fields}
    return PartNames(**{key: value[:LONGEST_NAME] for key, value in names.items()})


class MergedScan(DocumentPart):
    """A scan whose points are in a merged cloud; its first frame there has the number ``frame``."""

    id: str
    name: Text
    calibration_id: str
    points: int
    frame: int


class ScanFile(Document):
    """The name, the part and the figures of a scan; ``crenel report`` renders it."""

    FORMAT: ClassVar[str] = "crenel/scan"

    name: Text
    started_at: str
    part: PartNames = NO_PART
    points: int
    frames: int
    seconds: float
    frames_without_points: int = 0
    """Frames with a line that gave no points, of ``frames_with_line``."""
    frames_with_line: int = 0
    frames_too_fast: int | None = None
    """None, like the next: not counted, as by earlier versions."""
    frames_lost: int | None = None
    note: Text = ""
    """What is wrong with it; usually empty."""
    calibration_id: str
    calibration: str = ""
    """The name of the calibration."""
    calibration_um: float | None = None
    """Standard uncertainty of a scanned point by the calibration."""
    arm_serial: str = ""
    sensor_serial: str = ""
    sources: tuple[MergedScan, ...] = ()
    """The scans that a merged cloud is made of."""
    operator: str = ""
    station: str = ""
    simulated: bool = False
    software: Software


def read_scan_file(folder: Path) -> ScanFile | None:
    """Reads the record in a scan's folder; None where it has none, as of earlier versions.

    Raises:
        OperationError: the file is damaged.
    """
    path = folder / SCAN
    return ScanFile.read(path) if path.exists() else None
