"""Format of numbers, names and times in reports."""

import re
from collections.abc import Iterable
from datetime import UTC
from typing import Literal

from crenel.messages.limits import decimals_beside, limit_quantity
from crenel.messages.message import Message, Quantity, Text, Unit, message, quantity, rounded, word
from crenel.timestamps import parse_moment

_UNITS = re.compile(r"(?<=\d) (?=(?:µm|mm|px|nm|%|°C|°)(?:\W|$))")
_SIGNS = re.compile(r"(?<=\S) ([×Ø]) (?=\d)")
_LIMIT = re.compile(r"([≤≥±]) (?=\d)")
_MINUS = re.compile(r"(?<![\w-])-(?=\d)")
UNKNOWN = message("not-stated")
NONE = word("none")


def device_name(name: str, serial: str) -> Message:
    """A device by its name and serial number."""
    return message("name-and-serial-number", name=name or UNKNOWN, serial_number=serial or UNKNOWN)


def software_name(version: str) -> Message:
    """This program in one of its versions."""
    return message("crenel", version=version)


def format_moment(text: str | None) -> Text:
    """An ISO time in readable form, in UTC."""
    if not text:
        return UNKNOWN
    try:
        when = parse_moment(text).astimezone(UTC)
    except ValueError:
        return text
    return f"{when:%Y-%m-%d %H:%M} UTC"


def micrometres(value_um: float) -> Quantity:
    return quantity(value_um, "µm", 1)


def error_value(value: float, unit: Literal["µm", "″"]) -> Quantity:
    """An error in the unit of its kind."""
    return quantity(value, unit, 1)


def millimetres(value_um: float) -> Quantity:
    """Micrometres in millimetres, to a tenth of a micrometre."""
    return quantity(value_um / 1e3, "mm", 4)


def in_both_units(
    value_um: float, limits_um: Iterable[float | None] = ()
) -> tuple[Quantity, Quantity]:
    """A length in micrometres and in millimetres, as in the two columns of the tables.

    Args:
        limits_um: in the same row; both are so exact that none seems to be on its other side.
    """
    places = _places(value_um, limits_um)
    return quantity(value_um, "µm", places), quantity(value_um / 1e3, "mm", places + 3)


def value_beside(value: float, limit: float | None, unit: Unit, signed: bool = False) -> Quantity:
    """A value beside the limit by which its size is judged: never rounded to its other side."""
    return Quantity(float(value), unit, _places(value, [limit]), signed)


def limit_beside(value: float | None, limit: float, unit: Unit) -> Quantity:
    """A limit in the row of a value, which is rounded no more than that."""
    return limit_quantity(limit, unit, _places(value or 0.0, [limit]))


def at_most(limit_um: float | None, value_um: float) -> Text:
    """A limit in the row of a value, as in the tables."""
    if limit_um is None:
        return NONE
    return message("at-most-limit", limit=limit_beside(value_um, limit_um, "µm"))


def _places(value: float, limits: Iterable[float | None]) -> int:
    return decimals_beside(abs(value), [one for one in limits if one is not None], 1)


def plus_minus(uncertainty: Quantity) -> Message:
    """An expanded uncertainty."""
    return message("plus-minus", uncertainty=uncertainty)


def ball_diameter(value_mm: float, digits: int = 4) -> Message:
    """The diameter of a ball, with a limited number of digits."""
    return message("ball-diameter", diameter=rounded(value_mm, "mm", digits))


def temperature(value_c: float | None) -> Text:
    return message("not-measured") if value_c is None else quantity(value_c, "°C", 1)


def join_units(text: str) -> str:
    """The text with numbers not separated from their units, and typographic minus signs."""
    tight = _UNITS.sub("\u00a0", text).replace("k = ", "k\u00a0=\u00a0")
    tight = _LIMIT.sub("\\1\u00a0", _SIGNS.sub("\u00a0\\1\u00a0", tight))
    return _MINUS.sub("−", tight)


def simulation_notes(simulated: bool) -> list[Text]:
    """The note for a record that was made without a real arm and sensor."""
    return [message("made-simulated-hardware-demonstration")] if simulated else []
