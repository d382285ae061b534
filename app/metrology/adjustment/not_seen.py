"""Poses whose pictures show nothing usable."""

from collections.abc import Sequence
from dataclasses import dataclass

from app.metrology.refusal import Refusal


@dataclass(frozen=True)
class NotSeen:
    """A pose whose pictures could not be used, and why."""

    number: int
    refusal: Refusal


def refuse_nothing_seen(seen: Sequence[object], unseen: Sequence[NotSeen], thing: str) -> None:
    """Refuses where no picture shows the ``thing``, with the reason of the first.

    Raises:
        Refusal: the first picture's own, or that there is no picture.
    """
    if seen:
        return
    if unseen:
        raise unseen[0].refusal
    raise Refusal("no-images", "no pose was given", "", f"take a picture of the {thing}")
