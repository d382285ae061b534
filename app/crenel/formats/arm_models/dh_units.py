"""Units and convention of a Denavit-Hartenberg table: stated, likely, or refused as impossible."""

import math
from collections.abc import Sequence
from dataclasses import replace
from decimal import Decimal

from crenel.errors import OperationError
from crenel.formats.arm_models.dh_cells import Cell
from crenel.formats.arm_models.model import Answers, ModelQuestion, answer_to
from crenel.messages.message import Text, message, rounded
from crenel.units import MM_PER

LENGTH_UNITS = ("mm", "cm", "m", "inch")
ANGLE_UNITS = ("deg", "rad")
USUAL_MM, POSSIBLE_MM = (200.0, 6000.0), (100.0, 20_000.0)
"""What the lengths of arms add up to, as a rule and at most."""
CONVENTIONS = ("dh-standard", "dh-modified")
WORDS = {"modified": 1, "craig": 1, "mdh": 1, "modifiziert": 1, "standard": 0, "classic": 0}
"""Words of titles, with the convention that each states."""
FULL_TURN = 2 * math.pi + 2e-3
"""The largest angle in radians."""
FEWEST_DECIMALS = 2
"""With which a multiple of π/2 is recognized."""


def ask_length(total: float, stated: str, answers: Answers) -> ModelQuestion:
    """The unit of length.

    Args:
        total: sum of the lengths as they stand in the text.
        stated: the unit that the text states; empty if none.

    Raises:
        OperationError: with the stated or answered unit, no arm has such lengths; all are zero.
    """
    usual = [one for one in LENGTH_UNITS if _is_within(total * MM_PER[one], USUAL_MM)]
    question = ModelQuestion("length", LENGTH_UNITS, stated, bool(stated))
    why: Text = ""
    if len(usual) == 1:
        as_mm = rounded(total * MM_PER[usual[0]], "mm", 4)
        why = message("lengths-add-up", total=rounded(total, "", 4), unit=usual[0], length=as_mm)
        question = replace(question, likely=usual[0], why=why)
    if not total:
        raise OperationError(
            "model-length-unit",
            message("lengths-all-zero"),
            remedy=message("give-lengths-of-links"),
        )
    unit = stated or answer_to(question, answers)
    if unit:
        refuse_impossible_length(total * MM_PER[unit], unit, message("give-unit-of-lengths"), why)
    return replace(question, answer=unit)


def refuse_impossible_length(total_mm: float, unit: str, remedy: Text, why: Text = "") -> None:
    """Refuses an arm whose links are too short or too long in all, as in another unit.

    Args:
        total_mm: sum of the lengths of all links, read in this unit.

    Raises:
        OperationError: ``model-length-unit``.
    """
    if not _is_within(total_mm, POSSIBLE_MM):
        shown = message("lengths-in-unit", unit=unit, length=rounded(total_mm, "mm", 4))
        why = why or message("no-arm-has-such-lengths")
        raise OperationError("model-length-unit", shown, why, remedy)


def ask_angle(angles: Sequence[Cell], answers: Answers) -> ModelQuestion:
    """The unit of the angles that do not state theirs.

    Raises:
        OperationError: degrees are called radians, or radians degrees.
    """
    plain = [cell for cell in angles if cell.value and cell.unit is None]
    own = next((cell.unit for cell in angles if cell.value and cell.unit), "deg")
    question = ModelQuestion("angle", ANGLE_UNITS, "" if plain else own, stated=not plain)
    likely, why = _likely_unit(plain)
    if likely:
        question = replace(question, likely=likely, why=why)
    unit = question.answer or answer_to(question, answers)
    for called in ANGLE_UNITS:
        likely, why = _likely_unit([cell for cell in angles if (cell.unit or unit) == called])
        if likely not in ("", called):
            raise OperationError(
                "model-angle-unit",
                message("angles-called", unit=called),
                why,
                message("give-unit-of-angles"),
            )
    return replace(question, answer=unit)


def ask_convention(
    title: str, counts_before: bool, twists: Sequence[tuple[float, float]], answers: Answers
) -> ModelQuestion:
    """Whether the table is standard, or modified as Craig's.

    Args:
        title: the lines before the table.
        counts_before: lengths or twists have the index i - 1.
        twists: length and twist of each joint.
    """
    words = {WORDS[word] for word in title.lower().replace("-", " ").split() if word in WORDS}
    stated = CONVENTIONS[words.pop()] if len(words) == 1 else ""
    question = ModelQuestion("convention", CONVENTIONS, stated, bool(stated))
    first, last = any(twists[0]), any(twists[-1])
    if counts_before:
        question = replace(question, likely="dh-modified", why=message("index-before"))
    elif first and not last:
        question = replace(question, likely="dh-standard", why=message("last-row-empty"))
    elif last and not first:
        question = replace(question, likely="dh-modified", why=message("first-row-empty"))
    return replace(question, answer=stated or answer_to(question, answers))


def degrees_of(cell: Cell, unit: str) -> float:
    """An angle in degrees; a multiple of π/2 that was rounded when written is one.

    Args:
        unit: that of cells that do not say it themselves.
    """
    if (cell.unit or unit) != "rad":
        return cell.value
    quarters = round(cell.value / (math.pi / 2))
    return 90.0 * quarters if _is_right(cell.value) else math.degrees(cell.value)


def _likely_unit(angles: Sequence[Cell]) -> tuple[str, Text]:
    """The unit in which these angles can only be, and why; empty if they can be in both."""
    values = [abs(cell.value) for cell in angles if cell.value]
    largest = max(values, default=0.0)
    shown = rounded(largest, "", 6)
    if largest > FULL_TURN:
        return "deg", message("angle-beyond-a-turn", value=shown)
    if values and all(_is_right(value) for value in values):
        return "rad", message("angles-are-multiples", value=shown)
    return "", ""


def _is_within(value: float, limits: tuple[float, float]) -> bool:
    return limits[0] <= value <= limits[1]


def _is_right(value_rad: float) -> bool:
    """Whether an angle is a multiple of π/2 to the digits with which it is written."""
    off = abs(value_rad - round(value_rad / (math.pi / 2)) * math.pi / 2)
    decimals = _decimals(value_rad)
    return decimals >= FEWEST_DECIMALS and off <= 0.5000001 * 10.0**-decimals + 1e-15


def _decimals(value: float) -> int:
    """How many digits stand behind the point of a number."""
    return -int(Decimal(repr(value)).as_tuple().exponent)
