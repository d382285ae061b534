"""Tables of a result as a folder of CSV files, or as one XLSX workbook."""

import importlib.util
import io
from collections.abc import Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path

from crenel.formats.atomic_write import check_output_path, write_atomically
from crenel.formats.csv_table import table_text
from crenel.formats.io_errors import convert_io_errors
from crenel.formats.optional_library import import_library
from crenel.messages.message import Text, message
from crenel.timestamps import parse_moment

LIBRARY = "xlsxwriter"
WIDEST = 60
"""The width of the widest column, in characters."""
EARLIEST = datetime(1980, 1, 1)
Cell = str | float | int | None
"""None: not known, an empty cell."""


@dataclass(frozen=True)
class ResultTable:
    """One table; its name is also that of its file or worksheet."""

    name: str
    columns: tuple[str, ...]
    rows: tuple[tuple[Cell, ...], ...]


def table_csv(table: ResultTable) -> bytes:
    """One table as a CSV file, UTF-8."""
    rows = [["" if cell is None else cell for cell in row] for row in table.rows]
    return table_text(table.columns, rows).encode()


def write_csv_folder(tables: Sequence[ResultTable], folder: Path) -> list[Path]:
    """Writes one CSV file for each table into a folder, which is made; returns their paths.

    Raises:
        OperationError: a file or the folder cannot be written.
    """
    with convert_io_errors(folder):
        folder.mkdir(exist_ok=True)
    written = []
    for table in tables:
        path = folder / f"{table.name}.csv"
        write_atomically(path, table_csv(table))
        written.append(path)
    return written


def write_workbook(tables: Sequence[ResultTable], path: Path, title: str, moment: str = "") -> None:
    """Writes tables as worksheets of an XLSX file, with identical bytes for the same tables.

    Args:
        moment: when the result was made, ISO 8601, for the properties of the file.

    Raises:
        OperationError: ``extra-missing`` without the extra ``xlsx``; the file cannot be written.
    """
    check_output_path(path)
    needed, remedy = message("xlsx-package-missing"), message("install-extra-xlsx")
    library = import_library(path, LIBRARY, needed, remedy)
    content = io.BytesIO()
    # texts stay texts: none becomes a formula, a link or a number
    options = {
        "in_memory": True,
        "strings_to_formulas": False,
        "strings_to_urls": False,
        "strings_to_numbers": False,
    }
    with library.Workbook(content, options) as book:
        book.set_properties({"title": title, "created": _in_utc(moment)})
        bold = book.add_format({"bold": True, "bottom": 1})
        for table in tables:
            page = book.add_worksheet(table.name)
            page.freeze_panes(1, 0)
            page.write_row(0, 0, table.columns, bold)
            for number, row in enumerate(table.rows, 1):
                page.write_row(number, 0, row)
            for column, cells in enumerate(zip(table.columns, *table.rows, strict=True)):
                page.set_column(column, column, min(max(len(str(c)) for c in cells) + 2, WIDEST))
    write_atomically(path, content.getvalue())


def _in_utc(moment: str) -> datetime:
    """A moment in UTC, so that the same result gives the same file."""
    try:
        return parse_moment(moment).astimezone(UTC).replace(tzinfo=None)
    except ValueError:
        return EARLIEST


def workbook_obstacle() -> Text:
    """What to install before a workbook can be written; empty if nothing is missing."""
    if importlib.util.find_spec(LIBRARY) is not None:
        return ""
    return message("xlsx-extra-missing")
