"""Wall-clock time for display."""

from datetime import UTC, datetime

LATEST_NS = 253_402_214_400 * 10**9
"""The last day that a date can have, in ns since 1970; file systems know later ones."""


def utc_now() -> str:
    """ISO 8601 in UTC, to the millisecond."""
    return datetime.now(UTC).isoformat(timespec="milliseconds").replace("+00:00", "Z")


def parse_moment(text: str) -> datetime:
    """The time in a record, in UTC unless stated otherwise; raises ``ValueError``, also for one
    that has no date in UTC."""
    found = datetime.fromisoformat(text)
    if found.tzinfo is None:
        return found.replace(tzinfo=UTC)
    try:
        found.astimezone(UTC)
    except OverflowError as error:
        raise ValueError(f"{text} has no date in UTC") from error
    return found


def is_moment(text: object) -> bool:
    """Whether a value that was read contains a time."""
    try:
        return isinstance(text, str) and bool(parse_moment(text))
    except ValueError:
        return False


def is_date(text: str) -> bool:
    """Whether a text is a day of the calendar, as YYYY-MM-DD."""
    return len(text) == len("YYYY-MM-DD") and text[4] == "-" and is_moment(text)


def clamp_ns(file_ns: int) -> int:
    """The time of a file in ns since 1970; one outside the calendar is the nearest within it."""
    return min(max(file_ns, 0), LATEST_NS)


def moment_of_ns(file_ns: int) -> datetime:
    """The same as a moment in UTC."""
    return datetime.fromtimestamp(clamp_ns(file_ns) / 1e9, UTC)
