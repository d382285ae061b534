"""Records and files that an address names; ``NotFoundError`` where there is none."""

from pathlib import Path
from typing import TypeVar

from starlette.responses import FileResponse, Response

from crenel.api.answers.problems import NotFoundError
from crenel.errors import OperationError
from crenel.formats.io_errors import convert_io_errors
from crenel.formats.open_file import open_file
from crenel.messages.message import Text, message
from crenel.operations.context import Context
from crenel.store.calibrations import CalibrationRecord
from crenel.store.scans import ScanRecord
from crenel.store.session_records import InspectionRecord, PerformanceRecord, VerificationRecord

Record = TypeVar("Record")


def find_calibration(context: Context, record_id: str) -> CalibrationRecord:
    """An accepted calibration."""
    missing = message("there-no-calibration", calibration_id=record_id)
    return _present(context.store.calibrations.get(record_id), missing)


def find_scan(context: Context, record_id: str) -> ScanRecord:
    """A scan."""
    return _present(context.store.scans.get(record_id), message("there-no-scan", scan_id=record_id))


def find_verification(context: Context, record_id: str) -> VerificationRecord:
    """An accepted verification."""
    missing = message("there-no-verification", record_id=record_id)
    return _present(context.store.verifications.get(record_id), missing)


def find_performance(context: Context, record_id: str) -> PerformanceRecord:
    """A performance test."""
    missing = message("there-no-performance", record_id=record_id)
    return _present(context.store.performances.get(record_id), missing)


def find_inspection(context: Context, record_id: str) -> InspectionRecord:
    """A finished inspection of a part."""
    missing = message("there-no-inspection", record_id=record_id)
    return _present(context.store.inspections.get(record_id), missing)


def _present(record: Record | None, missing: Text) -> Record:
    if record is None:
        raise NotFoundError(missing)
    return record


def check_not_recorded(context: Context, scan_id: str, what: Text) -> None:
    """Raises ``OperationError`` while this scan is being recorded: ``what`` cannot be done now."""
    state = context.scanner.state()
    if state.scan_id == scan_id and state.state in ("running", "stopping"):
        raise OperationError("busy", what, message("being-recorded"), message("stop-scan-first"))


def send_file(
    path: Path | None, missing: Text, media_type: str, name: str = "", cached: bool = False
) -> Response:
    """A file of the data folder to look at, or where it is named to download.

    Args:
        missing: the text where there is no ordinary file.

    Raises:
        NotFoundError: there is none.
        OperationError: it cannot be read.
    """
    if path is None or not path.is_file():
        raise NotFoundError(missing)
    with convert_io_errors(path):
        open_file(path).close()
    headers = {"Cache-Control": "private"} if cached else None
    return FileResponse(path, media_type=media_type, filename=name or None, headers=headers)
