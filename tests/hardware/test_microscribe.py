"""The MicroScribe driver against an arm at the far end of a line, as the SDK describes it."""

import math
import os
import runpy
import sys
import threading
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from crenel_hardware.arm.microscribe import hci, microscribe
from crenel_hardware.arm.robots import streaming_arm
from crenel_hardware.errors import DeviceError
from crenel_hardware.interfaces import ArmDriver, Button
from crenel_hardware.registry import arm_driver
from tests.hardware.conformance import ArmBench, ArmConformance
from tests.hardware.reading import (
    LONG_S,
    PATIENT_S,
    button_edges,
    opened,
    read_readings,
    read_samples,
    read_until,
    select_samples,
)
from tests.hardware.speaking_arm import Line, PtyLine, SpeakingBench, SpeakingDevice

pytestmark = [
    pytest.mark.device,
    pytest.mark.skipif(not hasattr(os, "openpty"), reason="there are no pseudo-terminals here"),
]

COUNTS = 8000
HOME_COUNTS = (0, 100, 200, 300, 400)
PEDALS = {Button.PRIMARY: 1, Button.UNDO: 2}


class FakeMicroscribe(SpeakingDevice):
    """Answers on a thread of its own. ``counts`` and ``pedals`` are what it reports.

    Faults: ``silent`` (hears nothing), ``skip`` (requests that get no answer), ``damage`` (answers
    with bit 7 set in the payload), ``late_s`` (answers so late), ``no_encoder`` (the maximum of
    one encoder is 0).
    """

    def __init__(self, line: Line, baud_rounds: int = 2) -> None:
        self.counts = [10, 20, 30, 40, 50]
        self.pedals = self.damage = self.heard = 0
        self.late_s = 0.0
        self.no_encoder = False
        self._rounds = baud_rounds
        self._unheard = baud_rounds
        self._inbox = b""
        self._in_session = False
        super().__init__(line, 0.0003)

    def unplug(self) -> None:
        super().unplug()
        with self._lock:
            self._in_session, self._inbox = False, b""

    def work(self) -> None:
        data = self.line.read()
        self.heard += len(data)
        if not self.silent:
            self._inbox += data
            while self._inbox and self._step():
                pass

    def _step(self) -> bool:
        """Takes one command from the inbox; False if it is not complete."""
        if not self._in_session:
            return self._listen()
        command, self._inbox = self._inbox[0], self._inbox[1:]
        texts = {0xC8: b"MicroScribe", 0xCA: b"G2X", 0xCB: b"MS-1234", 0xC9: b"MSCR"}
        if command == 0xC5:
            self._in_session, self._unheard = False, self._rounds
        elif command in texts:
            self.line.write(bytes([command]) + texts[command] + b"\0")
        elif command == 0xC2:
            self.counts = list(HOME_COUNTS)
            self.line.write(bytes([command]))
        elif command == 0xC6:
            self.line.write(bytes([command]) + self._maxima())
        elif command < 0x40:
            self._answer(command)
        return True

    def _listen(self) -> bool:
        """Before a session: echoes the sign-on once it has found the baud rate."""
        if (at := self._inbox.find(b"BEGIN")) >= 0:
            self._inbox, self._in_session = self._inbox[at + 5 :], True
            self.line.write(b"MSCR1-1C\0")
            return True
        if (at := self._inbox.find(b"IMMC")) < 0:
            return False
        self._inbox = self._inbox[at + 4 :]
        self._unheard -= 1
        if self._unheard < 0:
            self.line.write(b"IMMC")
        return True

    def _maxima(self) -> bytes:
        largest = [COUNTS - 1] * 6
        if self.no_encoder:
            largest[2] = 0
        return bytes(12) + b"".join(value.to_bytes(2, "big") for value in largest)

    def _answer(self, command: int) -> None:
        if self.skip:
            self.skip -= 1
            return
        late_s = self.late_s  # before the counts: an answer that is in time has those of now
        number = {0: 0, 1: 5, 2: 7, 3: 6}[command & 3]
        counts = (self.counts + [0, 0])[:number]
        payload = bytes([self.pedals & 0x7F])
        if command & 0x20:
            payload += bytes(2)
        payload += b"".join(bytes([count >> 7 & 0x7F, count & 0x7F]) for count in counts)
        if self.damage:
            self.damage -= 1
            payload = payload[:-1] + b"\xff"
        if late_s:
            time.sleep(late_s)
        self.line.write(bytes([command | 0x80]) + payload)


class MicroscribeBench(SpeakingBench):
    def __init__(self, arm: FakeMicroscribe) -> None:
        super().__init__(arm)
        self.arm = arm

    def driver(self) -> ArmDriver:
        return make_driver(self.arm)

    def contacts(self) -> int:
        return self.arm.heard

    def set_buttons(self, pressed: set[Button]) -> None:
        self.arm.pedals = sum(PEDALS[button] for button in pressed)


def make_driver(arm: FakeMicroscribe, **options: object) -> ArmDriver:
    return arm_driver("microscribe", {"url": arm.line.url, "timeout_s": PATIENT_S, **options})


@pytest.fixture
def arm(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[FakeMicroscribe]:
    monkeypatch.setattr(hci, "_ANSWER_S", 20.0)  # a busy machine may stand still for a second
    with FakeMicroscribe(PtyLine(tmp_path)) as arm:
        yield arm


@pytest.fixture
def driver(arm: FakeMicroscribe) -> Iterator[ArmDriver]:
    with opened(make_driver(arm)) as driver:
        yield driver


class TestMicroscribe(ArmConformance):
    @pytest.fixture
    def bench(self, arm: FakeMicroscribe, monkeypatch: pytest.MonkeyPatch) -> ArmBench:
        # no answer of a busy machine is late
        monkeypatch.setattr(microscribe, "_ANSWER_S", 2.0)
        monkeypatch.setattr(streaming_arm, "_SILENCE_S", LONG_S)
        return MicroscribeBench(arm)


def test_counts_become_radians(driver: ArmDriver) -> None:
    info = driver.open()
    assert (info.name, info.serial_number, info.joint_count) == ("MicroScribe G2X", "MS-1234", 5)
    assert info.stamps == "arrival"
    sample = read_samples(driver)[0]
    assert sample.joints_rad == pytest.approx(2 * np.pi * np.arange(10, 60, 10) / COUNTS)


def test_angles_pass_through_zero_without_a_jump(arm: FakeMicroscribe, driver: ArmDriver) -> None:
    first = read_samples(driver)[0]
    arm.counts[0] = COUNTS - 10
    later = read_until(driver, lambda got: any(s.joints_rad[0] < 0 for s in select_samples(got)))
    turned = select_samples(later)[-1].joints_rad[0] - first.joints_rad[0]
    assert turned == pytest.approx(-20 * 2 * math.pi / COUNTS)


def test_a_damaged_answer_is_lost_and_the_next_is_read(
    arm: FakeMicroscribe, driver: ArmDriver, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(microscribe, "_ANSWER_S", LONG_S)
    read_readings(driver, 3)  # past the answers that a busy machine had made late
    before = driver.health.corrupt
    arm.damage = 3
    read_until(driver, lambda _: driver.health.corrupt >= before + 3 and not arm.damage)
    # one more if a busy machine is late again
    assert before + 3 <= driver.health.corrupt <= before + 4
    # the next answer that is read shows what is lost
    read_until(driver, lambda _: driver.health.lost == driver.health.corrupt)
    read_readings(driver, 6)


def test_a_late_answer_is_not_of_the_next_question(arm: FakeMicroscribe, driver: ArmDriver) -> None:
    read_samples(driver)
    arm.late_s = 1.0  # after the next questions
    read_until(driver, lambda _: driver.health.corrupt > 3)
    arm.counts[0], arm.late_s = 1010, 0.0
    later = read_samples(driver, 6)
    turned = [sample.joints_rad[0] for sample in later]
    assert turned == pytest.approx([2 * math.pi * 1010 / COUNTS] * len(later))


def test_pedals_are_buttons(arm: FakeMicroscribe, driver: ArmDriver) -> None:
    assert driver.open().buttons == {Button.PRIMARY, Button.UNDO}
    arm.pedals = 3
    edges = button_edges(read_until(driver, button_edges))
    assert edges == [(Button.PRIMARY, True), (Button.UNDO, True)]


def test_a_driver_does_not_move_the_home_position(arm: FakeMicroscribe, driver: ArmDriver) -> None:
    driver.close()
    driver.open()
    read_samples(driver)
    driver.close()
    assert arm.counts == [10, 20, 30, 40, 50]


def test_the_home_position_is_set_on_request(
    arm: FakeMicroscribe, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(sys, "argv", ["microscribe", arm.line.url])
    monkeypatch.delitem(sys.modules, "crenel_hardware.arm.microscribe.microscribe", raising=False)
    runpy.run_module("crenel_hardware.arm.microscribe.microscribe", run_name="__main__")
    assert capsys.readouterr().out == "MS-1234\n"
    assert arm.counts == list(HOME_COUNTS)


def test_what_is_wrong_at_opening_is_said(arm: FakeMicroscribe) -> None:
    arm.no_encoder = True
    with pytest.raises(DeviceError, match="for joint 3"):
        make_driver(arm).open()
    arm.silent = True
    with pytest.raises(DeviceError, match="No MicroScribe answers"):
        make_driver(arm, timeout_s=0.3).open()
    arm.unplug()
    with pytest.raises(DeviceError, match="There is no serial port"):
        make_driver(arm).open()


def test_another_device_is_not_taken_for_an_arm(tmp_path: Path) -> None:
    arm = FakeMicroscribe(PtyLine(tmp_path), baud_rounds=1_000_000)
    driver = make_driver(arm, timeout_s=3.0)
    chatter = threading.Timer(0.2, arm.line.write, [b"$GPGGA,123519\r\n"])
    chatter.start()
    with pytest.raises(DeviceError, match="does not answer as a MicroScribe does"):
        driver.open()
    chatter.join()
    arm.stop()


def test_a_client_of_others_reads_the_arm_of_these_tests(arm: FakeMicroscribe) -> None:
    hci = pytest.importorskip("microcmm.hci")
    client = hci.HCI(arm.line.url)
    assert client.connect() == "MSCR1-1C"
    assert client.get_string(0xCB) == "MS-1234"
    assert client.get_maxes().max_encoder[:5] == [COUNTS - 1] * 5
    arm.pedals = 2
    packet = client.sample(5)
    assert (packet.buttons, packet.encoders) == (2, [10, 20, 30, 40, 50])
    client.go_home_pos()
    assert client.sample(5).encoders == list(HOME_COUNTS)
    client.disconnect()
