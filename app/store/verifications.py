"""Accepted verifications of calibrations."""

import json
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import asdict, dataclass
from pathlib import Path
from sqlite3 import Row
from typing import Any, Literal

from pydantic import TypeAdapter

from app.messages.message import Text, text_to_json
from app.messages.stored import SUFFIX, restore_texts
from app.store.database import Database
from app.store.journal import Check, JournalRow, accept_any, append_row, close_session
from app.timestamps import parse_moment

COLUMNS = "id, calibration_id, folder, accepted_at, figures"


@dataclass(frozen=True, slots=True)
class VerificationFigures:
    """Data of a verification in lists, available without opening its file."""

    result: Literal["pass", "fail", "uncertain"]
    text: Text
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


FIGURES = TypeAdapter(VerificationFigures)


class VerificationStore:
    """The verifications that operators accepted. Paths of folders are stored relative to
    ``folder``."""

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
        check: Check = accept_any,
    ) -> JournalRow:
        """Saves a session's verification and closes the session, in one transaction.

        The verification's id is its session's. ``figures`` has the fields of
        ``VerificationFigures``.
        """
        listed = VerificationFigures(**figures)
        with self._database.transaction() as connection:
            payload = {"result": listed.result}
            row = append_row(connection, session_id, "accepted", payload, key, check)
            connection.execute(
                f"INSERT INTO verification ({COLUMNS}) VALUES (?, ?, ?, ?, ?)",
                (
                    session_id,
                    calibration_id,
                    folder.relative_to(self._folder).as_posix(),
                    row.at,
                    _encode(listed),
                ),
            )
            close_session(connection, session_id)
        return row

    def get(self, verification_id: str) -> VerificationRecord | None:
        found = self._read("WHERE id = ?", verification_id)
        return found[0] if found else None

    def newest_for(self, calibration_id: str) -> VerificationRecord | None:
        """The last verification of a calibration."""
        found = self._read(
            "WHERE calibration_id = ? ORDER BY accepted_at DESC, rowid DESC",
            calibration_id,
        )
        return found[0] if found else None

    def newest(self) -> VerificationRecord | None:
        """The last of all verifications."""
        found = self._read("ORDER BY accepted_at DESC, rowid DESC")
        return found[0] if found else None

    def all(self) -> list[VerificationRecord]:
        """All accepted verifications that can be read, newest first."""
        return self._read("ORDER BY accepted_at DESC, rowid DESC")

    def _read(self, clause: str, *values: str) -> list[VerificationRecord]:
        found = []
        for row in self._database.read(f"SELECT {COLUMNS} FROM verification {clause}", *values):
            with suppress(ValueError, RecursionError):
                found.append(self._record(row))
        return found

    def _record(self, row: Row) -> VerificationRecord:
        """Raises ``ValueError`` for figures or times that cannot be read."""
        parse_moment(row["accepted_at"])
        return VerificationRecord(
            row["id"],
            row["calibration_id"],
            self._folder / row["folder"],
            row["accepted_at"],
            FIGURES.validate_python(restore_texts(json.loads(row["figures"]))),
        )

    def unreadable(self) -> list[str]:
        """Ids of verifications whose row cannot be read."""
        readable = {record.id for record in self.all()}
        return [
            row["id"]
            for row in self._database.read("SELECT id FROM verification ORDER BY rowid")
            if row["id"] not in readable
        ]


def _encode(figures: VerificationFigures) -> str:
    """The figures as JSON: English text with its data next to it."""
    fields = {**asdict(figures), "text": str(figures.text)}
    if not isinstance(figures.text, str):
        fields[f"text{SUFFIX}"] = text_to_json(figures.text)
    return json.dumps(fields, allow_nan=False)
