"""Finished scans."""

import json
import logging
import threading
from dataclasses import dataclass
from pathlib import Path

from crenel.errors import OperationError
from crenel.formats.recording.completeness import NONE_MISSING, MissingFrames
from crenel.formats.results.scan_record import NO_PART, PartNames
from crenel.messages.message import Text
from crenel.messages.stored import decode_text, encode_data
from crenel.store.database import NOT_SAVED, Database

log = logging.getLogger(__name__)


@dataclass(frozen=True, slots=True)
class ScanRecord:
    """One finished scan and the folder of its recording and cloud."""

    id: str
    name: Text
    folder: Path
    started_at: str
    points: int
    frames: int
    seconds: float
    calibration_id: str
    interrupted: Text = ""
    """Why it ended before the operator ended it; otherwise empty."""
    recording_bytes: int | None = None
    """Size of its completed recording; None for scans from earlier versions."""
    suspended_s: float = 0.0
    """For how long the program was suspended meanwhile."""
    left_out: MissingFrames = NONE_MISSING
    """Nothing of scans from earlier versions."""
    part: PartNames = NO_PART
    frames_too_fast: int | None = None
    """None, like the next, of scans from earlier versions."""
    frames_lost: int | None = None
    sources: tuple[str, ...] = ()
    """Ids of the scans that were merged into this one."""


class ScanStore:
    """The recorded scans. Paths of folders are stored relative to the data folder.

    If the row of a scan cannot be written to the disk, the scan is listed from memory until it can;
    its recording is saved in any case, and listed after the next start.
    """

    def __init__(self, database: Database, folder: Path) -> None:
        self._database = database
        self._folder = folder
        self._lock = threading.Lock()
        self._waiting: dict[str, ScanRecord] = {}

    def add(self, scan: ScanRecord) -> None:
        """Lists a scan; raises ``OperationError`` only if the disk is not the cause."""
        try:
            self._insert(scan)
        except OperationError as error:
            if error.code != NOT_SAVED:
                raise
            log.warning("scan %s is not listed yet: %s", scan.id, error.why)
            with self._lock:
                self._waiting[scan.id] = scan

    def add_waiting(self) -> None:
        """Lists scans that wait for the disk; raises ``OperationError`` if it is still full."""
        with self._lock:
            for scan in list(self._waiting.values()):
                self._insert(scan)
                del self._waiting[scan.id]

    def complete(
        self, scan_id: str, points: int, frames: int, seconds: float, left_out: MissingFrames
    ) -> None:
        """The content of a scan, found when its cloud was computed from its recording."""
        with self._database.transaction() as connection:
            connection.execute(
                "UPDATE scan SET points = ?, frames = ?, seconds = ?, frames_left_out = ?,"
                " frames_with_line = ? WHERE id = ?",
                (points, frames, seconds, left_out.frames, left_out.of, scan_id),
            )

    def _insert(self, scan: ScanRecord) -> None:
        with self._database.transaction() as connection:
            connection.execute(
                "INSERT INTO scan (id, name, folder, started_at, points, frames, seconds,"
                " calibration_id, interrupted, recording_bytes, name_message, interrupted_message,"
                " suspended_s, frames_left_out, frames_with_line, part, frames_too_fast,"
                " frames_lost, sources)"
                " VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
                (
                    scan.id,
                    str(scan.name),
                    scan.folder.relative_to(self._folder).as_posix(),
                    scan.started_at,
                    scan.points,
                    scan.frames,
                    scan.seconds,
                    scan.calibration_id,
                    str(scan.interrupted),
                    scan.recording_bytes,
                    encode_data(scan.name),
                    encode_data(scan.interrupted),
                    scan.suspended_s,
                    scan.left_out.frames,
                    scan.left_out.of,
                    scan.part.model_dump_json(),
                    scan.frames_too_fast,
                    scan.frames_lost,
                    json.dumps(scan.sources),
                ),
            )

    def rename(self, scan_id: str, name: str) -> None:
        """Renames a scan."""
        with self._database.transaction() as connection:
            connection.execute(
                "UPDATE scan SET name = ?, name_message = NULL WHERE id = ?", (name, scan_id)
            )

    def set_part(self, scan_id: str, part: PartNames) -> None:
        """Names the part of a scan."""
        with self._database.transaction() as connection:
            connection.execute(
                "UPDATE scan SET part = ? WHERE id = ?", (part.model_dump_json(), scan_id)
            )

    def note_merged(self, scan: ScanRecord) -> None:
        """A merged cloud was made again, of more scans."""
        with self._database.transaction() as connection:
            connection.execute(
                "UPDATE scan SET points = ?, frames = ?, seconds = ?, frames_left_out = ?,"
                " frames_with_line = ?, frames_too_fast = ?, frames_lost = ?, sources = ?"
                " WHERE id = ?",
                (
                    *(scan.points, scan.frames, scan.seconds),
                    *(scan.left_out.frames, scan.left_out.of),
                    *(scan.frames_too_fast, scan.frames_lost),
                    *(json.dumps(scan.sources), scan.id),
                ),
            )

    def delete(self, scan_id: str) -> None:
        """Removes a scan from the list; the caller removes its folder."""
        with self._lock:
            self._waiting.pop(scan_id, None)
        with self._database.transaction() as connection:
            connection.execute("DELETE FROM scan WHERE id = ?", (scan_id,))

    def get(self, scan_id: str) -> ScanRecord | None:
        with self._lock:
            if scan_id in self._waiting:
                return self._waiting[scan_id]
        found = self._read("WHERE id = ?", scan_id)
        return found[0] if found else None

    def newest(self) -> ScanRecord | None:
        """The most recently started scan in the list."""
        found = self._read("ORDER BY started_at DESC, rowid DESC LIMIT 1")
        return found[0] if found else None

    def all(self) -> list[ScanRecord]:
        """Every scan, newest first."""
        with self._lock:
            waiting = list(self._waiting.values())
        return waiting[::-1] + self._read("ORDER BY started_at DESC, rowid DESC")

    def list_interrupted(self) -> list[ScanRecord]:
        """The scans that ended before their operators ended them."""
        return self._read("WHERE interrupted != ''")

    def _read(self, clause: str, *values: str) -> list[ScanRecord]:
        return [
            ScanRecord(
                row["id"],
                decode_text(row["name"], row["name_message"]),
                self._folder / row["folder"],
                row["started_at"],
                row["points"],
                row["frames"],
                row["seconds"],
                row["calibration_id"],
                decode_text(row["interrupted"], row["interrupted_message"]),
                row["recording_bytes"],
                row["suspended_s"],
                MissingFrames(row["frames_left_out"], row["frames_with_line"]),
                PartNames.model_validate_json(row["part"]),
                row["frames_too_fast"],
                row["frames_lost"],
                tuple(json.loads(row["sources"])),
            )
            for row in self._database.read(f"SELECT * FROM scan {clause}", *values)
        ]
