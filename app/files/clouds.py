"""Point clouds: PLY written in pieces, PLY and XYZ text read."""

import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO

import numpy as np

from app.files.atomic import atomic_file
from app.files.failures import files_refused
from app.files.ply import find_vertices, read_vertices
from app.metrology.frames import Floats
from app.metrology.refusal import Refusal

VERTEX = np.dtype(
    [
        ("x", "<f8"),
        ("y", "<f8"),
        ("z", "<f8"),
        ("intensity", "<f4"),
        ("sigma_px", "<f4"),
        ("frame", "<i4"),
    ]
)
PLY_TYPES = {"f8": "double", "f4": "float", "i4": "int"}
COUNT_WIDTH = 20
FARTHEST_MM = 1e7
"""Nothing that an arm measures lies further away."""


@dataclass(frozen=True)
class Cloud:
    """A cloud as read; ``intensity`` and ``frame`` where the file has them."""

    points_mm: Floats
    """(N, 3)"""
    intensity: Floats | None = None
    """(N,)"""
    frame: Floats | None = None
    """(N,) number of the frame that each point came from."""


class PlyWriter:
    """Appends points to an open PLY file; see ``ply_writer``."""

    def __init__(self, file: BinaryIO) -> None:
        self._file = file
        self.points = 0
        file.write(_header(0))

    def write(
        self, points_mm: Floats, intensity: Floats, sigma_px: Floats, frame: int | Floats
    ) -> None:
        """Appends points (N, 3); rows with NaN are left out.

        Args:
            intensity, sigma_px: (N,) as of the stripe.
            frame: which frame they came from, one for all or (N,).
        """
        vertices = np.empty(len(points_mm), VERTEX)
        for i, axis in enumerate("xyz"):
            vertices[axis] = points_mm[:, i]
        vertices["intensity"], vertices["sigma_px"] = intensity, sigma_px
        vertices["frame"] = frame
        vertices = vertices[np.isfinite(points_mm).all(axis=1)]
        self._file.write(vertices.tobytes())
        self.points += len(vertices)

    def finish(self) -> None:
        """Puts the final count into the header."""
        self._file.seek(0)
        self._file.write(_header(self.points))


@contextmanager
def ply_writer(path: Path) -> Iterator[PlyWriter]:
    """A PLY file (binary little-endian) to append to, which appears once it is complete.

    Raises:
        Refusal: the file cannot be written.
    """
    with atomic_file(path) as file:
        writer = PlyWriter(file)
        yield writer
        writer.finish()


def read_cloud(path: Path) -> Cloud:
    """Reads a PLY (binary of either order, or ascii) or an XYZ text file.

    Raises:
        Refusal: missing, cut off, malformed, or without points.
    """
    with files_refused(path), open(path, "rb") as file:
        is_ply = file.read(4).rstrip() == b"ply"
        cloud = _read_ply(path, file) if is_ply else _read_xyz(path)
    if not len(cloud.points_mm):
        raise Refusal("cloud-empty", str(path), "it holds no points", "Scan the gauge again")
    largest = float(
        np.max(np.abs(cloud.points_mm), initial=0.0, where=np.isfinite(cloud.points_mm))
    )
    if largest > FARTHEST_MM:
        raise Refusal(
            "cloud-too-far",
            f"{path} has a coordinate of {largest:.3g} mm",
            f"an arm measures within {FARTHEST_MM:.0e} mm",
            "Give a cloud in millimetres",
        )
    return cloud


def _header(count: int) -> bytes:
    """The header, of one length whatever the count: a comment takes up the slack."""
    digits = str(count)
    lines = [
        "ply",
        "format binary_little_endian 1.0",
        "comment crenel cloud: mm, arm frame " + "." * (COUNT_WIDTH - len(digits)),
        f"element vertex {digits}",
        *(f"property {PLY_TYPES[VERTEX[name].str[1:]]} {name}" for name in VERTEX.names or ()),
        "end_header",
    ]
    return ("\n".join(lines) + "\n").encode()


def _read_ply(path: Path, file: BinaryIO) -> Cloud:
    vertices = read_vertices(path, file, find_vertices(path, file))
    return Cloud(
        np.column_stack([vertices[axis] for axis in "xyz"]).astype(np.float64, copy=False),
        vertices.get("intensity"),
        vertices.get("frame"),
    )


def _read_xyz(path: Path) -> Cloud:
    with open(path, encoding="utf-8-sig", errors="replace") as text:
        start = text.read(4096)
    lines = [line for line in start.splitlines() if line.strip() and line[0] not in "#/"]
    if not lines or "\0" in start:
        why = "it is neither PLY nor XYZ text" if lines else "it is empty"
        raise Refusal("cloud-unreadable", str(path), why, "Give a .ply or .xyz cloud")
    delimiter = next((sign for sign in ";," if sign in lines[0]), None)
    skip = 0 if _is_point(lines[0], delimiter) else start.splitlines().index(lines[0]) + 1
    try:
        with warnings.catch_warnings(action="ignore"):  # of a file without rows
            points = np.loadtxt(
                path,
                comments=("#", "//"),
                delimiter=delimiter,
                usecols=(0, 1, 2),
                ndmin=2,
                skiprows=skip,
                encoding="utf-8-sig",
            )
    except (ValueError, IndexError) as error:
        raise Refusal(
            "cloud-unreadable",
            str(path),
            f"a line of x y z numbers is expected, but {str(error).split(';')[0]}",
            "Give a .ply or .xyz cloud",
        ) from error
    return Cloud(points.reshape(-1, 3))


def _is_point(line: str, delimiter: str | None) -> bool:
    try:
        return len([float(cell) for cell in line.split(delimiter)[:3]]) == 3
    except ValueError:
        return False
