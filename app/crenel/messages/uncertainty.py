"""How every page, report, file and command rounds an uncertainty."""

from math import floor, log10

from crenel.messages.message import Quantity, Unit, quantity

DECIMALS: dict[Unit, int] = {"mm": 4}
USUAL_DECIMALS, MOST_DECIMALS = 1, 6
POINT_DECIMALS = 1
"""Decimals of the standard uncertainty of a scanned point, in µm."""


def uncertainty_decimals(value: float, usual: int = USUAL_DECIMALS) -> int:
    """So many decimals as usual, or two significant digits of a smaller one.

    Example:
        >>> [uncertainty_decimals(value) for value in (0.0, 123.4, 0.1, 0.096, 0.0034)]
        [1, 1, 1, 3, 4]
    """
    if not 0 < value < 10.0**-usual:
        return usual
    return min(1 - floor(log10(value)), MOST_DECIMALS)


def uncertainty_quantity(value: float, unit: Unit) -> Quantity:
    """An expanded uncertainty, rounded as everywhere; one that is not zero never appears as it.

    Example:
        >>> str(uncertainty_quantity(0.0964, "µm"))
        '0.096 µm'
    """
    value = max(value, 10.0**-MOST_DECIMALS) if value > 0 else value
    usual = DECIMALS.get(unit, USUAL_DECIMALS)
    return quantity(value, unit, uncertainty_decimals(value, usual))


def point_quantity(total_um: float) -> Quantity:
    """The standard uncertainty of a scanned point, rounded as in its report."""
    return quantity(total_um, "µm", POINT_DECIMALS)


def part_quantity(value: float, whole: float, unit: Unit) -> Quantity:
    """A part of an expanded uncertainty, to one decimal more.

    So the root of the parts as printed is the whole as printed.

    Example:
        >>> str(part_quantity(1.4368, whole=2.5103, unit="µm"))
        '1.44 µm'
    """
    return quantity(value, unit, uncertainty_quantity(whole, unit).decimals + 1)
