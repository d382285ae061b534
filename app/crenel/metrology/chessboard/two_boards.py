"""Two boards that both fit the certificate: nothing in a picture says which of them is meant.

One of them may be partly out of the picture, and still be the one that is meant.
"""

from collections.abc import Sequence

import cv2
import numpy as np
from numpy.typing import NDArray

from crenel.errors import OperationError
from crenel.messages.message import message
from crenel.metrology.chessboard.failure_evidence import fail_with_marks
from crenel.metrology.chessboard.missing_corners import CornerGrid
from crenel.metrology.chessboard.saddle_points import Saddles
from crenel.metrology.detection.failure_evidence import DetectionError, ImageAnnotation
from crenel.metrology.image import Image
from crenel.metrology.targets.chessboard import Chessboard
from crenel.metrology.transforms import Floats

# Saddles this near to a board's hull may be its own.
AROUND_PX = 5
# Markers seen twice that show a second board; fewer may be misread in what is beside it.
FEWEST_TWICE = 3
# A grid that ends at the picture's edge may be a board's part if it has a whole side of it and so
# many corners along the other, or this share of all. A pattern with more gaps is no board.
FEWEST_ALONG, LEAST_OF_ALL, LEAST_FILLED = 3, 0.5, 0.8


def saddles_outside(image: Image, saddles: Saddles, uv_px: Floats) -> Saddles:
    """The saddles that do not lie within the hull of corners (N, 2)."""
    inside = np.zeros(image.shape, np.uint8)
    hull = cv2.convexHull(np.round(uv_px).astype(np.int32))
    cv2.fillConvexPoly(inside, hull, (1,))
    cv2.polylines(inside, [hull], True, (1,), 2 * AROUND_PX)
    u, v = np.round(saddles.uv_px).astype(np.int64).T
    free = inside[v, u] == 0
    return Saddles(saddles.uv_px[free], saddles.phase[free])


def is_cut_off_board(board: Chessboard, grid: CornerGrid) -> bool:
    """Whether corners may be those of a board of this size that the picture's edge cuts off."""
    if len(grid.places) < 2 * FEWEST_ALONG or min(grid.extent) < 2:
        return False
    if len(grid.places) < LEAST_FILLED * grid.extent.prod():
        return False
    inner = np.array(board.inner_corners)
    fitting = [way for way in (inner, inner[::-1]) if (grid.extent <= way).all()]
    has_side = any(
        grid.extent[axis] == way[axis] and grid.extent[1 - axis] >= FEWEST_ALONG
        for way in fitting
        for axis in (0, 1)
    )
    has_most = bool(fitting) and len(grid.places) >= LEAST_OF_ALL * inner.prod()
    return (has_side or has_most) and grid.cause_beyond(board.inner_corners) == "outside"


def refuse_two_boards(
    board: Chessboard, image: Image, corners: Sequence[Floats], *, second_is_whole: bool = True
) -> DetectionError:
    """The error, with the hull of the corners (N, 2) of each board as marks."""
    hulls = [cv2.convexHull(uv.astype(np.float32))[:, 0].astype(np.float64) for uv in corners]
    return _refuse(board, image, hulls, second_is_whole)


def refuse_repeated_markers(
    board: Chessboard, image: Image, ids: NDArray[np.int64], outlines_px: Floats
) -> DetectionError | None:
    """The error if several of the markers (M,) were read twice, with their outlines (M, 4, 2)."""
    found, count = np.unique(ids, return_counts=True)
    twice = found[count > 1]
    if len(twice) < FEWEST_TWICE:
        return None
    return _refuse(board, image, outlines_px[np.isin(ids, twice)])


def _refuse(
    board: Chessboard,
    image: Image,
    outlines_px: Sequence[Floats] | Floats,
    second_is_whole: bool = True,
) -> DetectionError:
    columns, rows = board.inner_corners
    what = (
        message("two-boards-in-picture", columns=columns, rows=rows)
        if second_is_whole
        else message("part-of-second-board-in-picture", columns=columns, rows=rows)
    )
    refusal = OperationError(
        "two-boards",
        what,
        message("which-board-not-certain", name=board.name),
        message("cover-one-board"),
    )
    marks = [
        ImageAnnotation("segment", *one.tolist(), *other.tolist())
        for outline in outlines_px
        for one, other in zip(outline, np.roll(outline, -1, axis=0), strict=True)
    ]
    return fail_with_marks(refusal, "object", image, marks)
