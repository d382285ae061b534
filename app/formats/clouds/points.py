"""Points of a cloud, as every format takes and returns them."""

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
"""One point: mm in the arm frame; grey levels over the background; standard uncertainty
(k = 1) by the fit of its stripe, in µm; number of its frame in the recording."""

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
    """A cloud as read; the rest beside the points where the file has it."""

    points_mm: Floats
    """(N, 3)"""
    intensity: Floats | None = None
    """(N,)"""
    frame: Floats | None = None
    """(N,) number of the frame that each point came from."""
    uncertainty_um: Floats | None = None
    """(N,) k = 1"""


class PointSink(Protocol):
    """A file of some format that grows by pieces."""

    def write(self, points: Points) -> None:
        """Appends points; raises ``OperationError`` where the format cannot hold them."""

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
        frame: which frame they came from, one for all or (N,).
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
