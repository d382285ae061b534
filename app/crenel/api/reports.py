"""Reports of calibrations, verifications, tests, checks, identifications and scans.

A report is rendered from its folder at each request; nothing of it is stored, and it is identical
to that of ``crenel report`` for the folder.
"""

import asyncio
from collections.abc import Callable, Sequence
from pathlib import Path as Folder
from typing import Annotated, Literal

from fastapi import Path, Query
from starlette.responses import Response

from crenel.api.access.authorization import StationRouter
from crenel.api.answers.lookups import find_calibration, find_performance, find_scan
from crenel.api.answers.problems import NotFoundError
from crenel.formats.results.scan_record import SCAN
from crenel.guide.arm.view import ArmCheckSummary, IdentificationSummary, TipCheckSummary
from crenel.messages.message import Text, message
from crenel.operations.context import Context, TheContext
from crenel.report.contents.reports import render_report

router = StationRouter(prefix="/api")
Form = Literal["html", "pdf"]
ArmRecordKind = Literal["checks", "tips", "identifications"]
RecordId = Annotated[str, Path(max_length=128, pattern=r"^[0-9A-Za-z-]+$")]
Language = Annotated[str, Query(pattern="^[a-z]{2}$")]
Finished = ArmCheckSummary | TipCheckSummary | IdentificationSummary
MEDIA: dict[Form, str] = {"html": "text/html; charset=utf-8", "pdf": "application/pdf"}


@router.get("/calibrations/{record_id}/report.{form}")
async def calibration_report(
    record_id: RecordId, form: Form, context: TheContext, lang: Language = "en"
) -> Response:
    """The report of an accepted calibration."""
    return await _report(context, lambda: _calibration(context, record_id), form, lang)


@router.get("/arm/{kind}/{record_id}/report.{form}")
async def arm_report(
    kind: ArmRecordKind, record_id: RecordId, form: Form, context: TheContext, lang: Language = "en"
) -> Response:
    """The report of a finished arm check, tip check or identification."""
    return await _report(context, lambda: _session(context, kind, record_id), form, lang)


@router.get("/verifications/{record_id}/report.{form}")
async def verification_report(
    record_id: RecordId, form: Form, context: TheContext, lang: Language = "en"
) -> Response:
    """The report of a verification."""
    return await _report(context, lambda: _verification(context, record_id), form, lang)


@router.get("/performances/{record_id}/report.{form}")
async def performance_report(
    record_id: RecordId, form: Form, context: TheContext, lang: Language = "en"
) -> Response:
    """The report of a performance test."""
    return await _report(context, lambda: find_performance(context, record_id).folder, form, lang)


@router.get("/scans/{record_id}/report.{form}")
async def scan_report(
    record_id: RecordId, form: Form, context: TheContext, lang: Language = "en"
) -> Response:
    """The report of a finished scan."""
    return await _report(context, lambda: _scan(context, record_id), form, lang)


def _scan(context: Context, record_id: str) -> Folder:
    """The folder of a scan; those of earlier versions get the file that says what they are."""
    scan = find_scan(context, record_id)
    if not scan.folder.is_dir():
        raise NotFoundError(context.recovery.scan_note(scan))
    if not (scan.folder / SCAN).is_file():
        context.library.records.write_file(scan)
    return scan.folder


def _calibration(context: Context, record_id: str) -> Folder:
    return find_calibration(context, record_id).file.parent


def _session(context: Context, kind: ArmRecordKind, record_id: str) -> Folder:
    """The folder of a finished session.

    Raises:
        NotFound: there is none of this kind with this number.
    """
    past = context.arm_guide.history
    finished: dict[ArmRecordKind, tuple[Callable[[], Sequence[Finished]], Text]] = {
        "checks": (past.checks, message("there-no-check-arm", record_id=record_id)),
        "tips": (past.tip_checks, message("there-no-check-tip", record_id=record_id)),
        "identifications": (
            past.identifications,
            message("there-no-identification-arm", record_id=record_id),
        ),
    }
    all_of_kind, missing = finished[kind]
    if all(one.id != record_id for one in all_of_kind()):
        raise NotFoundError(missing)
    return context.store.folder / "sessions" / record_id


def _verification(context: Context, record_id: str) -> Folder:
    folder = context.store.folder / "verifications" / record_id
    if not folder.is_dir():
        raise NotFoundError(message("there-no-verification", record_id=record_id))
    return folder


async def _report(
    context: Context, find: Callable[[], Folder], form: Form, language: str
) -> Response:
    def make() -> tuple[str, bytes]:
        folder = find()
        return folder.name, render_report(folder, f".{form}", language)

    async with context.printer:
        name, content = await asyncio.to_thread(make)
    named = {"Content-Disposition": f'inline; filename="report-{name}.{form}"'}
    return Response(content, media_type=MEDIA[form], headers=named)
