"""The lists of verifications, performance tests and inspections: a row of each session, with
folder, time and figures."""

import json
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar, Generic, Literal, Protocol, TypeVar

from pydantic import TypeAdapter

from crenel.gauges.plan.document import Kind
from crenel.messages.message import Text, text_to_json
from crenel.messages.stored import SUFFIX, restore_texts
from crenel.store.database import Database
from crenel.store.journal import Check, JournalRow, accept_any, append_row, close_session
from crenel.timestamps import parse_moment

if TYPE_CHECKING:
    from _typeshed import DataclassInstance

    class SummaryFigures(DataclassInstance, Protocol):
        """Data of a record in lists, available without opening its files."""

        @property
        def text(self) -> Text: ...


class ListedRecord(Protocol):
    """What the lists need to know of a record."""

    @property
    def id(self) -> str: ...


Record = TypeVar("Record", bound=ListedRecord)


class SessionRecordStore(Generic[Record]):
    """The records of one kind of session. Paths of folders are stored relative to ``folder``.

    A record's id is its session's. A subclass names its table and the column of the time.
    """

    TABLE: ClassVar[str]
    ENDED_AT: ClassVar[str]

    def __init__(self, database: Database, folder: Path) -> None:
        self._database = database
        self._folder = folder
        self._columns = f"id, calibration_id, folder, {self.ENDED_AT}, figures"

    def get(self, record_id: str) -> Record | None:
        return self._first("WHERE id = ?", record_id)

    def all(self) -> list[Record]:
        """All records that can be read, newest first."""
        return self._read(f"ORDER BY {self.ENDED_AT} DESC, rowid DESC")

    def unreadable(self) -> list[str]:
        """Ids of records whose row cannot be read."""
        readable = {record.id for record in self.all()}
        return [
            row["id"]
            for row in self._database.read(f"SELECT id FROM {self.TABLE} ORDER BY rowid")
            if row["id"] not in readable
        ]

    def _first(self, clause: str, *values: str) -> Record | None:
        found = self._read(clause, *values)
        return found[0] if found else None

    def _read(self, clause: str, *values: str) -> list[Record]:
        found = []
        query = f"SELECT {self._columns} FROM {self.TABLE} {clause}"
        for row in self._database.read(query, *values):
            with suppress(ValueError, RecursionError):
                parse_moment(row[self.ENDED_AT])
                figures = restore_texts(json.loads(row["figures"]))
                folder = self._folder / row["folder"]
                found.append(
                    self._build(
                        row["id"], row["calibration_id"] or "", folder, row[self.ENDED_AT], figures
                    )
                )
        return found

    def _build(
        self, record_id: str, calibration_id: str, folder: Path, ended_at: str, figures: Any
    ) -> Record:
        """A record; raises ``ValueError`` for figures that cannot be read."""
        raise NotImplementedError

    def _close(
        self,
        session_id: str,
        kind: str,
        payload: Mapping[str, object],
        calibration_id: str,
        folder: Path,
        figures: "SummaryFigures",
        key: str | None,
        check: Check,
    ) -> JournalRow:
        """Lists a record and closes its session with the session's last row, in one transaction."""
        with self._database.transaction() as connection:
            row = append_row(connection, session_id, kind, payload, key, check)
            stored = folder.relative_to(self._folder).as_posix()
            connection.execute(
                f"INSERT INTO {self.TABLE} ({self._columns}) VALUES (?, ?, ?, ?, ?)",
                (session_id, calibration_id or None, stored, row.at, _encode(figures)),
            )
            close_session(connection, session_id)
        return row


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


VERIFICATION_FIGURES = TypeAdapter(VerificationFigures)


class VerificationStore(SessionRecordStore[VerificationRecord]):
    """The verifications that operators accepted."""

    TABLE, ENDED_AT = "verification", "accepted_at"

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

        ``figures`` has the fields of ``VerificationFigures``.
        """
        listed = VerificationFigures(**figures)
        payload = {"result": listed.result}
        return self._close(
            session_id, "accepted", payload, calibration_id, folder, listed, key, check
        )

    def newest_for(self, calibration_id: str) -> VerificationRecord | None:
        """The last verification of a calibration."""
        return self._first(
            "WHERE calibration_id = ? ORDER BY accepted_at DESC, rowid DESC", calibration_id
        )

    def newest(self) -> VerificationRecord | None:
        """The last of all verifications."""
        return self._first("ORDER BY accepted_at DESC, rowid DESC")

    def _build(
        self, record_id: str, calibration_id: str, folder: Path, ended_at: str, figures: Any
    ) -> VerificationRecord:
        listed = VERIFICATION_FIGURES.validate_python(figures)
        return VerificationRecord(record_id, calibration_id, folder, ended_at, listed)


@dataclass(frozen=True, slots=True)
class PerformanceSummaryFigures:
    """Data of a test in lists, available without opening its files."""

    kind: Kind
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
    """Empty for a test by touch that was done without one."""
    folder: Path
    ended_at: str
    figures: PerformanceSummaryFigures


PERFORMANCE_FIGURES = TypeAdapter(PerformanceSummaryFigures)


class PerformanceStore(SessionRecordStore[PerformanceRecord]):
    """The tests in which a point was taken."""

    TABLE, ENDED_AT = "performance", "ended_at"

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
        return self._close(session_id, kind, payload, calibration_id, folder, listed, key, check)

    def newest_judged(self) -> PerformanceRecord | None:
        """The last test that was not cancelled."""
        return self._first(
            "WHERE CASE WHEN json_valid(figures) THEN json_extract(figures, '$.result') END"
            " <> 'cancelled'"
            " ORDER BY ended_at DESC, rowid DESC"
        )

    def _build(
        self, record_id: str, calibration_id: str, folder: Path, ended_at: str, figures: Any
    ) -> PerformanceRecord:
        listed = PERFORMANCE_FIGURES.validate_python(figures)
        return PerformanceRecord(record_id, calibration_id, folder, ended_at, listed)


@dataclass(frozen=True, slots=True)
class InspectionFigures:
    """Data of an inspection in lists, available without opening its files."""

    result: Literal["pass", "fail", "undecided", "none"]
    text: Text
    """The verdict in one sentence."""
    program: str
    part: str
    serial_number: str
    passed: int
    failed: int
    undecided: int
    """Dimensions by their decision."""
    operator: str


@dataclass(frozen=True, slots=True)
class InspectionRecord:
    """One finished inspection and its folder."""

    id: str
    calibration_id: str
    folder: Path
    ended_at: str
    figures: InspectionFigures


INSPECTION_FIGURES = TypeAdapter(InspectionFigures)


class InspectionStore(SessionRecordStore[InspectionRecord]):
    """The finished inspections of parts."""

    TABLE, ENDED_AT = "inspection", "ended_at"

    def close(
        self,
        session_id: str,
        payload: Mapping[str, object],
        calibration_id: str,
        folder: Path,
        figures: Mapping[str, Any],
        key: str | None,
        check: Check = accept_any,
    ) -> JournalRow:
        """Lists a session's inspection and closes the session with its last row, in one
        transaction.

        ``figures`` has the fields of ``InspectionFigures``.
        """
        listed = InspectionFigures(**figures)
        return self._close(
            session_id, "accepted", payload, calibration_id, folder, listed, key, check
        )

    def _build(
        self, record_id: str, calibration_id: str, folder: Path, ended_at: str, figures: Any
    ) -> InspectionRecord:
        listed = INSPECTION_FIGURES.validate_python(figures)
        return InspectionRecord(record_id, calibration_id, folder, ended_at, listed)


def _encode(figures: "SummaryFigures") -> str:
    """The figures as JSON: English text with its data next to it."""
    fields = {**asdict(figures), "text": str(figures.text)}
    if not isinstance(figures.text, str):
        fields[f"text{SUFFIX}"] = text_to_json(figures.text)
    return json.dumps(fields, allow_nan=False)
