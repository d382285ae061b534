"""Messages from the broker that have not been processed yet: bounded, whatever is published."""

import asyncio
import time
from collections import Counter, OrderedDict
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Literal

from crenel.supervision.messages import parse_topic

DropReason = Literal["long", "strange", "often", "crowded"]
"""long: over the limit; strange: not a message of a station; often: more of one topic than can be
shown; crowded: of more stations than are kept."""


class Unread:
    """Counts since the start, written on the event loop and read in any thread."""

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self._clock = clock
        self._counts: Counter[DropReason] = Counter()
        self._newest_s: float | None = None

    def add(self, why: DropReason, number: int = 1) -> None:
        self._counts[why] += number
        self._newest_s = self._clock()

    @property
    def counts(self) -> Mapping[str, int]:
        """By reason; reasons that never occurred are missing."""
        return {str(why): number for why, number in self._counts.items()}

    @property
    def ago_s(self) -> float | None:
        """Time since the newest one; None if all were read."""
        return None if self._newest_s is None else self._clock() - self._newest_s


LONGEST_BYTES = {"report": 64 * 1024, "presence": 4 * 1024, "event": 8 * 1024}
"""Reports of stations are usually a tenth of this."""
MOST_UNKNOWN, MOST_UNKNOWN_BYTES = 600, 8_000_000
"""Number of topics of unknown stations that may wait; those of known stations are not limited."""
TOLERATED = 10
"""Number of messages of one topic that may be overtaken before processing: the station was busy."""


@dataclass(frozen=True, slots=True)
class ReceivedMessage:
    """One message; ``retained`` if the broker retained it."""

    station: str
    kind: str
    payload: bytes
    retained: bool


@dataclass(slots=True)
class _Waiting:
    """The latest message of one topic, and how many came since the topic was last read."""

    latest: ReceivedMessage
    came: int = 0


class Inbox:
    """Keeps the latest message of each topic, in the order in which the topics first appeared.

    Known stations come before all others. It is used on the event loop only; ``put`` never waits.
    """

    def __init__(self, prefix: str, unread: Unread, is_known: Callable[[str], bool]) -> None:
        self._prefix, self._unread, self._is_known = prefix, unread, is_known
        self._known: OrderedDict[tuple[str, str], _Waiting] = OrderedDict()
        self._unknown: OrderedDict[tuple[str, str], _Waiting] = OrderedDict()
        self._unknown_bytes = 0
        self._filled = asyncio.Event()

    def __len__(self) -> int:
        """Topics with waiting messages."""
        return len(self._known) + len(self._unknown)

    def put(self, topic: str, payload: bytes, retained: bool) -> None:
        """Adds a message, or counts it as not read."""
        parts = parse_topic(self._prefix, topic)
        if parts is None:
            self._unread.add("strange")
            return
        if len(payload) > LONGEST_BYTES[parts[1]]:
            self._unread.add("long")
            return
        lane = self._known if self._is_known(parts[0]) else self._unknown
        received = ReceivedMessage(*parts, payload, retained)
        waiting = lane.setdefault(parts, _Waiting(received))
        if lane is self._unknown:
            before = len(waiting.latest.payload) if waiting.came else 0
            self._unknown_bytes += len(payload) - before
        waiting.latest = received
        waiting.came += 1
        if waiting.came > TOLERATED:
            self._unread.add("often")
        self._evict()
        self._filled.set()

    def _evict(self) -> None:
        while len(self._unknown) > MOST_UNKNOWN or self._unknown_bytes > MOST_UNKNOWN_BYTES:
            self._take_next(self._unknown)
            self._unread.add("crowded")

    async def wait(self) -> None:
        """Waits for a message."""
        await self._filled.wait()

    def take(self) -> ReceivedMessage | None:
        """The latest message of the next topic; None if none waits."""
        lane = self._known or self._unknown
        if not lane:
            self._filled.clear()
            return None
        return self._take_next(lane)

    def _take_next(self, lane: OrderedDict[tuple[str, str], _Waiting]) -> ReceivedMessage:
        _, waiting = lane.popitem(last=False)
        if lane is self._unknown:
            self._unknown_bytes -= len(waiting.latest.payload)
        return waiting.latest
