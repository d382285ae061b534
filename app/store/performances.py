"""Performance tests, finished and cancelled."""

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

COLUMNS = "id, calibration_id, folder, ended_at, figures"


@dataclass(frozen=True, slots=True)
class PerformanceSummaryFigures:
    """Data of a test in lists, available without opening its files."""

    kind: Literal["sphere", "lengths", "plane", "contact"]
    result: Literal["pass", "fail", "uncertain", "cancelled"]
    text: Text
    """The verdict in one sentence, or why the test was cancelled."""
    artefact: str
    operator: str


@dataclass(frozen=True, slots=True)
class PerformanceRecord:
    """One test and the folder of its files."""

    id: str
    calibration_id: str
    folder: Path
    ended_at: str
    figures: PerformanceSummaryFigures


FIGURES = TypeAdapter(PerformanceSummaryFigures)


class PerformanceStore:
    """The tests in which a point was taken. Paths of folders are stored relative to ``folder``."""

    def __init__(self, database: Database, folder: Path) -> None:
        self._database = database
        self._folder = folder

    def close(
        self,
        session_id: str,
        kind: str,
        payload: Mapping[str, object],
        calibration_id: str,
        folder: Path,
        figures: Mapping[str, Any],
        key: str | None,
        check: Check = accept_any,
    ) -> JournalRow:
        """Lists a session's test and closes the session with its last row, in one transaction.

        ``figures`` has the fields of ``PerformanceSummaryFigures``.
        """
        listed = PerformanceSummaryFigures(**figures)
        with self._database.transaction() as connection:
            row = append_row(connection, session_id, kind, payload, key, check)
            connection.execute(
                f"INSERT INTO performance ({COLUMNS}) VALUES (?, ?, ?, ?, ?)",
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

    def get(self, performance_id: str) -> PerformanceRecord | None:
        found = self._read("WHERE id = ?", performance_id)
        return found[0] if found else None

    def all(self) -> list[PerformanceRecord]:
        """All tests that can be read, newest first."""
        return self._read("ORDER BY ended_at DESC, rowid DESC")

    def _read(self, clause: str, *values: str) -> list[PerformanceRecord]:
        found = []
        for row in self._database.read(f"SELECT {COLUMNS} FROM performance {clause}", *values):
            with suppress(ValueError, RecursionError):
                found.append(self._record(row))
        return found

    def _record(self, row: Row) -> PerformanceRecord:
        """Raises ``ValueError`` for figures or times that cannot be read."""
        parse_moment(row["ended_at"])
        return PerformanceRecord(
            row["id"],
            row["calibration_id"],
            self._folder / row["folder"],
            row["ended_at"],
            FIGURES.validate_python(restore_texts(json.loads(row["figures"]))),
        )

    def unreadable(self) -> list[str]:
        """Ids of tests whose row cannot be read."""
        readable = {record.id for record in self.all()}
        return [
            row["id"]
            for row in self._database.read("SELECT id FROM performance ORDER BY rowid")
            if row["id"] not in readable
        ]


def _encode(figures: PerformanceSummaryFigures) -> str:
    """The figures as JSON: English text with its data next to it."""
    fields = {**asdict(figures), "text": str(figures.text)}
    if not isinstance(figures.text, str):
        fields[f"text{SUFFIX}"] = text_to_json(figures.text)
    return json.dumps(fields, allow_nan=False)
