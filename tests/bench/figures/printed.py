"""Numbers as the documents print them: a cell of a table, or a place in a sentence."""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Protocol

ROOT = Path(__file__).resolve().parents[3]
NUMBER = re.compile(r"(?<![\w.])[-−]?\d+(?:[ \u00a0\u202f]\d{3}(?!\d))*(?:\.\d+)?")
ACCURACY, README = "docs/accuracy.md", "README.md"
WELL = "What it does, and how well"
NONE = "none"
HEADING = re.compile(r"^#+ (.+)$")
Cells = tuple[str, ...]


class UnreadableError(Exception):
    """A figure is not where it should be: in a document, or in what a command prints."""


@dataclass(frozen=True)
class PrintedNumber:
    """A number and half a unit of its last digit: by so much it may have been rounded."""

    value: float
    rounding: float

    def agrees_with(self, other: "PrintedNumber") -> bool:
        apart = abs(self.value - other.value)
        return apart <= max(self.rounding, other.rounding) * (1 + 1e-9)


class Printed(Protocol):
    """Something that documents print."""

    def number(self) -> PrintedNumber: ...


@dataclass(frozen=True)
class Place:
    """Where a document prints a number.

    ``row`` holds the first cells of a table's row, each exactly or by its unique beginning; without
    it, the section's sentences are searched. ``pattern``, with one group, finds the number in the
    cell or the section; without it, ``which`` counts the numbers.
    """

    page: str
    section: str
    row: Cells = ()
    column: str | int = 1
    which: int = 0
    pattern: str = ""

    def __str__(self) -> str:
        return f"{self.page}, {', '.join((self.section, *self.row))}"

    def number(self) -> PrintedNumber:
        """The number as it is printed. UnreadableError: it is not there, or not once."""
        lines = section_lines(self.page, self.section)
        text = self._cell(lines) if self.row else " ".join(lines)
        if self.pattern:
            found = re.findall(self.pattern, text)
            if len(found) != 1:
                raise UnreadableError(f"{self}: {self.pattern!r} is there {len(found)} times")
            text = found[0]
        numbers = NUMBER.findall("0" if text == NONE else text)
        if self.which >= len(numbers):
            raise UnreadableError(f"{self}: no number {self.which + 1} in {text[:80]!r}")
        return parse_number(numbers[self.which])

    def _cell(self, lines: list[str]) -> str:
        """The only cell of the row and the column in the tables of the section."""
        exact, beginning = [], []
        for head, rows in tables(lines):
            names = range(len(head)) if isinstance(self.column, int) else head
            at = [index for index, name in enumerate(names) if name == self.column]
            for cells in rows if len(at) == 1 else ():
                pairs = list(zip(self.row, cells, strict=False))
                if all(cell == name for name, cell in pairs):
                    exact.append(cells[at[0]])
                elif all(cell.startswith(name) for name, cell in pairs):
                    beginning.append(cells[at[0]])
        found = exact or beginning
        if len(found) != 1:
            raise UnreadableError(f"{self}: {len(found)} cells under {self.column!r}")
        return found[0]


@dataclass(frozen=True)
class Quotient:
    """Of two printed numbers: a rate over that of a peer."""

    of: Place
    to: Place

    def __str__(self) -> str:
        return f"{self.of} / {self.to}"

    def number(self) -> PrintedNumber:
        of, to = self.of.number(), self.to.number()
        value = of.value / to.value
        return PrintedNumber(value, value * (of.rounding / of.value + to.rounding / to.value))


def parse_number(text: str) -> PrintedNumber:
    """A number with a minus sign and with spaces between thousands."""
    plain = re.sub(r"\s", "", text).replace("−", "-")
    decimals = len(plain.partition(".")[2])
    return PrintedNumber(float(plain), 0.5 * 10.0**-decimals)


@cache
def page_lines(page: str) -> tuple[str, ...]:
    return tuple((ROOT / page).read_text("utf-8").splitlines())


def section_lines(page: str, section: str) -> list[str]:
    """The lines below a heading, which must exist, up to the next one of any level."""
    lines: list[str] | None = None
    for line in page_lines(page):
        heading = HEADING.match(line)
        if heading and lines is not None:
            break
        if heading and heading[1] == section:
            lines = []
        elif lines is not None:
            lines.append(line)
    if lines is None:
        raise UnreadableError(f"{page} has no section {section!r}")
    return lines


def tables(lines: list[str]) -> Iterator[tuple[Cells, list[Cells]]]:
    """Head and rows of each table. A row without a first cell goes on with that above it."""
    block: list[Cells] = []
    for line in [*lines, ""]:
        if line.startswith("|"):
            block.append(tuple(cell.strip() for cell in line.strip().strip("|").split("|")))
        elif block:
            head, _, *rows = block
            yield head, list(_continued(rows))
            block = []


def _continued(rows: list[Cells]) -> Iterator[Cells]:
    first = ""
    for cells in rows:
        first = cells[0] or first
        yield (first, *cells[1:])


def in_readme(row: str, pattern: str) -> Place:
    """In the README's table, in the row whose label begins so."""
    return Place(README, WELL, (row,), pattern=pattern)
