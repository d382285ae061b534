"""Version 2 of the protocol: poses, trigger pulses, properties, in front of a speaking device."""

import threading
import time
from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np
import pytest

from crenel_hardware import registry
from crenel_hardware.arm.serial_encoder import SerialEncoderArm
from crenel_hardware.errors import DeviceError
from crenel_hardware.interfaces import (
    AnswersWhileSilent,
    ArmReading,
    ArmRecord,
    Button,
    PoseSample,
    PulseSource,
)
from tests.hardware.conformance import ArmBench, ArmConformance
from tests.hardware.reading import (
    button_edges,
    loss_of,
    opened,
    read_readings,
    read_samples,
    read_until,
    select_readings,
    select_samples,
)
from tests.hardware.speaking_arm import (
    FakeArm,
    PtyLine,
    TcpLine,
    hello_2_packet,
    packet,
    pose_payload,
)
from tests.hardware.test_serial_encoder import SerialBench, make_driver, open_error

pytestmark = pytest.mark.device

Driver = SerialEncoderArm


class TestPosesOverTcp(ArmConformance):
    @pytest.fixture
    def bench(self) -> Iterator[ArmBench]:
        first_sequence = (1 << 32) - 300
        with FakeArm(TcpLine(), joints=0, first_sequence=first_sequence, version=2) as arm:
            yield SerialBench(arm)


class TestPosesThatChange(ArmConformance):
    """Over a pseudo-terminal, from an arm that may be silent."""

    @pytest.fixture
    def bench(self, tmp_path: Path) -> Iterator[ArmBench]:
        with FakeArm(PtyLine(tmp_path), joints=0, version=2) as arm:
            arm.properties |= 8
            yield SerialBench(arm)


class TestFiveJointsWithPulses(ArmConformance):
    @pytest.fixture
    def bench(self, tmp_path: Path) -> Iterator[ArmBench]:
        with FakeArm(PtyLine(tmp_path), joints=5, version=2) as arm:
            yield SerialBench(arm)


@pytest.fixture
def poses() -> Iterator[FakeArm]:
    with FakeArm(TcpLine(), joints=0, version=2) as arm:
        yield arm


@pytest.fixture
def joints(tmp_path: Path) -> Iterator[FakeArm]:
    with FakeArm(PtyLine(tmp_path), joints=6, version=2) as arm:
        yield arm


@pytest.fixture
def of_poses(poses: FakeArm) -> Iterator[Driver]:
    with opened(make_driver(poses, timeout_s=5.0)) as driver:
        yield driver


@pytest.fixture
def of_joints(joints: FakeArm) -> Iterator[Driver]:
    with opened(make_driver(joints, timeout_s=5.0)) as driver:
        yield driver


def select_poses(records: list[ArmRecord]) -> list[PoseSample]:
    return [record for record in records if isinstance(record, PoseSample)]


def at_pulses(records: Sequence[ArmRecord]) -> list[ArmReading]:
    return [one for one in select_readings(list(records)) if one.pulse is not None]


def test_both_names_are_the_same_driver() -> None:
    for name in ("bridge", "serial-encoder"):
        driver = registry.arm_driver(name, {"url": "/dev/none"})
        assert isinstance(driver, SerialEncoderArm)
        assert isinstance(driver, PulseSource)
        assert isinstance(driver, AnswersWhileSilent)


def test_the_properties_are_those_of_the_hello(poses: FakeArm) -> None:
    poses.greets = False
    said = hello_2_packet([], 100.0, 0b0111, 5, 17, (1.0, 80.0), "R", "9")
    timer = threading.Timer(0.4, poses.inject, [said])
    timer.start()
    driver = make_driver(poses, setting=17)
    with pytest.raises(DeviceError, match="does not answer a request"):
        driver.open()  # it announces pulses, and hears nothing
    timer.join()
    timer = threading.Timer(0.4, poses.inject, [hello_2_packet([], 100.0, 0b0111, 5, 17)])
    timer.start()
    info = driver.open()
    timer.join()
    assert (info.reports, info.pose_of, info.joint_count) == ("pose", "tool", 0)
    assert (info.stamps, info.free_running, info.pulses_hz) == ("arrival", True, None)
    assert info.buttons == {Button.PRIMARY, Button.BACK}
    driver.close()


def test_poses_are_those_that_were_sent(poses: FakeArm, of_poses: Driver) -> None:
    poses.quaternion = [0.0, 0.60003, 0.0, 0.80004]  # rounded by the bridge
    read_readings(of_poses, 51)
    for pose in select_poses(read_until(of_poses, lambda got: len(got) > 50)):
        assert pose.position_mm == (float(pose.sequence), -80.25, 433.0)
        assert pose.quaternion_xyzw == pytest.approx((0.0, 0.6, 0.0, 0.8), abs=1e-12)
        assert pose.pulse is None
    assert of_poses.health.corrupt == 0


@pytest.mark.parametrize("fault", ["not a number", "infinite", "length"])
def test_what_is_no_pose_is_dropped_at_first(poses: FakeArm, of_poses: Driver, fault: str) -> None:
    read_until(of_poses, select_poses)
    bad_y = {"not a number": np.nan, "infinite": np.inf, "length": 0.0}[fault]
    bad_q = [0.0, 0.6, 0.0, 0.9] if fault == "length" else [0.0, 0.6, 0.0, 0.8]
    at_us = poses.device_us(time.monotonic_ns()) + 1_000_000
    bad = pose_payload(poses.sequence + 1000, at_us, 0, 17, (0, bad_y, 0), bad_q)
    poses.inject(packet(3, bad, 2))
    read_until(of_poses, lambda _: of_poses.health.corrupt == 1)
    assert all(np.isfinite(p.position_mm).all() for p in select_poses(list(of_poses.read(0.5))))
    poses.y_mm, poses.quaternion = bad_y, bad_q
    error = loss_of(of_poses)
    assert "The last 50 poses" in str(error.what)
    assert error.remedy
    with pytest.raises(DeviceError, match="not open"):
        of_poses.read(0.0)


def test_a_button_pressed_at_a_bad_pose_is_not_lost(poses: FakeArm, of_poses: Driver) -> None:
    read_until(of_poses, select_poses)
    with poses._lock:
        poses.buttons, poses.y_mm = 1, float("nan")
    read_until(of_poses, lambda _: of_poses.health.corrupt >= 3)
    poses.y_mm = 0.0
    assert button_edges(read_until(of_poses, button_edges)) == [(Button.PRIMARY, True)]


def test_poses_of_another_tool_or_base_are_an_error(poses: FakeArm, of_poses: Driver) -> None:
    poses.setting = 123456
    error = loss_of(of_poses)
    assert "setting 123456 of tool and coordinate system instead of 17" in str(error.what)
    assert "instead of 17" in open_error(poses.line.url, setting=17)


def test_an_arm_sends_what_it_announced(joints: FakeArm, of_joints: Driver) -> None:
    at_us = joints.device_us(time.monotonic_ns()) + 1_000_000
    pose = pose_payload(joints.sequence + 1000, at_us, 0, 0, (0, 0, 0), (0, 0, 0, 1))
    joints.inject(packet(3, pose, 2))
    assert "announced joints, but sends poses" in str(loss_of(of_joints).what)


def test_samples_of_an_arm_of_poses_are_an_error(poses: FakeArm, of_poses: Driver) -> None:
    poses.joints = 6
    assert "announced 0 joints, but sends 6" in str(loss_of(of_poses).what)


@pytest.mark.parametrize("kind", ["joints", "poses"])
def test_pulses_count_from_one_after_each_start(request: pytest.FixtureRequest, kind: str) -> None:
    arm: FakeArm = request.getfixturevalue(kind)
    driver: Driver = request.getfixturevalue(f"of_{kind}")
    assert arm.pulse_requests[0][1] == 0.0  # of a host that went away
    for rate_hz, every in ((50.0, 10), (125.0, 4)):
        driver.start_pulses(rate_hz)
        records = select_readings(read_until(driver, lambda got: len(at_pulses(got)) > 9))
        at_pulse = at_pulses(records)
        assert [r.pulse for r in at_pulse] == list(range(1, len(at_pulse) + 1))
        assert set(np.diff([r.sequence for r in at_pulse])) == {every}
        first = records.index(at_pulse[0])
        assert at_pulse[0].stamp_ns - records[0].stamp_ns > 0.2e9 or first == 0
    driver.stop_pulses()
    driver.stop_pulses()
    rates = [rate for _, rate in arm.pulse_requests]
    assert list(dict.fromkeys(rates)) == [0.0, 50.0, 125.0]
    assert rates[-1] == 0.0
    later = read_until(driver, lambda got: len(got) > 50)
    assert not at_pulses(later)
    assert driver.health.lost == driver.health.corrupt == 0


def test_pulses_start_while_another_thread_reads(of_joints: Driver) -> None:
    records: list[ArmRecord] = []
    ended = threading.Event()

    def read() -> None:
        while not ended.is_set():
            records.extend(of_joints.read(0.5))

    reader = threading.Thread(target=read)
    reader.start()
    for rate_hz in (100.0, 50.0, 250.0):
        of_joints.start_pulses(rate_hz)
    of_joints.stop_pulses()
    ended.set()
    reader.join()
    assert np.all(np.diff([s.sequence for s in select_samples(records)]) == 1)


def test_pulses_of_a_former_host_mean_nothing(joints: FakeArm, of_joints: Driver) -> None:
    of_joints.start_pulses(250.0)
    read_until(of_joints, at_pulses)
    of_joints.close()
    with opened(make_driver(joints, timeout_s=5.0)) as second:
        assert not at_pulses(read_until(second, lambda got: len(got) > 50))
        second.start_pulses(250.0)
        assert at_pulses(read_until(second, at_pulses))[0].pulse == 1


def test_a_restart_while_the_arm_pulses_is_an_error(joints: FakeArm, of_joints: Driver) -> None:
    of_joints.start_pulses(100.0)
    read_until(of_joints, at_pulses)
    joints.reboot()
    assert "restarted while the camera counted" in str(loss_of(of_joints).what)
    of_joints.open()
    of_joints.start_pulses(100.0)
    assert at_pulses(read_until(of_joints, at_pulses))[0].pulse == 1


def test_pulses_that_another_host_restarts_are_an_error(joints: FakeArm, of_joints: Driver) -> None:
    of_joints.start_pulses(100.0)
    read_until(of_joints, lambda got: len(at_pulses(got)) > 3)
    joints.pulse = 0
    assert "restarted while the camera counted" in str(loss_of(of_joints).what)


def test_a_restart_without_pulses_goes_on(joints: FakeArm, of_joints: Driver) -> None:
    before = read_samples(of_joints, 21)
    joints.reboot()
    after = read_samples(of_joints, 101)
    assert np.all(np.diff([s.stamp_ns for s in before + after]) > 0)


@pytest.mark.parametrize("rate_hz", [0.0, 0.5, 501.0, 1.0, float("nan")])
def test_a_rate_that_is_not_possible_is_refused(of_joints: Driver, rate_hz: float) -> None:
    """By the driver outside of the announced range, by the arm at 1 Hz."""
    with pytest.raises(DeviceError, match="cannot trigger at") as caught:
        of_joints.start_pulses(rate_hz)
    assert "from 1" in str(caught.value.remedy)
    read_readings(of_joints, 4)


def test_an_arm_without_pulses_cannot_be_asked_for_them(tmp_path: Path) -> None:
    with FakeArm(PtyLine(tmp_path), version=1) as arm:
        driver = make_driver(arm)
        with pytest.raises(DeviceError, match="not open"):
            driver.start_pulses(10.0)
        assert driver.open().pulses_hz is None
        with pytest.raises(DeviceError, match="no output for trigger pulses"):
            driver.start_pulses(10.0)
        driver.stop_pulses()
        driver.close()
        driver.stop_pulses()


def test_a_pulse_request_without_an_answer_is_an_error(joints: FakeArm, of_joints: Driver) -> None:
    joints.greets = False
    with pytest.raises(DeviceError, match="does not answer a request"):
        of_joints.start_pulses(10.0)


def test_an_arm_that_was_unplugged_is_not_alive(joints: FakeArm, of_joints: Driver) -> None:
    joints.silent = True
    assert of_joints.is_alive()
    joints.greets = False
    assert not of_joints.is_alive()
    joints.unplug()
    assert not of_joints.is_alive()
    loss_of(of_joints)
