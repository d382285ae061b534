"""Records of every kind in a data folder, each as its own part of the program writes it."""

from typing import Any

from crenel.formats.json_document import SOFTWARE
from crenel.formats.recording import reader
from crenel.formats.recording.writer import RecordingWriter
from crenel.formats.results.acceptance import ACCEPTANCE, Acceptance
from crenel.formats.results.arm_checks import ARM_CHECK, TIP_CHECK, ArmCheckFile, TipCheckFile
from crenel.formats.results.calibration import CALIBRATION
from crenel.gauges.plan.document import RESULT
from crenel.gauges.quick.document import VERIFICATION, VerificationFile
from crenel.store.scans import ScanRecord
from crenel.store.store import Store
from tests.archive.filled import add_session
from tests.formats.test_documents import calibration_file, judged_file
from tests.gauges.judgement.results import plane_result
from tests.gauges.quick.test_study import RECORD

CALIBRATION_ID = "20260501-090000-cd34"
STARTED_AT = "2026-05-04T11:15:00Z"
PLY = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
POINTS = "property float z\nend_header\n0 0 0\n0 0 1\n0 1 0\n"


def add_calibration(store: Store) -> None:
    folder = add_session(store, "calibration", CALIBRATION_ID, ended=False)
    judged_file().write(folder / CALIBRATION)
    name = "Calibration of May"
    accepted: dict[str, Any] = {"name": name, "accepted_at": "2026-05-01T09:20:00Z"}
    accepted |= {
        "operator": "Ada",
        "calibration_sha256": "0" * 64,
        "usable_um": 60.0,
        "temperature_c": 20.5,
    }
    Acceptance.model_validate(accepted).write(folder / ACCEPTANCE)
    figures: dict[str, Any] = {"total_um": 23.0, "verdict": "good", "object_serial": ""}
    figures |= {"arm_serial": "A-17", "sensor_serial": "L-3"}
    store.calibrations.accept(CALIBRATION_ID, name, folder / CALIBRATION, figures, None)


def add_recorded_scan(store: Store, scan_id: str, label: str) -> None:
    """A scan with a recording that describes itself, and a cloud of three points."""
    folder = store.folder / "scans" / scan_id
    folder.mkdir()
    about = {reader.SCAN_NAME: "Scan 1", reader.SCAN_STARTED: STARTED_AT}
    about |= {reader.SCAN_CALIBRATION: CALIBRATION_ID}
    about |= {reader.ARM_SERIAL: "A-17", reader.SENSOR_SERIAL: "L-3"}
    with RecordingWriter(folder / "scan.mcap", ("J1",), about):
        pass
    (folder / "cloud.ply").write_text(PLY + POINTS)
    store.scans.add(ScanRecord(scan_id, label, folder, STARTED_AT, 3, 5, 1.0, CALIBRATION_ID))


def add_checks(store: Store) -> None:
    folder = add_session(store, "verification", "20260502-100000-aa11")
    VerificationFile.model_validate(RECORD).write(folder / VERIFICATION)
    calibration_file().write(folder / CALIBRATION)
    folder = add_session(store, "performance", "20260503-100000-bb22")
    plane_result(folder).write(folder / RESULT)
    about: dict[str, Any] = {"checked_at": "2026-05-04T07:30:00+00:00", "operator": "Ben"}
    about |= {"arm_name": "Arm 6-1200", "arm_serial": "A-17"}
    about |= {"limit_um": 60.0, "software": SOFTWARE}
    arm_check = about | {"points": 40, "largest_um": 83.4, "verdict": "bad"}
    arm_check |= {"half_range_um": (20.0, 71.0, 30.0), "two_sigma_um": (15.0, 40.0, 20.0)}
    arm_check |= {"encoders_two_sigma_um": (10.0, 10.0, 10.0)}
    folder = add_session(store, "arm", "20260504-073000-cc33")
    ArmCheckFile.model_validate(arm_check).write(folder / ARM_CHECK)
    tip_check = about | {"sphere_mm": 25.0, "touches": 9, "diameter_mm": 5.9, "expected_mm": 6.0}
    tip_check |= {"error_um": -100.0, "expanded_uncertainty_um": 20.0, "scatter_um": 12.0}
    tip_check |= {"decision": "fail", "words": "The tip is worn."}
    folder = add_session(store, "arm", "20260504-080000-dd44")
    TipCheckFile.model_validate(tip_check).write(folder / TIP_CHECK)
    add_session(store, "arm", "20260504-090000-ee55")


def add_every_kind(store: Store) -> None:
    add_calibration(store)
    add_checks(store)
    add_recorded_scan(store, "20260504-111500", "Housing 4711")
