"""Boards in pictures by others: held in the hand, on walls, soft, compressed, bent by the lens."""

from pathlib import Path

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray

from crenel.errors import OperationError
from crenel.metrology.chessboard.board_detection import BoardDetection
from crenel.metrology.chessboard.detect_board import detect_board
from crenel.metrology.targets.chessboard import Chessboard
from crenel.metrology.transforms import Floats
from tests.metrology.refusals import refusal_of
from tests.pictures import blur, halve
from tests.running.usual import usual

pytestmark = pytest.mark.slow

SETS = {"opencv-stereo": (9, 6), "carnd": (9, 6), "wide": (8, 6)}
EVERY = 4
"""Pictures of a set that are looked at: every fourth."""
PAIR = ("left13.jpg", "left14.jpg")
CLASSIC = cv2.CALIB_CB_ADAPTIVE_THRESH | cv2.CALIB_CB_NORMALIZE_IMAGE


def read(path: Path) -> NDArray[np.uint8]:
    return np.asarray(cv2.imread(str(path), cv2.IMREAD_GRAYSCALE), np.uint8)


def read_stereo(real: Path, name: str) -> NDArray[np.uint8]:
    """A picture of a board of 9 by 6."""
    return read(real / "boards" / "opencv-stereo" / name)


def board(columns: int, rows: int) -> Chessboard:
    return Chessboard("board", "", (columns, rows), 25.0, 0.1)


@pytest.mark.parametrize("name", usual(SETS, 1, pytest.mark.soak))
def test_what_opencv_finds_is_found_and_numbered_alike(real: Path, name: str) -> None:
    columns, rows = SETS[name]
    for path in sorted((real / "boards" / name).glob("*.jpg"))[::EVERY]:
        image = read(path)
        found, corners = cv2.findChessboardCorners(image, (columns, rows), None, CLASSIC)
        if not found:
            continue
        detection = detect_board(image, board(columns, rows))
        steps = np.linalg.norm(np.diff(corners[:, 0], axis=0), axis=1)
        assert len(detection) > 0.8 * columns * rows, path.name
        theirs = np.asarray(corners, np.float64).reshape(rows, columns, 2)
        assert off_px(detection, theirs) < 0.3 * np.median(steps), path.name


def off_px(detection: BoardDetection, theirs: Floats) -> float:
    """The usual distance from OpenCV's corners (rows, columns, 2), counted from either end."""
    ways = (theirs, theirs[::-1, ::-1], theirs[:, ::-1], theirs[::-1])
    off = [way.reshape(-1, 2)[detection.number] - detection.uv_px for way in ways]
    return min(float(np.median(np.linalg.norm(one, axis=1))) for one in off)


def test_white_that_is_clipped_costs_no_corner(real: Path) -> None:
    image = read_stereo(real, "left01.jpg")
    bright = np.clip(image * 1.6, 0, 255).astype(np.uint8)
    assert np.mean(bright == 255) > 0.1
    assert len(detect_board(bright, board(9, 6))) == 54


@pytest.mark.parametrize(
    ("columns", "rows"), usual([(8, 6), (9, 5), (7, 6), (10, 6)], {1}, pytest.mark.soak)
)
def test_a_certificate_of_another_size_is_refused(real: Path, columns: int, rows: int) -> None:
    image = halve(read_stereo(real, "left02.jpg"))
    code = refusal_of(detect_board, image, board(columns, rows)).code
    assert code in ("another-board", "board-partly-seen")


@pytest.mark.parametrize(
    ("size", "name", "words"),
    usual(
        [
            ((9, 7), "left05.jpg", "9 × 6 inner corners was found: board has 9 × 7"),
            ((10, 7), "left01.jpg", "If 10 × 7 is the number of squares"),
            ((7, 10), "left05.jpg", "If 7 × 10 is the number of squares"),
        ],
        2,
        pytest.mark.soak,
    ),
)
def test_a_certificate_that_counts_more_is_recognised(
    real: Path, size: tuple[int, int], name: str, words: str
) -> None:
    refusal = refusal_of(detect_board, halve(read_stereo(real, name)), board(*size))
    assert refusal.code == "another-board"
    assert words in refusal.line


@pytest.mark.parametrize("share", [0.2, 0.3])
def test_corners_near_the_edge_of_it_are_not_called_blurred(real: Path, share: float) -> None:
    image = read(real / "boards" / "carnd" / "calibration9.jpg")
    whole = detect_board(image, board(9, 6))
    uv = whole.uv_px[np.argsort(whole.number)].reshape(6, 9, 2)
    first = np.sort(min(uv[:, 0, 0], uv[:, -1, 0], key=np.mean))
    cut = int(first[-2] - share * np.linalg.norm(uv[0, 1] - uv[0, 0]))
    with pytest.raises(OperationError, match="partly out of the picture") as refused:
        detect_board(image[:, cut:].copy(), board(9, 6))
    assert refused.value.code == "board-partly-seen"


def test_a_row_out_of_the_picture_is_not_made_up_by_an_outline(real: Path) -> None:
    image = read_stereo(real, "left04.jpg")
    top = float(detect_board(image, board(9, 6)).uv_px[:, 1].min())
    refusal_of(detect_board, image[int(top) + 60 :].copy(), board(9, 6))


def test_a_board_on_a_screen_is_not_taken_for_the_one_that_is_cut_off(real: Path) -> None:
    image = read_stereo(real, "left12.jpg")
    right = float(detect_board(image, board(9, 6)).uv_px[:, 0].max())
    refusal_of(detect_board, image[:, : int(right) - 15].copy(), board(9, 6))


@pytest.mark.parametrize(
    ("folder", "name", "first", "last"),
    usual(
        [
            ("opencv-stereo", "left10.jpg", 3, 4),
            ("opencv-stereo", "left01.jpg", 3, 5),
            ("wide", "GOPR0054.jpg", 3, 5),
        ],
        1,
        pytest.mark.soak,
    ),
)
def test_a_strip_across_is_named(real: Path, folder: str, name: str, first: int, last: int) -> None:
    columns, rows = SETS[folder]
    image = read(real / "boards" / folder / name)
    whole = detect_board(image, board(columns, rows))
    uv = np.full((columns * rows, 2), np.nan)
    uv[whole.number] = whole.uv_px
    grid = uv.reshape(rows, columns, 2)
    ends = np.array([grid[0, first], grid[0, last], grid[-1, last], grid[-1, first]])
    strip = ends.mean(axis=0) + 1.25 * (ends - ends.mean(axis=0))
    cv2.fillPoly(image, [np.round(strip).astype(np.int32)], (90,))
    with pytest.raises(OperationError, match="the others are covered") as refused:
        detect_board(image, board(columns, rows))
    assert refused.value.code == "board-partly-seen"


def test_a_board_cut_off_beside_a_whole_one_is_not_ignored(real: Path) -> None:
    one, other = (read_stereo(real, name) for name in PAIR)
    both = np.hstack([one, other[:, : other.shape[1] * 2 // 3]]).astype(np.uint8)
    refusal = refusal_of(detect_board, both, board(9, 6))
    assert refusal.code == "two-boards"
    assert "a part of a second one" in refusal.line


@pytest.mark.parametrize("blur_px", usual([5.0, 6.0, 7.0], {1}, pytest.mark.soak))
def test_a_picture_far_out_of_focus_is_refused_with_this_reason(real: Path, blur_px: float) -> None:
    image = read_stereo(real, "left01.jpg")
    with pytest.raises(OperationError, match="is blurred: its edges"):
        detect_board(blur(image, blur_px), board(9, 6))
