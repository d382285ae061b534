"""The routes of the clouds that are made on demand."""

from http import HTTPStatus

from fastapi import APIRouter, Depends
from sqlalchemy import Connection
from starlette.responses import FileResponse, Response

from crenel.api.answers.problems import NotFoundError
from crenel.batch.results import RebuiltCloud
from crenel.errors import sentence
from crenel.fleet.catalogue.entry import CatalogueEntry
from crenel.fleet.catalogue.reading import SearchQuery, read_record, search
from crenel.formats.json_document import SOFTWARE
from crenel.messages.message import message
from crenel.server.fleet.access import FleetAccess
from crenel.server.fleet.clouds.queue import CloudJob
from crenel.server.fleet.clouds.service import FORMATS, FleetClouds
from crenel.server.fleet.service import FleetService
from crenel.wire.fleet import CalibrationChoice, CloudOrderState, CloudWish, MadeCloud, ScanClouds
from crenel.wire.json_response import json_response

MOST_CALIBRATIONS = 200
"""How many calibrations of a station are offered: the newest."""


def cloud_router(service: FleetService, clouds: FleetClouds, access: FleetAccess) -> APIRouter:
    """The routes; who may only view may fetch what is there."""
    router = APIRouter(prefix="/api/fleet")
    acting = [Depends(access.check_may_act)]

    @router.get("/records/{station}/scan/{scan_id}/clouds")
    def list_clouds(station: str, scan_id: str) -> Response:
        with service.catalogue().reading() as connection:
            scan = _read_scan(connection, station, scan_id)
            calibrations = _find_calibrations(connection, scan)
        answer = ScanClouds(
            problem=sentence(clouds.problem_of(station)),
            software=SOFTWARE.version,
            used_calibration_id=scan.calibration_id,
            calibrations=calibrations,
            made=[_describe(one) for one in clouds.list_made(scan)],
            orders=[_state_of(one) for one in clouds.queue.jobs_of(station, scan_id)],
        )
        return json_response(answer)

    @router.post("/records/{station}/scan/{scan_id}/clouds", dependencies=acting)
    def order(station: str, scan_id: str, wish: CloudWish) -> Response:
        with service.catalogue().reading() as connection:
            scan = _read_scan(connection, station, scan_id)
            wanted = {wish.calibration_id, *wish.calibration_ids}
            for calibration_id in sorted(wanted - {"", scan.calibration_id}):
                _check_calibration(connection, station, calibration_id)
        return json_response(_state_of(clouds.order(scan, list(wanted), wish.format)))

    @router.delete("/cloud-orders/{order_id}", dependencies=acting)
    def cancel(order_id: int) -> Response:
        clouds.queue.cancel(order_id)
        return Response(status_code=HTTPStatus.NO_CONTENT)

    @router.get("/clouds/{name}")
    def fetch(name: str) -> Response:
        found = clouds.kept.fetch(name)
        if found is None:
            raise NotFoundError(message("fleet-no-cloud", name=name))
        return FileResponse(found, media_type="application/octet-stream", filename=name)

    return router


def _read_scan(connection: Connection, station: str, scan_id: str) -> CatalogueEntry:
    scan = read_record(connection, station, "scan", scan_id)
    if scan is None:
        raise NotFoundError(message("fleet-no-record", id=scan_id))
    return scan


def _check_calibration(connection: Connection, station: str, calibration_id: str) -> None:
    """Raises ``NotFoundError`` if the catalogue has no such calibration of the station."""
    if read_record(connection, station, "calibration", calibration_id) is None:
        raise NotFoundError(message("fleet-no-record", id=calibration_id))


def _find_calibrations(connection: Connection, scan: CatalogueEntry) -> list[CalibrationChoice]:
    """Those of the arm and the sensor of a scan, where these are known."""
    query = SearchQuery(station=scan.station, kind="calibration", limit=MOST_CALIBRATIONS)
    found = [
        _describe_choice(one.entry)
        for one in search(connection, query)
        if one.entry.id == scan.calibration_id or _is_of_devices(one.entry, scan)
    ]
    if all(one.id != scan.calibration_id for one in found):
        used = read_record(connection, scan.station, "calibration", scan.calibration_id)
        unknown = CalibrationChoice(id=scan.calibration_id, label="", sensor_serial="", at=None)
        found.append(unknown if used is None else _describe_choice(used))
    return found


def _describe_choice(calibration: CatalogueEntry) -> CalibrationChoice:
    return CalibrationChoice(
        id=calibration.id,
        label=calibration.label,
        sensor_serial=calibration.sensor_serial,
        at=calibration.at,
    )


def _is_of_devices(calibration: CatalogueEntry, scan: CatalogueEntry) -> bool:
    pairs = (
        (calibration.arm_serial, scan.arm_serial),
        (calibration.sensor_serial, scan.sensor_serial),
    )
    return all(own == other or not own or not other for own, other in pairs)


def _describe(document: RebuiltCloud) -> MadeCloud:
    return MadeCloud(
        name=document.cloud,
        calibration_ids=[one.id for one in document.calibrations],
        software=document.software.version,
        points=document.points,
        size_bytes=document.cloud_bytes,
        warnings=list(document.warnings),
    )


def _state_of(job: CloudJob) -> CloudOrderState:
    return CloudOrderState(
        id=job.id,
        calibration_ids=list(job.order.calibration_ids),
        format=FORMATS[job.order.suffix],
        state=job.state,
        share=job.share,
        note=job.note,
        problem=job.problem,
    )
