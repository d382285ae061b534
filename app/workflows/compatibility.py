"""Whether a recording holds a scan, and belongs to the calibration and the arm given with it."""

from app.errors import OperationError
from app.formats.file_names import display_path
from app.formats.recording.reader import IMAGE_TOPIC, JOINTS_TOPIC, STRIPE_TOPIC, Recording
from app.formats.results.calibration import Calibration
from app.metrology.arm.kinematics import Arm


def check_content(recording: Recording, frames: int, joint_samples: int) -> str:
    """What a recording that was read is called; refuses one that holds no scan."""
    topics = recording.topics
    if not recording.cut and not {JOINTS_TOPIC, IMAGE_TOPIC, STRIPE_TOPIC} & topics:
        raise OperationError(
            "recording-foreign",
            f"{display_path(recording.path)} holds {', '.join(sorted(topics)) or 'no topics'}",
            f"a scan has {JOINTS_TOPIC} and {IMAGE_TOPIC} or {STRIPE_TOPIC}",
        )
    named = recording.cut or display_path(recording.path)
    if not frames:
        raise OperationError("recording-without-frames", f"{named}: no frames")
    if not joint_samples:
        raise OperationError("recording-without-joints", f"{named}: no joint angles")
    return named


def check_station(recording: Recording, calibration: Calibration, arm: Arm) -> None:
    """Refuses a recording of another sensor than the calibration's, or of another arm."""
    serials = calibration.serial_numbers
    for device, recorded, known in (
        ("sensor", recording.station.get("sensor_serial", ""), serials.sensor),
        ("arm", recording.station.get("arm_serial", ""), arm.serial_number),
    ):
        if recorded and known and recorded != known:
            raise OperationError(
                f"{device}-of-another-serial",
                f"{display_path(recording.path)} was taken with {device} {recorded}",
                f"the {'calibration' if device == 'sensor' else 'arm.json'} is for {known}",
                "Give the files that belong together",
            )


def check_serials(calibration: Calibration, arm: Arm) -> None:
    """Refuses an arm's model that is of another arm than the calibration's."""
    known = calibration.serial_numbers.arm
    if known and arm.serial_number and known != arm.serial_number:
        raise OperationError(
            "arm-of-another-serial",
            f"the arm model is of arm {arm.serial_number}",
            f"the calibration is for arm {known}",
            "Give the files that belong together",
        )
