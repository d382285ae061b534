"""The demonstration: the simulated station, with its datasheets in a data folder."""

import json
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path

from crenel.errors import OperationError
from crenel.formats.atomic_write import write_atomically
from crenel.formats.datasheets.arm import ArmFile
from crenel.formats.io_errors import convert_io_errors
from crenel.messages.message import join, message
from crenel.operations.device_setup import StationDevices
from crenel.operations.services import MonitoringSettings
from crenel.server.station_parts import StationParts
from crenel.settings.settings import Settings
from crenel.settings.station_toml import DEFAULT_FILE, read_settings
from crenel.station.setup.drivers import SimulatedDevices
from crenel_hardware.interfaces import SensorDriver
from crenel_hardware.registry import arm_driver
from crenel_hardware.simulator.scene.random_scenes import demo_robot
from crenel_hardware.simulator.scene.world import RoomThermometer
from crenel_hardware.simulator.station import SimulatedStation, SimulationConfig

PLACES = {
    "arm.json": "arms/simulated.json",
    "object.json": "objects/simulated.json",
    "chessboard.json": "objects/chessboard.json",
    "sensor.json": "sensors/simulated.json",
    "example-plate.json": "programs/example-plate.json",
}
"""Location of a datasheet in the data folder; those of gauges have their own folder."""


ROBOT = SimulationConfig(arm=demo_robot(), robot=True)
ROBOT_HZ = 250.0


@contextmanager
def open_simulation(data: Path, robot: bool = False, gige: bool = False) -> Iterator[StationParts]:
    """A running simulation, with a sensor that is ready, as the parts of a station.

    Args:
        robot: a robot carries the sensor, instead of an arm that an operator guides.
        gige: the sensor's camera sends its pictures over GigE Vision.

    Raises:
        OperationError: the data folder cannot be written.
        DeviceError: the port of GigE Vision is taken.
    """
    config = ROBOT if robot else SimulationConfig()
    with SimulatedStation(replace(config, camera="gige") if gige else config) as simulation:
        yield station_parts(simulation, data)


def station_parts(simulation: SimulatedStation, data: Path) -> StationParts:
    """A station with a started simulation; the real driver reads its arm or robot.

    Devices that were chosen on the Devices page are used instead of the simulation's.

    Raises:
        OperationError: the data folder cannot be written, or its station.toml is not valid.
    """
    write_datasheets(simulation, data)
    driver, options = _arm_options(simulation)
    devices = SimulatedDevices(lambda: arm_driver(driver, options), simulation.sensor)
    file = data / DEFAULT_FILE
    settings = read_settings(file) if file.exists() else Settings()
    chosen = settings.devices
    return StationParts(
        name="Demonstration",
        data=data,
        sensor=None if settings.sensors else _sensors(simulation),
        devices=StationDevices(file, chosen, devices, settings.sensors),
        simulated_operator=simulation.operator,
        guest="Demo",
        monitoring=MonitoringSettings(
            thermometer=RoomThermometer(),
            effective_settings={
                "drivers": {"arm": driver, "sensor": _sensor_driver_name(simulation)}
                | {kind: table.driver for kind, table in chosen.items()}
            },
        ),
    )


def _sensors(simulation: SimulatedStation) -> Mapping[str, Callable[[], SensorDriver]] | None:
    """Both sensors of a simulation with two; None of the only one."""
    if not simulation.config.second_sensor:
        return None
    return {"left": simulation.sensor, "right": simulation.second_sensor}


def _arm_options(simulation: SimulatedStation) -> tuple[str, dict[str, object]]:
    """Name and options of the driver of the simulated arm."""
    if simulation.config.robot:
        robot = simulation.robot
        options = {"address": simulation.config.host, "port": robot.port, "rate_hz": ROBOT_HZ}
        return "ur-rtde", options
    return "serial-encoder", {"url": simulation.arm_url}


def _sensor_driver_name(simulation: SimulatedStation) -> str:
    return "genicam" if simulation.config.camera == "gige" else "simulated"


def _is_identified(path: Path) -> bool:
    """Whether a file contains an identified arm."""
    try:
        return ArmFile.read(path).identification is not None
    except OperationError:
        return False


def write_datasheets(simulation: SimulatedStation, data: Path) -> None:
    """Writes the files that come with the devices into the data folder."""
    for name, datasheet in simulation.datasheets().items():
        content = (json.dumps(datasheet, indent=1) + "\n").encode()
        target = data / PLACES.get(name, f"gauges/{name}")
        with _explain_data_folder(data), convert_io_errors(target.parent):
            if name == "arm.json" and _is_identified(target):
                continue  # it is known better than by its datasheet
            target.parent.mkdir(parents=True, exist_ok=True)
            write_atomically(target, content)


@contextmanager
def _explain_data_folder(data: Path) -> Iterator[None]:
    """Names the option for another folder, if that is the remedy."""
    try:
        yield
    except OperationError as error:
        if error.code in ("disk-full", "output-not-a-file"):
            raise
        raise OperationError(
            "data-folder-unwritable",
            message("data-folder-cannot-be-used", folder=data),
            join([error.what, error.why], ": "),
            message("give-folder-user-may-write-data"),
        ) from error
