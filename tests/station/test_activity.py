"""One activity has the arm, and what runs unattended is stopped, whatever people do in between."""

from collections.abc import Callable
from functools import partial

import pytest
from hypothesis import settings
from hypothesis import strategies as st
from hypothesis.stateful import (
    RuleBasedStateMachine,
    invariant,
    precondition,
    rule,
    run_state_machine_as_test,
)

from crenel.errors import OperationError
from crenel.findings import Finding
from crenel.messages.message import Text
from crenel.station.activity import TITLES, TOPIC, Activities, ActivityKind, ArmInUseError, ArmUse
from crenel.station.bus import Bus
from crenel.station.control_lease import LAPSES_S, Lease, Person
from crenel.station.unattended import Unattended, UnattendedWatch
from tests.clocks import Clock

PEOPLE = (Person("a", "Anna"), Person("b", "Ben"), Person("t", "Anna"))
BEAT_S, LOOK_S, LATEST_S = 5.0, 0.5, 2.0
people, kinds = st.sampled_from(PEOPLE), st.sampled_from(sorted(TITLES))


class StationInUse(RuleBasedStateMachine):
    """People with browsers at a station, whose scan, sessions, laser and arm are variables."""

    def __init__(self) -> None:
        super().__init__()
        self.clock, self.bus = Clock(), Bus()
        self.lease = Lease(self.bus, self.clock)
        self.open: set[ActivityKind] = set()
        self.owner: ActivityKind | None = None
        self.is_lit = self.is_moving = self.is_driven = False
        self.limit_s: float | None = 30.0
        self.place_mm: float | None = 0.0
        self.present: set[str] = set()
        self.heard_s = {one.id: 0.0 for one in PEOPLE}
        self.attended_s = self.moved_s = self.clock.now_s
        self.stops: list[Text] = []
        self.start()

    def start(self) -> None:
        """As the station does; the sessions are still open."""
        self.activities = Activities(self.bus, lambda: self.lease.last_name)
        for kind in TITLES:
            self.activities.add(kind, partial(self.open.__contains__, kind))
        station = Unattended(
            silence_s=lambda: self.lease.silence_s,
            place_mm=lambda: None if self.place_mm is None else (0.0, self.place_mm),
            is_lit=lambda: self.is_lit or "scan" in self.open,
            is_driven=lambda: self.is_driven,
            limit_s=lambda: self.limit_s,
        )
        self.watch = UnattendedWatch(station, self.stop, self.activities.note, self.clock)
        self.watch.look()

    def stop(self, because: Text) -> None:
        self.stops.append(because)
        self.halt()

    def halt(self) -> None:
        self.is_lit = False
        self.open.discard("scan")

    def act(self, person: Person) -> bool:
        """As every request to act does first."""
        try:
            self.lease.act(person)
        except OperationError:
            return False
        self.hear(person)
        return True

    def hear(self, person: Person) -> None:
        self.heard_s[person.id] = self.clock.now_s
        self.note_attention()

    def note_attention(self) -> None:
        holder = self.lease.control.holder
        if holder is not None:
            self.attended_s = max(self.attended_s, self.heard_s[holder.id])

    @rule(person=people, kind=kinds, opens=st.booleans())
    def begin(self, person: Person, kind: ActivityKind, opens: bool) -> None:
        """It may be refused meanwhile, as a scan without calibration is."""
        if not self.act(person):
            return
        if self.owner not in (None, kind):
            with pytest.raises(ArmInUseError) as refused, self.activities.using(kind):
                pytest.fail("it began unasked")
            assert refused.value.activity.kind == self.owner
            return
        with self.activities.using(kind):
            assert self.activities.use.activity is not None
            if opens:
                self.open.add(kind)
        self.owner = kind if kind in self.open else None
        use = self.activities.use
        assert use.note is None or self.owner == kind
        if use.activity is not None:
            assert use.activity.who == person.name

    @rule(person=people, asked=st.booleans())
    def end(self, person: Person, asked: bool) -> None:
        """By the id that the question was about, or by one of before."""
        activity = self.activities.use.activity
        if activity is None or not self.act(person):
            return
        if not asked:
            with pytest.raises(ArmInUseError):
                self.activities.end("of-before", self.halt)
            return
        self.activities.end(activity.id, self.halt)
        self.owner = None

    @rule(kind=kinds)
    def close(self, kind: ActivityKind) -> None:
        """A session is accepted, a scan is stopped."""
        self.open.discard(kind)

    @rule()
    def restart(self) -> None:
        self.halt()
        self.owner = None
        self.start()
        for kind in sorted(self.open):
            self.activities.resume(kind, "2026-01-01T00:00:00Z")
        self.owner = min(self.open, default=None)

    @rule(person=people)
    def come(self, person: Person) -> None:
        self.present.add(person.id)

    @rule(person=people)
    def vanish(self, person: Person) -> None:
        """The tab is closed, the network cut, the browser frozen: no beat comes any more."""
        self.present.discard(person.id)

    @rule(
        person=people,
        how=st.sampled_from(["vanish", "release", "leave"]),
        arm=st.sampled_from(["still", "moving", "driven", "lost"]),
    )
    def leave_scan(self, person: Person, how: str, arm: str) -> None:
        """What a station must not go on with, unless the arm moves."""
        self.come(person)
        self.begin(person, "scan", True)
        self.move(arm == "moving", arm == "driven", arm == "lost")
        self.wait(3.0)
        if how != "vanish":
            self.change_control(person, how)
        self.vanish(person)
        self.wait(40.0)

    @rule(person=people)
    def switch_on(self, person: Person) -> None:
        self.is_lit = self.is_lit or self.act(person)

    @rule(person=people, how=st.sampled_from(["ask", "release", "take", "leave"]))
    def change_control(self, person: Person, how: str) -> None:
        before = self.lease.control.holder
        steps: dict[str, Callable[[], None]] = {
            "ask": partial(self.lease.ask, person),
            "release": partial(self.lease.release, person),
            "take": partial(self.lease.take_over, person, "it is my turn"),
            "leave": partial(self.lease.leave, person.id),
        }
        try:
            steps[how]()
        except OperationError:
            return
        if how in ("ask", "take"):
            self.hear(person)
        if before is not None and self.lease.control.holder is None:
            self.attended_s = self.clock.now_s
        self.note_attention()

    @rule(moving=st.booleans(), driven=st.booleans(), lost=st.booleans())
    def move(self, moving: bool, driven: bool, lost: bool) -> None:
        self.is_moving, self.is_driven = moving and not lost, driven
        if lost != (self.place_mm is None):
            self.place_mm = None if lost else 0.0

    @rule(limit_s=st.sampled_from([10.0, 30.0, None]))
    def set_limit(self, limit_s: float | None) -> None:
        self.limit_s = limit_s

    @rule(seconds=st.sampled_from([1.0, 6.0, LAPSES_S, 40.0]))
    def wait(self, seconds: float) -> None:
        for tick in range(round(seconds / LOOK_S)):
            self.clock.now_s += LOOK_S
            if self.is_moving and self.place_mm is not None:
                self.place_mm += 0.3  # slowly: it counts as moved at every second look
            if self.is_moving or self.is_driven:
                self.moved_s = self.clock.now_s
            if tick * LOOK_S % BEAT_S == 0:
                for person in PEOPLE:
                    if person.id in self.present:
                        self.lease.beat(person.id)
                        self.hear(person)
            self.look()

    def look(self) -> None:
        self.note_attention()
        before, was_lit = len(self.stops), self.is_lit or "scan" in self.open
        self.watch.look()
        now_s = self.clock.now_s
        alone_s = min(now_s - self.attended_s, now_s - self.moved_s)
        if len(self.stops) > before:
            assert was_lit
            assert self.limit_s is not None
            assert alone_s >= self.limit_s - 2 * LOOK_S
            note = self.activities.use.note
            assert isinstance(note, Finding)
            assert note.text == self.stops[-1]
        elif was_lit and self.limit_s is not None:
            assert alone_s < self.limit_s + LATEST_S

    @precondition(lambda self: self.owner is not None and self.owner not in self.open)
    @rule()
    def notice_end(self) -> None:
        assert self.activities.use.activity is None
        self.owner = None

    @invariant()
    def the_arm_is_where_everyone_sees_it(self) -> None:
        if self.owner not in self.open:
            self.owner = None
        use = self.activities.use
        assert (use.activity.kind if use.activity else None) == self.owner
        assert self.bus.latest(TOPIC) == use


@pytest.mark.slow
def test_no_activity_begins_unasked_and_nothing_runs_unattended() -> None:
    run_state_machine_as_test(
        StationInUse, settings=settings(max_examples=100, stateful_step_count=40, deadline=None)
    )


def test_an_activity_is_named_with_who_and_since_when(bus: Bus) -> None:
    activities = Activities(bus, lambda: "Anna")
    for kind in TITLES:
        activities.add(kind, lambda: True)
    assert bus.latest(TOPIC) == ArmUse()
    with (
        activities.using("calibration"),
        pytest.raises(ArmInUseError) as refused,
        activities.using("scan"),
    ):
        pass
    assert refused.value.activity == activities.use.activity
    assert "Calibration: since 20" in refused.value.line
    assert "by Anna" in refused.value.line
