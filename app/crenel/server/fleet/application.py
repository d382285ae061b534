"""The routes of the fleet's server; it only reads from stations, and answers in JSON."""

import asyncio
from collections.abc import AsyncIterator, Sequence
from contextlib import asynccontextmanager, suppress
from datetime import UTC, datetime
from typing import Annotated

from fastapi import FastAPI, Query, Request
from pydantic import AfterValidator
from starlette.responses import RedirectResponse, Response

from crenel.api.access.sub_path import page_base, sub_path_of
from crenel.api.answers import problems
from crenel.api.answers.problems import NotFoundError
from crenel.api.static_files import file_response, page_response
from crenel.fleet.ageing import ageing_of, spread_of
from crenel.fleet.calibration_doubts import find_calibration_doubts
from crenel.fleet.catalogue.entry import ENTRY_KINDS
from crenel.fleet.catalogue.quantities import CALIBRATION_TITLES, title_of
from crenel.fleet.catalogue.reading import (
    FoundRecord,
    SearchQuery,
    list_newest_calibrations,
    quantities,
    read_record,
    search,
    summarise_stations,
)
from crenel.fleet.fleet_settings import DEFAULT_FILE
from crenel.fleet.questions import drift_of, find_affected, find_doubted
from crenel.formats.json_document import SOFTWARE
from crenel.loops import naming_hangs, reporting_deaths
from crenel.messages.message import message
from crenel.metrology.change_points import LEAST_VALUES
from crenel.server.fleet.access import FleetAccess
from crenel.server.fleet.clouds.routes import cloud_router
from crenel.server.fleet.clouds.service import FleetClouds
from crenel.server.fleet.service import FleetService
from crenel.server.fleet.sign_in import PASSWORD_PAGE, AccessCheck, sign_in_router
from crenel.server.middleware import Guard
from crenel.wire.fleet import (
    CalibrationsInUse,
    FleetAgeing,
    FleetCalibrationDoubt,
    FleetCalibrationDoubts,
    FleetCalibrationSpread,
    FleetOverview,
    FleetRecord,
    FleetSpread,
    FleetStation,
    FleetStationAgeing,
    FoundFleetRecord,
    NamedQuantity,
    RecordsPage,
    StationsOnBroker,
)
from crenel.wire.fleet_drift import (
    DriftDoubtedRecordings,
    DriftingStation,
    DriftPeriod,
    FleetDrift,
)
from crenel.wire.json_response import json_response

PAGE = "fleet.html"
MOST = 50
MOST_KEYS = 2**53


def _check_date(moment: datetime) -> datetime:
    try:
        return moment.astimezone(UTC)
    except (OverflowError, ValueError) as error:
        raise ValueError(message("value-must-be-date")) from error


QueryMoment = Annotated[datetime, AfterValidator(_check_date)]
"""A moment that has a date in UTC, too."""


def build_fleet_app(
    service: FleetService, clouds: FleetClouds, access: FleetAccess, hosts: Sequence[str] = ()
) -> FastAPI:
    """The application; it collects, listens and makes clouds from its start to its end.

    Args:
        hosts: additional names by which browsers may reach it.
    """

    @asynccontextmanager
    async def lifespan(app: FastAPI) -> AsyncIterator[None]:
        with reporting_deaths(), naming_hangs():
            service.start()
            clouds.start()
            watching = None
            if access.people is not None:
                watching = asyncio.create_task(access.people.watch_provider())
            try:
                yield
            finally:
                if watching is not None and access.people is not None:
                    watching.cancel()
                    with suppress(asyncio.CancelledError):
                        await watching
                    access.people.close()
                await asyncio.to_thread(clouds.queue.close)
                await service.close()

    app = FastAPI(
        title="Crenel fleet",
        version=SOFTWARE.version,
        lifespan=lifespan,
        docs_url=None,
        redoc_url=None,
        openapi_url=None,
    )
    problems.install(app)
    app.include_router(sign_in_router(access))
    _add_lists(app, service)
    _add_questions(app, service)
    app.include_router(cloud_router(service, clouds, access))
    _add_pages(app)

    app.add_middleware(AccessCheck, access=access)
    app.add_middleware(Guard, hosts=hosts, file=DEFAULT_FILE)
    return app


def _add_lists(app: FastAPI, service: FleetService) -> None:
    @app.get("/api/fleet/overview")
    def overview() -> Response:
        catalogue = service.catalogue()
        with catalogue.reading() as connection:
            stations = summarise_stations(connection)
            known = quantities(connection)
        answer = FleetOverview(
            place=catalogue.place,
            stations=[FleetStation.model_validate(one) for one in stations],
            kinds=list(ENTRY_KINDS),
            quantities=[
                NamedQuantity(
                    id=one,
                    title=title_of(one),
                    unit=unit,
                    of_calibrations=one in CALIBRATION_TITLES,
                )
                for one, unit in known.items()
            ],
            problem=service.problem,
            looks_every_s=service.looks_every_s,
        )
        return json_response(answer)

    @app.get("/api/fleet/stations")
    async def stations() -> Response:
        connected = service.broker.state.connected if service.broker is not None else None
        answer = StationsOnBroker(broker=connected, stations=list(service.remote_stations()))
        return json_response(answer)

    @app.get("/api/fleet/records")
    def records(
        text: Annotated[str, Query(max_length=200)] = "",
        station: Annotated[str, Query(max_length=40)] = "",
        kind: Annotated[str, Query(max_length=40)] = "",
        since: QueryMoment | None = None,
        until: QueryMoment | None = None,
        before: QueryMoment | None = None,
        before_key: Annotated[int, Query(ge=0, le=MOST_KEYS)] = 0,
    ) -> Response:
        query = SearchQuery(
            text=text,
            station=station,
            kind=kind,
            since=since,
            until=until,
            limit=MOST + 1,
            before=None if before is None else (before, before_key),
        )
        with service.catalogue().reading() as connection:
            found = search(connection, query)
        listed = [_record_of(one) for one in found[:MOST]]
        return json_response(RecordsPage(records=listed, more=len(found) > MOST))

    @app.get("/api/fleet/records/{station}/{kind}/{record_id}")
    def record(station: str, kind: str, record_id: str) -> Response:
        with service.catalogue().reading() as connection:
            found = read_record(connection, station, kind, record_id)
        if found is None:
            raise NotFoundError(message("fleet-no-record", id=record_id))
        return json_response(FleetRecord.model_validate(found))


def _add_questions(app: FastAPI, service: FleetService) -> None:
    @app.get("/api/fleet/drift/{quantity}")
    def drift(
        quantity: str,
        station: Annotated[list[str], Query()] = [],  # noqa: B006
        right_since: QueryMoment | None = None,
    ) -> Response:
        with service.catalogue().reading() as connection:
            found = drift_of(connection, quantity, station, right_since=right_since)
            periods = [one for its in found for one in find_affected(connection, its)]
            doubted = [one for its in found for one in find_doubted(connection, its)]
        answer = FleetDrift(
            quantity=quantity,
            least_values=LEAST_VALUES,
            stations=[DriftingStation.model_validate(one) for one in found],
            periods=[DriftPeriod.model_validate(one) for one in periods],
            doubted=[DriftDoubtedRecordings.model_validate(one) for one in doubted],
        )
        return json_response(answer)

    @app.get("/api/fleet/calibrations")
    def calibrations() -> Response:
        with service.catalogue().reading() as connection:
            found = list_newest_calibrations(connection)
        answer = CalibrationsInUse(calibrations=[FleetRecord.model_validate(one) for one in found])
        return json_response(answer)

    @app.get("/api/fleet/calibrations/{station}/doubts")
    def doubts(station: str) -> Response:
        with service.catalogue().reading() as connection:
            found = find_calibration_doubts(connection, station)
        answer = FleetCalibrationDoubts(
            doubts=[FleetCalibrationDoubt.model_validate(one) for one in found]
        )
        return json_response(answer)

    @app.get("/api/fleet/spread/{quantity}")
    def spread(quantity: str, station: Annotated[list[str], Query()] = []) -> Response:  # noqa: B006
        with service.catalogue().reading() as connection:
            found = spread_of(connection, quantity, station)
        spreads = [FleetCalibrationSpread.model_validate(one) for one in found]
        return json_response(FleetSpread(quantity=quantity, spreads=spreads))

    @app.get("/api/fleet/ageing/{quantity}")
    def ageing(quantity: str, station: Annotated[list[str], Query()] = []) -> Response:  # noqa: B006
        with service.catalogue().reading() as connection:
            found = ageing_of(connection, quantity, station)
        stations = [FleetStationAgeing.model_validate(one) for one in found]
        return json_response(FleetAgeing(quantity=quantity, stations=stations))


def _add_pages(app: FastAPI) -> None:
    @app.get(PASSWORD_PAGE)
    def after_password(request: Request) -> Response:
        return RedirectResponse(f"{sub_path_of(request.scope)}/", 303)

    @app.get("/{path:path}")
    async def page(path: str, request: Request) -> Response:
        accepts = request.headers.get("accept-encoding", "")
        found = await asyncio.to_thread(file_response, path, accepts)
        if found is None and (path.startswith("api/") or "." in path):
            raise NotFoundError(message("there-nothing", path=f"/{path}"))
        return found or page_response(PAGE, page_base(request.scope))


def _record_of(found: FoundRecord) -> FoundFleetRecord:
    record = FleetRecord.model_validate(found.entry).model_dump()
    return FoundFleetRecord(**{**record, "size_bytes": found.size_bytes, "key": found.key})
