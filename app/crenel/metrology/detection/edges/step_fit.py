"""The position of a step of brightness, from the pixels around it, with its standard deviation."""

import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.detection.edges.stations import EdgeStations
from crenel.metrology.transforms import Floats
from crenel.native.arguments import F64, I64, Array, Function, Integer, Real
from crenel.native.library import CRENEL

# Extent of the window from the edge: in blurs and pixels, at least three.
_REACH_BLURS, _REACH_PX, _LEAST_REACH_PX = 2.5, 1.0, 3.0
# The light of an adjacent edge extends over this many of its blurs.
_NEIGHBOUR_BLURS = 2.0
# Minimum size of the window that must remain on either side.
_NEEDED_BLURS, _NEEDED_PX = 1.5, 0.5
# The Gaussian's integral and its density, tabulated at this step of its standard deviation.
_PER_SIGMA, _OUTERMOST = 128, 9
_AT = np.arange(-_OUTERMOST * _PER_SIGMA, _OUTERMOST * _PER_SIGMA + 1) / _PER_SIGMA
_NODES = np.array(
    [
        [0.5 * math.erfc(-z / math.sqrt(2.0)) for z in _AT],
        np.exp(-0.5 * _AT**2) / math.sqrt(2.0 * math.pi),
    ]
)
# Number of pixels processed at a time.
_AT_A_TIME = 8

_measure = Function(
    CRENEL,
    "measure_steps",
    Array(F64, "height", "width"),
    Array(F64, "n", 4),
    Array(F64, "n", 3),
    Array(I64, "n"),
    Array(F64, 2, "k"),
    Real(),
    Integer(),
    Array(F64, "n", 6, written=True),
    Array(F64, 9, "most", written=True),
)


@dataclass(frozen=True)
class StepMeasurements:
    """Results of ``measure_steps`` per station, arrays (N,); NaN without a sound edge.

    ``offset_px`` along the normal and its ``sigma_px``; ``step``: height in grey levels
    from the second region to the first, and its ``step_sigma``; ``blur_px``: the
    blur's standard deviation; ``noise``: the scatter of the pixels about the fit,
    grey levels.
    """

    offset_px: Floats
    sigma_px: Floats
    step: Floats
    step_sigma: Floats
    blur_px: Floats
    noise: Floats


def with_clearance(at: EdgeStations, blur_px: float) -> EdgeStations:
    """The stations with enough clearance to adjacent edges for a blur of this standard
    deviation."""
    needed = (_NEIGHBOUR_BLURS + _NEEDED_BLURS) * blur_px + _NEEDED_PX
    return select_stations(at, at.clearance_px.min(axis=1) >= needed)


def select_stations(at: EdgeStations, keep: NDArray[np.bool_] | NDArray[np.int64]) -> EdgeStations:
    """Some of the stations."""
    return replace(
        at,
        edge=at.edge[keep],
        part=at.part[keep],
        points_mm=at.points_mm[keep],
        uv_px=at.uv_px[keep],
        normal=at.normal[keep],
        clearance_px=at.clearance_px[keep],
        length_px=at.length_px[keep],
    )


def join_stations(one: EdgeStations, other: EdgeStations) -> EdgeStations:
    """The stations of both, of the same visible parts."""
    return replace(
        one,
        edge=np.concatenate([one.edge, other.edge]),
        part=np.concatenate([one.part, other.part]),
        points_mm=np.concatenate([one.points_mm, other.points_mm]),
        uv_px=np.concatenate([one.uv_px, other.uv_px]),
        normal=np.concatenate([one.normal, other.normal]),
        clearance_px=np.concatenate([one.clearance_px, other.clearance_px]),
        length_px=np.concatenate([one.length_px, other.length_px]),
    )


def measure_steps(
    image: Floats, at: EdgeStations, blur_px: float, free_blur: bool = False
) -> StepMeasurements:
    """Sub-pixel edges at stations that are within about two pixels, or two blurs, of them.

    Least squares on the pixels themselves: nothing is interpolated, so the result does not depend
    on the orientation of an edge relative to rows and columns.

    Args:
        image: (H, W) grey levels, NaN at pixels that must not count.
        at: stations with clearance (``with_clearance``).
        blur_px: standard deviation of the picture's blur; also fitted if ``free_blur``.
    """
    reach = max(_LEAST_REACH_PX, _REACH_BLURS * blur_px + _REACH_PX)
    clearance = np.minimum(reach, at.clearance_px - _NEIGHBOUR_BLURS * blur_px)
    windows = np.column_stack([clearance, np.full(len(clearance), at.half_length_px)])
    places = np.column_stack([at.uv_px, at.normal])
    reach = np.ceil(np.hypot(clearance.max(axis=1), at.half_length_px)).astype(np.int64)
    workspace = np.empty((9, (2 * int(reach.max(initial=0)) + 1) ** 2 + _AT_A_TIME))
    found = np.empty((len(places), 6))
    unknowns = 6 if free_blur else 5
    _measure(image, places, windows, reach, _NODES, blur_px, unknowns, found, workspace)
    return StepMeasurements(*(found[:, k] for k in range(6)))
