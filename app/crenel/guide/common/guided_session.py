"""What every guided session of a station has: its journal, the state folded from it, its view."""

import logging
import secrets
import threading
from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass, replace
from datetime import UTC, datetime
from pathlib import Path
from typing import Generic

from crenel.errors import OperationError, StaleViewError, sentence
from crenel.findings import Finding
from crenel.guide.common.arguments import Args, check_arguments
from crenel.guide.common.flow import Flow, View
from crenel.guide.common.journal import Check, Journal, JournalEntry, fold
from crenel.guide.common.rules import Live, State
from crenel.guide.common.simulated_operator import SimulatedOperator
from crenel.guide.common.view import Busy
from crenel.messages.message import Text, message
from crenel.station.bus import Bus
from crenel.station.devices.rig import Rig
from crenel.station.jobs import Job, Jobs, Progress

log = logging.getLogger(__name__)


@dataclass(frozen=True)
class StationServices:
    """The station's parts that every session works with."""

    bus: Bus
    rig: Rig
    jobs: Jobs
    operator_of_simulation: SimulatedOperator | None
    """The operator of the simulated station; it can work only while no device is a real one."""

    @property
    def simulated_operator(self) -> SimulatedOperator | None:
        """The simulated operator, if it can work with the present devices."""
        return None if self.rig.real else self.operator_of_simulation


@dataclass(frozen=True)
class Provenance:
    """What a record says of where, by whom and how warm it was made."""

    station: str = ""
    is_simulated: Callable[[], bool] = lambda: False
    """Whether a device is the simulation's."""
    operator: Callable[[], str] = str
    """Who has control or had it last; empty where nobody did."""
    temperature_c: Callable[[], float | None] = lambda: None
    """The room's; None where it is not measured."""
    celsius_near: Callable[[str], float | None] = lambda at: None
    """The same at another time."""


NO_PROVENANCE = Provenance()


def new_session_id() -> str:
    """By the time, and different within a second."""
    return f"{datetime.now(UTC):%Y%m%d-%H%M%S}-{secrets.token_hex(2)}"


class GuidedSession(ABC, Generic[State, Live, View]):
    """The latest session of a kind. All methods may be called from any thread."""

    station: StationServices

    def __init__(
        self,
        station: StationServices,
        journal: Journal,
        flow: Flow[State, Live, View],
        data_folder: Path,
        provenance: Provenance,
    ) -> None:
        self.lock = threading.RLock()
        self.changed = threading.Condition(self.lock)
        self.simulation_running = False
        self.declined = 0
        """Counts what was asked for and declined."""
        self.use_arm: Callable[[], AbstractContextManager[None]] = nullcontext
        """Opens a block in which the session has the arm; raises where another activity has it."""
        self.station = station
        self.data_folder, self.provenance = data_folder, provenance
        self._journal, self._flow = journal, flow
        self._trouble: Finding | None = None
        self._published: View | None = None
        self.unreadable_reason: Text = ""
        """Why the last session is not gone on with: it cannot be read. Empty where it can."""
        self.state = self._last_state()

    def _last_state(self) -> State:
        """Where the latest session stands; as before the first where it cannot be read.

        Raises:
            OperationError: the database itself is damaged.
        """
        session = self._journal.latest_session(self._flow.kind)
        if session is None:
            return self._flow.empty
        try:
            return fold(self._journal.rows(session.id), self._flow.empty, self._flow.after)
        except OperationError:
            raise
        except Exception as error:  # whatever stands there, the rest is served
            self._skip_session(session.id, error)
            return self._flow.empty

    def resume(self) -> None:
        """Brings the station in line with the session; one that cannot be shown is set aside."""
        try:
            self.sync_station()
            self.view()
        except Exception as error:  # as above
            self._skip_session(self.state.session_id, error)
            self.state = self._flow.empty
            self.sync_station()

    def sync_station(self) -> None:
        """The station works with what the session chose."""

    def _skip_session(self, session_id: str, error: Exception) -> None:
        log.warning("session %s cannot be continued", session_id, exc_info=error)
        self.unreadable_reason = message(
            "session-cannot-read-set-aside", session_id=session_id, error=error
        )

    def append(self, kind: str, payload: Mapping[str, object], key: str | None = None) -> None:
        """Writes a row, and brings the state in line with it."""
        with self.lock:
            session_id = self.state.session_id
            self.keep(lambda check: self._journal.append(session_id, kind, payload, key, check))
            if self.state.ended:
                self._journal.end_session(session_id)
            self.after_change()

    def keep(self, write: Callable[[Check], JournalEntry]) -> None:
        """Has a row written, which is folded before it is committed; the state follows.

        Raises:
            OperationError: it cannot be folded, and is not kept.
        """
        states: list[State] = []

        def check(row: JournalEntry) -> None:
            try:
                states.append(self._flow.after(self.state, row))
            except Exception as error:
                log.exception("a row %s cannot be applied", row.kind)
                raise OperationError(
                    "not-readable",
                    message("not-saved"),
                    message("session-not-readable-with-change"),
                    message("send-support-bundle"),
                ) from error

        row = write(check)
        self.state = states[-1]
        if row.kind not in self._flow.automatic:
            self._trouble = None

    def after_change(self) -> None:
        """Whoever waits for a row goes on, and the view is published."""
        self.changed.notify_all()
        self.refresh()

    def begin_session(self, state: State, payload: Mapping[str, object], key: str | None) -> None:
        """Begins a session in a state; where it cannot be written, as on a full disk, the one
        before stays."""
        before, self.state = self.state, state
        try:
            self._journal.begin_session(state.session_id, self._flow.kind)
            self.append("started", payload, key)
        except BaseException:
            self.state = before
            raise

    @property
    def running(self) -> bool:
        """Whether a session is open."""
        return bool(self.state.session_id) and not self.state.ended

    @property
    def started_at(self) -> str:
        """When the latest session began, ISO 8601; empty before the first."""
        session = self._journal.latest_session(self._flow.kind)
        return session.started_at if session is not None else ""

    @property
    def busy(self) -> Busy | None:
        """The work that is under way."""
        job = self.station.jobs.current
        return Busy(job.text or job.title, job.fraction) if job is not None else None

    @abstractmethod
    def live(self) -> Live:
        """The station as the flow sees it."""

    def view(self) -> View:
        """The session as of now."""
        with self.lock:
            return self._flow.view_of(self.state, self.live())

    @property
    def rev(self) -> int:
        """What the view's revision is now."""
        return self.state.rev

    def why_not(self, name: str, args: Mapping[str, object], by_simulation: bool) -> Text:
        """Why a command cannot be done now; ``by_simulation``: its own running job is no reason."""
        live = self.live()
        return self._flow.rules.rejection_reason(
            self.state, replace(live, busy=None) if by_simulation else live, name, args
        )

    def check_allowed(
        self, name: str, args: Args, rev: int | None, by_simulation: bool = False
    ) -> Args:
        """Before every command: a browser's with its view's revision, or ``by_simulation``.

        Returns:
            The arguments, each of its type.

        Raises:
            OperationError: it cannot be done now, was given on an old view, or has wrong arguments.
        """
        if rev is not None and rev != self.rev:
            raise self.stale()
        typed = check_arguments(self._flow.rules.arguments(name), args)
        if reason := self.why_not(name, typed, by_simulation):
            raise OperationError("not-now", reason)
        return typed

    def stale(self) -> StaleViewError:
        """What is raised where a command was given on an old view."""
        return StaleViewError(None)

    def refresh(self) -> View:
        """Publishes the view if it changed, and returns it."""
        with self.lock:
            view = self.view()
            if view != self._published:
                self._published = view
                self.station.bus.publish(self._flow.topic, view)
            return view

    def forget_datasheets(self) -> None:
        """Has the datasheets of the data folder read again at the next look."""

    def note_datasheets(self) -> None:
        """Goes by the datasheets of the data folder, which have been changed."""
        with self.lock:
            self.forget_datasheets()
            self.refresh()

    def knows_key(self, key: str) -> bool:
        """Whether a command with this idempotency key has acted already."""
        return self._journal.knows_key(key)

    def decline(self, refusal: OperationError) -> None:
        """Shows why something was not done, until something is."""
        with self.lock:
            self._trouble = Finding("attention", refusal.reason, sentence(refusal.remedy))
            self.declined += 1
            self.station.bus.event("refused", refusal.text, "attention")
            self.changed.notify_all()
            self.refresh()

    def start_job(self, title: Text, work: Callable[[Progress], None]) -> None:
        """Starts work in the background; why it failed is shown in the session.

        Raises:
            OperationError: ``busy`` while another job runs.
        """

        def done(job: Job[None]) -> None:
            if job.refusal is not None:
                self.decline(job.refusal)
            self.refresh()

        self.station.jobs.start(title, work, done)

    def start_simulation(self, work: Callable[[Progress], None]) -> None:
        """Lets the simulated operator work; raises ``OperationError`` while another job runs."""

        def run(progress: Progress) -> None:
            try:
                work(progress)
            finally:
                self.simulation_running = False

        self.simulation_running = True
        try:
            self.start_job(message("simulation-work"), run)
        except OperationError:
            self.simulation_running = False
            raise

    def stop_work(self) -> None:
        """Ends early what works by itself in this session; idempotent."""
        self.stop_simulation()

    def stop_simulation(self) -> None:
        """Ends the simulated operator's work in this session early; idempotent."""
        if self.simulation_running and self.station.simulated_operator is not None:
            self.simulation_running = False
            self.station.simulated_operator.cancel()
