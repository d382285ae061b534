"""The figures of one cloud of a gauge, each with its standard uncertainty."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from crenel.errors import OperationError
from crenel.gauges.quick.maths.errors import (
    ARCSEC_PER_RAD,
    NominalPlane,
    NominalSphere,
    SphereCheck,
    check_plane,
    check_sphere,
)
from crenel.gauges.quick.maths.figure_uncertainty import fit_uncertainty, range_sd, rms_sd
from crenel.gauges.quick.maths.gauge_gate import GATE_MM, UnfilteredForm, plane_form, sphere_form
from crenel.gauges.quick.maths.scanned_gauge import (
    cap_angle_rad,
    find_spheres,
    plane_width_mm,
    sphere_is_other,
)
from crenel.metrology.fitting.plane_sphere import PlaneFit, SphereFit
from crenel.metrology.fitting.shape import distances_from
from crenel.metrology.transforms import Floats

MOST_LEFT_OUT = 0.1
"""Share of a cloud's points beside a sphere from which on it is looked for by its radius, too."""


@dataclass(frozen=True)
class GaugeFigures:
    """What a cloud says of its gauge, in the units of the names."""

    used: int
    rms_mm: float
    form_mm: float
    in_gate: int
    range_mm: float
    place: dict[str, tuple[float, ...] | float]
    """The place of the fitted shape, by the fields of ``CloudReport``."""
    errors: dict[str, float | None]
    """Against the nominal, by name."""
    sd: dict[str, float]
    """Standard uncertainty (k = 1) of each figure by the scatter of the points, by name and in its
    unit."""
    width_mm: float | None = None
    """The width of a plane's cloud in its narrower direction."""
    radius_mm: float | None = None
    cap_rad: float | None = None
    """What the points cover of a sphere, from the middle to the rim."""

    def without(self, names: Sequence[str]) -> "GaugeFigures":
        """These figures without some errors."""
        return replace(
            self, errors={name: self.errors[name] for name in self.errors if name not in names}
        )

    def fields(self) -> dict[str, object]:
        """The fields of a ``CloudReport``."""
        return {
            "used": self.used,
            "rms_um": self.rms_mm * 1e3,
            "form_um": self.form_mm * 1e3,
            "in_gate": self.in_gate,
            "range_all_um": self.range_mm * 1e3,
            "width_mm": self.width_mm,
            **self.place,
            **self.errors,
        }


def as_frames(numbers: Floats) -> NDArray[np.int64] | None:
    """Frame numbers (N,); None if they are none."""
    if not np.isfinite(numbers).all() or float(np.abs(numbers).max(initial=0.0)) > 2**53:
        return None
    return numbers.astype(np.int64)


def plane_figures(
    points_mm: Floats,
    frame: NDArray[np.int64] | None,
    nominal: NominalPlane | None,
) -> GaugeFigures:
    """The figures of a plane's cloud.

    Args:
        points_mm: (N, 3) without NaN.
        frame: (N,) their frames, if the file has them.

    Raises:
        OperationError: as ``check_plane``.
    """
    check = check_plane(points_mm, nominal)
    fit = check.fit
    unfiltered = plane_form(points_mm, fit, points_mm[fit.used])
    sd = _dispersion_sd(fit, points_mm, unfiltered)
    found = fit_uncertainty(fit, points_mm[fit.used], None if frame is None else frame[fit.used])
    if found is not None:
        height = found.sd(0, 0) * 1e3
        steepness = max(abs(float(fit.normal[2])), 1e-9)
        sd |= {
            "angle_arcsec": found.sd(1, 2) * ARCSEC_PER_RAD,
            "offset_error_um": height,
            "z_error_um": height / steepness,
        }
    return GaugeFigures(
        used=int(np.sum(fit.used)),
        rms_mm=fit.rms_mm,
        form_mm=fit.form_mm,
        in_gate=unfiltered.points,
        range_mm=unfiltered.range_mm,
        place={
            "normal": tuple(fit.normal.tolist()),
            "offset_mm": fit.offset_mm,
            "centre_mm": tuple(fit.centre_mm.tolist()),
        },
        errors={
            "angle_arcsec": check.angle_arcsec,
            "z_error_um": check.z_error_um,
            "offset_error_um": check.offset_um,
        },
        sd=sd if found is not None else {},
        width_mm=plane_width_mm(points_mm[fit.used]),
    )


def sphere_figures(
    points_mm: Floats,
    frame: NDArray[np.int64] | None,
    nominal: NominalSphere | None,
) -> GaugeFigures:
    """The figures of a sphere's cloud, which may show larger things too if a nominal is given.

    Args:
        points_mm: (N, 3) without NaN.
        frame: (N,) their frames, if the file has them.

    Raises:
        OperationError: as ``check_sphere``.
    """
    check = _find_sphere(points_mm, nominal)
    fit = check.fit
    known = nominal is not None and abs(nominal.radius_mm - fit.radius_mm) < GATE_MM / 2
    radius_mm = nominal.radius_mm if nominal is not None and known else fit.radius_mm
    unfiltered = sphere_form(points_mm, fit, radius_mm)
    used = points_mm[fit.used]
    found = fit_uncertainty(fit, used, None if frame is None else frame[fit.used])
    sd = _dispersion_sd(fit, points_mm, unfiltered)
    if found is not None:
        radius = found.sd(3, 3)
        sd |= {
            "radius_mm": radius,
            "radius_error_um": radius * 1e3,
            "centre_error_um": found.sd(0, 2) * 1e3,
        }
    return GaugeFigures(
        used=len(used),
        rms_mm=fit.rms_mm,
        form_mm=fit.form_mm,
        in_gate=unfiltered.points,
        range_mm=unfiltered.range_mm,
        place={"centre_mm": tuple(fit.centre_mm.tolist()), "radius_mm": fit.radius_mm},
        errors={
            "radius_error_um": check.radius_error_um,
            "centre_error_um": check.centre_error_um,
        },
        sd=sd if found is not None else {},
        radius_mm=fit.radius_mm,
        cap_rad=cap_angle_rad(used, fit.centre_mm),
    )


def _find_sphere(points_mm: Floats, nominal: NominalSphere | None) -> SphereCheck:
    """The sphere in a cloud; where it is not most of it, by the nominal radius."""
    check: SphereCheck | None = None
    refusal: OperationError | None = None
    try:
        check = check_sphere(points_mm, nominal)
    except OperationError as error:
        refusal = error
    if nominal is not None and not _is_found(check, nominal, len(points_mm)):
        for part in find_spheres(points_mm, nominal):
            try:
                found = check_sphere(points_mm[part], nominal)
            except OperationError:
                continue
            if not sphere_is_other(found.fit.radius_mm, nominal.radius_mm):
                used = part.copy()
                used[part] = found.fit.used
                return replace(found, fit=replace(found.fit, used=used))
    if check is None:
        assert refusal is not None
        raise refusal
    return check


def _is_found(check: SphereCheck | None, nominal: NominalSphere, points: int) -> bool:
    """Whether a fit to all points is the gauge, and nearly all are its."""
    if check is None or sphere_is_other(check.fit.radius_mm, nominal.radius_mm):
        return False
    return int(check.fit.used.sum()) >= (1 - MOST_LEFT_OUT) * points


def _dispersion_sd(
    fit: PlaneFit | SphereFit, points_mm: Floats, unfiltered: UnfilteredForm
) -> dict[str, float]:
    """The standard deviations of rms, form and range, in µm."""
    off = distances_from(fit, points_mm[fit.used])
    scatter = {
        "rms_um": rms_sd(off, 3 if isinstance(fit, PlaneFit) else 4),
        "form_um": range_sd(off),
        "range_all_um": unfiltered.range_sd_mm,
    }
    return {name: sd * 1e3 for name, sd in scatter.items()}
