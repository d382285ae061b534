"""What of an arm's readings can be true, and what cannot."""

import numpy as np
import pytest

from crenel.metrology.arm.joint_plausibility import EQUAL_FROZEN, PlausibilityFilter, limits_error
from crenel.metrology.arm.kinematics import Arm
from crenel.metrology.transforms import Floats
from tests.metrology.joint_motions import ARM, MS, NOISE_RAD, Sample
from tests.metrology.joint_motions import judged as judged_each
from tests.metrology.joint_motions import samples as samples_at
from tests.present import present

FINE, COARSE = 2 * np.pi / 2**22, 2 * np.pi / 2**14


def samples(q_rad: Floats) -> list[Sample]:
    return samples_at(q_rad, 1000.0)


def swept(count: int, quantum_rad: float = FINE, seed: int = 1) -> Floats:
    """The joints at rest for a second, then moving; J4 always at rest."""
    rng = np.random.default_rng(seed)
    t = np.maximum(np.arange(count) * 1e-3 - 1.0, 0.0)
    q = 0.4 * (1 - np.cos(2.0 * t))[:, None] * np.array([1.0, -1.0, 0.5, 0.0, 1.0, 2.0])
    q = q + 0.3 + rng.normal(0.0, NOISE_RAD, q.shape)
    return np.asarray(np.rint(q / quantum_rad) * quantum_rad)


def judged(
    readings: list[Sample], arm: Arm | None = ARM
) -> tuple[PlausibilityFilter[Sample], Floats]:
    """The judge, and the stamps in ms of what it let pass."""
    found = judged_each(readings, arm=arm)
    stamps = np.array([one.stamp_ns // MS for one in readings])
    return found.judge, stamps[found.passed]


@pytest.mark.parametrize("quantum_rad", [FINE, COARSE], ids=["fine", "coarse"])
def test_an_honest_arm_passes_whole(quantum_rad: float) -> None:
    """Also where a joint stands whose encoder is too coarse to show its noise."""
    judge, passed = judged(samples(swept(5000, quantum_rad)))
    assert judge.newest is None
    np.testing.assert_array_equal(passed, np.arange(5000))


def test_motion_as_fast_as_a_persons_hand_passes() -> None:
    t = np.arange(3000) * 1e-3
    q = np.repeat(np.sin(8.0 * t)[:, None], 6, axis=1)
    assert judged(samples(q))[0].rejected_count == 0


def test_a_frozen_encoder_is_found_and_nothing_of_it_passes() -> None:
    q = swept(4000)
    q[2000:3000, 4] = q[2000, 4]
    judge, passed = judged(samples(q))
    assert judge.newest is not None
    assert judge.first is not None
    assert (judge.first.kind, judge.first.joint) == ("frozen", "J5")
    assert f"{EQUAL_FROZEN} consecutive readings" in judge.newest.error.line
    assert judge.impossible == 0
    assert not set(passed) & set(range(2001, 3000))
    assert passed[-1] == 3999


def test_a_frozen_encoder_of_a_joint_that_stands_is_found_too() -> None:
    q = swept(3000)
    q[2000:2500, 3] = q[2000, 3]
    judge, passed = judged(samples(q))
    assert judge.frozen == 499
    assert judge.impossible == 0
    assert judge.first_between(2001 * MS, 2499 * MS) is not None
    assert judge.first_between(0, 2000 * MS) is None
    assert judge.judged_ns == 2999 * MS
    assert len(passed) == 3000 - 499


def test_a_few_equal_readings_are_let_go_in_their_order() -> None:
    q = swept(3000)
    few = EQUAL_FROZEN - 5
    q[2000 : 2000 + few, 3] = q[2000, 3]
    judge, passed = judged(samples(q))
    assert judge.rejected_count == 0
    np.testing.assert_array_equal(passed, np.arange(3000))


def test_one_wrong_reading_is_left_out_alone() -> None:
    q = swept(4000)
    wrong = np.arange(100, 4000, 211)
    q[wrong, 2] += np.pi / 2
    judge, passed = judged(samples(q))
    assert judge.impossible == len(wrong)
    assert not set(passed) & set(wrong.tolist())
    assert "90.0° away from where it can be" in present(judge.first).error.line


def test_readings_outside_the_limits_are_left_out_and_named() -> None:
    q = swept(2000)
    q[1500:1503, 0] += 6 * np.pi
    judge, passed = judged(samples(q))
    assert (judge.impossible, judge.outside) == (3, 3)
    assert not set(passed) & {1500, 1501, 1502}
    line = present(judge.newest).error.line
    assert "joint J1 reads" in line
    assert "−171.9° to 171.9°" in line


def test_no_number_is_no_reading() -> None:
    q = swept(100)
    q[50, 5] = np.nan
    judge, passed = judged(samples(q), None)
    assert str(present(judge.newest).error.what) == "the reading of joint J6 is not a number"
    assert len(passed) == 99


def test_a_joint_that_a_knock_may_have_moved_is_believed_after_a_while() -> None:
    q = swept(1500)
    q[300:, 1] += 0.008
    judge, passed = judged(samples(q))
    assert judge.impossible == 500
    np.testing.assert_array_equal(passed, [*range(300), *range(800, 1500)])


def test_a_joint_that_jumped_farther_is_not() -> None:
    q = swept(3000)
    q[300:, 1] += 1.0
    judge, passed = judged(samples(q))
    assert present(judge.newest).kind == "slip"
    np.testing.assert_array_equal(passed, np.arange(300))


def test_an_arm_that_is_elsewhere_with_several_joints_is_believed_after_a_while() -> None:
    """Readings of the way there are missing: no encoder slipped, and the scan goes on."""
    q = swept(3000)
    q[300:, [1, 3, 4]] += [0.4, -0.3, 0.5]
    judge, passed = judged(samples(q))
    assert present(judge.first).kind == "jump"
    np.testing.assert_array_equal(passed, [*range(300), *range(800, 3000)])


def test_after_a_gap_the_arm_may_be_anywhere() -> None:
    first, then = samples(swept(100)), samples(swept(100) + 1.0)
    later = [Sample(one.stamp_ns + 500 * MS, one.joints_rad) for one in then]
    assert judged([*first, *later])[0].rejected_count == 0


def test_limits_are_those_of_the_arm_with_a_little_beyond_the_stop() -> None:
    assert limits_error([0.0, 3.005, 0, 0, 0, -3.005], ARM) is None
    refusal = present(limits_error([0.0, 0.0, 0, 0, 3.5, 0], ARM))
    assert "joint J5 reads 200.5°" in refusal.line
