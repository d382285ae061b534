"""``arm.json``: an arm's Denavit-Hartenberg model, limits and tip; or a robot's tip alone."""

from collections.abc import Sequence
from pathlib import Path
from typing import ClassVar, Literal, Self

import numpy as np
from pydantic import Field, model_validator

from crenel.errors import OperationError
from crenel.formats.datasheets.arm_identification import IdentificationPart
from crenel.formats.file_names import display_path
from crenel.formats.json_document import (
    Document,
    DocumentPart,
    Name,
    NotNegative,
    Number,
    SerialNumber,
    SizeMm,
    field_name,
    read_text,
)
from crenel.messages.message import message, quantity, rounded
from crenel.metrology.arm.kinematics import Arm, Joint, RobotArm, Tip
from crenel.metrology.arm.link_error import LinkError, error_from_transform, error_transform
from crenel.metrology.arm.modified_dh import standard_from_modified
from crenel.metrology.arm.near_frames import with_near_frames
from crenel.rotations import CONVENTIONS

JOINT_COUNTS = (5, 6, 7)
METRES_MM = 10.0
"""No arm has all of its lengths below this: they are in metres."""
SHORTEST_ARM_MM = 120.0
"""No arm is shorter, stretched out: its lengths are in inches or centimetres."""
QUARTER_RAD = np.pi / 2
NEAR_QUARTER = 0.02
"""How near to a quarter turn an angle counts as one: zeros of joints in radians are so near to
multiples of it."""
SMALL_ANGLE = 0.5
"""An offset or a twist that was identified is smaller, in degrees."""
MOST_TURNS_DEG = 720.0
"""No angle between links is larger."""


class ErrorPart(DocumentPart):
    x_mm: Number = 0.0
    y_mm: Number = 0.0
    z_mm: Number = 0.0
    rx_deg: Number = 0.0
    ry_deg: Number = 0.0
    rz_deg: Number = 0.0


class JointPart(DocumentPart):
    name: Name
    a_mm: Number
    alpha_deg: Number
    d_mm: Number
    theta_deg: Number
    sign: Literal[1, -1] = 1
    limits_deg: tuple[Number, Number]
    encoder_sd_deg: NotNegative = 0.0
    error: ErrorPart | None = None

    @model_validator(mode="after")
    def _limits_ascend(self) -> Self:
        if self.limits_deg[0] >= self.limits_deg[1]:
            limits = field_name("limits_deg")
            raise ValueError(message("limits-deg-must-ascend", limits=limits, name=self.name))
        return self


class TipPart(DocumentPart):
    x_mm: Number
    y_mm: Number
    z_mm: Number
    diameter_mm: SizeMm


class ArmFile(Document):
    """The file, as described in docs/formats.md."""

    FORMAT: ClassVar[str] = "crenel/arm"

    name: Name
    serial_number: SerialNumber = ""
    convention: Literal["dh-standard", "dh-modified", "pose"]
    rotation: str | None = None
    """How the tables of a robot's poses write rotations; None: as quaternions."""
    base: ErrorPart | None = None
    """Constant transform before the first joint."""
    joints: tuple[JointPart, ...] = Field(default=())
    tip: TipPart | None = None
    """A robot that touches nothing has none."""
    identification: IdentificationPart | None = None

    @model_validator(mode="after")
    def _check_joints(self) -> Self:
        if self.convention != "pose" and len(self.joints) not in JOINT_COUNTS:
            field, joints = field_name("joints"), len(self.joints)
            raise ValueError(message("not-five-to-seven-joints", field=field, joints=joints))
        if self.convention != "pose" and self.tip is None:
            raise ValueError(message("tip-missing-place-flange-diameter", tip=field_name("tip")))
        if self.rotation and (self.convention != "pose" or self.rotation not in CONVENTIONS):
            known = ", ".join(CONVENTIONS)
            raise ValueError(message("rotation-of-poses", name=repr(self.rotation), names=known))
        _refuse_other_units(self.joints)
        names = [joint.name for joint in self.joints]
        for name in names:
            if names.count(name) > 1:
                raise ValueError(message("joint-name-twice", name=repr(name)))
        return self


def _refuse_other_units(joints: Sequence[JointPart]) -> None:
    """Raises ``ValueError`` for lengths that are not in mm, or angles that are not in degrees.

    An arm has twists of a quarter turn, limits beyond a few degrees, and a length.
    """
    if not joints:
        return
    lengths = [abs(length) for joint in joints for length in (joint.a_mm, joint.d_mm)]
    if 0 < max(lengths) < METRES_MM:
        longest = rounded(max(lengths), "mm", 4)
        raise ValueError(message("lengths-are-in-metres", longest=longest))
    if 0 < sum(lengths) < SHORTEST_ARM_MM:
        shown = quantity(sum(lengths), "mm")
        raise ValueError(message("lengths-of-no-arm", length=shown))
    twists = [abs(joint.alpha_deg) for joint in joints]
    zeros = [abs(joint.theta_deg) for joint in joints]
    limits = [abs(limit) for joint in joints for limit in joint.limits_deg]
    quarters = [abs(zero / QUARTER_RAD - round(zero / QUARTER_RAD)) for zero in zeros]
    in_radians = {
        "alpha_deg": SMALL_ANGLE < max(twists) <= 4 * QUARTER_RAD,
        "theta_deg": SMALL_ANGLE < max(zeros) <= 4 * QUARTER_RAD and max(quarters) < NEAR_QUARTER,
        "limits_deg": max(limits) <= 4 * QUARTER_RAD,
    }
    for field, values in (("alpha_deg", twists), ("theta_deg", zeros), ("limits_deg", limits)):
        largest = f"{max(values):.4g}"
        if in_radians[field]:
            raise ValueError(message("arm-angles-in-radians", field=field, largest=largest))
        if field != "limits_deg" and max(values) > MOST_TURNS_DEG:
            raise ValueError(message("arm-angles-converted-twice", field=field, largest=largest))


def read_any_arm(path: Path) -> Arm | RobotArm:
    """Reads ``arm.json`` of either convention; ``OperationError`` names the file and the field."""
    return parse_any_arm(read_text(path), path)


def parse_any_arm(text: str, path: Path) -> Arm | RobotArm:
    """Reads the text of a file of this name; as ``read_any_arm``."""
    document = ArmFile.parse_text(text, path)
    tip = None if document.tip is None else Tip(**document.tip.model_dump())
    if document.convention == "pose":
        return RobotArm(document.name, document.serial_number, tip, document.rotation or "")
    assert tip is not None
    joints = tuple(_joint(part) for part in document.joints)
    base = _link_error(document.base)
    if document.convention == "dh-modified":
        first, joints = standard_from_modified(joints)
        base = error_from_transform(error_transform(base) @ error_transform(first))
    return with_near_frames(Arm(document.name, document.serial_number, joints, tip, base))


def read_arm(path: Path) -> Arm:
    """Reads the ``arm.json`` of an arm with joints; raises ``OperationError`` for a robot's."""
    arm = read_any_arm(path)
    if isinstance(arm, Arm):
        return arm
    raise OperationError(
        "arm-without-joints",
        message("convention-is-pose", path=display_path(path)),
        message("arm-with-joints-needed"),
        message("give-denavit-hartenberg-model"),
    )


def arm_document(arm: Arm, identification: IdentificationPart | None = None) -> ArmFile:
    """The file of an arm in the standard convention; of an identified one, with what its parameters
    rest on."""
    tip = arm.tip
    return ArmFile(
        name=arm.name,
        serial_number=arm.serial_number,
        convention="dh-standard",
        base=error_part(arm.base),
        joints=tuple(joint_part(joint) for joint in arm.joints),
        tip=TipPart(x_mm=tip.x_mm, y_mm=tip.y_mm, z_mm=tip.z_mm, diameter_mm=tip.diameter_mm),
        identification=identification,
    )


def _joint(part: JointPart) -> Joint:
    low, high = np.deg2rad(part.limits_deg)
    return Joint(
        name=part.name,
        a_mm=part.a_mm,
        alpha_rad=float(np.deg2rad(part.alpha_deg)),
        d_mm=part.d_mm,
        theta_rad=float(np.deg2rad(part.theta_deg)),
        sign=part.sign,
        limits_rad=(float(low), float(high)),
        encoder_sd_rad=float(np.deg2rad(part.encoder_sd_deg)),
        error=_link_error(part.error),
    )


def _link_error(part: ErrorPart | None) -> LinkError:
    error = part or ErrorPart()
    return LinkError(
        error.x_mm,
        error.y_mm,
        error.z_mm,
        float(np.deg2rad(error.rx_deg)),
        float(np.deg2rad(error.ry_deg)),
        float(np.deg2rad(error.rz_deg)),
    )


def joint_part(joint: Joint) -> JointPart:
    """A joint as it stands in the file."""
    return JointPart(
        name=joint.name,
        a_mm=joint.a_mm,
        alpha_deg=float(np.rad2deg(joint.alpha_rad)),
        d_mm=joint.d_mm,
        theta_deg=float(np.rad2deg(joint.theta_rad)),
        sign=1 if joint.sign > 0 else -1,
        limits_deg=(float(np.rad2deg(joint.limits_rad[0])), float(np.rad2deg(joint.limits_rad[1]))),
        encoder_sd_deg=float(np.rad2deg(joint.encoder_sd_rad)),
        error=error_part(joint.error),
    )


def error_part(error: LinkError) -> ErrorPart | None:
    """A constant transform in mm and degrees; None for no error, so that files stay short."""
    if error == LinkError():
        return None
    return ErrorPart(
        x_mm=error.x_mm,
        y_mm=error.y_mm,
        z_mm=error.z_mm,
        rx_deg=float(np.rad2deg(error.rx_rad)),
        ry_deg=float(np.rad2deg(error.ry_rad)),
        rz_deg=float(np.rad2deg(error.rz_rad)),
    )
