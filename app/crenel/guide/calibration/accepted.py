"""An accepted calibration, shown again as it was."""

from crenel.errors import OperationError
from crenel.findings import Finding
from crenel.formats.results.calibration import CalibrationFile
from crenel.guide.calibration.live import CameraCalibration
from crenel.guide.calibration.outcome import CalibrationOutcome, from_payload
from crenel.guide.calibration.session_folder import SessionFolder
from crenel.guide.calibration.state import CalibrationState, apply_row
from crenel.guide.calibration.steps.body import geometry
from crenel.guide.calibration.steps.poses import past_pose_pictures
from crenel.guide.calibration.touch.report import touch_report
from crenel.guide.common.journal import Journal, StoredCalibration, fold
from crenel.guide.common.view import ResultPicture
from crenel.messages.message import message
from crenel.metrology.limits import LIMITS


def restore_result(
    journal: Journal, folder: SessionFolder, session_id: str, image_url: str
) -> tuple[ResultPicture, list[Finding]]:
    """The result's picture and its findings.

    Args:
        image_url: the address of the session's pictures, to which their names are added.

    Raises:
        OperationError: the session was never solved, or its files cannot be read any more.
    """
    state, solved = _load_outcome(journal, session_id)
    chosen = folder.datasheets()
    if solved is None or solved.result is None or chosen.arm is None or chosen.object is None:
        raise OperationError(
            "record-incomplete",
            message("calibration-cannot-shown", session_id=session_id),
            message("files-no-longer-in-data-folder"),
            message("restore-sessions-folder-backup"),
        )
    touch = touch_report(state.counted, chosen.arm, chosen.object, LIMITS.good_um)
    picture = ResultPicture(
        result=solved.result,
        stale=False,
        object=geometry(chosen.object),
        points=solved.points or touch.points,
        poses=past_pose_pictures(state, _capture_outcomes(state), solved, image_url),
    )
    return picture, list(solved.findings)


def read_camera_calibration(stored: StoredCalibration) -> CameraCalibration | None:
    """A calibration of camera and mounting to which the laser can be added; None of another one."""
    try:
        document = CalibrationFile.read(stored.file)
    except OperationError:
        return None
    if document.laser_plane is not None or document.covariance is None:
        return None
    serial = document.serial_numbers
    return CameraCalibration(stored.id, stored.name, serial.arm, serial.sensor)


def _load_outcome(
    journal: Journal, session_id: str
) -> tuple[CalibrationState, CalibrationOutcome | None]:
    """How the session ended; without an outcome where its rows cannot be read."""
    try:
        state = fold(journal.rows(session_id), CalibrationState(), apply_row)
        return state, from_payload(state.solved.outcome) if state.solved else None
    except (ArithmeticError, AttributeError, LookupError, TypeError, ValueError):
        return CalibrationState(), None


def _capture_outcomes(state: CalibrationState) -> dict[int, CalibrationOutcome]:
    return {capture.number: from_payload(capture.outcome) for capture in state.captures}
