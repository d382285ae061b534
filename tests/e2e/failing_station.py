"""A simulated station whose camera goes, or comes back, with each SIGUSR1; takes the folder.

Its laser is switched at the sensor, not from here, as with a plain GigE camera.
"""

import signal
import sys
from pathlib import Path

from crenel.server.demo import station_parts
from crenel.server.listener import listen
from crenel.server.startup import Plan, run
from crenel_hardware.simulator.station import SimulatedStation, SimulationConfig


def serve(data: Path) -> None:
    listening = listen("127.0.0.1", 0, 1)
    with SimulatedStation(SimulationConfig(laser_switch=False)) as simulation:

        def turn(*_: object) -> None:
            simulation.camera_faults.lost = not simulation.camera_faults.lost

        signal.signal(signal.SIGUSR1, turn)
        parts = station_parts(simulation, data)
        run(Plan("Failing", lambda: parts, "127.0.0.1", by_link=True), listening, False)


if __name__ == "__main__":
    serve(Path(sys.argv[1]))
