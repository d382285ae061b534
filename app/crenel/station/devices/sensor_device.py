"""The sensor of the rig: its frames, its laser, its exposure."""

import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from typing import Literal

from crenel.errors import OperationError
from crenel.messages.message import message
from crenel.station.bus import Bus
from crenel.station.devices.auto_exposure import MOST_STEPS, better_exposure_us
from crenel.station.devices.capture import no_pictures_error
from crenel.station.devices.device_thread import READ_TIMEOUT_S, DeviceReader
from crenel.station.devices.frame_hub import FrameHub
from crenel.station.devices.link_state import DeviceState, device_state
from crenel.station.pulses.pulse_pairing import PulsePairing
from crenel_hardware.clock import now_ns
from crenel_hardware.errors import DeviceError
from crenel_hardware.interfaces import (
    DeliversLines,
    Delivery,
    Frame,
    Line,
    SensorDriver,
    SensorInfo,
)

LaserState = Literal["on", "off", "unknown"]
LaserSource = Literal["switch", "no-switch", "no-answer", "lost", "absent"]
Better = Callable[[Frame, tuple[float, float]], float | None]

# After a loss no longer than this, a laser that was on is switched on again.
LASER_RESTORE_S = 5.0
FRAME_TIMEOUT_S = 3.0


@dataclass(frozen=True, slots=True)
class LaserBelief:
    """What is believed of a laser, and from what. Nothing that has no ground is believed."""

    state: LaserState
    known_from: LaserSource
    """``switch``: as last switched, which the sensor took. The other four say why it is unknown:
    nobody can switch the laser here and the camera does not see whether it has one, the sensor did
    not answer, its connection is lost, or no sensor was connected yet."""


class StationSensor:
    """Reads the sensor in its own thread; everything else may be called from any thread."""

    def __init__(
        self, bus: Bus, make: Callable[[], SensorDriver], pairing: PulsePairing | None = None
    ) -> None:
        """``pairing``: gives frames the times of their trigger pulses."""
        self.label = ""
        """What people call it."""
        self._bus = bus
        self._pairing = pairing
        self.frames = FrameHub()
        self._exposure_wanted_us: float | None = None
        self._laser_wanted = False
        self._laser_answered = True
        """Whether the sensor took the last switching of its laser."""
        self._was_connected = False
        self._delivering = threading.RLock()
        self._lines_wanted = False
        self._picture_users = 0
        self._last_frame_s = 0.0
        self.reader: DeviceReader[SensorDriver, SensorInfo] = DeviceReader(
            "sensor",
            make,
            lambda driver: driver.open(),
            self._read,
            self._on_connect,
            lambda info: info.longest_gap_s,
            lambda info: info.free_running,
        )

    def replace(self, make: Callable[[], SensorDriver]) -> None:
        """Switches the laser off and changes to another sensor, with an exposure of its own."""
        self.laser_off()
        self._exposure_wanted_us = None
        self._lines_wanted = self._was_connected = False
        self.reader.replace(make)
        self.frames.clear()

    @property
    def info(self) -> SensorInfo | None:
        """Properties of the sensor; None while it is not connected."""
        return self.reader.info

    @property
    def fresh(self) -> bool:
        """True while frames arrive."""
        return self.reader.fresh

    @property
    def is_paired(self) -> bool:
        """Whether frames and readings of the arm have the times of the same pulses."""
        return self._pairing is not None and self._pairing.is_paired

    def link(self) -> DeviceState:
        return device_state(message("sensor-heading"), self.reader.link(), self.info, self.label)

    @property
    def laser(self) -> LaserBelief:
        """Whether the laser is on, and from what that is known."""
        info = self.info
        if info is None or not self.fresh:
            return LaserBelief("unknown", "lost" if self._was_connected else "absent")
        if not info.has_laser_switch:
            return LaserBelief("unknown", "no-switch")
        if not self._laser_answered:
            return LaserBelief("unknown", "no-answer")
        return LaserBelief("on" if self._laser_wanted else "off", "switch")

    @property
    def is_taken_as_lit(self) -> bool:
        """Whether a laser line is looked for in the pictures: as the laser was last switched; if it
        has no switch, as the driver assumes. This is no knowledge of the laser: see ``laser``."""
        info, latest = self.info, self.frames.newest
        if info is None:
            return False
        if info.has_laser_switch:
            return self._laser_wanted
        return latest is not None and latest.laser_on

    @property
    def exposure_us(self) -> float | None:
        """The exposure of the latest frame or line; None without a sensor."""
        latest = self.frames.newest
        return latest.exposure_us if latest is not None and self.info else None

    def set_laser(self, on: bool) -> None:
        """Switches the laser; raises ``OperationError`` without a sensor or a switch."""
        driver, info = self.open_driver()
        if not info.has_laser_switch:
            raise OperationError(
                "no-laser-switch",
                message("sensors-laser-cannot-switched-here"),
                remedy=message("use-switch-sensor"),
            )
        self._laser_answered = False
        try:
            driver.set_laser(on)
        except DeviceError as error:
            raise OperationError("sensor-lost", error.what, remedy=error.remedy) from error
        self._laser_wanted, self._laser_answered = on, True

    def laser_off(self) -> None:
        """Switches the laser off if there is one; never raises."""
        self._laser_wanted = False
        driver = self.reader.driver
        if driver is not None:
            self._laser_answered = False
            try:
                driver.set_laser(False)
                self._laser_answered = True
            except DeviceError:
                # the sensor is lost; its driver switches the laser off when it closes
                self._bus.event("laser", message("sensor-did-answer-laser-off"), "bad")

    def set_exposure_us(self, exposure_us: float) -> None:
        """Sets the exposure from one of the next frames on; kept over a reconnection."""
        driver, info = self.open_driver()
        shortest, longest = info.exposure_range_us
        wanted = min(max(exposure_us, shortest), longest)
        try:
            driver.set_exposure_us(wanted)
        except DeviceError as error:
            raise OperationError("sensor-lost", error.what, remedy=error.remedy) from error
        self._exposure_wanted_us = wanted

    def auto_exposure(self, better: Better = better_exposure_us) -> float:
        """Brings the bright parts of the picture to 70 % of full scale; returns the exposure in µs.

        A rule other than ``better_exposure_us`` may define the bright parts.

        Blocks for about a second; outside the range, the exposure stays at the limit.
        """
        _, info = self.open_driver()
        with self.pictures():
            frame = self._next_frame(now_ns(), None)
            for _ in range(MOST_STEPS):
                wanted = better(frame, info.exposure_range_us)
                if wanted is None:
                    break
                self.set_exposure_us(wanted)
                frame = self._next_frame(now_ns(), wanted)
            return frame.exposure_us

    def want_lines(self, on: bool) -> None:
        """Has the sensor deliver lines from now on if it can, or pictures again.

        Kept over a reconnection. Without a sensor, it takes effect when it is back.

        Raises:
            OperationError: the sensor refuses.
        """
        with self._delivering:
            self._lines_wanted = on
            self._set_delivery()

    @contextmanager
    def pictures(self) -> Iterator[None]:
        """The sensor delivers pictures while such a block is open.

        Raises:
            OperationError: ``no-pictures`` of a sensor that delivers lines alone, ``sensor-lost``.
        """
        _, info = self.open_driver()
        if "picture" not in info.delivers:
            raise no_pictures_error()
        with self._delivering:
            self._picture_users += 1
            try:
                self._set_delivery()
            except OperationError:
                self._picture_users -= 1
                raise
        try:
            yield
        finally:
            with self._delivering:
                self._picture_users -= 1
                with suppress(OperationError):  # a lost sensor follows when it is back
                    self._set_delivery()

    def _set_delivery(self) -> None:
        driver, info = self.reader.driver, self.info
        if driver is None or info is None:
            return
        try:
            _deliver(driver, info, self._delivery)
        except DeviceError as error:
            raise OperationError("sensor-lost", error.what, remedy=error.remedy) from error

    @property
    def _delivery(self) -> Delivery:
        return "line" if self._lines_wanted and not self._picture_users else "picture"

    def open_driver(self) -> tuple[SensorDriver, SensorInfo]:
        """The open driver; raises ``OperationError`` if there is none."""
        driver, info = self.reader.driver, self.info
        if driver is None or info is None:
            raise OperationError(
                "sensor-lost",
                message("sensor-not-connected"),
                self.reader.link().text,
                message("wait-until-connected"),
            )
        return driver, info

    def _next_frame(self, after_ns: int, exposure_us: float | None) -> Frame:
        """A frame after a time stamp, with the wanted exposure if it arrives within a second."""

        def later(frame: Frame) -> bool:
            return frame.mid_exposure_ns > after_ns

        def as_wanted(frame: Frame) -> bool:
            return later(frame) and (
                exposure_us is None or abs(frame.exposure_us - exposure_us) < 0.01 * exposure_us
            )

        frame = self.frames.wait(as_wanted, 1.0) or self.frames.wait(later, FRAME_TIMEOUT_S)
        if frame is None:
            newest = self.frames.newest
            if isinstance(newest, Line) and newest.mid_exposure_ns > after_ns:
                raise no_pictures_error()
            raise OperationError(
                "sensor-lost", message("no-picture-came-sensor"), remedy=message("wait-until-back")
            )
        return frame

    def _on_connect(self, driver: SensorDriver, info: SensorInfo) -> None:
        """Restores the state of a sensor that is back."""
        self._was_connected = True
        if self._exposure_wanted_us is not None:
            driver.set_exposure_us(self._exposure_wanted_us)
        with self._delivering:
            _deliver(driver, info, self._delivery)
        if info.has_laser_switch:
            away_s = time.monotonic() - self._last_frame_s
            self._laser_wanted = self._laser_wanted and away_s <= LASER_RESTORE_S
            self._laser_answered = False
            driver.set_laser(self._laser_wanted)
            self._laser_answered = True

    def _read(self, driver: SensorDriver) -> int:
        frame = driver.read(READ_TIMEOUT_S)
        if frame is None:
            return 0
        self._last_frame_s = time.monotonic()
        if self._pairing is not None:
            paired = self._pairing.pair(frame)
            if paired is None:  # its pulse is not known: nothing is made of it
                return 1
            frame = paired
        self.frames.put(frame)
        return 1


def _deliver(driver: SensorDriver, info: SensorInfo, delivery: Delivery) -> None:
    """Tells a sensor that has the choice; raises ``DeviceError``."""
    if len(info.delivers) > 1 and isinstance(driver, DeliversLines):
        driver.set_delivery(delivery)
