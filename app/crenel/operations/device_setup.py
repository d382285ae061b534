"""Setting up the station's devices: finding, trying and choosing them."""

import threading
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Literal

from crenel.errors import OperationError
from crenel.formats.file_names import display_path
from crenel.guide.common.datasheet_library import DatasheetLibrary
from crenel.messages.message import Text, message, word
from crenel.operations.datasheets.new_datasheet import (
    UndescribedArm,
    UndescribedSensor,
    find_undescribed,
    find_undescribed_arm,
    write_arm_datasheet,
    write_datasheet,
)
from crenel.settings.device_tables import write_device
from crenel.settings.settings import DeviceKind, DeviceTable
from crenel.station.bus import Bus
from crenel.station.devices.link_state import DeviceState
from crenel.station.devices.rig import Rig
from crenel.station.setup.drivers import (
    DeviceChoice,
    DriverForm,
    SimulatedDevices,
    check_options,
    device_address,
    driver_forms,
    is_same_device,
    use_choice,
)
from crenel.station.setup.search import DeviceSearch, SearchProblem
from crenel.station.setup.trial_view import TrialSubject, TrialView
from crenel.station.setup.trials import DeviceTrials

KINDS: tuple[DeviceKind, ...] = ("arm", "sensor")


@dataclass(frozen=True)
class StationDevices:
    """What ``station.toml`` says of the devices."""

    file: Path | None = None
    """None where nothing can be chosen, as of a recording that is replayed."""
    tables: Mapping[DeviceKind, DeviceTable] = field(default_factory=dict)
    simulation: SimulatedDevices | None = None
    """What a demonstration uses without a table."""
    sensors: Mapping[str, DeviceTable] = field(default_factory=dict)
    """The tables of a station with several sensors, by their names; they are not changed on the
    page."""


@dataclass(frozen=True)
class StationDevice:
    """A device of the station."""

    kind: DeviceKind
    driver: str
    """Empty of a simulated device, or if none is chosen."""
    label: str
    options: Mapping[str, object]
    simulated: bool
    state: DeviceState


@dataclass(frozen=True)
class FoundView:
    """A device that was found."""

    kind: DeviceKind
    driver: str
    title: Text
    options: Mapping[str, object]
    in_use: bool
    """The station uses it."""


@dataclass(frozen=True)
class DevicesView:
    """The content of the Devices page."""

    file: str
    """Where choices are saved; empty where nothing can be chosen."""
    demonstration: bool
    devices: tuple[StationDevice, ...]
    searching: bool
    searched: bool
    """Whether a search has ended."""
    found: tuple[FoundView, ...]
    problems: tuple[SearchProblem, ...]
    drivers: tuple[DriverForm, ...]
    undescribed: UndescribedSensor | None
    """The chosen camera, if the data folder has no datasheet of it yet."""
    undescribed_arm: UndescribedArm | None
    """The chosen arm, likewise."""


def choice_of(table: DeviceTable | None) -> DeviceChoice | None:
    """The choice that a table of ``station.toml`` makes."""
    return None if table is None else DeviceChoice(table.driver, table.options, table.label)


class DeviceSetup:
    """The devices of one station. Methods may be called from any thread.

    Args:
        busy: why devices cannot be changed now; None if they can.
        note: called with the tables after each change.
        note_options: called with the options of a device before it is opened.
        library: the datasheets in the data folder.
        data: the data folder.
    """

    def __init__(
        self,
        bus: Bus,
        rig: Rig,
        devices: StationDevices,
        busy: Callable[[], OperationError | None],
        note: Callable[[Mapping[DeviceKind, DeviceTable]], None],
        note_options: Callable[[Mapping[str, object]], None],
        library: Callable[[], DatasheetLibrary],
        data: Path,
    ) -> None:
        self._library, self._data = library, data
        self._note_options = note_options
        for table in devices.tables.values():
            note_options(table.options)
        self._bus, self._rig, self._busy, self._note = bus, rig, busy, note
        self._file, self._simulation = devices.file, devices.simulation
        self._tables = dict(devices.tables)
        for kind, table in self._tables.items():
            (rig.arm if kind == "arm" else rig.sensor).label = table.label
        self._sensors = dict(devices.sensors)
        for name, table in self._sensors.items():
            rig.sensors[name].label = table.label or name
        self._changing = threading.Lock()
        self.search = DeviceSearch()
        self.trials = DeviceTrials(rig)

    @cached_property
    def _forms(self) -> tuple[DriverForm, ...]:
        return driver_forms()

    def view(self) -> DevicesView:
        """The present content of the page."""
        result = self.search.result
        return DevicesView(
            file="" if self._file is None else display_path(self._file),
            demonstration=self._simulation is not None,
            devices=self._devices(),
            searching=self.search.running,
            searched=result.done,
            found=self._device_rows(),
            problems=result.problems,
            drivers=self._forms,
            undescribed=self._find_undescribed(),
            undescribed_arm=self._find_undescribed_arm(),
        )

    def try_device(self, kind: DeviceKind, driver: str, entered: Mapping[str, object]) -> TrialView:
        """Opens a device for a look, or shows the station's own if it is that one.

        Raises:
            OperationError: there is no such driver, or it refuses an option.
        """
        options = check_options(kind, driver, entered)
        self._note_options(options)
        in_use = self._is_in_use(kind, driver, device_address(kind, driver, options))
        return self.trials.start(TrialSubject(kind, driver, options, in_use))

    def choose(
        self, kind: DeviceKind, driver: str, entered: Mapping[str, object], label: str
    ) -> None:
        """Saves a device in ``station.toml``, and the station uses it at once.

        Raises:
            OperationError: the driver refuses an option, the station is at work, or the file
                cannot be changed; everything is then as before.
        """
        options = check_options(kind, driver, entered)
        self._note_options(options)
        self._change(kind, DeviceTable(driver=driver, label=label.strip(), **options))

    def remove(self, kind: DeviceKind) -> None:
        """Takes a device out of ``station.toml``: a demonstration uses the simulated one again.

        Raises:
            OperationError: as ``choose``.
        """
        if kind in self._tables:
            self._change(kind, None)

    def describe(self, stripe_axis: Literal["u", "v"]) -> None:
        """Writes the datasheet of the chosen camera, which a calibration needs.

        Raises:
            OperationError: it has one, none is connected, or the disk refuses the file.
        """
        with self._changing:
            write_datasheet(self._find_undescribed(), stripe_axis, self._data)

    def describe_arm(self) -> None:
        """Writes the datasheet of the chosen arm, which reports poses.

        Raises:
            OperationError: as ``describe``, or the arm reports joints.
        """
        with self._changing:
            write_arm_datasheet(self._find_undescribed_arm(), self._data)

    def close(self) -> None:
        """Ends a trial."""
        self.trials.close()

    def _change(self, kind: DeviceKind, table: DeviceTable | None) -> None:
        with self._changing:
            if self._file is None:
                raise OperationError("devices-fixed", message("devices-of-replay-are-fixed"))
            if kind == "sensor" and len(self._rig.sensors) > 1:
                raise OperationError(
                    "several-sensors",
                    message("station-has-several-sensors-not-changed-here"),
                    remedy=message("change-them-in-file", file=display_path(self._file)),
                )
            busy = self._busy()
            if busy is not None:
                raise busy
            self.trials.stop()  # it may have the device open
            write_device(self._file, kind, table)
            if table is None:
                self._tables.pop(kind, None)
            else:
                self._tables[kind] = table
            use_choice(self._rig, kind, choice_of(table), self._simulation)
            self._note(self._tables)
        self._bus.event("device-chosen", message("device-was-chosen", title=word(kind)), "good")

    def _find_undescribed(self) -> UndescribedSensor | None:
        if "sensor" not in self._tables:
            return None
        return find_undescribed(self._rig.sensor, self._library())

    def _find_undescribed_arm(self) -> UndescribedArm | None:
        if "arm" not in self._tables:
            return None
        return find_undescribed_arm(self._rig.arm, self._library())

    def _device_rows(self) -> tuple[FoundView, ...]:
        """What the last search found, and the devices in use that no search finds."""
        found = [
            FoundView(
                one.kind,
                one.driver,
                one.title,
                one.options,
                self._is_in_use(one.kind, one.driver, one.options),
            )
            for one in self.search.result.devices
        ]
        for kind, table in self._tables.items():
            if not any(one.in_use and one.kind == kind for one in found):
                found.append(self._manual_device(kind, table))
        return tuple(found)

    def _manual_device(self, kind: DeviceKind, table: DeviceTable) -> FoundView:
        """A device in use that a person has entered."""
        options = device_address(kind, table.driver, table.options)
        side = self._rig.arm if kind == "arm" else self._rig.sensor
        name = "" if side.info is None else side.info.name
        title = " · ".join(filter(None, (name, *map(str, options.values()))))
        return FoundView(kind, table.driver, title or table.driver, options, in_use=True)

    def _is_in_use(self, kind: DeviceKind, driver: str, options: Mapping[str, object]) -> bool:
        return self._name_in_use(kind, driver, options) is not None

    def _name_in_use(
        self, kind: DeviceKind, driver: str, options: Mapping[str, object]
    ) -> str | None:
        """The name of the station's sensor that it is, empty of the arm and of the only sensor;
        None if the station does not use it."""
        tables = {"": self._tables[kind]} if kind in self._tables else {}
        if kind == "sensor":
            tables |= self._sensors
        for name, table in tables.items():
            if is_same_device(kind, driver, options, table.driver, table.options):
                return name
        return None

    def _devices(self) -> tuple[StationDevice, ...]:
        if len(self._rig.sensors) == 1:
            return tuple(self._device(kind) for kind in KINDS)
        return (self._device("arm"), *map(self._one_of_several, self._rig.sensors))

    def _one_of_several(self, name: str) -> StationDevice:
        """One of several sensors."""
        sensor, table = self._rig.sensors[name], self._sensors.get(name)
        return StationDevice(
            kind="sensor",
            driver="" if table is None else table.driver,
            label=sensor.label,
            options={} if table is None else dict(table.options),
            simulated=table is None,
            state=sensor.link(),
        )

    def _device(self, kind: DeviceKind) -> StationDevice:
        table = self._tables.get(kind)
        side = self._rig.arm if kind == "arm" else self._rig.sensor
        return StationDevice(
            kind=kind,
            driver="" if table is None else table.driver,
            label="" if table is None else table.label,
            options={} if table is None else dict(table.options),
            simulated=table is None and self._simulation is not None,
            state=side.link(),
        )
