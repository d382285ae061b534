"""What every guided session of a station has: its journal, the state folded from it, its view."""

import secrets
import threading
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from datetime import UTC, datetime
from typing import Generic, Protocol, TypeVar

from app.guide.hand import Hand
from app.guide.journal import Journal, Row, fold
from app.guide.touching import sentence
from app.metrology.refusal import Refusal
from app.station.bus import Bus
from app.station.findings import Finding
from app.station.jobs import Jobs


class Machinery(Protocol):
    """What every session needs of the machine room."""

    @property
    def bus(self) -> Bus: ...
    @property
    def jobs(self) -> Jobs: ...
    @property
    def hand(self) -> Hand | None: ...


class SessionState(Protocol):
    """What all states have."""

    @property
    def session_id(self) -> str: ...
    @property
    def ended(self) -> object:
        """True in some way once the session is over."""


STALE = "stale-view"
State = TypeVar("State", bound=SessionState)
View = TypeVar("View")


def new_session_id() -> str:
    """By the time, and different within a second."""
    return f"{datetime.now(UTC):%Y%m%d-%H%M%S}-{secrets.token_hex(2)}"


class GuidedSession(ABC, Generic[State, View]):
    """The latest session of a kind. All methods may be called from any thread.

    Args:
        kind: of the sessions in the journal.
        topic: under which the view is published.
        empty, step: the state before the first row, and what a row makes of a state.
    """

    station: Machinery

    def __init__(
        self,
        station: Machinery,
        journal: Journal,
        kind: str,
        topic: str,
        empty: State,
        step: Callable[[State, Row], State],
    ) -> None:
        self.lock = threading.RLock()
        self.changed = threading.Condition(self.lock)
        self.hand_running = False
        self.declined = 0
        """Counts what was asked for and declined."""
        self.station = station
        self._journal, self._topic = journal, topic
        self._trouble: Finding | None = None
        self._published: View | None = None
        session = journal.latest_session(kind)
        self.state = empty if session is None else fold(journal.rows(session.id), empty, step)

    @property
    def running(self) -> bool:
        """Whether a session is open."""
        return bool(self.state.session_id) and not self.state.ended

    @abstractmethod
    def view(self) -> View:
        """The session as of now."""

    @property
    @abstractmethod
    def rev(self) -> int:
        """What the view's revision is now."""

    @abstractmethod
    def why_not(self, name: str, args: Mapping[str, object], by_hand: bool) -> str | None:
        """Why a command cannot be done now; ``by_hand``: the hand's own work is no hindrance."""

    def refuse_unless_possible(
        self, name: str, args: Mapping[str, object], rev: int | None, by_hand: bool = False
    ) -> None:
        """Before every command: of a browser with its view's revision, of the hand as its own.

        Raises:
            Refusal: it cannot be done now, or was given on an old view.
        """
        if rev is not None and rev != self.rev:
            raise self.stale()
        if reason := self.why_not(name, args, by_hand):
            raise Refusal("not-now", reason)

    def stale(self) -> Exception:
        """What is raised where a command was given on an old view."""
        return Refusal(
            STALE,
            "The session went on meanwhile; nothing was done",
            remedy="Look at the present step, and act on that",
        )

    @contextmanager
    def beginning(self) -> Iterator[None]:
        """A session that cannot be written, as on a full disk, is not begun."""
        before = self.state
        try:
            yield
        except BaseException:
            self.state = before
            raise

    def refresh(self) -> View:
        """Publishes the view if it changed, and returns it."""
        with self.lock:
            view = self.view()
            if view != self._published:
                self._published = view
                self.station.bus.publish(self._topic, view)
            return view

    def knows_key(self, key: str) -> bool:
        """Whether a command with this idempotency key has acted already."""
        return self._journal.knows_key(key)

    def decline(self, refusal: Refusal) -> None:
        """Shows why something was not done, until something is."""
        with self.lock:
            why = f": {refusal.why}" if refusal.why else ""
            text = sentence(f"{refusal.what}{why}")
            self._trouble = Finding("attention", text, sentence(refusal.remedy))
            self.declined += 1
            self.station.bus.event("refused", refusal.line, "attention")
            self.changed.notify_all()
            self.refresh()
