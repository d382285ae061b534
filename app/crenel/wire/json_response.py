"""JSON for browsers that always comes about, and an error as RFC 9457 problem+json.

Light, for what answers before the station is loaded.
"""

import re
from http import HTTPStatus

from pydantic_core import PydanticSerializationError, to_json, to_jsonable_python
from starlette.exceptions import HTTPException
from starlette.responses import Response

from crenel.messages.message import Text

SURROGATES = re.compile("[\ud800-\udfff]")
REPLACEMENT = "\N{REPLACEMENT CHARACTER}"


def encode_json(value: object) -> bytes:
    """The value as JSON; not a number is null, half a character ``U+FFFD``."""
    try:
        return to_json(value, inf_nan_mode="null")
    except PydanticSerializationError:
        plain = to_jsonable_python(value, inf_nan_mode="null")
        return to_json(_valid(plain), inf_nan_mode="null")


def json_response(value: object) -> Response:
    """The response of a value that is not to be checked against its model again."""
    return Response(encode_json(value), media_type="application/json")


def _valid(value: object) -> object:
    """Plain values with valid texts only."""
    if isinstance(value, str):
        return SURROGATES.sub(REPLACEMENT, value)
    if isinstance(value, dict):
        return {_valid(key): _valid(inner) for key, inner in value.items()}
    if isinstance(value, list):
        return [_valid(inner) for inner in value]
    return value


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
