"""The station's devices: one arm, one sensor or several, read and reconnected permanently."""

import shutil
import threading
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Literal, TypeAlias

from crenel.errors import OperationError
from crenel.loops import Loop
from crenel.messages.message import Text, join, message, word
from crenel.station.bus import Bus
from crenel.station.devices.arm_device import StationArm
from crenel.station.devices.capture import Capture, capture
from crenel.station.devices.device_thread import Link, LinkState
from crenel.station.devices.link_state import DeviceState
from crenel.station.devices.sensor_device import LaserBelief, StationSensor
from crenel.station.pulses.pulse_pairing import PulsePairing
from crenel.station.pulses.pulse_trigger import PulseTrigger, TriggerSettings
from crenel_hardware.interfaces import ArmDriver, SensorDriver

# Interval at which devices are published, and at once when one is lost or back.
PUBLISH_S, LOOK_S = 0.2, 0.05
DeviceName: TypeAlias = Literal["arm", "sensor"]


@dataclass(frozen=True, slots=True)
class Devices:
    """Everything that the browser shows of the devices."""

    arm: DeviceState
    sensor: DeviceState
    laser: LaserBelief
    """What is believed of the lasers of all sensors: on if one is, off only if each is known to
    be."""
    has_laser_switch: bool
    arm_still: bool
    exposure_us: float | None
    tip_mm: tuple[float, float, float] | None
    disk_free_gb: float | None
    """None while the data folder cannot be looked at."""


@dataclass(frozen=True, slots=True)
class NamedSensor:
    """One of several sensors."""

    name: str
    label: str
    """What people call it."""
    state: DeviceState
    laser: LaserBelief


@dataclass(frozen=True, slots=True)
class SensorChoice:
    """The sensors of a station with several."""

    selected: str
    """Name of the one that is seen, switched, exposed and calibrated."""
    sensors: tuple[NamedSensor, ...]


class Rig:
    """Both devices, and operations that need both.

    Args:
        arm, sensor: return a new, unopened driver at each call; of several sensors, one for each
            by its name.
        data_dir: the folder whose disk is watched.
        trigger: the arm triggers the cameras in this way; None if it does not.
        real: of a demonstration, which devices are real ones instead of the simulation's.
    """

    def __init__(
        self,
        bus: Bus,
        arm: Callable[[], ArmDriver],
        sensor: Callable[[], SensorDriver] | Mapping[str, Callable[[], SensorDriver]],
        data_dir: Path,
        trigger: TriggerSettings | None = None,
        real: frozenset[DeviceName] = frozenset(),
    ) -> None:
        self.real = real
        self._bus = bus
        self._data_dir = data_dir
        makers = {"": sensor} if callable(sensor) else dict(sensor)
        pairings: dict[str, PulsePairing] = {}
        if trigger is not None:
            pairings = {name: PulsePairing(trigger.delay_of_us(name)) for name in makers}
        self.arm = StationArm(bus, arm, tuple(pairings.values()))
        self.sensors: Mapping[str, StationSensor] = {
            name: StationSensor(bus, make, pairings.get(name)) for name, make in makers.items()
        }
        """By their names; the name of the only one is empty."""
        for name, one in self.sensors.items():
            one.label = name
        self._selected = next(iter(self.sensors))
        self._trigger: PulseTrigger | None = None
        if trigger is not None:
            self._trigger = PulseTrigger(trigger, tuple(pairings.values()))
        self._capturing = threading.Lock()
        self._publisher: Loop | None = None
        self._reported: dict[str, Link] = {}
        self._published_s, self._doubted = 0.0, False

    @property
    def sensor(self) -> StationSensor:
        """The only sensor; of several, the one that is selected."""
        return self.sensors[self._selected]

    @property
    def selected(self) -> str:
        """Name of the sensor that is seen, switched, exposed and calibrated; empty of the only
        one."""
        return self._selected

    def select(self, name: str, is_scanning: bool = False) -> None:
        """Selects another sensor; the lasers of the others are switched off, except in a scan.

        Raises:
            OperationError: there is no such sensor, or a picture is being taken.
        """
        if name not in self.sensors:
            raise OperationError("no-such-sensor", message("no-sensor-named", name=name))
        if not self._capturing.acquire(blocking=False):
            raise OperationError("busy", message("picture-being-taken-already"))
        try:
            self._selected = name
        finally:
            self._capturing.release()
        for other, sensor in self.sensors.items():
            if other != name and not is_scanning:
                sensor.laser_off()

    @property
    def laser(self) -> LaserBelief:
        """What is believed of all lasers together, the gravest first."""
        order = ("on", "unknown", "off")
        beliefs = [one.laser for one in self.sensors.values()]
        return min(beliefs, key=lambda belief: order.index(belief.state))

    def lasers_off(self) -> None:
        """Switches the lasers of all sensors off; never raises."""
        for sensor in self.sensors.values():
            sensor.laser_off()

    def start(self) -> None:
        self.arm.reader.start()
        for sensor in self.sensors.values():
            sensor.reader.start()
        if self._trigger is not None:
            self._trigger.start()
        self._publisher = Loop("rig-state", self._publish, LOOK_S)
        self._publisher.start()

    def stop(self) -> None:
        """Switches the lasers off, closes devices and ends threads."""
        self.lasers_off()
        if self._trigger is not None:
            self._trigger.stop()
        self.arm.reader.stop()
        for sensor in self.sensors.values():
            sensor.reader.stop()
        if self._publisher is not None:
            self._publisher.stop(2.0)
            self._publisher = None

    def use_arm(self, make: Callable[[], ArmDriver], real: bool = True) -> None:
        """Changes to another arm, without a restart."""
        self.real = self.real | {"arm"} if real else self.real - {"arm"}
        self.arm.reader.replace(make)

    def use_sensor(self, make: Callable[[], SensorDriver], real: bool = True) -> None:
        """Changes to another sensor, without a restart."""
        self.real = self.real | {"sensor"} if real else self.real - {"sensor"}
        self.sensor.replace(make)

    def devices(self) -> Devices:
        """The current state of everything."""
        info = self.sensor.info
        return Devices(
            arm=self.arm.link(),
            sensor=self.sensor.link(),
            laser=self.laser,
            has_laser_switch=info is not None and info.has_laser_switch,
            arm_still=self.arm.stillness().still,
            exposure_us=self.sensor.exposure_us,
            tip_mm=self.arm.tip_mm(),
            disk_free_gb=self._disk_free_gb(),
        )

    def _disk_free_gb(self) -> float | None:
        try:
            return shutil.disk_usage(self._data_dir).free / 1e9
        except OSError:
            return None

    def losing(self) -> frozenset[str]:
        """The devices that lose much of their data just now: arm, sensor and its name."""
        links = [("arm", self.arm.reader.link())]
        links += [(f"sensor {name}", one.reader.link()) for name, one in self.sensors.items()]
        return frozenset(name for name, link in links if link.losing)

    def sensor_choice(self) -> SensorChoice:
        """The sensors to choose from."""
        return SensorChoice(
            self._selected,
            tuple(
                NamedSensor(name, one.label or name, one.link(), one.laser)
                for name, one in self.sensors.items()
            ),
        )

    def capture_pair(self, needs_laser: bool = True) -> Capture:
        """The calibration picture: ambient and laser while the arm is still, or one with both.

        Args:
            needs_laser: False if the ambient picture will do where the laser does not switch on.

        Raises:
            OperationError: ``arm-moving`` before, ``arm-moved`` during the capture,
                ``arm-lost``, ``no-arm-model``, ``sensor-lost``, ``laser-stuck``, ``no-pictures``,
                ``busy``.
        """
        _, info = self.sensor.open_driver()
        if not self._capturing.acquire(blocking=False):
            raise OperationError("busy", message("picture-being-taken-already"))
        try:
            self.arm.average()
            with self.sensor.pictures():
                return capture(
                    self.sensor.frames,
                    self.sensor.set_laser if info.has_laser_switch else None,
                    self.sensor.is_taken_as_lit,
                    lambda first_ns, last_ns: self.arm.mean_over(first_ns, last_ns, "arm-moved"),
                    needs_laser,
                )
        finally:
            self._capturing.release()

    def _publish(self) -> None:
        """Reports what has changed; publishes at once when a device is lost or back."""
        before = _states(self._reported)
        links = [("arm", "", self.arm.reader.link())]
        links += [("sensor", name, one.reader.link()) for name, one in self.sensors.items()]
        for title, name, link in links:
            key = f"{title} {name}"
            known, self._reported[key] = self._reported.get(key), link
            self._report_link(title, known, link, name)
        if self._trigger is not None:
            drivers = [one.reader.driver for one in self.sensors.values()]
            self._trigger.use(self.arm.reader.driver, drivers)
        self._report_doubt()
        now_s = time.monotonic()
        if _states(self._reported) != before or now_s - self._published_s >= PUBLISH_S:
            self._published_s = float("-inf")  # at once if this fails
            self._bus.publish("devices", self.devices())
            if len(self.sensors) > 1:
                self._bus.publish("sensors", self.sensor_choice())
            self._published_s = now_s

    def _report_doubt(self) -> None:
        """Reports once that the arm's readings have become impossible."""
        doubt = self.arm.doubt()
        before, self._doubted = self._doubted, doubt is not None
        if doubt is not None and not before:
            self._bus.event(doubt.code, doubt.text, "bad")

    def _report_link(self, title: str, before: Link | None, link: Link, name: str = "") -> None:
        """Reports once that a device was lost or loses much, and once that it is back."""
        if link.losing and not (before and before.losing):
            losing: Text = message("data-lost-now", title=word(title))
            losing = join([name, losing], ": ") if name else losing
            self._bus.event(f"{title}-losing", losing, "bad")
        if before and before.state == link.state:
            return
        text = join([name, link.text], ": ") if name else link.text
        if link.state is LinkState.LOST:
            self._bus.event(f"{title}-lost", text, "bad")
        elif link.state is LinkState.CONNECTED:
            self._bus.event(f"{title}-connected", text, "good")


def _states(links: Mapping[str, Link]) -> dict[str, tuple[LinkState, bool]]:
    """What is published at once when it changes."""
    return {name: (link.state, link.losing) for name, link in links.items()}
