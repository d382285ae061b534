"""Reports on calibrations, verifications, and checks and identifications of the arm.

A report is made of its folder each time it is asked for: nothing of it is kept, and it is
what ``crenel report`` makes of the folder.
"""

from collections.abc import Iterable
from pathlib import Path as Folder
from typing import Annotated, Literal

from fastapi import APIRouter, Path, Query
from starlette.responses import Response

from app.api.context import Context, TheContext
from app.api.problems import NotFound
from app.guide.arm.view import ArmCheckSummary, IdentificationSummary, TipCheckSummary
from app.report.reports import report_as

router = APIRouter(prefix="/api")
Form = Literal["html", "pdf"]
RecordId = Annotated[str, Path(max_length=128, pattern=r"^[0-9A-Za-z-]+$")]
Language = Annotated[str, Query(pattern="^[a-z]{2}$")]
Finished = ArmCheckSummary | TipCheckSummary | IdentificationSummary
MEDIA: dict[Form, str] = {"html": "text/html; charset=utf-8", "pdf": "application/pdf"}


@router.get("/calibrations/{record_id}/report.{form}")
def of_calibration(
    record_id: RecordId, form: Form, context: TheContext, lang: Language = "en"
) -> Response:
    """The report on an accepted calibration."""
    record = context.store.calibrations.get(record_id)
    if record is None:
        raise NotFound(f"There is no calibration {record_id}.")
    return _report(record.file.parent, form, lang)


@router.get("/arm/checks/{record_id}/report.{form}")
def of_check(
    record_id: RecordId, form: Form, context: TheContext, lang: Language = "en"
) -> Response:
    """The report on a finished check of the arm."""
    missing = f"There is no check of the arm {record_id}."
    folder = _session(context, context.arm_guide.past.checks(), record_id, missing)
    return _report(folder, form, lang)


@router.get("/arm/tips/{record_id}/report.{form}")
def of_tip(record_id: RecordId, form: Form, context: TheContext, lang: Language = "en") -> Response:
    """The report on a finished check of the tip."""
    missing = f"There is no check of the tip {record_id}."
    folder = _session(context, context.arm_guide.past.tip_checks(), record_id, missing)
    return _report(folder, form, lang)


@router.get("/arm/identifications/{record_id}/report.{form}")
def of_identification(
    record_id: RecordId, form: Form, context: TheContext, lang: Language = "en"
) -> Response:
    """The report on an identification of the arm."""
    missing = f"There is no identification of the arm {record_id}."
    folder = _session(context, context.arm_guide.past.identifications(), record_id, missing)
    return _report(folder, form, lang)


@router.get("/verifications/{record_id}/report.{form}")
def of_verification(
    record_id: RecordId, form: Form, context: TheContext, lang: Language = "en"
) -> Response:
    """The report on a verification."""
    folder = _verification(context, record_id)
    if not folder.is_dir():
        raise NotFound(f"There is no verification {record_id}.")
    return _report(folder, form, lang)


def _session(
    context: Context, finished: Iterable[Finished], record_id: str, missing: str
) -> Folder:
    """Of a finished session; what is ``missing`` is said where there is none of that number."""
    if all(one.id != record_id for one in finished):
        raise NotFound(missing)
    return context.store.folder / "sessions" / record_id


def _verification(context: Context, record_id: str) -> Folder:
    return context.store.folder / "verifications" / record_id


def _report(folder: Folder, form: Form, language: str) -> Response:
    content = report_as(folder, f".{form}", language)
    named = {"Content-Disposition": f'inline; filename="report-{folder.name}.{form}"'}
    return Response(content, media_type=MEDIA[form], headers=named)
