"""The period of a selection, as it is given on the command line."""

from dataclasses import dataclass
from datetime import UTC, datetime, timedelta

from crenel.errors import OperationError
from crenel.messages.message import message
from crenel.timestamps import parse_moment

EARLIEST = datetime(1970, 1, 1, tzinfo=UTC)
LATEST = datetime(9999, 1, 1, tzinfo=UTC)


@dataclass(frozen=True, slots=True)
class Period:
    """From a moment up to, but without, another one."""

    begin: datetime = EARLIEST
    end: datetime = LATEST

    def contains(self, at: datetime) -> bool:
        """Whether it began and has not ended."""
        return self.begin <= at < self.end


ALWAYS = Period()


def parse_period(text: str) -> Period:
    """A day, a month, a year, or two of these or of moments with ``..`` between; UTC.

    >>> period = parse_period("2026-05..2026-06-15")
    >>> period.begin.date().isoformat(), period.end.date().isoformat()
    ('2026-05-01', '2026-06-16')

    Raises:
        OperationError: it is none of these, or ends before it begins.
    """
    first, dots, last = text.strip().partition("..")
    try:
        begin = _bounds(first)[0] if first else EARLIEST
        end = _bounds(last)[1] if last else (LATEST if dots else _bounds(first)[1])
    except (ValueError, OverflowError):
        raise _period_error(text) from None
    if begin >= end:
        raise _period_error(text)
    return Period(begin, end)


def _bounds(text: str) -> tuple[datetime, datetime]:
    """The first moment of what a text names, and the first one after it."""
    parts = text.strip().split("-")
    if len(parts) <= 2 and all(part.isdigit() for part in parts):
        year, month = int(parts[0]), int(parts[1]) if len(parts) == 2 else None
        begin = datetime(year, month or 1, 1, tzinfo=UTC)
        after = year * 12 + (month or 12)  # months since year 0, of the following one
        return begin, datetime(after // 12, after % 12 + 1, 1, tzinfo=UTC)
    begin = parse_moment(text.strip())
    return begin, begin + (timedelta(days=1) if len(text.strip()) == len("2026-05-01") else _STEP)


_STEP = timedelta(microseconds=1)
"""A moment ends with itself."""


def _period_error(text: str) -> OperationError:
    return OperationError(
        "period", message("batch-no-period", period=text), remedy=message("batch-give-period")
    )
