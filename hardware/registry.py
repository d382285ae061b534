"""Finds a driver by the name that station.toml gives.

Drivers are entry points of the groups ``crenel.arms`` and ``crenel.sensors``: callables
that take the table's options and return an unopened driver. The ones below are built
in; they are registered in pyproject.toml as well and are found here without any
installed package, too.
"""

from collections.abc import Callable, Mapping
from difflib import get_close_matches
from importlib.metadata import EntryPoint, entry_points
from typing import cast

from hardware.errors import DeviceError
from hardware.interfaces import ArmDriver, SensorDriver

_ARMS, _SENSORS = "crenel.arms", "crenel.sensors"

BUILT_IN = {
    _ARMS: {"serial-encoder": "hardware.arm.serial_encoder:from_options"},
    _SENSORS: {
        "opencv": "hardware.sensor.opencv_camera:from_options",
        "folder": "hardware.sensor.folder:from_options",
    },
}


def arm_drivers() -> list[str]:
    """Names that ``[arm] driver`` may take."""
    return sorted(_find_drivers(_ARMS))


def sensor_drivers() -> list[str]:
    """Names that ``[sensor] driver`` may take."""
    return sorted(_find_drivers(_SENSORS))


def arm_driver(name: str, options: Mapping[str, object]) -> ArmDriver:
    """An unopened arm driver.

    Args:
        name: as in ``[arm] driver`` of station.toml.
        options: the table's other keys.

    Raises:
        DeviceError: no such driver, its package is broken, or an option is wrong.
    """
    return cast(ArmDriver, _factory(_ARMS, name)(options))


def sensor_driver(name: str, options: Mapping[str, object]) -> SensorDriver:
    """An unopened sensor driver; as ``arm_driver``, for ``[sensor]``."""
    return cast(SensorDriver, _factory(_SENSORS, name)(options))


def _find_drivers(group: str) -> dict[str, list[EntryPoint]]:
    """Every entry point of the group by name; the same one twice counts once."""
    found = {name: [EntryPoint(name, value, group)] for name, value in BUILT_IN[group].items()}
    for entry in entry_points(group=group):
        same_name = found.setdefault(entry.name, [])
        if all(entry.value != other.value for other in same_name):
            same_name.append(entry)
    return found


def _factory(group: str, name: str) -> Callable[[Mapping[str, object]], object]:
    table = "arm" if group == _ARMS else "sensor"
    found = _find_drivers(group)
    if name not in found:
        near = get_close_matches(name, found, 1)
        meant = f"Did you mean {near[0]}? " if near else ""
        raise DeviceError(
            f"station.toml, [{table}]: there is no driver {name!r}",
            f"{meant}Drivers there are: {', '.join(sorted(found))}.",
        )
    entry, *others = found[name]
    if others:
        packages = " and ".join(_package(each) for each in (entry, *others))
        raise DeviceError(
            f"The {table} driver {name!r} is offered by {packages}", "Uninstall one of them."
        )
    try:
        loaded = entry.load()
    except Exception as error:
        raise DeviceError(
            f"The {table} driver {name!r} of {_package(entry)} cannot be loaded: "
            f"{type(error).__name__}: {error}",
            "Reinstall or update that package.",
        ) from error
    if not callable(loaded):
        raise DeviceError(
            f"The {table} driver {name!r} of {_package(entry)} is not callable: {entry.value}",
            "Its entry point must name a function that takes the options.",
        )
    return cast(Callable[[Mapping[str, object]], object], loaded)


def _package(entry: EntryPoint) -> str:
    if entry.dist is None:
        return "this program"
    return f"the package {entry.dist.name} {entry.dist.version}"
