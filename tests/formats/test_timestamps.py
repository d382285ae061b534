"""What is read as a moment, and what is not."""

from datetime import UTC, datetime

import pytest

from crenel.timestamps import is_moment, parse_moment, utc_now


def test_a_moment_without_a_zone_is_in_utc() -> None:
    assert parse_moment("2026-01-02T03:04:05") == datetime(2026, 1, 2, 3, 4, 5, tzinfo=UTC)
    assert parse_moment("2026-01-02T04:04:05+01:00") == parse_moment("2026-01-02T03:04:05")
    assert is_moment(utc_now())


@pytest.mark.parametrize("text", ["yesterday", "", "2026-13-01", "0001-01-01T00:00+14:00", 7, None])
def test_what_is_no_moment(text: object) -> None:
    assert not is_moment(text)
