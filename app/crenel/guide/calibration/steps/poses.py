"""The poses as they are looked at: each picture, what was found in it, what became of it. Pure."""

from collections.abc import Mapping
from typing import Literal

from crenel.guide.calibration.live import CalibrationLive
from crenel.guide.calibration.outcome import CalibrationOutcome
from crenel.guide.calibration.rules import offer
from crenel.guide.calibration.state import CalibrationState, PoseCapture
from crenel.guide.common.result_view import PoseRow
from crenel.guide.common.view import Action, PosePicture
from crenel.messages.message import Text, message, word


def pose_pictures(
    state: CalibrationState, live: CalibrationLive, solved: CalibrationOutcome | None = None
) -> list[PosePicture]:
    """All poses that were taken for what is chosen, those set aside too.

    Args:
        solved: the result that they are shown with; None before there is one.
    """
    query = f"?session={state.session_id}"
    return [
        _pose(
            capture,
            f"/api/flow/image/{_file_name(capture)}{query}",
            live.capture_outcomes.get(capture.number),
            solved,
            None if state.ended else _action(state, live, capture),
            f"/api/flow/picture/{capture.number}.zip{query}",
        )
        for capture in state.listed
    ]


def past_pose_pictures(
    state: CalibrationState,
    looked_at: Mapping[int, CalibrationOutcome],
    solved: CalibrationOutcome,
    image_url: str,
) -> list[PosePicture]:
    """The same of a session that is over, whose pictures are at ``image_url``."""
    return [
        _pose(capture, image_url + _file_name(capture), looked_at.get(capture.number), solved, None)
        for capture in state.listed
    ]


def _file_name(capture: PoseCapture) -> str:
    return capture.ambient.rsplit("/", 1)[-1]


def _pose(
    capture: PoseCapture,
    image_url: str,
    looked_at: CalibrationOutcome | None,
    solved: CalibrationOutcome | None,
    action: Action | None,
    bundle_url: str = "",
) -> PosePicture:
    rows = solved.result.poses if solved and solved.result else ()
    row = next((one for one in rows if one.number == capture.number), None)
    drawings = solved.poses if solved else ()
    drawing = next((one for one in drawings if one.number == capture.number), None)
    found = drawing or looked_at
    used = row is not None and row.used and not capture.gone
    note = _note(capture, row, looked_at)
    return PosePicture(
        number=capture.number,
        state=_state(capture, row),
        note=note,
        image_url=image_url,
        width_px=capture.width_px,
        height_px=capture.height_px,
        corners=found.corners if found else (),
        outline=found.outline if found else (),
        stripe=found.stripe if found else (),
        marks=looked_at.marks if looked_at else (),
        edges_rms_px=row.edges_rms_px if row and used else None,
        stripe_rms_px=row.stripe_rms_px if row and used else None,
        off_um=row.off_um if row and used else None,
        action=action,
        stripe_off=drawing.stripe_off if drawing else (),
        bundle_url=bundle_url if note and not capture.gone else "",
    )


def _state(
    capture: PoseCapture, row: PoseRow | None
) -> Literal["taken", "used", "left_out", "aside"]:
    if capture.gone:
        return "aside"
    if row is None:
        return "taken"
    return "used" if row.used else "left_out"


def _note(capture: PoseCapture, row: PoseRow | None, looked_at: CalibrationOutcome | None) -> Text:
    """Why the pose, or its laser line, does not count; empty where both do."""
    if capture.gone:
        return message("pose-is-set-aside")
    if row is not None and row.reason:
        return (
            message("used-but", reason=row.reason)
            if row.used
            else message("left-out", reason=row.reason)
        )
    bad = looked_at is not None and any(f.quality == "bad" for f in looked_at.findings)
    if row is not None or looked_at is None or not bad:
        return ""
    fault = looked_at.fault
    return message("not-usable-because", fault=word(fault)) if fault else message("not-usable")


def _action(state: CalibrationState, live: CalibrationLive, capture: PoseCapture) -> Action:
    args = {"number": capture.number}
    if capture.gone:
        return offer(state, live, "restore_pose", message("take-back"), args)
    return offer(state, live, "void_pose", message("set-aside"), args)
