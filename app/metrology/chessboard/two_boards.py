"""Two boards that both fit the certificate: nothing in a picture says which of them is meant."""

from collections.abc import Sequence

import cv2
import numpy as np
from numpy.typing import NDArray

from app.errors import OperationError
from app.messages.message import message
from app.metrology.chessboard.failure_evidence import fail_with_marks
from app.metrology.chessboard.saddle_points import Saddles
from app.metrology.detection.failure_evidence import DetectionError, ImageAnnotation
from app.metrology.image import Image
from app.metrology.targets.chessboard import Chessboard
from app.metrology.transforms import Floats

# Saddles this near to a board's hull may be its own.
AROUND_PX = 5
# Markers seen twice that show a second board; fewer may be misread in what is beside it.
FEWEST_TWICE = 3


def saddles_outside(image: Image, saddles: Saddles, uv_px: Floats) -> Saddles:
    """The saddles that do not lie within the hull of corners (N, 2)."""
    inside = np.zeros(image.shape, np.uint8)
    hull = cv2.convexHull(np.round(uv_px).astype(np.int32))
    cv2.fillConvexPoly(inside, hull, (1,))
    cv2.polylines(inside, [hull], True, (1,), 2 * AROUND_PX)
    u, v = np.round(saddles.uv_px).astype(np.int64).T
    free = inside[v, u] == 0
    return Saddles(saddles.uv_px[free], saddles.phase[free])


def refuse_two_boards(board: Chessboard, image: Image, corners: Sequence[Floats]) -> DetectionError:
    """The error, with the hull of the corners (N, 2) of each board as marks."""
    hulls = [cv2.convexHull(uv.astype(np.float32))[:, 0].astype(np.float64) for uv in corners]
    return _refuse(board, image, hulls)


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
    board: Chessboard, image: Image, outlines_px: Sequence[Floats] | Floats
) -> DetectionError:
    columns, rows = board.inner_corners
    refusal = OperationError(
        "two-boards",
        message("two-boards-in-picture", columns=columns, rows=rows),
        message("which-board-not-certain", name=board.name),
        message("cover-one-board"),
    )
    marks = [
        ImageAnnotation("segment", *one.tolist(), *other.tolist())
        for outline in outlines_px
        for one, other in zip(outline, np.roll(outline, -1, axis=0), strict=True)
    ]
    return fail_with_marks(refusal, "object", image, marks)
