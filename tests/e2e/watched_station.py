"""A simulated station on a broker, with nature's own calibration in use; takes folder and port."""

import sys
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

from crenel.server.demo import station_parts
from crenel.server.listener import listen
from crenel.server.startup import Plan, run
from crenel.store.store import Store
from crenel.supervision.broker_settings import BrokerSettings
from crenel_hardware.simulator.station import SimulatedStation
from tests.api.calibrated import use_truth


def serve(data: Path, broker_port: int) -> None:
    listening = listen("127.0.0.1", 0, 1)
    with SimulatedStation() as simulation:
        parts = station_parts(simulation, data)
        store = Store(data)
        guide = SimpleNamespace(_on_closed=lambda: None)
        context = SimpleNamespace(store=store, guide=guide)
        use_truth(SimpleNamespace(simulation=simulation, data=data, context=context), "truth")
        store.close()
        watching = replace(
            parts.monitoring, mqtt=BrokerSettings(host="127.0.0.1", port=broker_port)
        )
        parts = replace(parts, monitoring=watching)
        run(Plan("Watched", lambda: parts, "127.0.0.1", by_link=True), listening, False)


if __name__ == "__main__":
    serve(Path(sys.argv[1]), int(sys.argv[2]))
