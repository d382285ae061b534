"""Control of the station: one person at a time, visible to everyone.

A person takes control by acting while nobody has it, and loses it after a silence, which is judged
by the heartbeats of the login session in control. A change of control ends no scan and no step; how
long the silence lasts is what ``unattended`` goes by.
"""

import threading
import time
from collections.abc import Callable
from dataclasses import dataclass

from crenel.errors import OperationError
from crenel.messages.message import message
from crenel.station.bus import Bus

LAPSES_S = 20.0
"""Without a heartbeat from the holder's browser."""
LONGEST_REASON = 120


@dataclass(frozen=True, slots=True)
class Person:
    """A person at a browser."""

    id: str
    """The id of the browser's login session."""
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
        self._heard_s: dict[str, float] = {}
        """When the browsers of the holder and of the one who asks were last heard, by their ids."""
        self._silent_since_s = clock()
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

    @property
    def silence_s(self) -> float:
        """How long nobody who has control was heard."""
        with self._lock:
            self._lapse()
            return self._clock() - self._silent_since_s

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
            self._hear(person.id)

    def beat(self, person_id: str) -> None:
        """The browser is still connected."""
        with self._lock:
            self._lapse()
            self._hear(person_id)

    def ask(self, person: Person) -> None:
        """Requests control from the holder; takes it if it is free."""
        with self._lock:
            holder = self.control.holder
            if holder is None or holder.id == person.id:
                self.act(person)
                return
            self._set(Control(holder, person))
            self._hear(person.id)
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
                self._bus.event("control", message("has-control-now", name=asked_by.name))
            else:
                self._set(Control(person))
                self._bus.event("control", message("keeps-control", name=person.name))

    def release(self, person: Person) -> None:
        """Releases control."""
        with self._lock:
            asked_by = self._require_holder(person).asked_by
            self._set(Control(asked_by))

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
            self._hear(person.id)
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
            raise OperationError("control-not-yours", message("you-do-not-have-control"))
        return control

    def _hear(self, person_id: str) -> None:
        """The browser of the holder, or of the one who asks, has been heard now."""
        for person in (self._control.holder, self._control.asked_by):
            if person is not None and person.id == person_id:
                self._heard_s[person_id] = self._clock()
        self._note_silence()

    def _note_silence(self) -> None:
        holder = self._control.holder
        if holder is not None:
            self._silent_since_s = max(self._silent_since_s, self._heard_s.get(holder.id, 0.0))

    def _is_silent(self, person: Person) -> bool:
        return self._clock() - self._heard_s.get(person.id, float("-inf")) > LAPSES_S

    def _lapse(self) -> None:
        """Whoever is silent loses control, to the one who asks for it and is not."""
        holder, asked_by = self._control.holder, self._control.asked_by
        if asked_by is not None and self._is_silent(asked_by):
            asked_by = None
        if holder is not None and self._is_silent(holder):
            holder, asked_by = asked_by, None
        self._set(Control(holder, asked_by))

    def _set(self, control: Control) -> None:
        if control != self._control:
            had, self._control = self._control.holder, control
            if had is not None and control.holder is None and not self._is_silent(had):
                self._silent_since_s = self._clock()  # it was let go just now
            self.last_name = control.holder.name if control.holder else self.last_name
            self._note_silence()
            known = {one.id for one in (control.holder, control.asked_by) if one is not None}
            self._heard_s = {who: at for who, at in self._heard_s.items() if who in known}
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
