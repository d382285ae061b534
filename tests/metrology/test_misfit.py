"""Coordinates that do not fit their arm as they are: why not, and what is stated otherwise."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from crenel.errors import OperationError
from crenel.metrology.arm.identification.checks.coordinates import (
    check_coordinates,
    check_coordinates_agree,
)
from crenel.metrology.arm.identification.identify import Identification, identify
from crenel.metrology.arm.identification.observations import BASE, ArmObservations, Coordinates
from crenel.metrology.arm.identification.parameter_selection import candidates_of
from crenel.metrology.arm.identification.parameters import tip_index
from crenel.metrology.arm.identification.robust_solve import fit_arm
from crenel.metrology.arm.kinematics import Arm
from tests.metrology.refusals import refusal_of
from tests.running.usual import usual
from tests.simulated_robots import Tracker, built, measure, postures, robot

Session = tuple[Arm, Coordinates]
Spoil = Callable[[Coordinates], Coordinates]
Fault = tuple[int, float, float]
"""A joint, its sign, and its angle in degrees by which its zero is off."""


def drawn(arm: Arm, poses: int, seed: int = 2, full: bool = False) -> Session:
    rng = np.random.default_rng(seed)
    true, q = built(arm, rng), postures(arm, poses, rng)
    return arm, measure(true, q, Tracker.somewhere(rng), rng, full)


@pytest.fixture(scope="module")
def session() -> Session:
    return drawn(robot(6), 60)


@pytest.fixture(scope="module")
def short() -> Session:
    """Of an arm without its last joint: two thirds of the pairs of faults are left to be tried."""
    return drawn(replace(robot(6), joints=robot(6).joints[:5]), 30)


def moved(found: Coordinates, row: int) -> Coordinates:
    """The instrument stands elsewhere from this row on."""
    turn, points = Rotation.from_rotvec([0.4, -0.9, 1.7]), found.points_mm.copy()
    points[row:] = turn.apply(points[row:]) + [9000.0, -2500.0, 900.0]
    return replace(found, points_mm=points)


def turned(q_rad: np.ndarray, joint: int, sign: float, offset_deg: float) -> np.ndarray:
    changed = q_rad.copy()
    changed[:, joint] = sign * changed[:, joint] - np.deg2rad(offset_deg)
    return changed


FAULTS: tuple[tuple[Spoil, str], ...] = (
    (lambda c: replace(c, q_rad=turned(c.q_rad, 2, -1, 0)), "Reverse the sign of joint J3"),
    (lambda c: replace(c, q_rad=turned(c.q_rad, 1, 1, 90)), r"theta_deg of joint J2 .* by \+90"),
    (lambda c: replace(c, points_mm=c.points_mm[:, [1, 0, 2]]), "must be right-handed"),
    (lambda c: replace(c, q_rad=np.roll(c.q_rad, 1, axis=0)), "angles of the next row"),
    (lambda c: replace(c, frame=BASE), "another name than base"),
    (lambda c: moved(c, 30), "moved before line 32, .* name of its own in the column frame"),
    (lambda c: replace(c, points_mm=c.points_mm / 25.4), "if they were in inches, .* millimetres"),
    (lambda c: replace(c, points_mm=c.points_mm / 10), "if they were in centimetres"),
)
NAMES = ("sign", "zero", "mirrored", "row", "base", "moved", "inches", "centimetres")


@pytest.mark.slow
@pytest.mark.parametrize(("spoil", "says"), FAULTS, ids=NAMES)
def test_the_fault_is_named(session: Session, spoil: Spoil, says: str) -> None:
    arm, found = session
    with pytest.raises(OperationError, match=says) as refused:
        check_coordinates(arm, ArmObservations(coordinates=(spoil(found),)))
    assert refused.value.code == "arm-does-not-fit"


@pytest.mark.slow
def test_inverted_poses_are_named() -> None:
    arm, found = drawn(robot(6), 60, seed=3, full=True)
    assert found.rotations is not None
    back = np.swapaxes(found.rotations, 1, 2)
    points = -np.einsum("nij,nj->ni", back, found.points_mm)
    inverted = replace(found, rotations=back, points_mm=points)
    with pytest.raises(OperationError, match="Give the pose of the marker in the frame of the"):
        check_coordinates(arm, ArmObservations(coordinates=(inverted,)))


@pytest.mark.slow
@pytest.mark.parametrize(
    ("first", "second", "says"),
    usual(
        [
            ((1, 1, 90), (3, -1, 0), r"J2 .* by \+90.*; Reverse the sign of joint J4"),
            ((1, -1, 0), (2, -1, 0), "sign of joint J2 .*; Reverse the sign of joint J3"),
        ],
        1,
        pytest.mark.soak,
    ),
)
def test_two_joint_faults_are_named(short: Session, first: Fault, second: Fault, says: str) -> None:
    arm, found = short
    spoilt = replace(found, q_rad=turned(turned(found.q_rad, *first), *second))
    with pytest.raises(OperationError, match=says):
        check_coordinates(arm, ArmObservations(coordinates=(spoilt,)))


@pytest.mark.soak
def test_three_faults_keep_the_general_reason(short: Session) -> None:
    arm, found = short
    q_rad = turned(turned(turned(found.q_rad, 1, -1, 0), 2, -1, 0), 3, 1, 90)
    given = ArmObservations(coordinates=(replace(found, q_rad=q_rad),))
    assert "joint J" not in str(refusal_of(check_coordinates, arm, given))


def test_an_instrument_that_moved_is_named_with_the_row(session: Session) -> None:
    arm, found = session

    def judged(row: int) -> None:
        points = found.points_mm.copy()
        points[row:, 0] += 1.5
        given = ArmObservations(coordinates=(replace(found, points_mm=points),))
        fit = fit_arm(arm, given.stacked, candidates_of(arm, given))
        check_coordinates_agree(given.stacked, fit)

    judged(0)
    refusal = refusal_of(judged, 20)
    assert refusal.code == "frames-mixed"
    assert f"from line {found.lines[20]} on" in refusal.line


@pytest.mark.slow
def test_too_large_an_uncertainty_is_named(session: Session) -> None:
    arm, found = session

    def stated(sd_mm: float) -> Identification:
        given = replace(found, standard_uncertainty_mm=np.full(len(found.q_rad), sd_mm))
        return identify(arm, ArmObservations(coordinates=(given,)))

    assert any("standard_uncertainty_mm" in str(text) for text in stated(0.3).warnings)
    refusal = refusal_of(stated, 8.0)
    assert refusal.code == "uncertainty-too-large"
    assert "or in another unit" in refusal.line


def test_a_tip_that_was_not_measured_is_held_for_this_reason(session: Session) -> None:
    arm, found = session
    tip = tip_index(arm)
    reflector = ArmObservations(coordinates=(replace(found, marker="reflector"),))
    held = candidates_of(arm, reflector).fixed
    assert {held[tip + k] for k in range(3)} == {"tip"}
    assert "marker" in held.values()
    assert "flange frame" not in held.values()
    assert tip in candidates_of(arm, ArmObservations(coordinates=(found,))).order
