"""The operator's client: the files that the build left in ``app/static``."""

from fastapi import APIRouter, FastAPI, Request
from starlette.exceptions import HTTPException
from starlette.responses import Response

from app.api.files.static_files import file_response, names_a_file, page_response

router = APIRouter(include_in_schema=False)


@router.get("/api/openapi.json")
def openapi(request: Request) -> dict[str, object]:
    """What the interface takes and gives, for programs."""
    app: FastAPI = request.app
    return app.openapi()


@router.api_route("/api/{path:path}", methods=["GET", "POST", "PUT", "PATCH", "DELETE"])
def no_such_interface(path: str) -> Response:
    raise HTTPException(404)


@router.api_route("/{path:path}", methods=["GET", "HEAD"])
def client(path: str) -> Response:
    """A built file, or the page itself, which finds its own way by the address."""
    found = file_response(path)
    if found is None and names_a_file(path):
        raise HTTPException(404)
    return found or page_response("index.html")
