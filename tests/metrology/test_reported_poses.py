"""Readings of an arm: poses to transforms and back, between, on average, and judged; angles."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation, Slerp

from crenel.metrology.arm.kinematics import RobotArm, Tip, flange_poses, tip_centres
from crenel.metrology.arm.pose_plausibility import SETTLED, PosePlausibilityFilter
from crenel.metrology.arm.reading_interpolation import interpolate_readings
from crenel.metrology.arm.reported_poses import (
    blend_poses,
    mean_pose,
    pose_from_transform,
    transforms_from_poses,
)
from crenel_hardware.interfaces import PoseSample
from tests.metrology.refusals import refusal_of

MS = 1_000_000


def random_poses(count: int, seed: int) -> np.ndarray:
    random = np.random.default_rng(seed)
    quaternions = Rotation.random(count, random_state=seed).as_quat()
    return np.hstack([random.uniform(-900, 900, (count, 3)), quaternions])


def test_poses_become_the_same_transforms_as_by_an_independent_library() -> None:
    poses = random_poses(50, 1)
    found = transforms_from_poses(poses)
    R = Rotation.from_quat(poses[:, 3:]).as_matrix()
    np.testing.assert_allclose(found[:, :3, :3], R, atol=1e-14)
    np.testing.assert_array_equal(found[:, :3, 3], poses[:, :3])
    for T in found:
        back = transforms_from_poses(pose_from_transform(T)[None])[0]
        np.testing.assert_allclose(back, T, atol=1e-12)


@given(st.integers(0, 1000), st.floats(0, 1), st.booleans())
def test_between_two_poses_the_rotation_is_spherical(seed: int, share: float, flip: bool) -> None:
    a, b = random_poses(2, seed)
    expected = Slerp([0, 1], Rotation.from_quat([a[3:], b[3:]]))(share)
    if flip:  # the same rotation
        b = np.concatenate([b[:3], -b[3:]])
    found = blend_poses(a[None], b[None], np.array([share]))[0]
    np.testing.assert_allclose(found[:3], a[:3] + share * (b[:3] - a[:3]), atol=1e-9)
    assert (Rotation.from_quat(found[3:]).inv() * expected).magnitude() < 1e-7
    assert np.linalg.norm(found[3:]) == pytest.approx(1.0)


def test_poses_are_interpolated_by_their_time() -> None:
    poses = random_poses(3, 4)
    stamps = np.array([0, 4 * MS, 100 * MS])
    wanted = np.array([0, MS, 50 * MS, 101 * MS])
    found = interpolate_readings("pose", stamps, poses, wanted, 25 * MS)
    np.testing.assert_array_equal(found[0], poses[0])
    np.testing.assert_allclose(found[1, :3], 0.75 * poses[0, :3] + 0.25 * poses[1, :3])
    assert np.isnan(found[2:]).all()  # in a gap, and after the end


def test_the_mean_pose_does_not_depend_on_the_signs_of_quaternions() -> None:
    random = np.random.default_rng(3)
    random_turn = Rotation.random(random_state=5)
    turns = Rotation.from_rotvec(1e-4 * random.normal(size=(400, 3))) * random_turn
    poses = np.hstack([random.normal(0, 0.01, (400, 3)) + [1, 2, 3], turns.as_quat()])
    poses[::3, 3:] *= -1
    mean = mean_pose(poses)
    np.testing.assert_allclose(mean[:3], poses[:, :3].mean(axis=0))
    assert (Rotation.from_quat(mean[3:]).inv() * turns.mean()).magnitude() < 1e-9


def test_a_robot_without_a_tip_says_so() -> None:
    pose = random_poses(1, 2)
    tipped = RobotArm("robot", "R-1", Tip(1.0, 2.0, 3.0, 6.0))
    expected = flange_poses(tipped, pose)[0] @ [1.0, 2.0, 3.0, 1.0]
    np.testing.assert_allclose(tip_centres(tipped, pose)[0], expected[:3])
    assert refusal_of(tip_centres, RobotArm("robot", "R-1"), pose).code == "tip-missing"


def sample(ms: int, pose: np.ndarray) -> PoseSample:
    x, y, z, qx, qy, qz, qw = pose.tolist()
    return PoseSample(ms, ms * MS, (x, y, z), (qx, qy, qz, qw))


Judge = PosePlausibilityFilter[PoseSample]


@pytest.fixture
def judge() -> Judge:
    return PosePlausibilityFilter()


HERE = np.array([500.0, 0.0, 300.0, 0.0, 0.0, 0.0, 1.0])
MOVED = np.array([0.01, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0])
FAR = np.array([1400.0, 0.0, 300.0, 0.0, 0.0, 0.0, 1.0])
EAST = np.array([1.0, 0, 0, 0, 0, 0, 0])


@pytest.mark.parametrize(
    ("wrong", "kind"),
    [
        (np.array([np.nan, 0, 0, 0, 0, 0, 1]), "number"),
        (np.array([500.0, 0, 300, 0, 0, 0, 1.01]), "quaternion"),
        (FAR, "jump"),
        (np.array([500.0, 0, 300, 0, 0, 1, 0]), "jump"),
    ],
)
def test_a_pose_that_cannot_be_is_held_back(judge: Judge, wrong: np.ndarray, kind: str) -> None:
    good = judge.filter([sample(0, HERE), sample(4, wrong), sample(8, HERE + MOVED)])
    assert [one.sequence for one in good] == [0, 8]
    assert judge.newest is not None
    assert judge.newest.kind == kind
    assert judge.newest.error.remedy
    assert judge.first_between(3 * MS, 5 * MS) is judge.newest
    assert judge.first_between(5 * MS, 9 * MS) is None


def test_poses_that_stay_elsewhere_are_accepted_there_and_reported(judge: Judge) -> None:
    stays = [sample(4 + 4 * i, FAR) for i in range(SETTLED + 3)]
    good = judge.filter([sample(0, HERE), *stays])
    assert [one.sequence for one in good] == [0, *(one.sequence for one in stays[SETTLED:])]
    assert judge.newest is not None
    assert judge.newest.kind == "moved-frame"
    assert "900" in str(judge.newest.error.text)


def test_within_a_scan_poses_of_another_frame_are_held_back_until_they_leap_back(
    judge: Judge,
) -> None:
    judge.keeps_frame = True
    away = [sample(4 + 4 * i, FAR + i * MOVED) for i in range(500)]
    after_a_gap = [sample(4000 + 4 * i, FAR + i * MOVED) for i in range(SETTLED + 3)]
    back = [sample(4100 + 4 * i, HERE + MOVED) for i in range(3)]
    good = judge.filter([sample(0, HERE), *away, *after_a_gap, *back])
    assert [one.sequence for one in good] == [0, *(one.sequence for one in back)]
    judge.filter(away_again := [sample(4150 + 4 * i, FAR) for i in range(SETTLED)])
    judge.keeps_frame = False  # the scan ends
    good = judge.filter([sample(4300 + 4 * i, FAR) for i in range(3)])
    assert [one.sequence for one in good] == [4304, 4308]
    assert judge.rejected_count == len(away) + len(after_a_gap) + len(away_again) + 1


def test_poses_that_the_network_held_back_are_one_frame(judge: Judge) -> None:
    """1 m/s; those of 0.1 s come at once, stamped as they come."""
    judge.keeps_frame = True
    stamps_ms = [300 if 50 <= i <= 75 else 4 * i for i in range(150)]
    path = [sample(at, HERE + [4.0 * i, 0, 0, 0, 0, 0, 0]) for i, at in enumerate(stamps_ms)]
    good = judge.filter(path)
    assert [one.sequence for one in good[-70:]] == stamps_ms[-70:]


def test_an_arm_that_reconnects_may_be_anywhere(judge: Judge) -> None:
    judge.filter([sample(0, HERE)])
    judge.forget_place()
    assert len(judge.filter([sample(4, FAR)])) == 1


def test_a_fast_robot_passes(judge: Judge) -> None:
    path = [sample(4 * i, HERE + [8.0 * i, 0, 0, 0, 0, 0, 0]) for i in range(100)]  # 2 m/s
    assert len(judge.filter(path)) == 100


NOISE_MM, PERIOD_MS = 0.001, 4


def noisy_poses(count: int, first: int = 0) -> list[PoseSample]:
    """Of an arm at rest whose encoders show noise."""
    rng = np.random.default_rng(first + 1)
    noise = np.zeros((count, 7))
    noise[:, :3] = rng.normal(0.0, NOISE_MM, (count, 3))
    return [sample(PERIOD_MS * (first + i), HERE + noise[i]) for i in range(count)]


def repeated(pose: PoseSample, count: int, first: int) -> list[PoseSample]:
    again = np.array(pose.reading)
    return [sample(PERIOD_MS * (first + i), again) for i in range(count)]


def test_a_pose_sent_again_and_again_is_held_back_from_its_first_repetition(judge: Judge) -> None:
    honest = noisy_poses(400)
    assert judge.filter(honest) == honest
    frozen = repeated(honest[-1], 250, 400)
    assert judge.filter(frozen[:20]) == []
    assert judge.judged_ns == honest[-1].stamp_ns, "the first of them wait"
    assert judge.filter(frozen[20:]) == []
    assert judge.rejected_count == len(frozen)
    assert judge.newest is not None
    assert judge.newest.kind == "frozen"
    assert "old pose" in str(judge.newest.error.why)
    # it may have moved in the meantime
    later = noisy_poses(100, 650)
    there = [np.array(one.reading) + 90.0 * EAST for one in later]
    moved = [sample(PERIOD_MS * (650 + i), pose) for i, pose in enumerate(there)]
    assert judge.filter(moved) == moved


def test_a_few_equal_poses_are_late_but_not_lost(judge: Judge) -> None:
    honest = noisy_poses(400)
    judge.filter(honest)
    twice = repeated(honest[-1], 3, 400)
    assert judge.filter(twice) == []
    after = noisy_poses(1, 403)
    assert judge.filter(after) == [*twice, *after]
    assert judge.rejected_count == 0
    # such an arm is believed from now on
    assert len(judge.filter(repeated(after[0], 250, 404))) == 250


def test_poses_that_wait_at_the_end_are_released(judge: Judge) -> None:
    honest = noisy_poses(400)
    twice = repeated(honest[-1], 3, 400)
    judge.filter([*honest, *twice])
    assert judge.release() == twice


def test_an_arm_that_reports_commanded_poses_may_rest(judge: Judge) -> None:
    """Its poses are equal at rest, and turn back nowhere while it moves."""
    path = [sample(PERIOD_MS * i, HERE + 0.2 * i * EAST) for i in range(1000)]
    resting = repeated(path[-1], 1000, 1000)
    back = [sample(PERIOD_MS * (2000 + i), HERE + 0.2 * (999 - i) * EAST) for i in range(1000)]
    assert len(judge.filter([*path, *resting, *back])) == 3000


STAMPS_NS = np.array([1_000, 2_000, 3_000, 9_000])
Q_RAD = np.array([[0.0, 3.1], [0.2, -3.1], [0.4, -3.0], [1.0, -2.0]])
GAP_NS = 2_000


def test_a_stamp_between_two_samples_lies_on_the_line_between_them() -> None:
    found = interpolate_readings("joints", STAMPS_NS, Q_RAD, np.array([2_250, 2_000]), GAP_NS)
    np.testing.assert_allclose(found, [[0.25, -3.075], [0.2, -3.1]], atol=1e-12)


def test_a_joint_that_passes_the_half_turn_is_followed_the_short_way() -> None:
    ((_, q2),) = interpolate_readings("joints", STAMPS_NS, Q_RAD, np.array([1_500]), GAP_NS)
    np.testing.assert_allclose(np.exp(1j * q2), -1.0, atol=1e-12)


def test_outside_the_samples_and_in_gaps_there_is_nothing() -> None:
    found = interpolate_readings("joints", STAMPS_NS, Q_RAD, np.array([999, 9_001, 4_000]), GAP_NS)
    assert np.isnan(found).all()
    assert np.isfinite(interpolate_readings("joints", STAMPS_NS, Q_RAD, STAMPS_NS, GAP_NS)).all()


def test_without_samples_there_is_nothing() -> None:
    found = interpolate_readings("joints", STAMPS_NS[:0], Q_RAD[:0], np.array([1_000]), GAP_NS)
    assert found.shape == (1, 2)
    assert np.isnan(found).all()
