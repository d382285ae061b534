"""Notifications by webhook: their address and their kinds."""

from dataclasses import dataclass
from typing import Annotated

from pydantic import Field

from crenel.api.access.authorization import StationRouter
from crenel.errors import OperationError
from crenel.messages.message import Text, message
from crenel.operations.context import Context, TheContext
from crenel.supervision.webhook import WebhookSettings
from crenel.wire.schema import RequestBody as Asked

router = StationRouter(prefix="/api")


@dataclass(frozen=True)
class Notifications:
    """The secret itself is never shown again; ``trouble`` is that of the last attempt."""

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
    """``secret``: null keeps it, an empty string removes it."""

    url: Annotated[str, Field(max_length=500)]
    secret: Annotated[str, Field(max_length=200)] | None
    done: bool
    fault: bool
    due: bool


@router.get("/notifications")
def notifications(context: TheContext) -> Notifications:
    """The address of notifications, and the results of the last ones."""
    return _notifications(context)


@router.post("/notifications")
def change(asked: NotificationsChange, context: TheContext) -> Notifications:
    """Sets the address and kinds of notifications; another address requires the secret again."""
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
    """Sends a test notification; its result is available a moment later."""
    if not context.monitoring.webhook.settings.url:
        raise OperationError(
            "no-webhook", message("there-no-address-yet"), remedy=message("give-one-first")
        )
    context.monitoring.notify("test", message("says-hello", name=context.station.name))
    return _notifications(context)


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
