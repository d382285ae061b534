"""Test value uncertainty of a verification's figures: of the gauge and its set-up alone."""

from collections.abc import Mapping, Sequence

import numpy as np

from app.formats.datasheets.gauge import GaugeFile
from app.formats.results.verification import FigureName
from app.metrology.gauges.errors import ARCSEC_PER_RAD
from app.metrology.performance.value_uncertainty import (
    SphereCertificate,
    centre_uncertainty_um,
    form_uncertainty_um,
    plane_uncertainty_um,
    size_uncertainty_um,
)
from app.workflows.measure_gauge import GaugeFit


def gauge_test_uncertainty(
    gauge: GaugeFile, fits: Sequence[GaugeFit]
) -> Mapping[FigureName, float]:
    """The test value uncertainty of every figure of a gauge, k = 1, in the figure's unit.

    For where the gauge stands, it only has to stand still: nothing but its own form moves a fit.

    Args:
        gauge: the gauge by its certificate.
        fits: of its clouds; for a plane, their widths turn its flatness into a tilt.

    Source:
        ISO 14253-5, ISO/TS 23165.
    """
    return _plane(gauge, fits) if gauge.shape == "plane" else _sphere(gauge)


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


def _plane(gauge: GaugeFile, fits: Sequence[GaugeFit]) -> dict[FigureName, float]:
    form = plane_uncertainty_um(gauge.form_um, gauge.standard_uncertainty_um)
    # clouds of different parts of the plane are tilted by half its flatness over their width
    widths_mm = [fit.width_mm for fit in fits if fit.width_mm]
    tilt = np.arctan(gauge.form_um / 2e3 / min(widths_mm)) if widths_mm else 0.0
    return {
        "form": form,
        "form_all": form,
        "range_all": form,
        "rms": form,
        "angle": float(tilt) * ARCSEC_PER_RAD,
        "angle_range": float(tilt) * ARCSEC_PER_RAD,
        "offset": form,
        "z_error": form,
        "offset_range": gauge.form_um / 2,
    }
