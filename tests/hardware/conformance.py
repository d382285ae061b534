"""What every arm driver and every sensor driver must do.

A test class inherits ``ArmConformance`` or ``SensorConformance`` and gives a fixture
``bench``: the driver under test and the device in front of it.

What an arm offers is read from its ``ArmInfo``: joints or poses, its buttons, whether it sends
without a change. A test of something that the arm does not have is skipped.
"""

import threading
import time
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import pytest

from crenel_hardware.clock import now_ns
from crenel_hardware.errors import DeviceError
from crenel_hardware.interfaces import (
    AnswersWhileSilent,
    ArmDriver,
    ArmInfo,
    ArmReading,
    Button,
    ButtonEvent,
    DeliversLines,
    Delivery,
    Frame,
    JointSample,
    Line,
    PoseSample,
    SensorDriver,
    SensorInfo,
    SensorReading,
)
from tests.hardware.reading import (
    LONG_S,
    button_edges,
    loss_of,
    next_frame,
    next_reading,
    open_in_time,
    read_past,
    read_readings,
    read_until,
    read_until_delivery,
    read_until_lost,
    read_until_quiet,
    reading_within,
    select_readings,
    wait_until,
)

TRIGGERED_S = 20.0
"""The picture of a trigger is there long before, or was lost."""
EARLY_NS = 10**9
"""Stamps of a device that was held up at the start may be late by so much."""
STALE_NS = 30 * 10**9
"""What arrives first may have waited for so long; the clocks of devices are off by much more."""
MOST_WAITING = 64
"""Pictures that a driver may have taken before an order reaches it."""


class Bench(ABC):
    """A device that the test can unplug."""

    @abstractmethod
    def unplug(self) -> None: ...

    @abstractmethod
    def plug_in(self) -> None: ...


class ArmBench(Bench):
    """An arm driver with a device that the test controls. The device sends, unless silenced."""

    counts_losses: bool = True
    """False if nothing on the wire shows the host that samples were lost."""

    @abstractmethod
    def driver(self) -> ArmDriver:
        """A new driver, unopened."""

    @abstractmethod
    def contacts(self) -> int | None:
        """How often the device was spoken to; None if the driver only listens."""

    @abstractmethod
    def silence(self, silent: bool) -> None:
        """The device stays, and sends nothing."""

    def lose_samples(self, count: int) -> None:
        """The next samples are taken and not sent; needed if ``counts_losses``."""
        raise AssertionError("the bench of an arm that counts losses must cause them")

    def set_buttons(self, pressed: set[Button]) -> None:
        """Exactly these buttons are down; needed if the arm has buttons."""
        raise AssertionError("the bench of an arm with buttons must press them")


class FaultyArmBench(ArmBench):
    """A bench of a device with the faults ``unplugged``, ``silent`` and ``skip``."""

    faults: Any

    def unplug(self) -> None:
        self.faults.unplugged = True

    def plug_in(self) -> None:
        self.faults.unplugged = False

    def silence(self, silent: bool) -> None:
        self.faults.silent = silent

    def lose_samples(self, count: int) -> None:
        self.faults.skip = count


class SensorBench(Bench):
    """A sensor driver with a device that the test controls."""

    @abstractmethod
    def driver(self) -> SensorDriver:
        """A new driver, unopened."""

    def lossy_driver(self, resent: bool) -> tuple[SensorDriver, set[int]]:
        """A driver whose device loses parts of these pictures, and sends them again if asked and
        ``resent``."""
        pytest.skip("this device counts no pictures, or loses none")

    def pictures_until_wrap(self) -> int:
        """After how many pictures the device's own counter begins again."""
        pytest.skip("this device's counter does not wrap soon")

    def triggered_driver(self) -> SensorDriver:
        """A driver whose device waits for ``trigger``."""
        pytest.skip("this device has no trigger")

    def trigger(self) -> None:
        """Lets the device of ``triggered_driver`` take one picture."""
        raise NotImplementedError

    def take_control(self) -> None:
        """Another program opens the device."""
        pytest.skip("any number of programs may use this device")

    def leave_control(self) -> None:
        """The other program closes the device."""
        raise NotImplementedError

    def revoke_control(self) -> None:
        """The device stops obeying the program that has opened it."""
        pytest.skip("this device cannot be made to disobey")


def open_with_buttons(driver: ArmDriver) -> list[Button]:
    """Opens the arm and returns its buttons; skips the test if it has none."""
    info = driver.open()
    if not info.buttons:
        pytest.skip("the arm has no buttons")
    return [button for button in Button if button in info.buttons]


def assert_fits(reading: ArmReading, info: ArmInfo) -> None:
    """The reading is of the kind that the arm says it reports, and holds numbers."""
    if isinstance(reading, JointSample):
        assert info.reports == "joints"
        assert len(reading.joints_rad) == info.joint_count
        assert np.all(np.isfinite(reading.joints_rad))
    else:
        assert info.reports == "pose"
        assert np.all(np.isfinite(reading.position_mm))
        assert np.linalg.norm(reading.quaternion_xyzw) == pytest.approx(1.0, abs=1e-9)


def assert_close_ends_reading(read: Callable[[], object], close: Callable[[], None]) -> None:
    reader = threading.Thread(target=lambda: read_until_lost(read), daemon=True)
    reader.start()
    time.sleep(0.2)
    close()
    reader.join(LONG_S)
    assert not reader.is_alive(), "read went on after close"


def assert_opens_after_closing_twice(driver: ArmDriver | SensorDriver) -> None:
    driver.close()
    driver.open()
    driver.close()
    driver.close()
    with pytest.raises(DeviceError):
        driver.read(0.0)
    driver.open()


def assert_lost_while_unplugged(bench: Bench, driver: ArmDriver | SensorDriver) -> None:
    bench.unplug()
    error = loss_of(driver)
    assert error.what
    assert error.remedy
    with pytest.raises(DeviceError):
        driver.open()
    bench.plug_in()


class ArmConformance:
    """Inherit, and give a fixture ``bench``."""

    @pytest.fixture
    def driver(self, bench: ArmBench) -> Iterator[ArmDriver]:
        driver = bench.driver()
        yield driver
        driver.close()

    def test_nothing_is_touched_before_open(self, bench: ArmBench, driver: ArmDriver) -> None:
        listens_only = bench.contacts() is None
        assert not bench.contacts()
        with pytest.raises(DeviceError):
            driver.read(0.0)
        driver.close()
        assert not bench.contacts()
        driver.open()
        assert listens_only or bench.contacts()

    def test_says_what_it_is(self, driver: ArmDriver) -> None:
        info = driver.open()
        assert isinstance(info, ArmInfo)
        assert info.name
        assert info.joint_count in ((5, 6, 7) if info.reports == "joints" else (0,))
        assert info.rate_hz > 0
        assert info.stamps in ("arrival", "device", "pulse")
        assert info.buttons <= frozenset(Button)
        for reading in read_readings(driver, 21):
            assert_fits(reading, info)

    def test_open_twice_is_open_once(self, bench: ArmBench, driver: ArmDriver) -> None:
        info = driver.open()
        contacts = bench.contacts()
        assert driver.open() == info
        assert bench.contacts() == contacts
        read_readings(driver, 4)

    def test_close_twice_then_open_again(self, driver: ArmDriver) -> None:
        assert_opens_after_closing_twice(driver)
        read_readings(driver, 4)

    def test_close_elsewhere_ends_reading(self, bench: ArmBench, driver: ArmDriver) -> None:
        driver.open()
        bench.silence(True)
        assert_close_ends_reading(lambda: driver.read(LONG_S), driver.close)

    def test_read_returns_empty_after_its_timeout(self, bench: ArmBench, driver: ArmDriver) -> None:
        driver.open()
        bench.silence(True)
        read_until_quiet(driver)
        start = time.monotonic()
        assert list(driver.read(0.3)) == []
        assert 0.25 <= time.monotonic() - start < LONG_S
        bench.silence(False)
        read_readings(driver, 4)

    def test_stamps_and_sequence_strictly_increase(self, driver: ArmDriver) -> None:
        count = min(200, round(2 * driver.open().rate_hz))
        before = now_ns()
        samples = read_readings(driver, count + 1)
        stamps = np.array([s.stamp_ns for s in samples])
        assert np.all(np.diff(stamps) > 0)
        assert np.all(np.diff([s.sequence for s in samples]) > 0)
        assert before - STALE_NS < stamps[0]
        assert stamps[-1] <= now_ns() + EARLY_NS

    def test_a_gap_is_counted(self, bench: ArmBench, driver: ArmDriver) -> None:
        skip_unless_losses_show(bench)
        driver.open()
        assert driver.health.lost == 0
        samples = read_readings(driver, 4)
        bench.lose_samples(7)
        samples += select_readings(read_until(driver, lambda _: driver.health.lost >= 7))
        samples += read_readings(driver, 1)
        steps = np.diff([s.sequence for s in samples])
        # an answer of a busy machine may be late as well
        assert steps.max() >= 8
        assert steps.sum() - len(steps) == driver.health.lost

    def test_buttons_give_their_edges_once(self, bench: ArmBench, driver: ArmDriver) -> None:
        buttons = open_with_buttons(driver)
        seen: list[tuple[Button, bool]] = []
        for button in buttons:
            for pressed in (True, False):
                bench.set_buttons({button} if pressed else set())
                seen += button_edges(read_until(driver, button_edges))
        records = read_until(driver, lambda got: len(got) > 20)
        assert button_edges(records) == []
        assert seen == [(button, pressed) for button in buttons for pressed in (True, False)]

    def test_a_button_held_at_open_is_no_press(self, bench: ArmBench, driver: ArmDriver) -> None:
        button = open_with_buttons(driver)[0]
        driver.close()
        bench.set_buttons({button})
        deadline = time.monotonic() + LONG_S
        while True:  # on a busy machine it may be pressed after the first opening
            driver.open()
            if not button_edges(read_until(driver, lambda got: len(got) > 20)):
                return
            driver.close()
            assert time.monotonic() < deadline, "a button that is held counts as pressed each time"

    def test_an_edge_has_the_stamp_of_a_sample(self, bench: ArmBench, driver: ArmDriver) -> None:
        bench.set_buttons({open_with_buttons(driver)[0]})
        records = read_until(driver, button_edges)
        at = next(i for i, r in enumerate(records) if isinstance(r, ButtonEvent))
        assert isinstance(records[at - 1], JointSample | PoseSample)
        assert records[at].stamp_ns == records[at - 1].stamp_ns

    def test_loss_is_an_error_until_opened(self, bench: ArmBench, driver: ArmDriver) -> None:
        driver.open()
        assert_lost_while_unplugged(bench, driver)
        open_in_time(driver)
        read_readings(driver, 4)

    def test_a_silent_arm_that_is_asked_answers(self, bench: ArmBench, driver: ArmDriver) -> None:
        """An arm that sends changes alone can be asked whether it is there."""
        if driver.open().free_running:
            pytest.skip("the arm sends all the time")
        assert isinstance(driver, AnswersWhileSilent)
        bench.silence(True)
        read_until_quiet(driver)
        assert driver.is_alive()
        bench.unplug()
        wait_until(lambda: not driver.is_alive(), "an unplugged arm answers")

    def test_counts_start_afresh_at_open(self, bench: ArmBench, driver: ArmDriver) -> None:
        skip_unless_losses_show(bench)
        driver.open()
        bench.lose_samples(3)
        read_until(driver, lambda _: driver.health.lost >= 3)
        driver.close()
        driver.open()
        assert driver.health.lost == 0
        # an answer may have been on its way while it was closed
        assert driver.health.corrupt <= 1


def skip_unless_losses_show(bench: ArmBench) -> None:
    if not bench.counts_losses:
        pytest.skip("nothing on the wire shows a loss")


def assert_is_picture_or_line(reading: SensorReading, info: SensorInfo) -> None:
    """It is of the size that the sensor says, and a line has points one after the other."""
    if isinstance(reading, Frame):
        assert "picture" in info.delivers
        assert reading.image.shape == (info.height_px, info.width_px)
        assert reading.image.dtype in (np.uint8, np.uint16)
        return
    assert "line" in info.delivers
    assert (reading.width_px, reading.height_px) == (info.width_px, info.height_px)
    lists = (reading.u, reading.v, reading.intensity, reading.sigma_px)
    for numbers in lists:
        assert numbers.shape == (len(reading.u),)
        assert np.isfinite(numbers).all()
    assert np.all(reading.sigma_px > 0)
    for place, size in ((reading.u, info.width_px), (reading.v, info.height_px)):
        assert np.all((place >= -0.5) & (place <= size - 0.5))
    columns, rows = (np.diff(np.floor(place + 0.5)) for place in (reading.u, reading.v))
    assert np.all(columns > 0) or np.all(rows > 0)


class SensorConformance:
    """Inherit, and give a fixture ``bench``."""

    @pytest.fixture
    def driver(self, bench: SensorBench) -> Iterator[SensorDriver]:
        driver = bench.driver()
        yield driver
        driver.close()

    def test_nothing_is_touched_before_open(self, bench: SensorBench) -> None:
        bench.unplug()
        driver = bench.driver()  # a device that is not there disturbs nobody yet
        with pytest.raises(DeviceError):
            driver.read(0.0)
        driver.close()
        with pytest.raises(DeviceError) as caught:
            driver.open()
        assert caught.value.what
        assert caught.value.remedy

    def test_frames_are_what_it_says(self, driver: SensorDriver) -> None:
        info = driver.open()
        assert isinstance(info, SensorInfo)
        shortest, longest = info.exposure_range_us
        assert 0 <= shortest <= longest
        for _ in range(3):
            assert_is_picture_or_line(next_reading(driver), info)

    def test_pictures_or_lines_come_as_switched(self, driver: SensorDriver) -> None:
        info = driver.open()
        first: Delivery = "picture" if "picture" in info.delivers else "line"
        assert isinstance(next_reading(driver), Frame if first == "picture" else Line)
        if len(info.delivers) == 1:
            pytest.skip("the sensor sends one of them alone")
        assert isinstance(driver, DeliversLines)
        driver.set_laser(True)
        for delivery in ("line", "line", "picture", "line"):
            driver.set_delivery(delivery)
            reading = read_until_delivery(driver, delivery)
            assert_is_picture_or_line(reading, info)
            later = next_reading(driver)
            assert isinstance(later, type(reading))
            assert later.sequence > reading.sequence
        driver.close()
        driver.open()
        assert isinstance(next_reading(driver), Frame)

    def test_open_twice_is_open_once(self, driver: SensorDriver) -> None:
        info = driver.open()
        first = next_reading(driver)
        assert driver.open() == info
        assert next_reading(driver).sequence > first.sequence

    def test_close_twice_then_open_again(self, driver: SensorDriver) -> None:
        assert_opens_after_closing_twice(driver)
        next_reading(driver)

    def test_close_elsewhere_ends_reading(self, driver: SensorDriver) -> None:
        driver.open()
        assert_close_ends_reading(lambda: driver.read(LONG_S), driver.close)

    def test_read_returns_none_after_its_timeout(self, driver: SensorDriver) -> None:
        driver.open()
        start = time.monotonic()
        while driver.read(0.0) is not None:
            assert time.monotonic() - start < LONG_S

    def test_stamps_and_sequence_strictly_increase(self, driver: SensorDriver) -> None:
        driver.open()
        before = now_ns()
        frames = [next_reading(driver) for _ in range(12)]
        assert np.all(np.diff([f.mid_exposure_ns for f in frames]) > 0)
        sequence = np.array([f.sequence for f in frames])
        assert np.all(np.diff(sequence) > 0)
        assert np.diff(sequence).sum() - (len(frames) - 1) <= driver.health.lost
        assert before - STALE_NS < frames[0].mid_exposure_ns
        assert frames[-1].mid_exposure_ns <= now_ns()

    def test_a_frame_is_not_overwritten_later(self, driver: SensorDriver) -> None:
        driver.open()
        first = next_reading(driver)
        numbers = first.image if isinstance(first, Frame) else first.v
        copy = numbers.copy()
        for _ in range(10):
            next_reading(driver)
        np.testing.assert_array_equal(numbers, copy)

    def test_exposure_stays_within_its_range(self, driver: SensorDriver) -> None:
        shortest, longest = driver.open().exposure_range_us
        for wanted in (shortest, shortest, 2 * longest + 1.0, 0.0):
            driver.set_exposure_us(wanted)
            for _ in range(8):
                frame = next_reading(driver)
            assert shortest <= frame.exposure_us <= longest

    def test_the_laser_switch_is_idempotent_and_always_answers(self, driver: SensorDriver) -> None:
        driver.set_laser(False)
        has_switch = driver.open().has_laser_switch
        for on in (True, True, False, False, True):
            driver.set_laser(on)
            frames = [next_reading(driver) for _ in range(8)]
            # a busy machine has more pictures waiting from before
            while has_switch and frames[-1].laser_on != on and len(frames) < MOST_WAITING:
                frames.append(next_reading(driver))
            assert not has_switch or frames[-1].laser_on == on
        driver.close()
        driver.set_laser(False)

    def test_loss_is_an_error_until_opened(self, bench: SensorBench, driver: SensorDriver) -> None:
        driver.open()
        next_reading(driver)
        assert_lost_while_unplugged(bench, driver)
        driver.open()
        next_reading(driver)
        assert driver.health.received > 0

    def test_pictures_lost_on_the_wire_are_counted(self, bench: SensorBench) -> None:
        """A busy machine may lose more while it opens: then it is tried again."""
        deadline = time.monotonic() + LONG_S
        while True:
            driver, damaged = bench.lossy_driver(resent=False)
            driver.open()
            if driver.health.lost <= len(damaged):
                break
            driver.close()
            assert time.monotonic() < deadline, "what was not sent counts as lost each time"
        seen = read_past(driver, max(damaged))
        missing = set(range(max(seen))) - seen
        # numbers begin with the first picture that the driver sees; the camera may be ahead
        ahead = range(min(damaged) + 1)
        assert any({number - late for number in damaged} <= missing for late in ahead)
        assert len(missing) <= driver.health.lost
        driver.close()

    def test_what_is_sent_again_is_not_lost(self, bench: SensorBench) -> None:
        """On a busy machine, what is sent again may come too late: then it is tried again."""
        deadline = time.monotonic() + LONG_S
        while True:
            driver, damaged = bench.lossy_driver(resent=True)
            driver.open()
            seen = read_past(driver, max(damaged))
            driver.close()
            if damaged <= seen:
                return
            assert time.monotonic() < deadline, f"{damaged - seen} of {damaged} are lost each time"

    def test_a_counter_may_begin_again(self, bench: SensorBench, driver: SensorDriver) -> None:
        enough = bench.pictures_until_wrap() + 30
        driver.open()
        frames = [next_frame(driver) for _ in range(enough)]
        steps = np.diff([frame.sequence for frame in frames])
        assert steps.min() == 1
        assert (steps - 1).sum() <= driver.health.lost < enough

    def test_a_triggered_camera_is_silent_and_there(self, bench: SensorBench) -> None:
        driver = bench.triggered_driver()
        info = driver.open()
        assert not info.free_running
        assert isinstance(driver, AnswersWhileSilent)
        for _ in range(5):
            assert driver.read(0.2) is None
            assert driver.is_alive()
        frames: list[Frame] = []
        pulses = missed = 0
        while len(frames) < 3:
            bench.trigger()
            pulses += 1
            frame = reading_within(driver, TRIGGERED_S)
            if frame is not None:
                assert isinstance(frame, Frame)
                assert frame.pulse == pulses
                assert frame.image.shape == (info.height_px, info.width_px)
                frames.append(frame)
                continue
            missed += 1  # a busy machine may have lost it, or the control of the camera
            assert missed < 8, "most pictures are lost"
            if missed % 2 == 0:
                driver.close()
                open_in_time(driver)
                pulses = 0
        assert driver.read(0.2) is None
        assert driver.health.lost <= pulses - 3
        bench.unplug()
        assert not driver.is_alive()
        loss_of(driver)
        assert not driver.is_alive()
        driver.close()

    def test_a_device_in_use_is_refused(self, bench: SensorBench, driver: SensorDriver) -> None:
        bench.take_control()
        with pytest.raises(DeviceError, match="in use by another program"):
            driver.open()
        bench.leave_control()
        open_in_time(driver)
        next_frame(driver)

    def test_a_disobedient_device_is_lost(self, bench: SensorBench, driver: SensorDriver) -> None:
        driver.open()
        next_reading(driver)
        bench.revoke_control()
        error = loss_of(driver)
        assert error.remedy
        open_in_time(driver)
        next_frame(driver)
