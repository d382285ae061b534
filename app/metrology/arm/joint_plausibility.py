"""Whether an arm's readings can be true: judged one by one, as they come."""

import math
from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Generic, Literal, Protocol, TypeVar

from app.errors import Refusal
from app.metrology.arm.kinematics import Arm

Kind = Literal["number", "limits", "jump", "frozen"]


class Reading(Protocol):
    """One sample of all encoders."""

    @property
    def stamp_ns(self) -> int: ...

    @property
    def joints_rad(self) -> Sequence[float]:
        """(n,)"""


R = TypeVar("R", bound=Reading)
At = tuple[int, Sequence[float]]
"""A stamp in ns, and the encoder angles (n,) in rad."""

STOP_TOLERANCE_RAD = math.radians(0.5)
"""An arm that rests at its stop may read a little past its limit."""
MOST_SPEED_RAD_S = 30.0
"""A hand moves a tip at 2 m/s at most, and spins a wrist by less than three turns a second."""
MOST_ACCELERATION_RAD_S2 = 5000.0
"""A knock of 50 g, 0.1 m from a joint's axis."""
NOISE_SDS = 12.0
"""The encoder's own noise, in a speed taken from two of its readings, looks like motion."""
LONGEST_STEP_S = 0.01
"""A joint that jumped is waited for no longer than this by its largest speed."""
FORGET_S = 0.1
"""After a gap so long a joint may be anywhere."""
SETTLED_S = 0.5
"""A joint that stays for so long where it jumped to is believed again."""
LEVELS, WATCHED, REVERSALS = 4, 64, 16
"""Noise is seen where among so many readings there are so many values and changes of direction."""
EQUAL_HELD, EQUAL_FROZEN = 2, 32
"""A joint whose noise was seen reads the same value twice in a row with a chance below one
half: two are held for a moment, and 32 come less than once in years of readings."""
REMEMBERED = 4096


@dataclass(frozen=True)
class Implausible:
    """A reading that cannot be true."""

    kind: Kind
    stamp_ns: int
    joint: str
    reading_rad: float
    limits_rad: tuple[float, float]
    step_rad: float = 0.0
    """By how much it jumped."""

    @property
    def refusal(self) -> Refusal:
        """What is said of it: the joint, the reading, what it may be, and what to do."""
        reading = f"{math.degrees(self.reading_rad):.1f}°"
        if self.kind == "number":
            return Refusal(
                "joint-implausible",
                f"joint {self.joint} reads no number",
                "nothing is taken from such a reading",
                "check the arm's cable, then switch the arm off and on",
            )
        if self.kind == "limits":
            low, high = (math.degrees(limit) for limit in self.limits_rad)
            return Refusal(
                "joint-implausible",
                f"joint {self.joint} reads {reading}",
                f"its datasheet lets it turn from {low:.1f}° to {high:.1f}°",
                "bring the joint to its reference and switch the arm off and on; "
                "if it goes on, choose the datasheet of this arm",
            )
        if self.kind == "jump":
            return Refusal(
                "joint-implausible",
                f"joint {self.joint} reads {reading}, "
                f"{math.degrees(abs(self.step_rad)):.1f}° from its reading before",
                f"no joint turns faster than {math.degrees(MOST_SPEED_RAD_S):.0f}°/s",
                "check the joint's encoder and cable, then bring the arm to its reference",
            )
        return Refusal(
            "joint-implausible",
            f"joint {self.joint} reads {reading} without its usual noise",
            f"{EQUAL_FROZEN} readings in a row are equal to the last digit",
            "its encoder stands still: switch the arm off and on, and check the joint's cable",
        )


def outside_limits(q_rad: Sequence[float], arm: Arm) -> Refusal | None:
    """What is said of angles (n,) outside the arm's limits; None for those inside."""
    for joint, angle_rad in zip(arm.joints, q_rad, strict=True):
        low, high = joint.limits_rad
        if not low - STOP_TOLERANCE_RAD <= angle_rad <= high + STOP_TOLERANCE_RAD:
            return Implausible("limits", 0, joint.name, angle_rad, joint.limits_rad).refusal
    return None


class _Joint:
    """What is known of one joint from its readings so far."""

    def __init__(self, name: str, limits_rad: tuple[float, float], sd_rad: float) -> None:
        self.name = name
        self.limits_rad = limits_rad
        self.low, self.high = limits_rad[0] - STOP_TOLERANCE_RAD, limits_rad[1] + STOP_TOLERANCE_RAD
        self.noise_rad = NOISE_SDS * sd_rad
        self.speed_rad_s = 0.0
        self.noisy = False
        self.equal = 0
        """How often the newest reading came again."""
        self._levels: set[float] = set()
        self._seen = self._reversals = 0
        self._way = 0.0

    def watch(self, before_rad: float, now_rad: float) -> None:
        """Counts equal readings, and learns whether the joint's noise shows."""
        change = now_rad - before_rad
        self.equal = 0 if change else self.equal + 1
        if self.noisy:
            return
        self._seen += 1
        self._levels.add(now_rad)
        if change:
            self._reversals += change * self._way < 0
            self._way = change
        self.noisy = len(self._levels) >= LEVELS and self._reversals >= REVERSALS
        if self._seen >= WATCHED:
            self._seen = self._reversals = 0
            self._levels.clear()


class JointJudge(Generic[R]):
    """Lets plausible readings pass and keeps the others back.

    A reading is impossible that is no number, lies outside its joint's limits, or lies
    farther from the one before than a joint can turn. A joint is frozen that reads the same
    value to the last digit again and again although its noise was seen before: so a joint
    that stands is not accused, nor one whose encoder is too coarse to show noise. Readings
    that may turn out frozen wait until it is known.

    Args:
        arm: None while it is not known: then limits are not judged.
    """

    def __init__(self, joint_count: int, rate_hz: float, arm: Arm | None = None) -> None:
        self.impossible = self.frozen = 0
        """Readings kept back so far."""
        self.outside = 0
        """Those of the impossible that lie outside the joints' limits."""
        self.newest: Implausible | None = None
        self.first: Implausible | None = None
        self.judged_ns: int | None = None
        """What came up to here is known to be good or bad."""
        self._arm = arm
        self._period_s = 1.0 / max(rate_hz, 1.0)
        self._joints = [_Joint(f"J{i + 1}", (-math.inf, math.inf), 0.0) for i in range(joint_count)]
        self._last: At | None = None
        self._raw: Sequence[float] | None = None
        self._paced = False
        """Whether the joints' speeds are known."""
        self._aside: At | None = None
        """Where a joint has jumped to, and since when."""
        self._aside_last: At | None = None
        self._held: list[R] = []
        self._bad: deque[tuple[int, Implausible]] = deque(maxlen=REMEMBERED)
        self.set_arm(arm)

    @property
    def kept_back(self) -> int:
        return self.impossible + self.frozen

    def set_arm(self, arm: Arm | None) -> None:
        """Whose limits hold from now on; what was learned of the encoders is kept."""
        self._arm = arm
        if arm is None or arm.joint_count != len(self._joints):
            return
        for joint, own in zip(self._joints, arm.joints, strict=True):
            joint.name, joint.limits_rad = own.name, own.limits_rad
            joint.low = own.limits_rad[0] - STOP_TOLERANCE_RAD
            joint.high = own.limits_rad[1] + STOP_TOLERANCE_RAD
            joint.noise_rad = NOISE_SDS * own.encoder_sd_rad

    def between(self, first_ns: int, last_ns: int) -> Implausible | None:
        """The first reading kept back in a stretch of time; None where all were plausible."""
        return next((one for at, one in tuple(self._bad) if first_ns <= at <= last_ns), None)

    def passed(self, readings: Sequence[R]) -> list[R]:
        """The readings, oldest first, that are now known to be plausible."""
        good: list[R] = []
        for reading in readings:
            stamp_ns, q_rad = reading.stamp_ns, reading.joints_rad
            self._watch(q_rad)
            wrong = self._impossible(stamp_ns, q_rad)
            if wrong is not None:
                self.impossible += 1
                self.outside += wrong.kind == "limits"
                self._keep_back(stamp_ns, wrong)
            else:
                self._held.append(reading)
            self._settle(good)
            if not self._held:
                self.judged_ns = stamp_ns
        return good

    def rest(self) -> list[R]:
        """What still waits at the end of the readings: too few to be called frozen."""
        rest, self._held = self._held, []
        return rest

    def _watch(self, q_rad: Sequence[float]) -> None:
        if self._raw is not None:
            for joint, before_rad, now_rad in zip(self._joints, self._raw, q_rad, strict=True):
                joint.watch(before_rad, now_rad)
        self._raw = q_rad

    def _settle(self, good: list[R]) -> None:
        """Lets go what waits, or keeps it back where a joint is frozen."""
        held, longest, which = self._held, 0, None
        for joint in self._joints:
            if joint.noisy and joint.equal > longest:
                longest, which = joint.equal, joint
        if which is None or longest < EQUAL_HELD:
            good += held
            held.clear()
        elif longest >= EQUAL_FROZEN:
            at = self._joints.index(which)
            for reading in held:
                self.frozen += 1
                stamp_ns, stands_rad = reading.stamp_ns, reading.joints_rad[at]
                wrong = Implausible("frozen", stamp_ns, which.name, stands_rad, which.limits_rad)
                self._keep_back(stamp_ns, wrong)
            held.clear()

    def _keep_back(self, stamp_ns: int, wrong: Implausible) -> None:
        self.newest, self.first = wrong, self.first or wrong
        self._bad.append((stamp_ns, wrong))

    def _impossible(self, stamp_ns: int, q_rad: Sequence[float]) -> Implausible | None:
        """What is impossible in a reading by itself, or after the ones before; None for nothing."""
        for joint, angle_rad in zip(self._joints, q_rad, strict=True):
            if not joint.low <= angle_rad <= joint.high or not math.isfinite(angle_rad):
                kind: Kind = "limits" if math.isfinite(angle_rad) else "number"
                return Implausible(kind, stamp_ns, joint.name, angle_rad, joint.limits_rad)
        wrong = self._jump(self._last, stamp_ns, q_rad)
        if wrong is not None and not self._stays_aside(stamp_ns, q_rad):
            return wrong
        self._follow(stamp_ns, q_rad)
        return None

    def _jump(self, last: At | None, stamp_ns: int, q_rad: Sequence[float]) -> Implausible | None:
        """Where a joint cannot have come from the last good reading to this one."""
        if last is None:
            return None
        passed_s = (stamp_ns - last[0]) / 1e9
        if passed_s <= 0 or (passed_s > FORGET_S and self._aside is None):
            return None
        step_s = min(max(passed_s, self._period_s), LONGEST_STEP_S)
        gained_rad = 0.5 * MOST_ACCELERATION_RAD_S2 * step_s * step_s if self._paced else math.inf
        way_rad = MOST_SPEED_RAD_S * step_s
        for joint, before_rad, now_rad in zip(self._joints, last[1], q_rad, strict=True):
            moved = math.remainder(now_rad - before_rad, math.tau)
            surprise = abs(moved - joint.speed_rad_s * step_s)
            # stamps may be off by a period where they are taken at arrival
            unsure_rad = joint.noise_rad + abs(joint.speed_rad_s) * self._period_s
            if abs(moved) > way_rad + unsure_rad or surprise > gained_rad + unsure_rad:
                return Implausible("jump", stamp_ns, joint.name, now_rad, joint.limits_rad, moved)
        return None

    def _stays_aside(self, stamp_ns: int, q_rad: Sequence[float]) -> bool:
        """Whether the readings have long gone on from where a joint jumped to."""
        last = self._aside_last
        self._aside_last = (stamp_ns, q_rad)
        goes_on = last is not None and 0 < stamp_ns - last[0] < FORGET_S * 1e9
        if goes_on and last is not None:
            way_rad = MOST_SPEED_RAD_S * max((stamp_ns - last[0]) / 1e9, self._period_s)
            goes_on = all(
                abs(math.remainder(now - before, math.tau)) <= way_rad + joint.noise_rad
                for joint, before, now in zip(self._joints, last[1], q_rad, strict=True)
            )
        if self._aside is None or not goes_on:
            self._aside = (stamp_ns, q_rad)
        return stamp_ns - self._aside[0] >= SETTLED_S * 1e9

    def _follow(self, stamp_ns: int, q_rad: Sequence[float]) -> None:
        """Takes a good reading as the one to go on from."""
        last = self._last
        passed_s = 0.0 if last is None else (stamp_ns - last[0]) / 1e9
        self._paced = last is not None and 0 < passed_s <= FORGET_S
        if last is not None and self._paced:
            per_s = 1 / max(passed_s, self._period_s)
            for joint, before_rad, now_rad in zip(self._joints, last[1], q_rad, strict=True):
                joint.speed_rad_s = math.remainder(now_rad - before_rad, math.tau) * per_s
        self._last = (stamp_ns, q_rad)
        self._aside = self._aside_last = None
