"""The arm's firmware: its machine code, run by simavr, in front of the driver."""

import os
import select
import tty
from collections.abc import Iterator
from contextlib import closing
from math import pi
from pathlib import Path

import numpy as np
import pytest

from crenel_hardware.arm.packet_reader import PacketReader
from crenel_hardware.arm.protocol import (
    HELLO_REQUEST,
    Hello,
    Packet,
    PulseAnswer,
    Sample,
    pulse_request,
)
from crenel_hardware.arm.serial_encoder import SerialEncoderArm, from_options
from crenel_hardware.interfaces import ArmDriver, ArmRecord, Button, JointSample
from tests.hardware.conformance import ArmBench, ArmConformance
from tests.hardware.firmware.board import (
    CLOCK_HZ,
    WITHIN_S,
    Board,
    build_board,
    build_firmware,
    missing_tool,
)
from tests.hardware.reading import (
    button_edges,
    loss_of,
    read_readings,
    read_samples,
    read_until,
    select_samples,
)

pytestmark = [
    pytest.mark.device,
    pytest.mark.skipif(missing_tool() is not None, reason=f"{missing_tool()} is not installed"),
]

PER_TURN = 1 << 14
BOUNCE_MS = 3
"""A few samples long; a contact that has settled is longer."""
BITS = {Button.PRIMARY: 0, Button.UNDO: 1, Button.BACK: 2}


@pytest.fixture(scope="module")
def program(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return build_board(tmp_path_factory.mktemp("board"))


@pytest.fixture(scope="module")
def firmware(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("firmware")
    return build_firmware(folder, NAME="Bench arm", SERIAL_NUMBER="B-1")


@pytest.fixture
def board(program: Path, firmware: Path, tmp_path: Path) -> Iterator[Board]:
    made = Board(program, firmware, tmp_path / "ttyARM")
    yield made
    made.power_off()


@pytest.fixture
def driver(board: Board) -> Iterator[SerialEncoderArm]:
    with closing(open_later(board)) as made:
        yield made


def open_later(board: Board) -> SerialEncoderArm:
    return from_options({"url": board.url, "baudrate": 500_000, "timeout_s": 20.0})


class FirmwareBench(ArmBench):
    def __init__(self, board: Board) -> None:
        self.board = board

    def driver(self) -> ArmDriver:
        return open_later(self.board)

    def contacts(self) -> int:
        return self.board.contacts

    def unplug(self) -> None:
        self.board.power_off()

    def plug_in(self) -> None:
        self.board.power_on()

    def silence(self, silent: bool) -> None:
        self.board.stop_clock(silent)

    def lose_samples(self, count: int) -> None:
        self.board.tell("drop", count)

    def set_buttons(self, pressed: set[Button]) -> None:
        for button, bit in BITS.items():
            self.board.tell("button", bit, int(button in pressed))


class TestFirmware(ArmConformance):
    @pytest.fixture
    def bench(self, board: Board) -> ArmBench:
        return FirmwareBench(board)


class RawLine:
    """The terminal without the driver."""

    def __init__(self, board: Board) -> None:
        self.end = os.open(board.url, os.O_RDWR | os.O_NOCTTY)
        tty.setraw(self.end)
        self.reader = PacketReader()

    def until(self, count: int, kind: type[Packet]) -> list[Packet]:
        """What arrives until so many packets of a kind have."""
        found: list[Packet] = []
        while sum(isinstance(packet, kind) for packet in found) < count:
            ready, _, _ = select.select([self.end], [], [], WITHIN_S)
            assert ready, f"the board is silent after {found[-3:]}"
            found += self.reader.feed(os.read(self.end, 4096))
        return found

    def samples(self, count: int) -> list[Sample]:
        return [packet for packet in self.until(count, Sample) if isinstance(packet, Sample)]

    def say(self, data: bytes) -> None:
        os.write(self.end, data)


@pytest.fixture
def line(board: Board) -> Iterator[RawLine]:
    made = RawLine(board)
    yield made
    os.close(made.end)


def numbers_of(records: list[ArmRecord]) -> list[int]:
    """Those of the pulses, which count from 1 after each start."""
    return [sample.pulse for sample in select_samples(records) if sample.pulse is not None]


def counts_of(sample: JointSample) -> list[float]:
    return [angle * PER_TURN / (2 * pi) for angle in sample.joints_rad]


def samples_at(driver: ArmDriver, counts: list[int]) -> list[JointSample]:
    """Read until every joint is where it should be, to the bit."""

    def there(records: list[ArmRecord]) -> bool:
        samples = select_samples(records)
        return bool(samples) and counts_of(samples[-1]) == pytest.approx(counts, abs=1e-6)

    return select_samples(read_until(driver, there))


def test_it_says_what_it_is(driver: SerialEncoderArm) -> None:
    info = driver.open()
    assert (info.name, info.serial_number, info.joint_count) == ("Bench arm", "B-1", 6)
    assert (info.rate_hz, info.pulses_hz, info.stamps) == (200.0, (1.0, 200.0), "device")
    assert info.buttons == set(Button)


@pytest.mark.parametrize("joints", [5, 7])
def test_arms_of_five_and_seven_joints(program: Path, tmp_path: Path, joints: int) -> None:
    firmware = build_firmware(tmp_path / "build", JOINTS=joints, SAMPLE_HZ=100)
    board = Board(program, firmware, tmp_path / "ttyARM", joints)
    board.turn(list(range(100, 100 + joints)))
    with closing(open_later(board)) as driver:
        info = driver.open()
        assert (info.joint_count, info.rate_hz) == (joints, 100.0)
        samples_at(driver, list(range(100, 100 + joints)))
    board.power_off()


def test_angles_are_right_to_the_bit_and_pass_through_zero(board: Board, driver: ArmDriver) -> None:
    rng = np.random.default_rng(7)
    board.turn(start := rng.integers(0, PER_TURN, 6).tolist())
    board.tell("reset")  # the start is the absolute position
    driver.open()
    samples_at(driver, start)
    cut_off = driver.health.corrupt  # the reset may have ended a packet in its middle
    at = start
    for _ in range(12):  # several turns forward, in steps of less than half a turn
        at = [count + 7000 for count in at]
        board.turn(at)
        samples_at(driver, at)
    for _ in range(20):
        at = [count - 7001 for count in at]
        board.turn(at)
        samples_at(driver, at)
    assert min(at) < -PER_TURN
    assert driver.health.corrupt == cut_off


def test_every_sample_is_taken_at_the_stated_rate(line: RawLine) -> None:
    assert_sampled_every(line, 5000)


def test_every_sample_is_taken_at_the_highest_rate(program: Path, tmp_path: Path) -> None:
    board = Board(program, build_firmware(tmp_path / "build", SAMPLE_HZ=400), tmp_path / "ttyARM")
    line = RawLine(board)
    assert_sampled_every(line, 2500)
    os.close(line.end)
    board.power_off()


def assert_sampled_every(line: RawLine, period_us: int) -> None:
    samples = line.samples(300)
    assert set(np.diff([sample.sequence for sample in samples])) == {1}
    assert set(np.diff([sample.device_us for sample in samples])) == {period_us}


@pytest.mark.parametrize("rate_hz", [20.0, 33.0, 130.0, 200.0])
def test_pulses_trigger_and_latch(board: Board, driver: SerialEncoderArm, rate_hz: float) -> None:
    driver.open()
    driver.start_pulses(rate_hz)
    at_pulse: list[JointSample] = []
    while len(at_pulse) < 8:  # those of before the request come first
        samples = read_samples(driver, 50)
        at_pulse += [sample for sample in samples if sample.pulse is not None]
    assert [sample.pulse for sample in at_pulse] == list(range(1, len(at_pulse) + 1))
    assert driver.health.lost == 0
    board.await_pulses(len(at_pulse))
    rose, latched, fell = np.array(board.pulses).T
    assert np.array_equal(rose, latched)
    assert np.abs(fell - rose - 300e-6 * CLOCK_HZ).max() <= 1
    assert np.abs(np.diff(rose) - CLOCK_HZ / rate_hz).max() <= 8  # a tick of the timer


def test_the_time_of_a_pulse_is_that_of_its_edge(board: Board, line: RawLine) -> None:
    line.say(pulse_request(9, 77.0))
    packets = line.until(150, Sample)
    answer = next(packet for packet in packets if isinstance(packet, PulseAnswer))
    assert (answer.number, answer.done) == (9, True)
    assert answer.rate_hz == pytest.approx(77.0, abs=0.002)
    samples = [packet for packet in packets if isinstance(packet, Sample)]
    assert np.all(np.diff([sample.device_us for sample in samples]) >= 2000)
    times_us = [sample.device_us for sample in samples if sample.pulse is not None]
    board.await_pulses(len(times_us))
    edges_us = np.array(board.pulses)[: len(times_us), 0] / (CLOCK_HZ / 1e6)
    assert np.ptp(edges_us - times_us) <= 1.0
    # a repeated request starts nothing
    line.say(pulse_request(9, 77.0))
    again = line.until(1, PulseAnswer) + line.until(60, Sample)
    numbers = [p.pulse for p in again if isinstance(p, Sample) and p.pulse is not None]
    assert numbers[0] == len(times_us) + 1


def test_pulses_start_from_one_after_a_pause(board: Board, driver: SerialEncoderArm) -> None:
    driver.open()
    for start in range(1, 4):
        driver.start_pulses(100.0)
        read_until(driver, lambda got: len(numbers_of(got)) > 20)
        board.pulses_by_now()
        gaps_s = np.diff([rose for rose, _, _ in board.pulses]) / CLOCK_HZ
        assert np.sum(gaps_s >= 0.3) == start - 1
    driver.stop_pulses()
    read_readings(driver, 51)
    count = board.pulses_by_now()
    assert not numbers_of(read_until(driver, lambda got: len(got) > 50))
    assert board.pulses_by_now() == count


@pytest.mark.parametrize("rate_hz", [0.5, 200.1, 4_000_000.0])
def test_impossible_rates_are_refused(board: Board, line: RawLine, rate_hz: float) -> None:
    line.say(pulse_request(1, rate_hz))
    (answer,) = (p for p in line.until(1, PulseAnswer) if isinstance(p, PulseAnswer))
    assert answer == PulseAnswer(1, False, 0.0)
    line.until(150, Sample)
    assert board.pulses == []


def test_garbage_from_the_host_does_no_harm(board: Board, line: RawLine) -> None:
    rng = np.random.default_rng(3)
    line.until(5, Sample)
    wrong_sum = bytearray(pulse_request(1, 100.0))
    wrong_sum[-1] ^= 1
    for round_ in range(6):
        line.say(rng.bytes(40) + HELLO_REQUEST[:5] + bytes(wrong_sum) + pulse_request(2, 50.0)[:9])
        packets = line.until(20, Sample)
        assert not any(isinstance(packet, PulseAnswer) for packet in packets), round_
    line.say(HELLO_REQUEST)
    packets = line.until(1, Hello)
    samples = [packet for packet in packets if isinstance(packet, Sample)]
    assert set(np.diff([sample.sequence for sample in samples])) <= {1}
    assert line.reader.corrupt == 0
    assert board.pulses == []


def test_a_bouncing_contact_gives_one_press(board: Board, line: RawLine) -> None:
    line.until(3, Sample)
    board.tell("bounce", 1, 7, BOUNCE_MS)
    states = [sample.buttons for sample in line.samples(40)]
    board.tell("button", 1, 0)
    states += [sample.buttons for sample in line.samples(20)]
    changes = np.flatnonzero(np.diff(states))
    assert [states[0], *(states[i + 1] for i in changes)] == [0, 2, 0]
    assert np.diff(changes)[0] >= 5


def test_an_encoders_error_costs_few_samples(board: Board, driver: SerialEncoderArm) -> None:
    board.turn([500] * 6)
    driver.open()
    samples_at(driver, [500] * 6)
    for command in ("error", "noise"):
        lost = driver.health.lost
        board.tell(command, 3)
        read_until(driver, lambda _, lost=lost: driver.health.lost > lost)  # type: ignore[misc]
        later = read_samples(driver, 21)
        assert driver.health.lost - lost <= 3
        assert counts_of(later[-1]) == pytest.approx([500] * 6)


@pytest.mark.parametrize("cause", ["reset", "hang"])
def test_a_restart_goes_on_without_pulses_and_is_an_error_with_them(
    board: Board, driver: SerialEncoderArm, cause: str
) -> None:
    """By the reset line, or by the watchdog when nothing is latched any more."""
    board.turn([7_000] * 6)
    driver.open()
    before = samples_at(driver, [7_000] * 6)
    board.tell(cause)
    after = read_samples(driver, 301)
    assert np.all(np.diff([s.stamp_ns for s in before + after]) > 0)
    assert counts_of(after[-1]) == pytest.approx([7_000] * 6)
    driver.start_pulses(100.0)
    read_until(driver, lambda got: any(s.pulse for s in select_samples(got)))
    board.tell(cause)
    assert "restarted while the camera counted" in str(loss_of(driver).what)
    driver.open()
    driver.start_pulses(100.0)
    first = read_until(driver, lambda got: any(s.pulse for s in select_samples(got)))
    assert next(s.pulse for s in select_samples(first) if s.pulse) == 1


def test_both_edges_of_a_press_come_through(board: Board, driver: SerialEncoderArm) -> None:
    driver.open()
    for pressed in (1, 0):
        board.tell("button", 0, pressed)
        edges = button_edges(read_until(driver, button_edges))
        assert edges == [(Button.PRIMARY, bool(pressed))]
