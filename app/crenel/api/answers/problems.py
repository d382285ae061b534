"""All errors as RFC 9457 problem+json: what happened, why, and what to do."""

import logging
from http import HTTPStatus

from fastapi import FastAPI, Request
from fastapi.exceptions import RequestValidationError
from starlette.exceptions import HTTPException
from starlette.responses import Response
from starlette.types import ASGIApp, Receive, Scope, Send
from starlette.types import Message as AsgiMessage

from crenel.errors import STALE, OperationError, StaleViewError
from crenel.messages.message import Text, join, message, quantity
from crenel.messages.validation import validation_text
from crenel.security.authentication import AccessDeniedError, TooManyAttemptsError
from crenel.store.database import NOT_SAVED
from crenel.wire.json_response import RequestError, problem

log = logging.getLogger(__name__)

UNPROCESSABLE = 422
STATUSES = {
    STALE: 409,
    NOT_SAVED: 507,
    "disk-full": 507,
    "catalogue-away": 503,
    "datasheet-exists": 409,
    "datasheet-changed": 409,
    "no-datasheet": 404,
}
"""Statuses of the refusals that programs recognise by them."""


def operation_problem(error: OperationError, status: int = UNPROCESSABLE) -> Response:
    detail = message("error-what", what=error.what)
    if error.why:
        detail = message("error-what-and-why", what=error.what, why=error.why)
    view = error.view if isinstance(error, StaleViewError) else None
    return problem(status, error.code, detail, error.remedy, view)


class NotFoundError(Exception):
    """The requested thing does not exist (any more)."""

    def __init__(self, text: Text) -> None:
        super().__init__(text)
        self.text = text

    def __str__(self) -> str:
        return str(self.text)


def install(app: FastAPI) -> None:
    """Answers every exception of a route with a problem."""
    app.add_exception_handler(OperationError, _answer_operation_error)
    app.add_exception_handler(NotFoundError, _answer_not_found)
    app.add_exception_handler(AccessDeniedError, _answer_access_denied)
    app.add_exception_handler(TooManyAttemptsError, _answer_too_many)
    app.add_exception_handler(RequestValidationError, _answer_invalid)
    app.add_exception_handler(HTTPException, _answer_http_error)
    app.add_middleware(_Unexpected)


async def _answer_operation_error(request: Request, error: Exception) -> Response:
    assert isinstance(error, OperationError)
    if error.code == NOT_SAVED:
        log.warning(
            message("log-not-saved", method=request.method, path=request.url.path, reason=error.why)
        )
    return operation_problem(error, STATUSES.get(error.code, UNPROCESSABLE))


async def _answer_not_found(request: Request, error: Exception) -> Response:
    assert isinstance(error, NotFoundError)
    return problem(HTTPStatus.NOT_FOUND, "not-found", error.text)


async def _answer_access_denied(request: Request, error: Exception) -> Response:
    assert isinstance(error, AccessDeniedError)
    return problem(error.status, error.code, error.detail, error.remedy)


async def _answer_too_many(request: Request, error: Exception) -> Response:
    assert isinstance(error, TooManyAttemptsError)
    return too_many_attempts(error)


def too_many_attempts(error: TooManyAttemptsError) -> Response:
    """The answer to passwords that come too fast."""
    wait_s = max(round(error.wait_s), 1)
    answer = problem(
        HTTPStatus.TOO_MANY_REQUESTS,
        "too-many-tries",
        message("too-many-wrong-tries"),
        message("wait-s-then-try-again", wait=quantity(wait_s, "s")),
    )
    answer.headers["Retry-After"] = str(wait_s)
    return answer


async def _answer_invalid(request: Request, error: Exception) -> Response:
    assert isinstance(error, RequestValidationError)
    first = error.errors()[0]
    place = ".".join(str(part) for part in first["loc"] if part != "body")
    reason = validation_text(first)
    text = join([place, reason], ": ") if place else reason
    return problem(UNPROCESSABLE, "bad-request", message("request-understood", text=text))


async def _answer_http_error(request: Request, error: Exception) -> Response:
    assert isinstance(error, HTTPException)
    if error.status_code == HTTPStatus.NOT_FOUND:
        return problem(404, "not-found", message("there-nothing", path=request.url.path))
    if error.status_code == HTTPStatus.METHOD_NOT_ALLOWED:
        unsupported = message("method-not-accepted", path=request.url.path, method=request.method)
        return problem(405, "method-not-allowed", unsupported)
    text = error.text if isinstance(error, RequestError) else error.detail
    return problem(error.status_code, "bad-request", text)


class _Unexpected:
    """Answers unexpected exceptions; the log has the traceback, the browser does not."""

    def __init__(self, app: ASGIApp) -> None:
        self._app = app

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        begun = False

        async def sending(part: AsgiMessage) -> None:
            nonlocal begun
            begun = True
            await send(part)

        try:
            await self._app(scope, receive, sending)
        except Exception:
            if begun or scope["type"] != "http":
                raise
            log.exception("%s %s failed", scope["method"], scope["path"])
            answer = problem(
                500,
                "unexpected",
                message("server-failed-what-taken-before-kept"),
                message("try-again-if-happens-again-stations"),
            )
            await answer(scope, receive, send)
