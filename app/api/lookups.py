"""Records by the ids in addresses."""

from app.api.problems import NotFoundError
from app.messages.message import message
from app.operations.context import Context
from app.store.calibrations import CalibrationRecord
from app.store.scans import ScanRecord


def find_calibration(context: Context, calibration_id: str) -> CalibrationRecord:
    """An accepted calibration; raises ``NotFoundError`` if there is none with this id."""
    record = context.store.calibrations.get(calibration_id)
    if record is None:
        raise NotFoundError(message("there-no-calibration", calibration_id=calibration_id))
    return record


def find_scan(context: Context, scan_id: str) -> ScanRecord:
    """A scan; raises ``NotFoundError`` if there is none with this id."""
    scan = context.store.scans.get(scan_id)
    if scan is None:
        raise NotFoundError(message("there-no-scan", scan_id=scan_id))
    return scan
