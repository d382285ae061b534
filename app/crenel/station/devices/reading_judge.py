"""Judges the readings of the connected arm, joints or poses, by the filter of their kind."""

from collections.abc import Sequence
from typing import Protocol

from crenel.errors import OperationError
from crenel.metrology.arm.joint_plausibility import PlausibilityFilter
from crenel.metrology.arm.kinematics import AnyArm, Arm
from crenel.metrology.arm.pose_plausibility import PosePlausibilityFilter
from crenel_hardware.interfaces import ArmInfo, ArmReading, JointSample, PoseSample


class HeldBack(Protocol):
    """A reading that was held back."""

    @property
    def stamp_ns(self) -> int: ...

    @property
    def error(self) -> OperationError:
        """What is wrong with it."""


class ReadingJudge:
    """Lets plausible readings pass; readings of the other kind are none of this arm's.

    Args:
        arm: the model, whose limits apply; None while unknown.
    """

    def __init__(self, info: ArmInfo, arm: AnyArm | None) -> None:
        self.serial_number = info.serial_number
        self._joints: PlausibilityFilter[JointSample] = PlausibilityFilter(
            info.joint_count, info.rate_hz
        )
        self._poses: PosePlausibilityFilter[PoseSample] = PosePlausibilityFilter()
        self._judge = self._poses if info.reports == "pose" else self._joints
        self.set_arm(arm)

    @property
    def rejected_count(self) -> int:
        """Number of readings held back."""
        return self._judge.rejected_count

    @property
    def newest(self) -> HeldBack | None:
        """The newest of them."""
        return self._judge.newest

    @property
    def judged_ns(self) -> int | None:
        """Readings up to this one are judged, and none of them waits."""
        return self._judge.judged_ns

    def set_arm(self, arm: AnyArm | None) -> None:
        """Sets the arm whose limits apply from now on."""
        self._joints.set_arm(arm if isinstance(arm, Arm) else None)

    def forget_place(self) -> None:
        """The arm reconnects: it may be anywhere."""
        self._judge.forget_place()

    def keep_frame(self, kept: bool) -> None:
        """Whether poses that leapt to a new place are held back: while a scan runs."""
        self._poses.keeps_frame = kept

    def first_between(self, first_ns: int, last_ns: int) -> HeldBack | None:
        """The first reading held back in an interval of time; None if all were plausible."""
        return self._judge.first_between(first_ns, last_ns)

    def filter(self, samples: Sequence[ArmReading]) -> list[ArmReading]:
        """The readings, oldest first, now known to be plausible."""
        if self._judge is self._poses:
            return [*self._poses.filter([one for one in samples if isinstance(one, PoseSample)])]
        return [*self._joints.filter([one for one in samples if isinstance(one, JointSample)])]
