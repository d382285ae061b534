"""Control of the station: one person at a time, visible to everyone.

A person takes control by acting while nobody has it, and loses it after a silence. This never ends
a scan or a step; it only changes who may act.
"""

import threading
import time
from collections.abc import Callable
from dataclasses import dataclass

from app.errors import OperationError
from app.messages.message import message
from app.station.bus import Bus

LAPSES_S = 20.0
"""Without a heartbeat from the holder's browser."""
LONGEST_REASON = 120


@dataclass(frozen=True, slots=True)
class Person:
    """A person at a browser."""

    id: str
    """Of the browser's login session."""
    name: str


@dataclass(frozen=True, slots=True)
class Control:
    """Control as everyone sees it, in the topic ``control``."""

    holder: Person | None = None
    asked_by: Person | None = None


class Lease:
    """Control of one station; any thread may call it."""

    def __init__(self, bus: Bus, clock: Callable[[], float] = time.monotonic) -> None:
        self._bus, self._clock = bus, clock
        self._lock = threading.RLock()
        self._control = Control()
        self._beat_s = 0.0
        self.last_name = ""
        """The person who has control, or had it last: presses of the arm's buttons are attributed
        to them."""
        bus.publish("control", self._control)

    @property
    def control(self) -> Control:
        """The current state."""
        with self._lock:
            self._lapse()
            return self._control

    def act(self, person: Person) -> None:
        """Called before every action: takes control if it is free.

        Raises:
            OperationError: another person has control.
        """
        with self._lock:
            holder = self.control.holder
            if holder is None:
                self._set(Control(person))
            elif holder.id != person.id:
                raise _not_in_control(person, holder)
            self._beat_s = self._clock()

    def beat(self, person_id: str) -> None:
        """The browser is still connected."""
        with self._lock:
            if self._control.holder is not None and self._control.holder.id == person_id:
                self._beat_s = self._clock()
            self._lapse()

    def ask(self, person: Person) -> None:
        """Requests control from the holder; takes it if it is free."""
        with self._lock:
            holder = self.control.holder
            if holder is None or holder.id == person.id:
                self.act(person)
                return
            self._set(Control(holder, person))
            self._bus.event(
                "control", message("asks-control", name=person.name, holder=holder.name)
            )

    def answer(self, person: Person, give: bool) -> None:
        """The holder gives control to the person who requested it, or keeps it."""
        with self._lock:
            asked_by = self._require_holder(person).asked_by
            if asked_by is None:
                raise OperationError("control-not-asked", message("nobody-asks-control"))
            if give:
                self._set(Control(asked_by))
                self._beat_s = self._clock()
                self._bus.event("control", message("has-control-now", name=asked_by.name))
            else:
                self._set(Control(person))
                self._bus.event("control", message("keeps-control", name=person.name))

    def release(self, person: Person) -> None:
        """Releases control."""
        with self._lock:
            asked_by = self._require_holder(person).asked_by
            self._set(Control(asked_by))
            self._beat_s = self._clock()

    def take_over(self, person: Person, reason: str) -> None:
        """Takes control from its holder, with a reason that everyone can read.

        Raises:
            OperationError: no reason is given, although another person has control.
        """
        reason = " ".join(reason.split())[:LONGEST_REASON]
        with self._lock:
            holder = self.control.holder
            others = holder is not None and holder.name != person.name
            if others and not reason:
                raise OperationError(
                    "control-reason",
                    message("no-reason-given"),
                    message("one-who-loses-control-reads-why"),
                    message("say-few-words-why-you-take"),
                )
            self._set(Control(person))
            self._beat_s = self._clock()
            if holder is not None and others:
                text = message(
                    "took-over-control", name=person.name, holder=holder.name, reason=reason
                )
                self._bus.event("control", text, "attention")

    def leave(self, person_id: str) -> None:
        """A browser that signed out loses control."""
        with self._lock:
            holder, asked_by = self._control.holder, self._control.asked_by
            if holder is not None and holder.id == person_id:
                self._set(Control(asked_by))
                self._beat_s = self._clock()
            elif asked_by is not None and asked_by.id == person_id:
                self._set(Control(holder))

    def leave_all(self, name: str) -> None:
        """A person who was signed out everywhere loses control."""
        with self._lock:
            for person in (self._control.asked_by, self._control.holder):
                if person is not None and person.name.lower() == name.lower():
                    self.leave(person.id)

    def _require_holder(self, person: Person) -> Control:
        control = self.control
        if control.holder is None or control.holder.id != person.id:
            raise OperationError("control-not-yours", message("you-do-have-control"))
        return control

    def _lapse(self) -> None:
        late = self._clock() - self._beat_s > LAPSES_S
        if self._control.holder is not None and late:
            self._beat_s = self._clock()
            self._set(Control(self._control.asked_by))

    def _set(self, control: Control) -> None:
        if control != self._control:
            self._control = control
            self.last_name = control.holder.name if control.holder else self.last_name
            self._bus.publish("control", control)


def _not_in_control(person: Person, holder: Person) -> OperationError:
    return OperationError(
        "control",
        message("has-control-in-another-browser", name=holder.name)
        if holder.name == person.name
        else message("has-control", name=holder.name),
        message("one-browser-acts-time"),
        message("ask-control-take-over"),
    )
