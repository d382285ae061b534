"""Encoders that stand still while their joints may move."""

import math
from collections import deque
from collections.abc import Sequence

from crenel.metrology.arm.joint_plausibility.implausible import EQUAL_FROZEN
from crenel.metrology.arm.joint_plausibility.reach import PACE, Stop

EQUAL_PENDING = 2
"""A joint with visible noise occasionally repeats a reading; checks start from this number."""
WATCHED, REVERSALS, LARGE_STEPS = 64, 16, 1.5
"""Noise is visible if this many of this many readings reverse by more than one encoder step: one
step back and forth may be a joint between two steps."""
MOVING_STEPS = 6.0
"""While the joint moves, noise shows in third differences: for a smooth rotation they are below
four encoder steps, or do not alternate."""
SAME_STEP, FINEST, COARSEST = 1.5, 0.5, 2.0
"""Factors by which step and noise of encoders of one kind may differ."""
ROUNDING_RAD = 1e-12
QUIET = 20
"""An encoder that changes after this many equal readings has too little noise for a judgement."""
COARSEST_STEP_RAD = math.tau / 2**12
"""A larger change is more than one step."""
STOPPED_RAD_S = 0.3
STOPPED_RAD_S2 = 150.0
"""A person cannot stop a joint from such a speed any faster."""
STEADY, STEADY_S = 0.75, 0.004
"""If a joint does not slow down by this share of its speed in this time, it will not in the
next."""
STOPPED_S = 0.1
MOVING_RAD_S, MOVING_S = 0.2, 0.02
"""Other joints keep moving if one of them turns faster than this, this soon after a stop."""
AT_LIMIT_RAD = math.radians(2.0)
MOST_KEPT = 64


class Encoder:
    """What is known about the encoder of one joint from its readings so far."""

    def __init__(self) -> None:
        self.low_rad, self.high_rad = -math.inf, math.inf
        self.sd_rad = 0.0
        """The noise in its datasheet."""
        self.step_rad = math.inf
        """The smallest change so far, and the smallest difference between two changes."""
        self.noisy = self.frozen = False
        self.quiet = False
        """It repeated one reading for long and then continued: this shows nothing about it."""
        self.equal = 0
        """Number of repetitions of the newest reading."""
        self.since_ns = 0
        """Time of its first occurrence."""
        self.stop: Stop | None = None
        self._seen = self._reversals = self._moving_reversals = 0
        self._way = self._turn = self._third = 0.0

    def change(self, stamp_ns: int, change_rad: float) -> bool:
        """Adds a reading that differs; True if the encoder's step estimate changed."""
        self.quiet = self.quiet or (self.equal >= QUIET and not self.frozen)
        self.equal, self.since_ns, self.frozen = 0, stamp_ns, False
        return abs(change_rad) < self.step_rad and self._learn(abs(change_rad))

    def watch(self, change_rad: float) -> bool:
        """Learns whether noise is visible in the changes between readings; True if the encoder's
        step estimate changed."""
        way, learnt = self._way, False
        turn = change_rad - way
        third = turn - self._turn
        # changes are whole steps, and so are their differences
        if ROUNDING_RAD < abs(turn) < self.step_rad:
            learnt = self._learn(abs(turn))
        if change_rad * way < 0 and abs(change_rad) > LARGE_STEPS * self.step_rad:
            self._reversals += 1
        if third * self._third < 0 and abs(third) > MOVING_STEPS * self.step_rad:
            self._moving_reversals += 1
        self._way, self._turn, self._third = change_rad, turn, third
        self._seen += 1
        # uneven sampling of a moving joint looks alike: only if the datasheet agrees
        if self._reversals >= REVERSALS or (
            self._moving_reversals >= REVERSALS and self.sd_rad >= self.step_rad
        ):
            self.noisy = True
        if self._seen >= WATCHED:
            self._seen = self._reversals = self._moving_reversals = 0
        return learnt

    def _learn(self, step_rad: float) -> bool:
        learnt = step_rad < 0.999 * self.step_rad  # not because of the last digit of a number
        self.step_rad = step_rad
        return learnt


class Standstill:
    """Detects encoders that repeat a reading to the last digit although they cannot.

    Two signs reveal such an encoder. Its noise is missing: it was seen before, or is seen at most
    of the other joints, whose encoders are of the same kind by datasheet and step. Or, if an
    encoder is too coarse to show noise, the joint stopped instantly out of a steady rotation, away
    from its limits, while others continue. A joint that merely stands still shows neither.
    """

    def __init__(self, joint_count: int, rate_hz: float) -> None:
        self.encoders = [Encoder() for _ in range(joint_count)]
        self.stops: list[Stop | None] = [None] * joint_count
        """Times at which joints stopped instantly, while their readings repeat."""
        self._stopped: list[Stop | None] = [None] * joint_count
        """The same after one equal reading, which slow joints also show."""
        self._period_s = 1.0 / max(rate_hz, 1.0)
        self._before: deque[tuple[int, Sequence[float]]] = deque(maxlen=MOST_KEPT)

    def watch(self, stamp_ns: int, q_rad: Sequence[float]) -> bool:
        """Takes the next reading (n,); True if the step estimate of an encoder changed."""
        if not self._before:
            for encoder in self.encoders:
                encoder.since_ns = stamp_ns
            self._before.append((stamp_ns, q_rad))
            return False
        last_ns, last_rad = self._before[-1]
        passed_s = (stamp_ns - last_ns) / 1e9
        self._period_s += PACE * (min(max(passed_s, 0.0), 2 * self._period_s) - self._period_s)
        learnt = False
        for joint, encoder in enumerate(self.encoders):
            change_rad = q_rad[joint] - last_rad[joint]
            if change_rad:
                learnt = encoder.change(stamp_ns, change_rad) or learnt
            else:
                encoder.equal += 1
                if encoder.equal == 1:
                    self._stopped[joint] = self._stop(joint)
                elif encoder.equal == EQUAL_PENDING:
                    stop = self._stopped[joint]
                    if stop is None and encoder.noisy:  # then it need not have been fast
                        stop = (encoder.since_ns, q_rad[joint], self._speed(joint))
                    self.stops[joint] = stop
            if not encoder.noisy:
                learnt = encoder.watch(change_rad) or learnt
        self._before.append((stamp_ns, q_rad))
        return learnt

    def read_on(self) -> None:
        """Removes the stops of joints whose readings change again, after they were judged."""
        for joint, encoder in enumerate(self.encoders):
            if not encoder.equal:
                self.stops[joint] = None

    def step_rad(self, joint: int) -> float:
        """The encoder's step: the smallest change it showed, otherwise the largest step of the
        others; 0 if none is known, and at most that of the coarsest encoder."""
        return min(self._step_rad(joint), COARSEST_STEP_RAD)

    def _step_rad(self, joint: int) -> float:
        own = self.encoders[joint].step_rad
        if math.isfinite(own):
            return own
        steps = [one.step_rad for one in self.encoders if math.isfinite(one.step_rad)]
        return max(steps, default=0.0)

    def find(self) -> tuple[bool, int | None]:
        """Whether a joint may be frozen, and which one is."""
        may_be_frozen = False
        for joint, encoder in enumerate(self.encoders):
            if encoder.equal < EQUAL_PENDING:
                continue
            if encoder.frozen:
                return True, joint
            noiseless = encoder.noisy or self._should_be_noisy(joint)
            if not noiseless and (self.stops[joint] is None or not self._others_go_on(joint)):
                continue
            may_be_frozen = True
            if encoder.equal >= EQUAL_FROZEN and (noiseless or self._stands_long(joint)):
                encoder.frozen = True
                return True, joint
        return may_be_frozen, None

    def _should_be_noisy(self, joint: int) -> bool:
        """Whether its encoder is one that shows noise."""
        encoder = self.encoders[joint]
        if encoder.quiet or not encoder.sd_rad:
            return False
        noisy = [one for one in self.encoders if one.noisy]
        if 2 * len(noisy) < len(self.encoders):
            return False
        finest = min(one.sd_rad for one in noisy)
        coarsest = max(one.sd_rad for one in noisy)
        step_rad = max(one.step_rad for one in noisy)
        return (
            FINEST * finest <= encoder.sd_rad <= COARSEST * coarsest
            and self._step_rad(joint) <= SAME_STEP * step_rad
            and encoder.sd_rad >= 0.5 * step_rad
        )

    def _stop(self, joint: int) -> Stop | None:
        """Position of a joint that turned steadily up to the reading before the newest."""
        before, period_s = self._before, self._period_s
        count = self._steady_count()
        if len(before) <= 2 * count:
            return None
        end_ns, end = before[-1]
        span_s = count * period_s
        turned = math.remainder(end[joint] - before[-1 - count][1][joint], math.tau)
        speed = turned / span_s
        if abs(speed) < max(STOPPED_RAD_S, STOPPED_RAD_S2 * 0.5 * (span_s + period_s)):
            return None
        first_ns, first = before[-1 - 2 * count]
        if not 0.5 < (end_ns - first_ns) / 1e9 / (2 * span_s) < 1.5:
            return None
        angle = end[joint]
        if not self._is_inside(joint, angle):
            return None
        earlier = math.remainder(angle - first[joint], math.tau) - turned
        slack_rad = self.encoders[joint].step_rad
        steady = abs(turned) >= STEADY * abs(earlier) - slack_rad and turned * earlier > 0
        return (end_ns, angle, speed) if steady else None

    def _speed(self, joint: int) -> float:
        """Speed of a joint before its reading repeated, in rad/s."""
        count = self._steady_count()
        if len(self._before) < count + 2:
            return 0.0
        turned = self._before[-2][1][joint] - self._before[-2 - count][1][joint]
        return math.remainder(turned, math.tau) / (count * self._period_s)

    def _steady_count(self) -> int:
        return min(max(round(STEADY_S / self._period_s), 1), MOST_KEPT // 2 - 1)

    def _is_inside(self, joint: int, angle_rad: float) -> bool:
        encoder = self.encoders[joint]
        return encoder.low_rad + AT_LIMIT_RAD < angle_rad < encoder.high_rad - AT_LIMIT_RAD

    def _others_go_on(self, joint: int) -> bool:
        """Whether another joint has continued turning since one stopped."""
        stop = self.stops[joint]
        if stop is None:
            return False
        newest_ns, newest = self._before[-1]
        passed_s = (newest_ns - stop[0]) / 1e9
        if passed_s < MOVING_S:
            return True
        since = next((one for one in self._before if one[0] >= stop[0]), self._before[0])
        spent_s = (newest_ns - since[0]) / 1e9
        going = any(
            abs(math.remainder(now - then, math.tau)) >= MOVING_RAD_S * spent_s
            for other, (now, then) in enumerate(zip(newest, since[1], strict=True))
            if other != joint
        )
        if not going:
            self.stops[joint] = None
        return going

    def _stands_long(self, joint: int) -> bool:
        stop = self.stops[joint]
        return stop is not None and self._before[-1][0] - stop[0] >= STOPPED_S * 1e9
