"""Signing in and out, and control of the station."""

import asyncio
from dataclasses import replace
from http import HTTPStatus

from fastapi import Request, Response

from crenel.api.access.authorization import StationRouter, ThePerson, TheVisitor, visitor_of
from crenel.api.access.browser import (
    address_of,
    browser_token,
    current_user,
    own_address,
    set_browser_token,
    set_cookie,
    token_of,
)
from crenel.messages.message import Text, message
from crenel.operations.context import Context, TheContext
from crenel.security.anonymous_queue import without_place
from crenel.security.authentication import AccessDeniedError
from crenel.station.control_lease import Control
from crenel.store.login_sessions import Principal
from crenel.wire.readiness import READY, Readiness
from crenel.wire.sign_in import (
    ControlReply,
    FirstAdmin,
    NewPassword,
    SignIn,
    SignInCode,
    SignInState,
    TakeoverReason,
)

router = StationRouter(prefix="/api")
SIGNED_IN = message("signed")


@router.get("/session")
def session(request: Request, context: TheContext) -> SignInState:
    """Who is signed in here, or how to sign in."""
    return sign_in_state(context, request, visitor_of(request))


@router.get("/starting")
def starting() -> Readiness:
    """Whether the station is ready; during the start, the start-up server answers this."""
    return READY


@router.post("/session")
def sign_in(
    asked: SignIn, request: Request, response: Response, context: TheContext
) -> SignInState:
    """Signs this browser in."""
    account = context.authenticator.sign_in(
        asked.name, asked.password, address_of(request), browser_token(request)
    )
    if account is None:
        context.store.audit.note(
            asked.name, address_of(request), message("signed"), message("wrong-password")
        )
        raise AccessDeniedError(
            HTTPStatus.UNAUTHORIZED,
            "wrong-password",
            message("name-password-do-belong-together"),
            message("try-again-ask-administrator-new-password"),
        )
    _trust_browser(account.name, request, response, context)
    return begin_session(account.name, request, response, context)


@router.post("/session/code")
def sign_in_guest(
    asked: SignInCode, request: Request, response: Response, context: TheContext
) -> SignInState:
    """Signs in the guest of a demonstration."""
    guest = context.authenticator.guest_by_code(asked.code, address_of(request))
    if guest is None:
        raise _wrong_code(context, request, message("entered-consoles-code"))
    return begin_session(guest, request, response, context)


@router.post("/session/admin")
def first_admin(
    asked: FirstAdmin, request: Request, response: Response, context: TheContext
) -> SignInState:
    """Creates the first administrator, and signs this browser in."""
    account = context.authenticator.make_admin(
        asked.code, asked.name, asked.password, address_of(request)
    )
    if account is None:
        raise _wrong_code(context, request, message("made-first-administrator"))
    _trust_browser(account.name, request, response, context)
    return begin_session(account.name, request, response, context)


@router.post("/session/kiosk")
def sign_in_kiosk(
    asked: SignInCode, request: Request, response: Response, context: TheContext
) -> SignInState:
    """Makes this browser a kiosk screen."""
    visitor = context.authenticator.kiosk_by_link(asked.code, address_of(request))
    if visitor is None:
        raise AccessDeniedError(
            HTTPStatus.UNAUTHORIZED,
            "kiosk-link",
            message("link-no-longer-valid"),
            message("ask-administrator-new-one"),
        )
    set_cookie(response, request, asked.code, kiosk=True)
    context.store.audit.note(visitor.name, address_of(request), message("opened-kiosk"))
    return sign_in_state(context, request, visitor)


@router.delete("/session")
async def sign_out(request: Request, response: Response, context: TheContext) -> SignInState:
    """Signs this browser out; its control goes to whoever requested it, or becomes free.

    The answer names the page on which the provider of the account signs out, too.
    """
    visitor = await asyncio.to_thread(_end_session, request, context)
    set_cookie(response, request, "", kiosk=False)
    signed_out = await asyncio.to_thread(sign_in_state, context, request, None)
    if visitor is None or not visitor.provider or context.provider is None:
        return signed_out
    async with without_place(request):
        page = await context.provider.sign_out_address(own_address(request, "/"))
    return replace(signed_out, sign_out_page=page)


def _end_session(request: Request, context: Context) -> Principal | None:
    visitor = visitor_of(request)
    if visitor is not None:
        context.lease.leave(visitor.id)
        context.store.login_sessions.end(token_of(request))
        context.store.audit.note(visitor.name, address_of(request), message("signed-out"))
    return visitor


@router.post("/session/password")
def change_password(
    asked: NewPassword,
    request: Request,
    response: Response,
    context: TheContext,
    visitor: TheVisitor,
) -> SignInState:
    """Changes the user's own password; all other browsers of this user are signed out."""
    context.store.accounts.check_local(visitor.name)
    address, browser = address_of(request), browser_token(request)
    if context.authenticator.sign_in(visitor.name, asked.old, address, browser) is None:
        raise AccessDeniedError(
            HTTPStatus.FORBIDDEN,
            "wrong-password",
            message("old-password-wrong"),
            message("try-again"),
        )
    context.store.accounts.set_password(visitor.name, asked.new)
    context.store.login_sessions.end_all(visitor.name)
    context.lease.leave_all(visitor.name)
    return begin_session(visitor.name, request, response, context)


@router.post("/control/ask")
def ask(context: TheContext, person: ThePerson) -> Control:
    """Requests control; takes it if it is free."""
    context.lease.ask(person)
    return context.lease.control


@router.post("/control/answer")
def answer(asked: ControlReply, context: TheContext, person: ThePerson) -> Control:
    """Gives control to the user who requested it, or keeps it."""
    context.lease.answer(person, asked.give)
    return context.lease.control


@router.post("/control/release")
def release(context: TheContext, person: ThePerson) -> Control:
    """Releases control."""
    context.lease.release(person)
    return context.lease.control


@router.post("/control/take")
def take(
    asked: TakeoverReason, request: Request, context: TheContext, person: ThePerson
) -> Control:
    """Takes control over, with a reason that everyone can read."""
    request.state.detail = asked.reason
    context.lease.take_over(person, asked.reason)
    return context.lease.control


def begin_session(
    name: str, request: Request, response: Response, context: Context, act: Text = SIGNED_IN
) -> SignInState:
    """Signs this browser in; ``act`` is for the audit log."""
    token = context.store.login_sessions.begin(name, request.headers.get("user-agent", ""))
    set_cookie(response, request, token, kiosk=False)
    context.store.audit.note(name, address_of(request), act)
    return sign_in_state(context, request, context.store.login_sessions.principal(token))


def _trust_browser(name: str, request: Request, response: Response, context: Context) -> None:
    """After a correct password, wrong attempts of others no longer slow this browser down."""
    before = browser_token(request)
    if not context.store.login_sessions.is_known_browser(before, name):
        set_browser_token(
            response, request, context.store.login_sessions.remember_browser(before, name)
        )


def sign_in_state(context: Context, request: Request, visitor: Principal | None) -> SignInState:
    """Who is signed in, or how to sign in."""
    entrance, provider = context.authenticator, context.provider
    return SignInState(
        context.station.name,
        current_user(visitor),
        entrance.first_start,
        entrance.by_code,
        provider.name if provider else "",
        provider.trouble if provider else "",
        address=own_address(request, "/"),
    )


def _wrong_code(context: Context, request: Request, act: Text) -> AccessDeniedError:
    context.store.audit.note("", address_of(request), act, message("wrong-code"))
    return AccessDeniedError(
        HTTPStatus.UNAUTHORIZED,
        "wrong-code",
        message("code-wrong"),
        message("take-one-console-shows-since-stations"),
    )
