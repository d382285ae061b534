"""``map.ply``: cells of a nominal surface with deviation, uncertainty and decision."""

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from crenel.formats.atomic_write import write_atomically
from crenel.metrology.transforms import Floats

MAP = "map.ply"
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


def write_map(path: Path, rows: NDArray[np.void]) -> None:
    """Writes the rows of a map, binary little-endian.

    Raises:
        OperationError: the file cannot be written.
    """
    lines = [
        "ply",
        "format binary_little_endian 1.0",
        "comment crenel map: mm, part frame; decision 0 in, 1 out, 2 undecided",
        f"element vertex {len(rows)}",
        *(f"property {TYPES[CELL[name].str[1:]]} {name}" for name in CELL.names or ()),
        "end_header",
    ]
    write_atomically(path, ("\n".join(lines) + "\n").encode() + rows.tobytes())
