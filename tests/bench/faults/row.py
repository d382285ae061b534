"""What came of one kind of fault."""

import math
from dataclasses import dataclass, field


@dataclass
class FaultRow:
    """One kind of fault: how often it was tried, survived, and lost what it must not."""

    kind: str
    tries: int = 0
    survived: int = 0
    lost: int = 0
    stop_s: float = math.nan
    """The longest time that Stop took under it; NaN where it was not pressed."""
    notes: list[str] = field(default_factory=list)
    """A measured figure, and what did not go as it must."""

    def note_stop(self, seconds: float) -> None:
        self.stop_s = max(seconds, 0.0 if math.isnan(self.stop_s) else self.stop_s)

    def count_try(self, survived: bool, lost: bool = False, note: str = "") -> None:
        """Counts one try."""
        self.tries += 1
        self.survived += survived
        self.lost += lost
        if note:
            self.notes.append(note)


COLUMNS = ("fault", "tries", "survived", "lost", "Stop at most", "")


def table(rows: list[FaultRow]) -> list[tuple[str, ...]]:
    return [
        (
            row.kind,
            str(row.tries),
            str(row.survived),
            str(row.lost),
            "" if math.isnan(row.stop_s) else f"{row.stop_s:.2f} s",
            "; ".join(row.notes),
        )
        for row in rows
    ]
