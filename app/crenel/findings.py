"""Messages of the station to the operator, with their severity."""

from dataclasses import dataclass
from typing import Literal

from crenel.messages.message import Text, message

Quality = Literal["good", "attention", "bad", "neutral"]
GRAVEST_FIRST: tuple[Quality, ...] = ("bad", "attention", "neutral", "good")


@dataclass(frozen=True, slots=True)
class Finding:
    """One sentence with the value and the limit, and a remedy; ``pose`` is the number of the pose
    concerned, if it concerns one."""

    quality: Quality
    text: Text
    remedy: Text = ""
    pose: int | None = None


def capital(text: Text) -> Text:
    """The text with a capital letter at the beginning."""
    return message("capital", text=text) if text else ""
