"""What a station needs before its first calibration: what is there, and what comes next. Pure."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Literal

from crenel.findings import Quality
from crenel.formats.datasheets.sensor import SensorDatasheet
from crenel.guide.calibration.live import ConnectedArm, ConnectedSensor
from crenel.guide.common.datasheet_library import DatasheetLibrary
from crenel.guide.common.validity import NextAction, Page, Validity
from crenel.messages.message import Text, message
from crenel.metrology.arm.kinematics import AnyArm, Arm
from crenel.metrology.targets.chessboard import Chessboard
from crenel.metrology.targets.target import is_nominal
from crenel.station.devices.link_state import DeviceState

Need = Literal[
    "sensor", "arm", "arm-model", "sensor-datasheet", "target", "certificate", "tip", "calibration"
]


@dataclass(frozen=True)
class PreparationStep:
    """One thing on the way to the first calibration."""

    id: Need
    title: Text
    done: bool
    optional: bool
    """Whether one may calibrate without it."""
    quality: Quality
    text: Text
    """What is there, or what is missing, in one sentence."""
    page: Page
    action: Text
    """What the button that leads there says."""


@dataclass(frozen=True)
class ConnectedDevices:
    """The devices as they are now, and what they say of themselves once they are connected."""

    arm: DeviceState
    sensor: DeviceState
    arm_info: ConnectedArm | None
    sensor_info: ConnectedSensor | None


def list_preparation(
    devices: ConnectedDevices, library: DatasheetLibrary, tip: Validity | None
) -> tuple[PreparationStep, ...]:
    """Everything that the first calibration needs, in the order in which it is done.

    Args:
        tip: of an arm with joints, what its last check says.
    """
    arms = [entry.datasheet for entry in library.arms.values()]
    sensors = [entry.datasheet for entry in library.sensors.values()]
    targets = [entry.datasheet for entry in library.objects.values()]
    with_joints = tip is not None
    steps = [
        _device("sensor", message("sensor-heading"), devices.sensor, message("connect-the-sensor")),
        _device("arm", message("arm"), devices.arm, message("connect-the-arm")),
        _datasheet(
            "arm-model",
            message("need-arm-model"),
            [one.name for one in arms if _is_model_of(one, devices.arm_info)],
            message("no-model-fits-connected-arm") if arms else message("no-arm-model-yet"),
            message("enter-the-arm"),
        ),
        _datasheet(
            "sensor-datasheet",
            message("need-sensor-datasheet"),
            [one.name for one in sensors if _is_of(one, devices.sensor_info)],
            message("no-datasheet-fits-sensor") if sensors else message("no-sensor-datasheet-yet"),
            message("enter-the-sensor"),
        ),
        _datasheet(
            "target",
            message("need-target"),
            [one.name for one in targets if with_joints or isinstance(one, Chessboard)],
            message("no-target-yet") if with_joints else message("no-board-yet"),
            message("enter-the-target"),
        ),
    ]
    if with_joints and targets and all(is_nominal(one) for one in targets):
        steps.append(_certificate())
    if tip is not None:
        steps.append(_tip(tip))
    all_there = _first_missing(steps) is None
    text = message("all-there-calibrate") if all_there else message("comes-last")
    calibration = PreparationStep(
        "calibration",
        message("need-first-calibration"),
        False,
        False,
        "neutral",
        text,
        "calibrate",
        message("calibrate"),
    )
    return (*steps, calibration)


def next_preparation(steps: Sequence[PreparationStep]) -> NextAction | None:
    """Where the first thing that is missing is brought about; None once one can calibrate."""
    step = _first_missing(steps)
    if step is None or step.id == "calibration":
        return None
    return NextAction(step.action, step.page, step.text)


def _first_missing(steps: Iterable[PreparationStep]) -> PreparationStep | None:
    return next((one for one in steps if not (one.done or one.optional)), None)


def _device(
    need: Literal["sensor", "arm"], title: Text, state: DeviceState, action: Text
) -> PreparationStep:
    done = state.state == "connected"
    quality: Quality = "good" if done else state.quality
    return PreparationStep(need, title, done, False, quality, state.text, "devices", action)


def _datasheet(
    need: Literal["arm-model", "sensor-datasheet", "target"],
    title: Text,
    fitting: Sequence[str],
    missing: Text,
    action: Text,
) -> PreparationStep:
    done = bool(fitting)
    text = missing
    if done:
        text = fitting[0] if len(fitting) == 1 else message("choose-of-several", count=len(fitting))
    quality: Quality = "good" if done else "attention"
    return PreparationStep(need, title, done, False, quality, text, "datasheets", action)


def _certificate() -> PreparationStep:
    return PreparationStep(
        "certificate",
        message("need-certificate"),
        False,
        True,
        "neutral",
        message("block-known-by-drawing"),
        "datasheets",
        message("certify-the-block"),
    )


def _tip(tip: Validity) -> PreparationStep:
    done = tip.state == "valid"
    quality: Quality = "neutral" if tip.state == "missing" else tip.quality
    text = message("tip-is-checked-in-a-seat") if tip.state == "missing" else tip.text
    return PreparationStep("tip", message("tip"), done, True, quality, text, tip.page, tip.action)


def _is_model_of(arm: AnyArm, info: ConnectedArm | None) -> bool:
    """Whether a datasheet can be that of the connected arm; any can, while none is connected."""
    if info is None:
        return True
    if info.serial_number and arm.serial_number and info.serial_number != arm.serial_number:
        return False
    if info.reports != arm.reading_kind:
        return False
    return not isinstance(arm, Arm) or arm.joint_count == info.joint_count


def _is_of(sensor: SensorDatasheet, info: ConnectedSensor | None) -> bool:
    """The same of a sensor's datasheet."""
    if info is None:
        return True
    if info.serial_number and sensor.serial_number and info.serial_number != sensor.serial_number:
        return False
    return (sensor.width_px, sensor.height_px) == (info.width_px, info.height_px)
