"""Numbers beside the limits that they are compared with.

Rounded alone, 0.304 and 0.296 are both 0.3: a reader then sees a sign that contradicts the numbers.
"""

from collections.abc import Iterable
from dataclasses import replace

from crenel.messages.message import Quantity, Unit, rounded

MOST_DECIMALS = 6
"""Numbers that differ by less than these show are equal to a reader."""
SET_DECIMALS, TINY = 2, 1e-9


def decimals_beside(value: float, limits: Iterable[float], decimals: int = 0) -> int:
    """So many decimals at least that a value is not rounded to the other side of its limits, as
    ``round_limit`` has them, nor onto one of them.

    Example:
        >>> decimals_beside(0.304, [0.3], 2), decimals_beside(0.31, [0.3], 2)
        (3, 2)
    """
    compared = list(limits)
    for places in range(decimals, MOST_DECIMALS):
        shown = round(value, places)
        if all(_side(value, one) == _side(shown, round_limit(one, places)) for one in compared):
            return places
    return max(decimals, MOST_DECIMALS)


def round_limit(limit: float, decimals: int) -> float:
    """A limit that was computed, rounded; one that somebody set, with a few decimals more, as it
    is."""
    stated = round(limit, decimals + SET_DECIMALS)
    return stated if abs(stated - limit) < TINY else round(limit, decimals)


def limit_quantity(limit: float, unit: Unit, decimals: int) -> Quantity:
    """A limit beside a value of so many decimals, without zeros at its end; it is not rounded
    itself, since the browser may show it in inch.

    Example:
        >>> limit_quantity(142.19, "mm", 0)
        Quantity(value=142.19, unit='mm', decimals=2, signed=False)
        >>> limit_quantity(142.1934, "mm", 0)
        Quantity(value=142.1934, unit='mm', decimals=0, signed=False)
    """
    return replace(rounded(round_limit(limit, decimals), unit, digits=15), value=float(limit))


def beside_limit(
    value: float, limit: float, unit: Unit = "", decimals: int = 0, signed: bool = False
) -> tuple[Quantity, Quantity]:
    """A value and its limit as they are shown beside each other.

    Args:
        decimals: that the value has at least.
        signed: the value has its sign, and its size is compared.

    Example:
        >>> [(one.value, one.decimals) for one in beside_limit(0.304, 0.3, "px", 2)]
        [(0.304, 3), (0.3, 1)]
    """
    places = decimals_beside(abs(value) if signed else value, [limit], decimals)
    return Quantity(float(value), unit, places, signed), limit_quantity(limit, unit, places)


def _side(value: float, limit: float) -> int:
    return int(value > limit) - int(value < limit)
