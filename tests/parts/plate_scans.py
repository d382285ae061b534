"""A finished scan of the simulated plate in the data folder of a station."""

from pathlib import Path

from crenel.formats.datasheets.arm import read_any_arm
from crenel.formats.results.calibration import CalibrationFile, calibration_from_document
from crenel.formats.results.scan_record import CLOUD
from crenel.station.scan.storage import RECORDING
from crenel.store.scans import ScanRecord
from crenel.store.store import Store
from crenel.workflows.reconstruct import reconstruct_cloud
from tests.parts.simulated_inspection import (
    draw_station,
    draw_truth,
    plan_passes,
    scan_part,
    usual_passes,
    write_station,
)
from tests.parts.simulated_plate import Plate

PLATE = Plate()
FIGURES = {
    "total_um": 30.0,
    "verdict": "good",
    "arm_serial": "P-7",
    "object_serial": "B-1",
    "sensor_serial": "",
}


def add_plate_scan(store: Store, scan_id: str, links: bool = True, seed: int = 51) -> ScanRecord:
    """Lists a scan of the plate, with its recording, its cloud and its calibration.

    Args:
        links: whether the calibration states the errors of the arm's links.
    """
    session = f"calibration-{scan_id}"
    files = store.folder / "sessions" / session
    station = draw_station(4)
    write_station(files, station, links)
    store.journal.begin_session(session, "calibration")
    store.calibrations.accept(session, "Plate", files / "calibration.json", FIGURES, None)
    used = store.calibrations.active("")
    assert used is not None
    folder = store.folder / "scans" / scan_id
    folder.mkdir(parents=True)
    passes = plan_passes(station, usual_passes(PLATE), 2)
    scan_part(folder / RECORDING, PLATE, draw_truth(station, seed), passes, seed)
    made = reconstruct_cloud(
        folder / RECORDING,
        calibration_from_document(CalibrationFile.read(used.file)),
        read_any_arm(files / "arm.json"),
        folder / CLOUD,
    )
    scan = ScanRecord(
        scan_id,
        "Plate 1",
        folder,
        "2026-11-21T10:00:00+00:00",
        made.points,
        made.frames,
        made.seconds,
        used.id,
    )
    store.scans.add(scan)
    return scan


def forget_covariance(store: Store, scan: ScanRecord) -> None:
    """From here on the calibration of a scan has no covariance, as those of earlier versions."""
    record = store.calibrations.get(scan.calibration_id)
    assert record is not None
    document = CalibrationFile.read(record.file)
    document.model_copy(update={"covariance": None}).write(record.file)


def write_plate(path: Path) -> Path:
    """The drawing of the plate as binary STL."""
    from tests.parts.meshes import write_stl

    return write_stl(path, PLATE.corners())
