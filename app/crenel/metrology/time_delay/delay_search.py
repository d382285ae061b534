"""The search for delay and plane over seconds, without start values, through jumps of a clock.

Each of some windows of the pass proposes planes: those of the delays that bring its points closest
to one. The plane that fits the whole pass best, by the cheapest path of the delay through it, is
the start of the fit.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from crenel.errors import OperationError
from crenel.metrology.arm.reading_interpolation import Stamps
from crenel.metrology.fitting.plane_sphere import fit_plane
from crenel.metrology.robust import sigma_from_median
from crenel.metrology.time_delay.course import CourseShape
from crenel.metrology.time_delay.delay_fit import DelayHypothesis
from crenel.metrology.time_delay.delay_path import JUMP_CELLS, UNKNOWN_COST, cheapest_path
from crenel.metrology.time_delay.plane_pass import PlanePass
from crenel.metrology.transforms import Floats

SEARCH_NS, STEP_NS = 5_000_000_000, 5_000_000
"""Delays tried before the fit."""
CELLS = 2 * SEARCH_NS // STEP_NS
FRAMES, PROPOSAL_FRAMES, WINDOW_FRAMES, LEAST_WINDOW_FRAMES = 600, 150, 60, 20
PAIRS = 3
POINTS = 2 * PAIRS
"""The points of each frame; of two that are half a line apart, the one nearer to the plane counts,
since another surface may fill a part of the line."""
CHUNK_FRAMES = 50
WINDOW_NS, MOST_WINDOWS, PROPOSALS = 4_000_000_000, 9, 2
"""Lengths and number of windows, and how many planes each proposes."""
APART_CELLS = 20
LEAST_KNOWN = 1 / 3
"""Minimum share of the frames for which a delay leaves poses of the arm."""
COARSE_MM, FINE_MM = 0.3, 0.03
"""Largest and smallest scatter of frames about the plane that the search assumes."""
CAP = 9.0
"""Cost of a frame far from the plane, in squared scatters."""
LEAST_PIECE_FRAMES = 8

Plane = tuple[Floats, float]


@dataclass(frozen=True)
class _Sample:
    """Some frames of a pass, and the poses of the arm on a grid of times around them."""

    stamps_ns: Stamps
    points: Floats
    """(F, P, 4) homogeneous, in the sensor frame."""
    poses: Floats
    """(G, 3, 4) every ``STEP_NS``; NaN if unknown."""
    begins: NDArray[np.int64]
    """(F,) place on the grid of the smallest delay."""
    share: Floats
    """(F,) by how much of a step each frame is later than that."""

    def select(self, frames: NDArray[np.int64]) -> "_Sample":
        return _Sample(
            self.stamps_ns[frames],
            self.points[frames],
            self.poses,
            self.begins[frames],
            self.share[frames],
        )

    def spread(self, frames: int) -> "_Sample":
        """Not more than some frames, evenly spread."""
        count = len(self.stamps_ns)
        return self.select(np.linspace(0, count - 1, min(frames, count)).astype(np.int64))

    def rows_at_delays(self, table: Floats, chosen: slice) -> Floats:
        """(f, CELLS + 1, ...) rows of a table over the grid, at all delays of some frames."""
        at = self.begins[chosen, None] + np.arange(CELLS + 2)
        share = self.share[chosen].reshape(-1, *([1] * table.ndim))
        rows = table[at]
        return np.asarray((1 - share) * rows[:, :-1] + share * rows[:, 1:])

    def points_at(self, cells: NDArray[np.int64]) -> Floats:
        """(F, P, 3) in the arm frame, each frame at the delay of its cell."""
        share = self.share[:, None, None] + 0.5
        before, within = np.divmod(share, 1.0)
        at = self.begins + cells + before[:, 0, 0].astype(np.int64)
        poses = (1 - within) * self.poses[at] + within * self.poses[at + 1]
        return np.asarray(np.einsum("fij,fpj->fpi", poses, self.points))

    def pose_share(self, path: NDArray[np.int64]) -> float:
        """Share of the frames that have a pose at the delays of a path."""
        return float(np.isfinite(self.points_at(path)).all(axis=(1, 2)).mean())


def search_delay(passed: PlanePass) -> DelayHypothesis | None:
    """Start values of the delay's course and the plane.

    Args:
        passed: frames with points.

    Returns:
        A course with drift, and with the jumps that are seen so coarsely; None if no delay leaves
        poses of the arm around enough frames.
    """
    whole = _take_sample(passed)
    few, best = whole.spread(PROPOSAL_FRAMES), None
    for plane, cell in _propose_planes(whole):
        path, cost = cheapest_path(_cell_costs(few, plane, COARSE_MM))
        if not few.pose_share(path) > LEAST_KNOWN:
            path, cost = np.full(len(path), cell), CAP
        if best is None or cost < best[0]:
            best = cost, _refit_plane(few, path) or plane, path
    if best is None:
        return None
    _, plane, path = best
    scatter_mm = COARSE_MM
    path = path[np.linspace(0, len(path) - 1, len(whole.stamps_ns)).round().astype(np.int64)]
    for _ in range(2):
        tried, _ = cheapest_path(_cell_costs(whole, plane, scatter_mm))
        if not whole.pose_share(tried) > LEAST_KNOWN:
            break
        path = tried
        plane = _refit_plane(whole, path) or plane
        off = np.abs(whole.points_at(path) @ plane[0] - plane[1])
        near = off[off < 3 * COARSE_MM]
        scatter = sigma_from_median(near) if len(near) else COARSE_MM
        scatter_mm = float(np.clip(scatter, FINE_MM, COARSE_MM))
    return _course_of_path(whole.stamps_ns, path, plane)


def _take_sample(passed: PlanePass) -> _Sample:
    count = len(passed.stamps_ns)
    chosen = np.linspace(0, count - 1, min(FRAMES, count)).round().astype(np.int64)
    first, last = passed.first[chosen], passed.first[chosen + 1] - 1
    rows = np.linspace(first, last, POINTS, axis=1).round().astype(np.int64)
    points = np.concatenate([passed.points_mm[rows], np.ones((*rows.shape, 1))], axis=2)
    stamps_ns = passed.stamps_ns[chosen]
    begin_ns = int(stamps_ns[0]) - SEARCH_NS
    begins, rest_ns = np.divmod(stamps_ns - SEARCH_NS - begin_ns, STEP_NS)
    grid_ns = begin_ns + STEP_NS * np.arange(int(begins[-1]) + CELLS + 2, dtype=np.int64)
    return _Sample(
        stamps_ns, points, passed.poses_at(grid_ns)[:, :3], begins, rest_ns / float(STEP_NS)
    )


def _propose_planes(whole: _Sample) -> Iterator[tuple[Plane, int]]:
    """Planes, each with the delay at which it was found."""
    for window in _windows(whole):
        for cell in _flattest_cells(window):
            plane = _refit_plane(window, np.full(len(window.stamps_ns), cell))
            if plane is not None:
                yield plane, cell


def _windows(whole: _Sample) -> Iterator[_Sample]:
    """The whole pass, and parts of it that a jump may leave whole."""
    stamps_ns = whole.stamps_ns
    yield whole.spread(WINDOW_FRAMES)
    first, last = int(stamps_ns[0]), int(stamps_ns[-1])
    count = min(MOST_WINDOWS, 2 * (last - first) // WINDOW_NS)
    for begin in np.linspace(first, last - WINDOW_NS, max(count, 0)):
        inside = np.flatnonzero((stamps_ns >= begin) & (stamps_ns <= begin + WINDOW_NS))
        if len(inside) >= LEAST_WINDOW_FRAMES:
            yield whole.select(inside).spread(WINDOW_FRAMES)


def _flattest_cells(window: _Sample) -> list[int]:
    """The delays at which the points of a window lie closest to one plane."""
    poses = window.rows_at_delays(window.poses, slice(None))[:, :-1]
    frames, cells = poses.shape[:2]
    # (F, 3 K, P) by matrix products, which are several times as fast as an einsum
    seen = poses.reshape(frames, -1, 4) @ window.points.swapaxes(1, 2)
    points = seen.reshape(frames, cells, 3, POINTS).transpose(1, 2, 0, 3).reshape(cells, 3, -1)
    known = np.isfinite(poses).all(axis=(2, 3))
    count = known.sum(axis=0)
    points = np.where(np.isfinite(points), points, 0.0)
    total = np.maximum(count * POINTS, 1)[:, None]
    centre = points.sum(axis=2) / total
    moments = points @ points.swapaxes(1, 2) / total[:, :, None]
    moments -= centre[:, :, None] * centre[:, None]
    flatness = np.linalg.eigvalsh(moments)[:, 0]
    flatness[count < max(LEAST_WINDOW_FRAMES, LEAST_KNOWN * frames)] = np.inf
    found: list[int] = []
    for _ in range(PROPOSALS):
        best = int(np.argmin(flatness))
        if not np.isfinite(flatness[best]):
            break
        found.append(best)
        flatness[max(best - APART_CELLS, 0) : best + APART_CELLS] = np.inf
    return found


def _refit_plane(sample: _Sample, path: NDArray[np.int64]) -> Plane | None:
    """The plane of the points at the delays of a path; None where few have a pose."""
    points = sample.points_at(path).reshape(-1, 3)
    points = points[np.isfinite(points).all(axis=1)]
    try:
        plane = fit_plane(points)
    except OperationError:  # too few, or all on one line
        return None
    return plane.normal, plane.offset_mm


def _cell_costs(sample: _Sample, plane: Plane, scatter_mm: float) -> Floats:
    """(F, CELLS) mean squared distance of a frame's pairs of points from the plane, in squared
    scatters and at most ``CAP``, at the best delay within each cell."""
    table = np.asarray(np.einsum("i,gij->gj", plane[0], sample.poses))
    found = []
    for start in range(0, len(sample.stamps_ns), CHUNK_FRAMES):
        chosen = slice(start, start + CHUNK_FRAMES)
        off = sample.points[chosen] @ sample.rows_at_delays(table, chosen).swapaxes(1, 2)
        off = (off - plane[1]) / scatter_mm
        near = np.minimum(off[:, :, :-1] ** 2, off[:, :, 1:] ** 2)
        near[off[:, :, :-1] * off[:, :, 1:] < 0] = 0.0
        cost = np.minimum(np.minimum(near[:, :PAIRS], near[:, PAIRS:]), CAP).mean(axis=1)
        found.append(np.where(np.isfinite(cost), cost, UNKNOWN_COST))
    return np.concatenate(found)


def _course_of_path(stamps_ns: Stamps, path: NDArray[np.int64], plane: Plane) -> DelayHypothesis:
    """The course whose jumps are those of the path between pieces that last."""
    begins = [0, *(np.flatnonzero(np.abs(np.diff(path)) >= JUMP_CELLS) + 1), len(path)]
    kept = [(first, last) for first, last in pairwise(begins) if last - first >= LEAST_PIECE_FRAMES]
    frames = np.concatenate([np.arange(*piece) for piece in kept] or [np.arange(len(path))])
    jumps_ns = tuple(
        int(stamps_ns[last - 1] + stamps_ns[first]) // 2
        for (_, last), (first, _) in pairwise(kept)
        if abs(int(path[first]) - int(path[last - 1])) >= JUMP_CELLS
    )
    shape = CourseShape(int(stamps_ns[-1]), True, jumps_ns)
    delays_ns = (path[frames] + 0.5) * STEP_NS - SEARCH_NS
    values = np.linalg.lstsq(shape.basis(stamps_ns[frames]), delays_ns, rcond=None)[0]
    return DelayHypothesis(shape, values, *plane)
