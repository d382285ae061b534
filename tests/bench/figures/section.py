"""Figures of one section of docs/accuracy.md."""

from dataclasses import dataclass

from tests.bench.figures.figure import Better, Command, Figure, Read, Tolerance
from tests.bench.figures.printed import ACCURACY, Cells, Place, Printed

SMALLER, LARGER, NEAR_ONE, AS_PRINTED = Better


@dataclass(frozen=True)
class Section:
    """A section of docs/accuracy.md, and the command that measures its figures."""

    command: Command
    title: str

    def place(
        self, row: str | Cells, column: str | int = 1, which: int = 0, pattern: str = ""
    ) -> Place:
        cells = (row,) if isinstance(row, str) else row
        return Place(ACCURACY, self.title, cells, column, which, pattern)

    def __call__(
        self,
        name: str,
        place: Printed | tuple[str | Cells, str | int] | tuple[str | Cells, str | int, int] | str,
        read: Read,
        better: Better,
        tolerance: Tolerance,
        also: Printed | None = None,
    ) -> Figure:
        """A figure in a row and a column (and which number there), or in a sentence's pattern."""
        match place:
            case str():
                place = self.place((), pattern=place)
            case tuple():
                place = self.place(*place)
        places = (place, also) if also else (place,)
        return Figure(name, self.command, places, read, better, tolerance)
