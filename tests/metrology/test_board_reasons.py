"""The reason of a refused picture of a chessboard is the true one."""

from collections.abc import Callable
from dataclasses import replace

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray

from app.metrology.chessboard.detect_board import detect_board
from app.metrology.chessboard.failure_evidence import BoardFailure, explain_failure
from app.metrology.chessboard.laser_light import drop_faint_stripe
from app.metrology.chessboard.missing_corners import CornerGrid
from app.metrology.detection.failure_evidence import DetectionError
from app.metrology.sensor.camera import project
from app.metrology.stripe import extract_stripe
from app.metrology.targets.chessboard import corner_points
from app.metrology.transforms import Floats
from tests.metrology.boards import BOARD, POSES, Look, camera_pose, picture
from tests.metrology.seen_boards import camera_at

pytestmark = pytest.mark.slow

Grey = NDArray[np.uint8]


def moved(right_mm: float) -> Floats:
    T = POSES[1].copy()
    T[0, 3] += right_mm
    return T


def covered(image: Grey) -> Grey:
    """Paper over all but three columns."""
    uv = project(camera_at(POSES[1]), corner_points(BOARD)).reshape(6, 7, 2)
    edge = (uv[:, 2] + uv[:, 3]) / 2
    down = edge[5] - edge[0]
    paper = [edge[0] - down, edge[5] + down, edge[5] + down + 8 * (uv[5, 6] - uv[5, 5])]
    paper.append(edge[0] - down + 8 * (uv[0, 6] - uv[0, 5]))
    hidden = image.copy()
    cv2.fillPoly(hidden, [np.round(paper).astype(np.int32)], (70,))
    return hidden


def glared(image: Grey) -> Grey:
    """A reflection of a window over two columns and the board beyond."""
    uv = project(camera_at(POSES[1]), corner_points(BOARD)).reshape(6, 7, 2)
    step = uv[:, 1] - uv[:, 0]
    left, right = uv[:, 4] - step / 2, uv[:, 6] + 2 * step
    ends = [left[0], right[0], right[5], left[5]]
    bright = np.zeros(image.shape, np.float32)
    down = (uv[5, 4] - uv[0, 4]) / 3
    ends = [ends[0] - down, ends[1] - down, ends[2] + down, ends[3] + down]
    cv2.fillPoly(bright, [np.round(ends).astype(np.int32)], (400.0,))
    lit = image + np.asarray(cv2.GaussianBlur(bright, (0, 0), 4))
    return np.asarray(lit.clip(0, 255), np.uint8)


def unchanged(image: Grey) -> Grey:
    return image


@pytest.mark.parametrize(
    ("T", "look", "spoil", "code", "fault", "words"),
    [
        (
            moved(45.0),
            Look(),
            unchanged,
            "board-partly-seen",
            "framing",
            "partly out of",
        ),
        (POSES[1], Look(), glared, "board-partly-seen", "lighting", "others are overexposed"),
        (POSES[1], Look(), covered, "another-board", "object", "uncover the rest of this one"),
        (POSES[1], Look(blur_px=20.0), unchanged, "board-not-found", "focus", "blurred"),
        (
            POSES[1],
            Look(dark=5.0, bright=8.0),
            unchanged,
            "board-not-found",
            "exposure",
            "no contrast",
        ),
        (
            camera_pose(10, 30, 5, 3000),
            Look(bright=220.0),
            unchanged,
            "board-too-small",
            "framing",
            "wide in",
        ),
        (
            POSES[1],
            Look(board=replace(BOARD, inner_corners=(9, 8), square_mm=7.0)),
            unchanged,
            "another-board",
            "object",
            "9 × 8 inner corners was found: rendered board has 7 × 6",
        ),
        (
            POSES[1],
            Look(board=replace(BOARD, inner_corners=(6, 5))),
            unchanged,
            "another-board",
            "object",
            "6 × 5 inner corners was found: rendered board has 7 × 6",
        ),
    ],
)
def test_the_true_reason_is_named_and_never_a_laser_that_is_off(
    T: Floats, look: Look, spoil: Callable[[Grey], Grey], code: str, fault: str, words: str
) -> None:
    image = spoil(picture(T, replace(look, laser=False)))
    with pytest.raises(DetectionError) as refused:
        detect_board(image, BOARD)
    assert (refused.value.code, refused.value.fault) == (code, fault)
    assert words in refused.value.line
    assert "laser" not in refused.value.line.lower()


def test_a_line_over_the_outermost_corners_is_named() -> None:
    image = picture(POSES[1], Look(laser=False)).astype(np.float64)
    uv = project(camera_at(POSES[1]), corner_points(BOARD)).reshape(6, 7, 2)[:, 6]
    along = np.polyfit(uv[:, 1], uv[:, 0], 1)
    v, u = np.mgrid[0 : image.shape[0], 0 : image.shape[1]]
    image += 800 * np.exp(-((u - np.polyval(along, v)) ** 2) / (2 * 4.0**2))
    lit = np.clip(image, 0, 255).astype(np.uint8)
    stripe = drop_faint_stripe(lit, extract_stripe(lit, "v"))
    assert len(stripe.u) > 300
    with pytest.raises(DetectionError, match="laser line covers") as refused:
        detect_board(lit, BOARD, stripe)
    assert (refused.value.code, refused.value.fault) == ("board-partly-seen", "framing")


def test_a_cover_across_the_middle_of_a_board_as_wide_as_the_picture_is_named() -> None:
    wide = replace(BOARD, inner_corners=(9, 6), square_mm=7.0)
    T = camera_pose(5, 30, 2, 135)
    image = picture(T, Look(laser=False, board=wide))
    uv = project(camera_at(T), corner_points(wide)).reshape(6, 9, 2)
    assert len(detect_board(image, wide)) == 54
    down = uv[5] - uv[0]
    ends = [uv[0, 3] - down[3], uv[0, 6] - down[6], uv[5, 6] + down[6], uv[5, 3] + down[3]]
    cv2.fillPoly(image, [np.round(ends).astype(np.int32)], (70,))
    with pytest.raises(DetectionError, match="the others are covered") as refused:
        detect_board(image, wide)
    assert (refused.value.code, refused.value.fault) == ("board-partly-seen", "framing")
    assert "Uncover the whole board" in refused.value.line


@pytest.mark.parametrize(
    ("spacing_px", "words"), [(28.0, "the others are covered"), (8.0, "partly out of")]
)
def test_another_grid_is_the_other_end_of_a_board_only_if_its_squares_are_about_as_large(
    spacing_px: float, words: str
) -> None:
    image = np.full((480, 330), 90, np.uint8)
    cut_off = grid_on(image, 3, 6, (245.0, 95.0), 31.0)
    other = grid_on(image, 5, 6, (20.0, 180.0), spacing_px)
    failure = BoardFailure(cut_off, np.ones(18, np.bool_), None, (cut_off, other))
    refusal = explain_failure(replace(BOARD, inner_corners=(9, 6)), failure)
    assert words in refusal.line


def test_a_square_part_of_a_board_is_cut_off_on_whichever_side_the_picture_ends() -> None:
    image = np.full((480, 330), 90, np.uint8)
    board = replace(BOARD, inner_corners=(9, 6))
    for first_px in ((20.0, 150.0), (155.0, 150.0), (90.0, 20.0), (90.0, 305.0)):
        cut_off = grid_on(image, 6, 6, first_px, 31.0)
        failure = BoardFailure(cut_off, np.ones(36, np.bool_), None, (cut_off,))
        assert "partly out of" in explain_failure(board, failure).line


def grid_on(
    image: Grey, columns: int, rows: int, first_px: tuple[float, float], spacing_px: float
) -> CornerGrid:
    places = np.stack(np.meshgrid(np.arange(columns), np.arange(rows)), axis=-1).reshape(-1, 2)
    uv_px = np.array(first_px) + spacing_px * places
    return CornerGrid(image, np.zeros(image.shape, np.bool_), places, uv_px)


def test_a_board_of_which_no_corner_can_be_measured_is_refused_as_blurred() -> None:
    fine = replace(BOARD, square_mm=5.0)
    image = cv2.GaussianBlur(picture(POSES[1], Look(laser=False, board=fine)), (0, 0), 6)
    with pytest.raises(DetectionError) as refused:
        detect_board(np.asarray(image, np.uint8), fine)
    assert refused.value.code in ("board-blurred", "board-not-found")
    assert "blurred" in refused.value.line
