"""How reports print numbers, names and times."""

import re
from datetime import UTC

from app.timestamps import parse_moment

_UNITS = re.compile(r"(?<=\d) (?=(?:µm|mm|px|nm|%|°C|°)(?:\W|$))")
_SIGNS = re.compile(r"(?<=\S) ([×Ø]) (?=\d)")
_LIMIT = re.compile(r"([≤≥]) (?=\d)")
_MINUS = re.compile(r"(?<![\w-])-(?=\d)")
UNKNOWN = "not stated"


def device_name(name: str, serial: str) -> str:
    """A device by its name and serial number."""
    return f"{name or UNKNOWN}, serial number {serial or UNKNOWN}"


def format_moment(text: str | None) -> str:
    """An ISO time as people read it, in UTC."""
    if not text:
        return UNKNOWN
    try:
        when = parse_moment(text).astimezone(UTC)
    except ValueError:
        return text
    return f"{when:%Y-%m-%d %H:%M} UTC"


def micrometres(value_um: float) -> str:
    return f"{value_um:.1f} µm"


def millimetres(value_um: float) -> str:
    """Micrometres in millimetres, to a tenth of a micrometre."""
    return f"{value_um / 1e3:.4f} mm"


def temperature(value_c: float | None) -> str:
    return "not measured" if value_c is None else f"{value_c:.1f} °C"


def join_units(text: str) -> str:
    """The text with numbers not parted from their units, and minus signs as printed."""
    tight = _UNITS.sub("\u00a0", text).replace("k = ", "k\u00a0=\u00a0")
    tight = _LIMIT.sub("\\1\u00a0", _SIGNS.sub("\u00a0\\1\u00a0", tight))
    return _MINUS.sub("−", tight)


def simulation_notes(simulated: bool) -> list[str]:
    """What to know first of a record that was made without a real arm and sensor."""
    return ["Made on simulated hardware: a demonstration."] if simulated else []
