"""The journal of a guided session: where it is kept, and what its folds and rows share."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import reduce
from pathlib import Path
from typing import Any, Protocol, TypeVar

from crenel.errors import OperationError, reason_sentence, sentence
from crenel.findings import Finding, Quality
from crenel.messages.message import Text, text_from_json, text_to_json

State = TypeVar("State")
Point = TypeVar("Point", bound=Any)  # a dataclass with ``index`` and ``voided``
Undone = tuple[int, ...]
"""Indices of what was taken back since the last one was taken, the last of them last."""
FORMER_NOTES = ("hand_started", "hand_stopped")
SIMULATION_NOTES = ("simulation_started", "simulation_stopped", *FORMER_NOTES)
"""Rows that record when the simulated operator ran, and change nothing; journals of earlier
versions have the former ones."""


class JournalEntry(Protocol):
    """One thing that happened; rows are only ever appended."""

    @property
    def number(self) -> int: ...
    @property
    def session_id(self) -> str: ...
    @property
    def at(self) -> str: ...
    @property
    def kind(self) -> str: ...
    @property
    def payload(self) -> Mapping[str, object]: ...


Check = Callable[[JournalEntry], None]
"""Is given a row before it is committed; what it raises undoes the row."""


class JournalSession(Protocol):
    """One guided session, open until ``ended_at`` is set."""

    @property
    def id(self) -> str: ...
    @property
    def started_at(self) -> str: ...
    @property
    def ended_at(self) -> str | None: ...


class Journal(Protocol):
    """Where the rows are kept; every call returns once the disk has it."""

    def begin_session(self, session_id: str, kind: str) -> JournalSession: ...
    def end_session(self, session_id: str) -> None: ...
    def latest_session(self, kind: str) -> JournalSession | None: ...
    def append(
        self,
        session_id: str,
        kind: str,
        payload: Mapping[str, object],
        key: str | None,
        check: Check,
    ) -> JournalEntry: ...
    def knows_key(self, key: str) -> bool: ...
    def rows(self, session_id: str) -> Sequence[JournalEntry]: ...
    def last_number(self) -> int: ...


def fold(
    rows: Sequence[JournalEntry], begin: State, step: Callable[[State, JournalEntry], State]
) -> State:
    """The state that a session's rows lead to."""
    return reduce(step, rows, begin)


def take_back(
    taken: Iterable[Point], undone: Undone, index: int
) -> tuple[tuple[Point, ...], Undone]:
    """What was taken, without the one of an index; and what can be put back now."""
    return _mark(taken, index, voided=True), (*undone, index)


def reading_of(payload: Mapping[str, Any]) -> tuple[float, ...]:
    """The arm's reading of a row; rows of earlier versions have angles, named by their unit."""
    return tuple(payload["reading"] if "reading" in payload else payload["q_rad"])


def put_back(
    taken: Iterable[Point], undone: Undone, index: int
) -> tuple[tuple[Point, ...], Undone]:
    """The inverse."""
    return _mark(taken, index, voided=False), tuple(i for i in undone if i != index)


def _mark(taken: Iterable[Point], index: int, voided: bool) -> tuple[Point, ...]:
    return tuple(replace(one, voided=voided) if one.index == index else one for one in taken)


class StoredCalibration(Protocol):
    """An accepted calibration and its file."""

    @property
    def id(self) -> str: ...
    @property
    def name(self) -> str: ...
    @property
    def file(self) -> Path: ...
    @property
    def accepted_at(self) -> str: ...


class Calibrations(Protocol):
    """Where accepted calibrations are kept; one of each sensor is in use.

    ``sensor`` is the sensor's name, empty of the only one.
    """

    def active(self, sensor: str = "") -> StoredCalibration | None: ...
    def accept(
        self,
        session_id: str,
        name: str,
        file: Path,
        figures: Mapping[str, object],
        key: str | None,
        check: Check,
        sensor: str = "",
    ) -> JournalEntry: ...


@dataclass(frozen=True)
class RecordedError:
    """An error as a journal row has it: its code, and its texts as data."""

    code: str
    what: Text
    why: Text
    remedy: Text

    @property
    def reason(self) -> Text:
        """What happened and why, as a sentence."""
        return reason_sentence(self.what, self.why)

    def finding(self, quality: Quality, remedy: Text = "") -> Finding:
        """The error as it is shown; ``remedy`` is used where it has none of its own."""
        return Finding(quality, self.reason, sentence(self.remedy or remedy))


def error_payload(error: OperationError) -> dict[str, object]:
    """The fields of a row."""
    return {
        "code": error.code,
        "what": text_to_json(error.what),
        "why": text_to_json(error.why),
        "remedy": text_to_json(error.remedy),
    }


def error_from_payload(payload: Mapping[str, Any]) -> RecordedError:
    """From the fields of a row; rows of earlier versions have English sentences."""
    return RecordedError(
        str(payload["code"]),
        text_from_json(payload["what"]),
        text_from_json(payload["why"]),
        text_from_json(payload["remedy"]),
    )
