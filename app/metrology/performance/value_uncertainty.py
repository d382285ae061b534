"""Test value uncertainty: of the artefact and the set-up, not of the instrument that is tested.

ISO 14253-5 keeps the two apart: what the arm or scanner scatters is what the test measures.
"""

from dataclasses import dataclass
from typing import Literal

import numpy as np

DIAMETER_BY_FORM = 2 * 0.33 / (2 * np.sqrt(2.0))
"""What a lobed form of 1 µm makes of a diameter: its deviations have the standard deviation
``F / (2 sqrt(2))``, and the radius through 25 places 0.33 of that of a point."""
CENTRES_BY_FORM = {"touch": 0.7, "scan": 0.48, "both": 0.35}
"""What a form of 1 µm makes of the distance of centres by five touches, or by the patches that a
scan shows. Measured on simulated spheres with 5 to 8 lobes: ``crenel bench performance``."""
CENTRES_BY_DRIFT = {"touch": 0.13, "scan": 0.13, "both": 0.5}
"""What a drift of 1 µm over the whole test makes of it: five articulations take up to two fifths of
the time, ``0.4 * 1.12 / sqrt(12)``; from touches to scans the sphere moves by most of it."""
FORM_BY_DRIFT = 0.25
"""The same of the form of touches and scans together."""


@dataclass(frozen=True)
class SphereCertificate:
    """A sphere by its certificate; standard uncertainties, k = 1."""

    diameter_mm: float
    diameter_sd_um: float
    form_um: float
    form_sd_um: float = 0.0
    expansion_per_c: float = 0.0
    expansion_sd_per_c: float = 0.0


def form_uncertainty_um(sphere: SphereCertificate) -> float:
    """Of form and dispersion, k = 1: ``u² = (F/2)² + u_F²``.

    Source:
        ISO/TS 23165.
    """
    return float(np.hypot(sphere.form_um / 2, sphere.form_sd_um))


def size_uncertainty_um(
    sphere: SphereCertificate, temperature_sd_c: float = 0.0, off_c: float = 0.0
) -> float:
    """Of size, k = 1: the diameter's, the form's over 25 places, the temperature's, and that of
    the coefficient of expansion.

    Args:
        off_c: temperature of the sphere minus 20 °C.
    """
    by_form = DIAMETER_BY_FORM * sphere.form_um
    by_heat = 1e3 * sphere.diameter_mm * sphere.expansion_per_c * temperature_sd_c
    by_coefficient = 1e3 * sphere.diameter_mm * sphere.expansion_sd_per_c * off_c
    squares = sphere.diameter_sd_um**2 + by_form**2 + by_heat**2 + by_coefficient**2
    return float(np.sqrt(squares))


def centre_uncertainty_um(sphere: SphereCertificate) -> float:
    """Of the centre of a sphere through many points, k = 1: what its form makes of it."""
    return 0.35 * sphere.form_um / 2


def location_uncertainty_um(
    sphere: SphereCertificate, moved_um: float, of: Literal["touch", "scan", "both"]
) -> float:
    """Of a location error, k = 1: the sphere has to stand still, and its form moves the centres.

    Args:
        moved_um: distance between its centres by touch at the beginning and at the end.
        of: five articulations by touch or by scan, or touches against scans.
    """
    by_form = CENTRES_BY_FORM[of] * sphere.form_um
    return float(np.hypot(CENTRES_BY_DRIFT[of] * moved_um, by_form))


def form_of_both_uncertainty_um(sphere: SphereCertificate, moved_um: float) -> float:
    """Of the form of touches and scans together, k = 1: the sphere moves between them."""
    return float(np.hypot(form_uncertainty_um(sphere), FORM_BY_DRIFT * moved_um))


def plane_uncertainty_um(flatness_um: float, flatness_sd_um: float) -> float:
    """Of the form of a plane, k = 1."""
    return float(np.hypot(flatness_um / 2, flatness_sd_um))
