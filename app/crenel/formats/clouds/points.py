"""Points of a cloud, as every format accepts and returns them."""

from dataclasses import dataclass, replace
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.transforms import Floats
from crenel.native.arguments import F64, I64, U8, Array, Function
from crenel.native.library import CRENEL

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


def positions_of(points: Points) -> Floats:
    """Positions (N, 3) of points, mm."""
    return np.column_stack([points[axis] for axis in "xyz"])


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


STANDS_FOR_NONE = 10
"""A place that occurs so many times as often as most stands for points without a measurement."""


@dataclass(frozen=True)
class LeftOut:
    """How many points of a file are none that were measured."""

    deleted: int = 0
    """The file marks them as deleted, withheld or invalid."""
    missing: int = 0
    """They have no coordinates, or those that stand for none, such as (0, 0, 0)."""
    repeated: int = 0
    """The same point is there already."""


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
    left_out: LeftOut = LeftOut()
    """What of the file was left out beside these points."""
    mm_per_unit: float = 1.0
    """The unit of the numbers in the file, by which they became mm."""


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


def cloud_from_columns(columns: dict[str, Floats], deleted: int = 0) -> Cloud:
    """The cloud of a table's columns (N,) by name, of which ``deleted`` rows were left out."""
    return Cloud(
        np.column_stack([columns[axis] for axis in "xyz"]).astype(np.float64, copy=False),
        columns.get("intensity"),
        columns.get("frame"),
        columns.get("uncertainty_um"),
        LeftOut(deleted=deleted),
    )


def leave_out_unmeasured(cloud: Cloud) -> Cloud:
    """The cloud without points at (0, 0, 0) and without repetitions, which it counts.

    Of a place that occurs far more often than most, nothing is kept: it stands for points that
    were not measured, as (0, 0, 0) does in another frame.
    """
    points = cloud.points_mm + 0.0  # makes -0 equal to 0
    is_set = points.any(axis=1)
    order = np.lexsort(points[is_set].T)  # stable: of equal ones, the first comes first
    ordered = points[is_set][order]
    starts = np.flatnonzero(np.r_[True, (ordered[1:] != ordered[:-1]).any(axis=1)][: len(ordered)])
    counts = np.diff(np.r_[starts, len(ordered)])
    is_place = counts <= STANDS_FOR_NONE * np.median(counts) if len(counts) else counts > 0
    kept = np.zeros(len(points), dtype=np.bool_)
    kept[np.flatnonzero(is_set)[order[starts[is_place]]]] = True
    missing = int(np.sum(~is_set) + np.sum(counts[~is_place]))
    repeated = int(np.sum(counts[is_place] - 1))
    if not missing + repeated:
        return cloud
    return replace(
        cloud,
        points_mm=cloud.points_mm[kept],
        intensity=None if cloud.intensity is None else cloud.intensity[kept],
        frame=None if cloud.frame is None else cloud.frame[kept],
        uncertainty_um=None if cloud.uncertainty_um is None else cloud.uncertainty_um[kept],
        left_out=replace(cloud.left_out, missing=missing, repeated=repeated),
    )


def scale_cloud(cloud: Cloud, mm_per_unit: float) -> Cloud:
    """The cloud if the numbers of its file have another unit than it states."""
    if mm_per_unit == cloud.mm_per_unit:
        return cloud
    points_mm = cloud.points_mm * (mm_per_unit / cloud.mm_per_unit)
    return replace(cloud, points_mm=points_mm, mm_per_unit=mm_per_unit)
