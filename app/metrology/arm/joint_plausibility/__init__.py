"""Whether an arm's readings can be true: judged one by one, as they come."""

from app.metrology.arm.joint_plausibility.implausible import (
    EQUAL_FROZEN,
    Implausible,
    Kind,
    outside_limits,
)
from app.metrology.arm.joint_plausibility.judge import JointJudge

__all__ = ["EQUAL_FROZEN", "Implausible", "JointJudge", "Kind", "outside_limits"]
