"""Other stations on the broker, and which of them are lost."""

import math
import time
from collections import OrderedDict
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict, PlainSerializer, ValidationError

from crenel.supervision.inbox import Unread
from crenel.supervision.message_data import readable
from crenel.supervision.messages import KINDS, Presence, StationEvent, StationReport

LOST_AFTER_S = 3.5
"""Without a report for three beats, so that one late message causes no alarm."""
MOST_STATIONS = 200
"""Maximum number of stations, whatever is on the broker."""
ESTABLISHED_S = 60.0
"""A station that has been heard for this long has priority over new ones."""
RETURN_AFTER_S = 0.5
"""A rejected station that sends again after this time counts as persistent."""
TURNED_AWAY_STORED = 8192

State = Literal["live", "lost", "off", "waiting", "unknown"]


def _readable(payload: BaseModel | None) -> object:
    return None if payload is None else readable(payload)


def _all_readable(payloads: Sequence[BaseModel]) -> object:
    return [readable(payload) for payload in payloads]


class RemoteStation(BaseModel):
    """One station as the browser shows it; each text is sent as its message, if it has one."""

    model_config = ConfigDict(frozen=True)

    id: str
    name: str
    state: State
    """waiting: retained by the broker, and not heard yet; unknown: the broker itself is lost."""
    silent_s: float | None
    """Time since its last report; null before the first."""
    report: Annotated[StationReport | None, PlainSerializer(_readable)]
    """Only the worst of its alarms."""
    alarms: int
    events: Annotated[tuple[StationEvent, ...], PlainSerializer(_all_readable)]
    """The newest event, if any."""


@dataclass
class _TrackedStation:
    name: str
    known_s: float
    """Time since which it has been expected."""
    first_s: float | None = None
    """Time of its first report."""
    heard_s: float | None = None
    presence: Literal["online", "off", "lost"] = "online"
    instance: str = ""
    report: StationReport | None = None
    """The report of a station with the worst alarm alone: two hundred stations may have sent the
    longest ones."""
    alarms: int = 0
    event: StationEvent | None = None
    """The newest one."""


class Fleet:
    """Combines messages into stations. It is used in one thread.

    A station is lost if the broker publishes its last will, and also if there was no report for
    ``LOST_AFTER_S`` although its connection exists: a process that hangs keeps its socket open.
    """

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self._clock = clock
        self._stations: dict[str, _TrackedStation] = {}
        self._turned_away: OrderedDict[str, float] = OrderedDict()
        """Times at which stations were first rejected; the latest of them."""
        self._broker_since: float | None = None
        self.unread = Unread(clock)

    def note_broker(self, connected: bool) -> None:
        """The connection to the broker was established or lost."""
        self._broker_since = self._clock() if connected else None

    def take(self, station: str, kind: str, payload: bytes, retained: bool) -> None:
        """Processes a message; ``retained`` if the broker retained it."""
        if not payload:  # the way to remove retained messages from the broker
            if kind == "presence":
                self._stations.pop(station, None)
            return
        try:
            received = KINDS[kind].model_validate_json(payload)
        except ValidationError:
            self.unread.add("strange")
            return
        if getattr(received, "station", None) != station:
            self.unread.add("strange")
            return
        if station not in self._stations and not self._make_space(station, retained):
            self.unread.add("crowded")
            return
        known = self._stations.setdefault(station, _TrackedStation(station, self._clock()))
        self._fold(known, received, retained)

    def knows(self, station: str) -> bool:
        return station in self._stations

    def _make_space(self, station: str, retained: bool) -> bool:
        """Whether there is room for one more station; if necessary, the one that has been silent
        longest is removed.

        A station that still sends is never removed, so that invented stations cannot hide existing
        ones; retained messages do not displace a station. A station that sent only once gives way
        to one that sends again, so that a flood of new names does not exclude a persistent station.
        """
        if len(self._stations) < MOST_STATIONS:
            return True
        if retained:
            return False
        returns = self._returns(station)
        id_, silent = min(self._stations.items(), key=lambda item: _eviction_rank(item[1]))
        sends = silent.heard_s is not None and self._clock() - silent.heard_s <= LOST_AFTER_S
        if sends and not (returns and silent.heard_s == silent.first_s):
            return False
        self._turned_away.pop(station, None)
        del self._stations[id_]
        return True

    def _returns(self, station: str) -> bool:
        """Whether a rejected station has sent before."""
        now_s = self._clock()
        first_s = self._turned_away.setdefault(station, now_s)
        if now_s - first_s > LOST_AFTER_S:
            self._turned_away[station] = now_s
        while len(self._turned_away) > TURNED_AWAY_STORED:
            self._turned_away.popitem(last=False)
        return RETURN_AFTER_S <= now_s - first_s <= LOST_AFTER_S

    def _fold(self, known: _TrackedStation, message: BaseModel, retained: bool) -> None:
        if isinstance(message, Presence):
            older = known.heard_s is not None and message.instance != known.instance
            if older and message.state != "online":
                return  # the last will of an earlier start that arrives late
            known.name, known.presence = message.name, message.state
            known.instance = message.instance
            if message.state == "online" and not retained:
                known.known_s = self._clock()
        elif isinstance(message, StationReport):
            known.name, known.report = message.name, _shorten_report(message)
            known.alarms = len(message.alarms)
            if not retained:
                known.heard_s = self._clock()
                known.first_s = known.heard_s if known.first_s is None else known.first_s
                known.presence, known.instance = "online", message.instance
        elif isinstance(message, StationEvent) and not retained:
            known.event = message

    def stations(self) -> tuple[RemoteStation, ...]:
        """All stations by name; those that have been heard for a while come before new ones."""
        stations = sorted(self._stations.items(), key=lambda item: (*_list_rank(item[1]), item[0]))
        return tuple(self._remote_station(id_, known) for id_, known in stations)

    def _remote_station(self, id_: str, known: _TrackedStation) -> RemoteStation:
        silent_s = None if known.heard_s is None else self._clock() - known.heard_s
        return RemoteStation(
            id=id_,
            name=known.name,
            state=self._state(known, silent_s),
            silent_s=silent_s,
            report=known.report,
            alarms=known.alarms,
            events=() if known.event is None else (known.event,),
        )

    def _state(self, known: _TrackedStation, silent_s: float | None) -> State:
        if self._broker_since is None:
            return "unknown"
        if known.presence != "online":
            return known.presence
        now = self._clock()
        # messages missed while the broker was away do not count
        waited_s = now - max(known.known_s, self._broker_since)
        if silent_s is None or silent_s > LOST_AFTER_S:
            return "waiting" if waited_s <= LOST_AFTER_S else "lost"
        return "live"


def _eviction_rank(known: _TrackedStation) -> tuple[bool, float]:
    """Small for stations that are removed first: briefly heard, then silent for long."""
    if known.first_s is None or known.heard_s is None:
        return False, -math.inf
    return known.heard_s - known.first_s >= ESTABLISHED_S, known.heard_s


def _list_rank(known: _TrackedStation) -> tuple[int, str]:
    """Order in the list: stations heard for a while, then those heard at all, then the others."""
    standing, heard_s = _eviction_rank(known)
    return -(standing + (heard_s > -math.inf)), known.name.lower()


def _shorten_report(report: StationReport) -> StationReport:
    if len(report.alarms) < 2:
        return report
    worst = min(report.alarms, key=lambda alarm: alarm.quality != "bad")
    return report.model_copy(update={"alarms": (worst,)})
