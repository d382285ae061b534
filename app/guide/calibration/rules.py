"""Why a command is not possible now; an empty answer means that it is. Pure."""

from collections.abc import Callable, Mapping

from app.findings import Finding
from app.guide.calibration.live import CalibrationLive
from app.guide.calibration.poses.board_views import still_missing
from app.guide.calibration.state import STEPS, CalibrationState
from app.guide.calibration.touch.block import WRONG_FACE_MM
from app.guide.calibration.touch.report import face_names

Args = Mapping[str, object]
Rule = Callable[[CalibrationState, CalibrationLive, Args], str]

ONLY_IN = {
    "confirm_devices": ("devices",),
    "choose": ("setup",),
    "confirm_setup": ("setup",),
    "select_face": ("touch",),
    "take_point": ("touch",),
    "undo": ("touch",),
    "redo": ("touch",),
    "void_point": ("touch",),
    "confirm_touch": ("touch",),
    "confirm_place": ("place",),
    "capture": ("capture",),
    "keep_picture": ("place", "capture"),
    "another_pose": ("solve", "review"),
    "void_pose": ("solve", "review"),
    "retake": ("solve", "review"),
    "restore_pose": ("solve", "review"),
    "solve": ("solve", "review"),
    "accept": ("review",),
    "back": ("setup", "touch", "place", "capture", "solve", "review"),
    "let_hand": ("devices", "setup", "touch", "place", "capture", "solve"),
}
ALWAYS = ("stop_hand", "repeat", "abandon")


def rejection_reason(state: CalibrationState, live: CalibrationLive, name: str, args: Args) -> str:
    """Why the command ``name`` cannot be done now; empty when it can."""
    if name not in ONLY_IN and name not in ALWAYS:
        return f"There is no command '{name}'."
    if name == "stop_hand":
        return "" if live.hand_running else "The hand is not moving."
    if live.busy is not None:
        return f"Wait: {live.busy.text[0].lower()}{live.busy.text[1:]}."
    if (state.ended or not state.session_id) and name != "repeat":
        return "This calibration is closed. Start a new one."
    if name in ONLY_IN and state.step not in ONLY_IN[name]:
        return f"This belongs to another step; the calibration stands at '{state.step}'."
    rule = RULES.get(name)
    return rule(state, live, args) if rule else ""


def _devices(state: CalibrationState, live: CalibrationLive, args: Args) -> str:
    return _arm_there(live) or _sensor_there(live)


def _arm_there(live: CalibrationLive) -> str:
    return "" if live.arm_link.state == "connected" else f"The arm: {live.arm_link.text}"


def _sensor_there(live: CalibrationLive) -> str:
    return "" if live.sensor_link.state == "connected" else f"The sensor: {live.sensor_link.text}"


def _choose(state: CalibrationState, live: CalibrationLive, args: Args) -> str:
    field, chosen = args.get("field"), args.get("id")
    if not isinstance(field, str) or not isinstance(chosen, str):
        return "A choice needs a field and an id."
    return "" if live.library.has(field, chosen) else f"There is no {field} '{chosen}' here."


def _setup(state: CalibrationState, live: CalibrationLive, args: Args) -> str:
    chosen = live.chosen
    if chosen.arm is None or chosen.object is None or chosen.sensor is None:
        names = (("arm", chosen.arm), ("object", chosen.object), ("sensor", chosen.sensor))
        missing = [name for name, sheet in names if sheet is None]
        return f"Choose the {' and the '.join(missing)} first."
    if live.arm and live.arm.joint_count != chosen.arm.joint_count:
        return (
            f"The connected arm has {live.arm.joint_count} joints, "
            f"{chosen.arm.name} has {chosen.arm.joint_count}. Choose the arm that is connected."
        )
    size = (chosen.sensor.width_px, chosen.sensor.height_px)
    if live.sensor and size != (live.sensor.width_px, live.sensor.height_px):
        return (
            f"The connected sensor's picture is {live.sensor.width_px} × {live.sensor.height_px}, "
            f"{chosen.sensor.name} has {size[0]} × {size[1]} pixels. "
            "Choose the sensor that is connected."
        )
    return _others(live)


def _others(live: CalibrationLive) -> str:
    return " ".join(f"{found.text} {found.remedy}" for found in other_devices(live)[:1])


def other_devices(live: CalibrationLive) -> list[Finding]:
    """Connected devices that are not those of the chosen datasheets: nothing could be scanned
    with what is calibrated so. One that says no serial number cannot contradict."""
    chosen = live.chosen
    pairs = (("arm", live.arm, chosen.arm), ("sensor", live.sensor, chosen.sensor))
    return [
        Finding(
            "bad",
            f"The connected {name} has the serial number {there.serial_number}, "
            f"the chosen datasheet is for {sheet.serial_number}.",
            f"Choose the datasheet of this {name}, or connect the other {name}.",
        )
        for name, there, sheet in pairs
        if there is not None
        and sheet is not None
        and there.serial_number
        and sheet.serial_number
        and there.serial_number != sheet.serial_number
    ]


def _face(state: CalibrationState, live: CalibrationLive, args: Args) -> str:
    item = live.chosen.object
    known = item is not None and args.get("face") in face_names(item)
    return "" if known else f"There is no face '{args.get('face')}'."


def _take(state: CalibrationState, live: CalibrationLive, args: Args) -> str:
    if missing := _arm_there(live):
        return missing
    return "" if live.stillness.still else f"Hold the arm still. {live.stillness.text}."


def _undo(state: CalibrationState, live: CalibrationLive, args: Args) -> str:
    return "" if state.counted else "No point was taken yet."


def _redo(state: CalibrationState, live: CalibrationLive, args: Args) -> str:
    return "" if state.undone else "No point was taken back since the last one was taken."


def _void(state: CalibrationState, live: CalibrationLive, args: Args) -> str:
    known = any(contact.index == args.get("index") for contact in state.counted)
    return "" if known else "That point is not there any more."


def _touch(state: CalibrationState, live: CalibrationLive, args: Args) -> str:
    touch = live.touch
    if touch is None:
        return "The arm or the object that was chosen cannot be read any more."
    if live.chosen.board is None and touch.alignment is None:
        return touch.missing
    for point in touch.points:
        if point.outlier and abs(point.residual_um or 0.0) >= 1e3 * WRONG_FACE_MM:
            return f"Remove point {point.index + 1} first: it is not on the {point.face} face."
    return ""


def _place(state: CalibrationState, live: CalibrationLive, args: Args) -> str:
    return _arm_there(live) or _sensor_there(live)


def _capture(state: CalibrationState, live: CalibrationLive, args: Args) -> str:
    if live.scanning:
        return "A scan is running and has the laser. Stop it first."
    if missing := _place(state, live, args):
        return missing
    return "" if live.stillness.still else f"Hold the arm still. {live.stillness.text}."


def _keep(state: CalibrationState, live: CalibrationLive, args: Args) -> str:
    return "" if state.picture else "There is no picture yet. Take one."


def _void_pose(state: CalibrationState, live: CalibrationLive, args: Args) -> str:
    known = any(picture.number == args.get("number") for picture in state.pictures)
    if not known:
        return "That pose is not there any more."
    return "" if len(state.pictures) > 1 else "It is the only pose. Take another first."


def _restore_pose(state: CalibrationState, live: CalibrationLive, args: Args) -> str:
    aside = [picture.number for picture in state.listed if picture.gone]
    return "" if args.get("number") in aside else "That pose is not set aside."


def _solve(state: CalibrationState, live: CalibrationLive, args: Args) -> str:
    if state.step == "review" and state.outcome is not None:
        return "Nothing changed since this was solved."
    if not state.picture:
        return "There is no picture of this object and sensor. Take one."
    looked_at = [live.capture_outcomes[picture.number] for picture in state.pictures]
    if all(seen.fault for seen in looked_at):
        return "No picture shows the object yet. Take one anew."
    if live.chosen.board is not None:
        usable = sum(len(seen.corners) > 0 for seen in looked_at)
        if missing := still_missing(usable):
            return missing
    return _touch(state, live, args)


def _accept(state: CalibrationState, live: CalibrationLive, args: Args) -> str:
    seen = live.latest_outcome
    if seen is None or seen.result is None or state.outcome is None:
        return "Something changed since this was solved. Solve again."
    if others := _others(live):
        return others
    result = seen.result
    if result.verdict != "bad":
        return ""
    if result.usable_um is not None and result.total_um > result.usable_um:
        return f"{result.total_um:.0f} µm; usable is at most {result.usable_um:.0f} µm."
    return "It should not be used: the findings say why."


def _back(state: CalibrationState, live: CalibrationLive, args: Args) -> str:
    to = args.get("to", STEPS[max(STEPS.index(state.step) - 1, 0)])
    earlier = STEPS[: STEPS.index(state.step)]
    return "" if to in earlier else f"There is no earlier step '{to}'."


def _simulation(state: CalibrationState, live: CalibrationLive, args: Args) -> str:
    return "" if live.has_hand else "There is no simulated hand on real devices."


RULES: dict[str, Rule] = {
    "confirm_devices": _devices,
    "choose": _choose,
    "confirm_setup": _setup,
    "select_face": _face,
    "take_point": _take,
    "undo": _undo,
    "redo": _redo,
    "void_point": _void,
    "confirm_touch": _touch,
    "confirm_place": _place,
    "capture": _capture,
    "keep_picture": _keep,
    "void_pose": _void_pose,
    "restore_pose": _restore_pose,
    "solve": _solve,
    "accept": _accept,
    "back": _back,
    "let_hand": _simulation,
}
