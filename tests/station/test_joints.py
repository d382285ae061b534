"""The joints at a stamp, their mean, and whether the arm is still."""

import threading

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from crenel.metrology.arm.kinematics import RobotArm, tip_centres
from crenel.station.devices.reading_buffer import (
    RING_SAMPLES,
    ReadingRing,
    ReadingWindow,
    average_readings,
)
from crenel.station.devices.stillness import stillness
from crenel_hardware.interfaces import ArmInfo, JointSample, PoseSample
from tests.present import present
from tests.station.conftest import REST_RAD, six_axis_arm

MS = 1_000_000


def info(joint_count: int) -> ArmInfo:
    return ArmInfo("arm", "1", joint_count, 500.0)


def ring_of(count: int, period_ns: int = 2 * MS) -> ReadingRing:
    ring = ReadingRing(info(2))
    ring.extend([JointSample(i, i * period_ns, (0.001 * i, -0.002 * i)) for i in range(count)])
    return ring


@given(st.integers(min_value=0, max_value=198 * MS))
def test_a_pose_between_two_samples_lies_on_the_line_between_them(stamp_ns: int) -> None:
    found = present(ring_of(100).at(stamp_ns))
    np.testing.assert_allclose(found, np.array([0.001, -0.002]) * stamp_ns / (2 * MS), atol=1e-12)


def test_outside_the_samples_there_is_no_pose() -> None:
    ring = ring_of(100)
    assert ring.at(-1) is None
    assert ring.at(198 * MS + 1) is None


def test_a_gap_is_not_bridged() -> None:
    ring = ReadingRing(info(1))
    ring.extend([JointSample(0, 0, (0.0,)), JointSample(9, 40 * MS, (1.0,))])
    assert ring.at(10 * MS) is None
    assert ring.at(40 * MS) is not None


def test_an_encoder_that_rolls_over_is_interpolated_the_short_way() -> None:
    ring = ReadingRing(info(1))
    ring.extend([JointSample(0, 0, (np.pi - 0.01,)), JointSample(1, 2 * MS, (-np.pi + 0.03,))])
    found = present(ring.at(MS))
    assert np.cos(found[0] - (np.pi + 0.01)) == pytest.approx(1.0, abs=1e-12)
    mean = average_readings(ring.between(0, 2 * MS)).reading
    assert np.cos(mean[0] - (np.pi + 0.01)) == pytest.approx(1.0, abs=1e-12)


def test_the_ring_forgets_its_oldest_and_keeps_its_order() -> None:
    ring = ring_of(RING_SAMPLES + 500)
    assert ring.at(499 * 2 * MS) is None
    first = ring.between(0, 10**18)
    assert len(first) == RING_SAMPLES
    assert (np.diff(first.stamps_ns) == 2 * MS).all()
    assert first.stamps_ns[0] == 500 * 2 * MS


def test_a_sample_that_goes_back_in_time_is_left_out() -> None:
    ring = ring_of(3)
    ring.extend([JointSample(3, 3 * MS, (9.0, 9.0)), JointSample(4, 6 * MS, (0.003, -0.006))])
    assert ring.between(0, 10 * MS).stamps_ns.tolist() == [0, 2 * MS, 4 * MS, 6 * MS]


def test_a_reader_waits_for_the_sample_after_its_stamp() -> None:
    ring = ring_of(3)
    later = threading.Timer(0.05, ring.extend, [[JointSample(3, 6 * MS, (0.003, -0.006))]])
    later.start()
    found = ring.at(5 * MS, wait_s=5.0)
    later.join()
    np.testing.assert_allclose(present(found), [0.0025, -0.005])


def window_of(q_rad: np.ndarray) -> ReadingWindow:
    return ReadingWindow("joints", np.arange(len(q_rad), dtype=np.int64) * 2 * MS, q_rad)


def test_encoder_noise_alone_is_still() -> None:
    random = np.random.default_rng(1)
    arm = six_axis_arm()
    windows = (window_of(REST_RAD + 1e-5 * random.normal(size=(150, 6))) for _ in range(200))
    assert sum(stillness(arm, window).still for window in windows) >= 199


def test_a_drift_of_a_tenth_of_a_millimetre_is_not_still_and_is_reported() -> None:
    arm = six_axis_arm()
    drift = np.zeros((150, 6))
    drift[:, 1] = np.linspace(0, 4e-4, 150)
    found = stillness(arm, window_of(REST_RAD + drift))
    tips = tip_centres(arm, REST_RAD + drift[[0, -1]])
    assert not found.still
    # the six blocks' middles span five sixths of the path
    path_um = 1000 * np.linalg.norm(tips[1] - tips[0])
    assert found.moved_um == pytest.approx(5 / 6 * path_um, rel=0.02)
    assert f"{found.moved_um:.0f} µm" in str(found.text)


def test_a_turn_about_the_tip_is_not_still() -> None:
    """The last joint turns the sensor though the tip is near its axis."""
    arm = six_axis_arm()
    turned = np.zeros((150, 6))
    turned[:, 5] = np.linspace(0, 1.5e-3, 150)
    found = stillness(arm, window_of(REST_RAD + turned))
    assert not found.still
    assert found.turned_arcsec == pytest.approx(5 / 6 * 1.5e-3 * 206265, rel=0.02)
    assert found.moved_um < 25


def test_too_few_samples_are_not_called_still() -> None:
    assert not stillness(six_axis_arm(), window_of(np.tile(REST_RAD, (3, 1)))).still


def test_the_mean_comes_with_the_scatter_of_the_samples() -> None:
    random = np.random.default_rng(2)
    q = REST_RAD + 1e-4 * random.normal(size=(400, 6))
    mean = average_readings(window_of(q))
    np.testing.assert_allclose(mean.reading, q.mean(axis=0))
    np.testing.assert_allclose(mean.scatter, 1e-4, rtol=0.15)
    assert mean.samples == 400


ROBOT = RobotArm("robot", "R-1")


def poses_of(moves_mm: np.ndarray, noise_mm: float, seed: int) -> ReadingWindow:
    """At 250 Hz, along x by ``moves_mm``, with noise of position and rotation."""
    random = np.random.default_rng(seed)
    count = len(moves_mm)
    at = [500.0, 20.0, 300.0] + noise_mm * random.normal(size=(count, 3))
    at[:, 0] += moves_mm
    turns = Rotation.from_rotvec([0.3, 1.2, -0.4] + 2e-5 * random.normal(size=(count, 3)))
    stamps_ns = np.arange(count, dtype=np.int64) * 4 * MS
    return ReadingWindow("pose", stamps_ns, np.hstack([at, turns.as_quat()]))


@pytest.mark.parametrize("noise_mm", [0.0, 0.01, 0.1])
def test_the_noise_of_a_robot_at_rest_is_still(noise_mm: float) -> None:
    found = [stillness(ROBOT, poses_of(np.zeros(75), noise_mm, i)).still for i in range(100)]
    assert sum(found) >= 98


@pytest.mark.parametrize("noise_mm", [0.0, 0.01])
def test_a_robot_that_creeps_is_not_still(noise_mm: float) -> None:
    found = stillness(ROBOT, poses_of(np.linspace(0, 0.2, 75), noise_mm, 1))
    assert not found.still
    assert found.moved_um == pytest.approx(167, abs=15)


def test_a_ring_of_poses_interpolates_and_averages_them() -> None:
    poses = poses_of(np.linspace(0, 1, 75), 0.0, 2)
    ring = ReadingRing(ArmInfo("robot", "R-1", 0, 250.0, reports="pose"))
    ring.extend(
        [
            PoseSample(i, int(stamp), (one[0], one[1], one[2]), (one[3], one[4], one[5], one[6]))
            for i, (stamp, one) in enumerate(
                zip(poses.stamps_ns, poses.readings.tolist(), strict=True)
            )
        ]
    )
    between = present(ring.at(6 * MS))
    np.testing.assert_allclose(between[:3], poses.readings[1:3, :3].mean(axis=0))
    mean = average_readings(ring.between(0, 300 * MS))
    np.testing.assert_allclose(mean.reading[:3], poses.readings[:, :3].mean(axis=0))
    assert mean.scatter.shape == (7,)
