"""Messages in words: the language files, through Project Fluent's library."""

import re
from collections.abc import Callable
from functools import cache, partial
from typing import Any

from crenel.messages.language_file import ENGLISH, LanguageFile, languages
from crenel.messages.message import Message, MessageList, Quantity, Text, Value

FIRST_STRONG, POP = "\u2068", "\u2069"
TURNING = re.compile("[\u202a-\u202e\u2066-\u2069]")
"""Signs that turn all that follows."""
_LEFTWARDS = (
    "[\u0590-\u08ff\u200f\ufb1d-\ufdff\ufe70-\ufefc\U00010800-\U00010fff\U0001e800-\U0001efff]"
)
_RUN = re.compile(f"{_LEFTWARDS}(?:[\\d _'’-]*{_LEFTWARDS})*")
"""Letters from right to left with what stands between them."""
_ISOLATES = re.compile(f"\u2068[^\u202a-\u202e\u2066-\u2069]*\u2069|{TURNING.pattern}")
"""Those that are not of a text that was isolated before."""


def isolate_names(text: str) -> str:
    """A text in which what is written from right to left leaves the rest in its place.

    Signs that turn the text are seen and do nothing.
    """
    if text.isascii():
        return text
    plain = _ISOLATES.sub(lambda found: found[0] if len(found[0]) > 1 else "\ufffd", text)
    if FIRST_STRONG in plain:
        return plain
    return _RUN.sub(lambda run: f"{FIRST_STRONG}{run[0]}{POP}", plain)


MINUS, PLUS = "−", "+"
MINUTE_S = 60
TIGHT = frozenset(("", "°", "′", "″"))
"""Units that stand close behind their number."""

Render = Callable[[Text], str]


_FILE = re.compile(r"[^\s:,]*[/\\._]\w")
"""A path or the name of a file at the beginning of a text."""


def _capital(text: object) -> str:
    """With a capital letter, unless it begins with a file."""
    words = str(text)
    return words if _FILE.match(words) else words[:1].upper() + words[1:]


def _clause(text: object) -> str:
    return str(text).strip().rstrip(".")


def _in_minutes(seconds: float) -> str:
    """ "2 min 57 s", from an hour on "1 h 2 min"; the browser has the same (lengths.ts)."""
    minutes, rest_s = divmod(round(seconds), 60)
    hours, rest_min = divmod(minutes, 60)
    said = [(hours, "h"), (rest_min, "min")] if hours else [(minutes, "min"), (rest_s, "s")]
    return " ".join(f"{number} {unit}" for number, unit in said if number)


FUNCTIONS: dict[str, Callable[[Any], Any]] = {"CAPITAL": _capital, "CLAUSE": _clause}
"""What the language files may do to a text that is put in: begin it with a capital letter, take
its full stop away. The browser has the same."""


@cache
def renderer(language: str) -> Render:
    """What puts texts into the words of a language.

    Raises:
        FileNotFoundError: there is no such language.
    """
    return Catalogue(language).render


def translator(language: str) -> Render | None:
    """The renderer of another language; None for English, and for a language without a file."""
    return renderer(language) if language in languages()[1:] else None


def in_english(text: Text) -> str:
    """The text in English, the language of logs and of the console."""
    return text if isinstance(text, str) else renderer(ENGLISH)(text)


class Catalogue:
    """One language file. What it lacks is said in English."""

    def __init__(self, language: str) -> None:
        from babel import Locale
        from fluent.runtime import FluentBundle
        from fluent.runtime.types import fluent_number

        self._bundle = FluentBundle([language], FUNCTIONS, use_isolating=False)
        self._file = LanguageFile(language, self._bundle)
        self._decimal_point = Locale.parse(language).number_symbols["latn"]["decimal"]
        self._count = partial(fluent_number, useGrouping=False)
        self._language = language

    def render(self, text: Text) -> str:
        """The text in this language; an id that no file has is shown itself."""
        match text:
            case str():
                return text
            case Quantity():
                return self._quantity(text)
            case MessageList():
                return text.separator.join(self.render(item) for item in text.items)
            case Message():
                return self._message(text)

    def _message(self, text: Message) -> str:
        if not self._file.load(text.message_id):
            return text.message_id if self._language == ENGLISH else in_english(text)
        pattern = self._bundle.get_message(text.message_id).value
        if pattern is None:
            return text.message_id
        values = {name: self._value(value) for name, value in text.values.items()}
        words, _ = self._bundle.format_pattern(pattern, values)
        return str(words)

    def _value(self, value: Value) -> Any:
        match value:
            case str():
                return isolate_names(value)
            case int():
                return self._count(value)
            case _:
                return self.render(value)

    def _quantity(self, quantity: Quantity) -> str:
        """A number with a true minus sign, and none where nothing is left of it."""
        if quantity.unit == "s" and not quantity.decimals and quantity.value >= MINUTE_S:
            return _in_minutes(quantity.value)
        digits = f"{abs(quantity.value):.{quantity.decimals}f}"
        sign = ""
        if digits.strip("0."):
            sign = MINUS if quantity.value < 0 else PLUS if quantity.signed else ""
        space = "" if quantity.unit in TIGHT else " "
        return f"{sign}{digits.replace('.', self._decimal_point)}{space}{quantity.unit}"
