"""The serial driver against a device at the far end of a pseudo-terminal and of TCP."""

import os
import re
import threading
import time
from collections.abc import Iterator
from contextlib import closing
from math import pi
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from crenel_hardware.arm.expected_arm import SerialEncoderOptions
from crenel_hardware.arm.packet_stream import PacketStream
from crenel_hardware.arm.serial_encoder import SerialEncoderArm, from_options
from crenel_hardware.clock import now_ns
from crenel_hardware.errors import DeviceError
from crenel_hardware.interfaces import ArmDriver, ArmRecord, Button, JointSample, LinkHealth
from crenel_hardware.registry import arm_driver
from tests.bench.station.subprocess_station import free_port
from tests.hardware.conformance import ArmBench, ArmConformance
from tests.hardware.reading import (
    PATIENT_S,
    SILENT_S,
    loss_of,
    opened,
    read_readings,
    read_samples,
    read_until,
    select_samples,
)
from tests.hardware.speaking_arm import (
    COUNTS,
    FakeArm,
    PtyLine,
    Rfc2217Line,
    SpeakingBench,
    TcpLine,
    hello_packet,
    packet,
    sample_packet,
)

pytestmark = pytest.mark.device

BITS = {Button.PRIMARY: 1, Button.UNDO: 2, Button.BACK: 4}


def make_driver(arm: FakeArm, **options: object) -> SerialEncoderArm:
    return from_options({"url": arm.line.url, "timeout_s": PATIENT_S, **options})


class SerialBench(SpeakingBench):
    def __init__(self, arm: FakeArm) -> None:
        super().__init__(arm)
        self.arm = arm

    def driver(self) -> ArmDriver:
        return make_driver(self.arm)

    def contacts(self) -> int:
        return self.arm.requests

    def set_buttons(self, pressed: set[Button]) -> None:
        self.arm.buttons = sum(BITS[button] for button in pressed)


class TestOverPty(ArmConformance):
    @pytest.fixture
    def bench(self, arm: FakeArm) -> ArmBench:
        return SerialBench(arm)


class TestOverTcp(ArmConformance):
    @pytest.fixture
    def bench(self) -> Iterator[ArmBench]:
        with FakeArm(TcpLine(), joints=7, first_sequence=(1 << 32) - 300) as arm:
            yield SerialBench(arm)


@pytest.mark.filterwarnings("ignore:set(Daemon|Name):DeprecationWarning")  # pyserial's own
class TestOverRfc2217(ArmConformance):
    """A serial port served over the network, which has no file descriptor here."""

    @pytest.fixture
    def bench(self) -> Iterator[ArmBench]:
        with FakeArm(Rfc2217Line(), joints=6, rate_hz=200.0) as arm:
            yield SerialBench(arm)


@pytest.fixture
def arm(tmp_path: Path) -> Iterator[FakeArm]:
    with FakeArm(PtyLine(tmp_path)) as arm:
        yield arm


@pytest.fixture
def driver(arm: FakeArm) -> Iterator[ArmDriver]:
    with opened(make_driver(arm)) as driver:
        yield driver


def test_counts_become_radians(arm: FakeArm, driver: ArmDriver) -> None:
    info = driver.open()
    assert (info.name, info.serial_number, info.joint_count) == ("Bench arm", "B-1", 6)
    assert info.rate_hz == arm.rate_hz
    for sample in read_samples(driver, 51):
        assert sample.joints_rad == pytest.approx((2 * pi * sample.sequence / COUNTS,) * 6)


@pytest.mark.parametrize("counts", [1000, [1000, 2000, 3000, 4000, 5000, 6000]])
def test_counts_per_revolution_may_be_given(arm: FakeArm, counts: int | list[int]) -> None:
    with opened(make_driver(arm, counts_per_revolution=counts)) as driver:
        sample = read_samples(driver)[0]
        each = counts if isinstance(counts, list) else [counts] * 6
        expected = [2 * pi * sample.sequence / count for count in each]
        assert sample.joints_rad == pytest.approx(expected)


def test_damaged_packets_are_counted_as_corrupt_and_lost(arm: FakeArm, driver: ArmDriver) -> None:
    read_samples(driver)
    arm.damage = 5  # five in a row are one stretch
    read_until(driver, lambda _: driver.health.lost >= 5)
    assert driver.health.corrupt == 1
    arm.inject(b"\xa7\x5c\x01\x01\xff noise")
    read_until(driver, lambda _: driver.health.corrupt >= 2)
    read_readings(driver, 21)
    assert (driver.health.lost, driver.health.corrupt) == (5, 2)


def test_a_repeated_sample_is_dropped(arm: FakeArm, driver: ArmDriver) -> None:
    read_samples(driver)
    arm.repeat = 1
    samples = select_samples(read_until(driver, lambda _: driver.health.corrupt >= 1))
    assert np.all(np.diff([s.sequence for s in samples]) == 1)
    assert driver.health.lost == 0


def test_a_restarted_arm_goes_on(arm: FakeArm, driver: ArmDriver) -> None:
    """What it sent until its clock is known again counts as lost."""
    first = read_samples(driver, 101)
    arm.reboot()
    second = read_samples(driver, 201)
    assert np.all(np.diff([s.stamp_ns for s in first + second]) > 0)
    steps = np.diff([s.sequence for s in first + second])
    assert np.count_nonzero(steps > 1) <= 1  # none if the arm of a busy machine sent nothing
    assert driver.health.lost == steps.max() - 1
    assert min(s.joints_rad[0] for s in second) > 0


def begun_stream(rate_hz: float = 1000.0) -> tuple[PacketStream, LinkHealth]:
    health = LinkHealth()
    stream = PacketStream(SerialEncoderOptions(url="line"), health)
    stream.records(hello_packet([COUNTS] * 6, rate_hz), 0)
    return stream, health


def test_samples_that_waited_after_a_restart_get_no_wrong_times() -> None:
    """A delayed burst is all that the host knows of the new clock."""
    stream, health = begun_stream()
    taken: list[ArmRecord] = []
    for number in range(800):
        at_us, restarted = 5000 * number, number >= 400
        data = sample_packet(number - 400 * restarted, at_us - 2_000_000 * restarted, 0, [0] * 6)
        waited_us = 80_000 - 5000 * (number - 400) if 400 <= number < 416 else 0
        taken += stream.records(data, 1000 * (at_us + waited_us))
    samples = select_samples(taken)
    assert samples[-1].sequence == 799
    assert [s.stamp_ns for s in samples] == [5_000_000 * s.sequence for s in samples]
    assert 50 <= health.lost <= 70


def test_a_full_line_after_a_pause_of_the_host_is_no_jump() -> None:
    """The line kept the oldest samples of ten seconds, and lost the others."""
    stream, health = begun_stream(200.0)
    for number in [*range(500), *range(2450, 2900)]:
        arrival_us = 12_250_000 if 400 <= number < 500 else 5000 * number
        stream.records(sample_packet(number, 5000 * number, 0, [0] * 6), 1000 * arrival_us)
    assert health.lost == 1950


@pytest.mark.parametrize("by", ["clock", "count"])
def test_a_clock_or_count_that_jumps_is_an_error(arm: FakeArm, driver: ArmDriver, by: str) -> None:
    read_samples(driver)
    if by == "clock":
        arm.set_clock(3600.0)
    else:
        arm.sequence += 1_000_000
    assert "has jumped" in str(loss_of(driver).what)
    assert driver.health.lost == 0
    driver.open()
    read_samples(driver)


def test_the_sequence_wraps_without_a_loss(tmp_path: Path) -> None:
    with (
        FakeArm(PtyLine(tmp_path), first_sequence=(1 << 32) - 400) as arm,
        opened(make_driver(arm)) as driver,
    ):
        samples = read_samples(driver, 501)
        assert samples[-1].sequence > 1 << 32
        assert np.all(np.diff([s.sequence for s in samples]) == 1)
        assert driver.health.lost == 0


def assert_true_stamps(arm: FakeArm, samples: list[JointSample]) -> None:
    late_us = [(s.stamp_ns - arm.latched_ns[s.sequence]) / 1000 for s in samples]
    assert min(late_us) > -1000
    assert np.median(late_us) < 500_000


def test_stamps_are_those_of_latching(arm: FakeArm, driver: ArmDriver) -> None:
    """The device's clock here is the host's, so truth is known. What a busy machine learns of it is
    late; ``test_device_clock.py`` says how exact it is else."""
    assert_true_stamps(arm, read_samples(driver, 501))


def test_what_waited_in_the_line_keeps_its_times() -> None:
    with FakeArm(TcpLine()) as arm, opened(make_driver(arm)) as driver:
        read_readings(driver, 101)
        time.sleep(1.0)  # a reader that was held up
        burst = select_samples(list(driver.read(1.0)))
        assert len(burst) > 50
        assert_true_stamps(arm, burst)
        assert driver.health.lost == 0


def test_the_latency_comes_off_the_stamp(arm: FakeArm) -> None:
    with opened(make_driver(arm, latency_us=50_000.0)) as driver:
        sample = read_samples(driver)[0]
        assert now_ns() - sample.stamp_ns >= 50_000_000


def test_an_arm_that_cannot_listen_is_known_by_its_own_hello(arm: FakeArm) -> None:
    arm.greets = False
    timer = threading.Timer(0.5, arm.inject, [hello_packet([COUNTS] * 6)])
    timer.start()
    with closing(make_driver(arm)) as driver:
        assert driver.open().joint_count == 6
    timer.join()


def test_another_arm_on_the_same_line_is_an_error(arm: FakeArm, driver: ArmDriver) -> None:
    arm.inject(hello_packet([COUNTS] * 6, arm.rate_hz, serial="B-2"))
    error = loss_of(driver)
    assert "B-2" in str(error.what)
    assert "B-1" in str(error.what)


def test_samples_of_another_joint_count_are_an_error(arm: FakeArm, driver: ArmDriver) -> None:
    arm.joints = 7
    assert "announced 6 joints, but sends 7" in str(loss_of(driver).what)


def open_error(url: str, **options: object) -> str:
    driver = from_options({"url": url, "timeout_s": PATIENT_S, **options})
    with pytest.raises(DeviceError) as caught:
        driver.open()
    with pytest.raises(DeviceError):
        driver.read(0.0)
    return str(caught.value)


def test_what_is_wrong_at_opening_is_said(arm: FakeArm) -> None:
    url = arm.line.url
    arm.silent = True
    assert "sends its hello (Bench arm) but no samples" in open_error(url, timeout_s=SILENT_S)
    arm.greets = False
    assert "No data arrived from" in open_error(url, timeout_s=0.3)
    arm.silent = False
    assert "sends samples but no hello" in open_error(url, timeout_s=SILENT_S)
    arm.silent, arm.chatter = True, b"$GPGGA,123519\r\n"
    message = open_error(url, timeout_s=SILENT_S)
    assert "no packet of an encoder arm" in message
    assert "baud rate" in message
    arm.chatter = packet(1, bytes(40), version=3)
    assert "version 3 of the protocol" in open_error(url, timeout_s=SILENT_S)


@pytest.mark.parametrize("driver", ["bridge", "microscribe", "serial-encoder"])
@pytest.mark.parametrize(
    "url",
    [
        *("spy://loop://?file={}", "SPY:///dev/null?file={}&raw", "spy://socket://h:1?file={}"),
        *("loop://", "hwgrep://USB", "alt:///dev/null?class=PosixPollSerial", "cp2110://0"),
        *("file://{}", "{}", "/dev/..{}", "dev.toml", "socket://h:1/../{}", " spy://x?file={}"),
        *("/dev/ttyS0\0{}", "{}\0"),
    ],
)
def test_what_is_no_device_address_is_not_opened(tmp_path: Path, url: str, driver: str) -> None:
    kept = tmp_path / "station.db"
    kept.write_bytes(b"kept")
    with pytest.raises(DeviceError, match=r"not the address of a device|There is no serial"):
        arm_driver(driver, {"url": url.format(kept)}).open()
    assert kept.read_bytes() == b"kept"


def test_an_arm_of_the_wrong_kind_is_refused(arm: FakeArm) -> None:
    url = arm.line.url
    assert "station.toml states joint_count = 7" in open_error(url, joint_count=7)
    message = open_error(url, counts_per_revolution=[1, 2, 3])
    assert "3 counts_per_revolution, but the arm has 6" in message
    arm.counts = 0
    assert "0 counts per revolution for joint 1" in open_error(url)
    arm.joints = 4
    assert "reports 4 joints" in open_error(url)


def test_a_pulled_cable_is_said_without_words_of_the_library(tmp_path: Path) -> None:
    for line in (PtyLine(tmp_path), TcpLine()):
        with FakeArm(line) as arm, opened(make_driver(arm)) as driver:
            arm.unplug()
            what = loss_of(driver).what
        assert str(what) == f"The connection to the arm at {line.url} was lost"


def test_a_port_in_use_is_named(arm: FakeArm, driver: ArmDriver) -> None:
    assert "in use by another program" in open_error(arm.line.url)
    read_readings(driver, 4)


def test_a_port_that_cannot_be_opened_says_why(tmp_path: Path) -> None:
    assert "There is no serial port" in open_error(str(tmp_path / "ttyNONE"))
    assert "enter socket://192.168.1.4:5000" in open_error("192.168.1.4:5000")
    assert re.search("cannot be opened .*Check the arm's url", open_error("nonsense://x"))
    plain = tmp_path / "file"
    plain.write_text("no port")
    assert re.search("cannot be opened .*(Available|No serial) port", open_error(str(plain)))
    assert "No program listens at" in open_error(f"socket://127.0.0.1:{free_port()}")
    assert "is not known" in open_error("socket://no-such-host.invalid:1")


@pytest.mark.skipif(os.name != "posix" or os.geteuid() == 0, reason="root may open any port")
def test_a_port_of_another_owner_is_named(arm: FakeArm) -> None:
    os.chmod(os.path.realpath(arm.line.url), 0)
    assert "may not open the serial port" in open_error(arm.line.url)


def test_closing_ends_a_waiting_open(arm: FakeArm) -> None:
    arm.silent = True
    driver = make_driver(arm, timeout_s=60.0)
    timer = threading.Timer(0.3, driver.close)
    timer.start()
    with pytest.raises(DeviceError, match="is closed"):
        driver.open()
    timer.join()


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({}, "'url' is missing"),
        ({"url": "x", "baudrte": 9600}, "no option 'baudrte'. Did you mean baudrate?"),
        ({"url": "x", "baudrate": -1}, "baudrate = -1 cannot be used"),
        ({"url": "x", "baudrate": "fast"}, "baudrate = 'fast' cannot be used"),
        ({"url": "x", "joint_count": 4}, "joint_count = 4 cannot be used"),
        ({"url": "x", "counts_per_revolution": 0}, "counts_per_revolution = 0 cannot be used"),
        ({"url": 7}, "url = 7 cannot be used"),
    ],
)
def test_a_wrong_option_is_named(options: dict[str, object], words: str) -> None:
    with pytest.raises(DeviceError) as caught:
        from_options(options)
    assert "station.toml, [arm]" in str(caught.value.what)
    assert words in str(caught.value)


@given(st.lists(st.one_of(st.binary(max_size=80), st.just(b"\xa7\x5c\x01\x02\x61")), max_size=8))
@settings(
    max_examples=25, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)
def test_noise_costs_no_sample(arm: FakeArm, driver: ArmDriver, noises: list[bytes]) -> None:
    lost = driver.health.lost
    samples: list[JointSample] = []
    for noise in noises:
        arm.inject(noise)
        samples += read_samples(driver, 6)
    assert np.all(np.diff([s.sequence for s in samples]) == 1)
    assert driver.health.lost == lost
