"""Drivers by their names: made, checked, and described for a form."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import NoReturn

from crenel.errors import OperationError
from crenel.messages.message import Text, message, word
from crenel.station.devices.device_thread import NoDeviceChosenError
from crenel.station.devices.rig import DeviceName, Rig
from crenel_hardware import registry
from crenel_hardware.errors import DeviceError
from crenel_hardware.interfaces import ArmDriver, SensorDriver
from crenel_hardware.option_fields import OptionField, option_fields, read_entered

Options = Mapping[str, object]


@dataclass(frozen=True)
class DriverForm:
    """A driver that can be chosen, with the fields of its options."""

    kind: DeviceName
    name: str
    title: Text
    """What it is for."""
    usual: bool
    """Whether it is offered before the others."""
    fields: tuple[OptionField, ...]
    problem: Text
    """Why it cannot be used; usually empty."""
    alias: bool
    """Another name of a driver that is listed, too."""


def driver_forms() -> tuple[DriverForm, ...]:
    """Every driver that is installed, arms first."""
    named: list[tuple[DeviceName, str]] = [("arm", name) for name in registry.arm_drivers()]
    named += [("sensor", name) for name in registry.sensor_drivers()]
    return tuple(_form(kind, name) for kind, name in named)


def _form(kind: DeviceName, name: str) -> DriverForm:
    alias = registry.first_name(kind, name) != name
    try:
        model = registry.driver_options(kind, name)
    except DeviceError as error:
        return DriverForm(kind, name, name, False, (), error.what, alias)
    if model is None:
        return DriverForm(kind, name, name, False, (), "", alias)
    title = model.title or name
    return DriverForm(kind, name, title, model.usual, option_fields(model), "", alias)


def check_options(kind: DeviceName, driver: str, entered: Options) -> dict[str, object]:
    """Options as the driver takes them, from what was entered.

    Raises:
        OperationError: there is no such driver, or it refuses an option; in its own words.
    """
    try:
        options = read_entered(registry.driver_options(kind, driver), entered)
        make = registry.arm_driver if kind == "arm" else registry.sensor_driver
        make(driver, options).close()
    except DeviceError as error:
        raise OperationError("driver-options", error.what, remedy=error.remedy) from error
    return dict(options)


def arm_factory(driver: str, options: Options) -> Callable[[], ArmDriver]:
    """Makes unopened drivers of an arm; each call may raise ``DeviceError``."""
    return lambda: registry.arm_driver(driver, options)


def sensor_factory(driver: str, options: Options) -> Callable[[], SensorDriver]:
    """Makes unopened drivers of a sensor; each call may raise ``DeviceError``."""
    return lambda: registry.sensor_driver(driver, options)


def no_device_factory(kind: DeviceName) -> Callable[[], NoReturn]:
    """Stands for a station without such a device: every call raises ``NoDeviceChosenError``."""

    def make() -> NoReturn:
        raise NoDeviceChosenError(
            message("no-device-chosen", title=word(kind)), message("choose-one-under-devices")
        )

    return make


_ADDRESSES = frozenset(
    ("url", "source", "path", "address", "host", "port", "serial_number", "serial", "topic")
)


def device_address(kind: DeviceName, driver: str, options: Options) -> dict[str, object]:
    """Those of the options that say which device it is; the others say how it is used."""
    model = registry.driver_options(kind, driver)
    required = (
        set() if model is None else {k for k, v in model.model_fields.items() if v.is_required()}
    )
    return {key: value for key, value in options.items() if key in required | _ADDRESSES}


def is_same_device(
    kind: DeviceName, driver: str, options: Options, other: str, other_options: Options
) -> bool:
    """Whether two tables address the same device, as far as can be seen without opening it.

    Args:
        driver, options: as found: every option addresses the device.
        other, other_options: a table with any options.
    """
    files = _device_files(options)
    if files & _device_files(other_options):
        return True
    names = registry.first_name(kind, driver), registry.first_name(kind, other)
    if names[0] != names[1] or not options:
        return False
    return all(other_options.get(key) == value for key, value in options.items())


def _device_files(options: Options) -> set[Path]:
    """The device files among the options; a camera's number is one, too."""
    files = {
        Path(value).resolve()
        for value in options.values()
        if isinstance(value, str) and value.startswith("/dev/")
    }
    source = options.get("source")
    if isinstance(source, int):
        files.add(Path(f"/dev/video{source}"))
    return files


@dataclass(frozen=True)
class SimulatedDevices:
    """What a demonstration uses while no device is chosen."""

    arm: Callable[[], ArmDriver]
    sensor: Callable[[], SensorDriver]


@dataclass(frozen=True)
class DeviceChoice:
    """A driver with its options."""

    driver: str
    options: Options
    label: str = ""
    """What people call the device."""


def choose_arm(
    choice: DeviceChoice | None, simulation: SimulatedDevices | None
) -> Callable[[], ArmDriver]:
    """The factory of the arm: of the choice, or of the simulation, or one without an arm."""
    if choice is not None:
        return arm_factory(choice.driver, choice.options)
    return no_device_factory("arm") if simulation is None else simulation.arm


def choose_sensor(
    choice: DeviceChoice | None, simulation: SimulatedDevices | None
) -> Callable[[], SensorDriver]:
    """The factory of the sensor, as ``choose_arm``."""
    if choice is not None:
        return sensor_factory(choice.driver, choice.options)
    return no_device_factory("sensor") if simulation is None else simulation.sensor


def use_choice(
    rig: Rig, kind: DeviceName, choice: DeviceChoice | None, simulation: SimulatedDevices | None
) -> None:
    """Changes a device of the station to the choice, without a restart."""
    side = rig.arm if kind == "arm" else rig.sensor
    side.label = "" if choice is None else choice.label
    if kind == "arm":
        rig.use_arm(choose_arm(choice, simulation), real=choice is not None)
    else:
        rig.use_sensor(choose_sensor(choice, simulation), real=choice is not None)
