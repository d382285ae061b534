"""Accepted calibrations; one of each sensor is active."""

import json
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import asdict, dataclass
from pathlib import Path
from sqlite3 import Row
from typing import Annotated, Any, Literal

from pydantic import Field, TypeAdapter

from crenel.store.database import Database
from crenel.store.journal import Check, JournalRow, accept_any, append_row, close_session
from crenel.timestamps import parse_moment

MOST_UM = 1e9
"""One kilometre: larger than for any calibration."""
COLUMNS = "id, session_id, name, file, accepted_at, figures, active, sensor"


@dataclass(frozen=True, slots=True)
class CalibrationFigures:
    """Data of a calibration in lists, available without opening its file."""

    total_um: Annotated[float, Field(ge=0, le=MOST_UM, allow_inf_nan=False)]
    """Standard uncertainty of a scanned point, k = 1."""
    verdict: Literal["good", "attention", "bad", "neutral"]
    arm_serial: str
    object_serial: str
    sensor_serial: str


@dataclass(frozen=True, slots=True)
class CalibrationRecord:
    """One accepted calibration and the location of its file."""

    id: str
    session_id: str
    name: str
    file: Path
    accepted_at: str
    figures: CalibrationFigures
    active: bool
    sensor: str = ""
    """Name of the sensor in the station; empty of the only one."""


FIGURES = TypeAdapter(CalibrationFigures)


@dataclass(frozen=True, slots=True)
class UnreadableCalibration:
    """A calibration whose figures cannot be read."""

    id: str
    name: str
    active: bool
    sensor: str = ""


class CalibrationStore:
    """The calibrations that operators accepted. Paths of files are stored relative to
    ``folder``."""

    def __init__(self, database: Database, folder: Path) -> None:
        self._database = database
        self._folder = folder

    def accept(
        self,
        session_id: str,
        name: str,
        file: Path,
        figures: Mapping[str, Any],
        key: str | None,
        check: Check = accept_any,
        sensor: str = "",
        accepted_at: str | None = None,
    ) -> JournalRow:
        """Puts a session's calibration to use, and closes the session.

        The journal row ``accepted``, the record and the change of the active
        calibration are one transaction. The calibration's id is its session's.
        ``figures`` has the fields of ``CalibrationFigures``; ``sensor`` is the name of the sensor,
        empty of the only one. ``accepted_at`` if it was accepted elsewhere before.
        """
        kept = CalibrationFigures(**figures)
        with self._database.transaction() as connection:
            row = append_row(connection, session_id, "accepted", {"name": name}, key, check)
            connection.execute(
                "UPDATE calibration SET active = 0 WHERE active = 1 AND sensor = ?", (sensor,)
            )
            connection.execute(
                f"INSERT INTO calibration ({COLUMNS}) VALUES (?, ?, ?, ?, ?, ?, 1, ?)",
                (
                    session_id,
                    session_id,
                    name,
                    file.relative_to(self._folder).as_posix(),
                    accepted_at or row.at,
                    json.dumps(asdict(kept), allow_nan=False),
                    sensor,
                ),
            )
            close_session(connection, session_id)
        return row

    def active(self, sensor: str = "") -> CalibrationRecord | None:
        """The calibration of a sensor in use; None before the first was accepted, or if its row
        cannot be read."""
        return self._first_record("WHERE active = 1 AND sensor = ?", sensor)

    def get(self, calibration_id: str) -> CalibrationRecord | None:
        return self._first_record("WHERE id = ?", calibration_id)

    def newest(self) -> CalibrationRecord | None:
        """The last accepted calibration, in use or not."""
        return self._first_record("ORDER BY accepted_at DESC, rowid DESC")

    def all(self) -> list[CalibrationRecord]:
        """All accepted calibrations that can be read, newest first."""
        return self._read("ORDER BY accepted_at DESC, rowid DESC")

    def _first_record(self, clause: str, *values: str) -> CalibrationRecord | None:
        found = self._read(clause, *values)
        return found[0] if found else None

    def _read(self, clause: str, *values: str) -> list[CalibrationRecord]:
        found = []
        for row in self._database.read(f"SELECT {COLUMNS} FROM calibration {clause}", *values):
            with suppress(ValueError):
                found.append(self._record(row))
        return found

    def _record(self, row: Row) -> CalibrationRecord:
        """Raises ``ValueError`` for figures or times that cannot be read."""
        parse_moment(row["accepted_at"])
        return CalibrationRecord(
            row["id"],
            row["session_id"],
            row["name"],
            self._folder / row["file"],
            row["accepted_at"],
            FIGURES.validate_json(row["figures"]),
            bool(row["active"]),
            row["sensor"],
        )

    def unreadable(self) -> list[UnreadableCalibration]:
        """Calibrations whose row cannot be read."""
        kept = {record.id for record in self.all()}
        return [
            UnreadableCalibration(row["id"], row["name"], bool(row["active"]), row["sensor"])
            for row in self._database.read("SELECT id, name, active, sensor FROM calibration")
            if row["id"] not in kept
        ]
