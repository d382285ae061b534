"""Wall-clock time for display."""

from datetime import UTC, datetime


def utc_now() -> str:
    """ISO 8601 in UTC, to the millisecond."""
    return datetime.now(UTC).isoformat(timespec="milliseconds").replace("+00:00", "Z")


def parse_moment(text: str) -> datetime:
    """The time in a record, in UTC unless stated otherwise; raises ``ValueError``."""
    found = datetime.fromisoformat(text)
    return found if found.tzinfo is not None else found.replace(tzinfo=UTC)


def is_moment(text: object) -> bool:
    """Whether a value that was read contains a time."""
    try:
        return isinstance(text, str) and bool(parse_moment(text))
    except ValueError:
        return False
