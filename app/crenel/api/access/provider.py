"""Signing in with an account of the plant's provider, by OpenID Connect.

The provider sends the browser to ``/sign-in``, which is a page of the client like any other: it
comes from another site, so the browser sends no cookies with it. The page then posts what the
provider sent, with the cookies.
"""

import asyncio
from http import HTTPStatus
from typing import TYPE_CHECKING

from fastapi import Request, Response

from crenel.api.access.admission import admit_person
from crenel.api.access.auth import begin_session
from crenel.api.access.authorization import StationRouter
from crenel.api.access.browser import (
    BACK,
    address_of,
    own_address,
    pending_cookie,
    set_pending_cookie,
)
from crenel.api.answers.problems import NotFoundError
from crenel.errors import OperationError
from crenel.messages.message import message
from crenel.operations.context import Context, TheContext
from crenel.security.anonymous_queue import without_place
from crenel.security.authentication import AccessDeniedError
from crenel.single_sign_on.errors import SignInError
from crenel.single_sign_on.pending import LASTS_S, ProviderAnswer
from crenel.single_sign_on.person import ProviderPerson
from crenel.store.accounts import Account
from crenel.wire.sign_in import ProviderPage, ProviderReply, SignInState

if TYPE_CHECKING:
    from crenel.single_sign_on.provider import Provider

router = StationRouter(prefix="/api/session/provider")


@router.post("")
async def begin(request: Request, response: Response, context: TheContext) -> ProviderPage:
    """Begins a sign-in in this browser."""
    provider, address = _provider(context), address_of(request)
    context.authenticator.check_provider_attempts(address)
    try:
        async with without_place(request):
            page, cookie = await provider.begin(own_address(request, BACK))
    except SignInError as error:
        raise await asyncio.to_thread(_note_failure, error, address, context) from error
    set_pending_cookie(response, request, cookie, LASTS_S)
    return ProviderPage(page)


@router.post("/answer")
async def finish(
    asked: ProviderReply, request: Request, response: Response, context: TheContext
) -> SignInState:
    """Signs this browser in, with what the provider answered."""
    provider, address = _provider(context), address_of(request)
    context.authenticator.check_provider_attempts(address)
    answer = ProviderAnswer(asked.state, asked.code, asked.error)
    try:
        async with without_place(request):
            person = await provider.finish(
                answer, pending_cookie(request), own_address(request, BACK)
            )
        account = await asyncio.to_thread(_admit, person, context)
    except OperationError as error:
        raise await asyncio.to_thread(_note_failure, error, address, context) from error
    context.authenticator.note_provider_attempt(True, address)
    set_pending_cookie(response, request, "", 0)
    act = message("signed-in-with", name=provider.name)
    return await asyncio.to_thread(begin_session, account.name, request, response, context, act)


def _provider(context: Context) -> "Provider":
    if context.provider is None:
        raise NotFoundError(message("sign-in-no-provider"))
    return context.provider


def _admit(person: ProviderPerson, context: Context) -> Account:
    store = context.store
    return admit_person(
        person,
        _provider(context).settings,
        store.accounts,
        store.login_sessions,
        context.lease.leave_all,
    )


def _note_failure(error: OperationError, address: str, context: Context) -> AccessDeniedError:
    """Notes a failed sign-in in the audit log, and against repeated ones."""
    provider = _provider(context)
    context.authenticator.note_provider_attempt(False, address)
    act = message("signed-in-with", name=provider.name)
    context.store.audit.note("", address, act, error.reason)
    return AccessDeniedError(HTTPStatus.UNAUTHORIZED, error.code, error.what, error.remedy)
