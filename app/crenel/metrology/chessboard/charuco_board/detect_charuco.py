"""The inner corners of a ChArUco board: OpenCV reads the markers, which number them for certain.

The corners are measured as those of a plain chessboard, around the markers.
"""

import cv2
import numpy as np
from numpy.typing import NDArray

from crenel.errors import OperationError
from crenel.messages.message import message, quantity, rounded
from crenel.metrology.chessboard.board_detection import BoardDetection, agreeing_corners
from crenel.metrology.chessboard.charuco_board.arrangement import arrangement_of
from crenel.metrology.chessboard.charuco_board.charuco_failure import (
    explain_markers,
    refuse_arrangement,
)
from crenel.metrology.chessboard.charuco_board.charuco_grid import CharucoGrid, marker_squares
from crenel.metrology.chessboard.charuco_board.marker_reading import BoardReading, read_board
from crenel.metrology.chessboard.corner_fit import FittedCorner, fit_corner
from crenel.metrology.chessboard.failure_evidence import (
    BoardFailure,
    explain_failure,
    fail_with_marks,
)
from crenel.metrology.chessboard.missing_corners import CornerGrid
from crenel.metrology.chessboard.perspective import fit_perspective, map_places, predict_corner
from crenel.metrology.chessboard.two_boards import refuse_repeated_markers
from crenel.metrology.detection.failure_evidence import DetectionError
from crenel.metrology.image import Image, negative_of
from crenel.metrology.robust import median
from crenel.metrology.targets.chessboard import Chessboard, Markers, corner_grid
from crenel.metrology.transforms import Floats

# Corners that tell where the board is, over at least so many columns and rows.
FEWEST_CORNERS, FEWEST_OF_A_SIDE = 8, 2
# A corner is read wrongly that lies so far off where those around put it, in squares, and a board
# is another one where fewer than this share agree.
MISREAD_SQUARES, LEAST_AGREEING = 0.3, 0.7
# Markers that go on beyond the board's rows, and share of their size, that make it another.
FEWEST_FOREIGN, MARKER_SIZE_SHARE = 2, 0.12
# A marker goes on so that lies within so many squares of where a further row would have it.
FOREIGN_SQUARES = 1.0
# Corners are looked for beside those measured, so often.
ROUNDS = 4
# A corner whose neighbours are known lies within this many px of where they put it, or of its
# squares' width.
NEAR_PX, NEAR_SQUARES = 2.5, 0.2


def detect_charuco(
    image: Image,
    board: Chessboard,
    markers: Markers,
    blocked: NDArray[np.bool_],
    *,
    thorough: bool = True,
) -> BoardDetection:
    """Every inner corner that can be measured; the board may be covered or cut off in part.

    Args:
        image: (H, W) grey, 8 to 16 bits.
        blocked: (H, W) pixels that the laser's line spoils.
        thorough: also in other sizes of the picture.

    Raises:
        DetectionError: ``board-not-found``, ``another-board``, ``board-partly-seen``,
            ``board-mirrored``, ``board-too-small``, ``board-blurred`` or ``two-boards``.
    """
    reading = read_board(image, board, markers, thorough)
    if len(reading.number) < FEWEST_CORNERS:
        # of a print with white for black, or a picture's negative
        negative = negative_of(image)
        negative_reading = read_board(negative, board, markers, thorough=False)
        if len(negative_reading.number) >= FEWEST_CORNERS:
            image, reading = negative, negative_reading
    twice = refuse_repeated_markers(board, image, reading.markers, reading.outlines_px)
    if len(reading.number) < FEWEST_CORNERS:
        raise twice or explain_markers(image, board, markers, reading, thorough=thorough)
    right = _agree_with_neighbours(corner_grid(board)[reading.number], reading.uv_px)
    if right.mean() < LEAST_AGREEING or _goes_on(board, markers, reading, right):
        raise twice or refuse_arrangement(image, board, markers, reading)
    known = dict(zip(reading.number[right].tolist(), reading.uv_px[right], strict=True))
    _refuse_other_size(image, board, markers, reading, CharucoGrid(board, known))
    measured = _measure(image, board, markers, blocked, known)
    number = np.array(sorted(measured), dtype=np.int64)
    if not _enough(board, number):
        raise _explain_unmeasured(image, board, blocked, known, set(measured))
    uv = np.array([measured[k].uv_px for k in number])
    covariance = np.array([measured[k].covariance_px2 for k in number])
    kept = agreeing_corners(board, uv, number)
    return BoardDetection(uv[kept], covariance[kept], number[kept])


def _goes_on(
    board: Chessboard, markers: Markers, reading: BoardReading, right: NDArray[np.bool_]
) -> bool:
    """Whether the board in the picture has more rows of markers; not whether others lie beside."""
    foreign = ~np.isin(reading.markers, list(marker_squares(board, markers)))
    if not foreign.any() or right.sum() < 4:
        return False
    rows = board.inner_corners[1]
    H = fit_perspective(corner_grid(board)[reading.number[right]], reading.uv_px[right])
    column, row = arrangement_of(board, markers).places(reading.markers[foreign]).T
    due_px = map_places(H, np.column_stack([column - 0.5, rows - 0.5 - row]))
    outlines_px = reading.outlines_px[foreign]
    off_px = np.linalg.norm(outlines_px.mean(axis=1) - due_px, axis=1)
    sides_px = np.linalg.norm(np.diff(outlines_px, axis=1), axis=2).mean(axis=1)
    return int((off_px < FOREIGN_SQUARES * sides_px).sum()) >= FEWEST_FOREIGN


def _agree_with_neighbours(places: NDArray[np.int64], uv_px: Floats) -> NDArray[np.bool_]:
    """Which corners (N,) lie where those around put them; a lens may bend the board's lines."""
    agree = np.ones(len(places), dtype=np.bool_)
    for k, (place, uv) in enumerate(zip(places, uv_px, strict=True)):
        predicted = predict_corner(places, uv_px, place, certain=True)
        if predicted is not None:
            agree[k] = np.linalg.norm(predicted[0] - uv) < MISREAD_SQUARES * predicted[1]
    return agree


def _refuse_other_size(
    image: Image, board: Chessboard, markers: Markers, reading: BoardReading, grid: CharucoGrid
) -> None:
    """Refuses markers whose size, beside that of their squares, is not the certificate's."""
    squares = marker_squares(board, markers)
    shares = []
    for marker, outline in zip(reading.markers.tolist(), reading.outlines_px, strict=True):
        square = grid.square_px(*squares[marker]) if marker in squares else None
        if square is not None:
            areas = [cv2.contourArea(one.astype(np.float32)) for one in (outline, square)]
            shares.append(float(np.sqrt(areas[0] / max(areas[1], 1.0))))
    side_mm = median(shares) * board.square_mm if shares else markers.side_mm
    if abs(side_mm / markers.side_mm - 1) < MARKER_SIZE_SHARE:
        return
    refusal = OperationError(
        "another-board",
        message("markers-are-wide", width=quantity(side_mm, "mm", 1), name=board.name),
        message("certificate-says", square=rounded(markers.side_mm, "mm")),
        message("correct-marker-size"),
    )
    raise fail_with_marks(refusal, "object", image, reading.annotations)


def _enough(board: Chessboard, number: NDArray[np.int64]) -> bool:
    if len(number) < FEWEST_CORNERS:
        return False
    return bool(min(np.ptp(corner_grid(board)[number], axis=0)) >= FEWEST_OF_A_SIDE - 1)


def _measure(
    image: Image,
    board: Chessboard,
    markers: Markers,
    blocked: NDArray[np.bool_],
    known: dict[int, Floats],
) -> dict[int, FittedCorner]:
    """The corners by number that can be measured, those beside the ones that were read too."""
    measured: dict[int, FittedCorner] = {}
    tried: set[int] = set()
    for _ in range(ROUNDS):
        grid = CharucoGrid(board, known)
        marked = grid.mask_markers(image.shape, markers)
        fresh = [k for k in range(len(corner_grid(board))) if k in grid and k not in tried]
        if not fresh:
            break
        for number in fresh:
            tried.add(number)
            at = grid.at(number)
            found = fit_corner(image, blocked, at.uv_px, at.phase, at.spacing_px, marked)
            near_px = max(NEAR_PX, NEAR_SQUARES * at.spacing_px)
            if found is not None and np.linalg.norm(found.uv_px - at.uv_px) < near_px:
                measured[number] = found
        known = {number: found.uv_px for number, found in measured.items()}
        if len(known) < FEWEST_CORNERS:
            break
    return measured


def _explain_unmeasured(
    image: Image,
    board: Chessboard,
    blocked: NDArray[np.bool_],
    known: dict[int, Floats],
    measured: set[int],
) -> DetectionError:
    """The board is numbered, and too few of its corners can be measured."""
    numbers = list(known)
    grid = CornerGrid(image, blocked, corner_grid(board)[numbers], np.array(list(known.values())))
    can_be = np.array([number in measured for number in numbers])
    return explain_failure(board, BoardFailure(grid, can_be, np.ones(len(numbers), np.bool_)))
