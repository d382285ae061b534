"""Reading an arm or a sensor on, until what a test waits for has come."""

import time
from collections.abc import Callable, Iterator
from contextlib import closing, contextmanager
from typing import Protocol, TypeVar

from crenel_hardware.errors import DeviceError
from crenel_hardware.interfaces import (
    ArmDriver,
    ArmReading,
    ArmRecord,
    Button,
    ButtonEvent,
    Delivery,
    Frame,
    JointSample,
    Line,
    PoseSample,
    SensorDriver,
    SensorReading,
)

LONG_S = 120.0
PATIENT_S = 30.0
"""What a driver is given to open a device that answers: this machine may be busy."""
SILENT_S = 2.0
"""What it is given where the device stays silent, after it has said what it says."""
"""Much longer than anything here takes on a busy machine."""

InfoT_co = TypeVar("InfoT_co", covariant=True)
DriverT = TypeVar("DriverT", bound=ArmDriver | SensorDriver)


@contextmanager
def opened(driver: DriverT) -> Iterator[DriverT]:
    """The driver, open; it is closed at the end."""
    with closing(driver):
        driver.open()
        yield driver


def wait_until(done: Callable[[], object], otherwise: str = "it takes too long") -> None:
    deadline = time.monotonic() + LONG_S
    while not done():
        assert time.monotonic() < deadline, otherwise
        time.sleep(0.01)


def read_until(driver: ArmDriver, enough: Callable[[list[ArmRecord]], object]) -> list[ArmRecord]:
    """Reads on until the records satisfy ``enough``."""
    records: list[ArmRecord] = []
    deadline = time.monotonic() + LONG_S
    while not enough(records):
        assert time.monotonic() < deadline, f"not within {LONG_S} s: {records[-3:]}"
        records += driver.read(0.1)
    return records


def select_samples(records: list[ArmRecord]) -> list[JointSample]:
    return [record for record in records if isinstance(record, JointSample)]


def select_readings(records: list[ArmRecord]) -> list[ArmReading]:
    """Samples of joints or poses."""
    return [record for record in records if isinstance(record, JointSample | PoseSample)]


def read_samples(driver: ArmDriver, count: int = 1) -> list[JointSample]:
    """At least so many samples of an arm that reports joints."""
    return [one for one in read_readings(driver, count) if isinstance(one, JointSample)]


def read_readings(driver: ArmDriver, count: int = 1) -> list[ArmReading]:
    """At least so many samples of joints or poses."""
    readings: list[ArmReading] = []
    while len(readings) < count:
        readings += select_readings(read_until(driver, bool))
    return readings


def button_edges(records: list[ArmRecord]) -> list[tuple[Button, bool]]:
    return [(r.button, r.pressed) for r in records if isinstance(r, ButtonEvent)]


def read_until_lost(read: Callable[[], object]) -> DeviceError:
    """Reads on until the driver says that the device is lost."""
    deadline = time.monotonic() + LONG_S
    while time.monotonic() < deadline:
        try:
            read()
        except DeviceError as error:
            return error
    raise AssertionError("the loss was never reported")


def loss_of(driver: ArmDriver | SensorDriver, timeout_s: float = 0.1) -> DeviceError:
    return read_until_lost(lambda: driver.read(timeout_s))


def read_until_quiet(driver: ArmDriver) -> None:
    """Reads what is still on its way."""
    wait_until(lambda: not driver.read(0.1), "the device never falls silent")


def next_reading(driver: SensorDriver) -> SensorReading:
    """The next frame or line, waited for."""
    reading = reading_within(driver, LONG_S)
    assert reading is not None, f"no frame within {LONG_S} s"
    return reading


def reading_within(driver: SensorDriver, within_s: float) -> SensorReading | None:
    """The next frame or line, if one comes in time."""
    deadline = time.monotonic() + within_s
    while time.monotonic() < deadline:
        if (reading := driver.read(0.2)) is not None:
            return reading
    return None


def next_frame(driver: SensorDriver) -> Frame:
    """The next picture, waited for."""
    frame = next_reading(driver)
    assert isinstance(frame, Frame), "the sensor sends lines"
    return frame


def read_until_delivery(driver: SensorDriver, delivery: Delivery) -> SensorReading:
    """Reads until the first frame or line."""
    wanted = Frame if delivery == "picture" else Line
    deadline = time.monotonic() + LONG_S
    while not isinstance(reading := next_reading(driver), wanted):
        assert time.monotonic() < deadline, f"no {delivery} comes"
    return reading


def read_past(driver: SensorDriver, sequence: int) -> set[int]:
    """Reads until a sequence number has been passed; returns all numbers."""
    seen: set[int] = set()
    while not seen or max(seen) <= sequence:
        seen.add(next_frame(driver).sequence)
    return seen


class Opens(Protocol[InfoT_co]):
    """An arm or a sensor."""

    def open(self) -> InfoT_co: ...


def open_in_time(driver: Opens[InfoT_co]) -> InfoT_co:
    """Opens a device that may still be busy with its last user, or be on its way back."""
    deadline = time.monotonic() + LONG_S
    while True:
        try:
            return driver.open()
        except DeviceError:
            if time.monotonic() > deadline:
                raise
            time.sleep(0.1)
