"""CSV tables with named columns."""

import csv
import io
import math
import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path

from crenel.errors import OperationError
from crenel.formats.file_names import display_path
from crenel.formats.json_document import read_text
from crenel.messages.message import Text, message

WORKBOOK = "PK\x03\x04"
"""How the file of a spreadsheet program begins."""
FORMULA, GUARDED = re.compile(r"'*\s*[=+\-@]|'*[\t\r]"), re.compile(r"'+(\s*[=+\-@]|[\t\r])")
"""Cells that spreadsheet programs run, and those that an apostrophe keeps from it."""
NUMBER = re.compile(r"[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?")
"""What is a number to all of them; ``-nan`` is a formula, though not to Python."""


@dataclass(frozen=True)
class TableRow:
    """One row of a table, by column name."""

    path: Path
    line: int
    cells: dict[str, str]

    @property
    def place(self) -> Text:
        return message("row-place", path=display_path(self.path), line=self.line)

    def text(self, column: str) -> str:
        """A cell that must not be empty."""
        value = self.cells[column].strip()
        if not value:
            raise OperationError(
                "cell-empty", message("column-empty", place=self.place, column=column)
            )
        return value

    def number(self, column: str) -> float:
        """A finite decimal number."""
        value = self.text(column)
        try:
            number = float(value) if value.isascii() and "_" not in value else math.nan
        except ValueError:
            number = math.nan
        if not math.isfinite(number):
            raise OperationError(
                "cell-not-a-number",
                message("column-cell-is", place=self.place, column=column, value=repr(value)),
                message("finite-number-decimal-point-expected"),
                message("correct-cell-delete-row"),
            )
        return number

    def count(self, column: str) -> int:
        """An integer, zero or larger."""
        value = self.text(column)
        if not (value.isascii() and value.isdecimal()):
            raise OperationError(
                "cell-not-a-number",
                message("column-cell-is", place=self.place, column=column, value=repr(value)),
                message("whole-number-zero-more-expected"),
            )
        return int(value)


@dataclass(frozen=True)
class CsvTable:
    path: Path
    columns: tuple[str, ...]
    rows: tuple[TableRow, ...]


def read_table(path: Path, required: Iterable[str]) -> CsvTable:
    """Reads a CSV file; raises ``OperationError`` as ``parse_table``, or if it is unreadable."""
    return parse_table(read_text(path), path, required)


def parse_table(text: str, path: Path, required: Iterable[str]) -> CsvTable:
    """Reads the text of a CSV file whose first line names its columns, in any order.

    A byte-order mark, blank lines and either line ending are accepted; unknown columns are ignored.

    Args:
        path: named in errors.

    Raises:
        OperationError: a required column missing or named twice, a row of another length than
            the header, columns that are not separated by commas, or a file that is no text.
    """
    if text.startswith(WORKBOOK) or "\0" in text:
        raise OperationError(
            "table-is-no-text",
            display_path(path),
            message("table-is-workbook-or-no-text"),
            message("save-table-as-csv"),
        )
    lines = csv.reader(io.StringIO(text.removeprefix("\ufeff"), newline=""), strict=True)
    columns: tuple[str, ...] = ()
    rows: list[TableRow] = []
    try:
        for cells in lines:
            if not any(cell.strip() for cell in cells):
                continue
            cells = [cell[1:] if GUARDED.match(cell) else cell for cell in cells]
            if not columns:
                columns = tuple(cell.strip() for cell in cells)
                _check_columns(path, columns, required)
                continue
            _check_length(path, lines.line_num, cells, columns)
            rows.append(TableRow(path, lines.line_num, dict(zip(columns, cells, strict=True))))
    except csv.Error as error:
        raise OperationError(
            "table-malformed",
            message("row-place", path=display_path(path), line=lines.line_num),
            str(error),
        ) from error
    if not columns:
        raise OperationError("table-empty", display_path(path), message("table-is-empty"))
    return CsvTable(path, columns, tuple(rows))


def table_text(columns: Sequence[str], rows: Iterable[Sequence[str | float | int]]) -> str:
    """The text of a CSV file; numbers are written so that they are read back exactly.

    Texts that a spreadsheet program would run as formulas begin with an apostrophe, which
    ``parse_table`` takes away.
    """
    return "".join(_line([_guard_formula(cell) for cell in row]) for row in (columns, *rows))


def _line(cells: Sequence[str | float | int]) -> str:
    out = io.StringIO()
    csv.writer(out, lineterminator="\r\n").writerow(cells)  # which quotes both of these
    return out.getvalue().removesuffix("\r\n") + "\n"


def _guard_formula(cell: str | float | int) -> str | float | int:
    if isinstance(cell, str) and FORMULA.match(cell) and not NUMBER.fullmatch(cell):
        return f"'{cell}"
    return cell


def is_number(cell: str) -> bool:
    """Whether a cell is a number as Python reads it."""
    try:
        float(cell)
    except ValueError:
        return False
    return True


def _check_columns(path: Path, columns: tuple[str, ...], required: Iterable[str]) -> None:
    missing = [name for name in required if name not in columns]
    if (missing or len(columns) == 1) and any(";" in name or "\t" in name for name in columns):
        raise OperationError(
            "table-separator",
            display_path(path),
            message("columns-not-separated-by-commas"),
            message("save-commas-between-columns-point-numbers"),
        )
    if missing:
        raise OperationError(
            "columns-missing",
            message("no-column", path=display_path(path), names=", ".join(missing)),
            message("first-line-names", names=", ".join(columns)),
            message("must-name", names=", ".join(required)),
        )
    twice = sorted({name for name in columns if name and columns.count(name) > 1})
    if twice:
        raise OperationError(
            "columns-twice",
            message("column-stands-there-twice", path=display_path(path), names=", ".join(twice)),
        )


def _check_length(path: Path, line: int, cells: list[str], columns: tuple[str, ...]) -> None:
    if len(cells) == len(columns):
        return
    why = message("first-line-names-column-count", count=len(columns))
    remedy = message("complete-delete-row")
    if len(cells) > len(columns):
        remedy = message("numbers-without-decimal-comma")
    raise OperationError(
        "row-length",
        message("row-has-cells", path=display_path(path), line=line, count=len(cells)),
        why,
        remedy,
    )
