"""The points of a LAS or LAZ, as its libraries read them."""

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np

from crenel.errors import OperationError
from crenel.formats.clouds.las.layout import load_laspy
from crenel.formats.clouds.rows import format_error
from crenel.messages.message import message
from crenel.metrology.transforms import Floats

CHUNK_POINTS = 1 << 20
NAMES = ("x", "y", "z", "intensity", "withheld")


@dataclass(frozen=True)
class LasTable:
    """All points of a file, whatever their flags."""

    names: tuple[str, ...]
    """The names of the columns."""
    rows: Floats
    """(N, columns)"""
    announced: int
    """Points by the header."""


class LasReader:
    """The points of an open file, in pieces."""

    def __init__(self, reader: Any) -> None:
        self._reader = reader
        self.announced = int(reader.header.point_count)
        extra = set(reader.header.point_format.extra_dimension_names)
        self.names = (*NAMES, *sorted(extra & {"frame", "uncertainty_um"}))

    def pieces(self) -> Iterator[Floats]:
        """Some (N, columns) after another."""
        for piece in self._reader.chunk_iterator(CHUNK_POINTS):
            yield np.column_stack([np.array(piece[name], dtype=np.float64) for name in self.names])

    def read_all(self) -> LasTable:
        """All of them at once."""
        rows = np.concatenate([np.zeros((0, len(self.names))), *self.pieces()])
        return LasTable(self.names, rows, self.announced)


@contextmanager
def open_las(path: Path, file: BinaryIO) -> Iterator[LasReader]:
    """A LAS or LAZ to be read; errors are those of the libraries."""
    with load_laspy(path).open(file, closefd=False) as reader:
        yield LasReader(reader)


def format_las_error(path: Path, reason: str) -> OperationError:
    """What a library says of a damaged file, as a refusal."""
    return format_error(path, message("cloud-not-complete-format", format="LAS/LAZ", reason=reason))
