"""Notifications for absent users: done, fault, due."""

import time
from collections.abc import Callable
from typing import Annotated, Literal

from pydantic import Field

from crenel.messages.message import Text
from crenel.station.bus import Event
from crenel.supervision.message_data import MessageData
from crenel.supervision.messages import Count, Moment, Name, Payload, ShortText

NoticeKind = Literal["done", "fault", "due", "test"]
DONE = {"accepted", "scan-saved", "replay"}
REPEAT_S = 60.0
"""The same text is sent only once within this time: a loose cable must not cause a hundred
messages."""


class Notice(Payload):
    """One notification; the body of a webhook's request."""

    format: Literal["crenel/notice"] = "crenel/notice"
    number: Count = Field(description="Increases by one within an instance")
    station: Annotated[str, Field(pattern=r"^[a-z0-9-]{1,40}$")]
    instance: Annotated[str, Field(max_length=32)]
    name: Name = Field(description="Display name of the station")
    kind: NoticeKind
    at: Moment
    text: ShortText
    text_message: MessageData = None


def notice_kind(event: Event) -> NoticeKind | None:
    """The kind of notification for an event; None for most events."""
    if event.quality == "bad" and event.kind != "refused":
        return "fault"
    if event.kind in DONE and event.quality == "good":
        return "done"
    return None


class NoticeDeduplicator:
    """Whether the same text was sent recently."""

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self._clock = clock
        self._sent: dict[tuple[str, Text], float] = {}

    def is_new(self, kind: str, text: Text) -> bool:
        """Records it; False if it was sent within the last minute."""
        now_s = self._clock()
        self._sent = {key: at for key, at in self._sent.items() if now_s - at < REPEAT_S}
        new = (kind, text) not in self._sent
        if new:
            self._sent[kind, text] = now_s
        return new
