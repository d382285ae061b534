"""Test value uncertainty of a verification's figures: of the gauge and its set-up alone."""

from collections.abc import Mapping, Sequence

import numpy as np

from crenel.gauges.judgement.maths_value_uncertainty import (
    SphereCertificate,
    centre_uncertainty_um,
    form_uncertainty_um,
    plane_uncertainty_um,
    size_uncertainty_um,
)
from crenel.gauges.plan.document_gauge import GaugeFile
from crenel.gauges.quick.document import FigureName
from crenel.gauges.quick.maths.errors import ARCSEC_PER_RAD

RANGE_OF: dict[FigureName, FigureName] = {
    "angle": "angle_range",
    "offset": "offset_range",
    "z_error": "offset_range",
    "centre_error": "centre_range",
}
"""Figures to which two parts of one gauge contribute differently."""


def gauge_test_uncertainty(
    gauge: GaugeFile, widths_mm: Sequence[float] = (), steepness: float = 1.0
) -> Mapping[FigureName, float]:
    """The test value uncertainty of every figure of a gauge, k = 1, in the figure's unit.

    For where the gauge stands, it only has to stand still: nothing but its own form moves a fit.

    Args:
        gauge: the gauge by its certificate.
        widths_mm: of a plane's clouds, which turn its flatness into a tilt.
        steepness: of a plane, the share of Z in its normal.

    Source:
        ISO 14253-5, ISO/TS 23165.
    """
    return _plane(gauge, widths_mm, steepness) if gauge.shape == "plane" else _sphere(gauge)


def gauge_range_uncertainty(name: FigureName, test: Mapping[FigureName, float]) -> float:
    """What a gauge contributes to the difference of a figure between two clouds, k = 1.

    Args:
        name: of the figure.
        test: of the gauge, by ``gauge_test_uncertainty``.
    """
    ranged = RANGE_OF.get(name)
    if ranged is None:
        return 0.0
    steeper = test["z_error"] / test["offset"] if name == "z_error" and test["offset"] else 1.0
    return test[ranged] * steeper


def _sphere(gauge: GaugeFile) -> dict[FigureName, float]:
    assert gauge.radius_mm is not None
    sphere = SphereCertificate(
        2 * gauge.radius_mm, 2 * gauge.standard_uncertainty_um, gauge.form_um
    )
    form, place = form_uncertainty_um(sphere), centre_uncertainty_um(sphere)
    return {
        "form": form,
        "form_all": form,
        "range_all": form,
        "rms": form,
        "radius_error": size_uncertainty_um(sphere) / 2,
        "centre_error": place,
        "centre_range": place,
    }


def _plane(
    gauge: GaugeFile, widths_mm: Sequence[float], steepness: float
) -> dict[FigureName, float]:
    form = plane_uncertainty_um(gauge.form_um, gauge.standard_uncertainty_um)
    # clouds of different parts of the plane are tilted by half its flatness over their width
    tilt = np.arctan(gauge.form_um / 2e3 / min(widths_mm)) if widths_mm else 0.0
    return {
        "form": form,
        "form_all": form,
        "range_all": form,
        "rms": form,
        "angle": float(tilt) * ARCSEC_PER_RAD,
        "angle_range": float(tilt) * ARCSEC_PER_RAD,
        "offset": form,
        "z_error": form / steepness,
        "offset_range": gauge.form_um / 2,
    }
