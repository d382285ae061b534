"""Keeps the catalogue up to date: looks at all stations at intervals, and at one when it reports an
event."""

import asyncio
import contextlib
import logging
import threading
import time
from collections.abc import Sequence
from math import inf

from crenel.errors import OperationError
from crenel.fleet.catalogue.catalogue import FleetCatalogue
from crenel.fleet.collection.collector import CollectedStation, collect
from crenel.fleet.fleet_settings import FleetSettings
from crenel.loop_states import waiting
from crenel.loops import Loop, repeat
from crenel.messages.message import Text, message
from crenel.supervision.broker import Broker
from crenel.supervision.messages import new_instance
from crenel.supervision.remote_stations import Fleet, RemoteStation

log = logging.getLogger(__name__)
COPY_S = 40.0
"""Behind an event, the station's archive has the record within this time if it copies at once."""
END_S = 10.0
LONGEST_LOOK_S = 300.0
"""At one record of a place, or at what a place has."""
LISTENER = "fleet"


class FleetService:
    """The catalogue, the thread that fills it, and the stations on the broker.

    While the database or an archive is away, it tries again at every look; the page says so.

    Raises:
        OperationError: a library is missing, or the settings name no database.
    """

    def __init__(self, settings: FleetSettings) -> None:
        self._settings = settings
        self._stations = settings.list_stations()
        self._catalogue: FleetCatalogue | None = None
        self.problem: Text = ""
        """Why the catalogue cannot be used now; empty if it can."""
        self.remote = Fleet()
        self.broker: Broker | None = None
        if settings.mqtt is not None:
            self.broker = Broker(
                settings.mqtt, LISTENER, "Fleet", new_instance(), self.remote, listens_only=True
            )
            self.broker.on_message = self._note_events
        self._due_s: dict[str, float] = {one.id: 0.0 for one in self._stations}
        self._heard: dict[str, tuple[str, int]] = {}
        self._reporting: set[str] = set()
        """Stations with an event since they were looked at."""
        self._wake, self._ending = threading.Event(), threading.Event()
        self._lock = threading.Lock()
        self._loop = Loop(
            "fleet-collect", self._look_at_due, ending=self._ending, longest_s=LONGEST_LOOK_S
        )
        self._listening: asyncio.Task[None] | None = None

    @property
    def looks_every_s(self) -> float:
        return self._settings.catalogue.look_s

    def catalogue(self) -> FleetCatalogue:
        """The catalogue, opened when it can be.

        Raises:
            OperationError: it cannot be used now.
        """
        with self._lock:
            if self._catalogue is None:
                self._catalogue = FleetCatalogue(self._settings.catalogue.url())
            return self._catalogue

    def remote_stations(self) -> Sequence[RemoteStation]:
        """What the stations on the broker report; empty without a broker."""
        return self.remote.stations() if self.broker is not None else ()

    def start(self) -> None:
        """Begins to collect, and to listen; on the event loop."""
        self._loop.start()
        if self.broker is not None:
            self._listening = asyncio.create_task(repeat("broker", self.broker.run, longest_s=inf))

    async def close(self) -> None:
        """Ends both: a look in progress has stored what it has by then."""
        self._ending.set()
        if self._listening is not None:
            self._listening.cancel()
            with contextlib.suppress(asyncio.CancelledError):
                await self._listening
        await asyncio.to_thread(self._loop.stop, END_S, self._wake.set)
        if self._catalogue is not None:
            self._catalogue.close()

    def _look_at(self, station: str) -> None:
        """Looks at a station now, beside the regular times."""
        if station in self._due_s:
            self._due_s[station] = time.monotonic()
            self._wake.set()

    def _note_events(self) -> None:
        """A station that reports something new has perhaps a new record: in its data folder at
        once, in its archive a little later."""
        for station in self.remote.stations():
            for event in station.events[-1:]:
                newest = (event.instance, event.number)
                if self._heard.get(station.id) != newest:
                    self._heard[station.id] = newest
                    self._reporting.add(station.id)
                    self._look_at(station.id)

    def _look_at_due(self) -> None:
        """Looks at the stations whose time has come, and waits for the next one's."""
        self._wake.clear()
        if self._ending.is_set():
            return
        now_s = time.monotonic()
        due = [one for one in self._stations if self._due_s[one.id] <= now_s]
        if due:
            self._look(due)
        next_s = min(self._due_s.values(), default=now_s + self.looks_every_s)
        with waiting():
            self._wake.wait(max(next_s - time.monotonic(), 0.0))

    def _look(self, due: Sequence[CollectedStation]) -> None:
        for one in due:
            pause_s = self.looks_every_s
            if one.id in self._reporting:
                self._reporting.discard(one.id)
                pause_s = min(pause_s, COPY_S)
            self._due_s[one.id] = time.monotonic() + pause_s
        try:
            problems = collect(self.catalogue(), due).problems
            self.problem = ""
            for station, problem in problems.items():
                log.warning("%s is not collected completely: %s", station, problem.line)
        except OperationError as error:
            if not self.problem:
                log.warning("%s", error.line)
            self.problem = error.text
        except Exception as error:  # the next look may succeed
            log.exception("collecting failed")
            self.problem = message("what-and-why", what=message("program-failed"), why=error)
