"""A performance test as a folder of CSV files, or as one XLSX workbook."""

import importlib.util
import io
from datetime import UTC, datetime
from pathlib import Path

from crenel.formats.atomic_write import check_output_path, write_atomically
from crenel.formats.csv_table import table_text
from crenel.formats.io_errors import convert_io_errors
from crenel.formats.optional_library import import_library
from crenel.gauges.exchange.result_tables import result_tables
from crenel.gauges.judgement.document import PerformanceFile
from crenel.messages.message import Text, message
from crenel.timestamps import parse_moment

LIBRARY = "xlsxwriter"
WIDEST = 60
"""The width of the widest column, in characters."""
EARLIEST = datetime(1980, 1, 1)


def write_csv_tables(document: PerformanceFile, folder: Path) -> list[Path]:
    """Writes one CSV file for each table into a folder, which is made; returns their paths.

    Raises:
        OperationError: a file or the folder cannot be written.
    """
    with convert_io_errors(folder):
        folder.mkdir(exist_ok=True)
    written = []
    for table in result_tables(document):
        path = folder / f"{table.name}.csv"
        rows = [["" if cell is None else cell for cell in row] for row in table.rows]
        write_atomically(path, table_text(table.columns, rows).encode())
        written.append(path)
    return written


def write_workbook(document: PerformanceFile, path: Path) -> None:
    """Writes the tables as worksheets of an XLSX file, with identical bytes for the same result.

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
        book.set_properties({"title": document.id, "created": _end_time(document)})
        bold = book.add_format({"bold": True, "bottom": 1})
        for table in result_tables(document):
            page = book.add_worksheet(table.name)
            page.freeze_panes(1, 0)
            page.write_row(0, 0, table.columns, bold)
            for number, row in enumerate(table.rows, 1):
                page.write_row(number, 0, row)
            for column, cells in enumerate(zip(table.columns, *table.rows, strict=True)):
                page.set_column(column, column, min(max(len(str(c)) for c in cells) + 2, WIDEST))
    write_atomically(path, content.getvalue())


def _end_time(document: PerformanceFile) -> datetime:
    """When the test ended, in UTC, so that the same result gives the same file."""
    try:
        return parse_moment(document.ended_at).astimezone(UTC).replace(tzinfo=None)
    except ValueError:
        return EARLIEST


def workbook_obstacle() -> Text:
    """What to install before a workbook can be written; empty if nothing is missing."""
    if importlib.util.find_spec(LIBRARY) is not None:
        return ""
    return message("xlsx-extra-missing")
