"""What the station tells the operator: sentences with their weight."""

from dataclasses import dataclass
from typing import Literal

Quality = Literal["good", "attention", "bad", "neutral"]


@dataclass(frozen=True, slots=True)
class Finding:
    """One sentence with the number and the limit, and what to do about it; ``pose`` names the
    one of several poses that it is about."""

    quality: Quality
    text: str
    remedy: str = ""
    pose: int | None = None


def capital(text: str) -> str:
    """With a capital letter, as a sentence begins."""
    return text[:1].upper() + text[1:]
