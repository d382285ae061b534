"""An error as RFC 9457 problem+json; light, for what answers before the station is loaded."""

from http import HTTPStatus

from starlette.exceptions import HTTPException
from starlette.responses import Response

from app.messages.message import Text
from app.wire.encoding import encode_json


class RequestError(HTTPException):
    """A request that is not read to its end."""

    def __init__(self, status: int, text: Text) -> None:
        super().__init__(status, str(text))
        self.text = text


def problem(
    status: int, code: str, detail: Text, remedy: Text = "", view: object | None = None
) -> Response:
    """The response of an error; its fields are those of ``schema.Problem``.

    ``detail`` and ``remedy`` are English, for programs; ``messages`` has both as data, for the
    browser, which puts them into its reader's language.
    """
    body = {
        "type": "about:blank",
        "title": HTTPStatus(status).phrase,
        "status": status,
        "detail": str(detail),
        "code": code,
        "remedy": str(remedy),
        "messages": {"detail": detail, "remedy": remedy},
    }
    if view is not None:
        body["view"] = view
    return Response(
        encode_json(body),
        status_code=status,
        media_type="application/problem+json",
    )
