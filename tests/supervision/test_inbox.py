"""What waits to be looked at is bounded, and known stations come first."""

import pytest

from crenel.supervision.inbox import (
    LONGEST_BYTES,
    MOST_UNKNOWN,
    MOST_UNKNOWN_BYTES,
    TOLERATED,
    Inbox,
    Unread,
)


@pytest.fixture
def unread() -> Unread:
    return Unread()


@pytest.fixture
def inbox(unread: Unread) -> Inbox:
    return Inbox("crenel", unread, lambda station: station.startswith("known"))


def drained(inbox: Inbox) -> list[tuple[str, bytes]]:
    found = []
    while (heard := inbox.take()) is not None:
        found.append((heard.station, heard.payload))
    return found


def test_the_latest_of_a_topic_wins_known_stations_are_first(inbox: Inbox, unread: Unread) -> None:
    for number in range(TOLERATED):
        inbox.put("crenel/new/report", b"%d" % number, False)
        inbox.put("crenel/known-1/report", b"%d" % number, False)
    assert len(inbox) == 2
    assert drained(inbox) == [("known-1", b"9"), ("new", b"9")]
    assert unread.counts == {}
    assert drained(inbox) == []


def test_a_flood_of_one_topic_is_counted(inbox: Inbox, unread: Unread) -> None:
    for _ in range(TOLERATED + 5):
        inbox.put("crenel/known-1/report", b"x", False)
    assert unread.counts == {"often": 5}
    drained(inbox)
    inbox.put("crenel/known-1/report", b"x", False)
    assert unread.counts == {"often": 5}, "it is at an end"


def test_of_unknown_stations_the_longest_waiting_is_dropped(inbox: Inbox, unread: Unread) -> None:
    inbox.put("crenel/known-1/report", b"x", False)
    for number in range(MOST_UNKNOWN + 3):
        inbox.put(f"crenel/new-{number}/report", b"x", False)
    assert unread.counts == {"crowded": 3}
    stations = [station for station, _ in drained(inbox)]
    assert len(stations) == MOST_UNKNOWN + 1
    assert (stations[0], stations[1]) == ("known-1", "new-3")


def test_what_waits_of_unknown_stations_is_bounded_in_bytes(inbox: Inbox, unread: Unread) -> None:
    payload = b"x" * LONGEST_BYTES["report"]
    fitting = MOST_UNKNOWN_BYTES // len(payload)
    for _ in range(2):
        for number in range(fitting + 2):
            inbox.put(f"crenel/new-{number}/report", payload, False)
        inbox.put(f"crenel/new-{fitting + 1}/report", b"x", False)
        assert len(inbox) == fitting
        assert len(drained(inbox)) == fitting
    assert unread.counts == {"crowded": 4}


def test_what_is_too_long_or_of_no_station_is_not_kept(inbox: Inbox, unread: Unread) -> None:
    for kind, longest in LONGEST_BYTES.items():
        inbox.put(f"crenel/a/{kind}", b"x" * (longest + 1), False)
    for topic in (
        "",
        "crenel",
        "crenel/a",
        "crenel/a/b/report",
        "crenel/a/report/",
        "crenel//report",
        f"crenel/{'a' * 41}/report",
        "crenel/Ä/report",
        "crenel/a\n/report",
        "other/a/report",
        "crenel/a/other",
        "crenel" + "/a" * 30_000,
    ):
        inbox.put(topic, b"{}", False)
    assert len(inbox) == 0
    assert unread.counts == {"long": 3, "strange": 12}
    inbox.put("crenel/a/report", b"x" * LONGEST_BYTES["report"], False)
    assert len(inbox) == 1
