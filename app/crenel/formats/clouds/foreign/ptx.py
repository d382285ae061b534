"""PTX: scans as grids of points in the scanner's frame, each with its pose.

Before the points stand the numbers of columns and rows, the scanner's position and axes, and the
4 × 4 transform to the common frame, transposed. Lengths are in metres. A cell of the grid without
a measurement is at 0, 0, 0.
"""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import islice
from pathlib import Path
from typing import BinaryIO

import numpy as np

from crenel.formats.clouds.points import Cloud, LeftOut
from crenel.formats.clouds.rows import format_error, read_text_rows, text_lines
from crenel.formats.csv_table import is_number
from crenel.messages.message import message
from crenel.metrology.transforms import Floats
from crenel.units import MM_PER_M

NUMBERS = (1, 1, *(3,) * 4, *(4,) * 4)
"""In each line before the points."""


def is_ptx(head: bytes) -> bool:
    """Whether a file begins with the ten lines of a PTX."""
    return _reads_as_head([line for line in head.splitlines() if line.strip()][: len(NUMBERS)])


def read_ptx(path: Path, file: BinaryIO) -> Cloud:
    """Reads all scans of a PTX into the common frame, without cells that were not measured.

    Raises:
        OperationError: malformed or cut off.
    """
    file.seek(0)
    lines = text_lines(file)
    points, missing = [np.zeros((0, 3))], 0
    while head := list(islice(lines, len(NUMBERS))):
        scan = _read_scan(path, head, lines)
        measured = scan[scan.any(axis=1)]
        missing += len(scan) - len(measured)
        transform = np.array([line.split() for line in head[-4:]], dtype=np.float64)
        points.append(measured @ transform[:3, :3] + transform[3, :3])
    cloud = Cloud(MM_PER_M * np.concatenate(points), mm_per_unit=MM_PER_M)
    return replace(cloud, left_out=LeftOut(missing=missing))


def _read_scan(path: Path, head: Sequence[bytes], lines: Iterator[bytes]) -> Floats:
    if not _reads_as_head(head):
        raise format_error(path, message("cloud-ptx-head", line=repr(head[0].decode("latin-1"))))
    return read_text_rows(path, lines, 3, int(head[0]) * int(head[1]))


def _reads_as_head(lines: Sequence[bytes]) -> bool:
    words = [line.decode("latin-1").split() for line in lines]
    return (
        tuple(map(len, words)) == NUMBERS
        and all(words[i][0].isdecimal() for i in (0, 1))
        and all(is_number(word) for line in words for word in line)
    )
