"""What a station says while tests run, held against the languages that it speaks."""

import json
import re
import threading
from collections.abc import Iterator

import httpx

from app.strings.files import languages
from app.strings.sentences import load_sentences

SENTENCES = frozenset(
    ("text", "title", "label", "note", "detail", "remedy", "why_not", "confirm", "instruction")
    + ("words", "wanted", "reason", "verdict_text", "what", "why", "trouble", "progress", "source")
    + ("act", "action")
)
"""Where they stand in what is sent, as frontend/src/state/spoken.ts has it."""
TWO_WORDS = re.compile(r"\b[a-z]{2,}\b \b[a-z]{2,}\b")
"""Names, paths and numbers within a sentence are as they are; words are not."""


TEST_TEXTS = ("at lunch", "a test", "the admin", "the operator", "the viewer")
"""What the tests say themselves: reasons, names, and events of their own."""


class MessageCollector:
    """Every sentence of answers and events."""

    def __init__(self) -> None:
        self._texts: set[str] = set()
        self._lock = threading.Lock()

    def answer(self, response: httpx.Response) -> None:
        """A hook of the tests' client."""
        log = response.url.path == "/api/logs"
        if "json" in response.headers.get("content-type", "") and not log:
            response.read()
            self.value(json.loads(response.content or "null"))

    def text(self, text: str) -> None:
        with self._lock:
            self._texts.add(text)

    def value(self, value: object) -> None:
        """All that stands where sentences do."""
        for text in _texts(value):
            self.text(text)

    def untranslated(self) -> list[str]:
        """What some language does not know, each with what of it."""
        found = []
        for language in languages()[1:]:
            sentences = load_sentences(language)
            for text in sorted(self._texts):
                missed = [part for part in sentences.best(text).missed if TWO_WORDS.search(part)]
                if missed and not any(own in text for own in TEST_TEXTS):
                    found.append(f"{language}: {text!r}: {missed}")
        return found


def _texts(value: object) -> Iterator[str]:
    if isinstance(value, dict):
        for key, inner in value.items():
            if key in SENTENCES and isinstance(inner, str):
                yield inner
            elif key != "args":
                yield from _texts(inner)
    elif isinstance(value, list):
        for inner in value:
            yield from _texts(inner)
