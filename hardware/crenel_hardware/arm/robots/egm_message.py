"""The messages of ABB's Externally Guided Motion (EGM), as far as they are read here.

Source:
    ABB, "Application manual - Externally Guided Motion": the file ``egm.proto``. Fields that are
    not listed here are skipped.
"""

from typing import Any

from google.protobuf.descriptor_pb2 import FieldDescriptorProto, FileDescriptorProto
from google.protobuf.descriptor_pool import DescriptorPool
from google.protobuf.message import DecodeError
from google.protobuf.message_factory import GetMessageClass

_U32 = FieldDescriptorProto.TYPE_UINT32
_U64 = FieldDescriptorProto.TYPE_UINT64
_REAL = FieldDescriptorProto.TYPE_DOUBLE
_FIELDS: dict[str, list[tuple[int, str, "FieldDescriptorProto.Type.ValueType | str"]]] = {
    "EgmHeader": [(1, "seqno", _U32), (2, "tm", _U32)],
    "EgmCartesian": [(1, "x", _REAL), (2, "y", _REAL), (3, "z", _REAL)],
    "EgmQuaternion": [(1, "u0", _REAL), (2, "u1", _REAL), (3, "u2", _REAL), (4, "u3", _REAL)],
    "EgmPose": [(1, "pos", "EgmCartesian"), (2, "orient", "EgmQuaternion")],
    "EgmJoints": [(1, "joints", _REAL)],
    "EgmClock": [(1, "sec", _U64), (2, "usec", _U64)],
    "EgmFeedBack": [
        (1, "joints", "EgmJoints"),
        (2, "cartesian", "EgmPose"),
        (3, "externalJoints", "EgmJoints"),
        (4, "time", "EgmClock"),
    ],
    "EgmRobot": [(1, "header", "EgmHeader"), (2, "feedBack", "EgmFeedBack")],
}


def decode_robot(data: bytes) -> Any | None:
    """The message ``EgmRobot`` in a datagram; None of anything else."""
    robot = _EGM_ROBOT()
    try:
        robot.ParseFromString(data)
    except DecodeError:
        return None
    return robot if robot.HasField("header") and robot.HasField("feedBack") else None


def _robot_class() -> Any:
    file = FileDescriptorProto(name="egm.proto", package="abb.egm", syntax="proto2")
    for name, fields in _FIELDS.items():
        added = file.message_type.add(name=name)
        for number, field, kind in fields:
            repeated = name == "EgmJoints"
            added.field.add(
                name=field,
                number=number,
                label=(
                    FieldDescriptorProto.LABEL_REPEATED
                    if repeated
                    else FieldDescriptorProto.LABEL_OPTIONAL
                ),
                **_kind(kind),
            )
    pool = DescriptorPool()
    pool.Add(file)
    return GetMessageClass(pool.FindMessageTypeByName("abb.egm.EgmRobot"))


def _kind(kind: "FieldDescriptorProto.Type.ValueType | str") -> dict[str, Any]:
    if isinstance(kind, str):
        return {"type": FieldDescriptorProto.TYPE_MESSAGE, "type_name": f".abb.egm.{kind}"}
    return {"type": kind}


_EGM_ROBOT = _robot_class()
