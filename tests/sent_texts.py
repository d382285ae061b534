"""What a station sends to people while tests run: texts as data, no ready English sentence."""

import json
import re
import threading
from collections.abc import Iterator

import httpx

from crenel.messages.catalogue import in_english
from crenel.messages.message import Message, Text, text_from_json, text_to_json
from crenel.messages.stored import SUFFIX

TEXT_FIELDS = frozenset(
    ("text", "title", "label", "note", "detail", "remedy", "why_not", "confirm", "instruction")
    + ("words", "wanted", "reason", "verdict_text", "what", "why", "trouble", "progress")
    + ("act", "action")
)
"""The fields that have texts; a plain string in them is a name, a number or empty."""
TWO_WORDS = re.compile(r"\b[a-z]{2,}\b \b[a-z]{2,}\b")
"""Of prose; names, paths and numbers have none."""
OWN_TEXTS = (
    *("at lunch", "a test", "the test is over"),
    *("the admin", "the operator", "the viewer", "Simulated "),
)
"""What the tests write themselves: reasons, names, and events of their own; and the names in
datasheets of simulated devices."""
QUOTED_TEXTS = ("Can't connect to device",)
"""What libraries say and messages quote as the reason: Aravis, of a camera that is gone."""


def english(data: object) -> str:
    return str(text_from_json(data))


class TextCollector:
    """Every text of answers and events."""

    def __init__(self) -> None:
        self._texts: set[str] = set()
        self._lock = threading.Lock()

    def answer(self, response: httpx.Response) -> None:
        """A hook of the tests' client."""
        log = response.url.path == "/api/logs"
        if "json" in response.headers.get("content-type", "") and not log:
            response.read()
            self.value(json.loads(response.content or "null"))

    def text(self, text: Text) -> None:
        with self._lock:
            self._texts.add(json.dumps(text_to_json(text)))

    def value(self, value: object) -> None:
        """All texts in a value of JSON."""
        for text in _texts(value):
            self.text(text)

    def untranslated(self) -> list[str]:
        """Those with prose that is no message, or with a term that no file has."""
        texts = [text_from_json(json.loads(text)) for text in sorted(self._texts)]
        return [str(text) for text in texts if not _is_translated(text)]


def _is_translated(text: Text) -> bool:
    data = text_to_json(text)
    prose = [item for item in _strings(data) if TWO_WORDS.search(item)]
    unknown = [term for term in _terms(data) if in_english(Message(term)) == term]
    return not unknown and all(
        any(known in item for known in OWN_TEXTS + QUOTED_TEXTS) for item in prose
    )


def _texts(value: object) -> Iterator[Text]:
    if isinstance(value, dict):
        if _is_text(value):
            yield text_from_json(value)
            return
        # of a file and of a problem, the data stand next to the English
        with_data = value.get("messages") or {}
        for key, inner in value.items():
            if isinstance(inner, str):
                if key in TEXT_FIELDS and f"{key}{SUFFIX}" not in value and key not in with_data:
                    yield inner
            elif key != "args":
                yield from _texts(inner)
    elif isinstance(value, list):
        for inner in value:
            yield from _texts(inner)


def _is_text(value: dict[str, object]) -> bool:
    return {"message_id", "values"} == value.keys() or {"items", "separator"} == value.keys()


def _strings(data: object) -> Iterator[str]:
    """The plain strings of a text, and those among its values."""
    match data:
        case str():
            yield data
        case {"message_id": _, "values": dict(values)}:
            for value in values.values():
                yield from _strings(value)
        case {"items": list(items)}:
            for item in items:
                yield from _strings(item)


def _terms(data: object) -> Iterator[str]:
    """The ids that code makes from a term, as ``word`` does; all others are in its source."""
    match data:
        case {"message_id": str(message_id), "values": dict(values)}:
            if message_id.startswith("word-"):
                yield message_id
            for value in values.values():
                yield from _terms(value)
        case {"items": list(items)}:
            for item in items:
                yield from _terms(item)
