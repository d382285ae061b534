"""Texts in payloads for other programs: English, and next to it the message as data."""

from app.messages.message import Text
from app.messages.stored import SUFFIX
from app.supervision.message_data import message_data

LONGEST = 400
"""Of the English; what is longer is cut off."""


def payload_text(**texts: Text) -> dict[str, object]:
    """The fields of a payload for each text by its name: ``text`` and ``text_message``."""
    fields: dict[str, object] = {}
    for name, text in texts.items():
        fields |= {name: str(text)[:LONGEST], f"{name}{SUFFIX}": message_data(text)}
    return fields
