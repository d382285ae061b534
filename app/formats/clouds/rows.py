"""Rows of points after a header, binary or as text, and refusals that several formats share."""

import re
from pathlib import Path
from typing import BinaryIO

import numpy as np
from numpy.typing import NDArray

from app.errors import OperationError
from app.formats.file_names import display_path
from app.messages.message import Text, message, quantity
from app.metrology.transforms import Floats

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


def read_text_rows(path: Path, file: BinaryIO, columns: int, count: int) -> Floats:
    """(count, columns) of the lines that follow; raises ``OperationError`` if they are damaged."""
    lines = [line for line, _ in zip(file, range(count), strict=False)]
    if len(lines) < count:
        raise truncation_error(path, len(lines), count)
    if not lines:
        return np.zeros((0, columns))
    refuse_decimal_commas(path, lines[0].decode("ascii", "replace"))
    try:
        return np.loadtxt(lines, ndmin=2, usecols=range(columns))
    except (ValueError, IndexError) as error:
        raise format_error(path, str(error).split(";")[0]) from error


def refuse_decimal_commas(path: Path, line: str) -> None:
    """Raises ``OperationError`` for a row of numbers like 1,5 between spaces or semicolons."""
    if "," in line and DECIMAL_COMMAS.fullmatch(line):
        raise OperationError(
            "cloud-decimal-commas",
            display_path(path),
            message("cloud-decimal-commas"),
            message("cloud-export-decimal-points"),
        )


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
