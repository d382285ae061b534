"""Devices, scans, picture and 3D view of a station: everything that needs no session."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from crenel.messages.message import message
from crenel.operations.calibration_in_use import use_calibration
from crenel.operations.device_setup import StationDevices, choice_of
from crenel.operations.scan_calibrations import find_scan_source
from crenel.server.station_parts import StationParts
from crenel.settings.settings import DeviceKind
from crenel.station.bus import Bus
from crenel.station.devices.rig import Rig
from crenel.station.jobs import Jobs
from crenel.station.operator_settings import OperatorSettings
from crenel.station.preview.preview import Preview
from crenel.station.scan.scanner import Scanner
from crenel.station.setup.drivers import choose_arm, choose_sensor, sensor_factory
from crenel.station.view3d.scene import Scene
from crenel.station.view3d.view_controller import ViewController
from crenel.store.store import Store
from crenel_hardware.interfaces import SensorDriver


@dataclass(frozen=True)
class LiveStation:
    """The parts that threads of devices, scans and views keep up to date."""

    bus: Bus
    rig: Rig
    jobs: Jobs
    preview: Preview
    scene: Scene
    scanner: Scanner
    view_controller: ViewController
    settings: OperatorSettings

    def is_recording(self) -> bool:
        return self.scanner.recording() is not None

    def use_calibrations(self, store: Store) -> None:
        """Makes the active calibration of every sensor the one for its scans."""
        for name in self.rig.sensors:
            use_calibration(name, store, self.rig, self.preview, self.scanner, self.bus)


def open_live_station(parts: StationParts, store: Store) -> LiveStation:
    """Connects the parts; devices are not accessed yet."""
    bus, scans = Bus(), store.folder / "scans"
    rig, scene = _make_rig(parts, bus, store), Scene()
    scanner = Scanner(bus, rig, scene, scans)
    preview = Preview(bus, rig.arm, rig.sensor)
    settings = OperatorSettings(
        bus, rig, scanner, preview, store.settings.read(), store.settings.save
    )
    if store.settings.trouble is not None:
        lost = message("settings-are-lost", error=store.settings.trouble.text)
        bus.event("refused", lost, "attention")
    viewing = ViewController(
        bus, scene, scans, scanner.distance, lambda scan_id: find_scan_source(store, scan_id)
    )
    return LiveStation(bus, rig, Jobs(bus), preview, scene, scanner, viewing, settings)


def _make_rig(parts: StationParts, bus: Bus, store: Store) -> Rig:
    devices = parts.devices
    real: frozenset[DeviceKind] = frozenset(devices.tables)
    if devices.sensors:
        real |= {"sensor"}
    if devices.simulation is None:
        real = frozenset()
    return Rig(
        bus,
        parts.arm or choose_arm(choice_of(devices.tables.get("arm")), devices.simulation),
        parts.sensor or _sensor_makers(devices),
        store.folder,
        parts.trigger,
        real,
    )


def _sensor_makers(
    devices: StationDevices,
) -> Callable[[], SensorDriver] | Mapping[str, Callable[[], SensorDriver]]:
    """The factory of the sensor, or of each of several."""
    if not devices.sensors:
        return choose_sensor(choice_of(devices.tables.get("sensor")), devices.simulation)
    return {
        name: sensor_factory(table.driver, table.options) for name, table in devices.sensors.items()
    }
