"""``map.ply``: cells of a nominal surface with deviation, uncertainty and decision."""

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from crenel.formats.atomic_write import write_atomically
from crenel.metrology.transforms import Floats

MAP = "map.ply"
END = "end_header"
CELL = np.dtype(
    [
        ("x", "<f8"),
        ("y", "<f8"),
        ("z", "<f8"),
        ("deviation_um", "<f4"),
        ("uncertainty_um", "<f4"),
        ("decision", "u1"),
        ("points", "<i4"),
        ("frames", "<i4"),
    ]
)
"""Place on the nominal surface, mm, part frame; mean deviation, outward positive; standard
uncertainty (k = 1), NaN where it is not known; 0 in, 1 out, 2 undecided; points and frames."""
TYPES = {"f8": "double", "f4": "float", "u1": "uchar", "i4": "int"}


def pack_cells(
    at_mm: Floats,
    deviation_mm: Floats,
    standard_uncertainty_mm: Floats,
    decisions: NDArray[np.uint8],
    points: NDArray[np.int64],
    frames: NDArray[np.int64],
) -> NDArray[np.void]:
    """Rows (C,) of a map."""
    rows = np.zeros(len(at_mm), CELL)
    for k, axis in enumerate("xyz"):
        rows[axis] = at_mm[:, k]
    rows["deviation_um"], rows["uncertainty_um"] = 1e3 * deviation_mm, 1e3 * standard_uncertainty_mm
    rows["decision"], rows["points"], rows["frames"] = decisions, points, frames
    return rows


def map_bytes(rows: NDArray[np.void]) -> bytes:
    """The rows of a map as a file, binary little-endian."""
    lines = [
        "ply",
        "format binary_little_endian 1.0",
        "comment crenel map: mm, part frame; decision 0 in, 1 out, 2 undecided",
        f"element vertex {len(rows)}",
        *(f"property {TYPES[CELL[name].str[1:]]} {name}" for name in CELL.names or ()),
        END,
    ]
    return ("\n".join(lines) + "\n").encode() + rows.tobytes()


def rows_of_map(content: bytes) -> NDArray[np.void]:
    """The rows of a file that ``map_bytes`` made; raises ``ValueError`` of another one."""
    _, found, rows = content.partition(f"\n{END}\n".encode())
    if not found:
        raise ValueError("no map")
    return np.frombuffer(rows, CELL)


def write_map(path: Path, rows: NDArray[np.void]) -> None:
    """Writes the rows of a map.

    Raises:
        OperationError: the file cannot be written.
    """
    write_atomically(path, map_bytes(rows))
