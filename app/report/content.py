"""What a report says, whatever it is printed on."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Literal

from app.report.figure import Figure

Quality = Literal["good", "attention", "bad", "neutral"]


@dataclass(frozen=True)
class Verdict:
    """The outcome in a word, and the sentence that says why."""

    quality: Quality
    word: str
    text: str


@dataclass(frozen=True)
class Facts:
    """Names and values, in two columns where there is room."""

    rows: Sequence[tuple[str, str]]


@dataclass(frozen=True)
class ReportTable:
    """``widths`` are shares of the page; columns from ``numbers`` on are set to the right."""

    columns: Sequence[str]
    rows: Sequence[Sequence[str]]
    widths: Sequence[float]
    numbers: int = 1
    small: bool = False


@dataclass(frozen=True)
class TextBlock:
    text: str
    small: bool = False


@dataclass(frozen=True)
class ReportFinding:
    quality: Quality
    text: str
    remedy: str = ""


@dataclass(frozen=True)
class Findings:
    rows: Sequence[ReportFinding]


@dataclass(frozen=True)
class Pictures:
    """Figures in rows of ``across``, each with what it shows."""

    figures: Sequence[tuple[Figure, str]]
    across: int = 1


@dataclass(frozen=True)
class Signatures:
    """Lines to be signed, each with the name where it is known."""

    lines: Sequence[tuple[str, str]]


Block = Facts | ReportTable | TextBlock | Findings | Pictures | Signatures


@dataclass(frozen=True)
class Section:
    """``together``: its blocks are kept on one sheet of paper."""

    title: str
    blocks: Sequence[Block]
    together: bool = True


def signatures(operator: str) -> Section:
    """The lines that every report is signed on."""
    lines = [("Operator", operator), ("Approved", ""), ("Date", "")]
    return Section("Signatures", [Signatures(lines)])


@dataclass(frozen=True)
class Report:
    """One report; ``number`` is the session's."""

    title: str
    number: str
    station: str
    date: str
    verdict: Verdict
    sections: Sequence[Section]
    notes: Sequence[str] = field(default_factory=tuple)
    """What must be known before anything else, such as that the hardware was simulated."""
    language: str = "en"
