"""Finds a driver by its name in station.toml.

Drivers are entry points of the groups ``crenel.arms`` and ``crenel.sensors``: callables that take
the options of the table and return an unopened driver. The group ``crenel.finders`` has what
``crenel_hardware.discovery`` calls to find devices. The program's own are registered in its
pyproject.toml, like those of other packages.
"""

from collections.abc import Callable, Mapping
from difflib import get_close_matches
from importlib.metadata import EntryPoint, entry_points
from typing import Literal, TypeAlias, cast

from crenel.messages.message import Text, join, message
from crenel_hardware.errors import DeviceError
from crenel_hardware.interfaces import ArmDriver, SensorDriver
from crenel_hardware.options import Options, options_model

_ARMS, _SENSORS = "crenel.arms", "crenel.sensors"
FINDERS = "crenel.finders"

DeviceKind: TypeAlias = Literal["arm", "sensor"]
"""The table of station.toml that a device is for."""


def arm_drivers() -> list[str]:
    """Names for ``[arm] driver``."""
    return sorted(find_entries(_ARMS))


def sensor_drivers() -> list[str]:
    """Names for ``[sensor] driver``."""
    return sorted(find_entries(_SENSORS))


def arm_driver(name: str, options: Mapping[str, object]) -> ArmDriver:
    """An unopened arm driver.

    Args:
        name: value of ``[arm] driver`` in station.toml.
        options: the other keys of the table.

    Raises:
        DeviceError: no such driver, its package is broken, or an option is wrong.
    """
    return cast(ArmDriver, _factory(_ARMS, name)(options))


def sensor_driver(name: str, options: Mapping[str, object]) -> SensorDriver:
    """An unopened sensor driver; like ``arm_driver``, for ``[sensor]``."""
    return cast(SensorDriver, _factory(_SENSORS, name)(options))


def first_name(kind: DeviceKind, name: str) -> str:
    """The first name, by the alphabet, under which a driver is offered; else the name itself."""
    found = find_entries(_ARMS if kind == "arm" else _SENSORS)
    values = {entry.value for entry in found.get(name, [])}
    same = [other for other, entries in found.items() if values & {one.value for one in entries}]
    return min(same, default=name)


def driver_options(kind: DeviceKind, name: str) -> type[Options] | None:
    """The options of a driver; None of a driver that does not use ``read_options``.

    Raises:
        DeviceError: no such driver, or its package is broken.
    """
    return options_model(_factory(_ARMS if kind == "arm" else _SENSORS, name))


def find_entries(group: str) -> dict[str, list[EntryPoint]]:
    """Every entry point of the group by name, the program's own first; identical duplicates count
    once."""
    found: dict[str, list[EntryPoint]] = {}
    for entry in sorted(entry_points(group=group), key=_is_foreign):
        same_name = found.setdefault(entry.name, [])
        if all(entry.value != other.value for other in same_name):
            same_name.append(entry)
    return found


def _factory(group: str, name: str) -> Callable[[Mapping[str, object]], object]:
    table = "arm" if group == _ARMS else "sensor"
    found = find_entries(group)
    if name not in found:
        near = get_close_matches(name, found, 1)
        drivers = message("drivers-are", names=", ".join(sorted(found)))
        raise DeviceError(
            message("station-toml-no-such-driver", table=table, name=repr(name)),
            join([message("did-you-mean", name=near[0]), drivers], " ") if near else drivers,
        )
    entry, *others = found[name]
    if others:
        packages = join([package_of(each) for each in (entry, *others)])
        raise DeviceError(
            message("driver-offered", table=table, name=repr(name), packages=packages),
            message("uninstall-one-them"),
        )
    try:
        loaded = entry.load()
    except Exception as error:
        raise DeviceError(
            message(
                "driver-cannot-be-loaded",
                table=table,
                name=repr(name),
                package=package_of(entry),
                kind=type(error).__name__,
                error=error,
            ),
            message("reinstall-update-package"),
        ) from error
    if not callable(loaded):
        raise DeviceError(
            message(
                "driver-not-callable",
                table=table,
                name=repr(name),
                package=package_of(entry),
                value=entry.value,
            ),
            message("entry-point-must-name-function-takes"),
        )
    return cast(Callable[[Mapping[str, object]], object], loaded)


def package_of(entry: EntryPoint) -> Text:
    """The package that offers an entry point, in words."""
    if entry.dist is None or not _is_foreign(entry):
        return message("this-program")
    return message("package-named", name=entry.dist.name, version=entry.dist.version)


def _is_foreign(entry: EntryPoint) -> bool:
    return entry.dist is not None and entry.dist.name != "crenel"
