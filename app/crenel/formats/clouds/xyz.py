"""XYZ: one point a line, as text."""

import codecs
import io
import re
import warnings
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import islice, pairwise
from pathlib import Path
from typing import BinaryIO, TextIO

import numpy as np

from crenel.errors import OperationError
from crenel.formats.clouds.axis_names import (
    Axes,
    choose_axes,
    find_axes,
    unit_of_row,
    unknown_columns_error,
)
from crenel.formats.clouds.points import Cloud, Points, cloud_from_columns, scale_cloud
from crenel.formats.clouds.rows import has_decimal_commas, truncation_error
from crenel.formats.csv_table import is_number
from crenel.formats.file_names import display_path
from crenel.messages.message import message, quantity
from crenel.metrology.transforms import Floats
from crenel.native.arguments import I64, U8, Array, Function
from crenel.native.library import CRENEL

COLUMNS = {"x": 4, "y": 4, "z": 4, "intensity": 1, "uncertainty_um": 2, "frame": 0}
"""In their order, with their decimals: coordinates to 0.1 µm."""
HEAD = f"# {' '.join(COLUMNS)}\n"
LONGEST_NUMBER = 22
"""With what follows it, of up to 63 bits."""
FARTHEST_MM = 1e9
HEAD_LINES = 10
"""Lines among which there is one of a point."""
HEAD_CHARACTERS = 1 << 16
JOINED_UNIT = re.compile(r"[ \t]+([\[(])")
"""What separates a unit in brackets from its name."""

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


def read_xyz(path: Path, file: BinaryIO, columns: Sequence[str] | None = None) -> Cloud:
    """Reads lines of x y z and more; or where a line above the points names x, y and z, these.

    Args:
        columns: names or numbers of the columns of x, y and z, if the user gives them.
    """
    file.seek(0)
    mark = file.read(2)
    file.seek(0)
    is_wide = mark in (codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)
    with io.TextIOWrapper(file, "utf-16" if is_wide else "utf-8-sig", "replace") as text:
        return _read(path, text, columns)


@dataclass(frozen=True)
class _Layout:
    delimiter: str | None
    axes: Axes
    skip: int
    """Lines before the points."""
    quote: str | None
    """Around cells."""


def _read(path: Path, text: TextIO, columns: Sequence[str] | None) -> Cloud:
    start = text.read(HEAD_CHARACTERS)
    text.seek(0)
    lines: Iterable[str] = text
    if any(map(has_decimal_commas, start.splitlines())):
        start, lines = "".join(map(_put_points, start.splitlines(True))), map(_put_points, text)
    layout = _find_layout(path, start, columns)
    names: tuple[str, ...] = ("x", "y", "z")
    places: tuple[int, ...] = layout.axes.places
    if start.startswith(HEAD):
        names, places = tuple(COLUMNS), tuple(range(len(COLUMNS)))
    try:
        with warnings.catch_warnings(action="ignore"):  # of a file without rows
            table: Floats = np.loadtxt(
                _rows(path, lines, layout.skip),
                comments="#" if layout.quote else ("#", "//"),  # numpy takes either
                delimiter=layout.delimiter,
                usecols=places,
                ndmin=2,
                quotechar=layout.quote,
            ).reshape(-1, len(names))
    except (ValueError, IndexError) as error:
        raise OperationError(
            "cloud-unreadable",
            display_path(path),
            message("cloud-line-of-numbers-expected", reason=str(error).split(";")[0]),
            message("cloud-correct-line"),
        ) from error
    cloud = cloud_from_columns({name: table[:, i] for i, name in enumerate(names)})
    return scale_cloud(cloud, layout.axes.mm_per_unit or 1.0)


def _put_points(line: str) -> str:
    """A row with decimal points where it has decimal commas."""
    return line.replace(",", ".") if has_decimal_commas(line) else line


def _rows(path: Path, lines: Iterable[str], skip: int) -> Iterable[str]:
    """The lines of points, without the counts of points of a PTS; raises ``OperationError`` if it
    is cut off.

    Args:
        skip: lines before the first point.
    """
    lines = iter(lines)
    head = list(islice(lines, skip))
    return (
        _rows_below_counts(path, lines, int(head[-1]))
        if head and head[-1].strip().isdecimal()
        else lines
    )


def _rows_below_counts(path: Path, lines: Iterator[str], announced: int) -> Iterator[str]:
    left = announced
    for line in lines:
        if left == 0 and line.strip().isdecimal():
            left = int(line)
            announced += left
        elif line.strip():
            yield line
            left -= 1
    if left > 0:
        raise truncation_error(path, announced - left, announced)


def _find_layout(path: Path, start: str, columns: Sequence[str] | None) -> _Layout:
    """How the points stand in the lines, from those at the start of the file."""
    every = [line for line in start.splitlines() if line.strip()]
    lines = [line for line in every if line[0] not in "#/"]
    if not lines or "\0" in start:
        why = message("cloud-format-unknown") if lines else message("cloud-file-empty")
        raise OperationError(
            "cloud-unreadable", display_path(path), why, message("cloud-give-known-format")
        )
    rows = (line for line in lines[:HEAD_LINES] if _count_numbers(_cells(line)) >= 3)
    point = next(rows, None)
    above = every[: every.index(point or lines[0]) + (point is None)]
    cells = _cells(point or lines[:2][-1])
    titles = [line for line in above if line in lines]
    damaged = [line for line in titles if 0 < _count_numbers(_cells(line)) == len(cells) - 1]
    first = damaged[0] if damaged else point
    skip = len(start[: start.index(first)].splitlines()) if first else len(titles)
    axes = _find_axes(path, above, cells, columns)
    if axes is None:
        _refuse_numbers_of_points(path, lines[lines.index(point) :] if point else [], cells)
        axes = _find_numbers(path, cells) if point else Axes((0, 1, 2))
    quote = '"' if point and '"' in point else None
    return _Layout(_delimiter(point or lines[0]), axes, skip, quote)


def _find_axes(
    path: Path, above: Sequence[str], cells: Sequence[str], columns: Sequence[str] | None
) -> Axes | None:
    """The columns of x, y and z by a line of names; None: the file names none.

    Args:
        above: lines before the first point, comments too.
        cells: of the first point.
    """
    tables = [_names(line.lstrip("#/ ")) for line in above]
    named = [names for names in tables if len(names) == len(cells)]
    if columns is not None:
        return choose_axes(path, named[0] if named else [""] * len(cells), columns)
    found = [axes for names in tables if (axes := find_axes(names)) is not None]
    inside = [axes for axes in found if max(axes.places) < len(cells)]
    if inside:
        units = [unit for names in named if (unit := unit_of_row(names)) is not None]
        return inside[0] if not units else Axes(inside[0].places, units[0])
    for line, names in zip(above, tables, strict=True):
        is_table = line[0] not in "#/" or _delimiter(line) is not None
        if is_table and len(names) == len(cells) and not _count_numbers(names):
            raise unknown_columns_error(path, names)
    return None


def _find_numbers(path: Path, cells: Sequence[str]) -> Axes:
    """The first three cells, or the only three that are numbers; raises ``OperationError``."""
    numbers = [i for i, cell in enumerate(cells) if is_number(cell)]
    if numbers[:3] == [0, 1, 2] or len(numbers) == 3:
        x, y, z = numbers[:3]
        return Axes((x, y, z))
    raise OperationError(
        "cloud-columns-unknown",
        display_path(path),
        message("cloud-rows-without-column-names", cells=", ".join(cells)),
        message("cloud-give-columns"),
    )


def _refuse_numbers_of_points(path: Path, lines: Sequence[str], cells: Sequence[str]) -> None:
    """Refuses rows without names whose first column counts them."""
    firsts = [_cells(line)[0] for line in lines[:-1]]  # the last may be cut
    if len(cells) < 4 or len(firsts) < 4 or not all(map(is_number, firsts)):
        return
    numbers = [float(first) for first in firsts]
    if all(b - a == 1 for a, b in pairwise(numbers)):
        raise OperationError(
            "cloud-columns-unknown",
            display_path(path),
            message("cloud-first-column-counts-without-names"),
            message("cloud-give-columns"),
        )


def _delimiter(line: str) -> str | None:
    """What stands between the cells; None: white space."""
    if sign := next((sign for sign in ";," if sign in line), None):
        return sign
    return "\t" if line.count("\t") >= 2 else None


def _cells(line: str) -> list[str]:
    return [cell.strip(' "') for cell in line.split(_delimiter(line))]


def _names(line: str) -> list[str]:
    """Cells of a line of names, in which a unit may stand after white space."""
    return _cells(JOINED_UNIT.sub(r"_\1", line) if _delimiter(line) is None else line)


def _count_numbers(cells: Sequence[str]) -> int:
    return sum(is_number(cell) for cell in cells)
