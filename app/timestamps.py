"""Wall time, for people to read."""

from datetime import UTC, datetime


def utc_now() -> str:
    """ISO 8601 in UTC, to the millisecond."""
    return datetime.now(UTC).isoformat(timespec="milliseconds").replace("+00:00", "Z")


def parse_moment(text: str) -> datetime:
    """The moment that a record has, in UTC where it does not say; raises ``ValueError``."""
    found = datetime.fromisoformat(text)
    return found if found.tzinfo is not None else found.replace(tzinfo=UTC)


def is_moment(text: object) -> bool:
    """Whether something that was read says when it was."""
    try:
        return isinstance(text, str) and bool(parse_moment(text))
    except ValueError:
        return False
