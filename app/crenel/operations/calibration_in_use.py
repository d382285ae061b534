"""The calibration in use: read from its files, and checked while it is in use."""

from functools import lru_cache
from pathlib import Path

from crenel.errors import OperationError
from crenel.formats.datasheets.arm import read_any_arm
from crenel.formats.file_names import display_path
from crenel.formats.results.calibration import NO_PLANE, CalibrationFile, calibration_from_document
from crenel.formats.session.calibration_session import ARM
from crenel.messages.message import Text, message
from crenel.station.bus import Bus
from crenel.station.devices.rig import Rig
from crenel.station.preview.preview import Preview
from crenel.station.scan.points import ScanCalibration
from crenel.station.scan.scanner import Scanner
from crenel.station.working_distance import WorkingRange
from crenel.store.calibrations import CalibrationRecord
from crenel.store.store import Store
from crenel.workflows.compatibility import check_serials

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


def use_calibration(
    name: str, store: Store, rig: Rig, preview: Preview, scanner: Scanner, bus: Bus
) -> None:
    """Makes the active calibration of a sensor the one for scans."""
    record, is_shown = store.calibrations.active(name), name == rig.selected
    if is_shown:
        preview.set_calibration(None)
    if record is None:
        scanner.set_calibration(None, _unreadable(store, name), sensor=name)
        return
    try:
        calibration = scan_calibration(record)
    except OperationError as error:
        text = message("calibration-in-use-unreadable", error=error.text)
        bus.event("refused", text, "bad")
        scanner.set_calibration(None, _scan_refusal(error), sensor=name)
        return
    rig.arm.set_model(calibration.arm)
    scanner.set_calibration(calibration, look=lambda: calibration_error(record), sensor=name)
    if not is_shown:
        return
    preview.set_stripe_axis(calibration.stripe_axis)
    preview.set_calibration(
        WorkingRange(
            calibration.camera,
            calibration.plane,
            calibration.depth_range_mm,
            calibration.stripe_axis,
        )
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
        return _scan_refusal(error)
    return None


def _scan_refusal(error: OperationError) -> OperationError:
    """Why nothing can be scanned with a calibration, by what its files lack."""
    return error if error.code == NO_PLANE else unreadable_calibration_error(error.text)


def _stamp(path: Path) -> Stamp:
    try:
        there = path.stat()
    except OSError:
        return None
    return there.st_dev, there.st_size, there.st_mtime_ns


def _unreadable(store: Store, sensor: str) -> OperationError | None:
    """Why there is none although one was accepted."""
    active = next(
        (one for one in store.calibrations.unreadable() if one.active and one.sensor == sensor),
        None,
    )
    return (
        None
        if active is None
        else unreadable_calibration_error(message("no-readable-figures", name=active.name))
    )
