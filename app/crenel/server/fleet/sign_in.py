"""The routes by which people sign in at the fleet's server, as at a station, and what happens to
requests of others."""

import asyncio
from dataclasses import replace
from http import HTTPStatus

from fastapi import APIRouter, Request
from starlette.requests import HTTPConnection
from starlette.responses import Response
from starlette.types import ASGIApp, Receive, Scope, Send

from crenel.api.access.browser import (
    BACK,
    address_of,
    current_user,
    own_address,
    pending_cookie,
    set_cookie,
    set_pending_cookie,
    token_of,
)
from crenel.api.answers.problems import NotFoundError, too_many_attempts
from crenel.errors import OperationError
from crenel.messages.message import message
from crenel.security.authentication import AccessDeniedError, TooManyAttemptsError
from crenel.server.fleet.access import FleetAccess, FleetPeople, log_refusal
from crenel.single_sign_on.errors import SignInError
from crenel.single_sign_on.pending import LASTS_S, ProviderAnswer
from crenel.store.login_sessions import Principal
from crenel.wire.json_response import problem
from crenel.wire.sign_in import ProviderPage, ProviderReply, SignInState

NO_ACCESS = {"WWW-Authenticate": 'Basic realm="Crenel fleet", charset="UTF-8"'}
PASSWORD_PAGE = "/password"
"""Here a browser asks for the page's password, and sends it from then on."""
OPEN_PATHS = ("/api/session", "/api/session/provider", "/api/session/provider/answer")


class AccessCheck:
    """ASGI middleware that refuses requests without a sign-in.

    With a provider, the page itself is for everyone: it has the button for signing in.
    """

    def __init__(self, app: ASGIApp, access: FleetAccess) -> None:
        self._app, self._access = app, access

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        refusal = None
        if scope["type"] == "http" and not self._access.is_open:
            refusal = await _refusal_of(self._access, HTTPConnection(scope))
        await (refusal or self._app)(scope, receive, send)


async def _refusal_of(access: FleetAccess, connection: HTTPConnection) -> Response | None:
    """The answer to a request that is not allowed; None if it is."""
    try:
        by_password = access.knows_password(connection)
    except TooManyAttemptsError as error:
        return too_many_attempts(error)
    if by_password or await asyncio.to_thread(access.visitor, connection) is not None:
        return None
    path = connection.url.path
    if access.people is None or (path == PASSWORD_PAGE and access.has_password):
        return Response("The password is missing or wrong.", 401, NO_ACCESS)
    if path in OPEN_PATHS or not path.startswith("/api/"):
        return None
    return problem(401, "signed-out", message("nobody-signed-here"), message("sign-go"))


def sign_in_router(access: FleetAccess) -> APIRouter:
    """The routes of the entrance page."""
    router = APIRouter(prefix="/api/session")

    @router.get("")
    def session(request: Request) -> SignInState:
        return _state(access, request, access.visitor(request), access.knows_password(request))

    @router.post("/provider")
    async def begin(request: Request, response: Response) -> ProviderPage:
        people, address = _people(access), address_of(request)
        access.check_attempts(address)
        try:
            page, cookie = await people.provider.begin(own_address(request, BACK))
        except SignInError as error:
            raise _note_refusal(access, error, address) from error
        set_pending_cookie(response, request, cookie, LASTS_S)
        return ProviderPage(page)

    @router.post("/provider/answer")
    async def finish(asked: ProviderReply, request: Request, response: Response) -> SignInState:
        people, address = _people(access), address_of(request)
        access.check_attempts(address)
        answer = ProviderAnswer(asked.state, asked.code, asked.error)
        try:
            back, pending = own_address(request, BACK), pending_cookie(request)
            person = await people.provider.finish(answer, pending, back)
            device = request.headers.get("user-agent", "")
            token = await asyncio.to_thread(people.admit, person, device)
        except OperationError as error:
            raise _note_refusal(access, error, address) from error
        access.note_attempt(True, address)
        set_pending_cookie(response, request, "", 0)
        set_cookie(response, request, token, kiosk=False)
        return _state(access, request, await asyncio.to_thread(people.sessions.principal, token))

    @router.delete("")
    async def sign_out(request: Request, response: Response) -> SignInState:
        people = _people(access)
        visitor = await asyncio.to_thread(access.visitor, request)
        set_cookie(response, request, "", kiosk=False)
        if visitor is None:
            return _state(access, request)
        await asyncio.to_thread(people.sessions.end, token_of(request))
        page = await people.provider.sign_out_address(own_address(request, "/"))
        return replace(_state(access, request), sign_out_page=page)

    return router


def _people(access: FleetAccess) -> FleetPeople:
    if access.people is None:
        raise NotFoundError(message("sign-in-no-provider"))
    return access.people


def _state(
    access: FleetAccess,
    request: Request,
    visitor: Principal | None = None,
    by_password: bool = False,
) -> SignInState:
    """Who is signed in, or how to sign in; no provider: nobody has to."""
    provider = None if access.people is None or by_password else access.people.provider
    return SignInState(
        "Fleet",
        current_user(visitor),
        first_start=False,
        by_code=False,
        provider="" if provider is None else provider.name,
        provider_trouble="" if provider is None else provider.trouble,
        password_page=PASSWORD_PAGE if access.has_password else "",
        address=own_address(request, "/"),
    )


def _note_refusal(access: FleetAccess, error: OperationError, address: str) -> AccessDeniedError:
    access.note_attempt(False, address)
    log_refusal(error, address)
    return AccessDeniedError(HTTPStatus.UNAUTHORIZED, error.code, error.what, error.remedy)
