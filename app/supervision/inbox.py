"""What came from the broker and was not looked at yet: bounded, whatever is published there."""

import asyncio
import time
from collections import Counter, OrderedDict, deque
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Literal

from app.supervision.messages import EVENTS_STORED, parse_topic

DropReason = Literal["long", "strange", "often", "crowded"]
"""long: over the bound; strange: no message of a station; often: more of one topic than can be
shown; crowded: of more stations than are kept."""


class Unread:
    """Counts since the start. It is written on the event loop and read on any thread."""

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self._clock = clock
        self._counts: Counter[DropReason] = Counter()
        self._newest_s: float | None = None

    def add(self, why: DropReason, number: int = 1) -> None:
        self._counts[why] += number
        self._newest_s = self._clock()

    @property
    def counts(self) -> Mapping[str, int]:
        """By the reason; those that never were are missing."""
        return {str(why): number for why, number in self._counts.items()}

    @property
    def ago_s(self) -> float | None:
        """Since the newest; None where all were read."""
        return None if self._newest_s is None else self._clock() - self._newest_s


LONGEST_BYTES = {"report": 64 * 1024, "presence": 4 * 1024, "event": 8 * 1024}
"""A station's own are mostly a tenth of it."""
MOST_UNKNOWN, MOST_UNKNOWN_BYTES = 600, 8_000_000
"""Of stations that are not known yet so many topics may wait; of the known all may."""
TOLERATED = 10
"""So many of one topic may overtake one another before they are looked at: the station was busy."""


@dataclass(frozen=True, slots=True)
class ReceivedMessage:
    """One message; ``retained`` where the broker kept it from before."""

    station: str
    kind: str
    payload: bytes
    retained: bool


class _TopicQueue:
    """The latest of one topic; of events the last few."""

    def __init__(self, kind: str) -> None:
        self.messages: deque[ReceivedMessage] = deque(
            maxlen=EVENTS_STORED if kind == "event" else 1
        )
        self.came = 0

    @property
    def size(self) -> int:
        """In bytes."""
        return sum(len(message.payload) for message in self.messages)


class Inbox:
    """Keeps the latest message of each topic, in the order in which the topics were first heard.

    Known stations come before all others. It is used on the event loop alone; ``put`` never waits.
    """

    def __init__(self, prefix: str, unread: Unread, is_known: Callable[[str], bool]) -> None:
        self._prefix, self._unread, self._is_known = prefix, unread, is_known
        self._known: OrderedDict[tuple[str, str], _TopicQueue] = OrderedDict()
        self._unknown: OrderedDict[tuple[str, str], _TopicQueue] = OrderedDict()
        self._unknown_bytes = 0
        self._filled = asyncio.Event()

    def __len__(self) -> int:
        """Topics of which something waits."""
        return len(self._known) + len(self._unknown)

    def put(self, topic: str, payload: bytes, retained: bool) -> None:
        """Takes a message in, or counts it as not read."""
        parts = parse_topic(self._prefix, topic)
        if parts is None:
            self._unread.add("strange")
            return
        if len(payload) > LONGEST_BYTES[parts[1]]:
            self._unread.add("long")
            return
        lane = self._known if self._is_known(parts[0]) else self._unknown
        waiting = lane.setdefault(parts, _TopicQueue(parts[1]))
        before = waiting.size
        waiting.messages.append(ReceivedMessage(*parts, payload, retained))
        waiting.came += 1
        if waiting.came > TOLERATED:
            self._unread.add("often")
        if lane is self._unknown:
            self._unknown_bytes += waiting.size - before
            self._evict()
        self._filled.set()

    def _evict(self) -> None:
        while len(self._unknown) > MOST_UNKNOWN or self._unknown_bytes > MOST_UNKNOWN_BYTES:
            self._unread.add("crowded", len(self._take_next(self._unknown)))

    async def wait(self) -> None:
        """Until something is there."""
        await self._filled.wait()

    def take(self) -> list[ReceivedMessage]:
        """What waits of the next topic, the oldest first; nothing where none does."""
        lane = self._known or self._unknown
        if not lane:
            self._filled.clear()
            return []
        return self._take_next(lane)

    def _take_next(self, lane: OrderedDict[tuple[str, str], _TopicQueue]) -> list[ReceivedMessage]:
        _, waiting = lane.popitem(last=False)
        if lane is self._unknown:
            self._unknown_bytes -= waiting.size
        return list(waiting.messages)
