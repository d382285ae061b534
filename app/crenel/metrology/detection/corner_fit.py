"""Corners of the block at the intersections of measured edges, each with its covariance."""

from dataclasses import dataclass

import numpy as np

from crenel.metrology.detection.edges.measure_all import EdgeMeasurements
from crenel.metrology.detection.visibility import find_visible_edges, visible_corners
from crenel.metrology.sensor.camera import project
from crenel.metrology.targets.crenellated_block import corners as corners_of
from crenel.metrology.transforms import Floats

# Edges that cross at a smaller angle do not give a corner.
_FLATTEST_RAD = np.deg2rad(8.0)
_WORST_CORNER_PX = 1.5
# Edges that meet this far from the predicted corner do not give one: in px, and in standard
# deviations.
_FURTHEST_PX, _OUTLIER_SIGMAS = 1.0, 5.0
# The covariance of corners that are off by more standard deviations than this is increased in
# proportion.
_USUAL = 2.0
# A measured edge that is skewed by more than this against the predicted one, over its length and
# its own standard deviation, is a different edge.
_ASKEW_SIGMAS, _ASKEW_PX = 4.0, 0.7
# Minimum number of points that show the direction of an edge, and minimum length they cover, px.
_POINTS, _LENGTH_PX = 3, 15.0


@dataclass(frozen=True)
class Corner:
    """A corner of the block in the image, px, with its covariance (2, 2)."""

    name: str
    u: float
    v: float
    covariance_px2: Floats


def fit_corners(measured: EdgeMeasurements) -> tuple[Corner, ...]:
    """Corners where two measured edges meet, with their covariance."""
    camera, frame, block = measured.camera, measured.frame, measured.frame.block
    parts = find_visible_edges(frame, camera.centre_mm)
    begin = frame.starts_mm[parts.edge]
    along = frame.ends_mm[parts.edge] - begin
    ends = np.stack(
        [begin + parts.start[:, None] * along, begin + parts.end[:, None] * along], axis=1
    )
    lines = {}
    for part in np.unique(measured.at.part[measured.used]):
        line = _fit_line(measured, int(part))
        if line is not None:
            lines[int(part)] = line
    found = []
    shown = visible_corners(block, camera.centre_mm)
    for name, point in corners_of(block).items():
        if name not in shown:
            continue
        at = project(camera, point[None])[0]
        if (at < 0).any() or at[0] > camera.width_px - 1 or at[1] > camera.height_px - 1:
            continue
        touching = np.flatnonzero((np.abs(ends - point).max(axis=2) < 1e-6).any(axis=1))
        met = [lines[int(k)] for k in touching if int(k) in lines]
        corner = _intersect_lines(name, at, met, max(_FURTHEST_PX, measured.blur_px))
        if corner is not None:
            found.append(corner)
    return tuple(found)


@dataclass(frozen=True)
class _EdgeLine:
    """The measured edge of one part as offsets, linear along the part, from the predicted edge."""

    middle: Floats  # (2,) px, where the offset is known best
    direction: Floats  # (2,)
    offset_px: float
    slope: float
    variance_offset: float
    variance_slope: float
    reach_px: tuple[
        float, float
    ]  # along the part, as far beyond either end as the part was measured


def _fit_line(measured: EdgeMeasurements, part: int) -> _EdgeLine | None:
    rows = np.flatnonzero(measured.used & (measured.at.part == part))
    length = measured.at.length_px[rows]
    if len(rows) < _POINTS and length.sum() < _LENGTH_PX:
        return None
    uv, off = measured.at.uv_px[rows], measured.off_px[rows]
    weight = 1 / measured.sigma_px[rows] ** 2
    normal = measured.at.normal[rows].mean(axis=0)
    direction = np.array([normal[1], -normal[0]]) / np.linalg.norm(normal)
    middle = weight @ uv / weight.sum()
    s = (uv - middle) @ direction
    first, last, spread = float(s.min()), float(s.max()), float(weight @ s**2)
    slope = 0.0
    if len(rows) < _POINTS:
        # Each point gathers so much light that there are few: the edge follows the prediction, with
        # the uncertainty of that much light in many points.
        first, last = first - length[s.argmin()] / 2, last + length[s.argmax()] / 2
        spread = float(weight.sum() * length.sum() ** 2 / 12)
    elif spread <= 0:
        return None
    else:
        slope = float((weight * s) @ off / spread)
        if abs(slope) > max(_ASKEW_SIGMAS / np.sqrt(spread), _ASKEW_PX / (last - first)):
            return None
    return _EdgeLine(
        middle,
        direction,
        float(weight @ off / weight.sum()),
        slope,
        float(1 / weight.sum()),
        float(1 / spread),
        (2 * first - last, 2 * last - first),
    )


def _intersect_lines(
    name: str, at: Floats, lines: list[_EdgeLine], furthest_px: float
) -> Corner | None:
    """Weighted least-squares intersection of the edges that meet at the predicted ``at`` (2,).

    None if it is further from there than ``furthest_px``, or than its standard deviation explains.
    """
    information = np.zeros((2, 2))
    pull = np.zeros(2)
    used: list[_EdgeLine] = []
    for line in lines:
        s = float((at - line.middle) @ line.direction)
        if not line.reach_px[0] < s < line.reach_px[1]:
            continue
        used.append(line)
        variance = line.variance_offset + s**2 * line.variance_slope
        normal = np.array([-line.direction[1], line.direction[0]])
        information += np.outer(normal, normal) / variance
        pull += normal * (line.offset_px + s * line.slope) / variance
    crossings = [
        abs(a.direction[0] * b.direction[1] - a.direction[1] * b.direction[0])
        for a in used
        for b in used
    ]
    if not crossings or max(crossings) < np.sin(_FLATTEST_RAD):
        return None
    covariance: Floats = np.asarray(np.linalg.inv(information), dtype=np.float64)
    if float(np.linalg.eigvalsh(covariance)[-1]) > _WORST_CORNER_PX**2:
        return None
    shift = covariance @ pull
    # The camera follows from all edges; a shadow beside a corner moves only that corner.
    squares = float(shift @ information @ shift)
    if float(np.hypot(*shift)) > furthest_px or squares > _OUTLIER_SIGMAS**2:
        return None
    u, v = at + shift
    return Corner(name, float(u), float(v), covariance * max(1.0, squares / _USUAL**2))
