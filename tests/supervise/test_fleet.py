"""Which station is lost, by messages and a clock."""

from app.supervise.fleet import LOST_AFTER_S, MOST_STATIONS, Fleet
from app.supervise.messages import Presence, station_id
from tests.supervise.publishing import event_of, report_of


class Clock:
    now_s = 100.0

    def __call__(self) -> float:
        return self.now_s


def fleet() -> tuple[Fleet, Clock]:
    clock = Clock()
    made = Fleet(clock)
    made.broker(True)
    return made, clock


def take(made: Fleet, message: object, kind: str, retained: bool = False) -> None:
    made.take("a", kind, message.model_dump_json().encode(), retained)  # type: ignore[attr-defined]


def presence(state: str, instance: str = "1") -> Presence:
    return Presence.model_validate(
        {"station": "a", "instance": instance, "name": "A", "state": state}
    )


def state(made: Fleet) -> str:
    (shown,) = made.shown()
    return shown.state


def test_what_the_broker_kept_is_no_sign_of_life() -> None:
    made, clock = fleet()
    take(made, presence("online"), "presence", retained=True)
    take(made, report_of("a", "1"), "report", retained=True)
    assert state(made) == "waiting"
    clock.now_s += LOST_AFTER_S + 0.1
    assert state(made) == "lost"
    take(made, report_of("a", "1"), "report")
    assert state(made) == "live"


def test_a_will_of_an_earlier_start_is_no_loss() -> None:
    made, _ = fleet()
    take(made, presence("online", "2"), "presence")
    take(made, report_of("a", "2"), "report")
    take(made, presence("lost", "1"), "presence")
    assert state(made) == "live"
    take(made, presence("lost", "2"), "presence")
    assert state(made) == "lost"
    take(made, report_of("a", "3"), "report")
    assert state(made) == "live"


def test_silence_while_the_broker_was_away_is_no_loss() -> None:
    made, clock = fleet()
    take(made, report_of("a", "1"), "report")
    made.broker(False)
    clock.now_s += 60
    assert state(made) == "unknown"
    made.broker(True)
    assert state(made) == "waiting"
    clock.now_s += LOST_AFTER_S + 0.1
    assert state(made) == "lost"


def test_what_is_no_payload_is_counted_and_dropped() -> None:
    made, _ = fleet()
    for payload in (
        b"{",
        b"[]",
        b'{"station": "a"}',
        report_of("b", "1").model_dump_json().encode(),
    ):
        made.take("a", "report", payload, False)
    assert (made.shown(), made.invalid) == ((), 4)
    for number in range(MOST_STATIONS + 5):
        name = f"s{number}"
        made.take(name, "report", report_of(name, "1").model_dump_json().encode(), False)
    assert len(made.shown()) == MOST_STATIONS


def test_a_later_version_may_say_more() -> None:
    made, _ = fleet()
    payload = report_of("a", "1").model_dump_json().replace('"format"', '"later":{"x":1},"format"')
    made.take("a", "report", payload.encode(), False)
    assert state(made) == "live"


def test_events_are_the_newest_first_and_a_few() -> None:
    made, _ = fleet()
    for number in range(20):
        take(made, event_of("a", "1", number), "event")
    (shown,) = made.shown()
    assert [event.number for event in shown.events] == [19, 18, 17, 16, 15, 14]
    made.take("a", "presence", b"", True)
    assert made.shown() == ()


def test_names_become_parts_of_topics() -> None:
    assert station_id("Messraum 2 – Süd") == "messraum-2-sud"
    assert station_id("測定室") == "station"
    assert station_id("x" * 90) == "x" * 40
