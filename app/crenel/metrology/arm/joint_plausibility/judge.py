"""Judges the readings of an arm: plausible readings pass, all others are held back and reported."""

import math
from collections import deque
from collections.abc import Sequence
from typing import Generic, Protocol, TypeVar

from crenel.metrology.arm.joint_plausibility.frozen import Standstill
from crenel.metrology.arm.joint_plausibility.implausible import (
    STOP_TOLERANCE_RAD,
    ImplausibleKind,
    ImplausibleReading,
)
from crenel.metrology.arm.joint_plausibility.reach import Reach
from crenel.metrology.arm.joint_plausibility.spikes import LATER, Spikes
from crenel.metrology.arm.kinematics import Arm

REMEMBERED = 4096
NOISE_SDS, STEPS = 12.0, 2.0
"""In a speed from two readings, the noise and the step of the encoder look like motion."""
UNKNOWN_SD_RAD = 1e-4
"""For encoders whose datasheet states no noise."""


class JointReading(Protocol):
    """One sample of all encoders."""

    @property
    def stamp_ns(self) -> int: ...

    @property
    def joints_rad(self) -> Sequence[float]:
        """(n,)"""


R = TypeVar("R", bound=JointReading)


class PlausibilityFilter(Generic[R]):
    """Lets plausible readings pass and holds the others back.

    A reading is impossible if it is not a number, lies outside the limits of its joint, is further
    from the previous ones than a joint can turn (``Reach``), or stands out alone from the motion
    around it (``Spikes``). A joint is frozen if its reading repeats to the last digit although it
    cannot (``Standstill``). Each reading waits for the next three, and one that may turn out frozen
    until that is known.

    Args:
        arm: None while unknown: then limits are not judged.
    """

    def __init__(self, joint_count: int, rate_hz: float, arm: Arm | None = None) -> None:
        self.impossible = self.frozen = 0
        """Number of readings held back so far."""
        self.outside = 0
        """Number of impossible readings outside the joint limits."""
        self.newest: ImplausibleReading | None = None
        self.first: ImplausibleReading | None = None
        self.judged_ns: int | None = None
        """Readings up to this one are judged, and none of them waits."""
        self._names = [f"J{i + 1}" for i in range(joint_count)]
        self._limits_rad = [(-math.inf, math.inf)] * joint_count
        self._ranges_rad = self._limits_rad
        self._reach = Reach(joint_count, rate_hz)
        self._spikes = Spikes(joint_count)
        self._standstill = Standstill(joint_count, rate_hz)
        self._count = 0
        self._pending: deque[tuple[int, R]] = deque()
        """Waiting readings, with their running numbers."""
        self._rejected: deque[tuple[int, ImplausibleReading]] = deque(maxlen=REMEMBERED)
        self.set_arm(arm)

    @property
    def rejected_count(self) -> int:
        return self.impossible + self.frozen

    def set_arm(self, arm: Arm | None) -> None:
        """Sets the arm whose limits apply from now on; the knowledge about the encoders is kept."""
        if arm is not None and arm.joint_count == len(self._names):
            self._names = [joint.name for joint in arm.joints]
            self._limits_rad = [joint.limits_rad for joint in arm.joints]
            self._ranges_rad = [
                (low - STOP_TOLERANCE_RAD, high + STOP_TOLERANCE_RAD)
                for low, high in self._limits_rad
            ]
            for joint, encoder in zip(arm.joints, self._standstill.encoders, strict=True):
                encoder.sd_rad = joint.encoder_sd_rad
                encoder.low_rad, encoder.high_rad = joint.limits_rad
        self._set_noise()

    def forget_place(self) -> None:
        """The arm reconnects: its joints may be anywhere, and none has slipped."""
        self._reach.forget()
        self._spikes.forget()

    def first_between(self, first_ns: int, last_ns: int) -> ImplausibleReading | None:
        """The first reading held back in an interval of time; None if all were plausible."""
        return next((one for at, one in tuple(self._rejected) if first_ns <= at <= last_ns), None)

    def filter(self, readings: Sequence[R]) -> list[R]:
        """Judges new readings.

        Args:
            readings: oldest first, with n angles in rad and increasing time stamps in ns.

        Returns:
            The readings, oldest first, now known to be plausible; the latest ones wait for
            those after them.
        """
        good: list[R] = []
        held = self._pending
        for reading in readings:
            stamp_ns, q_rad = reading.stamp_ns, reading.joints_rad
            self._count += 1
            wrong = self._number_or_limits(stamp_ns, q_rad)
            if wrong is None:
                if self._standstill.watch(stamp_ns, q_rad):
                    self._set_noise()
                wrong = self._jump(stamp_ns, q_rad)
            if wrong is not None:
                self.impossible += 1
                self.outside += wrong.kind == "limits"
                self._reject(stamp_ns, wrong)
            else:
                held.append((self._count, reading))
                self._drop_spike(stamp_ns, q_rad)
            self._release_pending(good)
            if not held:
                self.judged_ns = stamp_ns
        return good

    def flush(self) -> list[R]:
        """Readings that still wait at the end: too few to be judged."""
        rest = [reading for _, reading in self._pending]
        self._pending.clear()
        if rest:
            self.judged_ns = rest[-1].stamp_ns
        return rest

    def _set_noise(self) -> None:
        """Sets the noise and the steps to be expected of the encoders."""
        sds = [one.sd_rad or UNKNOWN_SD_RAD for one in self._standstill.encoders]
        steps = [self._standstill.step_rad(joint) for joint in range(len(sds))]
        self._spikes.set_noise(sds, steps)
        self._reach.unsure_rad = [
            NOISE_SDS * sd + STEPS * step for sd, step in zip(sds, steps, strict=True)
        ]

    def _number_or_limits(self, stamp_ns: int, q_rad: Sequence[float]) -> ImplausibleReading | None:
        """Why a reading is impossible by itself; None if it is possible."""
        for joint, (angle_rad, (low, high)) in enumerate(zip(q_rad, self._ranges_rad, strict=True)):
            if not low <= angle_rad <= high or not math.isfinite(angle_rad):
                kind: ImplausibleKind = "limits" if math.isfinite(angle_rad) else "number"
                return self._implausible(kind, stamp_ns, joint, angle_rad)
        return None

    def _jump(self, stamp_ns: int, q_rad: Sequence[float]) -> ImplausibleReading | None:
        """Why a reading is impossible after the previous ones; None if it is possible."""
        jump = self._reach.follow(stamp_ns, q_rad, self._standstill.stops)
        self._standstill.read_on()
        if jump is None:
            return None
        kind: ImplausibleKind = "slip" if jump.stays else "jump"
        return self._implausible(kind, stamp_ns, jump.joint, q_rad[jump.joint], jump.step_rad)

    def _drop_spike(self, stamp_ns: int, q_rad: Sequence[float]) -> None:
        """Holds back the reading that the newest one shows to stand out alone from the motion
        around it."""
        spike = self._spikes.find(stamp_ns, q_rad)
        if spike is None:
            return
        place = len(self._pending) - 1 - LATER
        if place < 0 or self._pending[place][1].stamp_ns != spike.stamp_ns:
            return  # it was released if the readings in between were bad as well
        reading = self._pending[place][1]
        del self._pending[place]
        self.impossible += 1
        angle_rad = reading.joints_rad[spike.joint]
        wrong = self._implausible("spike", spike.stamp_ns, spike.joint, angle_rad, spike.off_rad)
        self._reject(spike.stamp_ns, wrong)

    def _release_pending(self, good: list[R]) -> None:
        """Releases what waited long enough, and holds back the readings of a frozen joint."""
        held, (may_be_frozen, joint) = self._pending, self._standstill.find()
        if joint is not None:
            since_ns = self._standstill.encoders[joint].since_ns
            for _, reading in held:
                if reading.stamp_ns <= since_ns:
                    good.append(reading)
                    continue
                self.frozen += 1
                stamp_ns, angle_rad = reading.stamp_ns, reading.joints_rad[joint]
                self._reject(stamp_ns, self._implausible("frozen", stamp_ns, joint, angle_rad))
            held.clear()
            # the position of the joint in the meantime is unknown
            self._reach.lose()
            self._spikes.forget()
        elif not may_be_frozen:
            while held and held[0][0] <= self._count - LATER:
                good.append(held.popleft()[1])

    def _implausible(
        self,
        kind: ImplausibleKind,
        stamp_ns: int,
        joint: int,
        angle_rad: float,
        step_rad: float = 0.0,
    ) -> ImplausibleReading:
        limits_rad = self._limits_rad[joint]
        return ImplausibleReading(
            kind, stamp_ns, self._names[joint], angle_rad, limits_rad, step_rad
        )

    def _reject(self, stamp_ns: int, wrong: ImplausibleReading) -> None:
        self.newest, self.first = wrong, self.first or wrong
        self._rejected.append((stamp_ns, wrong))
