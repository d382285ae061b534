"""Access to one thing without an account: kiosk links, and API tokens for the metrics."""

from fastapi import Request
from starlette.status import HTTP_204_NO_CONTENT

from crenel.api.access.authorization import StationRouter, TheVisitor
from crenel.api.answers.problems import NotFoundError
from crenel.messages.message import message
from crenel.operations.context import TheContext
from crenel.store.access_tokens import AccessTokenStore
from crenel.wire.sign_in import AccessTokenSummary, NewAccessToken

router = StationRouter(prefix="/api")


@router.get("/kiosk-links")
def kiosk_links(context: TheContext) -> list[AccessTokenSummary]:
    """Lists all kiosk links."""
    return _summaries(context.store.kiosk_links)


@router.post("/kiosk-links")
def add_kiosk_link(
    asked: NewAccessToken, request: Request, context: TheContext, visitor: TheVisitor
) -> AccessTokenSummary:
    """Creates a kiosk link; its token is shown only once."""
    request.state.detail = asked.name
    return _add(context.store.kiosk_links, asked.name, visitor.name)


@router.delete("/kiosk-links/{link_id}", status_code=HTTP_204_NO_CONTENT)
def remove_kiosk_link(link_id: str, context: TheContext) -> None:
    """Revokes a kiosk link."""
    if not context.store.kiosk_links.remove(link_id):
        raise NotFoundError(message("there-no-kiosk-link", link_id=link_id))


@router.get("/tokens")
def api_tokens(context: TheContext) -> list[AccessTokenSummary]:
    """Lists all API tokens for the metrics."""
    return _summaries(context.store.api_tokens)


@router.post("/tokens")
def add_api_token(
    asked: NewAccessToken, request: Request, context: TheContext, visitor: TheVisitor
) -> AccessTokenSummary:
    """Creates an API token for the metrics; it is shown only once."""
    request.state.detail = asked.name
    return _add(context.store.api_tokens, asked.name, visitor.name)


@router.delete("/tokens/{token_id}", status_code=HTTP_204_NO_CONTENT)
def remove_api_token(token_id: str, context: TheContext) -> None:
    """Revokes an API token."""
    if not context.store.api_tokens.remove(token_id):
        raise NotFoundError(message("there-no-token", token_id=token_id))


def _summaries(store: AccessTokenStore) -> list[AccessTokenSummary]:
    return [AccessTokenSummary(one.id, one.name, one.made_by, one.made_at) for one in store.all()]


def _add(store: AccessTokenStore, name: str, made_by: str) -> AccessTokenSummary:
    made, secret = store.add(name, made_by)
    return AccessTokenSummary(made.id, made.name, made.made_by, made.made_at, secret)
