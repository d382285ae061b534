"""What hides the corners of a board that a picture does not show."""

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.chessboard.corner_fit import window_radius_px
from crenel.metrology.chessboard.perspective import (
    fit_perspective,
    map_places,
    perspective_steps_px,
)
from crenel.metrology.image import Image, saturation_level
from crenel.metrology.robust import median
from crenel.metrology.transforms import Floats

Cause = Literal["outside", "laser", "glare", "unknown"]

# Around a corner, in shares of the distance to the next one and at least in px: what is looked at.
AROUND_SHARE, LEAST_AROUND_PX = 0.25, 3.0
# Share of it that laser light spoils, or that is clipped: both white squares are half of it.
LASER_SHARE, CLIPPED_SHARE = 0.15, 0.7
# Share of a row or column of corners that one cause must explain.
LEAST_OF_SIDE = 0.5


@dataclass(frozen=True)
class CornerGrid:
    """The corners found in a picture: N places (column, row) counted from anywhere, and pixels."""

    image: Image
    laser: NDArray[np.bool_]  # (H, W) pixels that the laser's line spoils
    places: NDArray[np.int64]  # (N, 2)
    uv_px: Floats  # (N, 2)

    @property
    def extent(self) -> NDArray[np.int64]:
        """(2,) number of columns and rows; 0 where there is no corner."""
        if not len(self.places):
            return np.zeros(2, np.int64)
        return np.asarray(np.ptp(self.places, axis=0) + 1)

    def spacing_px(self) -> float:
        """Usual distance between neighbouring corners."""
        at = {(int(i), int(j)): uv for (i, j), uv in zip(self.places, self.uv_px, strict=True)}
        steps = [
            float(np.linalg.norm(at[beside] - uv))
            for (i, j), uv in at.items()
            for beside in ((i + 1, j), (i, j + 1))
            if beside in at
        ]
        return median(steps) if steps else 0.0

    def steps_px(self) -> Floats:
        """(2,) how wide a square in the middle appears where it is widest, and across."""
        H = fit_perspective(self.places, self.uv_px)
        return perspective_steps_px(H, self.places.mean(axis=0))

    def causes(self, places: NDArray[np.int64]) -> list[Cause]:
        """What hides the corners at places (M, 2) of the grid, which may lie beyond it."""
        if min(self.extent) < 2:
            return ["unknown"] * len(places)
        uv_px = map_places(fit_perspective(self.places, self.uv_px), places)
        spacing_px = self.spacing_px()
        around_px = max(LEAST_AROUND_PX, AROUND_SHARE * spacing_px)
        needed_px = max(around_px, window_radius_px(spacing_px))
        return [self._cause(uv, around_px, needed_px) for uv in uv_px]

    def _cause(self, uv_px: Floats, around_px: float, needed_px: float) -> Cause:
        last = np.array(self.image.shape[::-1]) - 1
        # a corner this near to the edge of the picture cannot be measured
        if not np.isfinite(uv_px).all() or (np.minimum(uv_px, last - uv_px) < needed_px).any():
            return "outside"
        (u0, v0), (u1, v1) = np.round(uv_px - around_px), np.round(uv_px + around_px) + 1
        around = np.s_[int(v0) : int(v1), int(u0) : int(u1)]
        if self.laser[around].mean() > LASER_SHARE:
            return "laser"
        clipped = float((self.image[around] >= saturation_level(self.image)).mean())
        return "glare" if clipped > CLIPPED_SHARE else "unknown"

    def cause_beyond(self, inner_corners: tuple[int, int]) -> Cause:
        """What hides the outermost columns or rows of a board of this size."""
        low, high = self.places.min(axis=0), self.places.max(axis=0)
        sides: list[Cause] = []
        for axis in _short_axes(self.extent, inner_corners):
            along = np.arange(low[1 - axis], high[1 - axis] + 1)
            for end in (low[axis] - 1, high[axis] + 1):
                beyond = np.empty((len(along), 2), np.int64)
                beyond[:, axis], beyond[:, 1 - axis] = end, along
                sides.append(common_cause(self.causes(beyond)))
        order: tuple[Cause, ...] = ("outside", "laser", "glare")
        return next((cause for cause in order if cause in sides), "unknown")


def common_cause(causes: Sequence[Cause]) -> Cause:
    """The cause of at least half of them."""
    if not causes:
        return "unknown"
    cause, count = Counter(causes).most_common(1)[0]
    return cause if count >= LEAST_OF_SIDE * len(causes) else "unknown"


def _short_axes(extent: NDArray[np.int64], inner_corners: tuple[int, int]) -> list[int]:
    """The axes of a grid along which a board of this size has more, as it lies best; of a grid as
    wide as high, either one."""
    ways = [np.array(inner_corners) - extent, np.array(inner_corners[::-1]) - extent]
    misfits = [(int((way < 0).sum()), int(np.abs(way).sum())) for way in ways]
    best = [way for way, misfit in zip(ways, misfits, strict=True) if misfit == min(misfits)]
    return [axis for axis in (0, 1) if any(way[axis] > 0 for way in best)]
