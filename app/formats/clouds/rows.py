"""Rows of points after a header, binary or as text, and the refusals of a damaged file."""

from pathlib import Path
from typing import BinaryIO

import numpy as np
from numpy.typing import NDArray

from app.errors import Refusal
from app.formats.file_names import shown_path
from app.metrology.transforms import Floats

COUNT_WIDTH = 20
"""Digits a header keeps free for a count that is known at last only."""


def binary_rows(
    path: Path, file: BinaryIO, start: int, layout: np.dtype[np.void], count: int
) -> NDArray[np.void]:
    """``count`` rows from byte ``start`` on; raises ``Refusal`` where the file ends before."""
    whole = max(file.seek(0, 2) - start, 0) // max(layout.itemsize, 1)
    if whole < count:
        raise cut_off(path, whole, count)
    file.seek(start)
    return np.fromfile(file, layout, count)


def as_doubles(column: NDArray[np.generic]) -> Floats:
    """Numbers of any kind, whatever their NaN are marked with."""
    with np.errstate(invalid="ignore"):  # of NaN that are marked as signalling
        return column.astype(np.float64)


def text_rows(path: Path, file: BinaryIO, columns: int, count: int) -> Floats:
    """(count, columns) of the lines that follow; raises ``Refusal`` if malformed or cut off."""
    lines = [line for line, _ in zip(file, range(count), strict=False)]
    if len(lines) < count:
        raise cut_off(path, len(lines), count)
    if not lines:
        return np.zeros((0, columns))
    try:
        return np.loadtxt(lines, ndmin=2, usecols=range(columns))
    except (ValueError, IndexError) as error:
        raise malformed(path, str(error).split(";")[0]) from error


def malformed(path: Path, why: str) -> Refusal:
    """A file that is not as its format has it."""
    return Refusal("cloud-malformed", shown_path(path), why, "Export the cloud again")


def cut_off(path: Path, found: int, announced: int) -> Refusal:
    """A file that holds fewer points than its header says."""
    return Refusal(
        "cloud-cut-off",
        f"{shown_path(path)} holds {found} of {announced} points",
        "the file was cut off",
        "Export the cloud again",
    )
