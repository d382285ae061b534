"""XYZ: one point a line, as text."""

import warnings
from pathlib import Path
from typing import BinaryIO

import numpy as np
from numpy.typing import NDArray

from app.files.cloud_points import Cloud, Points, cloud_of
from app.metrology.compiled import kernel
from app.metrology.frames import Floats
from app.metrology.refusal import Refusal

COLUMNS = {"x": 4, "y": 4, "z": 4, "intensity": 1, "uncertainty_um": 2, "frame": 0}
"""In their order, with their decimals: coordinates to 0.1 µm."""
HEAD = f"# {' '.join(COLUMNS)}\n"
LONGEST_LINE = 21 * len(COLUMNS)
FARTHEST_MM = 1e9


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
            raise Refusal(
                "cloud-out-of-range",
                f"{self._path}: a point lies at {farthest:.3g} mm",
                f"XYZ is written up to {FARTHEST_MM:.0e} mm",
                "Write PLY",
            )
        decimals = np.array(list(COLUMNS.values()))
        scaled = np.rint(np.nan_to_num(table) * 10.0**decimals).clip(-(2.0**62), 2.0**62)
        text = np.empty(len(points) * LONGEST_LINE, dtype=np.uint8)
        length = _format(scaled.astype(np.int64), decimals, text)
        self._file.write(text[:length].data)

    def finish(self) -> None:
        """Nothing is held back."""


@kernel
def _format(scaled: NDArray[np.int64], decimals: NDArray[np.int64], text: NDArray[np.uint8]) -> int:
    """Writes numbers (N, C) as decimals into ``text``; how many bytes they take."""
    at = 0
    digits = np.empty(24, dtype=np.uint8)
    for row in scaled:
        for column in range(len(row)):
            value, places = row[column], decimals[column]
            if value < 0:
                text[at] = 45
                at += 1
                value = -value
            count = 0
            while value > 0 or count <= places:
                if count == places and places > 0:
                    digits[count] = 46
                    count += 1
                    places = -1
                digits[count] = 48 + value % 10
                value //= 10
                count += 1
            for i in range(count - 1, -1, -1):
                text[at] = digits[i]
                at += 1
            text[at] = 32
            at += 1
        text[at - 1] = 10
    return at


def read_xyz(path: Path) -> Cloud:
    """Reads lines of x y z and more; what is more is known where a first line names it."""
    with open(path, encoding="utf-8-sig", errors="replace") as text:
        start = text.read(4096)
    lines = [line for line in start.splitlines() if line.strip() and line[0] not in "#/"]
    if not lines or "\0" in start:
        why = "it is no cloud that is known here" if lines else "it is empty"
        raise Refusal(
            "cloud-unreadable", str(path), why, "Give a .ply, .pcd, .e57, .xyz, .las or .laz cloud"
        )
    delimiter = next((sign for sign in ";," if sign in lines[0]), None)
    skip = 0 if _is_point(lines[0], delimiter) else start.splitlines().index(lines[0]) + 1
    names = tuple(COLUMNS) if start.startswith(HEAD) else ("x", "y", "z")
    try:
        with warnings.catch_warnings(action="ignore"):  # of a file without rows
            table: Floats = np.loadtxt(
                path,
                comments=("#", "//"),
                delimiter=delimiter,
                usecols=range(len(names)),
                ndmin=2,
                skiprows=skip,
                encoding="utf-8-sig",
            ).reshape(-1, len(names))
    except (ValueError, IndexError) as error:
        raise Refusal(
            "cloud-unreadable",
            str(path),
            f"a line of x y z numbers is expected, but {str(error).split(';')[0]}",
            "Give a .ply or .xyz cloud",
        ) from error
    return cloud_of({name: table[:, i] for i, name in enumerate(names)})


def _is_point(line: str, delimiter: str | None) -> bool:
    try:
        return len([float(cell) for cell in line.split(delimiter)[:3]]) == 3
    except ValueError:
        return False
