"""What the commands of the guided calibration carry."""

from typing import Literal

from app.guide.common.arguments import (
    Arguments,
    ArgumentTable,
    BackArguments,
    IndexArguments,
    NumberArguments,
    OperatorArguments,
    ShortText,
)


class _Choice(Arguments):
    field: Literal["arm", "object", "sensor"]
    id: ShortText


class _Face(Arguments):
    face: ShortText


ARGUMENTS: ArgumentTable = {
    "choose": _Choice,
    "select_face": _Face,
    "void_point": IndexArguments,
    "void_pose": NumberArguments,
    "restore_pose": NumberArguments,
    "back": BackArguments,
    "run_simulation": OperatorArguments,
}
