"""Live state: the newest value of each topic, numbered events, many readers.

Device and worker threads publish; readers run on the event loop. This module is the only place
where data crosses from threads to the loop.
"""

import asyncio
import threading
from collections import deque
from collections.abc import Callable, Collection
from dataclasses import dataclass
from types import TracebackType
from typing import ParamSpec

from crenel.findings import Quality
from crenel.messages.message import Text

P = ParamSpec("P")

EVENT_BUFFER = 256


@dataclass(frozen=True, slots=True)
class Event:
    """An event; ``id`` increases by one."""

    id: int
    kind: str
    quality: Quality
    text: Text


@dataclass(frozen=True, slots=True)
class Updates:
    """Changes since the last look of a reader."""

    topics: dict[str, object]
    events: tuple[Event, ...]
    events_missed: int
    """Number of events that were dropped because this reader was slow."""


class Bus:
    """Latest-wins topics and numbered events.

    ``publish``, ``event``, ``latest`` and ``call`` may be used from any thread. A slow reader
    delays nobody: it finds the newest values on its next read.
    """

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._loop: asyncio.AbstractEventLoop | None = None
        self._waking = False
        self._values: dict[str, object] = {}
        self._versions: dict[str, int] = {}
        self._version = 0
        self._events: deque[Event] = deque(maxlen=EVENT_BUFFER)
        self._event_id = 0
        self._subscriptions: set[Subscription] = set()

    def attach(self, loop: asyncio.AbstractEventLoop) -> None:
        """Sets the event loop of readers and callbacks."""
        with self._lock:
            self._loop = loop
            self._waking = False

    def detach(self) -> None:
        """Forgets the event loop; later calls from threads are dropped."""
        with self._lock:
            self._loop = None

    def publish(self, topic: str, value: object) -> None:
        """Sets the newest value of a topic."""
        with self._lock:
            self._version += 1
            self._values[topic] = value
            self._versions[topic] = self._version
        self._wake()

    def event(self, kind: str, text: Text, quality: Quality = "neutral") -> Event:
        """Notifies every reader of an event."""
        with self._lock:
            self._event_id += 1
            event = Event(self._event_id, kind, quality, text)
            self._events.append(event)
        self._wake()
        return event

    def latest(self, topic: str) -> object | None:
        """The newest value of a topic; None before the first."""
        with self._lock:
            return self._values.get(topic)

    def call(self, callback: Callable[P, object], *args: P.args, **kwargs: P.kwargs) -> None:
        """Runs a callback on the event loop; dropped if there is none any more."""
        with self._lock:
            loop = self._loop
            if loop is not None and not loop.is_closed():
                loop.call_soon_threadsafe(lambda: callback(*args, **kwargs))

    def subscribe(self, without: Collection[str] = ()) -> "Subscription":
        """A new reader, to be used on the event loop.

        Its first ``next`` returns the value of every topic; past events are omitted. ``without``
        names topics that it does not want for now.
        """
        with self._lock:
            subscription = Subscription(self, self._event_id, without)
            self._subscriptions.add(subscription)
            return subscription

    def _wake(self) -> None:
        """Schedules one wake-up of all readers, however many changes precede it."""
        with self._lock:
            if self._waking or self._loop is None or self._loop.is_closed():
                return
            self._waking = True
            self._loop.call_soon_threadsafe(self._deliver)

    def _deliver(self) -> None:
        with self._lock:
            self._waking = False
            subscriptions = list(self._subscriptions)
        for subscription in subscriptions:
            subscription.changed.set()

    def _take(self, seen: dict[str, int], hidden: set[str], after: int) -> Updates:
        """Values newer than ``seen`` (which is updated) and events after an id."""
        with self._lock:
            topics: dict[str, object] = {}
            for topic, version in self._versions.items():
                if topic not in hidden and seen.get(topic, 0) < version:
                    topics[topic] = self._values[topic]
                    seen[topic] = version
            events = tuple(event for event in self._events if event.id > after)
            missed = self._event_id - after - len(events)
        return Updates(topics, events, missed)

    def _drop(self, subscription: "Subscription") -> None:
        with self._lock:
            self._subscriptions.discard(subscription)


class Subscription:
    """One reader of a bus; used on the event loop."""

    def __init__(self, bus: Bus, after_event: int, without: Collection[str]) -> None:
        self.changed = asyncio.Event()
        self.changed.set()
        self._bus = bus
        self._versions: dict[str, int] = {}
        self._hidden = set(without)
        self._after_event = after_event

    async def next(self) -> Updates:
        """Waits for a change; returns each topic once, with its newest value."""
        while True:
            await self.changed.wait()
            self.changed.clear()
            updates = self._bus._take(self._versions, self._hidden, self._after_event)
            self._after_event += updates.events_missed + len(updates.events)
            if updates.topics or updates.events or updates.events_missed:
                return updates

    def want(self, topic: str, on: bool) -> None:
        """Disables or enables a topic; once enabled, an unseen value is returned at once."""
        if on:
            self._hidden.discard(topic)
            self.changed.set()
        else:
            self._hidden.add(topic)

    def close(self) -> None:
        self._bus._drop(self)

    def __enter__(self) -> "Subscription":
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()
