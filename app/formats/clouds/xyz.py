"""XYZ: one point a line, as text."""

import io
import warnings
from collections.abc import Sequence
from pathlib import Path
from typing import BinaryIO, TextIO

import numpy as np

from app.errors import OperationError
from app.formats.clouds.points import Cloud, Points, cloud_from_columns
from app.formats.clouds.rows import refuse_decimal_commas
from app.formats.file_names import display_path
from app.messages.message import message, quantity
from app.metrology.transforms import Floats
from app.native.arguments import I64, U8, Array, Function
from app.native.library import CRENEL

COLUMNS = {"x": 4, "y": 4, "z": 4, "intensity": 1, "uncertainty_um": 2, "frame": 0}
"""In their order, with their decimals: coordinates to 0.1 µm."""
HEAD = f"# {' '.join(COLUMNS)}\n"
LONGEST_NUMBER = 22
"""With what follows it, of up to 63 bits."""
FARTHEST_MM = 1e9
HEAD_LINES = 10
"""Lines among which there is one of a point."""

_write_decimals = Function(
    CRENEL,
    "write_decimals",
    Array(I64, "n", "columns"),
    Array(I64, "columns"),
    Array(U8, "n", "columns", LONGEST_NUMBER, written=True),
    returns=int,
)


class XyzSink:
    """Appends points to an open file."""

    def __init__(self, path: Path, file: BinaryIO) -> None:
        self._path = path
        self._file = file
        file.write(HEAD.encode())

    def write(self, points: Points) -> None:
        table = np.column_stack([points[name].astype(np.float64) for name in COLUMNS])
        farthest = float(np.abs(table[:, :3]).max(initial=0.0))
        if farthest > FARTHEST_MM:
            raise OperationError(
                "cloud-out-of-range",
                message(
                    "cloud-point-lies-away",
                    path=display_path(self._path),
                    distance=quantity(farthest, "mm"),
                ),
                message("cloud-xyz-written-up-to", limit=quantity(FARTHEST_MM, "mm")),
                message("cloud-write-ply"),
            )
        decimals = np.array(list(COLUMNS.values()))
        scaled = np.rint(np.nan_to_num(table) * 10.0**decimals).clip(-(2.0**62), 2.0**62)
        text = np.empty((*table.shape, LONGEST_NUMBER), dtype=np.uint8)
        length = _write_decimals(scaled.astype(np.int64), decimals, text)
        self._file.write(text.reshape(-1)[:length].data)

    def finish(self) -> None:
        """Nothing is held back."""


def read_xyz(path: Path, file: BinaryIO) -> Cloud:
    """Reads lines of x y z and more; or where a line above the points names x, y and z, these."""
    file.seek(0)
    with io.TextIOWrapper(file, "utf-8-sig", "replace") as text:
        return _read(path, text)


def _read(path: Path, text: TextIO) -> Cloud:
    start = text.read(4096)
    text.seek(0)
    every = [line for line in start.splitlines() if line.strip()]
    lines = [line for line in every if line[0] not in "#/"]
    if not lines or "\0" in start:
        why = message("cloud-format-unknown") if lines else message("cloud-file-empty")
        raise OperationError(
            "cloud-unreadable",
            display_path(path),
            why,
            message("cloud-give-known-format"),
        )
    for line in lines[:HEAD_LINES]:
        refuse_decimal_commas(path, line)
    delimiter = next((sign for sign in ";," if sign in lines[0]), None)
    head = every[: every.index(lines[0]) + 1]
    places = _find_places(head, lines[:2][-1], delimiter)
    skip = 0 if _is_point(lines[0], delimiter, places) else start.splitlines().index(lines[0]) + 1
    names: tuple[str, ...] = ("x", "y", "z")
    if start.startswith(HEAD):
        names, places = tuple(COLUMNS), tuple(range(len(COLUMNS)))
    try:
        with warnings.catch_warnings(action="ignore"):  # of a file without rows
            table: Floats = np.loadtxt(
                text,
                comments=("#", "//"),
                delimiter=delimiter,
                usecols=places,
                ndmin=2,
                skiprows=skip,
            ).reshape(-1, len(names))
    except (ValueError, IndexError) as error:
        raise OperationError(
            "cloud-unreadable",
            display_path(path),
            message("cloud-line-of-numbers-expected", reason=str(error).split(";")[0]),
            message("cloud-give-ply-or-xyz"),
        ) from error
    return cloud_from_columns({name: table[:, i] for i, name in enumerate(names)})


def _find_places(head: Sequence[str], point: str, delimiter: str | None) -> tuple[int, ...]:
    """The columns of x, y and z: the first three, unless a line of names says otherwise.

    Args:
        head: lines down to the first that is no comment.
        point: a line of a point, as long as that of the names.
    """
    for line in head:
        names = [name.strip(' "').lower() for name in line.lstrip("#/ ").split(delimiter)]
        if len(names) == len(point.split(delimiter)) and {"x", "y", "z"} <= set(names):
            return tuple(names.index(axis) for axis in "xyz")
    return 0, 1, 2


def _is_point(line: str, delimiter: str | None, places: tuple[int, ...]) -> bool:
    cells = line.split(delimiter)
    try:
        return len([float(cells[place]) for place in places]) == len(places)
    except (ValueError, IndexError):
        return False
