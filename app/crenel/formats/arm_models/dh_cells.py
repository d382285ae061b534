"""Cells of a Denavit-Hartenberg table: numbers, multiples of π, degrees, joint variables."""

import math
import re
from dataclasses import dataclass
from typing import Literal

AngleUnit = Literal["deg", "rad"]

_VARIABLE = re.compile(r"([-+]?)\s*(?:q|θ|ϑ|theta|phi|φ|t|j)_?\{?[1-9]\}?\*?", re.IGNORECASE)
_NUMBER = r"\d+(?:\.\d*)?(?:e[-+]?\d+)?|\.\d+(?:e[-+]?\d+)?"
_WITH_PI = re.compile(rf"([-+]?)({_NUMBER})?\*?π(?:/({_NUMBER}))?", re.IGNORECASE)
_PLAIN = re.compile(rf"([-+]?)({_NUMBER})(°|deg|rad|mm|cm|m|inch|in)?", re.IGNORECASE)


_ANGLE_UNITS: dict[str, AngleUnit] = {"rad": "rad", "deg": "deg", "°": "deg"}


@dataclass(frozen=True)
class Cell:
    """A cell as it stands there; of a joint's angle, what is added to its reading."""

    value: float
    unit: AngleUnit | None = None
    """The cell itself says it: ``π/2``, ``90°``."""
    sign: int = 0
    """The sign of the joint's variable; 0 without one."""
    length_unit: str = ""
    """The cell itself says it: ``100 mm``."""


def parse_cell(text: str) -> Cell | None:
    """The value of a cell; None if it is none: ``-0.425``, ``-π/2``, ``90°``, ``100 mm``,
    ``q2 - 90``.

    Decimal commas are those of the table, and replaced before.
    """
    rest = re.sub(r"\s+", "", text.replace("\u2212", "-").replace("–", "-"))
    rest = re.sub(r"\\?pi", "π", rest, flags=re.IGNORECASE)
    sign = 0
    if (variable := _VARIABLE.search(rest)) is not None:
        sign = -1 if variable[1] == "-" else 1
        rest = rest[: variable.start()] + rest[variable.end() :]
        if rest in ("", "+"):
            return Cell(0.0, sign=sign)
    if (found := _WITH_PI.fullmatch(rest)) is not None:
        divisor = float(found[3] or 1)
        if divisor == 0:
            return None
        value = float(found[2] or 1) * math.pi / divisor
        return Cell(-value if found[1] == "-" else value, "rad", sign)
    if (found := _PLAIN.fullmatch(rest)) is not None:
        value = float(found[2]) * (-1 if found[1] == "-" else 1)
        suffix = (found[3] or "").lower()
        if not math.isfinite(value):
            return None
        if suffix in ("", *_ANGLE_UNITS):
            return Cell(value, _ANGLE_UNITS.get(suffix), sign)
        return Cell(value, sign=sign, length_unit="inch" if suffix == "in" else suffix)
    return None
