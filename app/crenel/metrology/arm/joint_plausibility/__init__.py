"""Plausibility of the arm's readings, judged one by one as they arrive."""

from crenel.metrology.arm.joint_plausibility.implausible import (
    EQUAL_FROZEN,
    ImplausibleKind,
    ImplausibleReading,
    limits_error,
)
from crenel.metrology.arm.joint_plausibility.judge import PlausibilityFilter

__all__ = [
    "EQUAL_FROZEN",
    "ImplausibleKind",
    "ImplausibleReading",
    "PlausibilityFilter",
    "limits_error",
]
