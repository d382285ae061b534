"""Temperatures during a performance test, from readings at its beginning and at its end."""

from dataclasses import dataclass

REFERENCE_C = 20.0
"""ISO 1: sizes and lengths hold at this temperature."""
ROUNDING_C = 1e-9


@dataclass(frozen=True)
class TemperatureLimits:
    """How steady artefact and arm have to be: conditions of the laboratory, not of a standard."""

    change_c: float = 1.0
    """Most that each may change between beginning and end."""
    from_20_c: float = 5.0
    """Most that each may be away from 20 °C."""


TEMPERATURE_LIMITS = TemperatureLimits()
"""A station's, unless its settings have others."""


@dataclass(frozen=True)
class TemperatureSpan:
    """Readings in °C; None where none was taken."""

    begin_c: float | None = None
    end_c: float | None = None

    @property
    def known_c(self) -> list[float]:
        """The readings that were taken, in their order."""
        return [one for one in (self.begin_c, self.end_c) if one is not None]

    @property
    def change_c(self) -> float | None:
        """End minus beginning; None unless both are known."""
        return None if self.begin_c is None or self.end_c is None else self.end_c - self.begin_c

    @property
    def farthest_c(self) -> float | None:
        """The reading that is farther from 20 °C; None without any."""
        return max(self.known_c, key=lambda one: abs(one - REFERENCE_C), default=None)

    def is_change_too_large(self, limits: TemperatureLimits) -> bool:
        """Whether both readings are known and too far apart."""
        return abs(self.change_c or 0.0) > limits.change_c + ROUNDING_C

    def is_too_far(self, limits: TemperatureLimits) -> bool:
        """Whether a reading is too far from 20 °C."""
        off_c = 0.0 if self.farthest_c is None else self.farthest_c - REFERENCE_C
        return abs(off_c) > limits.from_20_c + ROUNDING_C


@dataclass(frozen=True)
class MeanTemperature:
    """The temperature at which everything of a test was measured."""

    celsius: float
    sd_c: float
    """Standard uncertainty."""

    @property
    def off_c(self) -> float:
        """Away from 20 °C, with its sign."""
        return self.celsius - REFERENCE_C


def mean_temperature(span: TemperatureSpan, sd_c: float) -> MeanTemperature | None:
    """The mean of the readings; None without any.

    When a touch was taken is not known, so its temperature is anywhere between the two readings:
    a rectangular distribution as wide as their difference.

    Args:
        sd_c: standard uncertainty of a reading, the same thermometer at both ends.

    Source:
        JCGM 100 (GUM), 4.3.7: u = width / sqrt(12).

    Example:
        >>> mean_temperature(TemperatureSpan(20.0, 23.0), 0.5)
        MeanTemperature(celsius=21.5, sd_c=1.0)
    """
    known_c = span.known_c
    if not known_c:
        return None
    change_c = span.change_c or 0.0
    return MeanTemperature(sum(known_c) / len(known_c), (sd_c**2 + change_c**2 / 12) ** 0.5)
