"""What the operator sets of the laser's line, and the pictures of a session looked at by it."""

from crenel.errors import OperationError
from crenel.formats.images import read_grey
from crenel.formats.settings.line_settings import SessionLine
from crenel.guide.calibration.guide import CalibrationGuide
from crenel.guide.calibration.outcome import to_payload
from crenel.guide.calibration.poses.detection import PosePictures, detect_in_pictures
from crenel.guide.calibration.state import PoseCapture
from crenel.guide.common.arguments import Args
from crenel.messages.message import message
from crenel.metrology.stripe import check_settings
from crenel.station.jobs import Progress


def set_line(guide: CalibrationGuide, args: Args, key: str | None) -> None:
    """Sets what the line is like, and the zones of the station's picture, for the session.

    Raises:
        OperationError: the settings contradict each other, or the folder does not take them.
    """
    mask = guide.station.preview.mask
    line = SessionLine.model_validate({**args, "mask": None if mask is None else mask.fields()})
    check_settings(line.stripe)
    guide.folder.keep_line(line)
    guide.append("line_set", {"line": dict(args)}, key)


def look_again(guide: CalibrationGuide, progress: Progress) -> None:
    """Looks at all pictures of the session again, by what is set of the line now."""
    captures = guide.state.listed
    for done, capture in enumerate(captures):
        progress(message("looked-pose", number=capture.number), done / len(captures))
        _look(guide, capture)


def _look(guide: CalibrationGuide, capture: PoseCapture) -> None:
    """Records what a pose's pictures show; a picture that cannot be read stays as it was."""
    folder, chosen = guide.folder, guide.datasheets.selection(guide.state)
    try:
        ambient = read_grey(folder.path / capture.ambient)
        laser = None if capture.laser is None else read_grey(folder.path / capture.laser)
    except OperationError as error:
        guide.station.bus.event("refused", error.text, "attention")
        return
    pictures = PosePictures(ambient, laser, capture.lighting)
    outcome, seen = detect_in_pictures(pictures, chosen, capture.number, folder.line())
    guide.append("looked_again", {"number": capture.number, "outcome": to_payload(outcome)})
    guide.detections.keep(guide.state.session_id, capture.number, seen)
