"""Test value uncertainty: of the artefact and the set-up, not of the instrument that is tested.

ISO 14253-5 keeps the two apart: what the arm or scanner scatters is what the test measures.
"""

from dataclasses import dataclass

import numpy as np

SPHERE_POINTS = 25


@dataclass(frozen=True)
class SphereCertificate:
    """A sphere by its certificate; standard uncertainties, k = 1."""

    diameter_mm: float
    diameter_sd_um: float
    form_um: float
    form_sd_um: float = 0.0
    expansion_per_c: float = 0.0


def form_uncertainty_um(sphere: SphereCertificate) -> float:
    """Of form and dispersion, k = 1: ``u² = (F/2)² + u_F²``.

    Source:
        ISO/TS 23165.
    """
    return float(np.hypot(sphere.form_um / 2, sphere.form_sd_um))


def size_uncertainty_um(sphere: SphereCertificate, temperature_sd_c: float = 0.0) -> float:
    """Of size, k = 1: the diameter's, the form's over 25 places, and the temperature's."""
    by_form = sphere.form_um / 2 / np.sqrt(SPHERE_POINTS)
    by_heat = 1e3 * sphere.diameter_mm * sphere.expansion_per_c * temperature_sd_c
    return float(np.sqrt(sphere.diameter_sd_um**2 + by_form**2 + by_heat**2))


def location_uncertainty_um(sphere: SphereCertificate, moved_um: float) -> float:
    """Of a location error, k = 1: the sphere only has to stand still.

    Args:
        moved_um: distance between its centres by touch at the beginning and at the end.
    """
    # a uniform drift by ``moved`` over the test, and the form's effect on a centre
    return float(np.hypot(moved_um / np.sqrt(12.0), 0.35 * sphere.form_um / 2))


def plane_uncertainty_um(flatness_um: float, flatness_sd_um: float) -> float:
    """Of the form of a plane, k = 1."""
    return float(np.hypot(flatness_um / 2, flatness_sd_um))
