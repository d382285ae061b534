"""The inner corners of a ChArUco board: OpenCV reads the markers, which number them for certain.

The corners are measured as those of a plain chessboard, around the markers.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from app.errors import OperationError
from app.messages.message import message, quantity, rounded
from app.metrology.chessboard.board_detection import BoardDetection, agreeing_corners
from app.metrology.chessboard.charuco_grid import CharucoGrid, charuco_board, marker_squares
from app.metrology.chessboard.corner_fit import FittedCorner, fit_corner
from app.metrology.chessboard.failure_evidence import (
    BoardFailure,
    explain_failure,
    fail_with_marks,
)
from app.metrology.chessboard.missing_corners import CornerGrid
from app.metrology.chessboard.perspective import predict_corner
from app.metrology.chessboard.two_boards import refuse_repeated_markers
from app.metrology.detection.failure_evidence import DetectionError, ImageAnnotation
from app.metrology.image import Image, saturation_level
from app.metrology.robust import median
from app.metrology.targets.chessboard import Chessboard, Markers, corner_grid
from app.metrology.transforms import Floats

# Corners that tell where the board is, over at least so many columns and rows.
FEWEST_CORNERS, FEWEST_OF_A_SIDE = 8, 2
# Sizes in which markers are looked for, as shares of the picture's own.
SCALES = (1.0, 2.0, 0.5)
MOST_ENLARGED_PX = 3000
# The smallest marker's outline as a share of the picture's longer side.
LEAST_OUTLINE = 0.01
# A corner is read wrongly that lies so far off where those around put it, in squares, and a board
# is another one where fewer than this share agree.
MISREAD_SQUARES, LEAST_AGREEING = 0.3, 0.7
# Share of markers that the board does not have and of their size, beyond which it is another one.
MOST_FOREIGN, MARKER_SIZE_SHARE = 0.15, 0.12
# Corners are looked for beside those measured, so often.
ROUNDS = 4
# A corner whose neighbours are known lies within this many px of where they put it, or of its
# squares' width.
NEAR_PX, NEAR_SQUARES = 2.5, 0.2


@dataclass(frozen=True)
class _Reading:
    """What OpenCV reads in a picture: N corners by number, and M markers by id."""

    number: NDArray[np.int64]  # (N,)
    uv_px: Floats  # (N, 2)
    markers: NDArray[np.int64]  # (M,)
    outlines_px: Floats  # (M, 4, 2)


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
            ``board-too-small``, ``board-blurred`` or ``two-boards``.
    """
    reading = _read_markers(image, board, markers, thorough)
    twice = refuse_repeated_markers(board, image, reading.markers, reading.outlines_px)
    if len(reading.number) < FEWEST_CORNERS:
        raise twice or _too_little(image, board, markers, blocked, reading)
    right = _agree_with_neighbours(corner_grid(board)[reading.number], reading.uv_px)
    foreign = float((~np.isin(reading.markers, charuco_board(board, markers).getIds())).mean())
    if foreign > MOST_FOREIGN or right.mean() < LEAST_AGREEING:
        raise twice or _other_arrangement(image, board, markers, reading)
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


def _agree_with_neighbours(places: NDArray[np.int64], uv_px: Floats) -> NDArray[np.bool_]:
    """Which corners (N,) lie where those around put them; a lens may bend the board's lines."""
    agree = np.ones(len(places), dtype=np.bool_)
    for k, (place, uv) in enumerate(zip(places, uv_px, strict=True)):
        predicted = predict_corner(places, uv_px, place, certain=True)
        if predicted is not None:
            agree[k] = np.linalg.norm(predicted[0] - uv) < MISREAD_SQUARES * predicted[1]
    return agree


def _refuse_other_size(
    image: Image, board: Chessboard, markers: Markers, reading: _Reading, grid: CharucoGrid
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
    raise fail_with_marks(refusal, "object", image, _outlines(reading))


def _enough(board: Chessboard, number: NDArray[np.int64]) -> bool:
    if len(number) < FEWEST_CORNERS:
        return False
    return bool(min(np.ptp(corner_grid(board)[number], axis=0)) >= FEWEST_OF_A_SIDE - 1)


def _read_markers(image: Image, board: Chessboard, markers: Markers, thorough: bool) -> _Reading:
    """The reading with most corners, of the sizes in which the picture is looked at."""
    detector = _detector(board, markers)
    columns, rows = board.inner_corners
    best: _Reading | None = None
    for grey, across in _sizes(image, SCALES if thorough else SCALES[:1]):
        corners, ids, outlines, read = detector.detectBoard(grey)
        uv_px = np.zeros((0, 2)) if corners is None else corners.reshape(-1, 2).astype(np.float64)
        own = np.zeros(0, np.int64) if ids is None else ids.ravel().astype(np.int64)
        reading = _Reading(
            (rows - 1 - own // columns) * columns + own % columns,
            (uv_px + 0.5) * across - 0.5,
            np.zeros(0, np.int64) if read is None else read.ravel().astype(np.int64),
            (np.array(outlines, np.float64).reshape(-1, 4, 2) + 0.5) * across - 0.5,
        )
        if best is None or (len(own), len(outlines)) > (len(best.number), len(best.outlines_px)):
            best = reading
        if len(own) >= LEAST_AGREEING * columns * rows:
            break
    assert best is not None
    return best


def _detector(board: Chessboard, markers: Markers) -> cv2.aruco.CharucoDetector:
    detector = cv2.aruco.CharucoDetector(charuco_board(board, markers))
    parameters = detector.getDetectorParameters()
    parameters.minMarkerPerimeterRate = LEAST_OUTLINE
    detector.setDetectorParameters(parameters)
    return detector


def _sizes(
    image: Image, scales: tuple[float, ...]
) -> Iterator[tuple[NDArray[np.uint8], NDArray[np.float64]]]:
    """The picture with 8 bits in several sizes, and its own pixels per pixel of each."""
    full = image.astype(np.float64) * (255.0 / saturation_level(image))
    grey = np.clip(full, 0, 255).astype(np.uint8)
    for scale in scales:
        if scale > 1 and scale * max(image.shape) > MOST_ENLARGED_PX:
            continue
        method = cv2.INTER_AREA if scale < 1 else cv2.INTER_CUBIC
        small = cv2.resize(grey, None, fx=scale, fy=scale, interpolation=method)
        sized = np.asarray(small, np.uint8) if scale != 1.0 else grey
        yield sized, np.array(image.shape[::-1]) / np.array(sized.shape[::-1])


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


def _too_little(
    image: Image,
    board: Chessboard,
    markers: Markers,
    blocked: NDArray[np.bool_],
    reading: _Reading,
) -> DetectionError:
    """No markers, markers that are not arranged so, or too few of them."""
    columns, rows = board.inner_corners
    seen = len(reading.outlines_px)
    if seen and not len(reading.number):
        return _other_arrangement(image, board, markers, reading)
    if not seen:
        refusal = OperationError(
            "board-not-found",
            message("no-markers-found", dictionary=markers.dictionary, name=board.name),
            message("out-picture-covered-too-small-or-another-object"),
            message("bring-board-with-markers-into-picture"),
        )
        return fail_with_marks(refusal, "framing", image, (), guessed=True)
    refusal = OperationError(
        "board-partly-seen",
        message(
            "corners-were-found",
            found=len(reading.number),
            corners=columns * rows,
            name=board.name,
        ),
        message("so-many-corners-needed", fewest=FEWEST_CORNERS),
        message("bring-more-of-board-into-picture"),
    )
    return fail_with_marks(refusal, "framing", image, _outlines(reading), guessed=True)


def _other_arrangement(
    image: Image, board: Chessboard, markers: Markers, reading: _Reading
) -> DetectionError:
    refusal = OperationError(
        "another-board",
        message(
            "markers-were-found", count=len(reading.outlines_px), dictionary=markers.dictionary
        ),
        message("markers-not-arranged-so", name=board.name),
        message("give-certificate-of-charuco-board"),
    )
    return fail_with_marks(refusal, "object", image, _outlines(reading))


def _outlines(reading: _Reading) -> tuple[ImageAnnotation, ...]:
    return tuple(
        ImageAnnotation("segment", *one.tolist(), *other.tolist())
        for quad in reading.outlines_px
        for one, other in zip(quad, np.roll(quad, -1, axis=0), strict=True)
    )


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
