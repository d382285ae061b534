"""Units of length, and those that are mistaken for millimetres."""

MM_PER_M = 1000.0
MM_PER = {"mm": 1.0, "m": MM_PER_M, "inch": 25.4, "cm": 10.0, "dm": 100.0, "µm": 1e-3}
"""Millimetres in each unit."""
MISTAKEN_UNITS = ("m", "inch", "cm")
"""Units in which lengths are given where millimetres are expected, the commonest first."""


def mistaken_unit(ratio: float, within: float) -> str:
    """The unit of lengths of which each should be ``ratio`` times as large.

    Args:
        within: by which share the ratio may be off.

    Returns:
        One of ``MISTAKEN_UNITS``; empty: the ratio is that of no unit.

    Example:
        >>> mistaken_unit(25.1, 0.05), mistaken_unit(17.0, 0.05)
        ('inch', '')
    """
    for unit in MISTAKEN_UNITS:
        if MM_PER[unit] / (1 + within) <= ratio <= MM_PER[unit] * (1 + within):
            return unit
    return ""
