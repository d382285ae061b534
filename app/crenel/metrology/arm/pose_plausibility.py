"""Judges the poses that an arm reports: plausible poses pass, all others are held back.

A pose is impossible if it is not a number, if its quaternion is not a rotation, if no arm moves
that far since the previous pose, or if it repeats although it cannot (``PoseNoise``). Poses that
stay at a new place are accepted there: the arm's software has changed its frame or tool, and the
user is warned. Within one scan they are not, since its points would lie in two frames.
"""

import math
from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Generic, Literal, Protocol, TypeVar

import numpy as np

from crenel.errors import OperationError
from crenel.messages.message import message, quantity
from crenel.metrology.arm.pose_noise import PoseNoise
from crenel.metrology.transforms import Floats

FASTEST_MM_S, FASTEST_RAD_S = 10_000.0, 20.0
"""No robot and no hand moves an arm faster."""
UNSURE_MM, UNSURE_RAD = 2.0, 0.01
"""Noise of poses and of their time stamps, at rest."""
UNIT_TOLERANCE = 1e-3
SETTLED = 5
"""So many poses in a row at a new place are no fault of the transmission."""
LEAP_MM, LEAP_RAD = 200.0, 0.7
"""No arm comes that far while the network holds its poses back for 0.1 s: 2 m/s, 7 rad/s."""
REMEMBERED = 4096

ImplausiblePoseKind = Literal["number", "quaternion", "jump", "moved-frame", "frozen"]


class PoseReading(Protocol):
    """One reported pose."""

    @property
    def stamp_ns(self) -> int: ...

    @property
    def reading(self) -> Sequence[float]:
        """(7,) position in mm and quaternion x, y, z, w."""


@dataclass(frozen=True)
class ImplausiblePose:
    """A pose that was held back, and why."""

    kind: ImplausiblePoseKind
    stamp_ns: int
    step_mm: float = 0.0
    step_rad: float = 0.0
    """Distance and rotation from the previous pose."""

    @property
    def error(self) -> OperationError:
        """What is wrong, the possible cause, and what to do."""
        if self.kind in ("number", "quaternion"):
            return OperationError(
                "pose-implausible",
                message("pose-no-number") if self.kind == "number" else message("pose-no-rotation"),
                message("nothing-taken-such-reading"),
                message("check-arm-software-and-network"),
            )
        if self.kind == "frozen":
            return OperationError(
                "pose-implausible",
                message("pose-repeats"),
                message("poses-equal-to-last-digit"),
                message("check-arm-software-and-network"),
            )
        step, turn = quantity(self.step_mm, "mm", 1), quantity(math.degrees(self.step_rad), "°", 1)
        return OperationError(
            "pose-implausible",
            message("pose-jumped", step=step, turn=turn)
            if self.kind == "jump"
            else message("pose-jumped-and-stayed", step=step, turn=turn),
            message("no-arm-moves-that-fast"),
            message("check-frame-and-tool-of-arm"),
        )


P = TypeVar("P", bound=PoseReading)
_Placed = tuple[int, Floats]
"""A time stamp in ns, and the pose (7,)."""


@dataclass(frozen=True)
class _Elsewhere:
    """Poses held back one after the other that agree among themselves."""

    newest: _Placed
    count: int
    is_leap: bool
    """Too far from the last good pose for late ones."""


class PosePlausibilityFilter(Generic[P]):
    """Lets plausible poses pass at once and holds the others back.

    Only one that repeats, of an arm whose poses otherwise never do, waits until it is known whether
    the arm is frozen.
    """

    def __init__(self) -> None:
        self.rejected_count = 0
        self.newest: ImplausiblePose | None = None
        self.judged_ns: int | None = None
        """Poses up to this one are judged, and none of them waits."""
        self.keeps_frame = False
        """Whether poses that leapt to a new place are held back for as long as they stay there."""
        self._noise = PoseNoise()
        self._pending: list[P] = []
        self._last: _Placed | None = None
        self._elsewhere: _Elsewhere | None = None
        self._rejected: deque[ImplausiblePose] = deque(maxlen=REMEMBERED)

    def forget_place(self) -> None:
        """The arm reconnects: it may be anywhere."""
        self._last = self._elsewhere = None

    def first_between(self, first_ns: int, last_ns: int) -> ImplausiblePose | None:
        """The first pose held back in an interval of time; None if all were plausible."""
        within = (one for one in tuple(self._rejected) if first_ns <= one.stamp_ns <= last_ns)
        return next(within, None)

    def filter(self, readings: Sequence[P]) -> list[P]:
        """The plausible ones of new poses, oldest first."""
        good: list[P] = []
        for reading in readings:
            pose = np.array(reading.reading)
            was_frozen = self._noise.frozen
            may_be_frozen = self._noise.take(reading.stamp_ns, pose)
            if self._noise.frozen:
                self._reject_frozen(reading)
                continue
            if was_frozen:  # where it was in the meantime is unknown
                self.forget_place()
            wrong = self._find_fault(reading.stamp_ns, pose)
            if wrong is None and may_be_frozen:
                self._pending.append(reading)
                continue
            good += self.release()
            if wrong is None:
                good.append(reading)
            else:
                self._reject(wrong)
            self.judged_ns = reading.stamp_ns
        return good

    def release(self) -> list[P]:
        """The poses that wait, as nothing more comes, or a pose that shows them to be good."""
        released, self._pending = self._pending, []
        return released

    def _reject_frozen(self, newest: P) -> None:
        for reading in (*self.release(), newest):
            self._reject(ImplausiblePose("frozen", reading.stamp_ns))
        self.judged_ns = newest.stamp_ns

    def _reject(self, wrong: ImplausiblePose) -> None:
        self.rejected_count += 1
        self.newest = wrong
        self._rejected.append(wrong)

    def _find_fault(self, stamp_ns: int, pose: Floats) -> ImplausiblePose | None:
        if not np.isfinite(pose).all():
            return ImplausiblePose("number", stamp_ns)
        if abs(np.linalg.norm(pose[3:]) - 1) > UNIT_TOLERANCE:
            return ImplausiblePose("quaternion", stamp_ns)
        if self._last is None or self._is_here(self._last, stamp_ns, pose):
            self._last, self._elsewhere = (stamp_ns, pose), None
            return None
        there, step = self._elsewhere, _step(self._last[1], pose)
        if there is None or not _can_follow(there.newest, stamp_ns, pose):
            is_leap = step[0] > LEAP_MM or step[1] > LEAP_RAD
            self._elsewhere = _Elsewhere((stamp_ns, pose), 1, is_leap)
            return ImplausiblePose("jump", stamp_ns, *step)
        self._elsewhere = there = _Elsewhere((stamp_ns, pose), there.count + 1, there.is_leap)
        if there.count < SETTLED:
            return ImplausiblePose("jump", stamp_ns, *step)
        if not (self.keeps_frame and there.is_leap):
            self._last, self._elsewhere = there.newest, None
        return ImplausiblePose("moved-frame", stamp_ns, *step)

    def _is_here(self, last: _Placed, stamp_ns: int, pose: Floats) -> bool:
        """Whether the arm can have come from its last place, and not rather from elsewhere."""
        there = self._elsewhere
        if not _can_follow(last, stamp_ns, pose):
            return False
        if there is None or not _can_follow(there.newest, stamp_ns, pose):
            return True
        settled = there.count >= SETTLED and there.is_leap  # only a leap leads back
        return not settled and _shortest_s(last, pose) <= _shortest_s(there.newest, pose)


def _can_follow(before: _Placed, stamp_ns: int, pose: Floats) -> bool:
    seconds = max(stamp_ns - before[0], 0) / 1e9
    step_mm, step_rad = _step(before[1], pose)
    return (
        step_mm <= UNSURE_MM + FASTEST_MM_S * seconds
        and step_rad <= UNSURE_RAD + FASTEST_RAD_S * seconds
    )


def _shortest_s(before: _Placed, pose: Floats) -> float:
    """The time that the fastest arm needs from one pose to another."""
    step_mm, step_rad = _step(before[1], pose)
    return max(step_mm / FASTEST_MM_S, step_rad / FASTEST_RAD_S)


def _step(before: Floats, after: Floats) -> tuple[float, float]:
    """Distance in mm and rotation in rad between two poses."""
    cosine = min(abs(float(before[3:] @ after[3:])), 1.0)
    return float(np.linalg.norm(after[:3] - before[:3])), 2 * math.acos(cosine)
