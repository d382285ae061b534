"""Contact tests of articulated arms after ASME B89.4.22: diameter, articulation, volume."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from crenel.metrology.fitting.reference_sphere import least_squares_sphere
from crenel.metrology.transforms import Floats

SPHERES, SPHERE_POINTS = 3, 9
SEATS, SEAT_POINTS = 3, 10
PLACEMENTS = 20


@dataclass(frozen=True)
class EffectiveDiameter:
    """A master sphere measured three times near the middle of the reach."""

    errors_um: tuple[float, ...]
    """The errors of each measurement: its diameter minus the calibrated one."""
    mean_error_um: float
    standard_deviation_um: float


@dataclass(frozen=True)
class VolumetricLength:
    """Deviations of a ball bar's length over its placements."""

    deviations_um: tuple[float, ...]
    largest_um: float
    """In absolute value."""
    two_rms_um: float


def effective_diameter(
    spheres_mm: Sequence[Floats],
    tip_diameter_mm: float,
    calibrated_mm: float,
    growth: float = 1.0,
) -> EffectiveDiameter:
    """The effective diameter test.

    Args:
        spheres_mm: tip centres (N, 3) of each measurement of the master sphere.
        tip_diameter_mm, calibrated_mm: of the tip and of the sphere, this at 20 °C.
        growth: diameter of the sphere in the test over that at 20 °C.

    Source:
        ASME B89.4.22-2004: three measurements near the middle of the arm's extension.
    """
    measured_mm = [
        least_squares_sphere(points).diameter_mm - tip_diameter_mm for points in spheres_mm
    ]
    errors_um = [1e3 * (one / growth - calibrated_mm) for one in measured_mm]
    sd = float(np.std(errors_um, ddof=1)) if len(errors_um) > 1 else 0.0
    return EffectiveDiameter(tuple(errors_um), float(np.mean(errors_um)), sd)


def volumetric_length(deviations_um: Sequence[float]) -> VolumetricLength:
    """The volumetric performance test.

    Args:
        deviations_um: measured minus calibrated length of each placement.

    Source:
        ASME B89.4.22-2004: twenty placements of a ball bar.
    """
    values = np.asarray(deviations_um, dtype=np.float64)
    return VolumetricLength(tuple(values.tolist()), _largest(values), _two_rms(values))


def volumetric_uncertainty_um(
    deviations_um: Floats, certificate_sds_um: Floats, form_sds_um: Floats
) -> tuple[float, float]:
    """Test value uncertainties of the largest deviation and of 2 RMS, k = 1.

    It is the same bar in every placement: what its certificate and temperature are off by shifts
    all deviations together, one way or the other. What the form of its spheres makes of a length is
    another in each placement.

    Args:
        deviations_um: (N,) of the placements.
        certificate_sds_um, form_sds_um: (N,) standard uncertainties of the certified lengths at
            their temperature, and by the form.

    Example:
        >>> volumetric_uncertainty_um(np.array([3.0, 3.0]), np.array([0.5, 0.5]), np.zeros(2))
        (0.5, 1.0)
    """
    shifted = [deviations_um + sign * certificate_sds_um for sign in (-1, 1)]
    count, largest_at = len(deviations_um), int(np.argmax(np.abs(deviations_um)))

    def of_shift(figure: Callable[[Floats], float]) -> float:
        changes = [figure(one) - figure(deviations_um) for one in shifted]
        return float(np.sqrt(np.mean(np.square(changes))))

    by_form = 2 * float(np.sqrt(np.mean(form_sds_um**2) / count))
    return (
        float(np.hypot(of_shift(_largest), form_sds_um[largest_at])),
        float(np.hypot(of_shift(_two_rms), by_form)),
    )


def _largest(values: Floats) -> float:
    return float(np.max(np.abs(values)))


def _two_rms(values: Floats) -> float:
    return 2 * float(np.sqrt(np.mean(values**2)))
