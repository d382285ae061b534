"""The serial driver against a device at the far end of a pseudo-terminal and of TCP."""

from collections.abc import Iterator
from pathlib import Path

import pytest

from hardware.arm.serial_encoder import from_options
from hardware.interfaces import ArmDriver, Button
from tests.hardware.conformance import ArmBench, ArmConformance
from tests.hardware.speaking_arm import PtyLine, SpeakingArm, TcpLine

BITS = {Button.PRIMARY: 1, Button.UNDO: 2, Button.BACK: 4}


class SerialBench(ArmBench):
    def __init__(self, arm: SpeakingArm) -> None:
        self.arm = arm

    def driver(self) -> ArmDriver:
        return from_options({"url": self.arm.line.url, "timeout_s": 5.0})

    def contacts(self) -> int:
        return self.arm.requests

    def unplug(self) -> None:
        self.arm.unplug()

    def plug_in(self) -> None:
        self.arm.plug_in()

    def silence(self, silent: bool) -> None:
        self.arm.silent = silent

    def lose_samples(self, count: int) -> None:
        self.arm.skip = count

    def set_buttons(self, pressed: set[Button]) -> None:
        self.arm.buttons = sum(BITS[button] for button in pressed)


class TestOverPty(ArmConformance):
    @pytest.fixture
    def bench(self, tmp_path: Path) -> Iterator[ArmBench]:
        arm = SpeakingArm(PtyLine(tmp_path), joints=6)
        yield SerialBench(arm)
        arm.stop()


class TestOverTcp(ArmConformance):
    @pytest.fixture
    def bench(self) -> Iterator[ArmBench]:
        arm = SpeakingArm(TcpLine(), joints=7, first_sequence=(1 << 32) - 300)
        yield SerialBench(arm)
        arm.stop()
