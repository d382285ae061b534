"""Rows of points after a header, binary or as text, and refusals that several formats share."""

import re
from collections.abc import Iterator, Sequence
from itertools import islice
from pathlib import Path
from typing import BinaryIO

import numpy as np
from numpy.typing import NDArray

from crenel.errors import OperationError
from crenel.formats.file_names import display_path
from crenel.messages.message import Text, message, quantity
from crenel.metrology.transforms import Floats

COUNT_WIDTH = 20
"""Digits a header keeps free for a count that is known at last only."""
DECIMAL_COMMAS = re.compile(r"\s*([+-]?\d+(,\d+)?(e[+-]?\d+)?(\s*;\s*|\s+|$)){3,}", re.IGNORECASE)
"""A row of numbers some of which may have a decimal comma."""


def read_binary_rows(
    path: Path, file: BinaryIO, start: int, layout: np.dtype[np.void], count: int
) -> NDArray[np.void]:
    """``count`` rows from byte ``start`` on; raises ``OperationError`` if the file ends before."""
    whole = max(file.seek(0, 2) - start, 0) // max(layout.itemsize, 1)
    if whole < count:
        raise truncation_error(path, whole, count)
    file.seek(start)
    return np.fromfile(file, layout, count)


def as_doubles(column: NDArray[np.generic]) -> Floats:
    """Numbers of any kind, whatever their NaN are marked with."""
    with np.errstate(invalid="ignore"):  # of NaN that are marked as signalling
        return column.astype(np.float64)


def read_text_rows(path: Path, rows: Iterator[bytes], columns: int, count: int) -> Floats:
    """(count, columns) of the next lines; raises ``OperationError`` if they are damaged."""
    lines = list(islice(rows, count))
    if len(lines) < count:
        raise truncation_error(path, len(lines), count)
    if not lines:
        return np.zeros((0, columns))
    if has_decimal_commas(lines[0].decode("ascii", "replace")):
        raise OperationError(
            "cloud-decimal-commas",
            display_path(path),
            message("cloud-decimal-commas"),
            message("cloud-export-decimal-points"),
        )
    try:
        return np.loadtxt(lines, ndmin=2, usecols=range(columns))
    except (ValueError, IndexError) as error:
        raise format_error(path, str(error).split(";")[0]) from error


def text_lines(file: BinaryIO) -> Iterator[bytes]:
    """The lines that follow and are not blank, whatever they end with."""
    for line in file:
        yield from (part for part in line.splitlines() if part and not part.isspace())


def has_decimal_commas(line: str) -> bool:
    """Whether a line is a row of numbers like 1,5 between spaces or semicolons."""
    return "," in line and DECIMAL_COMMAS.fullmatch(line) is not None


def distinct_names(names: Sequence[str]) -> list[str]:
    """Names of columns, with their place behind those that repeat one before, except coordinates.

    Example:
        >>> distinct_names(["x", "_", "_"])
        ['x', '_', '_#2']
    """
    return [
        f"{name}#{i}" if name in names[:i] and name not in ("x", "y", "z") else name
        for i, name in enumerate(names)
    ]


def format_error(path: Path, why: Text) -> OperationError:
    """A file that is not as its format has it."""
    return OperationError("cloud-malformed", display_path(path), why, message("cloud-export-again"))


def out_of_range_error(path: Path, axis: str, farthest_mm: float, why: Text) -> OperationError:
    """A point is farther from the origin than a format allows."""
    return OperationError(
        "cloud-out-of-range",
        message(
            "cloud-point-lies-at",
            path=display_path(path),
            axis=axis,
            distance=quantity(farthest_mm, "mm"),
        ),
        why,
        message("cloud-write-ply-or-e57"),
    )


def truncation_error(path: Path, found: int, announced: int) -> OperationError:
    """A file that holds fewer points than its header says."""
    return OperationError(
        "cloud-cut-off",
        message(
            "cloud-contains-points-of", path=display_path(path), found=found, announced=announced
        ),
        message("file-cut-off"),
        message("cloud-export-again"),
    )
