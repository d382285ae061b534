"""The stations that are heard of, and which of them is lost."""

import time
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Literal

from pydantic import BaseModel, ConfigDict, ValidationError

from app.supervise.messages import KINDS, Presence, StationEvent, StationReport

LOST_AFTER_S = 3.5
"""Without a report: three beats missed, so that one late message is no alarm."""
EVENTS_KEPT = 6
MOST_STATIONS = 200
"""Whatever may be on the broker."""

State = Literal["live", "lost", "off", "waiting", "unknown"]


class StationShown(BaseModel):
    """One station as the browser shows it."""

    model_config = ConfigDict(frozen=True)

    id: str
    name: str
    state: State
    """waiting: kept by the broker, and not heard yet; unknown: the broker itself is lost."""
    silent_s: float | None
    """Since its last report; null before the first."""
    report: StationReport | None
    events: tuple[StationEvent, ...]


@dataclass
class _Station:
    name: str
    known_s: float
    """Since when it is waited for."""
    heard_s: float | None = None
    said: Literal["online", "off", "lost"] = "online"
    instance: str = ""
    report: StationReport | None = None
    events: list[StationEvent] = field(default_factory=list)


class Fleet:
    """Folds messages into stations. It is used on one thread.

    A station is lost when the broker says so by its will, and also when no report came for
    ``LOST_AFTER_S`` though its connection stands: a process that hangs keeps its socket open.
    """

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self._clock = clock
        self._stations: dict[str, _Station] = {}
        self._broker_since: float | None = None
        self.invalid = 0
        """Messages that were no payload of these."""

    def broker(self, connected: bool) -> None:
        """The connection to the broker was made, or lost."""
        self._broker_since = self._clock() if connected else None

    def take(self, station: str, kind: str, payload: bytes, retained: bool) -> None:
        """A message; ``retained`` where the broker kept it from before."""
        if not payload:  # the way to remove what the broker keeps
            if kind == "presence":
                self._stations.pop(station, None)
            return
        try:
            message = KINDS[kind].model_validate_json(payload)
        except ValidationError:
            self.invalid += 1
            return
        if getattr(message, "station", None) != station:
            self.invalid += 1
            return
        if station not in self._stations and len(self._stations) >= MOST_STATIONS:
            self.invalid += 1
            return
        known = self._stations.setdefault(station, _Station(station, self._clock()))
        self._fold(known, message, retained)

    def _fold(self, known: _Station, message: BaseModel, retained: bool) -> None:
        if isinstance(message, Presence):
            older = known.heard_s is not None and message.instance != known.instance
            if older and message.state != "online":
                return  # the last will of an earlier start, come late
            known.name, known.said = message.name, message.state
            known.instance = message.instance
            if message.state == "online" and not retained:
                known.known_s = self._clock()
        elif isinstance(message, StationReport):
            known.name, known.report = message.name, message
            if not retained:
                known.heard_s = self._clock()
                known.said, known.instance = "online", message.instance
        elif isinstance(message, StationEvent) and not retained:
            known.events = [*known.events, message][-EVENTS_KEPT:]

    def shown(self) -> tuple[StationShown, ...]:
        """All stations as of now, by name."""
        stations = sorted(self._stations.items(), key=lambda item: (item[1].name.lower(), item[0]))
        return tuple(self._shown(id_, known) for id_, known in stations)

    def _shown(self, id_: str, known: _Station) -> StationShown:
        silent_s = None if known.heard_s is None else self._clock() - known.heard_s
        return StationShown(
            id=id_,
            name=known.name,
            state=self._state(known, silent_s),
            silent_s=silent_s,
            report=known.report,
            events=tuple(reversed(known.events)),
        )

    def _state(self, known: _Station, silent_s: float | None) -> State:
        if self._broker_since is None:
            return "unknown"
        if known.said != "online":
            return known.said
        now = self._clock()
        # what was missed while the broker was away is nobody's fault
        waited_s = now - max(known.known_s, self._broker_since)
        if silent_s is None or silent_s > LOST_AFTER_S:
            return "waiting" if waited_s <= LOST_AFTER_S else "lost"
        return "live"
