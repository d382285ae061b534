"""The simulated arm in front of the real serial driver, with and without faults."""

import os
import resource
import socket
from collections.abc import Iterator
from contextlib import closing, contextmanager
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from crenel_hardware.arm.serial_encoder import from_options
from crenel_hardware.clock import now_ns
from crenel_hardware.errors import DeviceError
from crenel_hardware.interfaces import ArmDriver, Button, ButtonEvent, PoseSample, PulseSource
from crenel_hardware.simulator.devices.arm_device import ArmDevice, ArmFaults, Encoders
from crenel_hardware.simulator.devices.arm_packets import (
    RequestReader,
    hello_packet,
    pose_payload,
    pulse_answer_packet,
    reading_packet,
    sample_payload,
)
from crenel_hardware.simulator.devices.kinematics import flange_poses
from crenel_hardware.simulator.devices.motion import JointPath, Motion, min_jerk_progress
from crenel_hardware.simulator.devices.ports import DevicePort, PtyPort, TcpPort
from crenel_hardware.simulator.scene.random_scenes import demo_arm
from tests.hardware.conformance import ArmBench, ArmConformance
from tests.hardware.reading import (
    button_edges,
    opened,
    read_readings,
    read_samples,
    read_until,
    wait_until,
)
from tests.hardware.test_protocol import published_examples

pytestmark = pytest.mark.device

REST = np.array([0.1, -0.2, 0.3, -0.4, 0.5, -0.6])


def turn_by_one(seconds: float) -> JointPath:
    """Every joint turns by 1 rad from rest."""
    share = min_jerk_progress(np.linspace(0.0, 1.0, 30))[:, None]
    return JointPath(np.linspace(0.0, seconds, 30), REST + share)


@pytest.mark.parametrize("moves", ["play", "halt"])
def test_a_path_that_is_given_late_begins_where_the_arm_was_seen_last(moves: str) -> None:
    """On a busy machine the arm has sent readings of after the planned start."""
    motion = Motion(REST)
    motion.play(turn_by_one(1.0), 10**9)
    seen = motion.at_all(np.arange(1_300, 1_500) * 10**6)
    if moves == "play":
        back = JointPath(np.array([0.0, 1.0]), np.stack([seen[-1], REST]))
        motion.play(back, 1_400 * 10**6)
    else:
        motion.halt(1_400 * 10**6)
    after = motion.at_all(np.arange(1_500, 1_900) * 10**6)
    assert np.abs(np.diff(np.vstack([seen, after]), axis=0)).max() < 0.003


class DeviceBench(ArmBench):
    def __init__(self, line: DevicePort, rate_hz: float = 500.0, poses: bool = False) -> None:
        self.line, self.faults = line, ArmFaults()
        self.motion = Motion(REST)
        self.encoders = Encoders(rate_hz)
        self.device = ArmDevice(
            self.motion,
            line,
            self.encoders,
            self.faults,
            flange_poses=(lambda q: flange_poses(demo_arm(), q)) if poses else None,
        )
        self.device.start()

    def driver(self) -> ArmDriver:
        return from_options({"url": self.line.url, "timeout_s": 5.0})

    def contacts(self) -> int:
        return self.device.requests

    def unplug(self) -> None:
        self.faults.unplugged = True

    def plug_in(self) -> None:
        self.faults.unplugged = False

    def silence(self, silent: bool) -> None:
        self.faults.stalled = silent

    def lose_samples(self, count: int) -> None:
        self.device.skip(count)

    def set_buttons(self, pressed: set[Button]) -> None:
        for button in Button:
            self.device.press(button, button in pressed)


@contextmanager
def simulated(line: DevicePort | None = None, **more: Any) -> Iterator[DeviceBench]:
    """A bench over a line, else over TCP."""
    bench = DeviceBench(line or TcpPort("127.0.0.1", 0), **more)
    try:
        yield bench
    finally:
        bench.device.stop()


@pytest.fixture(params=[pytest.param("tcp", marks=pytest.mark.soak), "pty"])
def bench(request: pytest.FixtureRequest) -> Iterator[DeviceBench]:
    if request.param == "pty" and not hasattr(os, "openpty"):
        pytest.skip("there are no pseudo-terminals on this system")
    with simulated(PtyPort() if request.param == "pty" else None) as made:
        yield made


class TestSimulatedArm(ArmConformance):
    """Over TCP and over a pseudo-terminal."""


@pytest.fixture
def arm() -> Iterator[DeviceBench]:
    with simulated(rate_hz=1000.0) as made:
        yield made


@pytest.fixture
def driver(arm: DeviceBench) -> Iterator[ArmDriver]:
    with opened(arm.driver()) as driver:
        yield driver


def test_a_port_takes_its_clients_after_the_process_had_no_file_left() -> None:
    line = TcpPort("127.0.0.1", 0)
    host, port = line.url.removeprefix("socket://").split(":")
    soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
    with closing(socket.create_connection((host, int(port)))) as client:
        client.sendall(b"hello")
        resource.setrlimit(resource.RLIMIT_NOFILE, (3, hard))
        try:
            assert line.poll() == b""
        finally:
            resource.setrlimit(resource.RLIMIT_NOFILE, (soft, hard))
        wait_until(lambda: line.poll() == b"hello", "the client is never heard")
    line.release()


class TestSimulatedPoses(ArmConformance):
    @pytest.fixture
    def bench(self) -> Iterator[DeviceBench]:
        with simulated(poses=True) as made:
            yield made


def test_packets_are_the_published_examples() -> None:
    counts = [0, 1, -1, 4194304, -2097152, 123456]
    texts = ("Sample arm", "SA-0042", "2.0.0")
    joints, poses, pose, pulse, posed_pulse, request, answer = published_examples()[3:]
    hello = hello_packet([8388608] * 6, 1000.0, texts, 0, (1.0, 200.0))
    assert hello[:11] + hello[12:-4] == joints[:11] + joints[12:-4]  # but for the buttons
    hello = hello_packet([], 100.0, ("Sample bridge", "SB-7", "1.0"), 17)
    assert hello[:10] + hello[12:-4] == poses[:10] + poses[12:-4]  # of the flange
    where = pose_payload(7, 2_500_000, 1, 17, [612.5, -80.25, 433.0, 0.0, 0.6, 0.0, 0.8])
    sample = sample_payload(259, 1_000_001_000, 0, counts)
    assert reading_packet(3, where, None) == pose
    assert reading_packet(1, sample, 1) == pulse
    assert reading_packet(3, where, 70_000) == posed_pulse
    assert pulse_answer_packet(5, True, 100.016) == answer
    heard = RequestReader().feed(b"noise" + request[:9] + request + request)
    assert heard == (0, [(5, 100_000)] * 2)


def test_the_reported_poses_are_those_of_the_arm() -> None:
    with simulated(poses=True) as bench, closing(bench.driver()) as driver:
        info = driver.open()
        pose = read_readings(driver)[0]
    assert (info.reports, info.joint_count) == ("pose", 0)
    assert isinstance(pose, PoseSample)
    T = flange_poses(demo_arm(), REST[None])[0]
    assert pose.position_mm == pytest.approx(T[:3, 3].tolist(), abs=0.1)
    rotation = Rotation.from_quat(pose.quaternion_xyzw).as_matrix()
    assert np.abs(rotation - T[:3, :3]).max() < 1e-3


def test_the_angles_at_a_pulse_are_those_of_its_time(arm: DeviceBench, driver: ArmDriver) -> None:
    assert driver.open().pulses_hz == (1.0, 400.0)
    assert isinstance(driver, PulseSource)
    with pytest.raises(DeviceError, match="cannot trigger"):
        driver.start_pulses(1000.0)
    driver.start_pulses(130.0)
    arm.motion.play(turn_by_one(1.6), now_ns())
    samples = read_samples(driver, 2501)
    at_pulse = [
        i for i, s in enumerate(samples) if s.pulse is not None and 0 < i < len(samples) - 1
    ]
    assert [samples[i].pulse for i in at_pulse] == list(range(1, len(at_pulse) + 1))
    stamps = np.array([samples[i].stamp_ns for i in at_pulse])
    assert np.median(np.diff(stamps)) == pytest.approx(1e9 / 130, rel=0.01)
    between = [
        np.interp(samples[i].stamp_ns, [s.stamp_ns for s in near], [s.joints_rad[0] for s in near])
        - samples[i].joints_rad[0]
        for i in at_pulse
        for near in [(samples[i - 1], samples[i + 1])]
    ]
    assert np.ptp([samples[i].joints_rad[0] for i in at_pulse]) > 0.9
    assert np.abs(between).max() < 2e-4


LATE_NS = 1_000_000_000
"""By so much a busy machine may stamp something too late at first; nothing is stamped early."""


def test_a_driver_reads_true_angles_at_the_true_times(arm: DeviceBench, driver: ArmDriver) -> None:
    info = driver.open()
    assert (info.joint_count, info.rate_hz) == (6, 1000.0)
    start_ns, motion = now_ns() + 10_000_000, arm.motion
    motion.play(turn_by_one(0.6), start_ns)
    samples = read_samples(driver, 701)
    read = np.array([s.joints_rad for s in samples])
    assert np.ptp(read[:, 0]) > 0.9
    moving = np.abs(np.gradient(read[:, 0])) > 1e-3
    times_ns = start_ns + np.arange(0, 600_000_000, 100_000)
    latched_ns = np.interp(read[moving, 0], motion.at_all(times_ns)[:, 0], times_ns)
    true = motion.at_all(latched_ns.astype(np.int64))
    assert np.abs(true - read[moving]).max() < 1e-4
    sequence = np.array([s.sequence for s in samples])[moving]
    assert np.ptp(latched_ns - 1e6 * sequence) < 100_000
    late_ns = np.array([s.stamp_ns for s in samples])[moving] - latched_ns
    assert late_ns.min() > -20_000_000
    assert late_ns.max() < LATE_NS
    assert np.abs(read[-1] - REST - 1).max() < 1e-4


def test_rest_shows_encoder_noise_and_no_more(arm: DeviceBench, driver: ArmDriver) -> None:
    samples = read_samples(driver, 1501)
    q = np.array([s.joints_rad for s in samples])
    assert q.std(axis=0) == pytest.approx(np.full(6, arm.encoders.noise_rad), rel=0.15)
    assert np.abs(q.mean(axis=0) - REST).max() < 2e-6
    step = 2 * np.pi / arm.encoders.counts_per_revolution
    assert np.allclose(q / step, np.rint(q / step), atol=1e-6)


def test_faults_are_seen_as_what_they_are(arm: DeviceBench, driver: ArmDriver) -> None:
    faults = arm.faults
    faults.drop_rate = 0.2
    read_until(driver, lambda _: driver.health.lost > 50)
    assert driver.health.corrupt == 0
    faults.clear()
    faults.corrupt_rate, faults.garbage_rate = 0.1, 0.1
    read_until(driver, lambda _: driver.health.corrupt > 50)
    faults.clear()
    read_readings(driver, 51)
    health = (driver.health.lost, driver.health.corrupt)
    read_readings(driver, 301)
    assert (driver.health.lost, driver.health.corrupt) == health


def test_late_packets_come_late_and_none_is_missing(arm: DeviceBench, driver: ArmDriver) -> None:
    faults = arm.faults
    faults.late_rate, faults.late_s = 0.01, 0.15
    samples = read_samples(driver, 1201)
    assert driver.health.lost == 0
    assert np.all(np.diff([s.sequence for s in samples]) == 1)
    stamps = np.array([s.stamp_ns for s in samples])
    assert np.median(np.diff(stamps)) == pytest.approx(1e6, rel=0.05)


def test_a_press_is_where_and_when_it_was_made(arm: DeviceBench, driver: ArmDriver) -> None:
    at = now_ns() + 50_000_000
    arm.device.press(Button.PRIMARY, True, at)
    arm.device.press(Button.PRIMARY, False, at + 40_000_000)
    records = read_until(driver, lambda got: len(button_edges(got)) == 2)
    assert button_edges(records) == [(Button.PRIMARY, True), (Button.PRIMARY, False)]
    press, release = (r for r in records if isinstance(r, ButtonEvent))
    assert release.sequence - press.sequence == 40  # ms, and samples
    assert -20_000_000 < press.stamp_ns - at < LATE_NS


def test_a_client_that_does_not_read_holds_up_nobody(arm: DeviceBench, driver: ArmDriver) -> None:
    with opened(arm.driver()):  # and never read
        samples = read_samples(driver, 1501)
    assert np.all(np.diff([s.sequence for s in samples]) == 1)


def test_motion_rests_moves_and_halts_smoothly() -> None:
    motion = Motion(REST)
    start = 10**9
    end = motion.play(turn_by_one(1.0), start)
    assert np.array_equal(motion.at(start - 1), REST)
    assert not motion.is_resting(start + 1000)
    motion.halt(start + 500_000_000)  # before anybody has seen what comes later
    stamps = np.arange(start, start + 10**9, 10**6)
    q = motion.at_all(stamps)[:, 0]
    speed = np.diff(q) * 1000
    assert motion.is_resting(start + 700_000_000)
    assert np.abs(np.diff(speed)).max() < 0.1
    assert speed[-1] == 0
    assert 0.5 < q[-1] - REST[0] < 0.65
    whole = Motion(REST)
    whole.play(turn_by_one(1.0), start)
    assert np.allclose(whole.at(end + 5), REST + 1)


def test_a_held_arm_trembles_only_where_asked() -> None:
    for tremor in (0.0, 2e-5):
        motion = Motion(REST, tremor)
        path = JointPath(np.linspace(0.0, 0.2, 5), np.tile(REST, (5, 1)))
        end = motion.play(path, 10**9, trembles=True)
        held = motion.at_all(end + np.arange(200_000_000, 1_200_000_000, 10**6))
        assert np.ptp(held, axis=0).max() < 2e-4
        assert (np.ptp(held, axis=0).min() > 2e-5) == (tremor > 0)
