"""An error as RFC 9457 problem+json; light, for what answers before the station is loaded."""

from http import HTTPStatus

from starlette.responses import Response

from app.wire.encoding import encode_json


def problem(
    status: int, code: str, detail: str, remedy: str = "", view: object | None = None
) -> Response:
    """The response of an error; its fields are those of ``schema.Problem``."""
    body = {
        "type": "about:blank",
        "title": HTTPStatus(status).phrase,
        "status": status,
        "detail": detail,
        "code": code,
        "remedy": remedy,
    }
    if view is not None:
        body["view"] = view
    return Response(
        encode_json(body),
        status_code=status,
        media_type="application/problem+json",
    )
