"""Which report a folder has, and its two forms."""

from pathlib import Path

from app.errors import OperationError
from app.formats.file_names import display_path
from app.formats.results.arm_checks import ARM_CHECK, TIP_CHECK
from app.formats.results.verification import VERIFICATION
from app.formats.session.arm_session import IDENTIFIED
from app.report.content import Report
from app.report.contents.arm_check import arm_check_report
from app.report.contents.calibration import CALIBRATION, calibration_report
from app.report.contents.identification import identification_report
from app.report.contents.tip_check import tip_check_report
from app.report.contents.verification import verification_report
from app.report.html import html_page
from app.report.translation import translate_report

KINDS = (
    (VERIFICATION, verification_report),
    (ARM_CHECK, arm_check_report),
    (TIP_CHECK, tip_check_report),
    (IDENTIFIED, identification_report),
    (CALIBRATION, calibration_report),
)


def _pdf(report: Report) -> bytes:
    from app.report.pdf import pdf_document  # the PDF library is loaded by who prints

    return pdf_document(report)


FORMS = {".html": html_page, ".pdf": _pdf}


def folder_report(folder: Path) -> Report:
    """The report on whatever a folder records.

    Raises:
        Refusal: it records nothing that has a report, or a file of it is missing or damaged.
    """
    for name, report in KINDS:
        if (folder / name).is_file():
            return report(folder)
    there = "it holds no record of one" if folder.is_dir() else "there is no such folder"
    raise OperationError(
        "no-record",
        display_path(folder),
        there,
        f"Name the folder of a calibration, a check or a verification: it has one of "
        f"{', '.join(name for name, _ in KINDS)}",
    )


def render_report(folder: Path, suffix: str, language: str = "en") -> bytes:
    """The report on a folder as ``.html`` or ``.pdf``, the same bytes for the same files.

    Raises:
        Refusal: as ``folder_report``, or for another ``suffix`` or an unknown ``language``.
    """
    form = FORMS.get(suffix.lower())
    if form is None:
        raise OperationError(
            "report-form",
            f"a report cannot be written as '{suffix}'",
            remedy=f"End the name with {' or '.join(FORMS)}",
        )
    return form(translate_report(folder_report(folder), language))
