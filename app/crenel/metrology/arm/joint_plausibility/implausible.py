"""Messages about implausible readings."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from crenel.errors import OperationError
from crenel.messages.message import message, quantity
from crenel.metrology.arm.kinematics import Arm

ImplausibleKind = Literal["number", "limits", "jump", "slip", "spike", "frozen"]

STOP_TOLERANCE_RAD = math.radians(0.5)
"""An arm that rests at its stop may read slightly beyond its limit."""
EQUAL_FROZEN = 40
"""For a joint with visible noise, this many equal readings in a row occur less than once in
years."""


@dataclass(frozen=True)
class ImplausibleReading:
    """An implausible reading."""

    kind: ImplausibleKind
    stamp_ns: int
    joint: str
    reading_rad: float
    limits_rad: tuple[float, float]
    step_rad: float = 0.0
    """Size of the jump."""

    @property
    def error(self) -> OperationError:
        """What is wrong: the joint, the reading, the possible cause, and what to do."""
        reading = quantity(math.degrees(self.reading_rad), "°", 1)
        if self.kind == "number":
            return OperationError(
                "joint-implausible",
                message("joint-reads-no-number", joint=self.joint),
                message("nothing-taken-such-reading"),
                message("check-arms-cable-then-switch-arm"),
            )
        if self.kind == "limits":
            low, high = (math.degrees(limit) for limit in self.limits_rad)
            return OperationError(
                "joint-implausible",
                message("joint-reads", joint=self.joint, reading=reading),
                message(
                    "datasheet-lets-turn", low=quantity(low, "°", 1), high=quantity(high, "°", 1)
                ),
                message("bring-joint-reference-switch-arm-off"),
            )
        if self.kind == "jump":
            return OperationError(
                "joint-implausible",
                message(
                    "joint-reads-where-can",
                    joint=self.joint,
                    reading=reading,
                    step=quantity(math.degrees(abs(self.step_rad)), "°", 1),
                ),
                message("no-hand-no-knock-moves-joint"),
                message("check-joints-encoder-cable-then-bring"),
            )
        if self.kind == "slip":
            return OperationError(
                "joint-implausible",
                message(
                    "joint-jumped-stayed-there",
                    joint=self.joint,
                    step=quantity(math.degrees(abs(self.step_rad)), "°", 1),
                ),
                message("no-hand-no-knock-moves-joint"),
                message("move-joint-to-reference-within-sentence"),
            )
        if self.kind == "spike":
            return OperationError(
                "joint-implausible",
                message(
                    "joint-reads-off-readings-before-after",
                    joint=self.joint,
                    reading=reading,
                    step=quantity(math.degrees(abs(self.step_rad)), "°", 2),
                ),
                message("no-joint-goes-there-back-between"),
                message("check-joints-encoder-cable-then-bring"),
            )
        return OperationError(
            "joint-implausible",
            message("joint-reads-again-again", joint=self.joint, reading=reading),
            message("readings-equal-as-never-of-encoder", equal_frozen=EQUAL_FROZEN),
            message("encoder-stands-still-switch-arm-off"),
        )


def limits_error(q_rad: Sequence[float], arm: Arm) -> OperationError | None:
    """The error of angles (n,) outside the arm's limits; None if they are inside."""
    for joint, angle_rad in zip(arm.joints, q_rad, strict=True):
        low, high = joint.limits_rad
        if not low - STOP_TOLERANCE_RAD <= angle_rad <= high + STOP_TOLERANCE_RAD:
            return ImplausibleReading("limits", 0, joint.name, angle_rad, joint.limits_rad).error
    return None
