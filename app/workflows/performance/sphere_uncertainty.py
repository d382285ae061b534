"""Test value uncertainty of the figures of the one-sphere test: of the sphere and its set-up."""

from app.formats.performance.plan import SpherePart
from app.formats.performance.symbols import Quantity
from app.metrology.performance.value_uncertainty import (
    SphereCertificate,
    form_of_both_uncertainty_um,
    form_uncertainty_um,
    location_uncertainty_um,
    size_uncertainty_um,
)


def sphere_certificate(sphere: SpherePart) -> SphereCertificate:
    """What the certificate of a plan's sphere says."""
    return SphereCertificate(
        sphere.diameter_mm,
        sphere.diameter_sd_um,
        sphere.form_um,
        sphere.form_sd_um,
        sphere.expansion_per_c,
        sphere.expansion_sd_per_c,
    )


def sphere_uncertainty_um(
    of: Quantity,
    sphere: SphereCertificate,
    moved_um: float,
    form_effect_um: float | None = None,
    temperature_sd_c: float = 0.0,
    off_c: float = 0.0,
) -> float:
    """Test value uncertainty of a quantity of the one-sphere test, k = 1.

    Args:
        moved_um: of the sphere, between the first touches and the last.
        form_effect_um: what its form makes of this form or dispersion; None if that is unknown,
            which makes it the half form of ISO/TS 23165.
        off_c: temperature of the sphere minus 20 °C.
    """
    if of.startswith("size"):
        return size_uncertainty_um(sphere, temperature_sd_c, off_c)
    if of == "location-touch":
        return location_uncertainty_um(sphere, moved_um, "touch")
    if of == "location-scan":
        return location_uncertainty_um(sphere, moved_um, "scan")
    if of == "location-both":
        return location_uncertainty_um(sphere, moved_um, "both")
    if of == "form-both":
        return form_of_both_uncertainty_um(sphere, moved_um)
    return form_uncertainty_um(sphere) if form_effect_um is None else form_effect_um
