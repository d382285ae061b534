"""What a calibration does at a step: confirming it, taking the picture, and solving."""

from crenel.errors import OperationError
from crenel.formats.datasheets.sensor import SelectedPart
from crenel.guide.calibration.flow import HEADINGS
from crenel.guide.calibration.guide import CalibrationGuide
from crenel.guide.calibration.outcome import from_payload, to_payload
from crenel.guide.calibration.poses.advice import to_payload as to_advice
from crenel.guide.calibration.poses.board_views import next_view
from crenel.guide.calibration.poses.detection import detect_in_capture
from crenel.guide.calibration.poses.next_pose import advise
from crenel.guide.calibration.solve import solve
from crenel.guide.calibration.state import CAMERA
from crenel.guide.common.journal import error_payload
from crenel.messages.message import message
from crenel.station.jobs import Progress
from crenel.workflows.calibrate import LaserUse

CONFIRMATIONS = {
    "confirm_devices": "devices_confirmed",
    "confirm_setup": "setup_confirmed",
    "confirm_touch": "touch_confirmed",
    "confirm_place": "place_confirmed",
    "keep_picture": "capture_kept",
}


def confirm(guide: CalibrationGuide, name: str, key: str | None) -> None:
    """Confirms a step; from the set-up on, the session uses its own datasheet copies."""
    with guide.lock:
        if name == "confirm_setup":
            guide.folder.keep_datasheets(guide.datasheets.library(True), guide.state.choices)
            guide.keep_camera()
        guide.append(CONFIRMATIONS[name], {}, key)
        if name == "confirm_devices":
            guide.choose_for_connected()
        arm = guide.datasheets.selection(guide.state).arm
        touches_nothing = (arm is not None and arm.tip is None) or guide.state.choices.get(CAMERA)
        if name == "confirm_setup" and touches_nothing:
            guide.append("touch_confirmed", {})
        guide.station.bus.event("step_done", message("next", title=HEADINGS[guide.state.step]))


def capture(guide: CalibrationGuide, progress: Progress) -> None:
    """Takes the pictures while the arm is still, and looks at once whether they will do.

    Raises:
        OperationError: the arm moved, or a device is lost; nothing is kept then.
    """
    progress(message("taking-picture"), 0.1)
    chosen = guide.datasheets.selection(guide.state)
    # a chessboard without the laser's line serves camera and mounting
    taken = guide.station.rig.capture_pair(needs_laser=chosen.board is None)
    progress(message("looking-object-picture"), 0.4)
    number = len(guide.state.captures) + 1
    with guide.station.preview.resting():  # this picture is what counts now
        outcome, seen = detect_in_capture(taken, chosen, number, guide.folder.line())
    height, width = taken.ambient.image.shape
    with guide.lock:
        names = guide.folder.keep_capture(number, taken)
        guide.folder.keep_selected(_colour_taken(guide))
        guide.append(
            "image_captured",
            {
                **names,
                "lighting": taken.lighting,
                "reading": taken.joints.reading.tolist(),
                "scatter": taken.joints.scatter.tolist(),
                "samples": taken.joints.samples,
                "exposure_us": taken.ambient.exposure_us,
                "width_px": width,
                "height_px": height,
                "outcome": to_payload(outcome),
            },
        )
        guide.detections.keep(guide.state.session_id, number, seen)
        guide.folder.keep_contacts(guide.state.counted)
        guide.folder.keep_images(guide.state.pictures)
        guide.station.bus.event("step_done", message("pose-taken", number=number), "good")
    progress(message("working-out-which-pose-would-help"), 0.7)
    keep_advice(guide)


def _colour_taken(guide: CalibrationGuide) -> SelectedPart | None:
    """What the driver takes of a colour camera's pictures."""
    info = guide.station.rig.sensor.info
    if info is None or info.selected is None:
        return None
    return SelectedPart(colour=info.selected.colour, bayer=info.selected.bayer)


def keep_advice(guide: CalibrationGuide) -> None:
    """Keeps which pose to take next; where the poses cannot be solved, why."""
    inputs, board = guide.state.inputs, guide.datasheets.selection(guide.state).board
    if board is not None and next_view(guide.state.listed) is not None:
        return  # the next view is planned, whatever was found
    if guide.state.choices.get(CAMERA):
        return  # which pose would help camera and mounting is of no use
    try:
        advice = advise(guide.folder, guide.pose_detections(), guide.limits)
    except OperationError as error:
        pictures = guide.state.pictures
        known = guide.pose_detections()
        unusable = any(isinstance(known.get(one.number), OperationError) for one in pictures)
        newest = from_payload(pictures[-1].outcome).findings if pictures else ()
        shown = any(finding.quality == "bad" for finding in newest)
        if not (unusable or shown):
            _record_failure(guide, inputs, error)
        return
    if advice is not None:
        guide.append("advised", {"inputs": inputs, "advice": to_advice(advice)})


def calibrate(guide: CalibrationGuide, progress: Progress, laser: LaserUse = "auto") -> None:
    """Solves from the session's folder, exactly as the command line does."""
    with guide.lock:
        state = guide.state
        guide.folder.keep_contacts(state.counted)
        guide.folder.keep_images(state.pictures)
        in_use = guide.calibrations.active(guide.station.rig.selected)
    known, points = guide.pose_detections(), [contact.index for contact in state.counted]
    try:
        outcome = solve(guide.folder, in_use, progress, known, guide.limits, points, laser)
    except OperationError as error:
        _record_failure(guide, state.inputs, error)
        return
    guide.append("solved", {"inputs": state.inputs, "outcome": to_payload(outcome)})
    guide.station.bus.event("step_done", message("calibration-computed"), "good")


def _record_failure(guide: CalibrationGuide, inputs: str, error: OperationError) -> None:
    guide.append("solve_refused", {"inputs": inputs, **error_payload(error)})
    guide.station.bus.event("refused", error.text, "bad")
