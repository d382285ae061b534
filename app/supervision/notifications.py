"""Notifications for somebody who is away: done, at fault, due."""

import time
from collections.abc import Callable
from typing import Annotated, Literal

from pydantic import Field

from app.messages.message import Text
from app.station.bus import Event
from app.supervision.message_data import MessageData
from app.supervision.messages import Count, Moment, Name, Payload, ShortText

NoticeKind = Literal["done", "fault", "due", "test"]
DONE = {"accepted", "scan-saved", "replay"}
REPEAT_S = 60.0
"""The same text is sent once in so long: a loose cable is no reason for a hundred messages."""


class Notice(Payload):
    """One message; the body of a webhook's request."""

    format: Literal["crenel/notice"] = "crenel/notice"
    number: Count = Field(description="Counts up by one, of one instance")
    station: Annotated[str, Field(pattern=r"^[a-z0-9-]{1,40}$")]
    instance: Annotated[str, Field(max_length=32)]
    name: Name = Field(description="The station's, for people")
    kind: NoticeKind
    at: Moment
    text: ShortText
    text_message: MessageData = None


def notice_kind(event: Event) -> NoticeKind | None:
    """What an event is to somebody who is away; None for most."""
    if event.quality == "bad" and event.kind != "refused":
        return "fault"
    if event.kind in DONE and event.quality == "good":
        return "done"
    return None


class NoticeDeduplicator:
    """Whether the same was sent lately."""

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self._clock = clock
        self._sent: dict[tuple[str, Text], float] = {}

    def is_new(self, kind: str, text: Text) -> bool:
        """Notes it; False where it was sent within the last minute."""
        now_s = self._clock()
        self._sent = {key: at for key, at in self._sent.items() if now_s - at < REPEAT_S}
        new = (kind, text) not in self._sent
        if new:
            self._sent[kind, text] = now_s
        return new
