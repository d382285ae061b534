"""Points of a cloud, as every format accepts and returns them."""

from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from app.metrology.transforms import Floats
from app.native.arguments import F64, I64, U8, Array, Function
from app.native.library import CRENEL

POINT = np.dtype(
    [
        ("x", "<f8"),
        ("y", "<f8"),
        ("z", "<f8"),
        ("intensity", "<f4"),
        ("uncertainty_um", "<f4"),
        ("frame", "<i4"),
    ]
)
"""One point: mm in the arm frame; grey levels above the background; standard uncertainty (k = 1)
from the fit of its stripe, in µm; number of its frame in the recording."""

Points = NDArray[np.void]
"""(N,) of ``POINT``."""

_pack_points = Function(
    CRENEL,
    "pack_points",
    Array(F64, "n", 3),
    Array(F64, "n"),
    Array(F64, "n"),
    Array(I64, "n"),
    Array(U8, "n", POINT.itemsize, written=True),
    returns=int,
)


@dataclass(frozen=True)
class Cloud:
    """A cloud that was read; values other than the points are present if the file has them."""

    points_mm: Floats
    """(N, 3)"""
    intensity: Floats | None = None
    """(N,)"""
    frame: Floats | None = None
    """(N,) frame number of each point."""
    uncertainty_um: Floats | None = None
    """(N,) k = 1"""


class PointSink(Protocol):
    """A file of some format to which chunks are appended."""

    def write(self, points: Points) -> None:
        """Appends points; raises ``OperationError`` if the format cannot hold them."""

    def finish(self) -> None:
        """Completes the file."""


def pack_points(
    points_mm: Floats,
    intensity: Floats,
    uncertainty_um: Floats,
    frame: int | Floats | NDArray[np.int64],
) -> Points:
    """Records of points (N, 3); rows with NaN are left out.

    Args:
        intensity, uncertainty_um: (N,).
        frame: frame number, one for all points or (N,).
    """
    records = np.empty(len(points_mm), POINT)
    numbers = np.full(len(points_mm), frame, dtype=np.int64)
    kept = _pack_points(
        np.ascontiguousarray(points_mm, dtype=np.float64),
        np.ascontiguousarray(intensity, dtype=np.float64),
        np.ascontiguousarray(uncertainty_um, dtype=np.float64),
        numbers,
        records.view(np.uint8).reshape(-1, POINT.itemsize),
    )
    return records[:kept]


def cloud_from_columns(columns: dict[str, Floats]) -> Cloud:
    """The cloud of a table's columns (N,) by name."""
    return Cloud(
        np.column_stack([columns[axis] for axis in "xyz"]).astype(np.float64, copy=False),
        columns.get("intensity"),
        columns.get("frame"),
        columns.get("uncertainty_um"),
    )
