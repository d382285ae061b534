"""Who has control, over time."""

from functools import partial

import pytest

from crenel.errors import OperationError
from crenel.station.bus import Bus
from crenel.station.control_lease import LAPSES_S, Control, Lease, Person
from tests.clocks import Clock

ANNA, BEN, TABLET = Person("a", "Anna"), Person("b", "Ben"), Person("t", "Anna")


@pytest.fixture
def clock() -> Clock:
    return Clock()


@pytest.fixture
def lease(bus: Bus, clock: Clock) -> Lease:
    return Lease(bus, clock)


def test_the_first_to_act_has_it_and_all_are_notified(lease: Lease, bus: Bus) -> None:
    assert bus.latest("control") == Control()
    lease.act(ANNA)
    lease.act(ANNA)
    assert bus.latest("control") == Control(ANNA)
    with pytest.raises(OperationError, match="Anna has control"):
        lease.act(BEN)
    with pytest.raises(OperationError, match="in another browser"):
        lease.act(TABLET)


def test_without_beats_it_goes_to_the_one_who_asked(lease: Lease, clock: Clock, bus: Bus) -> None:
    assert lease.last_name == ""
    lease.act(ANNA)
    clock.now_s += LAPSES_S - 1
    lease.beat("a")
    clock.now_s += LAPSES_S - 1
    lease.ask(BEN)
    assert lease.control == Control(ANNA, BEN)
    clock.now_s += 2
    lease.beat("b")
    assert bus.latest("control") == Control(BEN)
    clock.now_s += LAPSES_S + 1
    assert lease.control == Control()
    assert lease.last_name == "Ben"


def test_a_late_beat_does_not_bring_it_back(lease: Lease, clock: Clock) -> None:
    lease.act(ANNA)
    clock.now_s += LAPSES_S + 1
    lease.act(BEN)
    lease.beat("a")
    assert lease.control == Control(BEN)


def test_only_the_holder_answers_and_lets_go(lease: Lease) -> None:
    lease.act(ANNA)
    with pytest.raises(OperationError, match="Nobody requests"):
        lease.answer(ANNA, give=True)
    lease.ask(BEN)
    for act in (partial(lease.answer, BEN, give=True), partial(lease.release, BEN)):
        with pytest.raises(OperationError, match="do not have control"):
            act()
    lease.answer(ANNA, give=False)
    assert lease.control == Control(ANNA)
    lease.ask(BEN)
    lease.release(ANNA)
    assert lease.control == Control(BEN)


def test_the_same_person_takes_over_without_reason_others_need_one(lease: Lease, bus: Bus) -> None:
    lease.act(ANNA)
    lease.take_over(TABLET, "")
    assert lease.control == Control(TABLET)
    with pytest.raises(OperationError, match="No reason"):
        lease.take_over(BEN, "   ")
    subscription = bus.subscribe()
    lease.take_over(BEN, "she went home")
    assert lease.control == Control(BEN)
    reported = bus._take({}, set(), subscription._after_event).events
    assert [str(event.text) for event in reported] == [
        "Ben took over control from Anna: she went home"
    ]


def test_signing_out_lets_go(lease: Lease) -> None:
    lease.act(ANNA)
    lease.ask(BEN)
    lease.leave("b")
    assert lease.control == Control(ANNA)
    lease.leave("a")
    assert lease.control == Control()


def test_a_person_signed_out_everywhere_has_control_at_no_browser(lease: Lease) -> None:
    lease.act(TABLET)
    lease.ask(BEN)
    lease.leave_all("anna")
    assert lease.control == Control(BEN)
    lease.ask(ANNA)
    lease.leave_all("Anna")
    assert lease.control == Control(BEN)
    lease.leave_all("Ben")
    assert lease.control == Control()
