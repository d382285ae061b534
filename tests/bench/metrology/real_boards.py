"""Chessboards in real pictures: what is found beside OpenCV's two finders, and how well.

The folder has one folder for each set, with the pictures of one camera and the board as
``object.json``. Without truth, a numbering is wrong where it contradicts that of a finder, and
the quality of corners is the rms that ``cv2.calibrateCamera`` leaves of those corners that all
three found.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import cv2
import numpy as np

from crenel.errors import OperationError
from crenel.formats.datasheets.target import read_object
from crenel.formats.images import GreyImage, read_grey, to_8_bits
from crenel.formats.io_errors import convert_io_errors
from crenel.metrology.chessboard.board_detection import BoardDetection
from crenel.metrology.chessboard.detect_board import detect_board
from crenel.metrology.targets.chessboard import Chessboard, corner_points
from crenel.metrology.transforms import Floats
from crenel.progress import Progress, no_progress

SUFFIXES = (".png", ".tif", ".tiff", ".bmp", ".pgm", ".jpg", ".jpeg")
OBJECT = "object.json"
CLASSIC = cv2.CALIB_CB_ADAPTIVE_THRESH | cv2.CALIB_CB_NORMALIZE_IMAGE
SECTORS = cv2.CALIB_CB_NORMALIZE_IMAGE | cv2.CALIB_CB_EXHAUSTIVE | cv2.CALIB_CB_ACCURACY
SUB_PIXEL = (cv2.TERM_CRITERIA_EPS + cv2.TERM_CRITERIA_MAX_ITER, 40, 0.001)
CONTRADICTS = 0.3
"""Of the distance between corners: the usual difference to a finder's corner of that number."""
FEWEST = 4
"""Pictures that a comparison of the corners needs."""
COLUMNS = ("set", "pictures", "Crenel", "classic", "sectors", "wrong")
COLUMNS_RMS = ("rms px: Crenel", "classic", "sectors")


@dataclass
class BoardSet:
    """The results of one set. ``rms_px``: by method, of the corners that all three found."""

    name: str
    pictures: int = 0
    found: dict[str, int] = field(default_factory=lambda: {"crenel": 0, "classic": 0, "sectors": 0})
    wrong: int = 0
    rms_px: dict[str, float] = field(default_factory=dict)


def run(folder: Path, progress: Progress = no_progress) -> list[BoardSet]:
    """Looks for the board in every picture of every set.

    Raises:
        OperationError: no set in the folder, or a picture or a certificate cannot be read.
    """
    with convert_io_errors(folder):
        sets = sorted(path.parent for path in folder.glob(f"*/{OBJECT}"))
    if not sets:
        raise OperationError(
            "folder-without-sets", str(folder), f"no folder in it has an {OBJECT}", "Add one"
        )
    results = []
    for number, one in enumerate(sets):
        progress(number / len(sets), one.name)
        board = read_object(one / OBJECT)
        if not isinstance(board, Chessboard):
            raise OperationError("not-a-board", str(one / OBJECT), "it is not a chessboard")
        files = sorted(path for path in one.iterdir() if path.suffix.lower() in SUFFIXES)
        pictures = (read_grey(path, "green") for path in files)
        results.append(measure_boards(one.name, pictures, board))
    return results


def measure_boards(name: str, pictures: Iterable[GreyImage], board: Chessboard) -> BoardSet:
    """Looks for the board in each picture of one camera, by all three methods."""
    result = BoardSet(name)
    places: list[Floats] = []
    seen: dict[str, list[Floats]] = {"crenel": [], "classic": [], "sectors": []}
    size = (0, 0)
    for image in pictures:
        size = (image.shape[1], image.shape[0])
        theirs = _find_by_opencv(image, board)
        detection = _detect(image, board)
        result.pictures += 1
        result.found["crenel"] += detection is not None
        for name in theirs:
            result.found[name] += 1
        if detection is None:
            continue
        same = _same_corners(detection, theirs, board)
        if theirs and not same:
            result.wrong += 1
        elif len(same) == 2:
            places.append(corner_points(board)[detection.number])
            for name, uv in (("crenel", detection.uv_px), *same.items()):
                seen[name].append(uv)
    if len(places) >= FEWEST:
        result.rms_px = {name: _calibration_rms_px(places, uv, size) for name, uv in seen.items()}
    return result


def _detect(image: GreyImage, board: Chessboard) -> BoardDetection | None:
    try:
        return detect_board(image, board)
    except OperationError:
        return None


def _find_by_opencv(image: GreyImage, board: Chessboard) -> dict[str, Floats]:
    """Corners (N, 2) px by finder, those of the classic one refined by ``cornerSubPix``."""
    grey = to_8_bits(image)
    found: dict[str, Floats] = {}
    ok, corners = cv2.findChessboardCorners(grey, board.inner_corners, None, CLASSIC)
    if ok:
        refined = cv2.cornerSubPix(grey, corners, (5, 5), (-1, -1), SUB_PIXEL)
        found["classic"] = np.asarray(refined, np.float64).reshape(-1, 2)
    ok, corners = cv2.findChessboardCornersSB(grey, board.inner_corners, None, SECTORS)
    if ok:
        found["sectors"] = np.asarray(corners, np.float64).reshape(-1, 2)
    return found


def _same_corners(
    detection: BoardDetection, theirs: dict[str, Floats], board: Chessboard
) -> dict[str, Floats]:
    """The corners (N, 2) px of the detection as each finder sees them, from whichever end and side
    it counts; without finders that contradict it."""
    columns, rows = board.inner_corners
    same = {}
    for name, uv in theirs.items():
        grid = uv.reshape(rows, columns, 2)
        step_px = float(np.median(np.linalg.norm(np.diff(grid, axis=1), axis=2)))
        off_px, corners = min(
            (
                (float(np.median(np.linalg.norm(corners - detection.uv_px, axis=1))), corners)
                for way in (grid, grid[::-1, ::-1], grid[:, ::-1], grid[::-1])
                for number in (detection.number, *detection.other_numbers)
                for corners in (way.reshape(-1, 2)[number],)
            ),
            key=lambda one: one[0],
        )
        if off_px <= CONTRADICTS * step_px:
            same[name] = corners
    return same


def _calibration_rms_px(
    places_mm: Sequence[Floats], pictures: Sequence[Floats], size_px: tuple[int, int]
) -> float:
    points = [place.astype(np.float32) for place in places_mm]
    corners = [uv.astype(np.float32).reshape(-1, 1, 2) for uv in pictures]
    return float(cv2.calibrateCamera(points, corners, size_px, np.eye(3), np.zeros(5))[0])


def table(results: Sequence[BoardSet]) -> list[list[str]]:
    """Rows to print under ``COLUMNS`` and ``COLUMNS_RMS``."""
    return [
        [
            one.name,
            *map(str, (one.pictures, *one.found.values(), one.wrong)),
            *(f"{one.rms_px[name]:.3f}" if name in one.rms_px else "–" for name in one.found),
        ]
        for one in results
    ]
