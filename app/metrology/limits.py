"""Limits for the uncertainty of scanned points, and units that are mistaken for millimetres."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Limits:
    """Limits of a point's uncertainty, k = 1: good up to the first, unusable above the second."""

    good_um: float = 50.0
    usable_um: float = 150.0


LIMITS = Limits()

UNITS_MM = {"m": 1000.0, "inch": 25.4, "cm": 10.0}


def mistaken_unit(ratio: float, within: float) -> str:
    """The unit of lengths of which each should be ``ratio`` times as large.

    Args:
        within: by which share the ratio may be off.

    Returns:
        A key of ``UNITS_MM``; empty: the ratio is that of no unit.

    Example:
        >>> mistaken_unit(25.1, 0.05), mistaken_unit(17.0, 0.05)
        ('inch', '')
    """
    for unit, millimetres in UNITS_MM.items():
        if millimetres / (1 + within) <= ratio <= millimetres * (1 + within):
            return unit
    return ""
