"""Authorisation of every request: who sent it, and whether they may do what it asks."""

import logging
from collections.abc import Iterator
from contextlib import contextmanager, nullcontext
from http import HTTPStatus
from typing import Annotated, cast

from fastapi import APIRouter, Depends
from fastapi.exceptions import WebSocketException
from starlette.requests import HTTPConnection

from crenel.api.access.browser import address_of, token_of
from crenel.errors import OperationError
from crenel.messages.message import Text, message
from crenel.operations.context import context_of
from crenel.security.authentication import AccessDeniedError
from crenel.security.permissions import ROUTES, WEBSOCKET, Right, Rule, has_right
from crenel.station.control_lease import Person
from crenel.store.login_sessions import Principal

log = logging.getLogger(__name__)
POLICY_VIOLATION = 1008
SIGN_IN_CHECK_S = 1.0


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


class StationRouter(APIRouter):
    """Routes of the station, each of which ``authorise`` lets a request pass to.

    The application takes them as they are: to include a router builds each route a second time,
    which delays the first request.
    """

    def __init__(self, prefix: str = "", include_in_schema: bool = True) -> None:
        super().__init__(
            prefix=prefix,
            include_in_schema=include_in_schema,
            # actions are in the audit log before they are answered
            dependencies=[Depends(authorise, scope="function")],
        )


TheVisitor = Annotated[Principal, Depends(current_visitor)]
ThePerson = Annotated[Person, Depends(person_of)]
