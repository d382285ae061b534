"""A board that looks the same when turned round is numbered by the arm's poses."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from app.metrology.adjustment.board.calibrate import calibrate_board
from app.metrology.adjustment.board.initial_guess import BoardObservation
from app.metrology.adjustment.board.problem import BoardInputs
from app.metrology.targets.chessboard import Chessboard, corner_grid
from app.metrology.transforms import Floats, rigid
from tests.metrology.refusals import refusal_of
from tests.metrology.seen_boards import error_um, session

pytestmark = pytest.mark.slow

EVEN_BOARD = Chessboard("even board", "", (8, 6), 10.0, 0.02, 0.2)


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
