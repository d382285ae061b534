"""Whether an arm's readings can be true: judged one by one, as they come."""

from app.metrology.arm.joint_plausibility.implausible import (
    EQUAL_FROZEN,
    ImplausibleKind,
    ImplausibleReading,
    limits_error,
)
from app.metrology.arm.joint_plausibility.judge import PlausibilityFilter

__all__ = [
    "EQUAL_FROZEN",
    "ImplausibleKind",
    "ImplausibleReading",
    "PlausibilityFilter",
    "limits_error",
]
