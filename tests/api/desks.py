"""Desks of guides beside the calibration's, and the station of a next server."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TypeVar

from crenel.station.bus import Bus
from crenel.station.devices.rig import Rig
from crenel.station.scan.scanner import Scanner
from crenel.station.view3d.scene import Scene
from crenel.store.store import Store
from tests.api.conftest import Desk, Server


class GuideDesk(Desk):
    def __init__(self, server: Server) -> None:
        self.server, self.http = server, server.http


GuideDeskT = TypeVar("GuideDeskT", bound=GuideDesk)


@contextmanager
def left_in_order(desk: GuideDeskT) -> Iterator[GuideDeskT]:
    yield desk
    desk.http.post("/api/stop").raise_for_status()
    desk.close()


@contextmanager
def next_station(server: Server, left: Path) -> Iterator[tuple[Store, Bus, Rig, Scanner, Scene]]:
    """Parts of a next server's station, on what a killed one left on the disk."""
    store, bus = Store(left), Bus()
    rig, scene = Rig(bus, server.simulation.sensor, server.simulation.sensor, left), Scene()  # type: ignore[arg-type]
    scanner = Scanner(bus, rig, scene, left / "scans")
    try:
        yield store, bus, rig, scanner, scene
    finally:
        scanner.close()
        scene.close()
        store.close()
