"""The MicroScribe driver against an arm at the far end of a pseudo-terminal.

No arm and no emulator of others exists here; with Python 3.12, a client of others (``microcmm``)
reads the arm of these tests as well.
"""

import math
import os
import runpy
import sys
import threading
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from hardware.arm.microscribe import microscribe
from hardware.arm.robots import streaming_arm
from hardware.errors import DeviceError
from hardware.interfaces import ArmDriver, Button
from hardware.registry import arm_driver
from tests.hardware.conformance import (
    LONG_S,
    ArmBench,
    ArmConformance,
    button_edges,
    read_until,
    select_samples,
)
from tests.hardware.speaking_arm import PtyLine
from tests.hardware.speaking_microscribe import COUNTS, HOME_COUNTS, FakeMicroscribe

pytestmark = [
    pytest.mark.device,
    pytest.mark.skipif(not hasattr(os, "openpty"), reason="there are no pseudo-terminals here"),
]

PEDALS = {Button.PRIMARY: 1, Button.UNDO: 2}


class MicroscribeBench(ArmBench):
    def __init__(self, arm: FakeMicroscribe) -> None:
        self.arm = arm

    def driver(self) -> ArmDriver:
        return make_driver(self.arm)

    def contacts(self) -> int:
        return self.arm.heard

    def unplug(self) -> None:
        self.arm.unplug()

    def plug_in(self) -> None:
        self.arm.plug_in()

    def silence(self, silent: bool) -> None:
        self.arm.silent = silent

    def lose_samples(self, count: int) -> None:
        self.arm.skip = count

    def set_buttons(self, pressed: set[Button]) -> None:
        self.arm.pedals = sum(PEDALS[button] for button in pressed)


def make_driver(arm: FakeMicroscribe, **options: object) -> ArmDriver:
    return arm_driver("microscribe", {"url": arm.line.url, **options})


def be_patient(monkeypatch: pytest.MonkeyPatch, answer_s: float) -> None:
    """No answer of a busy machine is late."""
    monkeypatch.setattr(microscribe, "_ANSWER_S", answer_s)


@pytest.fixture
def arm(tmp_path: Path) -> Iterator[FakeMicroscribe]:
    arm = FakeMicroscribe(PtyLine(tmp_path))
    yield arm
    arm.stop()


class TestMicroscribe(ArmConformance):
    @pytest.fixture
    def bench(self, arm: FakeMicroscribe, monkeypatch: pytest.MonkeyPatch) -> ArmBench:
        be_patient(monkeypatch, 0.5)
        monkeypatch.setattr(streaming_arm, "_SILENCE_S", LONG_S)
        return MicroscribeBench(arm)


def test_counts_become_radians(arm: FakeMicroscribe) -> None:
    driver = make_driver(arm)
    info = driver.open()
    assert (info.name, info.serial_number, info.joint_count) == ("MicroScribe G2X", "MS-1234", 5)
    assert info.stamps == "arrival"
    sample = select_samples(read_until(driver, select_samples))[0]
    assert sample.joints_rad == pytest.approx(2 * np.pi * np.arange(10, 60, 10) / COUNTS)
    driver.close()


def test_angles_pass_through_zero_without_a_jump(arm: FakeMicroscribe) -> None:
    driver = make_driver(arm)
    driver.open()
    first = select_samples(read_until(driver, select_samples))[0]
    arm.counts[0] = COUNTS - 10
    later = read_until(driver, lambda got: any(s.joints_rad[0] < 0 for s in select_samples(got)))
    turned = select_samples(later)[-1].joints_rad[0] - first.joints_rad[0]
    assert turned == pytest.approx(-20 * 2 * math.pi / COUNTS)
    driver.close()


def test_a_damaged_answer_is_lost_and_the_next_is_read(
    arm: FakeMicroscribe, monkeypatch: pytest.MonkeyPatch
) -> None:
    be_patient(monkeypatch, LONG_S)
    driver = make_driver(arm)
    driver.open()
    arm.damage = 3
    read_until(driver, lambda _: driver.health.lost >= 3)
    assert driver.health.corrupt == 3
    read_until(driver, lambda got: len(got) > 5)
    driver.close()


def test_a_late_answer_is_not_that_of_the_next_question(arm: FakeMicroscribe) -> None:
    driver = make_driver(arm)
    driver.open()
    read_until(driver, select_samples)
    arm.late_s = 1.0  # after the next questions
    read_until(driver, lambda _: driver.health.corrupt > 3)
    arm.counts[0], arm.late_s = 1010, 0.0
    later = select_samples(read_until(driver, lambda got: len(got) > 5))
    turned = [sample.joints_rad[0] for sample in later]
    assert turned == pytest.approx([2 * math.pi * 1010 / COUNTS] * len(later))
    driver.close()


def test_pedals_are_buttons(arm: FakeMicroscribe) -> None:
    driver = make_driver(arm)
    assert driver.open().buttons == {Button.PRIMARY, Button.UNDO}
    arm.pedals = 3
    assert button_edges(read_until(driver, button_edges)) == [
        (Button.PRIMARY, True),
        (Button.UNDO, True),
    ]
    driver.close()


def test_the_driver_does_not_move_the_home_position(arm: FakeMicroscribe) -> None:
    driver = make_driver(arm)
    driver.open()
    driver.close()
    driver.open()
    read_until(driver, select_samples)
    driver.close()
    assert arm.counts == [10, 20, 30, 40, 50]


def test_the_home_position_is_set_on_request(
    arm: FakeMicroscribe, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(sys, "argv", ["microscribe", arm.line.url])
    monkeypatch.delitem(sys.modules, "hardware.arm.microscribe.microscribe", raising=False)
    runpy.run_module("hardware.arm.microscribe.microscribe", run_name="__main__")
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
