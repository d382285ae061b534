"""Version 2 of the protocol: poses, trigger pulses, properties, in front of a speaking device."""

import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest

from hardware import registry
from hardware.arm.serial_encoder import SerialEncoderArm, from_options
from hardware.errors import DeviceError
from hardware.interfaces import (
    AnswersWhileSilent,
    ArmRecord,
    Button,
    JointSample,
    PoseSample,
    PulseSource,
)
from tests.hardware.conformance import (
    ArmBench,
    ArmConformance,
    button_edges,
    read_until,
    read_until_lost,
    select_readings,
    select_samples,
)
from tests.hardware.speaking_arm import (
    FakeSerialArm,
    PtyLine,
    TcpLine,
    hello_2_packet,
    packet,
    pose_payload,
)
from tests.hardware.test_serial_encoder import SerialBench, open_error

pytestmark = pytest.mark.device


class TestPosesOverTcp(ArmConformance):
    @pytest.fixture
    def bench(self) -> Iterator[ArmBench]:
        arm = FakeSerialArm(TcpLine(), joints=0, first_sequence=(1 << 32) - 300, version=2)
        yield SerialBench(arm)
        arm.stop()


class TestPosesThatChange(ArmConformance):
    """Over a pseudo-terminal, from an arm that may be silent."""

    @pytest.fixture
    def bench(self, tmp_path: Path) -> Iterator[ArmBench]:
        arm = FakeSerialArm(PtyLine(tmp_path), joints=0, version=2)
        arm.properties |= 8
        yield SerialBench(arm)
        arm.stop()


class TestFiveJointsWithPulses(ArmConformance):
    @pytest.fixture
    def bench(self, tmp_path: Path) -> Iterator[ArmBench]:
        arm = FakeSerialArm(PtyLine(tmp_path), joints=5, version=2)
        yield SerialBench(arm)
        arm.stop()


@pytest.fixture
def poses() -> Iterator[FakeSerialArm]:
    arm = FakeSerialArm(TcpLine(), joints=0, version=2)
    yield arm
    arm.stop()


@pytest.fixture
def joints(tmp_path: Path) -> Iterator[FakeSerialArm]:
    arm = FakeSerialArm(PtyLine(tmp_path), joints=6, version=2)
    yield arm
    arm.stop()


@pytest.fixture
def open_driver() -> Iterator[Callable[[FakeSerialArm], SerialEncoderArm]]:
    drivers: list[SerialEncoderArm] = []

    def opened(arm: FakeSerialArm) -> SerialEncoderArm:
        drivers.append(from_options({"url": arm.line.url, "timeout_s": 5.0}))
        drivers[-1].open()
        return drivers[-1]

    yield opened
    for driver in drivers:
        driver.close()


Opener = Callable[[FakeSerialArm], SerialEncoderArm]


def select_poses(records: list[ArmRecord]) -> list[PoseSample]:
    return [record for record in records if isinstance(record, PoseSample)]


def pulsed(records: list[ArmRecord]) -> list[JointSample]:
    return [sample for sample in select_samples(records) if sample.pulse is not None]


def test_both_names_are_the_same_driver() -> None:
    for name in ("bridge", "serial-encoder"):
        driver = registry.arm_driver(name, {"url": "/dev/none"})
        assert isinstance(driver, SerialEncoderArm)
        assert isinstance(driver, PulseSource)
        assert isinstance(driver, AnswersWhileSilent)


def test_the_properties_are_those_of_the_hello(poses: FakeSerialArm) -> None:
    poses.greets = False
    said = hello_2_packet([], 100.0, 0b0111, 5, 17, (1.0, 80.0), "R", "9")
    timer = threading.Timer(0.4, poses.inject, [said])
    timer.start()
    driver = from_options({"url": poses.line.url, "setting": 17})
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


def test_poses_are_those_that_were_sent(poses: FakeSerialArm, open_driver: Opener) -> None:
    driver = open_driver(poses)
    poses.quaternion = [0.0, 0.60003, 0.0, 0.80004]  # rounded by the bridge
    read_until(driver, lambda got: len(got) > 50)
    for pose in select_poses(read_until(driver, lambda got: len(got) > 50)):
        assert pose.position_mm == (float(pose.sequence), -80.25, 433.0)
        assert pose.quaternion_xyzw == pytest.approx((0.0, 0.6, 0.0, 0.8), abs=1e-12)
        assert pose.pulse is None
    assert driver.health.corrupt == 0


@pytest.mark.parametrize("fault", ["not a number", "infinite", "length"])
def test_what_is_no_pose_is_dropped_and_ends_the_connection_if_it_goes_on(
    poses: FakeSerialArm, open_driver: Opener, fault: str
) -> None:
    driver = open_driver(poses)
    read_until(driver, select_poses)
    bad_y = {"not a number": np.nan, "infinite": np.inf, "length": 0.0}[fault]
    bad_q = [0.0, 0.6, 0.0, 0.9] if fault == "length" else [0.0, 0.6, 0.0, 0.8]
    at_us = poses.device_us(time.monotonic_ns()) + 1_000_000
    bad = pose_payload(poses.sequence + 1000, at_us, 0, 17, (0, bad_y, 0), bad_q)
    poses.inject(packet(3, bad, 2))
    read_until(driver, lambda _: driver.health.corrupt == 1)
    assert all(np.isfinite(p.position_mm).all() for p in select_poses(list(driver.read(0.5))))
    poses.y_mm, poses.quaternion = bad_y, bad_q
    error = read_until_lost(lambda: driver.read(0.1))
    assert "The last 50 poses" in str(error.what)
    assert error.remedy
    with pytest.raises(DeviceError, match="not open"):
        driver.read(0.0)


def test_a_button_pressed_while_the_pose_is_bad_is_not_lost(
    poses: FakeSerialArm, open_driver: Opener
) -> None:
    driver = open_driver(poses)
    read_until(driver, select_poses)
    with poses._lock:
        poses.buttons, poses.y_mm = 1, float("nan")
    read_until(driver, lambda _: driver.health.corrupt >= 3)
    poses.y_mm = 0.0
    assert button_edges(read_until(driver, button_edges)) == [(Button.PRIMARY, True)]


def test_poses_of_another_tool_or_base_are_an_error(
    poses: FakeSerialArm, open_driver: Opener
) -> None:
    driver = open_driver(poses)
    poses.setting = 123456
    error = read_until_lost(lambda: driver.read(0.1))
    assert "setting 123456 of tool and coordinate system instead of 17" in str(error.what)
    assert "instead of 17" in open_error({"url": poses.line.url, "setting": 17})


def test_an_arm_sends_what_it_announced(joints: FakeSerialArm, open_driver: Opener) -> None:
    driver = open_driver(joints)
    at_us = joints.device_us(time.monotonic_ns()) + 1_000_000
    pose = pose_payload(joints.sequence + 1000, at_us, 0, 0, (0, 0, 0), (0, 0, 0, 1))
    joints.inject(packet(3, pose, 2))
    error = read_until_lost(lambda: driver.read(0.1))
    assert "announced joints, but sends poses" in str(error.what)


def test_samples_of_an_arm_that_announced_poses_are_an_error(
    poses: FakeSerialArm, open_driver: Opener
) -> None:
    driver = open_driver(poses)
    poses.joints = 6
    error = read_until_lost(lambda: driver.read(0.1))
    assert "announced 0 joints, but sends 6" in str(error.what)


@pytest.mark.parametrize("kind", ["joints", "poses"])
def test_pulses_are_counted_from_one_after_every_start(
    request: pytest.FixtureRequest, open_driver: Opener, kind: str
) -> None:
    arm: FakeSerialArm = request.getfixturevalue(kind)
    driver = open_driver(arm)
    assert arm.pulse_requests[0][1] == 0.0  # of a host that went away
    for rate_hz, every in ((50.0, 10), (125.0, 4)):
        driver.start_pulses(rate_hz)
        records = select_readings(
            read_until(
                driver, lambda got: sum(r.pulse is not None for r in select_readings(got)) > 9
            )
        )
        at_pulse = [r for r in records if r.pulse is not None]
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
    assert not [r for r in select_readings(later) if r.pulse is not None]
    assert driver.health.lost == driver.health.corrupt == 0


def test_pulses_start_while_another_thread_reads(
    joints: FakeSerialArm, open_driver: Opener
) -> None:
    driver = open_driver(joints)
    records: list[ArmRecord] = []
    ended = threading.Event()

    def read() -> None:
        while not ended.is_set():
            records.extend(driver.read(0.5))

    reader = threading.Thread(target=read)
    reader.start()
    for rate_hz in (100.0, 50.0, 250.0):
        driver.start_pulses(rate_hz)
    driver.stop_pulses()
    ended.set()
    reader.join()
    assert np.all(np.diff([s.sequence for s in select_samples(records)]) == 1)


def test_pulses_of_a_former_host_mean_nothing(joints: FakeSerialArm, open_driver: Opener) -> None:
    first = open_driver(joints)
    first.start_pulses(250.0)
    read_until(first, pulsed)
    first.close()
    second = open_driver(joints)
    assert not pulsed(read_until(second, lambda got: len(got) > 50))
    second.start_pulses(250.0)
    assert pulsed(read_until(second, pulsed))[0].pulse == 1


def test_an_arm_that_restarts_while_it_pulses_is_an_error(
    joints: FakeSerialArm, open_driver: Opener
) -> None:
    driver = open_driver(joints)
    driver.start_pulses(100.0)
    read_until(driver, pulsed)
    joints.reboot()
    error = read_until_lost(lambda: driver.read(0.1))
    assert "restarted while the camera counted" in str(error.what)
    driver.open()
    driver.start_pulses(100.0)
    assert pulsed(read_until(driver, pulsed))[0].pulse == 1


def test_pulses_that_another_program_restarts_are_an_error(
    joints: FakeSerialArm, open_driver: Opener
) -> None:
    driver = open_driver(joints)
    driver.start_pulses(100.0)
    read_until(driver, lambda got: len(pulsed(got)) > 3)
    joints.pulse = 0
    error = read_until_lost(lambda: driver.read(0.1))
    assert "restarted while the camera counted" in str(error.what)


def test_a_restart_without_pulses_goes_on(joints: FakeSerialArm, open_driver: Opener) -> None:
    driver = open_driver(joints)
    before = select_samples(read_until(driver, lambda got: len(got) > 20))
    joints.reboot()
    after = select_samples(read_until(driver, lambda got: len(got) > 100))
    assert np.all(np.diff([s.stamp_ns for s in before + after]) > 0)


@pytest.mark.parametrize("rate_hz", [0.0, 0.5, 501.0, 1.0, float("nan")])
def test_a_rate_that_is_not_possible_is_refused(
    joints: FakeSerialArm, open_driver: Opener, rate_hz: float
) -> None:
    """By the driver outside of the announced range, by the arm at 1 Hz."""
    driver = open_driver(joints)
    with pytest.raises(DeviceError, match="cannot trigger at") as caught:
        driver.start_pulses(rate_hz)
    assert "from 1" in str(caught.value.remedy)
    read_until(driver, lambda got: len(got) > 3)


def test_an_arm_without_pulses_cannot_be_asked_for_them(tmp_path: Path) -> None:
    arm = FakeSerialArm(PtyLine(tmp_path), version=1)
    driver = from_options({"url": arm.line.url})
    with pytest.raises(DeviceError, match="not open"):
        driver.start_pulses(10.0)
    assert driver.open().pulses_hz is None
    with pytest.raises(DeviceError, match="no output for trigger pulses"):
        driver.start_pulses(10.0)
    driver.stop_pulses()
    driver.close()
    driver.stop_pulses()
    arm.stop()


def test_a_pulse_request_that_is_never_answered_is_an_error(
    joints: FakeSerialArm, open_driver: Opener
) -> None:
    driver = open_driver(joints)
    joints.greets = False
    with pytest.raises(DeviceError, match="does not answer a request"):
        driver.start_pulses(10.0)


def test_an_arm_that_was_unplugged_is_not_alive(joints: FakeSerialArm, open_driver: Opener) -> None:
    driver = open_driver(joints)
    joints.silent = True
    assert driver.is_alive()
    joints.greets = False
    assert not driver.is_alive()
    joints.unplug()
    assert not driver.is_alive()
    read_until_lost(lambda: driver.read(0.1))
