"""The report of a folder, in its two forms."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

from crenel.errors import OperationError
from crenel.formats.file_names import display_path
from crenel.formats.results.arm_checks import ARM_CHECK, TIP_CHECK
from crenel.formats.results.calibration import CALIBRATION
from crenel.formats.results.scan_record import SCAN
from crenel.formats.session.arm_session import IDENTIFIED
from crenel.gauges.plan.document import RESULT as PERFORMANCE
from crenel.gauges.quick.document import VERIFICATION
from crenel.gauges.quick.report import verification_report
from crenel.gauges.report.contents import performance_report
from crenel.messages.message import Text, join, message
from crenel.parts.document_results import RESULTS
from crenel.parts.report.contents import folder_inspection_report
from crenel.report.content import Report
from crenel.report.contents.arm_check import arm_check_report
from crenel.report.contents.calibration import calibration_report
from crenel.report.contents.identification import identification_report
from crenel.report.contents.scan import scan_report
from crenel.report.contents.tip_check import tip_check_report
from crenel.report.html import html_page
from crenel.report.logo import read_logo
from crenel.report.translation import translate_report

KINDS = (
    (VERIFICATION, verification_report),
    (ARM_CHECK, arm_check_report),
    (TIP_CHECK, tip_check_report),
    (PERFORMANCE, performance_report),
    (IDENTIFIED, identification_report),
    (RESULTS, folder_inspection_report),  # beside the calibration that it used
    (CALIBRATION, calibration_report),
    (SCAN, scan_report),
)


def _pdf(report: Report[str]) -> bytes:
    from crenel.report.pdf import pdf_document  # loads the PDF library only if it is needed

    return pdf_document(report)


FORMS = {".html": html_page, ".pdf": _pdf}


def folder_report(folder: Path) -> Report[Text]:
    """The report of the record in a folder.

    Raises:
        OperationError: it has no record with a report, or one of its files is missing or damaged.
    """
    for name, report in KINDS:
        if (folder / name).is_file():
            return replace(report(folder), logo=read_logo(folder))
    there = message("holds-no-record-one") if folder.is_dir() else message("there-no-such-folder")
    raise OperationError(
        "no-record",
        display_path(folder),
        there,
        message(
            "name-folder-calibration-check-verification-has",
            files=join([name for name, _ in KINDS]),
        ),
    )


def render_report(folder: Path, suffix: str, language: str = "en") -> bytes:
    """The report of a folder as ``.html`` or ``.pdf``, with identical bytes for the same files.

    Raises:
        OperationError: as ``folder_report``, or for another ``suffix`` or an unknown ``language``.
    """
    form = _form(suffix)
    return form(translate_report(folder_report(folder), language))


def render(report: Report[Text], suffix: str, language: str = "en") -> bytes:
    """A report as ``.html`` or ``.pdf``.

    Raises:
        OperationError: another ``suffix`` or an unknown ``language``.
    """
    return _form(suffix)(translate_report(report, language))


def _form(suffix: str) -> Callable[[Report[str]], bytes]:
    form = FORMS.get(suffix.lower())
    if form is None:
        raise OperationError(
            "report-form",
            message("report-cannot-written", suffix=suffix),
            remedy=message("end-name"),
        )
    return form
