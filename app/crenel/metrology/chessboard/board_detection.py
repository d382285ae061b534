"""Corners of a board in one picture: measured, and numbered."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from crenel.metrology.chessboard.perspective import predict_corner
from crenel.metrology.robust import median
from crenel.metrology.targets.chessboard import Chessboard
from crenel.metrology.transforms import Floats

# Corners further than this off a perspective of all, and this often the usual, are left out.
MISFIT_PX, MISFIT_TIMES = 0.5, 6.0


@dataclass(frozen=True)
class BoardDetection:
    """N corners of the board in one picture.

    ``number`` (N,) is the index of each in ``corner_points``; if the colours are ambiguous,
    ``other_numbers`` holds the other numberings, each equally good. ``covariance_px2`` follows from
    the picture noise around each corner.
    """

    uv_px: Floats  # (N, 2)
    covariance_px2: Floats  # (N, 2, 2)
    number: NDArray[np.int64]  # (N,)
    other_numbers: tuple[NDArray[np.int64], ...] = ()

    def __len__(self) -> int:
        return len(self.number)


@dataclass(frozen=True)
class MeasuredCorners:
    """Corners that could be measured: pixels, covariances, and which of the grid's they are."""

    uv_px: Floats  # (M, 2)
    covariance_px2: Floats  # (M, 2, 2)
    index: NDArray[np.int64]  # (M,)


def agreeing_corners(board: Chessboard, uv: Floats, number: NDArray[np.int64]) -> NDArray[np.bool_]:
    """Which corners lie where a perspective of those around puts them, to a lens's distortion."""
    columns = board.inner_corners[0]
    places = np.column_stack([number % columns, number // columns])
    predicted = [predict_corner(places, uv, place) for place in places]
    off = np.array(
        [
            0.0 if one is None else float(np.linalg.norm(one[0] - at))
            for one, at in zip(predicted, uv, strict=True)
        ]
    )
    return np.asarray(off < max(MISFIT_PX, MISFIT_TIMES * median(off)))
