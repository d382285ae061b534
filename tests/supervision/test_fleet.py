"""Which station is lost, by messages and a clock."""

import json

import pytest
from pydantic import BaseModel

from crenel.supervision.messages import MOST_ALARMS, MOST_DEVICES, Alarm, Presence, station_id
from crenel.supervision.remote_stations import LOST_AFTER_S, MOST_STATIONS, Fleet
from tests.bench.faults.broker.usual_messages import DEVICE, make_event, make_report
from tests.clocks import Clock
from tests.supervision.publishing import SENSORS


@pytest.fixture
def clock() -> Clock:
    return Clock()


@pytest.fixture
def made(clock: Clock) -> Fleet:
    fleet = Fleet(clock)
    fleet.note_broker(True)
    return fleet


def take(made: Fleet, message: BaseModel, kind: str, retained: bool = False) -> None:
    made.take("a", kind, message.model_dump_json().encode(), retained)


def take_json(made: Fleet, report: object) -> None:
    made.take("a", "report", json.dumps(report).encode(), False)


def take_of(made: Fleet, name: str, retained: bool = False) -> None:
    made.take(name, "report", make_report(name, "1").model_dump_json().encode(), retained)


def presence(state: str, instance: str = "1") -> Presence:
    return Presence.model_validate(
        {"station": "a", "instance": instance, "name": "A", "state": state}
    )


def state(made: Fleet) -> str:
    (shown,) = made.stations()
    return shown.state


def test_what_the_broker_kept_is_no_sign_of_life(made: Fleet, clock: Clock) -> None:
    take(made, presence("online"), "presence", retained=True)
    take(made, make_report("a", "1"), "report", retained=True)
    assert state(made) == "waiting"
    clock.now_s += LOST_AFTER_S + 0.1
    assert state(made) == "lost"
    take(made, make_report("a", "1"), "report")
    assert state(made) == "live"


def test_a_will_of_an_earlier_start_is_no_loss(made: Fleet) -> None:
    take(made, presence("online", "2"), "presence")
    take(made, make_report("a", "2"), "report")
    take(made, presence("lost", "1"), "presence")
    assert state(made) == "live"
    take(made, presence("lost", "2"), "presence")
    assert state(made) == "lost"
    take(made, make_report("a", "3"), "report")
    assert state(made) == "live"


def test_silence_while_the_broker_was_away_is_no_loss(made: Fleet, clock: Clock) -> None:
    take(made, make_report("a", "1"), "report")
    made.note_broker(False)
    clock.now_s += 60
    assert state(made) == "unknown"
    made.note_broker(True)
    assert state(made) == "waiting"
    clock.now_s += LOST_AFTER_S + 0.1
    assert state(made) == "lost"


def test_what_is_no_payload_is_counted_and_dropped(made: Fleet) -> None:
    of_another = make_report("b", "1").model_dump_json().encode()
    for payload in (b"{", b"[]", b'{"station": "a"}', of_another):
        made.take("a", "report", payload, False)
    assert (made.stations(), made.unread.counts) == ((), {"strange": 4})
    for number in range(MOST_STATIONS + 5):
        take_of(made, f"s{number}")
    assert len(made.stations()) == MOST_STATIONS


def test_a_later_version_may_say_more(made: Fleet) -> None:
    take_json(made, {"later": {"x": 1}, **make_report("a", "1").model_dump(mode="json")})
    assert state(made) == "live"


def test_an_earlier_version_does_not_name_its_sensors(made: Fleet) -> None:
    report = make_report("a", "1", devices=(DEVICE, *SENSORS)).model_dump(mode="json")
    take_json(made, report)
    assert sensors(made) == ["", "left", "right"]
    for device in report["devices"]:
        del device["sensor"]
    take_json(made, report)
    assert sensors(made) == ["", "", ""]


def sensors(made: Fleet) -> list[str]:
    (shown,) = made.stations()
    assert shown.report is not None
    return [device.sensor for device in shown.report.devices]


def test_of_events_the_newest_is_shown(made: Fleet) -> None:
    for number in range(20):
        take(made, make_event("a", "1", number), "event")
    (shown,) = made.stations()
    assert [event.number for event in shown.events] == [19]
    made.take("a", "presence", b"", True)
    assert made.stations() == ()


def test_names_become_parts_of_topics() -> None:
    assert station_id("Messraum 2 – Süd") == "messraum-2-sud"
    assert station_id("測定室") == "station"
    assert station_id("x" * 90) == "x" * 40


def names(made: Fleet) -> list[str]:
    return [shown.id for shown in made.stations()]


@pytest.mark.slow
def test_invented_stations_hide_none_that_sends(made: Fleet, clock: Clock) -> None:
    """Also those that were sent once, and what the broker keeps of them."""
    for number in range(2 * MOST_STATIONS):
        take_of(made, f"kept-{number}", retained=True)
    assert len(names(made)) == MOST_STATIONS
    assert made.unread.counts == {"crowded": MOST_STATIONS}
    take_of(made, "real")
    for second in range(20):
        clock.now_s += 1.0
        take_of(made, "real")
        for number in range(2 * MOST_STATIONS):
            take_of(made, f"invented-{second}-{number}")
            take_of(made, f"kept-{number}", retained=True)
    assert len(names(made)) == MOST_STATIONS
    assert "real" in names(made)
    assert not any(name.startswith("kept") for name in names(made))


def test_a_station_that_goes_on_finds_a_place_among_new_names(made: Fleet, clock: Clock) -> None:
    """A flood that sends each name once keeps nobody out who sends every second."""
    for second in range(3):  # sooner than any of them is lost
        for number in range(MOST_STATIONS):
            take_of(made, f"invented-{second}-{number}")
            clock.now_s += 1.0 / MOST_STATIONS
        take_of(made, "real")
    assert "real" in names(made)
    assert len(names(made)) == MOST_STATIONS


@pytest.mark.slow
def test_a_lost_station_that_was_there_long_outlasts_new_ones(made: Fleet, clock: Clock) -> None:
    for _ in range(70):
        take_of(made, "real")
        clock.now_s += 1.0
    for second in range(20):
        clock.now_s += LOST_AFTER_S + 0.1
        for number in range(2 * MOST_STATIONS):
            take_of(made, f"invented-{second}-{number}")
    assert len(names(made)) == MOST_STATIONS
    assert names(made)[0] == "real"
    assert made.stations()[0].state == "lost"


def test_lists_of_a_report_are_bounded(made: Fleet) -> None:
    alarm = Alarm(quality="bad", text="x", remedy="")
    said = make_report("a", "1").model_dump()
    said |= {"alarms": [alarm.model_dump()] * 900, "devices": said["devices"] * 300}
    take_json(made, said)
    (shown,) = made.stations()
    assert shown.report is not None
    assert (shown.alarms, len(shown.report.alarms)) == (MOST_ALARMS, 1)
    assert len(shown.report.devices) == MOST_DEVICES
    for wrong in ({"up_s": 1e300}, {"alarms": "x" * 900}, {"activity": {"points": 10**100}}):
        take_json(made, said | wrong)
    assert made.unread.counts == {"strange": 3}
