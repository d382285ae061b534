"""A calibration in use that did not have to be made: the simulation's true values."""

from typing import Any

from tests.bench.faults.served import accept_truth


def use_truth(server: Any, name: str) -> str:
    """Accepts a true calibration of the simulation, for ``server`` or what has its parts, by this
    name."""
    accept_truth(server.context.store, server.simulation, name)
    server.context.guide._on_closed()  # the station works with it from now on
    return name
