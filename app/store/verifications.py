"""Accepted verifications of calibrations."""

import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any, Literal

from app.files.moments import utc_now
from app.store.database import Database
from app.store.journal import JournalRow, append_row

COLUMNS = "id, calibration_id, folder, accepted_at, figures"


@dataclass(frozen=True, slots=True)
class VerificationFigures:
    """What is listed of a verification without opening its file."""

    result: Literal["pass", "fail", "uncertain"]
    text: str
    """The verdict in one sentence."""
    shape: Literal["plane", "sphere"]
    gauge: str
    clouds: int
    touched: bool
    operator: str


@dataclass(frozen=True, slots=True)
class VerificationRecord:
    """One accepted verification and the folder of its files."""

    id: str
    calibration_id: str
    folder: Path
    accepted_at: str
    figures: VerificationFigures


class VerificationStore:
    """The verifications that an operator accepted. Folders are kept relative to ``folder``."""

    def __init__(self, database: Database, folder: Path) -> None:
        self._database = database
        self._folder = folder

    def accept(
        self,
        session_id: str,
        calibration_id: str,
        folder: Path,
        figures: Mapping[str, Any],
        key: str | None,
    ) -> JournalRow:
        """Keeps a session's verification and closes the session, in one transaction.

        The verification's id is its session's. ``figures`` has the fields of
        ``VerificationFigures``.
        """
        kept = VerificationFigures(**figures)
        with self._database.writing() as connection:
            row = append_row(connection, session_id, "accepted", {"result": kept.result}, key)
            connection.execute(
                f"INSERT INTO verification ({COLUMNS}) VALUES (?, ?, ?, ?, ?)",
                (
                    session_id,
                    calibration_id,
                    folder.relative_to(self._folder).as_posix(),
                    row.at,
                    json.dumps(asdict(kept), allow_nan=False),
                ),
            )
            connection.execute(
                "UPDATE session SET ended_at = ? WHERE id = ?", (utc_now(), session_id)
            )
        return row

    def get(self, verification_id: str) -> VerificationRecord | None:
        found = self._read("WHERE id = ?", verification_id)
        return found[0] if found else None

    def newest_of(self, calibration_id: str) -> VerificationRecord | None:
        """The last of a calibration's verifications."""
        found = self._read(
            "WHERE calibration_id = ? ORDER BY accepted_at DESC, rowid DESC LIMIT 1",
            calibration_id,
        )
        return found[0] if found else None

    def newest(self) -> VerificationRecord | None:
        """The last of all."""
        found = self._read("ORDER BY accepted_at DESC, rowid DESC LIMIT 1")
        return found[0] if found else None

    def all(self) -> list[VerificationRecord]:
        """Every accepted verification, newest first."""
        return self._read("ORDER BY accepted_at DESC, rowid DESC")

    def _read(self, clause: str, *values: str) -> list[VerificationRecord]:
        return [
            VerificationRecord(
                row["id"],
                row["calibration_id"],
                self._folder / row["folder"],
                row["accepted_at"],
                VerificationFigures(**json.loads(row["figures"])),
            )
            for row in self._database.read(f"SELECT {COLUMNS} FROM verification {clause}", *values)
        ]
