"""Orders clouds of the catalogue's scans from the places that ``fleet.toml`` names."""

import logging
from collections.abc import Sequence
from pathlib import Path

from crenel.batch.places import Place, settings_for
from crenel.batch.recordings import RECORDING
from crenel.batch.results import RebuiltCloud, check_results_apart
from crenel.batch.single_cloud import CloudOrder
from crenel.errors import OperationError
from crenel.fleet.catalogue.entry import CatalogueEntry
from crenel.fleet.fleet_settings import FleetSettings, StationPlaces
from crenel.formats.clouds.files import COPC
from crenel.messages.message import Text, message
from crenel.server.fleet.clouds.kept_clouds import PLY, KeptClouds
from crenel.server.fleet.clouds.orders_file import ORDERS_FILE, KeptOrder, KeptOrders
from crenel.server.fleet.clouds.queue import CloudJob, CloudQueue
from crenel.wire.fleet import CloudFormat

log = logging.getLogger(__name__)
SUFFIXES: dict[CloudFormat, str] = {"copc": COPC, "ply": PLY}
FORMATS: dict[str, CloudFormat] = {suffix: form for form, suffix in SUFFIXES.items()}
BYTES_OF_GB = 1e9


class FleetClouds:
    """The clouds of all stations.

    Args:
        folder: in which they are kept.

    Raises:
        OperationError: the folder is within the records of a station.
    """

    def __init__(self, settings: FleetSettings, folder: Path) -> None:
        self._scheduler = settings.clouds.scheduler
        self._places = {name: _places_of(its) for name, its in settings.stations.items()}
        self.kept = KeptClouds(folder, settings.clouds.limit_gb * BYTES_OF_GB)
        self._orders = KeptOrders(folder / ORDERS_FILE)
        self.queue = CloudQueue(self.kept, lambda jobs: self._orders.write(_orders_of(jobs)))
        sources = [place.settings for its in self._places.values() for place in its]
        try:
            check_results_apart(self.kept.settings, sources)
        except OperationError as error:
            remedy = message("fleet-name-cloud-folder")
            raise OperationError(error.code, error.what, remedy=remedy) from error

    def start(self) -> None:
        """Begins to make clouds, those first that an earlier server did not make."""
        waiting = []
        for one in self._orders.read():
            if problem := self.problem_of(one.station):
                log.warning("a cloud of %s is not made: %s", one.scan_id, problem)
                continue
            order = self._order(one.station, one.scan_id, one.calibration_ids, one.format)
            waiting.append((one.station, order))
        self.queue.start(waiting)

    def problem_of(self, station: str) -> Text:
        """Why no clouds of a station can be made; empty if they can."""
        if station in self._places:
            return ""
        return message("fleet-clouds-no-place", station=station)

    def order(
        self, scan: CatalogueEntry, calibration_ids: Sequence[str], form: CloudFormat
    ) -> CloudJob:
        """Orders the cloud of a scan.

        Args:
            calibration_ids: each for its sensor; of all others, the one that it was taken with.

        Raises:
            OperationError: it cannot be made here, or too many wait.
        """
        if problem := self.problem_of(scan.station):
            raise OperationError("no-place", problem)
        wanted = tuple(sorted({*calibration_ids} - {""}))
        others = () if wanted == (scan.calibration_id,) else wanted
        return self.queue.add(scan.station, self._order(scan.station, scan.id, others, form))

    def _order(
        self, station: str, scan_id: str, calibration_ids: tuple[str, ...], form: CloudFormat
    ) -> CloudOrder:
        return CloudOrder(
            self._places[station],
            scan_id,
            calibration_ids,
            self.kept.settings,
            SUFFIXES[form],
            self.kept.scratch,
            self._scheduler,
        )

    def list_made(self, scan: CatalogueEntry) -> list[RebuiltCloud]:
        """The clouds of a scan that are there."""
        sha256 = next((file.sha256 for file in scan.files if file.path == RECORDING), "")
        return self.kept.of_recording(scan.id, sha256)


def _orders_of(jobs: Sequence[CloudJob]) -> list[KeptOrder]:
    return [
        KeptOrder(
            station=job.station,
            scan_id=job.order.scan_id,
            calibration_ids=job.order.calibration_ids,
            format=FORMATS[job.order.suffix],
        )
        for job in jobs
    ]


def _places_of(station: StationPlaces) -> tuple[Place, ...]:
    """Its own disk first: nothing is fetched from there."""
    found = []
    if station.data is not None:
        found.append(Place(settings_for(str(station.data)), False))
    if station.archive is not None:
        found.append(Place(station.archive, True))
    return tuple(found)
