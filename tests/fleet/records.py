"""Records of every kind in a data folder, each as its own part of the program writes it."""

from pathlib import Path

from app.formats.json_document import SOFTWARE
from app.formats.performance.plan import RESULT
from app.formats.recording.reader import (
    ARM_SERIAL,
    SCAN_CALIBRATION,
    SCAN_NAME,
    SCAN_STARTED,
    SENSOR_SERIAL,
)
from app.formats.recording.writer import RecordingWriter
from app.formats.results.acceptance import ACCEPTANCE, Acceptance
from app.formats.results.arm_checks import ARM_CHECK, TIP_CHECK, ArmCheckFile, TipCheckFile
from app.formats.results.calibration import CALIBRATION
from app.formats.results.verification import VERIFICATION, VerificationFile
from app.store.scans import ScanRecord
from app.store.store import Store
from tests.archive.filled import add_session
from tests.formats.performance_builders import plane_result
from tests.formats.test_documents import calibration_file, judged_file
from tests.workflows.test_verification import RECORD

CALIBRATION_ID = "20260501-090000-cd34"
PLY = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
POINTS = "property float z\nend_header\n0 0 0\n0 0 1\n0 1 0\n"


def add_calibration(store: Store, record_id: str = CALIBRATION_ID, total_um: float = 23.0) -> None:
    """A calibration that was put to use."""
    folder = add_session(store, "calibration", record_id, ended=False)
    judged_file().write(folder / CALIBRATION)
    Acceptance.model_validate(
        {
            "name": "Calibration of May",
            "accepted_at": "2026-05-01T09:20:00Z",
            "operator": "Ada",
            "calibration_sha256": "0" * 64,
            "usable_um": 60.0,
            "temperature_c": 20.5,
        }
    ).write(folder / ACCEPTANCE)
    store.calibrations.accept(
        record_id,
        "Calibration of May",
        folder / CALIBRATION,
        {
            "total_um": total_um,
            "verdict": "good",
            "arm_serial": "A-17",
            "object_serial": "",
            "sensor_serial": "L-3",
        },
        None,
    )


def add_recorded_scan(
    store: Store, scan_id: str, label: str, started_at: str = "2026-05-04T11:15:00Z"
) -> None:
    """A scan with a recording that describes itself, and a cloud of three points."""
    folder = store.folder / "scans" / scan_id
    folder.mkdir()
    about = {
        SCAN_NAME: "Scan 1",
        SCAN_STARTED: started_at,
        SCAN_CALIBRATION: CALIBRATION_ID,
        ARM_SERIAL: "A-17",
        SENSOR_SERIAL: "L-3",
    }
    with RecordingWriter(folder / "scan.mcap", ("J1",), about):
        pass
    (folder / "cloud.ply").write_text(PLY + POINTS)
    store.scans.add(ScanRecord(scan_id, label, folder, started_at, 3, 5, 1.0, CALIBRATION_ID))


def add_checks(store: Store) -> None:
    """A verification, a performance test, an arm check and a tip check."""
    folder = add_session(store, "verification", "20260502-100000-aa11")
    VerificationFile.model_validate(RECORD).write(folder / VERIFICATION)
    calibration_file().write(folder / CALIBRATION)
    folder = add_session(store, "performance", "20260503-100000-bb22")
    plane_result(folder).write(folder / RESULT)
    about = {
        "checked_at": "2026-05-04T07:30:00+00:00",
        "operator": "Ben",
        "arm_name": "Arm 6-1200",
        "arm_serial": "A-17",
        "limit_um": 60.0,
        "software": SOFTWARE,
    }
    folder = add_session(store, "arm", "20260504-073000-cc33")
    ArmCheckFile.model_validate(
        {
            **about,
            "points": 40,
            "half_range_um": (20.0, 71.0, 30.0),
            "two_sigma_um": (15.0, 40.0, 20.0),
            "encoders_two_sigma_um": (10.0, 10.0, 10.0),
            "largest_um": 83.4,
            "verdict": "bad",
        }
    ).write(folder / ARM_CHECK)
    folder = add_session(store, "arm", "20260504-080000-dd44")
    TipCheckFile.model_validate(
        {
            **about,
            "sphere_mm": 25.0,
            "touches": 9,
            "diameter_mm": 5.9,
            "expected_mm": 6.0,
            "error_um": -100.0,
            "expanded_uncertainty_um": 20.0,
            "scatter_um": 12.0,
            "decision": "fail",
            "words": "The tip is worn.",
        }
    ).write(folder / TIP_CHECK)
    add_session(store, "arm", "20260504-090000-ee55")


def add_every_kind(store: Store) -> None:
    """All of these, and one scan."""
    add_calibration(store)
    add_checks(store)
    add_recorded_scan(store, "20260504-111500", "Housing 4711")


def archive_folder(tmp_path: Path) -> Path:
    folder = tmp_path / "archive"
    folder.mkdir(exist_ok=True)
    return folder
