"""The checks of earlier arm sessions, and what the next session takes over from them."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Protocol

from app.guide.arm.state import Artefact, Purpose
from app.guide.arm.tip import LIMIT_UM
from app.guide.arm.view import ArmCheckSummary, IdentificationSummary, TipCheckSummary
from app.guide.journal import Journal, Row

KIND = "arm"
CHECKED, TIP_CHECKED, SOLVED = "checked", "tip_checked", "solved"


class ArmJournal(Journal, Protocol):
    """A journal whose rows can be read over all sessions of a kind."""

    def history(self, session_kind: str, kind: str) -> Sequence[Row]: ...
    def latest(self, session_kind: str, kind: str) -> Row | None: ...


@dataclass(frozen=True)
class ArmPast:
    """All checks that were finished."""

    journal: ArmJournal

    def checks(self) -> list[ArmCheckSummary]:
        """Of the arm, newest first."""
        return [_summary(row) for row in reversed(self.journal.history(KIND, CHECKED))]

    def tip_checks(self) -> list[TipCheckSummary]:
        """Of the tip, newest first."""
        return [_tip_summary(row) for row in reversed(self.journal.history(KIND, TIP_CHECKED))]

    def identifications(self) -> list[IdentificationSummary]:
        """Of the arm, newest first; of each session the last fit, which its folder holds."""
        last = {row.session_id: row for row in self.journal.history(KIND, SOLVED)}
        return [_identification(row) for row in sorted(last.values(), key=_when, reverse=True)]

    def last_check(self) -> ArmCheckSummary | None:
        """The newest of the arm."""
        row = self.journal.latest(KIND, CHECKED)
        return None if row is None else _summary(row)

    def last_tip_check(self) -> TipCheckSummary | None:
        """The newest of the tip."""
        row = self.journal.latest(KIND, TIP_CHECKED)
        return None if row is None else _tip_summary(row)

    def last_limit_um(self, purpose: Purpose) -> float | None:
        """What the last one for a purpose was judged by; for the first, what is usual."""
        row = self.journal.latest(KIND, TIP_CHECKED if purpose == "tip" else CHECKED)
        if row is None:
            return LIMIT_UM if purpose == "tip" else None
        last = row.payload["limit_um"]
        return last if isinstance(last, float | int) else None

    def last_sphere(self) -> Artefact | None:
        """What the tip was checked on last."""
        row = self.journal.latest(KIND, TIP_CHECKED)
        if row is None or not isinstance(sphere := row.payload.get("sphere"), Mapping):
            return None
        return Artefact(**sphere)


def _when(row: Row) -> str:
    return row.at


def _identification(row: Row) -> IdentificationSummary:
    told = row.payload
    return IdentificationSummary(
        id=row.session_id,
        at=row.at,
        arm_name=str(told.get("arm_name", "")),
        arm_serial=str(told.get("arm_serial", "")),
        volume_before_um=float(told["volume_before_um"]),  # type: ignore[arg-type]  # as works.fit
        volume_after_um=float(told["volume_after_um"]),  # type: ignore[arg-type]  # wrote them
        size_known=bool(told["size_known"]),
    )


def _tip_summary(row: Row) -> TipCheckSummary:
    payload = {k: v for k, v in row.payload.items() if k not in ("sphere", "cause")}
    return TipCheckSummary(
        id=row.session_id,
        at=row.at,
        **payload,  # type: ignore[arg-type]  # as checking.check_the_tip wrote them
    )


def _summary(row: Row) -> ArmCheckSummary:
    return ArmCheckSummary(
        id=row.session_id,
        at=row.at,
        **{  # type: ignore[arg-type]  # as checking.check_the_arm wrote them
            name: tuple(value) if isinstance(value, list) else value
            for name, value in row.payload.items()
            if name not in ("centre_mm", "encoders_two_sigma_um")
        },
    )
