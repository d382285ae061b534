"""The conformance suite itself: every kind of arm passes it, and arms with faults do not."""

import threading
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Any

import pytest

from crenel_hardware.clock import now_ns
from crenel_hardware.errors import DeviceError
from crenel_hardware.interfaces import (
    ArmDriver,
    ArmInfo,
    ArmReading,
    ArmRecord,
    Button,
    ButtonEvent,
    JointSample,
    LinkHealth,
    PoseSample,
)
from tests.hardware.conformance import ArmBench, ArmConformance, FaultyArmBench

pytestmark = pytest.mark.device

RATE_HZ = 200.0
FIVE_JOINTS = ArmInfo("Five joints", "S-5", 5, RATE_HZ, buttons=frozenset({Button.PRIMARY}))
POSES = ArmInfo("Poses", "S-P", 0, RATE_HZ, reports="pose", buttons=frozenset())
FOUR_JOINTS = ArmInfo("Four", "S-4", 4, RATE_HZ, buttons=frozenset())
ON_CHANGE = ArmInfo(
    "On change", "S-C", 0, RATE_HZ, reports="pose", buttons=frozenset(), free_running=False
)


@dataclass
class Device:
    """A device inside this process: a counter that runs with the clock."""

    info: ArmInfo
    born_ns: int = field(default_factory=now_ns)
    contacts: int = 0
    unplugged: bool = False
    silent: bool = False
    skip: int = 0
    pressed: frozenset[Button] = frozenset()
    quaternion: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 1.0)
    answers_unplugged: bool = False


class Driver:
    """Meets ``ArmDriver`` and ``AnswersWhileSilent`` for a ``Device``."""

    def __init__(self, device: Device) -> None:
        self.device = device
        self.health = LinkHealth()
        self._closed = threading.Event()
        self._closed.set()
        self._next = 0
        self._pressed: frozenset[Button] = frozenset()

    def open(self) -> ArmInfo:
        if self._closed.is_set():
            self._require_plug()
            self.device.contacts += 1
            self.health = LinkHealth()
            self._next, self._pressed = self._due(), self.device.pressed
            self._closed.clear()
        return self.device.info

    def read(self, timeout_s: float) -> Sequence[ArmRecord]:
        deadline = time.monotonic() + timeout_s
        while True:
            self._require_plug()
            if self._closed.wait(min(0.005, timeout_s)):
                raise DeviceError("closed", "Open it.")
            records = self._take()
            if records or time.monotonic() >= deadline:
                return records

    def is_alive(self) -> bool:
        return not self.device.unplugged or self.device.answers_unplugged

    def close(self) -> None:
        self._closed.set()

    def _require_plug(self) -> None:
        if self.device.unplugged:
            self._closed.set()
            raise DeviceError("unplugged", "Plug it in.")

    def _due(self) -> int:
        return int((now_ns() - self.device.born_ns) * RATE_HZ / 1e9)

    def _take(self) -> list[ArmRecord]:
        device, due = self.device, self._due()
        if device.silent:
            self._next = due
            return []
        records: list[ArmRecord] = []
        for number in range(self._next, due):
            if device.skip:
                device.skip -= 1
                self.health.lost += 1
                continue
            self.health.received += 1
            stamp_ns = device.born_ns + int(number * 1e9 / RATE_HZ)
            records.append(self._reading(number, stamp_ns))
            pressed = device.pressed
            for button in pressed ^ self._pressed:
                records.append(ButtonEvent(number, stamp_ns, button, button in pressed))
            self._pressed = pressed
        self._next = due
        return records

    def _reading(self, number: int, stamp_ns: int) -> ArmReading:
        if self.device.info.reports == "joints":
            return JointSample(number, stamp_ns, (0.5,) * self.device.info.joint_count)
        return PoseSample(number, stamp_ns, (1.0, 2.0, 3.0), self.device.quaternion)


class DeviceBench(FaultyArmBench):
    def __init__(self, info: ArmInfo, **faults: Any) -> None:
        self.device = self.faults = Device(info, **faults)

    def driver(self) -> Driver:
        return Driver(self.device)

    def contacts(self) -> int:
        return self.device.contacts

    def set_buttons(self, pressed: set[Button]) -> None:
        self.device.pressed = frozenset(pressed)


class TestKindsOfArms(ArmConformance):
    @pytest.fixture(params=[FIVE_JOINTS, POSES, ON_CHANGE], ids=lambda info: info.name)
    def bench(self, request: pytest.FixtureRequest) -> ArmBench:
        return DeviceBench(request.param)


SUITE = ArmConformance()


@pytest.mark.parametrize(
    ("fault", "check"),
    [
        (
            {"quaternion": (0.0, 0.0, 0.0, 1.1)},
            lambda _, driver: SUITE.test_says_what_it_is(driver),
        ),
        ({"info": FOUR_JOINTS}, lambda _, driver: SUITE.test_says_what_it_is(driver)),
        ({"answers_unplugged": True}, SUITE.test_a_silent_arm_that_is_asked_answers),
    ],
)
def test_an_arm_with_a_fault_does_not_pass(
    fault: dict[str, Any],
    check: Callable[[ArmBench, ArmDriver], None],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr("tests.hardware.reading.LONG_S", 1.0)
    bench = DeviceBench(**{"info": ON_CHANGE, **fault})
    with pytest.raises(AssertionError):
        check(bench, bench.driver())


def test_what_an_arm_does_not_have_is_skipped() -> None:
    bench = DeviceBench(POSES)
    for check in (
        SUITE.test_buttons_give_their_edges_once,
        SUITE.test_a_button_held_at_open_is_no_press,
        SUITE.test_a_silent_arm_that_is_asked_answers,
    ):
        with pytest.raises(pytest.skip.Exception):
            check(bench, bench.driver())
