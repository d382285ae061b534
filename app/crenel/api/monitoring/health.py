"""Health of the station, its log, the support bundle and backups."""

import threading
from dataclasses import dataclass, replace
from typing import Annotated

from fastapi import Query
from starlette.responses import Response

from crenel.api.access.authorization import StationRouter
from crenel.api.monitoring.support import bundle
from crenel.errors import OperationError
from crenel.messages.catalogue import translator
from crenel.messages.language_file import ENGLISH
from crenel.messages.message import Text, message
from crenel.monitoring.health import Health
from crenel.monitoring.log_store import Level, LogLine
from crenel.operations.context import Context, TheContext
from crenel.operations.health_checks import HealthChecker
from crenel.store.backup import BackupRecord, display_backup
from crenel.timestamps import utc_now

router = StationRouter(prefix="/api")
LINES = 300
BUNDLING = threading.Lock()


@dataclass(frozen=True)
class BackupState:
    """``share``: completed share of the running backup; null if none is running."""

    share: float | None
    folder: str
    last: BackupRecord | None
    trouble: Text


@dataclass(frozen=True)
class HealthView:
    """The findings of the Health page."""

    health: Health
    backup: BackupState


@router.get("/health")
def health(context: TheContext) -> HealthView:
    """All checks with their results, their importance, and remedies."""
    checked = context.monitoring.health or HealthChecker(context).look()
    return HealthView(checked, _backup(context))


@router.get("/logs")
def logs(
    context: TheContext,
    level: Level = "info",
    words: Annotated[str, Query(max_length=100)] = "",
    lang: Annotated[str, Query(pattern="^[a-z]{2}$")] = ENGLISH,
) -> list[LogLine]:
    """The newest log lines of at least this level that contain all the words, newest first.

    Words are searched in English and in the user's language.
    """
    return context.monitoring.logs.read(level, words, LINES, translator(lang))


@router.get("/support.zip")
def support(context: TheContext) -> Response:
    """The support bundle: information for support, without secrets and names.

    Raises:
        OperationError: a bundle is already being made: several at once would delay Stop.
    """
    if not BUNDLING.acquire(blocking=False):
        raise OperationError(
            "busy", message("support-bundle-being-made-already"), remedy=message("wait")
        )
    try:
        content = bundle(context)
    finally:
        BUNDLING.release()
    name = f"crenel-support-{utc_now()[:19].replace(':', '')}.zip"
    headers = {"Content-Disposition": f'attachment; filename="{name}"', "Cache-Control": "no-store"}
    return Response(content, media_type="application/zip", headers=headers)


@router.post("/backup")
def start_backup(context: TheContext) -> BackupState:
    """Starts a backup of everything, while the station keeps running."""
    context.monitoring.backups.start()
    return _backup(context)


def _backup(context: Context) -> BackupState:
    backups = context.monitoring.backups
    last = backups.last
    if last is not None:
        last = replace(last, folder=display_backup(last.folder))
    return BackupState(backups.share, display_backup(backups.folder), last, backups.trouble)
