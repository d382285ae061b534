"""What a station needs before its first calibration, and where it is brought about."""

from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import pytest

from crenel.guide.calibration.live import ConnectedArm, ConnectedSensor
from crenel.guide.calibration.preparation import (
    ConnectedDevices,
    PreparationStep,
    list_preparation,
    next_preparation,
)
from crenel.guide.common.datasheet_library import DatasheetEntry, DatasheetLibrary
from crenel.guide.common.validity import ValidityInputs, check_validity
from crenel.metrology.arm.kinematics import RobotArm
from crenel.metrology.targets.chessboard import Chessboard
from tests.guide.builders import ARM, BLOCK, CONNECTED, SENSOR

TIP = check_validity(
    ValidityInputs(None, None, False, None, None, None), datetime(2026, 11, 29, tzinfo=UTC)
)[3]
ARM_INFO = ConnectedArm(ARM.serial_number, ARM.joint_count, "joints")
SENSOR_INFO = ConnectedSensor(SENSOR.serial_number, SENSOR.width_px, SENSOR.height_px)
ABSENT = replace(CONNECTED, state="absent", quality="attention", text="none is chosen")
NO_DEVICES = ConnectedDevices(ABSENT, ABSENT, None, None)
DEVICES = ConnectedDevices(CONNECTED, CONNECTED, ARM_INFO, SENSOR_INFO)


def library(**known: object) -> DatasheetLibrary:
    all_kinds: dict[str, Any] = {"arms": {}, "objects": {}, "sensors": {}}
    for kind, datasheet in known.items():
        all_kinds[kind] = {"one": DatasheetEntry("one", Path("one.json"), datasheet)}
    return DatasheetLibrary(**all_kinds, findings=())


ALL = library(arms=ARM, objects=BLOCK, sensors=SENSOR)


def missing(steps: tuple[PreparationStep, ...]) -> list[str]:
    return [one.id for one in steps if not one.done]


def test_a_new_station_is_led_from_its_devices_over_its_datasheets_to_calibrating() -> None:
    pages = []
    for devices, known in (
        (NO_DEVICES, library()),
        (replace(NO_DEVICES, sensor=CONNECTED, sensor_info=SENSOR_INFO), library()),
        (DEVICES, library()),
        (DEVICES, library(arms=ARM)),
        (DEVICES, library(arms=ARM, sensors=SENSOR)),
    ):
        found = next_preparation(list_preparation(devices, known, TIP))
        assert found is not None
        pages.append((found.page, str(found.label)))
    assert pages == [
        ("devices", "Connect the sensor"),
        ("devices", "Connect the arm"),
        ("datasheets", "Enter the arm"),
        ("datasheets", "Enter the sensor"),
        ("datasheets", "Enter a block or board"),
    ]
    ready = list_preparation(DEVICES, ALL, TIP)
    # the tip's check is recommended, and calibrating is up to Home
    assert (missing(ready), next_preparation(ready)) == (["tip", "calibration"], None)


BOARD = Chessboard("board 7", "C-7", (7, 6), 10.0, 0.05)
ROBOT = RobotArm("robot", "R-1")
POSES = replace(ARM_INFO, serial_number="R-1", joint_count=0, reports="pose")


@pytest.mark.parametrize(
    ("devices", "known", "unfit"),
    [
        (replace(DEVICES, arm_info=replace(ARM_INFO, serial_number="9")), ALL, ["arm-model"]),
        (replace(DEVICES, arm_info=replace(ARM_INFO, serial_number="")), ALL, []),
        (replace(DEVICES, arm_info=replace(ARM_INFO, joint_count=7)), ALL, ["arm-model"]),
        (
            replace(DEVICES, sensor_info=replace(SENSOR_INFO, width_px=99)),
            ALL,
            ["sensor-datasheet"],
        ),
        (
            replace(DEVICES, arm_info=POSES),
            library(arms=ROBOT, objects=BLOCK, sensors=SENSOR),
            ["target"],
        ),
        (replace(DEVICES, arm_info=POSES), library(arms=ROBOT, objects=BOARD, sensors=SENSOR), []),
    ],
)
def test_a_datasheet_of_another_device_does_not_count(
    devices: ConnectedDevices, known: DatasheetLibrary, unfit: list[str]
) -> None:
    has_joints = devices.arm_info is not None and devices.arm_info.reports == "joints"
    steps = list_preparation(devices, known, TIP if has_joints else None)
    assert [name for name in missing(steps) if name not in ("tip", "calibration")] == unfit
