"""Checks that a recording contains a scan, and belongs to its calibration and arm."""

from crenel.errors import OperationError
from crenel.formats.file_names import display_path
from crenel.formats.recording.reader import Recording
from crenel.formats.recording.topics import (
    IMAGE_TOPIC,
    JOINTS_TOPIC,
    POSE_TOPIC,
    STRIPE_TOPIC,
    split_topic,
)
from crenel.formats.results.calibration import Calibration
from crenel.messages.message import Text, message, word
from crenel.metrology.arm.kinematics import AnyArm


def check_content(recording: Recording, frames: int, joint_samples: int) -> Text:
    """The name of a recording in messages; refuses one that contains no scan."""
    topics = recording.topics
    known = {split_topic(topic)[0] for topic in topics}
    if not recording.cut and not {JOINTS_TOPIC, POSE_TOPIC, IMAGE_TOPIC, STRIPE_TOPIC} & known:
        raise OperationError(
            "recording-foreign",
            message(
                "holds-topics", path=display_path(recording.path), topics=", ".join(sorted(topics))
            )
            if topics
            else message("holds-no-topics", path=display_path(recording.path)),
            message(
                "scan-has",
                joints_topic=JOINTS_TOPIC,
                image_topic=IMAGE_TOPIC,
                stripe_topic=STRIPE_TOPIC,
            ),
        )
    named = recording.cut or display_path(recording.path)
    if not frames:
        raise OperationError("recording-without-frames", message("no-frames", named=named))
    if not joint_samples:
        raise OperationError("recording-without-joints", message("no-joint-angles", named=named))
    return named


def check_station(
    recording: Recording, calibration: Calibration, arm: AnyArm, sensor: str = ""
) -> None:
    """Refuses a recording of another sensor than the calibration's, or of another arm.

    ``sensor``: its name in the recording.
    """
    serials = calibration.serial_numbers
    for device, recorded, known in (
        ("sensor", recording.serial_of(sensor), serials.sensor),
        ("arm", recording.station.get("arm_serial", ""), arm.serial_number),
    ):
        if recorded and known and recorded != known:
            raise OperationError(
                f"{device}-of-another-serial",
                message(
                    "taken",
                    path=display_path(recording.path),
                    device=word(device),
                    recorded=recorded,
                ),
                message("the-is-for", device=device, known=known),
                message("give-files-belong-together"),
            )


def check_serials(calibration: Calibration, arm: AnyArm) -> None:
    """Refuses an arm model of another arm than the calibration's."""
    known = calibration.serial_numbers.arm
    if known and arm.serial_number and known != arm.serial_number:
        raise OperationError(
            "arm-of-another-serial",
            message("arm-model-arm", serial_number=arm.serial_number),
            message("calibration-arm", known=known),
            message("give-files-belong-together"),
        )
