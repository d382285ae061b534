"""The steps 'devices' and 'setup'. Pure."""

from app.findings import Quality
from app.guide.calibration.live import CalibrationLive
from app.guide.calibration.rules import other_devices
from app.guide.calibration.state import CalibrationState
from app.guide.calibration.steps.body import StepView, geometry, offer
from app.guide.common.view import Choice, ChoiceOption, ChoicesPicture, DeviceLine, DevicesPicture
from app.metrology.targets.chessboard import Chessboard
from app.metrology.targets.target import CalibrationTarget
from app.station.devices.link_state import DeviceState

QUALITY: dict[str, Quality] = {
    "connected": "good",
    "connecting": "attention",
    "lost": "bad",
    "off": "bad",
}


def devices_step(state: CalibrationState, live: CalibrationLive) -> StepView:
    """Are the arm and the sensor there?"""
    links = (live.arm_link, live.sensor_link)
    ready = all(link.state == "connected" for link in links)
    return StepView(
        instruction=(
            "Both devices answer. Go on."
            if ready
            else "Switch the arm and the sensor on and connect them."
        ),
        picture=DevicesPicture([_line(link) for link in links]),
        actions=[offer(state, live, "confirm_devices", "Continue", primary=True)],
    )


def _line(link: DeviceState) -> DeviceLine:
    text = link.text
    if link.rate_hz is not None:
        text = f"{text}, {link.rate_hz:.0f} a second"
    return DeviceLine(link.title, QUALITY[link.state], text)


def setup_step(state: CalibrationState, live: CalibrationLive) -> StepView:
    """Which arm, which object, which sensor?"""
    item = live.chosen.object
    return StepView(
        instruction="Check that the arm with its tip, the object and the sensor are those in use.",
        picture=ChoicesPicture(_choices(state, live), geometry(item) if item else None),
        actions=[offer(state, live, "confirm_setup", "These are in use", primary=True)],
        findings=[
            *other_devices(live),
            *([live.tip] if live.tip is not None else []),
            *live.library.findings,
        ],
    )


def _choices(state: CalibrationState, live: CalibrationLive) -> list[Choice]:
    library = live.library
    arms = [
        ChoiceOption(
            entry.id,
            entry.datasheet.name,
            f"serial number {entry.datasheet.serial_number}, {entry.datasheet.joint_count} joints, "
            f"tip Ø {entry.datasheet.tip.diameter_mm:.3f} mm",
        )
        for entry in library.arms.values()
    ]
    objects = [
        ChoiceOption(entry.id, entry.datasheet.name, _object_detail(entry.datasheet))
        for entry in library.objects.values()
    ]
    sensors = [
        ChoiceOption(
            entry.id,
            entry.datasheet.name,
            f"serial number {entry.datasheet.serial_number}, "
            f"{entry.datasheet.width_px} × {entry.datasheet.height_px} pixels",
        )
        for entry in library.sensors.values()
    ]
    return [
        Choice(field, title, options, state.choices.get(field, ""))
        for field, title, options in (
            ("arm", "Arm and tip", arms),
            ("object", "Object", objects),
            ("sensor", "Sensor", sensors),
        )
    ]


def _object_detail(item: CalibrationTarget) -> str:
    if isinstance(item, Chessboard):
        return _board_detail(item)
    size = (
        item.edges_x_mm[-1] - item.edges_x_mm[0],
        item.back_y_mm - item.front_y_mm,
        item.crest_z_mm - item.base_z_mm,
    )
    return (
        f"serial number {item.serial_number}, {item.merlon_count} merlons, "
        f"{size[0]:.0f} × {size[1]:.0f} × {size[2]:.0f} mm"
    )


def _board_detail(board: Chessboard) -> str:
    columns, rows = board.inner_corners
    if not board.serial_number:
        return f"chessboard, {columns} × {rows} inner corners, squares of {board.square_mm:g} mm"
    return (
        f"serial number {board.serial_number}, chessboard, {columns} × {rows} inner corners, "
        f"squares of {board.square_mm:g} mm"
    )
