"""Datasheets that the tests write: the program itself only reads them."""

from dataclasses import asdict
from pathlib import Path

from crenel.formats.datasheets.arm import ArmFile, TipPart, arm_document
from crenel.formats.datasheets.target import CharucoFile, ChessboardFile, ObjectFile
from crenel.metrology.arm.kinematics import Arm, RobotArm
from crenel.metrology.targets.chessboard import Chessboard
from crenel.metrology.targets.crenellated_block import Crenellated


def write_arm(path: Path, arm: Arm | RobotArm) -> None:
    if isinstance(arm, Arm):
        arm_document(arm).write(path)
        return
    tip = None if arm.tip is None else TipPart.model_validate(arm.tip, from_attributes=True)
    name, number = arm.name, arm.serial_number
    ArmFile(name=name, serial_number=number, convention="pose", tip=tip).write(path)


def write_object(path: Path, item: Crenellated | Chessboard) -> None:
    if isinstance(item, Crenellated):
        ObjectFile.model_validate(item, from_attributes=True).write(path)
    elif item.markers is not None:
        fields = asdict(item)
        columns, rows = fields.pop("inner_corners")
        markers = fields.pop("markers")
        CharucoFile.model_validate(
            {
                "kind": "charuco",
                **fields,
                "squares_x": columns + 1,
                "squares_y": rows + 1,
                "marker_mm": markers["side_mm"],
                "dictionary": markers["dictionary"],
                "legacy_pattern": markers["legacy"],
                "first_id": markers["first_id"],
            }
        ).write(path)
    else:
        ChessboardFile.model_validate({"kind": "chessboard", **asdict(item)}).write(path)
