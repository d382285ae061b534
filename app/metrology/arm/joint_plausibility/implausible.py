"""What is said of a reading that cannot be true."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from app.errors import OperationError
from app.metrology.arm.kinematics import Arm

ImplausibleKind = Literal["number", "limits", "jump", "slip", "spike", "frozen"]

STOP_TOLERANCE_RAD = math.radians(0.5)
"""An arm that rests at its stop may read a little past its limit."""
EQUAL_FROZEN = 40
"""So many equal readings in a row of a joint whose noise shows come less than once in years."""


@dataclass(frozen=True)
class ImplausibleReading:
    """A reading that cannot be true."""

    kind: ImplausibleKind
    stamp_ns: int
    joint: str
    reading_rad: float
    limits_rad: tuple[float, float]
    step_rad: float = 0.0
    """By how much it jumped."""

    @property
    def error(self) -> OperationError:
        """What is said of it: the joint, the reading, what it may be, and what to do."""
        reading = f"{math.degrees(self.reading_rad):.1f}°"
        if self.kind == "number":
            return OperationError(
                "joint-implausible",
                f"joint {self.joint} reads no number",
                "nothing is taken from such a reading",
                "check the arm's cable, then switch the arm off and on",
            )
        if self.kind == "limits":
            low, high = (math.degrees(limit) for limit in self.limits_rad)
            return OperationError(
                "joint-implausible",
                f"joint {self.joint} reads {reading}",
                f"its datasheet lets it turn from {low:.1f}° to {high:.1f}°",
                "bring the joint to its reference and switch the arm off and on; "
                "if it goes on, choose the datasheet of this arm",
            )
        if self.kind == "jump":
            return OperationError(
                "joint-implausible",
                f"joint {self.joint} reads {reading}, "
                f"{math.degrees(abs(self.step_rad)):.1f}° from where it can be",
                "no hand and no knock moves a joint so far in so short a time",
                "check the joint's encoder and cable, then bring the arm to its reference",
            )
        if self.kind == "slip":
            return OperationError(
                "joint-implausible",
                f"joint {self.joint} jumped by {math.degrees(abs(self.step_rad)):.1f}° "
                "and stayed there",
                "no hand and no knock moves a joint so far in so short a time",
                "bring the joint to its reference and switch the arm off and on",
            )
        if self.kind == "spike":
            return OperationError(
                "joint-implausible",
                f"joint {self.joint} reads {reading}, "
                f"{math.degrees(abs(self.step_rad)):.2f}° off its readings before and after",
                "no joint goes there and back between two readings",
                "check the joint's encoder and cable, then bring the arm to its reference",
            )
        return OperationError(
            "joint-implausible",
            f"joint {self.joint} reads {reading} again and again",
            f"{EQUAL_FROZEN} readings in a row or more are equal to the last digit, "
            "as those of a working encoder never are",
            "its encoder stands still: switch the arm off and on, and check the joint's cable",
        )


def limits_error(q_rad: Sequence[float], arm: Arm) -> OperationError | None:
    """What is said of angles (n,) outside the arm's limits; None for those inside."""
    for joint, angle_rad in zip(arm.joints, q_rad, strict=True):
        low, high = joint.limits_rad
        if not low - STOP_TOLERANCE_RAD <= angle_rad <= high + STOP_TOLERANCE_RAD:
            return ImplausibleReading("limits", 0, joint.name, angle_rad, joint.limits_rad).error
    return None
