"""What the commands of a calibration take, and why one is not possible now. Pure.

An empty reason means that it is possible.
"""

from typing import Literal

from crenel.findings import Finding
from crenel.formats.settings.line_settings import Threshold, Width
from crenel.guide.calibration.live import CalibrationLive
from crenel.guide.calibration.poses.board_views import still_missing
from crenel.guide.calibration.state import CAMERA, DEVICE, STEPS, CalibrationState
from crenel.guide.calibration.touch.block import WRONG_FACE_MM
from crenel.guide.calibration.touch.report import face_names, where_on_object
from crenel.guide.common.arguments import (
    Args,
    Arguments,
    BackArguments,
    IndexArguments,
    NumberArguments,
    OperatorArguments,
    ShortText,
)
from crenel.guide.common.rules import Command, CommandRules, no_simulation_reason
from crenel.messages.message import Text, join, message, quantity, word
from crenel.messages.uncertainty import point_quantity
from crenel.metrology.arm.kinematics import AnyArm, Arm, RobotArm
from crenel.metrology.stripe import PeakChoice


def _devices(state: CalibrationState, live: CalibrationLive, args: Args) -> Text:
    return _arm_there(live) or _sensor_there(live)


def _arm_there(live: CalibrationLive) -> Text:
    return (
        "" if live.arm_link.state == "connected" else message("arm-says", text=live.arm_link.text)
    )


def _sensor_there(live: CalibrationLive) -> Text:
    return (
        ""
        if live.sensor_link.state == "connected"
        else message("sensor", text=live.sensor_link.text)
    )


def _choose(state: CalibrationState, live: CalibrationLive, args: Args) -> Text:
    field, chosen = args.get("field"), args.get("id")
    if not isinstance(field, str) or not isinstance(chosen, str):
        return message("choice-needs-field-id")
    if field == DEVICE:
        return _choose_device(state, live, chosen)
    if field == CAMERA:
        return "" if chosen in ("", _id_to_keep(live)) else message("calibration-not-kept-any-more")
    return (
        ""
        if live.library.has(field, chosen)
        else message("there-no-here", field=field, chosen=chosen)
    )


def _choose_device(state: CalibrationState, live: CalibrationLive, chosen: str) -> Text:
    if chosen not in (one.name for one in live.devices):
        return message("no-sensor-named", name=chosen)
    if state.captures and chosen != state.choices.get(DEVICE):
        return message("pictures-were-taken-with-other-sensor")
    return ""


def _id_to_keep(live: CalibrationLive) -> str:
    return live.without_laser.id if live.without_laser is not None else ""


def _setup(state: CalibrationState, live: CalibrationLive, args: Args) -> Text:
    chosen = live.chosen
    if chosen.arm is None or chosen.object is None or chosen.sensor is None:
        names = (("arm", chosen.arm), ("object", chosen.object), ("sensor", chosen.sensor))
        missing = [name for name, document in names if document is None]
        return message("choose-first", things=join([word(name) for name in missing]))
    if other := _other_kind(live, chosen.arm):
        return other
    if camera := state.choices.get(CAMERA):
        if camera != _id_to_keep(live):
            return message("calibration-not-kept-any-more")
        if chosen.board is None:
            return message("camera-and-laser-apart-on-a-board-only")
    if not isinstance(chosen.arm, Arm) and chosen.board is None:
        return message("choose-chessboard-for-poses", name=chosen.arm.name)
    size = (chosen.sensor.width_px, chosen.sensor.height_px)
    if live.sensor and size != (live.sensor.width_px, live.sensor.height_px):
        return message(
            "connected-sensors-picture-has-pixels-choose",
            width_px=live.sensor.width_px,
            height_px=live.sensor.height_px,
            name=chosen.sensor.name,
            size=size[0],
            size2=size[1],
        )
    return _others(live)


def _other_kind(live: CalibrationLive, arm: AnyArm) -> Text:
    """The connected arm reports something else than the chosen one."""
    if live.arm is None:
        return ""
    if live.arm.reports != arm.reading_kind:
        if live.arm.reports == "joints":
            return message("connected-arm-reports-joints-choose", name=arm.name)
        return message("connected-arm-reports-poses-choose", name=arm.name)
    if isinstance(arm, Arm) and live.arm.joint_count != arm.joint_count:
        return message(
            "connected-arm-has-joints-has-choose",
            connected_joints=live.arm.joint_count,
            name=arm.name,
            joint_count=arm.joint_count,
        )
    return ""


def _others(live: CalibrationLive) -> Text:
    others = other_devices(live)
    return join([others[0].text, others[0].remedy], " ") if others else ""


def other_devices(live: CalibrationLive) -> list[Finding]:
    """Connected devices that are not those of the chosen datasheets: nothing could be scanned
    with what is calibrated so. One that says no serial number cannot contradict."""
    chosen = live.chosen
    pairs = (("arm", live.arm, chosen.arm), ("sensor", live.sensor, chosen.sensor))
    return [
        Finding(
            "bad",
            message(
                "connected-has-serial-number-chosen-datasheet",
                name=word(name),
                serial_number=there.serial_number,
                serial_number2=document.serial_number,
            ),
            message("choose-datasheet-connect-other", name=word(name)),
        )
        for name, there, document in pairs
        if there is not None
        and document is not None
        and there.serial_number
        and document.serial_number
        and there.serial_number != document.serial_number
    ]


def _face(state: CalibrationState, live: CalibrationLive, args: Args) -> Text:
    item = live.chosen.object
    known = item is not None and args.get("face") in face_names(item)
    return "" if known else message("there-no-face", face=str(args.get("face")))


def _take(state: CalibrationState, live: CalibrationLive, args: Args) -> Text:
    if missing := _arm_there(live):
        return missing
    if live.chosen.arm is not None and live.chosen.arm.tip is None:
        return message("arm-without-tip-touches-nothing", name=live.chosen.arm.name)
    return "" if live.stillness.still else message("hold-arm-still", text=live.stillness.text)


def _undo(state: CalibrationState, live: CalibrationLive, args: Args) -> Text:
    return "" if state.counted else message("no-point-taken-yet")


def _redo(state: CalibrationState, live: CalibrationLive, args: Args) -> Text:
    return "" if state.undone else message("no-point-taken-back-since-last")


def _void(state: CalibrationState, live: CalibrationLive, args: Args) -> Text:
    known = any(contact.index == args.get("index") for contact in state.counted)
    return "" if known else message("point-no-longer-there")


def _touch(state: CalibrationState, live: CalibrationLive, args: Args) -> Text:
    touch = live.touch
    if touch is None:
        return message("arm-object-chosen-cannot-read-any")
    if live.chosen.board is None and touch.alignment is None:
        return touch.missing
    for point in touch.points:
        if point.outlier and abs(point.residual_um or 0.0) >= 1e3 * WRONG_FACE_MM:
            return message(
                "remove-point-first-not-there",
                index=point.index + 1,
                where=where_on_object(point.face),
            )
    return next(iter(touch.doubts.values()), "")


def _place(state: CalibrationState, live: CalibrationLive, args: Args) -> Text:
    return _arm_there(live) or _sensor_there(live)


def _capture(state: CalibrationState, live: CalibrationLive, args: Args) -> Text:
    if live.scanning:
        return message("scan-running-has-laser-stop-first")
    if missing := _place(state, live, args):
        return missing
    return "" if live.stillness.still else message("hold-arm-still", text=live.stillness.text)


def can_take_poses(live: CalibrationLive) -> bool:
    """Whether pictures can be taken by themselves: a robot states where it rests, and only a
    board needs no touch."""
    arm = live.chosen.arm
    return isinstance(arm, RobotArm) and arm.tip is None and live.chosen.board is not None


def _take_poses(state: CalibrationState, live: CalibrationLive, args: Args) -> Text:
    if not can_take_poses(live):
        return message("pictures-by-themselves-only-for-robot-and-board")
    return _place(state, live, args)


def _setup_and_poses(state: CalibrationState, live: CalibrationLive, args: Args) -> Text:
    return _setup(state, live, args) or _take_poses(state, live, args)


def _stop_poses(state: CalibrationState, live: CalibrationLive, args: Args) -> Text:
    return "" if live.taking_poses else message("no-pictures-by-themselves")


def _keep(state: CalibrationState, live: CalibrationLive, args: Args) -> Text:
    return "" if state.picture else message("there-no-picture-yet-take-one")


def _void_pose(state: CalibrationState, live: CalibrationLive, args: Args) -> Text:
    known = any(picture.number == args.get("number") for picture in state.pictures)
    if not known:
        return message("pose-no-longer-there")
    return "" if len(state.pictures) > 1 else message("only-pose-take-another-first")


def _restore_pose(state: CalibrationState, live: CalibrationLive, args: Args) -> Text:
    aside = [picture.number for picture in state.listed if picture.gone]
    return "" if args.get("number") in aside else message("pose-not-set-aside")


def _set_line(state: CalibrationState, live: CalibrationLive, args: Args) -> Text:
    least, most = args.get("min_width_px"), args.get("max_width_px")
    if isinstance(least, float) and isinstance(most, float) and least >= most:
        return message("line-widths-do-not-ascend")
    return "" if state.picture else message("there-no-picture-object-sensor-take")


def _solve(state: CalibrationState, live: CalibrationLive, args: Args) -> Text:
    if state.step == "review" and state.outcome is not None:
        return message("nothing-changed-since-solved")
    if not state.picture:
        return message("there-no-picture-object-sensor-take")
    looked_at = [live.capture_outcomes[picture.number] for picture in state.pictures]
    if all(seen.fault for seen in looked_at):
        return message("no-picture-shows-object-yet-take")
    if live.chosen.board is not None:
        usable = sum(len(seen.corners) > 0 for seen in looked_at)
        if missing := still_missing(usable):
            return missing
    return _touch(state, live, args)


def _solve_without_laser(state: CalibrationState, live: CalibrationLive, args: Args) -> Text:
    if live.chosen.board is None:
        return message("camera-and-laser-apart-on-a-board-only")
    if state.choices.get(CAMERA):
        return message("camera-and-mounting-are-kept")
    return _solve(state, live, args)


def _add_laser(state: CalibrationState, live: CalibrationLive, args: Args) -> Text:
    missing = state.ended != "accepted" or live.without_laser is None
    return message("calibration-not-kept-any-more") if missing else ""


def _accept(state: CalibrationState, live: CalibrationLive, args: Args) -> Text:
    seen = live.latest_outcome
    if seen is None or seen.result is None or state.outcome is None:
        return message("something-changed-since-solved-solve-again")
    if others := _others(live):
        return others
    result = seen.result
    if result.verdict != "bad":
        return ""
    if result.usable_um is not None and result.total_um > result.usable_um:
        return message(
            "usable-most",
            total=point_quantity(result.total_um),
            usable=quantity(result.usable_um, "µm"),
        )
    return message("not-to-be-used-findings-say-why")


def _back(state: CalibrationState, live: CalibrationLive, args: Args) -> Text:
    to = args.get("to", STEPS[max(STEPS.index(state.step) - 1, 0)])
    earlier = STEPS[: STEPS.index(state.step)]
    return "" if to in earlier else message("there-no-earlier-step", to=str(to))


class _Choice(Arguments):
    field: Literal["arm", "object", "sensor", "device", "camera"]
    id: ShortText


class _LineArguments(Arguments):
    """What is not given is automatic."""

    threshold: Threshold | None = None
    min_width_px: Width | None = None
    max_width_px: Width | None = None
    choice: PeakChoice = "continuity"


class _Face(Arguments):
    face: ShortText


RULES = CommandRules[CalibrationState, CalibrationLive](
    {
        "confirm_devices": Command(("devices",), _devices),
        "choose": Command(("setup",), _choose, _Choice),
        "confirm_setup": Command(("setup",), _setup),
        "select_face": Command(("touch",), _face, _Face),
        "take_point": Command(("touch",), _take),
        "undo": Command(("touch",), _undo),
        "redo": Command(("touch",), _redo),
        "void_point": Command(("touch",), _void, IndexArguments),
        "confirm_touch": Command(("touch",), _touch),
        "confirm_place": Command(("place",), _place),
        "capture": Command(("capture",), _capture),
        "keep_picture": Command(("place", "capture"), _keep),
        "another_pose": Command(("solve", "review")),
        "void_pose": Command(("solve", "review"), _void_pose, NumberArguments),
        "retake": Command(("solve", "review")),
        "restore_pose": Command(("solve", "review"), _restore_pose, NumberArguments),
        "set_line": Command(("solve",), _set_line, _LineArguments),
        "solve": Command(("solve", "review"), _solve),
        "solve_without_laser": Command(("solve", "review"), _solve_without_laser),
        "accept": Command(("review",), _accept),
        "back": Command(STEPS[1:], _back, BackArguments),
        "run_simulation": Command(STEPS[:-1], no_simulation_reason, OperatorArguments),
        "stop_simulation": Command(),
        "setup_and_poses": Command(("setup",), _setup_and_poses),
        "take_poses": Command(("place", "capture", "solve"), _take_poses),
        "stop_poses": Command(rule=_stop_poses, while_busy=True),
        "repeat": Command(when_closed=True),
        "add_laser": Command(rule=_add_laser, when_closed=True),
        "abandon": Command(),
    },
    closed=message("calibration-closed-start-new-one"),
    elsewhere=lambda step: message("belongs-another-step-calibration-stands", step=step),
)
offer = RULES.offer
