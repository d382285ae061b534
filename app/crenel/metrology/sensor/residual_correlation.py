"""Scatter of the points of straight lines: beyond the stated noise, and correlation of
neighbours."""

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.transforms import Floats
from crenel.native.arguments import BOOL, F64, I64, Array, Function, Integer
from crenel.native.library import CRENEL

_alike = Function(CRENEL, "neighbours_alike", Array(F64, "n", 2), Array(F64, "n"), returns=float)
_variances = Function(
    CRENEL,
    "variances_of_lines",
    Array(I64, "n"),
    Array(I64, "n"),
    Array(BOOL, "n"),
    Array(F64, "n"),
    Array(F64, "n", 2),
    Integer(),
    Integer(),
    Array(F64, "n", written=True),
    Array(F64, 3, "n", written=True),
)


def neighbours_alike(uv_px: Floats, normalised_residuals: Floats) -> float:
    """Number of adjacent points (N,) that carry the information of one: 1 for white noise.

    The sum of the residuals' autocorrelation up to where it has decayed. ``uv_px`` (N, 2).
    """
    uv = np.ascontiguousarray(uv_px, dtype=np.float64)
    return float(_alike(uv, np.ascontiguousarray(normalised_residuals, dtype=np.float64)))


def variances_of_lines(
    off: Floats,
    line: NDArray[np.int64],
    kept: NDArray[np.bool_],
    places: Floats,
    about_mean: bool,
    fewest: int,
) -> Floats:
    """Variance (N,) of each line's points relative to the stated one: at least 1; 1 with too few
    points.

    Args:
        off: (N,) residuals over their standard deviations; line: (N,) the line number of each.
        kept: (N,) mask of those that count; places: (N, 2) their observed pixels.
        about_mean: whether an error that all points of a line share does not count as scatter.
        fewest: minimum number of points for the scatter of a line.
    """
    count = len(off)
    variances, workspace = np.empty(count), np.empty((3, count))
    order = np.argsort(line, kind="stable")
    pixels = np.ascontiguousarray(places, dtype=np.float64)
    _variances(order, line, kept, off, pixels, about_mean, fewest, variances, workspace)
    return variances
