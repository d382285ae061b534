"""Limits for the uncertainty of scanned points."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Limits:
    """Limits of a point's uncertainty, k = 1: good up to the first, unusable above the second."""

    good_um: float = 50.0
    usable_um: float = 150.0


LIMITS = Limits()
