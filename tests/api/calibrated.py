"""A calibration in use that did not have to be made: the simulation's true values."""

from typing import Any

from app.bench.faults.served import accept_truth


def use_truth(server: Any, name: str) -> str:
    """Accepts a true calibration of the server's simulation under this session's name.

    ``server`` has the simulation, the data folder and the context of one.
    """
    accept_truth(server.context.store, server.simulation, name)
    server.context.guide._on_closed()  # the station works with it from now on
    return name
