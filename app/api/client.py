"""The operator's client: the files that the build left in ``app/static``."""

from pathlib import Path

from fastapi import APIRouter, FastAPI, Request
from starlette.exceptions import HTTPException
from starlette.responses import FileResponse, HTMLResponse, Response

router = APIRouter(include_in_schema=False)
STATIC = Path(__file__).resolve().parents[1] / "static"
FOREVER = "public, max-age=31536000, immutable"
NOT_BUILT = """<!doctype html>
<html lang="en"><head><meta charset="utf-8"><title>Crenel</title>
<style>body{font:16px/1.5 system-ui,sans-serif;max-width:40rem;margin:15vh auto;padding:0 1rem}
</style></head><body><h1>The client is not built</h1>
<p>The station runs, and its interface answers under <code>/api</code>, but the pages of the
operator's client were not built into this copy of the program.</p>
<p>Install the program with <code>pip install .</code>, which builds them, or build them in
the source tree: <code>npm ci &amp;&amp; npm run build</code> in <code>frontend</code>.</p>
</body></html>
"""


@router.get("/api/openapi.json")
def openapi(request: Request) -> dict[str, object]:
    """What the interface takes and gives, for programs."""
    app: FastAPI = request.app
    return app.openapi()


@router.api_route("/api/{path:path}", methods=["GET", "POST", "PUT", "PATCH", "DELETE"])
def no_such_interface(path: str) -> Response:
    raise HTTPException(404)


@router.api_route("/{path:path}", methods=["GET", "HEAD"])
def client(path: str, request: Request) -> Response:
    """A built file, or the page itself, which finds its own way by the address."""
    index = STATIC / "index.html"
    if not index.is_file():
        return HTMLResponse(NOT_BUILT, 503)
    file = (STATIC / path).resolve()
    if path and file.is_file() and file.is_relative_to(STATIC):
        # names under assets carry a hash of their content
        hashed = file.is_relative_to(STATIC / "assets")
        return FileResponse(file, headers={"Cache-Control": FOREVER if hashed else "no-cache"})
    if path.startswith("assets/") or "." in path.rsplit("/", 1)[-1]:
        raise HTTPException(404)
    return FileResponse(index, headers={"Cache-Control": "no-cache"})
