"""Boards that look the same when turned round are numbered by the poses; reasons of refusals."""

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from typing import Any

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from crenel.metrology.adjustment.board.calibrate import calibrate_board
from crenel.metrology.adjustment.board.initial_guess import BoardObservation
from crenel.metrology.adjustment.board.problem import BoardInputs
from crenel.metrology.chessboard.detect_board import detect_board
from crenel.metrology.chessboard.failure_evidence import BoardFailure, explain_failure
from crenel.metrology.chessboard.laser_light import drop_faint_stripe
from crenel.metrology.chessboard.missing_corners import CornerGrid
from crenel.metrology.sensor.camera import project
from crenel.metrology.stripe import extract_stripe
from crenel.metrology.targets.chessboard import Chessboard, corner_grid, corner_points
from crenel.metrology.transforms import Floats, rigid
from tests.metrology.boards import BOARD, POSES, Look, camera_pose, picture
from tests.metrology.refusals import detection_refusal_of, refusal_of
from tests.metrology.seen_boards import camera_at, error_um, session
from tests.pictures import blur, halve

pytestmark = pytest.mark.slow

EVEN_BOARD = Chessboard("even board", "", (8, 6), 10.0, 0.02, 0.2)
Grey = NDArray[np.uint8]


def either_way(seen: BoardObservation, turned: bool) -> BoardObservation:
    """A picture in which the colours allow two numberings."""
    one = seen.detection.number
    other = len(corner_grid(EVEN_BOARD)) - 1 - one
    first, second = (other, one) if turned else (one, other)
    return replace(seen, detection=replace(seen.detection, number=first, other_numbers=(second,)))


def ambiguous_session(turned: tuple[bool, ...]) -> BoardInputs:
    given = session(0, board=EVEN_BOARD)
    seen = tuple(either_way(one, way) for one, way in zip(given.observations, turned, strict=True))
    return replace(given, observations=seen)


def turned_aside(readings: Floats, pose: int) -> Floats:
    """A flange that the robot reports turned by 40 degrees."""
    moved = readings.copy()
    moved[pose] = moved[pose] @ rigid(Rotation.from_rotvec([0.7, 0, 0]).as_matrix(), np.zeros(3))
    return moved


def test_the_flanges_turns_tell_the_numbering() -> None:
    found = calibrate_board(ambiguous_session((False, True, False, False, True, True, False, True)))
    assert all(pose.used for pose in found.poses)
    assert error_um(found) < 3 * found.uncertainty.total_um


@pytest.mark.parametrize("wrong", [0, 4])
def test_a_pose_that_does_not_tell_is_left_out_and_named(wrong: int) -> None:
    """Be it the first, to which the others are compared otherwise."""
    given = ambiguous_session((False, True, False, False, True, True, False, True))
    found = calibrate_board(replace(given, readings=turned_aside(given.readings, wrong)))
    (left_out,) = (pose for pose in found.poses if not pose.used)
    assert left_out.number == wrong + 1
    assert "looks the same when rotated" in str(left_out.reason)
    assert error_um(found) < 3 * found.uncertainty.total_um


def test_where_most_poses_do_not_tell_the_board_is_refused() -> None:
    given = ambiguous_session((False,) * 8)
    readings = given.readings.copy()
    readings[:, :3, :3] = Rotation.random(len(readings), random_state=0).as_matrix()
    refusal = refusal_of(calibrate_board, replace(given, readings=readings))
    assert refusal.code == "board-ambiguous"


def moved(right_mm: float) -> Floats:
    T = POSES[1].copy()
    T[0, 3] += right_mm
    return T


def seen_corners(T: Floats = POSES[1], board: Chessboard = BOARD) -> Floats:
    """(rows, columns, 2) where the corners are in a picture."""
    columns, rows = board.inner_corners
    return project(camera_at(T), corner_points(board)).reshape(rows, columns, 2)


def covered(image: Grey) -> Grey:
    """Paper over all but three columns."""
    uv = seen_corners()
    edge = (uv[:, 2] + uv[:, 3]) / 2
    down = edge[5] - edge[0]
    left, across = [edge[0] - down, edge[5] + down], 8 * (uv[[5, 0], 6] - uv[[5, 0], 5])
    paper = [*left, left[1] + across[0], left[0] + across[1]]
    hidden = image.copy()
    cv2.fillPoly(hidden, [np.round(paper).astype(np.int32)], (70,))
    return hidden


def glared(image: Grey) -> Grey:
    """A reflection of a window over two columns and the board beyond."""
    uv = seen_corners()
    step = uv[:, 1] - uv[:, 0]
    left, right = uv[:, 4] - step / 2, uv[:, 6] + 2 * step
    ends = [left[0], right[0], right[5], left[5]]
    bright = np.zeros(image.shape, np.float32)
    down = (uv[5, 4] - uv[0, 4]) / 3
    ends = [ends[0] - down, ends[1] - down, ends[2] + down, ends[3] + down]
    cv2.fillPoly(bright, [np.round(ends).astype(np.int32)], (400.0,))
    lit = image + np.asarray(cv2.GaussianBlur(bright, (0, 0), 4))
    return np.asarray(lit.clip(0, 255), np.uint8)


def shown(T: Floats = POSES[1], spoil: Callable[[Grey], Grey] = np.asarray, **look: Any) -> Grey:
    return spoil(picture(T, Look(laser=False, **look)))


def small(T: Floats = POSES[1], spoil: Callable[[Grey], Grey] = np.asarray) -> Grey:
    return halve(shown(T, spoil))


DIM = partial(shown, dark=5.0, bright=8.0)
FAR = partial(shown, camera_pose(10, 30, 5, 3000), bright=220.0)


@pytest.mark.parametrize(
    ("image", "code", "fault", "words"),
    [
        (partial(small, moved(45.0)), "board-partly-seen", "framing", "partly out of"),
        (partial(small, spoil=glared), "board-partly-seen", "lighting", "others are overexposed"),
        (partial(small, spoil=covered), "another-board", "object", "uncover the rest of this one"),
        (partial(shown, blur_px=20.0), "board-not-found", "focus", "blurred"),
        (DIM, "board-not-found", "exposure", "no contrast"),
        (partial(DIM, noise=2.0), "board-not-found", "exposure", "the picture is dim"),
        (FAR, "board-too-small", "framing", "wide in"),
    ],
)
def test_the_reason_is_true(image: Callable[[], Grey], code: str, fault: str, words: str) -> None:
    refusal = detection_refusal_of(detect_board, image(), BOARD)
    assert (refusal.code, refusal.fault) == (code, fault)
    assert words in refusal.line
    assert "laser" not in refusal.line.lower()


def test_a_line_over_the_outermost_corners_is_named() -> None:
    image = shown().astype(np.float64)
    uv = seen_corners()[:, 6]
    along = np.polyfit(uv[:, 1], uv[:, 0], 1)
    v, u = np.mgrid[0 : image.shape[0], 0 : image.shape[1]]
    image += 800 * np.exp(-((u - np.polyval(along, v)) ** 2) / (2 * 4.0**2))
    lit = np.clip(image, 0, 255).astype(np.uint8)
    stripe = drop_faint_stripe(lit, extract_stripe(lit, "v"))
    assert len(stripe.u) > 300
    refusal = detection_refusal_of(detect_board, lit, BOARD, stripe)
    assert (refusal.code, refusal.fault) == ("board-partly-seen", "framing")
    assert "laser line covers" in refusal.line


def test_a_cover_across_the_middle_of_a_board_as_wide_as_the_picture_is_named() -> None:
    wide = replace(BOARD, inner_corners=(9, 6), square_mm=7.0)
    T = camera_pose(5, 30, 2, 135)
    image = shown(T, board=wide)
    uv = seen_corners(T, wide)
    assert len(detect_board(image, wide)) == 54
    down = uv[5] - uv[0]
    ends = [uv[0, 3] - down[3], uv[0, 6] - down[6], uv[5, 6] + down[6], uv[5, 3] + down[3]]
    cv2.fillPoly(image, [np.round(ends).astype(np.int32)], (70,))
    refusal = detection_refusal_of(detect_board, image, wide)
    assert (refusal.code, refusal.fault) == ("board-partly-seen", "framing")
    assert "the others are covered" in refusal.line
    assert "Uncover the whole board" in refusal.line


@pytest.mark.parametrize(
    ("spacing_px", "words"), [(28.0, "the others are covered"), (8.0, "partly out of")]
)
def test_another_end_of_a_board_has_squares_about_as_large(spacing_px: float, words: str) -> None:
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
    refusal = refusal_of(detect_board, blur(shown(board=fine), 6), fine)
    assert refusal.code in ("board-blurred", "board-not-found")
    assert "blurred" in refusal.line
