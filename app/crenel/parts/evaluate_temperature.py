"""Lengths of a part at 20 °C, from the temperature that it had."""

from dataclasses import dataclass
from math import hypot

from crenel.errors import OperationError
from crenel.messages.message import Text, message, quantity
from crenel.parts.document_program import ProgramFile

REFERENCE_C = 20.0
USUAL_SHARE = 0.1
"""Standard uncertainty of a coefficient of expansion, where none is stated."""
LEAST_C, MOST_C = -20.0, 80.0


@dataclass(frozen=True)
class PartTemperature:
    """What was measured of the part's temperature, °C."""

    value_c: float
    sd_c: float


@dataclass(frozen=True)
class Compensation:
    """By what factor lengths as measured become those at 20 °C."""

    factor: float = 1.0
    sd: float = 0.0
    text: Text = ""
    """What should be known of it."""

    @property
    def is_made(self) -> bool:
        """Whether lengths are those at 20 °C."""
        return self.factor != 1.0 or self.sd > 0


UNCOMPENSATED = Compensation()


def find_compensation(program: ProgramFile, temperature: PartTemperature | None) -> Compensation:
    """The factor by the part's expansion, if its temperature was measured.

    Raises:
        OperationError: the temperature is impossible, or the program has no expansion.
    """
    if temperature is None:
        text = message("part-temperature-not-compensated") if program.dimensions else ""
        return Compensation(text=text)
    if not LEAST_C <= temperature.value_c <= MOST_C or not 0 <= temperature.sd_c <= MOST_C:
        raise OperationError(
            "part-temperature",
            message(
                "part-temperature-impossible", temperature=quantity(temperature.value_c, "°C", 1)
            ),
            "",
            message("part-give-temperature"),
        )
    expansion = program.part.expansion_per_c
    if expansion is None:
        raise OperationError(
            "part-expansion",
            message("part-expansion-not-stated"),
            "",
            message("part-state-expansion"),
        )
    off = temperature.value_c - REFERENCE_C
    own = program.part.expansion_sd_per_c
    sd = USUAL_SHARE * expansion if own is None else own
    text = message(
        "part-temperature-compensated",
        temperature=quantity(temperature.value_c, "°C", 1),
        factor=quantity(1e6 * expansion * off, "ppm", 0),
    )
    return Compensation(1 - expansion * off, hypot(off * sd, expansion * temperature.sd_c), text)
