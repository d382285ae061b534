"""The routes of the fleet's server; it only reads, and answers in JSON."""

import asyncio
import hmac
from base64 import b64decode
from collections.abc import AsyncIterator, Mapping
from contextlib import asynccontextmanager
from dataclasses import asdict
from datetime import datetime
from typing import Annotated

from fastapi import FastAPI, Query, Request
from pydantic import TypeAdapter
from starlette.middleware.base import RequestResponseEndpoint
from starlette.responses import Response

from app.api import problems
from app.api.problems import NotFoundError
from app.api.static_files import file_response, page_response
from app.fleet.catalogue.entry import ENTRY_KINDS, CatalogueEntry
from app.fleet.catalogue.reading import (
    SearchQuery,
    list_newest_calibrations,
    quantities,
    read_record,
    search,
    summarise_stations,
)
from app.fleet.questions import drift_of, find_affected
from app.formats.json_document import SOFTWARE
from app.messages.message import message
from app.server.fleet.service import FleetService
from app.wire.json_response import json_response

ENTRY = TypeAdapter(CatalogueEntry)
PAGE = "fleet.html"
MOST = 50
NO_ACCESS = {"WWW-Authenticate": 'Basic realm="Crenel fleet", charset="UTF-8"'}


def build_fleet_app(service: FleetService, password: str = "") -> FastAPI:
    """The application; it collects and listens from its start to its end.

    Args:
        password: required of every request if not empty, by HTTP Basic with any user name.
    """

    @asynccontextmanager
    async def lifespan(app: FastAPI) -> AsyncIterator[None]:
        service.start()
        try:
            yield
        finally:
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
    _add_routes(app, service)

    @app.middleware("http")
    async def check(request: Request, call_next: RequestResponseEndpoint) -> Response:
        if password and not _is_allowed(request.headers.get("authorization", ""), password):
            return Response("The password is missing or wrong.", 401, NO_ACCESS)
        return await call_next(request)

    return app


def _add_routes(app: FastAPI, service: FleetService) -> None:
    @app.get("/api/fleet/overview")
    def overview() -> Response:
        with service.catalogue().reading() as connection:
            stations = [asdict(one) for one in summarise_stations(connection)]
            known = quantities(connection)
        catalogue = service.catalogue()
        return json_response(
            {
                "place": catalogue.place,
                "stations": stations,
                "kinds": ENTRY_KINDS,
                "quantities": known,
                "problem": service.problem,
                "looks_every_s": service.looks_every_s,
            }
        )

    @app.get("/api/fleet/stations")
    async def stations() -> Response:
        broker = service.broker
        found = [one.model_dump(mode="json") for one in service.remote_stations()]
        return json_response(
            {"broker": broker is not None and broker.state.connected, "stations": found}
        )

    @app.get("/api/fleet/records")
    def records(
        text: Annotated[str, Query(max_length=200)] = "",
        station: Annotated[str, Query(max_length=40)] = "",
        kind: Annotated[str, Query(max_length=40)] = "",
        since: datetime | None = None,
        until: datetime | None = None,
        before: datetime | None = None,
        before_key: int = 0,
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
        listed = [{"key": one.key, **_entry_fields(one.entry)} for one in found[:MOST]]
        return json_response({"records": listed, "more": len(found) > MOST})

    @app.get("/api/fleet/records/{station}/{kind}/{record_id}")
    def record(station: str, kind: str, record_id: str) -> Response:
        with service.catalogue().reading() as connection:
            found = read_record(connection, station, kind, record_id)
        if found is None:
            raise NotFoundError(message("fleet-no-record", id=record_id))
        return json_response(_entry_fields(found))

    @app.get("/api/fleet/drift/{quantity}")
    def drift(quantity: str, station: Annotated[list[str], Query()] = []) -> Response:  # noqa: B006
        with service.catalogue().reading() as connection:
            found = drift_of(connection, quantity, station)
            periods = [one for its in found for one in find_affected(connection, its)]
        return json_response(
            {
                "quantity": quantity,
                "stations": [asdict(one) for one in found],
                "periods": [asdict(one) for one in periods],
            }
        )

    @app.get("/api/fleet/calibrations")
    def calibrations() -> Response:
        with service.catalogue().reading() as connection:
            found = list_newest_calibrations(connection)
        return json_response({"calibrations": [_entry_fields(one) for one in found]})

    @app.get("/{path:path}")
    async def page(path: str) -> Response:
        found = await asyncio.to_thread(file_response, path)
        if found is None and (path.startswith("api/") or "." in path):
            raise NotFoundError(message("there-nothing", path=f"/{path}"))
        return found or page_response(PAGE)


def _entry_fields(entry: CatalogueEntry) -> Mapping[str, object]:
    fields: dict[str, object] = ENTRY.dump_python(entry, mode="json")
    return {**fields, "size_bytes": entry.size_bytes}


def _is_allowed(header: str, password: str) -> bool:
    scheme, _, encoded = header.partition(" ")
    if scheme.lower() != "basic":
        return False
    try:
        given = b64decode(encoded, validate=True).partition(b":")[2]
    except ValueError:
        return False
    return hmac.compare_digest(given, password.encode())
