"""Positions that joints can reach from the previous ones: jumps, and encoders that slipped."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

MOST_SPEED_RAD_S = 30.0
"""A person moves a tip at 2 m/s at most, and turns a wrist at less than three revolutions per
second."""
MOST_ACCELERATION_RAD_S2 = 5000.0
"""A knock of 50 g, 0.1 m from a joint's axis."""
MOST_KNOCK_RAD_S = 10.0
"""Total change of a joint's speed by a knock: 1 m/s, 0.1 m from its axis."""
UNSURE_PERIODS = 2.0
"""Time stamps taken on arrival are off by up to half a period, which affects the speed too."""
FORGET_S = 0.1
"""After a gap this long, a joint may be anywhere."""
ESTABLISHED_S = 0.1
"""A position that readings report for this long is one position, correct or not."""
SETTLED_S = 0.5
"""A joint that stays this long at a position to which a knock could have moved it is trusted
again."""
PACE = 0.05
"""Weight of the newest period in the smoothed one."""

At = tuple[int, Sequence[float]]
"""A time stamp in ns, and the encoder angles (n,) in rad."""
Stop = tuple[int, float, float]
"""An instant stop of a joint: time stamp in ns, angle in rad, speed before in rad/s."""


@dataclass(frozen=True)
class Jump:
    """A reading that a joint cannot have reached."""

    joint: int
    step_rad: float
    stays: bool = False
    """It stayed there so long, and jumped so far, that its encoder must have slipped."""


class Reach:
    """Tracks the joints by their last reading and their speeds.

    After a jump, tracking continues at the new position, and the step that led there is stored. A
    later reading that undoes the step is back at the correct position and trusted. A reading that
    stays is trusted after a while only if a knock may have caused it, or if several joints jumped
    at once; otherwise the encoder slipped, which remains so until it jumps back or ``forget`` is
    called.
    """

    def __init__(self, joint_count: int, rate_hz: float) -> None:
        self.unsure_rad = [0.0] * joint_count
        """Possible error of a reading due to the encoder's noise and steps."""
        self._nominal_s = self.period_s = 1.0 / max(rate_hz, 1.0)
        """Period of the readings: as the arm states, or as they arrive if they arrive more
        slowly."""
        self._last: At | None = None
        self._speeds_rad_s = [0.0] * joint_count
        self._step_s: float | None = None
        """The time over which the speeds were determined; None while they are unknown."""
        self._good_since_ns = self._good_ns = 0
        self._aside: list[float] | None = None
        """The steps (n,) in rad from the correct position to the present readings."""
        self._aside_since_ns = 0
        self._jumped = 0
        self._too_far = self._slipped = False

    def forget(self) -> None:
        """The joints may be anywhere, and none has slipped: the arm reconnects."""
        self._last = self._aside = None
        self._slipped = False

    def lose(self) -> None:
        """The joints may be anywhere, but encoders that slipped are still off."""
        self._last = None
        if not self._slipped:
            self._aside = None

    def follow(
        self, stamp_ns: int, q_rad: Sequence[float], stops: Sequence[Stop | None]
    ) -> Jump | None:
        """Why a reading is impossible after the previous ones; None if it is possible.

        Args:
            stops: for each joint, the position of an instant stop; its encoder may have repeated
                a reading for a while, and now changes again.
        """
        if self._last is None:
            return self._start(stamp_ns, q_rad)
        last_ns, last_rad = self._last
        passed_s = (stamp_ns - last_ns) / 1e9
        if not 0 < passed_s <= FORGET_S:
            self.lose()
            return self._start(stamp_ns, q_rad)
        period_s = self.period_s
        self.period_s = max(
            self._nominal_s, period_s + PACE * (min(passed_s, 2 * period_s) - period_s)
        )
        step_s = max(passed_s, period_s)
        gained_rad, way_rad = math.inf, MOST_SPEED_RAD_S * step_s
        if self._step_s is not None:
            change = MOST_ACCELERATION_RAD_S2 * 0.5 * (step_s + self._step_s)
            gained_rad = min(change, MOST_KNOCK_RAD_S) * step_s
        moves, off = [], None
        unsure_s = UNSURE_PERIODS * period_s
        for joint, (before, now, speed, unsure) in enumerate(
            zip(last_rad, q_rad, self._speeds_rad_s, self.unsure_rad, strict=True)
        ):
            moved = now - before
            if not -3.0 < moved < 3.0:
                moved = math.remainder(moved, math.tau)
            surprise = moved - speed * step_s
            unsure += abs(speed) * unsure_s
            if abs(surprise) > gained_rad + unsure or abs(moved) > way_rad + unsure:
                stop = stops[joint]
                if stop is not None and self._reads_on(stop, stamp_ns, now, unsure):
                    moved = stop[2] * step_s
                else:
                    off = off or [0.0] * len(q_rad)
                    off[joint] = surprise
            moves.append(moved)
        aside = self._aside
        if aside is None and off is None:
            self._go_on(stamp_ns, q_rad, moves, step_s)
            self._good_ns = stamp_ns
            return None
        return self._judge_aside(stamp_ns, q_rad, moves, off, step_s, gained_rad, way_rad)

    def _start(self, stamp_ns: int, q_rad: Sequence[float]) -> Jump | None:
        self._last, self._step_s = (stamp_ns, q_rad), None
        self._speeds_rad_s = [0.0] * len(q_rad)
        if self._aside is not None:
            return self._newest_jump()
        self._good_since_ns = self._good_ns = stamp_ns
        return None

    def _go_on(
        self, stamp_ns: int, q_rad: Sequence[float], moves: list[float], step_s: float
    ) -> None:
        per_s = 1.0 / step_s
        self._speeds_rad_s = [moved * per_s for moved in moves]
        self._last, self._step_s = (stamp_ns, q_rad), step_s

    def _reads_on(self, stop: Stop, stamp_ns: int, now_rad: float, unsure: float) -> bool:
        """Whether a joint can have come here from where its encoder stood still for a while."""
        stop_ns, stop_rad, speed = stop
        passed_s = (stamp_ns - stop_ns) / 1e9
        surprise = math.remainder(now_rad - stop_rad - speed * passed_s, math.tau)
        gained_rad = min(MOST_ACCELERATION_RAD_S2 * passed_s, MOST_KNOCK_RAD_S) * passed_s
        return abs(surprise) <= gained_rad + unsure + abs(speed) * UNSURE_PERIODS * self.period_s

    def _judge_aside(
        self,
        stamp_ns: int,
        q_rad: Sequence[float],
        moves: list[float],
        off: list[float] | None,
        step_s: float,
        gained_rad: float,
        way_rad: float,
    ) -> Jump | None:
        """Whether the readings returned, stay where they jumped to, or jump again."""
        aside = self._aside or [0.0] * len(moves)
        speeds, unsure_s = self._speeds_rad_s, UNSURE_PERIODS * self.period_s
        back, to_back, to_here = self._aside is not None, 0.0, 0.0
        for moved, step, speed, unsure in zip(moves, aside, speeds, self.unsure_rad, strict=True):
            surprise = math.remainder(moved - speed * step_s, math.tau)
            undone = math.remainder(surprise + step, math.tau)
            unsure += abs(speed) * unsure_s
            back = back and abs(undone) <= min(gained_rad, way_rad) + unsure
            to_back, to_here = to_back + abs(undone), to_here + abs(surprise)
        established = stamp_ns - self._aside_since_ns >= ESTABLISHED_S * 1e9
        if off is None and (established or self._slipped or to_here <= to_back):
            back = False  # they stay near the new position: what may be motion is not a jump back
        if back:
            moves = [m + a for m, a in zip(moves, aside, strict=True)]
            self._believe(stamp_ns)
        elif off is not None:
            self._jump(stamp_ns, aside, off)
            # after a jump, the speed is still that from before
            moves = [s * step_s if o else m for m, s, o in zip(moves, speeds, off, strict=True)]
        else:
            self._stay(stamp_ns)
        self._go_on(stamp_ns, q_rad, moves, step_s)
        return None if self._aside is None else self._newest_jump()

    def _believe(self, stamp_ns: int) -> None:
        self._aside, self._slipped = None, False
        self._good_ns = stamp_ns

    def _jump(self, stamp_ns: int, aside: list[float], off: list[float]) -> None:
        """Continues tracking from the position to which the readings jumped."""
        steps = [math.remainder(a + o, math.tau) for a, o in zip(aside, off, strict=True)]
        self._aside, self._aside_since_ns = steps, stamp_ns
        if self._slipped:
            return
        # by the time since the last good one: what was in between is unknown
        passed_s = max((stamp_ns - self._good_ns) / 1e9, self.period_s)
        known = self._good_ns - self._good_since_ns >= ESTABLISHED_S * 1e9
        beyond = [
            abs(step)
            - MOST_KNOCK_RAD_S * passed_s
            - unsure
            - abs(speed) * UNSURE_PERIODS * self.period_s
            for step, unsure, speed in zip(steps, self.unsure_rad, self._speeds_rad_s, strict=True)
        ]
        self._jumped = max(range(len(steps)), key=lambda joint: abs(steps[joint]))
        # one encoder slips; where several joints leapt, readings of the time in between are missing
        leapt = sum(one > 0 for one in beyond)
        self._too_far = known and passed_s <= FORGET_S and leapt == 1

    def _stay(self, stamp_ns: int) -> None:
        """A position that the readings report for a while is trusted, or has slipped."""
        stays_s = (stamp_ns - self._aside_since_ns) / 1e9
        if self._too_far and stays_s >= ESTABLISHED_S:
            self._slipped = True
        elif not self._slipped and stays_s >= SETTLED_S:
            self._believe(stamp_ns)
            self._good_since_ns = stamp_ns

    def _newest_jump(self) -> Jump:
        assert self._aside is not None, "nothing jumped"
        return Jump(self._jumped, self._aside[self._jumped], self._slipped)
