"""The content of a report, independent of its form.

Its texts are data (``Text``); ``translation`` renders them as strings of one language.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Generic, Literal, TypeVar

from crenel.messages.message import Text, message
from crenel.report.figure import Figure

Quality = Literal["good", "attention", "bad", "neutral"]
T_co = TypeVar("T_co", bound=Text, covariant=True)
"""``Text``, or ``str`` after rendering."""


@dataclass(frozen=True)
class Verdict(Generic[T_co]):
    """The outcome in one word, and a sentence with the reason."""

    quality: Quality
    word: T_co
    text: T_co


@dataclass(frozen=True)
class Facts(Generic[T_co]):
    """Names and values, in two columns if there is space."""

    rows: Sequence[tuple[T_co, T_co]]


@dataclass(frozen=True)
class ReportTable(Generic[T_co]):
    """``widths`` are shares of the page; columns from ``numbers`` on are right-aligned."""

    columns: Sequence[T_co]
    rows: Sequence[Sequence[T_co]]
    widths: Sequence[float]
    numbers: int = 1
    small: bool = False


@dataclass(frozen=True)
class TextBlock(Generic[T_co]):
    text: T_co
    small: bool = False


@dataclass(frozen=True)
class ReportFinding(Generic[T_co]):
    """``remedy`` may be empty."""

    quality: Quality
    text: T_co
    remedy: T_co


@dataclass(frozen=True)
class Findings(Generic[T_co]):
    rows: Sequence[ReportFinding[T_co]]


@dataclass(frozen=True)
class Pictures(Generic[T_co]):
    """Figures in rows of ``across``, each with its caption."""

    figures: Sequence[tuple[Figure[T_co], T_co]]
    across: int = 1


@dataclass(frozen=True)
class Signatures(Generic[T_co]):
    """Lines for signatures."""

    lines: Sequence[T_co]


Block = (
    Facts[T_co]
    | ReportTable[T_co]
    | TextBlock[T_co]
    | Findings[T_co]
    | Pictures[T_co]
    | Signatures[T_co]
)


@dataclass(frozen=True)
class Section(Generic[T_co]):
    """``together``: its blocks stay on one page of paper."""

    title: T_co
    blocks: Sequence[Block[T_co]]
    together: bool = True

    @property
    def is_signed(self) -> bool:
        """Whether it has lines for signatures."""
        return any(isinstance(block, Signatures) for block in self.blocks)


def signatures(operator: str) -> Section[Text]:
    """The signature lines of every report, the first with the operator's name if known."""
    role = message("operator")
    operated = message("role-and-name", role=role, name=operator) if operator else role
    lines = (operated, message("approved"), message("date"))
    return Section(message("signatures"), [Signatures(lines)])


@dataclass(frozen=True)
class Report(Generic[T_co]):
    """One report; ``number`` is that of the session."""

    title: T_co
    number: str
    station: T_co
    date: T_co
    verdict: Verdict[T_co]
    sections: Sequence[Section[T_co]]
    notes: Sequence[T_co] = field(default_factory=tuple)
    """Notes of first importance, for example that the hardware was simulated."""
    language: str = "en"
    logo: bytes | None = None
    """A PNG or JPEG, above the title."""
