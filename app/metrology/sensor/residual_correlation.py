"""How the points of straight lines scatter: beyond what they say, and alike as neighbours."""

import numpy as np
from numpy.typing import NDArray

from app.metrology.transforms import Floats
from app.native.arguments import BOOL, F64, I64, Array, Function, Integer
from app.native.library import CRENEL

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
    """How many neighbouring points (N,) carry the information of one: 1 for white noise.

    The sum of the residuals' autocorrelation up to where it has died away. ``uv_px`` (N, 2).
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
    """Variance (N,) of each line's points beside what they say: at least 1, 1 where too few.

    Args:
        off: (N,) residuals over their deviations; line: (N,) the number of each one's line.
        kept: (N,) which of them count; places: (N, 2) pixels they were observed at.
        about_mean: whether what all points of a line share is no scatter.
        fewest: points that determine a line's scatter.
    """
    count = len(off)
    variances, workspace = np.empty(count), np.empty((3, count))
    order = np.argsort(line, kind="stable")
    pixels = np.ascontiguousarray(places, dtype=np.float64)
    _variances(order, line, kept, off, pixels, about_mean, fewest, variances, workspace)
    return variances
