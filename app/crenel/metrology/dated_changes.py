"""Changes of a figure between dated tests, and the periods in which it differed from a level that
is taken as right."""

from collections.abc import Iterable
from dataclasses import dataclass
from datetime import datetime


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
    """The standard uncertainty of the difference of both, k = 1."""

    @property
    def size(self) -> float:
        """By how much the figure changed."""
        return self.after_value - self.before_value


@dataclass(frozen=True, slots=True)
class DriftLevel:
    """The mean of a figure between two changes."""

    since: datetime
    """The time of its first value, as ``until`` is that of its last one."""
    until: datetime
    value: float
    values: int


@dataclass(frozen=True, slots=True)
class ChangedPeriod:
    """A stretch of time in which a figure differed from the level that is taken as right."""

    change: DriftChange | None
    """None: it differed from the first value on."""
    ended: DriftChange | None
    """None: it lasts."""
    levels: tuple[DriftLevel, ...]
    """In it, one after the other; never empty."""
    right_value: float

    @property
    def size(self) -> float:
        """By how much the level differed most."""
        return max((one.value - self.right_value for one in self.levels), key=abs)

    @property
    def standard_uncertainty(self) -> float:
        """The standard uncertainty of the difference at its beginning, or else at its end, k =
        1."""
        known = self.change or self.ended
        return 0.0 if known is None else known.standard_uncertainty

    @property
    def since(self) -> datetime | None:
        """The first moment that may be in it; None: no value bounds it."""
        return None if self.change is None else self.change.earliest

    @property
    def until(self) -> datetime | None:
        """The last moment that may be in it; None: it lasts."""
        return None if self.ended is None else self.ended.latest

    def surely_contains(self, at: datetime) -> bool:
        """Whether a moment is within both 95 % bounds."""
        begun = self.levels[0].since if self.change is None else self.change.latest
        ended = self.ended is not None and at > self.ended.earliest
        return at >= begun and not ended

    def surely_excludes(self, at: datetime) -> bool:
        """Whether a moment is outside both 95 % bounds."""
        before = self.since is not None and at <= self.since
        return before or (self.until is not None and at >= self.until)

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
