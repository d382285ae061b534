"""Who is notified: by webhook, and programs that read the metrics."""

from dataclasses import dataclass
from typing import Annotated

from fastapi import APIRouter, Request
from pydantic import Field
from starlette.status import HTTP_204_NO_CONTENT

from app.api.access.authorization import TheVisitor
from app.api.problems import NotFoundError
from app.errors import OperationError
from app.messages.message import Text, message
from app.operations.context import Context, TheContext
from app.supervision.webhook import WebhookSettings
from app.wire.schema import RequestBody as Asked

router = APIRouter(prefix="/api")


@dataclass(frozen=True)
class Notifications:
    """The secret itself is never shown again; ``trouble`` is of the last try."""

    url: str
    has_secret: bool
    done: bool
    fault: bool
    due: bool
    sent: int
    given_up: int
    waiting: int
    trouble: Text


class NotificationsChange(Asked):
    """``secret``: null leaves it, empty takes it away."""

    url: Annotated[str, Field(max_length=500)]
    secret: Annotated[str, Field(max_length=200)] | None
    done: bool
    fault: bool
    due: bool


class NewApiToken(Asked):
    name: Annotated[str, Field(min_length=1, max_length=60)]


@dataclass(frozen=True)
class ApiTokenSummary:
    """``token`` only where it was made just now."""

    id: str
    name: str
    made_by: str
    made_at: str
    token: str | None = None


@router.get("/notifications")
def notifications(context: TheContext) -> Notifications:
    """Where notifications go, and how the last ones fared."""
    return _notifications(context)


@router.post("/notifications")
def change(asked: NotificationsChange, context: TheContext) -> Notifications:
    """Sets where they go; another address needs its secret again."""
    watch, before = context.monitoring, context.monitoring.webhook.settings
    settings = WebhookSettings(
        url=asked.url,
        secret=asked.secret or "",
        done=asked.done,
        fault=asked.fault,
        due=asked.due,
    )
    if asked.secret is None and settings.url == before.url:
        settings = settings.model_copy(update={"secret": before.secret})
    watch.webhooks.save(settings)
    watch.webhook.settings = settings
    watch.webhook.trouble = ""
    return _notifications(context)


@router.post("/notifications/test")
async def send_test(context: TheContext) -> Notifications:
    """Sends one; how it fared shows a moment later."""
    if not context.monitoring.webhook.settings.url:
        raise OperationError(
            "no-webhook", message("there-no-address-yet"), remedy=message("give-one-first")
        )
    context.monitoring.notify("test", message("says-hello", name=context.station.name))
    return _notifications(context)


@router.get("/tokens")
def api_tokens(context: TheContext) -> list[ApiTokenSummary]:
    """Every token for the metrics."""
    found = context.store.api_tokens.all()
    return [ApiTokenSummary(one.id, one.name, one.made_by, one.made_at) for one in found]


@router.post("/tokens")
def add_api_token(
    asked: NewApiToken, request: Request, context: TheContext, visitor: TheVisitor
) -> ApiTokenSummary:
    """A new token, which is shown this once."""
    request.state.detail = asked.name
    one, token = context.store.api_tokens.add(asked.name, visitor.name)
    return ApiTokenSummary(one.id, one.name, one.made_by, one.made_at, token)


@router.delete("/tokens/{token_id}", status_code=HTTP_204_NO_CONTENT)
def remove_api_token(token_id: str, context: TheContext) -> None:
    """A token that is good for nothing from now on."""
    if all(one.id != token_id for one in context.store.api_tokens.all()):
        raise NotFoundError(message("there-no-token", token_id=token_id))
    context.store.api_tokens.remove(token_id)


def _notifications(context: Context) -> Notifications:
    webhook = context.monitoring.webhook
    settings = webhook.settings
    return Notifications(
        url=settings.url,
        has_secret=bool(settings.secret),
        done=settings.done,
        fault=settings.fault,
        due=settings.due,
        sent=webhook.sent,
        given_up=webhook.failed,
        waiting=webhook.waiting,
        trouble=webhook.trouble,
    )
