"""Messages: ids with values that carry their units. Pure, and without a word of any language."""

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field
from decimal import Decimal
from math import isfinite
from pathlib import Path
from typing import Any, Literal, NoReturn, TypeAlias, cast

Unit = Literal[
    "", "%", "ppm", "°", "′", "″", "mm", "µm", "nm", "m", "px", "s", "ms", "µs", "min", "h", "d",
    "°C", "K", "rad", "mrad", "Hz", "kHz", "fps", "kB", "MB", "GB", "MB/s", "mm/s", "°/s", "µm/K",
]  # fmt: skip
"""What stands behind a number; the language file has the number's place only."""


class _Rendered:
    """What is put into words only where it is read."""

    __slots__ = ()

    def __str__(self) -> str:
        """In English, as logs and the console have it."""
        from crenel.messages.catalogue import in_english

        return in_english(cast(Text, self))

    def __format__(self, spec: str) -> NoReturn:
        """In an f-string it would be English for every reader: it is refused."""
        raise TypeError(f"give {self!r} as a value of a message, or take str() for a log")


@dataclass(frozen=True, slots=True)
class Quantity(_Rendered):
    """A number with its unit, to so many ``decimals``; ``signed``: with a plus, too."""

    value: float
    unit: Unit = ""
    decimals: int = 0
    signed: bool = False

    __str__ = _Rendered.__str__


@dataclass(frozen=True, slots=True)
class Message(_Rendered):
    """A text of the language files, by its id.

    ``values`` fill its places. A ``str`` among them is a name or other text that has no
    translation: a serial number, a path, what a user wrote; or what the text chooses by.
    """

    message_id: str
    values: Mapping[str, "Value"] = field(default_factory=dict)

    __str__ = _Rendered.__str__

    def __hash__(self) -> int:
        return hash((self.message_id, repr(self.values)))


@dataclass(frozen=True, slots=True)
class MessageList(_Rendered):
    """Texts one after the other, as ``separator`` joins them: ", ", "; ", " · " or a space."""

    items: tuple["Text", ...]
    separator: str = ", "

    __str__ = _Rendered.__str__


Text: TypeAlias = Message | MessageList | Quantity | str
"""What is shown to people. A ``str`` is shown as it is in every language."""
Value: TypeAlias = Text | int


def message(message_id: str, /, **values: "Value | Path | Exception") -> Message:
    """The message of that id: ``message("edge-off", by=quantity(0.12, "mm", 2))``."""
    plain = {
        name: str(value) if isinstance(value, (Path, Exception)) else value
        for name, value in values.items()
    }
    return Message(message_id, plain)


def word(term: str) -> Message:
    """The name of a kind of thing that the program knows by an English word: ``plane``, ``left``.

    Its text is ``word-plane``; spaces in the term are hyphens.
    """
    return Message(f"word-{term.replace(' ', '-')}")


def quantity(value: float, unit: Unit = "", decimals: int = 0) -> Quantity:
    """A number with its unit."""
    return Quantity(float(value), unit, decimals)


def rounded(value: float, unit: Unit = "", digits: int = 6) -> Quantity:
    """A number of so many digits at most, without zeros at its end: 0.1 mm, 25 mm."""
    if not isfinite(value):
        return quantity(value, unit)
    exponent = Decimal(f"{value:.{digits}g}").normalize().as_tuple().exponent
    return Quantity(float(value), unit, max(0, -int(exponent)))


def signed(value: float, unit: Unit = "", decimals: int = 0) -> Quantity:
    """The same with its sign always, but for nothing."""
    return Quantity(float(value), unit, decimals, signed=True)


def join(items: Sequence[Text], separator: str = ", ") -> MessageList:
    """Texts one after the other."""
    return MessageList(tuple(items), separator)


def text_to_json(text: Text) -> object:
    """Plain values for a file; ``text_from_json`` reads them."""
    match text:
        case str():
            return text
        case Quantity():
            return asdict(text)
        case Message():
            values = {
                name: value if isinstance(value, int) else text_to_json(value)
                for name, value in text.values.items()
            }
            return {"message_id": text.message_id, "values": values}
        case MessageList():
            items = [text_to_json(item) for item in text.items]
            return {"items": items, "separator": text.separator}


def text_from_json(data: Any) -> Text:
    """A text from plain values; older files have sentences, which stay as they are.

    Raises:
        ValueError: it is no text.
    """
    match data:
        case str():
            return data
        case {"value": float() | int() as value, "unit": str(unit), "decimals": int(decimals)}:
            return Quantity(float(value), cast(Unit, unit), decimals, bool(data.get("signed")))
        case {"message_id": str(message_id), "values": dict(values)}:
            return Message(
                message_id,
                {
                    str(name): value if isinstance(value, int) else text_from_json(value)
                    for name, value in values.items()
                },
            )
        case {"items": list(items), "separator": str(separator)}:
            return MessageList(tuple(text_from_json(item) for item in items), separator)
    raise ValueError("it is no text")


def replace_name(text: Text, name: str, by: str) -> Text:
    """A text in which a name, as the beginning of a path, is another one wherever it stands."""
    match text:
        case str():
            return text.replace(name, by)
        case Message(message_id, values):
            replaced = {
                key: value if isinstance(value, int) else replace_name(value, name, by)
                for key, value in values.items()
            }
            return Message(message_id, replaced)
        case MessageList(items, separator):
            return MessageList(tuple(replace_name(item, name, by) for item in items), separator)
        case Quantity():
            return text


def mentions(text: Text, part: Text) -> bool:
    """Whether ``part`` is the text, or stands in it.

    Of a text of an earlier version, which is an English sentence, the words decide.
    """
    if isinstance(text, str):
        return str(part).strip().rstrip(".").lower() in text.lower()
    return _contains(text, _bare(part))


def _contains(text: Value, part: Text) -> bool:
    if isinstance(text, int):
        return False
    bare = _bare(text)
    if bare == part:
        return True
    match bare:
        case Message(_, values):
            return any(_contains(value, part) for value in values.values())
        case MessageList(items):
            return any(_contains(item, part) for item in items)
    return False


def _bare(text: Text) -> Text:
    """The text without the full stop that ``sentence`` puts to it."""
    while isinstance(text, Message) and text.message_id == "sentence":
        inner = text.values["text"]
        if isinstance(inner, int):
            return text
        text = inner
    return text
