"""What is to be copied to the archive, and what may leave the station's disk. Pure."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from datetime import datetime, timedelta
from pathlib import Path

from crenel.archive.manifest import ArchiveNote, Kind
from crenel.formats.results.scan_record import CLOUD
from crenel.timestamps import is_moment, parse_moment

"""A scan's cloud; the archive leaves it out where it can be made again."""
LEAST_KEPT = timedelta(days=1)
"""Nothing leaves the station's disk earlier, however full that is."""


@dataclass(frozen=True, slots=True)
class FileStamp:
    """State of a file of a record, without its content."""

    path: str
    """Relative to the record's folder, with ``/``."""
    bytes: int
    mtime_ns: int


@dataclass(frozen=True, slots=True)
class StationRecord:
    """A record on the station's disk."""

    kind: Kind
    id: str
    folder: Path
    at: datetime
    """When it was last changed."""
    finished: bool
    needed: bool
    """The station needs it on its own disk: for example, it is the calibration in use."""
    stamps: tuple[FileStamp, ...] = field(default=())
    """The stamps of all files, by path."""
    note: ArchiveNote | None = None
    label: str | None = None
    """The name of a scan in the list of scans."""
    calibration_id: str | None = None
    """The calibration of a scan by the list of scans: recordings of earlier versions do not state
    it."""
    points: int | None = None
    """The points of a scan with a cloud."""
    left_out: frozenset[str] = frozenset()
    """Files that are not copied: they are made again from the others."""

    @property
    def size_bytes(self) -> int:
        """All files together."""
        return sum(stamp.bytes for stamp in self.stamps)

    @property
    def bytes_without_cloud(self) -> int:
        """All files together but the cloud."""
        return sum(stamp.bytes for stamp in self.stamps if stamp.path != CLOUD)

    @property
    def copied(self) -> tuple[FileStamp, ...]:
        """The files that the archive takes."""
        return tuple(stamp for stamp in self.stamps if stamp.path not in self.left_out)

    @property
    def is_cloud_left_out(self) -> bool:
        """Whether the archive has no cloud, as it can be made again from the recording there."""
        held = () if self.note is None else self.note.files
        return bool(held) and not any(file.path == CLOUD for file in held)

    @property
    def is_archived(self) -> bool:
        """Whether the archive has exactly these files, perhaps without the cloud, under this name;
        without their names, as earlier versions wrote them, they stay as they are."""
        if self.note is None or self.note.label not in (None, self.label):
            return False
        left_out = {CLOUD} if self.kind == "scans" and self.is_cloud_left_out else set()
        here = tuple(stamp for stamp in self.stamps if stamp.path not in left_out)
        return here == stamps_of(self.note)


@dataclass(frozen=True, slots=True)
class Retention:
    """How long the station keeps what the archive has; None: no such rule."""

    keep_days: float | None = None
    free_gb: float | None = None


def stamps_of(note: ArchiveNote) -> tuple[FileStamp, ...]:
    """The files that the archive has, as they were on the station, by path."""
    found = (FileStamp(file.path, file.bytes, file.mtime_ns) for file in note.files)
    return tuple(sorted(found, key=lambda stamp: stamp.path))


def plan_copies(records: Sequence[StationRecord]) -> list[StationRecord]:
    """The finished records that the archive does not have as they are, oldest first."""
    missing = [one for one in records if one.finished and one.stamps and not one.is_archived]
    return sorted(missing, key=lambda one: (one.at, one.kind, one.id))


def plan_removals(
    records: Sequence[StationRecord], now: datetime, rules: Retention, free_bytes: int
) -> list[StationRecord]:
    """The records that may leave the station's disk, in this order.

    Each is archived as it is, not needed here, and has been on this disk unchanged for a day. The
    caller reads the archive's copy once more before it removes the station's.

    Args:
        free_bytes: free on the station's disk.
    """
    removable = sorted(
        (
            one
            for one in records
            if one.finished and one.is_archived and not one.needed
            if now - start_of_keeping(one) >= LEAST_KEPT
        ),
        key=lambda one: (start_of_keeping(one), one.kind, one.id),
    )
    chosen = []
    for one in removable:
        old = rules.keep_days is not None and now - start_of_keeping(one) >= timedelta(
            days=rules.keep_days
        )
        tight = rules.free_gb is not None and free_bytes < rules.free_gb * 1e9
        if old or tight:
            chosen.append(one)
            free_bytes += one.size_bytes
    return chosen


def start_of_keeping(record: StationRecord) -> datetime:
    """Since when a record has been on the station's disk as it is."""
    fetched = record.note.fetched_at if record.note is not None else ""
    return max(record.at, parse_moment(fetched)) if is_moment(fetched) else record.at
