"""Stations that are opened on a data folder, without their devices."""

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from types import SimpleNamespace

from crenel.operations.context import Context
from crenel.server.composition import close_context, open_context
from crenel.server.demo import station_parts
from crenel.server.station_parts import StationParts
from crenel_hardware.simulator.station import SimulatedStation
from tests.api.calibrated import use_truth


@dataclass(frozen=True)
class Station:
    """A simulated station, which can be opened on its data folder again and again."""

    simulation: SimulatedStation
    data: Path

    @property
    def parts(self) -> StationParts:
        return replace(station_parts(self.simulation, self.data), simulated_operator=None)

    @contextmanager
    def opened(self, calibrated: bool = False) -> Iterator[Context]:
        """``calibrated``: with a true calibration in use."""
        context = open_context(self.parts)
        try:
            if calibrated:
                use_truth(SimpleNamespace(simulation=self.simulation, context=context), "true")
            yield context
        finally:
            closed(context)


def closed(context: Context) -> None:
    close_context(context)
    context.store.close()
    context.monitoring.close()
