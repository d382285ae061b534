"""The steps 'devices' and 'setup'. Pure."""

from crenel.formats.datasheets.sensor import SensorDatasheet
from crenel.guide.calibration.live import CalibrationLive
from crenel.guide.calibration.rules import can_take_poses, offer, other_devices
from crenel.guide.calibration.state import CAMERA, DEVICE, CalibrationState
from crenel.guide.calibration.steps.body import StepView, geometry
from crenel.guide.common.view import (
    Action,
    Choice,
    ChoiceOption,
    ChoicesPicture,
    DeviceLine,
    DevicesPicture,
)
from crenel.messages.message import Text, message, quantity, rounded
from crenel.metrology.arm.kinematics import AnyArm, Arm
from crenel.metrology.targets.chessboard import Chessboard, Markers
from crenel.metrology.targets.target import CalibrationTarget
from crenel.station.devices.link_state import DeviceState


def devices_step(state: CalibrationState, live: CalibrationLive) -> StepView:
    """Are the arm and the sensor there?"""
    ready = all(link.state == "connected" for link in live.links)
    return StepView(
        instruction=(
            message("both-devices-answer-go")
            if ready
            else message("switch-arm-sensor-connect-them")
        ),
        picture=DevicesPicture([_line(link) for link in live.links]),
        actions=[offer(state, live, "confirm_devices", message("continue"), primary=True)],
    )


def _line(link: DeviceState) -> DeviceLine:
    text = link.text
    if link.rate_hz is not None:
        text = message("second", text=text, rate=quantity(link.rate_hz))
    return DeviceLine(link.title, link.quality, text)


def setup_step(state: CalibrationState, live: CalibrationLive) -> StepView:
    """Which arm, which object, which sensor?"""
    item, chosen_arm = live.chosen.object, live.chosen.arm
    return StepView(
        instruction=message("check-arm-tip-object-sensor-those"),
        picture=ChoicesPicture(_choices(state, live), geometry(item) if item else None),
        actions=[
            offer(state, live, "confirm_setup", message("these-use"), primary=True),
            *_offer_taking(state, live),
        ],
        findings=[
            *other_devices(live),
            *([live.tip] if live.tip is not None and isinstance(chosen_arm, Arm) else []),
            *live.library.findings,
        ],
    )


def _offer_taking(state: CalibrationState, live: CalibrationLive) -> list[Action]:
    """Offers to go on to the pictures of a robot with a board, which are taken by themselves."""
    if not can_take_poses(live):
        return []
    return [offer(state, live, "setup_and_poses", message("these-use-and-pictures"))]


def _choices(state: CalibrationState, live: CalibrationLive) -> list[Choice]:
    library = live.library
    arms = [
        ChoiceOption(
            entry.id,
            entry.datasheet.name,
            _arm_detail(entry.datasheet),
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
            _sensor_detail(entry.datasheet),
        )
        for entry in library.sensors.values()
    ]
    devices = [ChoiceOption(one.name, one.label, one.state.text) for one in live.devices]
    return [
        Choice(field, title, options, state.choices.get(field, ""))
        for field, title, options in (
            *_camera_choices(live),
            *(((DEVICE, message("connected-sensor"), devices),) if devices else ()),
            ("arm", message("arm-tip"), arms),
            ("object", message("object"), objects),
            ("sensor", message("sensor-heading"), sensors),
        )
    ]


def _camera_choices(live: CalibrationLive) -> list[tuple[str, Text, list[ChoiceOption]]]:
    """Whether camera and mounting of the calibration in use are kept, and the laser added."""
    kept = live.without_laser
    if kept is None or live.chosen.board is None:
        return []
    keeps = message("to-calibration", name=kept.name)
    options = [
        ChoiceOption("", message("calibrate-camera-mounting-and-laser"), ""),
        ChoiceOption(kept.id, message("add-the-laser"), keeps),
    ]
    return [(CAMERA, message("what-is-calibrated"), options)]


def _arm_detail(arm: AnyArm) -> Text:
    if isinstance(arm, Arm):
        return message(
            "serial-number-joints-tip",
            serial_number=arm.serial_number,
            joint_count=arm.joint_count,
            diameter=quantity(arm.tip.diameter_mm, "mm", 3),
        )
    if arm.tip is None and not arm.serial_number:
        return message("reports-poses-no-tip")
    if arm.tip is None:
        return message("serial-number-poses-no-tip", serial_number=arm.serial_number)
    return message(
        "serial-number-poses-tip",
        serial_number=arm.serial_number,
        diameter=quantity(arm.tip.diameter_mm, "mm", 3),
    )


def _sensor_detail(sensor: SensorDatasheet) -> Text:
    width_px, height_px = sensor.width_px, sensor.height_px
    if not sensor.serial_number:
        return message("picture-of-pixels", width_px=width_px, height_px=height_px)
    return message(
        "serial-number-pixels",
        serial_number=sensor.serial_number,
        width_px=width_px,
        height_px=height_px,
    )


def _object_detail(item: CalibrationTarget) -> Text:
    if isinstance(item, Chessboard):
        return _board_detail(item)
    size = (
        item.edges_x_mm[-1] - item.edges_x_mm[0],
        item.back_y_mm - item.front_y_mm,
        item.crest_z_mm - item.base_z_mm,
    )
    return message(
        "serial-number-merlons",
        serial_number=item.serial_number,
        merlon_count=item.merlon_count,
        size=quantity(size[0], "mm"),
        size2=quantity(size[1], "mm"),
        size3=quantity(size[2], "mm"),
    )


def _board_detail(board: Chessboard) -> Text:
    columns, rows = board.inner_corners
    if board.markers is not None:
        return _charuco_detail(board, board.markers)
    if not board.serial_number:
        return message(
            "chessboard-inner-corners-squares-mm",
            columns=columns,
            rows=rows,
            square=rounded(board.square_mm, "mm"),
        )
    return message(
        "serial-number-chessboard-inner-corners-squares",
        serial_number=board.serial_number,
        columns=columns,
        rows=rows,
        square=rounded(board.square_mm, "mm"),
    )


def _charuco_detail(board: Chessboard, markers: Markers) -> Text:
    columns, rows = (count + 1 for count in board.inner_corners)
    if not board.serial_number:
        return message(
            "charuco-squares-mm-markers",
            columns=columns,
            rows=rows,
            square=rounded(board.square_mm, "mm"),
            dictionary=markers.dictionary,
        )
    return message(
        "serial-number-charuco-squares-markers",
        serial_number=board.serial_number,
        columns=columns,
        rows=rows,
        square=rounded(board.square_mm, "mm"),
        dictionary=markers.dictionary,
    )
