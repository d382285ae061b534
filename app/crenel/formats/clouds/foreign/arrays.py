"""Arrays of numpy as clouds: NPY, and NPZ of several."""

import zipfile
import zlib
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np
from numpy.typing import NDArray

from crenel.errors import OperationError
from crenel.formats.clouds.axis_names import (
    choose_axes,
    cloud_of_axes,
    find_axes,
    find_named_axes,
)
from crenel.formats.clouds.points import Cloud
from crenel.formats.clouds.rows import as_doubles, format_error
from crenel.formats.file_names import display_path
from crenel.messages.message import message

NPY, ZIP = b"\x93NUMPY", b"PK\3\4"
MOST_COLUMNS = 16
"""An array with more numbers a row is a picture or another table."""
CLOUD_NAMES = ("points", "xyz", "vertices", "pts", "cloud", "pcd", "pc", "coords")
"""Names under which programs keep the coordinates beside colours and others."""
Array = NDArray[Any]


def is_array(head: bytes) -> bool:
    """Whether a file begins like an NPY, or an archive whose first file is one."""
    name = head[30 : 30 + int.from_bytes(head[26:28], "little")]
    return head.startswith(NPY) or (head.startswith(ZIP) and name.endswith(b".npy"))


def read_arrays(path: Path, file: BinaryIO, columns: Sequence[str] | None = None) -> Cloud:
    """Reads an array (N, 3) or wider, (3, N), (rows, columns, 3), or with named fields.

    Of several arrays, three named x, y, z are taken, or the only one of such a shape, or the one
    with a usual name.

    Args:
        columns: the names or numbers of the columns of x, y and z, if the user gives them.

    Raises:
        OperationError: damaged, or there is no such array, or more than one.
    """
    file.seek(0)
    try:
        loaded = np.load(file, allow_pickle=False)
        arrays = {"": loaded} if isinstance(loaded, np.ndarray) else dict(loaded.items())
    except (ValueError, EOFError, MemoryError, zipfile.BadZipFile, zlib.error) as error:
        raise format_error(
            path, message("cloud-not-complete-format", format="NPY/NPZ", reason=str(error))
        ) from error
    return _cloud_of_arrays(path, arrays, columns)


def _cloud_of_arrays(
    path: Path, arrays: Mapping[str, Array], columns: Sequence[str] | None
) -> Cloud:
    lists = {name: array for name, array in arrays.items() if array.ndim == 1 and _is_real(array)}
    if find_axes(list(lists)) is not None and len({len(array) for array in lists.values()}) == 1:
        return _cloud_of_table(
            path, {name: as_doubles(one) for name, one in lists.items()}, columns
        )
    tables = {name: one for name, array in arrays.items() if (one := _as_rows(array)) is not None}
    usual = [name for name in CLOUD_NAMES if name in tables]
    if not usual and len(tables) != 1:
        shapes = ", ".join(f"{name} {array.shape}".strip() for name, array in arrays.items())
        raise OperationError(
            "cloud-columns-unknown",
            display_path(path),
            message("cloud-arrays-there", names=shapes),
            message("cloud-save-one-array"),
        )
    rows = tables[usual[0] if usual else next(iter(tables))]
    if rows.dtype.names:
        return _cloud_of_table(path, {n: as_doubles(rows[n]) for n in rows.dtype.names}, columns)
    names = [""] * rows.shape[1]
    x, y, z = (0, 1, 2) if columns is None else choose_axes(path, names, columns).places
    return Cloud(np.column_stack([as_doubles(rows[:, place]) for place in (x, y, z)]))


def _cloud_of_table(
    path: Path, table: dict[str, NDArray[np.float64]], columns: Sequence[str] | None
) -> Cloud:
    names = list(table)
    return cloud_of_axes(table, names, find_named_axes(path, names, columns))


def _as_rows(array: Array) -> Array | None:
    """(N, columns), or (N,) with named fields; None: it is no cloud."""
    if array.dtype.names:
        plain = [name for name in array.dtype.names if array.dtype[name].kind in "fiu"]
        return np.ravel(array[plain]) if plain else None
    if not _is_real(array):
        return None
    if array.ndim == 3 and 3 <= array.shape[2] <= MOST_COLUMNS:
        return array.reshape(-1, array.shape[2])
    if array.ndim != 2:
        return None
    if 3 <= array.shape[1] <= MOST_COLUMNS:
        return array
    return array.T if 3 <= array.shape[0] <= MOST_COLUMNS else None


def _is_real(array: Array) -> bool:
    return array.dtype.kind in "fiu"
