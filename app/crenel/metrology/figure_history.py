"""A figure over time: its levels, which of them is taken as right, and when it differed."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from datetime import datetime
from itertools import pairwise
from typing import Literal

import numpy as np

from crenel.metrology.calibration_levels import CalibrationLevels, find_calibration_levels
from crenel.metrology.change_points import (
    LEAST_VALUES,
    MOST_VALUES,
    ChangePoint,
    find_changes,
    find_standing_out,
    replace_outliers,
    variance_widening,
    working_sd,
)
from crenel.metrology.dated_changes import ChangedPeriod, DriftChange, DriftLevel
from crenel.metrology.transforms import Floats

SAME_LEVEL = 3.0
"""Standard uncertainties: levels that differ by less are the same."""
CLEAR_MAJORITY = 0.75
"""A share of all values: a level with more of them is taken as right instead of the first one."""
RightBecause = Literal["first", "most", "chosen"]


@dataclass(frozen=True, slots=True)
class RightLevel:
    """The level that is taken as right; the values themselves do not tell which one is."""

    since: datetime
    """The time of its first value."""
    value: float
    values: int
    """That agree with it, also after it was left and found again."""
    because: RightBecause
    """It is the first one, or that of most values, or somebody chose it."""


@dataclass(frozen=True, slots=True)
class StandingOut:
    """A single value far from its level."""

    at: datetime
    value: float
    calibration_id: str


@dataclass(frozen=True, slots=True)
class DoubtfulCalibration:
    """A calibration that lies far from the others, but not surely further than they spread."""

    calibration_id: str
    size: float
    """The size of its own error."""
    since: datetime
    """The first test with it, as ``until`` the last one."""
    until: datetime


@dataclass(frozen=True, slots=True)
class OwnErrorSpread:
    """How far the calibrations of one station lie from each other."""

    calibrations: int
    standard_deviation: float | None
    """The standard deviation of their own errors, k = 1; None: too few calibrations, or tests of
    each, tell."""
    doubtful: tuple[DoubtfulCalibration, ...]


@dataclass(frozen=True, slots=True)
class FigureHistory:
    """What the values of a figure of one station tell."""

    changes: tuple[DriftChange, ...]
    levels: tuple[DriftLevel, ...]
    """Before, between and behind the changes; empty without values."""
    right: RightLevel | None
    """None without values."""
    periods: tuple[ChangedPeriod, ...]
    standing_out: tuple[StandingOut, ...]
    """One or two values together, which are too few for a period."""
    spread: OwnErrorSpread


def find_history(
    times: Sequence[datetime],
    values: Sequence[float],
    calibrations: Sequence[str] = (),
    right_since: datetime | None = None,
) -> FigureHistory:
    """The changes of a figure, of the newest ``MOST_VALUES`` values.

    Changes that ordinary errors of the calibrations explain are none. A period ends as soon as the
    level is the right one again, whatever levels lie between.

    Args:
        times: of the values, in order.
        calibrations: of each value, empty if unknown; none: all unknown.
        right_since: the level of the first value from then on is right, and that of the last value
            if there is none. Default: the first level, or another one with more than
            ``CLEAR_MAJORITY`` of the values.

    Example:
        >>> days = [datetime(2026, 5, day) for day in range(1, 19)]
        >>> good, bad = [1.0, 1.1, 0.9], [5.0, 5.1, 4.9]
        >>> found = find_history(days, good * 2 + bad * 2 + good * 2)
        >>> (period,) = found.periods
        >>> period.change.by.day, period.ended.by.day, round(period.size, 1)
        (7, 13, 4.0)
        >>> found.right.value, found.right.values, found.right.because
        (1.0, 12, 'first')
    """
    times, values = times[-MOST_VALUES:], values[-MOST_VALUES:]
    used = calibrations[-MOST_VALUES:] or [""] * len(values)
    series = np.array(values, dtype=np.float64)
    found = find_calibration_levels(series, used)
    spread = _describe_spread(times, used, found)
    if len(series) < LEAST_VALUES:
        return FigureHistory((), (), None, (), (), spread)
    segments = _Segments(times, series, used, found)
    changes, levels = segments.changes(), segments.levels()
    right, because = segments.choose_right(right_since)
    like_right = [segments.agree(right, one) for one in range(len(levels))]
    return FigureHistory(
        changes,
        levels,
        RightLevel(
            levels[right].since,
            levels[right].value,
            sum(one.values for one, like in zip(levels, like_right, strict=True) if like),
            because,
        ),
        tuple(_periods(changes, levels, like_right, levels[right].value)),
        segments.standing_out(),
        spread,
    )


def _describe_spread(
    times: Sequence[datetime], calibrations: Sequence[str], found: CalibrationLevels | None
) -> OwnErrorSpread:
    number = len({one for one in calibrations if one})
    if found is None:
        return OwnErrorSpread(number, None, ())
    doubtful = []
    for name, size in found.doubtful.items():
        tests = [at for at, used in zip(times, calibrations, strict=True) if used == name]
        doubtful.append(DoubtfulCalibration(name, size, tests[0], tests[-1]))
    return OwnErrorSpread(number, found.spread_sd, tuple(doubtful))


class _Segments:
    """The values between changes, less the ordinary errors of their calibrations."""

    def __init__(
        self,
        times: Sequence[datetime],
        values: Floats,
        calibrations: Sequence[str],
        found: CalibrationLevels | None,
    ) -> None:
        least_sd = 0.0 if found is None else found.scatter_sd
        self._times, self._calibrations = times, calibrations
        self._raw = values
        self._values = values if found is None else values - found.own_errors
        self._sd = working_sd(self._values, least_sd)
        self._spread_sd = 0.0 if found is None else found.spread_sd
        self._found = find_changes(self._values, least_sd)
        self._bounds = [0, *(one.index for one in self._found), len(values)]
        plain = replace_outliers(self._values, self._sd)
        widening = variance_widening(plain, self._bounds[1:-1])
        self._mean_sd = self._sd * float(np.sqrt(widening))
        self._means = [float(plain[a:b].mean()) for a, b in pairwise(self._bounds)]

    def levels(self) -> tuple[DriftLevel, ...]:
        bounds = pairwise(self._bounds)
        return tuple(
            DriftLevel(self._times[begin], self._times[end - 1], mean, end - begin)
            for (begin, end), mean in zip(bounds, self._means, strict=True)
        )

    def changes(self) -> tuple[DriftChange, ...]:
        return tuple(self._describe(number, one) for number, one in enumerate(self._found))

    def agree(self, one: int, other: int) -> bool:
        """Whether two levels are the same within their uncertainty."""
        difference = abs(self._means[one] - self._means[other])
        return one == other or difference <= SAME_LEVEL * self._uncertainty(one, other)

    def choose_right(self, since: datetime | None) -> tuple[int, RightBecause]:
        """The number of the level that is taken as right, and why."""
        numbers = range(len(self._means))
        if since is not None:
            later = (n for n in numbers if self._times[self._bounds[n + 1] - 1] >= since)
            return next(later, numbers[-1]), "chosen"
        sizes = np.diff(self._bounds)
        agreeing = [sum(int(sizes[m]) for m in numbers if self.agree(n, m)) for n in numbers]
        most = max(numbers, key=lambda n: (agreeing[n], sizes[n]))
        clear = agreeing[most] > CLEAR_MAJORITY * len(self._values)
        return (most, "most") if clear and not self.agree(0, most) else (0, "first")

    def standing_out(self) -> tuple[StandingOut, ...]:
        means = np.repeat(self._means, np.diff(self._bounds))
        unsure = {n for one in self._found for n in range(one.first_index - 1, one.last_index + 1)}
        return tuple(
            StandingOut(self._times[one], float(self._raw[one]), self._calibrations[one])
            for one in find_standing_out(self._values, means, self._sd)
            if one not in unsure
        )

    def _describe(self, number: int, found: ChangePoint) -> DriftChange:
        return DriftChange(
            after=self._times[found.index - 1],
            by=self._times[found.index],
            earliest=self._times[found.first_index - 1],
            latest=self._times[found.last_index],
            before_value=found.before,
            after_value=found.after,
            standard_uncertainty=self._uncertainty(number, number + 1),
        )

    def _uncertainty(self, one: int, other: int) -> float:
        """The uncertainty of the difference of two levels, k = 1; if they share a calibration, its
        error is none."""
        spans = [slice(self._bounds[n], self._bounds[n + 1]) for n in (one, other)]
        variance = self._mean_sd**2 * sum(1.0 / (span.stop - span.start) for span in spans)
        used = [set(self._calibrations[span]) for span in spans]
        if not used[0] & used[1]:
            variance += self._spread_sd**2 * sum(1.0 / len(its) for its in used)
        return float(np.sqrt(variance))


def _periods(
    changes: Sequence[DriftChange],
    levels: Sequence[DriftLevel],
    like_right: Sequence[bool],
    right_value: float,
) -> Iterator[ChangedPeriod]:
    """Levels one after the other that are not the right one, together."""
    begin = 0
    while begin < len(levels):
        end = begin
        while end < len(levels) and not like_right[end]:
            end += 1
        if end > begin:
            yield ChangedPeriod(
                changes[begin - 1] if begin else None,
                changes[end - 1] if end < len(levels) else None,
                tuple(levels[begin:end]),
                right_value,
            )
        begin = end + 1
