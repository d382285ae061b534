"""Texts in files and in the database: English for every reader, the message beside it as data.

In a JSON object, the English of a field ``text`` stands in ``text``, its data in
``text_message``; a list of texts has a list of data there. Older files have the English alone.
"""

import json
import math
from collections.abc import Mapping
from typing import Any, get_args

from crenel.messages.language_file import ENGLISH, read_sources
from crenel.messages.message import (
    Message,
    MessageList,
    Quantity,
    Text,
    Unit,
    text_from_json,
    text_to_json,
)

SUFFIX = "_message"
MOST_DECIMALS = 12
LONGEST_DATA = 4000
"""Characters of JSON in a database."""
RENDERED = (Message, MessageList, Quantity)
UNITS = frozenset(get_args(Unit))


def restore_text(english: str, data: object) -> Text:
    """The text that was written; its English where this version of Crenel has no such message."""
    try:
        text = text_from_json(data)
        return text if _is_usable(text) else english
    except (ValueError, OverflowError, RecursionError):
        return english


def encode_data(text: Text) -> str | None:
    """The data of a text as JSON, for a column next to that of its English; None where it has
    none or too much."""
    if isinstance(text, str):
        return None
    data = json.dumps(text_to_json(text), ensure_ascii=False)
    return data if len(data) <= LONGEST_DATA else None


def decode_text(english: str, data: str | None) -> Text:
    """The text of two such columns."""
    try:
        return english if data is None else restore_text(english, json.loads(data))
    except (ValueError, RecursionError):
        return english


def restore_texts(fields: Any) -> Any:
    """Values as read from a file, each text with data beside it restored."""
    if isinstance(fields, list):
        return [restore_texts(item) for item in fields] if _has_objects(fields) else fields
    if not isinstance(fields, Mapping):
        return fields
    restored = {name: restore_texts(value) for name, value in fields.items()}
    for name, value in fields.items():
        data = fields.get(f"{name}{SUFFIX}")
        if isinstance(value, str) and data is not None:
            restored[name] = restore_text(value, data)
        elif isinstance(value, list) and isinstance(data, list) and len(data) == len(value):
            restored[name] = [
                restore_text(item, one) if isinstance(item, str) else item
                for item, one in zip(value, data, strict=True)
            ]
    return restored


def _has_objects(items: list[Any]) -> bool:
    """Whether a list may hold texts, and is no long list of numbers."""
    return bool(items) and isinstance(items[0], Mapping)


def _is_usable(text: Text | int) -> bool:
    match text:
        case Message(message_id, values):
            return message_id in read_sources(ENGLISH) and all(map(_is_usable, values.values()))
        case MessageList(items):
            return all(map(_is_usable, items))
        case Quantity(value, unit, decimals):
            known = unit in UNITS and 0 <= decimals <= MOST_DECIMALS
            return known and math.isfinite(value)
    return True
