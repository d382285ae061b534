"""Errors of length: 5 lengths in 7 places, 3 times each."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from crenel.gauges.plan.maths_temperature import MeanTemperature
from crenel.metrology.transforms import Floats

LENGTHS, PLACES, REPEATS = 5, 7, 3
MOST_PLACES_OUTSIDE = 5
"""So many of the 35 may have one of their three values outside, and are measured again."""


LENGTH_BY_FORM = {"touch": 0.35, "scan": 0.27}
"""What a form of 1 µm of both spheres makes of the distance of their centres, by four touches all
around, or by a scan of caps of 40° (of 60°: 0.09). Simulated on spheres with 5 to 8 lobes."""


@dataclass(frozen=True)
class CalibratedLength:
    """A length by its certificate."""

    length_mm: float
    """At 20 °C."""
    standard_uncertainty_um: float
    expansion_per_c: float
    """Coefficient of thermal expansion."""
    expansion_sd_per_c: float = 0.0
    sphere_form_um: float = 0.0
    """Form deviation of the spheres at its ends."""


@dataclass(frozen=True)
class MeasuredLength:
    """One of the values."""

    place: int
    repeat: int
    nominal: CalibratedLength
    measured_mm: float
    artefact: MeanTemperature | None = None
    """Its temperature; None: taken as 20 °C."""
    by: Literal["touch", "scan"] = "touch"

    @property
    def error_um(self) -> float:
        """Measured minus calibrated length, with the artefact brought to 20 °C.

        Source:
            ISO 10360-2 and -12: E = L_measured - L_calibrated, expansion corrected.
        """
        off_c = 0.0 if self.artefact is None else self.artefact.off_c
        at_20_mm = self.measured_mm / (1 + self.nominal.expansion_per_c * off_c)
        return 1e3 * (at_20_mm - self.nominal.length_mm)

    @property
    def test_uncertainty_um(self) -> float:
        """Test value uncertainty, k = 1: of the certificate and the temperature with its
        change during the test, and what the form of the spheres makes of it; not the arm's."""
        return float(np.hypot(self.certificate_uncertainty_um, self.form_uncertainty_um))

    @property
    def form_uncertainty_um(self) -> float:
        """What the form of the spheres makes of the distance of their centres, k = 1: another
        one in each placement."""
        return LENGTH_BY_FORM[self.by] * self.nominal.sphere_form_um

    @property
    def certificate_uncertainty_um(self) -> float:
        """The uncertainty of the certificate and the temperature, k = 1: the same in every
        placement.

        Source:
            ISO/TS 23165: u² = u_cal² + (L ΔT u_α)² + (L α u_T)².
        """
        nominal = self.nominal
        off_c = 0.0 if self.artefact is None else self.artefact.off_c
        sd_c = 0.0 if self.artefact is None else self.artefact.sd_c
        length_um = 1e3 * nominal.length_mm
        return float(
            np.sqrt(
                nominal.standard_uncertainty_um**2
                + (length_um * off_c * nominal.expansion_sd_per_c) ** 2
                + (length_um * nominal.expansion_per_c * sd_c) ** 2
            )
        )


@dataclass(frozen=True)
class LengthSummary:
    """What the values of a length test say together."""

    worst: MeasuredLength
    outside: tuple[MeasuredLength, ...]
    """Values beyond the limit."""
    to_repeat: tuple[tuple[int, float], ...]
    """Places and lengths with one of three values outside: measured again, they must be inside."""
    accepted: bool
    """Whether the limit is kept, or may still be after the repeats."""


def summarise_lengths(
    values: Sequence[MeasuredLength], limits_um: Sequence[float]
) -> LengthSummary:
    """Judges values by their limits.

    Args:
        values: at least one.
        limits_um: the maximum permissible error of each; infinite without one.

    Source:
        ISO 10360-2: of the 35 groups, up to five may have one value outside.
    """
    pairs = list(zip(values, limits_um, strict=True))
    worst = max(pairs, key=lambda pair: (abs(pair[0].error_um) / pair[1], abs(pair[0].error_um)))[0]
    outside = tuple(value for value, limit in pairs if abs(value.error_um) > limit)
    groups: dict[tuple[int, float], int] = {}
    for value in outside:
        key = (value.place, value.nominal.length_mm)
        groups[key] = groups.get(key, 0) + 1
    single = tuple(sorted(key for key, count in groups.items() if count == 1))
    accepted = len(single) == len(groups) <= MOST_PLACES_OUTSIDE
    return LengthSummary(worst, outside, single, accepted)


def length_of_bar_mm(first_mm: Floats, second_mm: Floats) -> float:
    """Distance of the centres (3,) of a ball bar's two spheres."""
    return float(np.linalg.norm(np.asarray(first_mm) - np.asarray(second_mm)))


@dataclass(frozen=True)
class PermissibleError:
    """``A``, or ``A + L/K`` up to ``B``, in µm with L in mm."""

    a_um: float
    k: float | None = None
    """Dimensionless; the error grows by L/K."""
    b_um: float | None = None
    """The cap."""

    def at(self, length_mm: float = 0.0) -> float:
        """The limit in µm for a length.

        Source:
            The forms of ISO 10360-2, -9 and -12.

        Example:
            >>> PermissibleError(20.0, 40.0, 40.0).at(400.0)
            30.0
            >>> PermissibleError(20.0, 40.0, 40.0).at(4000.0)
            40.0
        """
        limit = self.a_um + (length_mm / self.k if self.k else 0.0)
        return limit if self.b_um is None else min(limit, self.b_um)
