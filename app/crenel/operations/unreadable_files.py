"""Unreadable files of the data folder. They are excluded, and everything else is available."""

from collections.abc import Callable
from pathlib import Path

from crenel.archive.records import is_in_archive_only
from crenel.errors import OperationError
from crenel.formats.datasheets.arm import read_any_arm
from crenel.formats.io_errors import convert_all_errors
from crenel.formats.results.calibration import CalibrationFile
from crenel.formats.session.calibration_session import ARM
from crenel.gauges.judgement.document import PerformanceFile
from crenel.gauges.plan.document import RESULT
from crenel.gauges.quick.document import VERIFICATION, VerificationFile
from crenel.messages.message import Text, message
from crenel.operations.context import Context


def list_unreadable(context: Context) -> list[Text]:
    """One sentence for each. It reads every record, which may take seconds."""
    store = context.store
    reasons = [guide.unreadable_reason for guide in context.guides if guide.unreadable_reason]
    rows = store.unreadable_rows()
    if rows:
        first = rows[0]
        reasons.append(message("journal-has-rows-cannot-read-first", count=len(rows), first=first))
    reasons += [
        message("calibration-cannot-read", name=one.name) for one in store.calibrations.unreadable()
    ]
    reasons += [
        message("verification-cannot-read", one=one) for one in store.verifications.unreadable()
    ]
    reasons += [
        message("performance-cannot-read", one=one) for one in store.performances.unreadable()
    ]
    for record in store.calibrations.all():
        reasons += _reading_error(record.file, CalibrationFile.read)
        reasons += _reading_error(record.file.parent / ARM, read_any_arm)
    for verification in store.verifications.all():
        if is_in_archive_only(store.folder, "verifications", verification.folder.name):
            continue
        reasons += _reading_error(verification.folder / VERIFICATION, VerificationFile.read)
    for test in store.performances.all():
        away = is_in_archive_only(store.folder, "performance", test.folder.name)
        if test.figures.result != "cancelled" and not away:
            reasons += _reading_error(test.folder / RESULT, PerformanceFile.read)
    return reasons


def _reading_error(path: Path, read: Callable[[Path], object]) -> list[Text]:
    try:
        with convert_all_errors(path):
            read(path)
    except OperationError as error:
        return [error.text]
    return []
