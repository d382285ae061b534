"""Progress of the station's start."""

from collections.abc import Sequence
from dataclasses import dataclass

from crenel.messages.message import Text


@dataclass(frozen=True)
class Readiness:
    """Progress of the start: ``done`` of the steps, which take ``share`` of the time."""

    ready: bool
    failed: bool = False
    """The start has failed, and the program is about to end."""
    station: str = ""
    steps: Sequence[Text] = ()
    done: int = 0
    share: float = 0.0


READY = Readiness(ready=True, share=1.0)
