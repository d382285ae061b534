"""What the station tells the operator: sentences with their weight."""

from dataclasses import dataclass
from typing import Literal

from app.messages.message import Text, message

Quality = Literal["good", "attention", "bad", "neutral"]


@dataclass(frozen=True, slots=True)
class Finding:
    """One sentence with the number and the limit, and what to do about it; ``pose`` names the
    one of several poses that it is about."""

    quality: Quality
    text: Text
    remedy: Text = ""
    pose: int | None = None


def capital(text: Text) -> Text:
    """With a capital letter, as a sentence begins."""
    return message("capital", text=text) if text else ""
