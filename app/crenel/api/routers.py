"""All routers of the application, in the order in which a path is looked for.

The last one answers what no other does: with the client's built files, or its page.
"""

from fastapi import FastAPI, Request
from starlette.exceptions import HTTPException
from starlette.responses import Response

from crenel.api import calibrations, devices, live, reports, scan, scene, settings
from crenel.api.access import accounts, auth, provider, tokens
from crenel.api.access.authorization import StationRouter
from crenel.api.access.sub_path import page_base
from crenel.api.datasheets import block_certificates, designs, documents
from crenel.api.library import opened_record, scans
from crenel.api.monitoring import health, metrics, notifications
from crenel.api.sessions import arm, calibration
from crenel.api.static_files import file_response, names_a_file, page_response
from crenel.api.viewer import proxy
from crenel.gauges.exchange.routes import router as gauge_exports
from crenel.gauges.quick.routes import router as verification
from crenel.gauges.routes import router as gauge_tests
from crenel.parts.compare.routes import router as part_comparison
from crenel.parts.routes import router as parts

client = StationRouter(include_in_schema=False)


@client.get("/api/openapi.json")
def openapi(request: Request) -> dict[str, object]:
    """What the interface takes and gives, for programs."""
    app: FastAPI = request.app
    return app.openapi()


@client.api_route("/api/{path:path}", methods=["GET", "POST", "PUT", "PATCH", "DELETE"])
def no_such_interface(path: str) -> Response:
    raise HTTPException(404)


@client.api_route("/{path:path}", methods=["GET", "HEAD"])
def client_file(path: str, request: Request) -> Response:
    """A built file, or the page itself, which finds its own way by the address."""
    found = file_response(path, request.headers.get("accept-encoding", ""))
    if found is None and names_a_file(path):
        raise HTTPException(404)
    return found or page_response("index.html", page_base(request.scope))


ROUTERS: tuple[StationRouter, ...] = (
    auth.router,
    provider.router,
    accounts.router,
    tokens.router,
    calibration.router,
    arm.router,
    verification,
    gauge_tests,
    gauge_exports,
    parts,
    calibrations.router,
    scan.router,
    settings.router,
    devices.router,
    documents.router,
    designs.router,
    block_certificates.router,
    scans.router,
    opened_record.router,
    part_comparison,
    reports.router,
    health.router,
    notifications.router,
    metrics.router,
    scene.router,
    live.router,
    proxy.router,
    client,
)

ROUTES = [route for router in ROUTERS for route in router.routes]
