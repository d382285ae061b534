"""The simulated station as a process, begun again after each fault: ``python -m`` this, a folder.

Its simulated operator is eight times as quick as the demonstration's; its console says the same.
"""

import json
from contextlib import ExitStack
from dataclasses import replace
from pathlib import Path
from typing import Annotated, Any

import numpy as np
import typer

from crenel.console import report_errors
from crenel.server.demo import ROBOT, station_parts, write_datasheets
from crenel.server.listener import listen
from crenel.server.startup import Plan, run
from crenel.server.station_parts import StationParts
from crenel.settings.settings import Settings
from crenel.settings.station_toml import DEFAULT_FILE, read_settings
from crenel.store.store import Store
from crenel_hardware.simulator.station import (
    SECOND_SERIAL_NUMBER,
    SENSOR_SERIAL_NUMBER,
    SimulatedStation,
    SimulationConfig,
)

CONFIG = SimulationConfig(pace=8.0)
HALF = replace(CONFIG, width_px=640, height_px=512, frames_hz=8.0, rate_hz=250.0)
"""Drawn four times as fast, a third as often, with a quarter of the readings; enough for points and
scans, and for calibrations if need be."""
HALF_SIZE = ("--width", str(HALF.width_px))
"""The options of the command for it."""
SMALL = SimulationConfig(width_px=320, height_px=256, frames_hz=10.0, rate_hz=250.0)
"""Costs so little that several stations share a machine."""
HOST = "127.0.0.1"


def true_calibration(simulation: SimulatedStation, second: bool = False) -> dict[str, Any]:
    """The calibration of a simulated sensor as a solve without any error would have it."""
    truth: dict[str, Any] = json.loads(json.dumps(simulation.truth()))
    T_cam_sensor = np.array(truth["camera"]["T_cam_sensor"])
    matrix = np.array(truth["camera"]["matrix"])
    return {
        "format": "crenel/calibration",
        "version": 1,
        "camera": {
            "projection_matrix": (matrix @ T_cam_sensor[:3]).tolist(),
            "matrix": matrix.tolist(),
            "rotation": T_cam_sensor[:3, :3].tolist(),
            "translation_mm": T_cam_sensor[:3, 3].tolist(),
            "distortion": truth["camera"]["distortion"],
            "width_px": simulation.config.width_px,
            "height_px": simulation.config.height_px,
        },
        "laser_plane": truth["laser_plane"],
        "probe_matrix": truth["T_flange_second_sensor" if second else "T_flange_sensor"],
        "stripe_axis": "u",
        "serial_numbers": {"arm": "", "object": "TWIN-B1", "sensor": _serial(second)},
        "uncertainty": {"total_um": 30.0, "budget": [], "depth_range_mm": [60.0, 240.0]},
    }


def _serial(second: bool) -> str:
    return SECOND_SERIAL_NUMBER if second else SENSOR_SERIAL_NUMBER


def accept_truth(
    store: Store, simulation: SimulatedStation, name: str, sensor: str = "", second: bool = False
) -> None:
    """Puts the true calibration in use, as a session of this name would have.

    Args:
        sensor: its name at a station with several; ``second``: which one it is in the simulation.
    """
    folder = store.folder / "sessions" / name
    folder.mkdir(parents=True)
    file = folder / "calibration.json"
    file.write_text(json.dumps(true_calibration(simulation, second)))
    (folder / "arm.json").write_text(json.dumps(simulation.datasheets()["arm.json"]))
    figures = {
        "total_um": 30.0,
        "verdict": "good",
        "arm_serial": "",
        "object_serial": "TWIN-B1",
        "sensor_serial": _serial(second),
    }
    store.journal.begin_session(name, "calibration")
    store.calibrations.accept(name, f"True {name}", file, figures, None, sensor=sensor)


def prepare(data: Path, config: SimulationConfig = CONFIG) -> None:
    """Makes a data folder of a station whose sensor is calibrated."""
    with SimulatedStation(config) as simulation:
        write_datasheets(simulation, data)
        store = Store(data)
        try:
            accept_truth(store, simulation, "truth")
        finally:
            store.close()


def _read_settings(data: Path) -> Settings:
    """Those of the data folder's station.toml."""
    file = data / DEFAULT_FILE
    return read_settings(file) if file.exists() else Settings()


def _parts_with_settings(
    simulation: SimulatedStation, data: Path, settings: Settings
) -> StationParts:
    """The parts of the demonstration, with archive and broker of the settings."""
    parts = station_parts(simulation, data)
    monitoring = replace(parts.monitoring, archive=settings.archive, mqtt=settings.mqtt)
    return replace(parts, monitoring=monitoring)


@report_errors
def serve(
    data: Path,
    robot: Annotated[bool, typer.Option("--robot", help="A robot carries the sensor.")] = False,
    small: Annotated[bool, typer.Option("--small", help="Few and small pictures.")] = False,
    width_px: Annotated[int, typer.Option("--width", help="Of the pictures, in px.")] = 1280,
) -> None:
    """Until SIGINT or SIGTERM."""
    alike = CONFIG if width_px >= CONFIG.width_px else HALF
    sized = replace(alike, width_px=width_px, height_px=width_px * 4 // 5)
    config = SMALL if small else sized
    if robot:
        config = replace(config, arm=ROBOT.arm, robot=ROBOT.robot)
    settings = _read_settings(data)
    with ExitStack() as devices:

        def parts() -> StationParts:
            simulation = devices.enter_context(SimulatedStation(config))
            return _parts_with_settings(simulation, data, settings)

        plan = Plan("Bench", parts, HOST, by_link=True, serving=settings.station)
        run(plan, listen(HOST, 0, 1), open_browser=False)


if __name__ == "__main__":
    typer.run(serve)
