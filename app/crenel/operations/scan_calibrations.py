"""By which calibrations a scan was made: as its recording states them, or else as it is listed."""

from crenel.errors import OperationError
from crenel.formats.recording.reader import SCAN_CALIBRATION, open_recording
from crenel.formats.recording.topics import sensor_values
from crenel.formats.session.calibration_session import ARM
from crenel.messages.message import message
from crenel.station.scan.storage import RECORDING
from crenel.station.view3d.elements.picked_scans import ScanOrigin
from crenel.store.calibrations import CalibrationRecord
from crenel.store.scans import ScanRecord
from crenel.store.store import Store


def scan_calibrations(store: Store, scan: ScanRecord) -> dict[str, CalibrationRecord]:
    """The calibration of each sensor of a scan, by its name; empty of the only one.

    Raises:
        OperationError: its recording cannot be read, or a calibration is not on this station.
    """
    metadata = open_recording(scan.folder / RECORDING).station_metadata()
    stated = sensor_values(metadata, SCAN_CALIBRATION)
    ids = {name: one for name, one in stated.items() if name} or {"": scan.calibration_id}
    records = {name: store.calibrations.get(one) for name, one in ids.items()}
    found = {name: record for name, record in records.items() if record is not None}
    if len(found) < len(ids):
        raise OperationError("no-calibration", message("calibration-known-here"))
    return found


def find_scan_source(store: Store, scan_id: str) -> ScanOrigin:
    """The files by which a scan was made, where they are on this station."""
    scan = store.scans.get(scan_id)
    if scan is None:
        return ScanOrigin()
    if scan.sources:
        return ScanOrigin(is_merged=True)
    try:
        found = scan_calibrations(store, scan)
    except OperationError:
        return ScanOrigin()
    files = [found[name].file for name in sorted(found)]
    return ScanOrigin([(file, file.parent / ARM) for file in files])
