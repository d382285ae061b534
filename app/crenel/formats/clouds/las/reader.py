"""Reads LAS and LAZ."""

from pathlib import Path
from typing import BinaryIO

from crenel.formats.clouds.las.layout import load_laspy
from crenel.formats.clouds.las.laz_process import read_in_process
from crenel.formats.clouds.las.table import LasTable, format_las_error, open_las
from crenel.formats.clouds.optional_library import first_line
from crenel.formats.clouds.points import Cloud, cloud_from_columns
from crenel.formats.clouds.rows import format_error, truncation_error
from crenel.messages.message import message

LARGEST_HEADER, RECORD_HEADER, EXTENDED_HEADER = 375, 54, 60
"""Bytes, by the standard: of the file, of a variable length record, of an extended one."""
POINT_FORMAT_BYTE, COMPRESSED_BITS = 104, 0xC0
"""Where the header has the format of the points, and what LAZ sets in it."""


def read_las(path: Path, file: BinaryIO) -> Cloud:
    """Reads a LAS or LAZ, without the points that are marked as deleted (withheld).

    Raises:
        OperationError: malformed or cut off.
    """
    load_laspy(path)
    _check_counts(path, file)
    table = read_in_process(path) if _is_compressed(file) else _read_uncompressed(path, file)
    if len(table.rows) < table.announced:
        raise truncation_error(path, len(table.rows), table.announced)
    columns = dict(zip(table.names, table.rows.T, strict=True))
    withheld = columns.pop("withheld") != 0
    kept = {name: column[~withheld] for name, column in columns.items()}
    return cloud_from_columns(kept, deleted=int(withheld.sum()))


def _read_uncompressed(path: Path, file: BinaryIO) -> LasTable:
    try:
        with open_las(path, file) as reader:
            return reader.read_all()
    except OSError:
        raise
    except Exception as error:  # the library raises errors of many kinds
        raise format_las_error(path, first_line(error) or type(error).__name__) from error


def _is_compressed(file: BinaryIO) -> bool:
    file.seek(POINT_FORMAT_BYTE)
    compressed = any(byte & COMPRESSED_BITS for byte in file.read(1))
    file.seek(0)
    return compressed


def _check_counts(path: Path, file: BinaryIO) -> None:
    """Refuses headers that announce more than the file can hold, which laspy would believe."""
    size = file.seek(0, 2)
    file.seek(0)
    head = file.read(LARGEST_HEADER)
    records = int.from_bytes(head[100:104], "little") * RECORD_HEADER
    extended = (
        int.from_bytes(head[243:247], "little") * EXTENDED_HEADER if head[25:26] > b"\3" else 0
    )
    if max(records, extended) > size:
        raise format_error(path, message("cloud-header-announces-more"))
    file.seek(0)
