"""Authorisation of every request: who sent it, and whether they may do what it asks."""

import asyncio
import logging
from collections.abc import Iterator
from contextlib import contextmanager, nullcontext
from http import HTTPStatus
from typing import Annotated, cast

from fastapi import Depends
from fastapi.exceptions import WebSocketException
from starlette.requests import HTTPConnection
from starlette.responses import Response
from starlette.websockets import WebSocket

from app.errors import OperationError
from app.messages.message import Text, message
from app.operations.context import context_of
from app.security.authentication import AccessDeniedError
from app.security.permissions import ROUTES, WEBSOCKET, Right, Rule, has_right
from app.station.control_lease import Person
from app.store.login_sessions import LONGEST, Principal

log = logging.getLogger(__name__)
POLICY_VIOLATION, SIGNED_OUT = 1008, 4401
SIGN_IN_CHECK_S = 1.0
A_YEAR_S = 365 * 86400
PORTS = {"http": 80, "ws": 80, "https": 443, "wss": 443}


def authorise(connection: HTTPConnection) -> Iterator[None]:
    """Lets a request pass to its route, and records its action in the audit log.

    Raises:
        Denied: nobody is signed in, the role has no permission, or the route is not listed.
        WebSocketException: the same for a live connection.
        OperationError: another user has control.
    """
    context, rule = context_of(connection), _rule(connection)
    if rule.right is Right.enter or (rule.right is Right.scrape and _has_metrics_token(connection)):
        yield
        return
    visitor = visitor_of(connection)
    # anonymous requests are not audited
    with _audit(connection, rule, visitor) if rule.act and visitor else nullcontext():
        connection.state.visitor = _check_right(connection, rule, visitor)
        if rule.right is Right.act:
            context.lease.act(person_of(connection))
        yield


@contextmanager
def _audit(connection: HTTPConnection, rule: Rule, visitor: Principal) -> Iterator[None]:
    """Records in the audit log what is done inside, or why it was refused."""
    outcome: Text = message("act-failed")
    try:
        yield
        outcome = "done"
    except OperationError as error:
        outcome = error.text
        raise
    except AccessDeniedError as denied:
        outcome = denied.detail
        raise
    finally:
        named = [str(value) for value in connection.path_params.values()]
        detail: Text = getattr(connection.state, "detail", "") or ", ".join(named)
        act = message("act-with-detail", act=rule.act, detail=detail) if detail else rule.act
        context_of(connection).store.audit.note(visitor.name, address_of(connection), act, outcome)


def _rule(connection: HTTPConnection) -> Rule:
    path = getattr(connection.scope.get("route"), "path", "")
    rule = ROUTES.get((connection.scope.get("method", WEBSOCKET), path))
    if rule is None:
        raise AccessDeniedError(
            HTTPStatus.FORBIDDEN,
            "not-allowed",
            message("nobody-may-use", path=connection.url.path),
            "",
        )
    return rule


def _check_right(connection: HTTPConnection, rule: Rule, visitor: Principal | None) -> Principal:
    """The user, if permitted; control is checked after this."""
    if visitor is None:
        denied = AccessDeniedError(
            HTTPStatus.UNAUTHORIZED, "signed-out", message("nobody-signed-here"), message("sign-go")
        )
    elif has_right(rule.right, visitor.role, visitor.kiosk):
        return visitor
    elif visitor.kiosk:
        denied = AccessDeniedError(
            HTTPStatus.FORBIDDEN,
            "role",
            message("kiosk-can-only-view"),
            message("sign-browser-your-own"),
        )
    else:
        role = "admin" if rule.right is Right.administer else "operator"
        denied = AccessDeniedError(
            HTTPStatus.FORBIDDEN,
            "role",
            message("may-not-do-this", name=visitor.name, role=role),
            message("ask-somebody-with-role", role=role),
        )
    if connection.scope["type"] == "websocket":
        raise WebSocketException(POLICY_VIOLATION, str(denied.detail))
    raise denied


def _has_metrics_token(connection: HTTPConnection) -> bool:
    """Whether a program has a valid token; wrong tokens are slowed down like passwords.

    Raises:
        TooManyTries: too many from this address.
    """
    kind, _, token = connection.headers.get("authorization", "").partition(" ")
    if kind.lower() != "bearer":
        return False
    return context_of(connection).authenticator.check_metrics_token(
        token.strip(), address_of(connection)
    )


def token_of(connection: HTTPConnection) -> str:
    """The cookie of the login session, or an empty string."""
    return connection.cookies.get(cookie_name(connection), "")


def visitor_of(connection: HTTPConnection) -> Principal | None:
    """The user signed in at this browser."""
    token = token_of(connection)
    return context_of(connection).store.login_sessions.principal(token) if token else None


def current_visitor(connection: HTTPConnection) -> Principal:
    """The user whom ``authorise`` let pass."""
    return cast(Principal, connection.state.visitor)


def person_of(connection: HTTPConnection) -> Person:
    """The same, as control identifies them."""
    visitor = current_visitor(connection)
    return Person(visitor.id, visitor.name)


async def wait_for_sign_out(socket: WebSocket) -> None:
    """Returns when this browser's login session is no longer valid, or its permissions have
    changed.

    Control ends with it, even if another program ended the session.
    """
    visitor = current_visitor(socket)
    while await asyncio.to_thread(visitor_of, socket) == visitor:
        await asyncio.sleep(SIGN_IN_CHECK_S)
    context_of(socket).lease.leave(visitor.id)
    await socket.close(SIGNED_OUT, "signed out")


TheVisitor = Annotated[Principal, Depends(current_visitor)]
ThePerson = Annotated[Person, Depends(person_of)]


def address_of(connection: HTTPConnection) -> str:
    """The address from which the request came."""
    return connection.client.host if connection.client else ""


def cookie_name(connection: HTTPConnection) -> str:
    """One name per port, because browsers store cookies by host name only."""
    url = connection.url
    return cookie_for(url.port or PORTS[url.scheme])


def cookie_for(port: int) -> str:
    """The same, by port."""
    return f"crenel-{port}"


def browser_token(connection: HTTPConnection) -> str:
    """The token that identifies this browser, or an empty string; it gives no access."""
    return connection.cookies.get(f"{cookie_name(connection)}-known", "")


def own_address(connection: HTTPConnection, path: str) -> str:
    """The address of a page, as this browser reaches the server."""
    return f"{connection.url.scheme}://{connection.url.netloc}{path}"


def pending_cookie(connection: HTTPConnection) -> str:
    """The cookie of a sign-in that waits for the provider's answer, or an empty string."""
    return connection.cookies.get(f"{cookie_name(connection)}-pending", "")


def set_pending_cookie(
    response: Response, connection: HTTPConnection, value: str, lasts_s: int
) -> None:
    """A sign-in was begun in this browser; an empty value: it is finished."""
    _write_cookie(response, connection, f"{cookie_name(connection)}-pending", value, lasts_s)


def set_cookie(response: Response, connection: HTTPConnection, token: str, kiosk: bool) -> None:
    """Signs this browser in with a token; scripts cannot read it, other pages cannot send it."""
    lasts_s = A_YEAR_S if kiosk else int(LONGEST.total_seconds())
    _write_cookie(response, connection, cookie_name(connection), token, lasts_s)


def set_browser_token(response: Response, connection: HTTPConnection, token: str) -> None:
    """The browser is trusted from now on."""
    _write_cookie(response, connection, f"{cookie_name(connection)}-known", token, A_YEAR_S)


def _write_cookie(
    response: Response, connection: HTTPConnection, name: str, token: str, lasts_s: int
) -> None:
    response.set_cookie(
        name,
        token,
        max_age=lasts_s,
        httponly=True,
        samesite="strict",
        secure=connection.url.scheme == "https",
    )
