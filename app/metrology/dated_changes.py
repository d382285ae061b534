"""Changes of a figure between dated tests: when, by how much, by which calibrations."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from datetime import datetime

import numpy as np

from app.metrology.change_points import MOST_VALUES, ChangePoint, find_changes


@dataclass(frozen=True, slots=True)
class DriftChange:
    """A change of a figure of one station."""

    after: datetime
    """It happened behind this value, most probably, and not behind ``by``."""
    by: datetime
    earliest: datetime
    """The same with a probability of 95 %."""
    latest: datetime
    before_value: float
    after_value: float
    standard_uncertainty: float
    """Of the difference of both, k = 1."""

    @property
    def size(self) -> float:
        """By how much the figure changed."""
        return self.after_value - self.before_value


@dataclass(frozen=True, slots=True)
class ChangedPeriod:
    """A stretch of time in which a figure differed from that before."""

    change: DriftChange
    ended: DriftChange | None = None
    """None: it lasts."""

    @property
    def until(self) -> datetime | None:
        """The last moment that may be in it; None: it lasts."""
        return None if self.ended is None else self.ended.latest

    def surely_contains(self, at: datetime) -> bool:
        """Whether a moment is within both 95 % bounds."""
        ended = self.ended is not None and at > self.ended.earliest
        return at >= self.change.latest and not ended

    def surely_excludes(self, at: datetime) -> bool:
        """Whether a moment is outside both 95 % bounds."""
        return at <= self.change.earliest or (self.until is not None and at >= self.until)

    def explaining_calibrations(self, tests: Iterable[tuple[datetime, str]]) -> tuple[str, ...]:
        """The calibrations of the tests that are surely within, if no test that is surely outside
        used one of them.

        Args:
            tests: when each was, and the calibration that it used; empty if unknown.
        """
        inside, outside = set(), set()
        for at, calibration_id in tests:
            if self.surely_contains(at):
                inside.add(calibration_id)
            elif self.surely_excludes(at):
                outside.add(calibration_id)
        if "" in inside or inside & outside:
            return ()
        return tuple(sorted(inside))


def find_dated_changes(
    times: Sequence[datetime], values: Sequence[float]
) -> tuple[DriftChange, ...]:
    """The changes of a figure, of the newest ``MOST_VALUES`` values.

    Args:
        times: of the values, in order.

    Example:
        >>> days = [datetime(2026, 5, day) for day in range(1, 13)]
        >>> (found,) = find_dated_changes(days, [1.0, 1.1, 0.9] * 2 + [5.0, 5.1, 4.9] * 2)
        >>> found.after.day, found.by.day, round(found.size, 2)
        (6, 7, 4.0)
    """
    times, values = times[-MOST_VALUES:], values[-MOST_VALUES:]
    return tuple(_describe_change(times, one) for one in find_changes(np.array(values)))


def find_periods(changes: Sequence[DriftChange]) -> Iterator[ChangedPeriod]:
    """A change with the one behind it, if that leads back to the level before."""
    left = list(changes)
    while left:
        change = left.pop(0)
        back = bool(left) and _leads_back(change, left[0])
        yield ChangedPeriod(change, left.pop(0) if back else None)


def _describe_change(times: Sequence[datetime], found: ChangePoint) -> DriftChange:
    return DriftChange(
        after=times[found.index - 1],
        by=times[found.index],
        earliest=times[found.first_index - 1],
        latest=times[found.last_index],
        before_value=found.before,
        after_value=found.after,
        standard_uncertainty=found.standard_uncertainty,
    )


def _leads_back(change: DriftChange, following: DriftChange) -> bool:
    """Whether a change undoes most of the one before."""
    return abs(following.after_value - change.before_value) < abs(change.size) / 2
