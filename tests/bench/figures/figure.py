"""A figure: where it is printed, what measures it, and when a measured value is worse."""

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from enum import Enum
from typing import Any

from tests.bench.figures.printed import Printed, PrintedNumber, UnreadableError

Read = Callable[[Any], float]


class Better(Enum):
    """Which values are better than a printed one."""

    SMALLER = "smaller"
    LARGER = "larger"
    NEAR_ONE = "nearer to 1"
    AS_PRINTED = "as printed"


class Verdict(Enum):
    """What a measured value says of the printed one."""

    HOLDS = "holds"
    BETTER = "better"
    WORSE = "worse"
    UNREADABLE = "unreadable"
    NOT_MEASURED = "not measured"


@dataclass(frozen=True)
class Tolerance:
    """By how much a value may be worse than a printed one, and why; its rounding comes on top."""

    of: Callable[[float], float] = field(repr=False)
    reason: str


@dataclass(frozen=True)
class Command:
    """A command as docs/accuracy.md prints it; ``folders`` replaces words, by a name from
    ``shared`` on."""

    documented: str
    folders: tuple[tuple[str, str], ...] = ()
    more: tuple[str, ...] = ()
    """Words that the document states in a sentence."""

    def __str__(self) -> str:
        words = [dict(self.folders).get(word, word) for word in self.documented.split()]
        return " ".join((*words, *self.more))


@dataclass(frozen=True)
class Figure:
    """One figure; all ``places`` print the same number."""

    name: str
    command: Command
    places: tuple[Printed, ...]
    read: Read = field(repr=False)
    better: Better
    tolerance: Tolerance

    def allowed(self, printed: PrintedNumber) -> float:
        """By how much a value may be worse, with the rounding of what is printed."""
        return self.tolerance.of(printed.value) + printed.rounding * (1 + 1e-9)


@dataclass(frozen=True)
class Outcome:
    """A figure beside what was measured."""

    figure: Figure
    verdict: Verdict
    printed: PrintedNumber | None = None
    measured: float | None = None
    why: str = ""


def read_printed(figure: Figure) -> PrintedNumber:
    """The number that all places of a figure print: the most exact one, if none contradicts it."""
    numbers = [place.number() for place in figure.places]
    best = min(numbers, key=lambda number: number.rounding)
    for place, number in zip(figure.places, numbers, strict=True):
        if not number.agrees_with(best):
            raise UnreadableError(f"{place} prints {number.value:g}, another page {best.value:g}")
    return best


def judge(figure: Figure, printed: PrintedNumber, measured: float) -> Verdict:
    """Worse or better by more than the tolerance."""
    worse_by = {
        Better.SMALLER: measured - printed.value,
        Better.LARGER: printed.value - measured,
        Better.NEAR_ONE: abs(measured - 1) - abs(printed.value - 1),
        Better.AS_PRINTED: abs(measured - printed.value),
    }[figure.better]
    allowed = figure.allowed(printed)
    if worse_by > allowed:
        return Verdict.WORSE
    return Verdict.BETTER if worse_by < -allowed else Verdict.HOLDS


def compare(figure: Figure, output: Any) -> Outcome:
    """A figure against the output of its command, as parsed from JSON."""
    printed = None
    try:
        printed = read_printed(figure)
        measured = float(figure.read(output))
    except UnreadableError as error:
        return Outcome(figure, Verdict.UNREADABLE, why=str(error))
    except (ArithmeticError, AttributeError, LookupError, TypeError, ValueError) as error:
        why = f"the command's output: {type(error).__name__}: {error}"
        return Outcome(figure, Verdict.UNREADABLE, printed, why=why)
    if not math.isfinite(measured):
        return Outcome(figure, Verdict.UNREADABLE, printed, measured, "the command measured none")
    return Outcome(figure, judge(figure, printed, measured), printed, measured)
