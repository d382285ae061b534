"""The catalogue as Parquet files, for questions of one's own in DuckDB, pandas or a spreadsheet."""

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

from sqlalchemy import Connection, Select, select

from crenel.fleet.catalogue.libraries import check_libraries
from crenel.fleet.catalogue.tables import FigureRow, FileRow, RecordRow, StationRow, UtcMoment
from crenel.formats.atomic_write import atomic_path, ensure_folder
from crenel.formats.io_errors import convert_io_errors

if TYPE_CHECKING:
    import pyarrow as pa

AT_ONCE = 20_000
"""Rows in memory; each is a row group of the file."""
RENAMED = {"at": "made_at"}
"""``at`` is a word of DuckDB's SQL."""
TABLES: dict[str, Select[Any]] = {
    "station": select(StationRow.__table__).order_by(StationRow.id),
    "record": select(RecordRow.__table__).order_by(RecordRow.key),
    "file": select(FileRow.__table__).order_by(FileRow.record_key, FileRow.path),
    "figure": select(FigureRow.__table__).order_by(FigureRow.record_key, FigureRow.number),
}


def export_parquet(connection: Connection, folder: Path) -> dict[str, int]:
    """Writes ``station``, ``record``, ``file`` and ``figure``, each as ``<name>.parquet``.

    Each file appears when it is complete, and replaces an earlier one. Times are in UTC.

    Returns:
        The number of rows of each.

    Raises:
        OperationError: a library is missing, or the folder cannot be written.
    """
    check_libraries(("pyarrow",))
    with convert_io_errors(folder):
        ensure_folder(folder)
    return {
        name: _write_table(connection, wanted, folder / f"{name}.parquet")
        for name, wanted in TABLES.items()
    }


def _write_table(connection: Connection, wanted: Select[Any], path: Path) -> int:
    import pyarrow as pa
    import pyarrow.parquet as pq

    schema = pa.schema(
        [
            (RENAMED.get(column.name, column.name), _type_of(column))
            for column in wanted.selected_columns
        ]
    )
    rows = 0
    with atomic_path(path) as part, pq.ParquetWriter(part, schema, compression="zstd") as writer:
        for some in _pieces(connection, wanted):
            rows += len(some)
            columns = [
                pa.array(values, kind)
                for values, kind in zip(zip(*some, strict=True), schema.types, strict=True)
            ]
            writer.write_table(pa.table(columns, schema=schema))
    return rows


def _pieces(connection: Connection, wanted: Select[Any]) -> Iterator[list[tuple[Any, ...]]]:
    streamed = connection.execution_options(yield_per=AT_ONCE).execute(wanted)
    for some in streamed.partitions():
        yield [tuple(row) for row in some]


def _type_of(column: Any) -> "pa.DataType":
    import pyarrow as pa

    by_python = {
        "str": pa.string(),
        "int": pa.int64(),
        "float": pa.float64(),
        "bool": pa.bool_(),
    }
    if isinstance(column.type, UtcMoment):
        return pa.timestamp("us", tz="UTC")
    return by_python[column.type.python_type.__name__]
