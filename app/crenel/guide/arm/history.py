"""The checks of earlier arm sessions, and what the next session takes over from them."""

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass
from typing import Protocol, TypeVar

from pydantic import TypeAdapter, ValidationError

from crenel.guide.arm.state import Artefact, Purpose
from crenel.guide.arm.tip import LIMIT_UM
from crenel.guide.arm.view import ArmCheckSummary, IdentificationSummary, TipCheckSummary
from crenel.guide.common.journal import Journal, JournalEntry
from crenel.timestamps import parse_moment

KIND = "arm"
CHECKED, TIP_CHECKED, SOLVED = "checked", "tip_checked", "solved"


class ArmJournal(Journal, Protocol):
    """A journal whose rows can be read over all sessions of a kind."""

    def history(self, session_kind: str, kind: str) -> Sequence[JournalEntry]: ...
    def latest(self, session_kind: str, kind: str) -> JournalEntry | None: ...


Summary = TypeVar("Summary")
CHECK = TypeAdapter(ArmCheckSummary)
TIP = TypeAdapter(TipCheckSummary)
IDENTIFICATION = TypeAdapter(IdentificationSummary)
SPHERE = TypeAdapter(Artefact)


@dataclass(frozen=True)
class ArmHistory:
    """All checks that were finished, and that can be read."""

    journal: ArmJournal

    def checks(self) -> list[ArmCheckSummary]:
        """The checks of the arm, newest first."""
        return self._all(CHECK, CHECKED)

    def tip_checks(self) -> list[TipCheckSummary]:
        """The checks of the tip, newest first."""
        return self._all(TIP, TIP_CHECKED)

    def identifications(self) -> list[IdentificationSummary]:
        """The identifications of the arm, newest first; of each session the last fit, which its
        folder holds."""
        last = {row.session_id: row for row in self.journal.history(KIND, SOLVED)}
        return _readable(IDENTIFICATION, sorted(last.values(), key=_when, reverse=True))

    def last_check(self) -> ArmCheckSummary | None:
        """The newest of the arm."""
        return self._last(CHECK, CHECKED)

    def last_tip_check(self) -> TipCheckSummary | None:
        """The newest of the tip."""
        return self._last(TIP, TIP_CHECKED)

    def last_limit_um(self, purpose: Purpose) -> float | None:
        """What the last one for a purpose was judged by; for the first, what is usual."""
        last = self.last_tip_check() if purpose == "tip" else self.last_check()
        if last is None:
            return LIMIT_UM if purpose == "tip" else None
        return last.limit_um

    def last_sphere(self) -> Artefact | None:
        """What the tip was checked on last."""
        row = self.journal.latest(KIND, TIP_CHECKED)
        if row is None or row.payload.get("sphere") is None:
            return None
        try:
            return SPHERE.validate_python(row.payload["sphere"])
        except ValidationError:
            return None

    def _all(self, kind_of: TypeAdapter[Summary], kind: str) -> list[Summary]:
        return _readable(kind_of, self.journal.history(KIND, kind)[::-1])

    def _last(self, kind_of: TypeAdapter[Summary], kind: str) -> Summary | None:
        row = self.journal.latest(KIND, kind)
        found = [] if row is None else _readable(kind_of, [row]) or self._all(kind_of, kind)
        return found[0] if found else None


def _readable(kind_of: TypeAdapter[Summary], rows: Sequence[JournalEntry]) -> list[Summary]:
    """The summaries in rows; rows that cannot be read are left out."""
    found = []
    for row in rows:
        with suppress(ValueError):  # of which pydantic's is one
            parse_moment(row.at)
            fields = {
                "arm_name": "",
                "arm_serial": "",
                **row.payload,
                "id": row.session_id,
                "at": row.at,
            }
            found.append(kind_of.validate_python(fields))
    return found


def _when(row: JournalEntry) -> str:
    return row.at
