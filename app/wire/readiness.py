"""How far the station's start is."""

from collections.abc import Sequence
from dataclasses import dataclass


@dataclass(frozen=True)
class Readiness:
    """How far the station is: ``done`` of the steps, which are ``share`` of the time."""

    ready: bool
    station: str = ""
    steps: Sequence[str] = ()
    done: int = 0
    share: float = 0.0


READY = Readiness(ready=True, share=1.0)
