"""What the uncertainty of scanned points is judged by."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Limits:
    """Uncertainty of a point, k = 1: good up to the first, not to be used beyond the second."""

    good_um: float = 50.0
    usable_um: float = 150.0


LIMITS = Limits()
