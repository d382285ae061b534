"""Finished scans."""

from dataclasses import dataclass
from pathlib import Path

from app.store.database import Database


@dataclass(frozen=True, slots=True)
class ScanRecord:
    """One finished scan and the folder of its recording and cloud."""

    id: str
    name: str
    folder: Path
    started_at: str
    points: int
    frames: int
    seconds: float
    calibration_id: str


class ScanStore:
    """The scans that were recorded. Folders are kept relative to the data folder."""

    def __init__(self, database: Database, folder: Path) -> None:
        self._database = database
        self._folder = folder

    def add(self, scan: ScanRecord) -> None:
        with self._database.writing() as connection:
            connection.execute(
                "INSERT INTO scan (id, name, folder, started_at, points, frames, seconds,"
                " calibration_id) VALUES (?, ?, ?, ?, ?, ?, ?, ?)",
                (
                    scan.id,
                    scan.name,
                    scan.folder.relative_to(self._folder).as_posix(),
                    scan.started_at,
                    scan.points,
                    scan.frames,
                    scan.seconds,
                    scan.calibration_id,
                ),
            )

    def rename(self, scan_id: str, name: str) -> None:
        """Gives a scan another name."""
        with self._database.writing() as connection:
            connection.execute("UPDATE scan SET name = ? WHERE id = ?", (name, scan_id))

    def delete(self, scan_id: str) -> None:
        """Takes a scan from the list; its folder is the caller's affair."""
        with self._database.writing() as connection:
            connection.execute("DELETE FROM scan WHERE id = ?", (scan_id,))

    def get(self, scan_id: str) -> ScanRecord | None:
        found = self._read("WHERE id = ?", scan_id)
        return found[0] if found else None

    def newest(self) -> ScanRecord | None:
        """The last that was begun."""
        found = self._read("ORDER BY started_at DESC, rowid DESC LIMIT 1")
        return found[0] if found else None

    def all(self) -> list[ScanRecord]:
        """Every scan, newest first."""
        return self._read("ORDER BY started_at DESC, rowid DESC")

    def _read(self, clause: str, *values: str) -> list[ScanRecord]:
        return [
            ScanRecord(
                row["id"],
                row["name"],
                self._folder / row["folder"],
                row["started_at"],
                row["points"],
                row["frames"],
                row["seconds"],
                row["calibration_id"],
            )
            for row in self._database.read(f"SELECT * FROM scan {clause}", *values)
        ]
