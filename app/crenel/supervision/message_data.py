"""Texts of payloads as data: limited when sent, and checked when received."""

import math
from collections.abc import Sequence
from typing import Annotated

from pydantic import BaseModel, BeforeValidator, Field

from crenel.messages.message import Message, MessageList, Quantity, Text, text_to_json
from crenel.messages.stored import RENDERED, SUFFIX, restore_text

MOST_DEPTH, MOST_PARTS, MOST_CHARACTERS = 20, 160, 1200
"""For one text: maximum nesting, number of values, and total number of characters."""
LONGEST_TEXT = 400
"""Maximum length of the English text; longer texts are truncated."""
LARGEST = 2**53
"""Largest number that every reader represents exactly."""


def message_data(text: Text) -> object:
    """The data of a text for a payload; None if there is none or too much."""
    if isinstance(text, str):
        return None
    data = text_to_json(text)
    return data if _is_bounded(data) else None


def payload_text(**texts: Text) -> dict[str, object]:
    """The fields of a payload for each text by its name: ``text`` and ``text_message``."""
    fields: dict[str, object] = {}
    for name, text in texts.items():
        fields |= {name: str(text)[:LONGEST_TEXT], f"{name}{SUFFIX}": message_data(text)}
    return fields


def _check(data: object) -> object:
    """A received message; None for one that this version of Crenel does not have.

    Raises:
        ValueError: it is larger than any valid message.
    """
    if data is None or isinstance(data, RENDERED):
        return data
    if not _is_bounded(data):
        raise ValueError("it is larger than a message")
    text = restore_text("", data)
    return None if isinstance(text, str) else text


MessageData = Annotated[
    Message | MessageList | Quantity | None,
    BeforeValidator(_check),
    Field(description="The text as data, for readers of other languages"),
]


def _is_bounded(data: object) -> bool:
    """Whether plain values are few, short and not deeply nested; without recursion."""
    characters, parts = 0, 0
    level: Sequence[object] = [data]
    for _ in range(MOST_DEPTH):
        parts += len(level)
        if parts > MOST_PARTS:
            return False
        for value in level:
            if isinstance(value, str):
                characters += len(value)
            elif isinstance(value, dict):
                characters += sum(len(str(name)) for name in value)
            elif isinstance(value, (int, float)) and not _is_exact(value):
                return False
        if characters > MOST_CHARACTERS:
            return False
        level = [inner for value in level for inner in _inner(value)]
        if not level:
            return True
    return False


def _is_exact(number: float) -> bool:
    return math.isfinite(number) if isinstance(number, float) else abs(number) <= LARGEST


def _inner(value: object) -> Sequence[object]:
    if isinstance(value, dict):
        return list(value.values())
    return value if isinstance(value, list) else ()


def readable(payload: BaseModel) -> dict[str, object]:
    """A payload for the browser: each text as its message if it has one, otherwise in English."""
    return _with_messages(payload.model_dump())


def _with_messages(fields: dict[str, object]) -> dict[str, object]:
    shown: dict[str, object] = {}
    for name, value in fields.items():
        if name.endswith(SUFFIX):
            continue
        data = fields.get(f"{name}{SUFFIX}")
        if data is not None:
            value = data
        elif isinstance(value, dict):
            value = _with_messages(value)
        elif isinstance(value, tuple):
            value = [_with_messages(one) if isinstance(one, dict) else one for one in value]
        shown[name] = value
    return shown
