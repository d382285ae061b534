"""The calibration in use: read from its files, and checked while it is in use."""

from functools import lru_cache
from pathlib import Path

from app.errors import OperationError
from app.formats.datasheets.arm import read_any_arm
from app.formats.file_names import display_path
from app.formats.results.calibration import CalibrationFile, calibration_from_document
from app.formats.session.calibration_session import ARM
from app.messages.message import Text, message
from app.station.scan.points import ScanCalibration
from app.store.calibrations import CalibrationRecord
from app.workflows.compatibility import check_serials

Stamp = tuple[int, int, int] | None
"""State of a file: device, size and time of writing; None if it is missing."""
REMEMBERED = 16


def unreadable_calibration_error(why: Text) -> OperationError:
    """Why Home and scans cannot use a calibration whose files are unreadable."""
    return OperationError(
        "calibration-unreadable",
        message("calibration-use-cannot-read"),
        why,
        message("put-file-back-last-backup-restart"),
    )


def scan_calibration(record: CalibrationRecord) -> ScanCalibration:
    """An accepted calibration with the arm on which it was made.

    Raises:
        OperationError: one of its files cannot be read, or they do not belong together.
    """
    document = CalibrationFile.read(record.file)
    found = calibration_from_document(document)
    uncertainty = document.uncertainty
    if uncertainty is None:
        raise OperationError(
            "field-missing", message("uncertainty-missing", file=display_path(record.file))
        )
    arm = read_any_arm(record.file.parent / ARM)
    check_serials(found, arm)
    return ScanCalibration(
        id=record.id,
        name=record.name,
        arm=arm,
        camera=found.camera,
        plane=found.plane,
        T_flange_sensor=found.T_flange_sensor,
        stripe_axis=found.stripe_axis,
        arm_serial=record.figures.arm_serial,
        sensor_serial=record.figures.sensor_serial,
        depth_range_mm=uncertainty.depth_range_mm,
    )


def calibration_error(record: CalibrationRecord) -> OperationError | None:
    """Why the files of a calibration cannot be read any more; None if they can.

    They are read again only after a change, because this is called whenever Home is shown.
    """
    return _trouble(record, _stamp(record.file), _stamp(record.file.parent / ARM))


@lru_cache(maxsize=REMEMBERED)
def _trouble(record: CalibrationRecord, *stamps: Stamp) -> OperationError | None:
    try:
        scan_calibration(record)
    except OperationError as error:
        return unreadable_calibration_error(error.text)
    return None


def _stamp(path: Path) -> Stamp:
    try:
        there = path.stat()
    except OSError:
        return None
    return there.st_dev, there.st_size, there.st_mtime_ns
