"""Compares clouds of gauges with their nominals (Eq. 10-12), as a report."""

from collections.abc import Sequence
from pathlib import Path
from typing import Literal

import numpy as np

from app.errors import OperationError
from app.formats.clouds.files import read_cloud
from app.formats.datasheets.gauge_nominal import read_nominal
from app.formats.io_errors import prefix_errors
from app.formats.results.gauge_report import CloudReport, GaugeReport, SpreadReport
from app.messages.message import Text, message, quantity
from app.metrology.fitting.plane_sphere import finite_points
from app.metrology.gauges.errors import (
    NominalPlane,
    NominalSphere,
    check_plane,
    check_sphere,
    compute_repeatability,
)
from app.metrology.gauges.gauge_gate import GATE_MM, plane_form, sphere_form
from app.metrology.transforms import Floats
from app.progress import Progress, no_progress

Shape = Literal["plane", "sphere"]
Unit = Literal["mm", "m", "inch"]
MM: dict[Unit, float] = {"mm": 1.0, "m": 1000.0, "inch": 25.4}
SMALLEST_MM, LARGEST_MM = 2.0, 20_000.0
"""Between these lie the sizes of clouds that an arm or a robot measures."""
FEW = 1.0
"""Percentage of a cloud's points beyond which it does not count for its size."""
SAME_RADIUS = 0.01
"""By which share of the nominal a radius in the right unit is off, at most."""
MOST_ROUGH = 0.01
"""The rms about a gauge's shape, of the cloud's size: more is another shape."""
NARROW = 0.02
"""The width of a cloud over its length: of less, the plane may turn about its line."""

FIGURES = {
    "angle_arcsec": ("angle ″", 1),
    "z_error_um": ("Z error µm", 1),
    "offset_error_um": ("offset µm", 1),
    "radius_mm": ("radius mm", 4),
    "radius_error_um": ("radius error µm", 1),
    "centre_error_um": ("centre error µm", 1),
    "rms_um": ("rms µm", 1),
    "form_um": ("form µm", 1),
    "range_all_um": ("range of all µm", 1),
}
"""Their headings and decimals."""


def verify(
    shape: Shape,
    clouds: Sequence[Path],
    nominal_path: Path | None = None,
    progress: Progress = no_progress,
    unit: Unit = "mm",
) -> tuple[GaugeReport, list[Text]]:
    """Fits every cloud and, given a nominal, says how far it is off.

    Args:
        unit: of the clouds' coordinates.

    Returns:
        The report, and what the user should know in addition.

    Raises:
        OperationError: a cloud or the nominal cannot be read, the nominal has another shape, or
            a cloud determines no plane or sphere.
    """
    nominal = None if nominal_path is None else read_nominal(nominal_path)
    found: list[CloudReport] = []
    warnings: list[Text] = []
    for done, path in enumerate(clouds):
        progress(done / len(clouds), path.name)
        points_mm = read_cloud(path).points_mm * MM[unit]
        with prefix_errors(path):
            cloud = _check_cloud(shape, path, points_mm, nominal)
        found.append(cloud)
        if other := _unit_by_radius(cloud, nominal, unit):
            warnings.append(message("cloud-of-another-unit", file=cloud.file, unit=other))
        else:
            warnings += _find_implausible(shape, cloud, points_mm, unit)
    progress(1.0, "")
    report = GaugeReport(
        shape=shape,
        nominal=None if nominal_path is None else str(nominal_path),
        clouds=tuple(found),
        spread=_spreads(found),
    )
    return report, warnings


def _unit_by_radius(
    cloud: CloudReport, nominal: NominalPlane | NominalSphere | None, unit: Unit
) -> Unit | None:
    """The other unit in which a sphere has its certified radius, if there is one."""
    if not isinstance(nominal, NominalSphere) or cloud.radius_mm is None:
        return None
    for other, mm in MM.items():
        off = cloud.radius_mm * mm / MM[unit] / nominal.radius_mm - 1
        if other != unit and abs(off) < SAME_RADIUS:
            return other
    return None


def _find_implausible(
    shape: Shape, cloud: CloudReport, points_mm: Floats, unit: Unit
) -> list[Text]:
    """Whether a cloud is of a size or a shape that it can hardly have."""
    finite = points_mm[np.isfinite(points_mm).all(axis=1)]
    between = np.percentile(finite, [FEW, 100 - FEW], axis=0)
    size_mm = float(np.linalg.norm(between[1] - between[0]))
    found: list[Text] = []
    if not SMALLEST_MM <= size_mm <= LARGEST_MM:
        size = quantity(size_mm, "mm", 0 if size_mm > LARGEST_MM else 3)
        found.append(message("cloud-of-odd-size", file=cloud.file, size=size, unit=unit))
    if cloud.rms_um * 1e-3 > MOST_ROUGH * size_mm:
        found.append(
            message(
                "cloud-of-another-shape",
                file=cloud.file,
                shape=shape,
                rms=quantity(cloud.rms_um * 1e-3, "mm", 3),
            )
        )
    length_mm, width_mm = _extent_mm(finite)
    if shape == "plane" and width_mm < NARROW * length_mm:
        found.append(
            message(
                "cloud-is-a-line",
                file=cloud.file,
                length=quantity(length_mm, "mm", 1),
                width=quantity(width_mm, "mm", 2),
            )
        )
    return found


def _extent_mm(points_mm: Floats) -> tuple[float, float]:
    """Length and width (mm) of most of the points (N, 3)."""
    _, axes = np.linalg.eigh(np.cov(points_mm.T))
    low, high = np.percentile(points_mm @ axes, [FEW, 100 - FEW], axis=0)
    width_mm, length_mm = np.sort(high - low)[1:]
    return float(length_mm), float(width_mm)


def _check_cloud(
    shape: Shape,
    path: Path,
    points_mm: Floats,
    nominal: NominalPlane | NominalSphere | None,
) -> CloudReport:
    if shape == "plane":
        if isinstance(nominal, NominalSphere):
            raise _shape_error("sphere", shape)
        return _plane_report(path, points_mm, nominal)
    if isinstance(nominal, NominalPlane):
        raise _shape_error("plane", shape)
    return _sphere_report(path, points_mm, nominal)


def _plane_report(path: Path, points_mm: Floats, nominal: NominalPlane | None) -> CloudReport:
    check = check_plane(points_mm, nominal)
    fit = check.fit
    finite, _ = finite_points(points_mm, 3, "plane")
    unfiltered = plane_form(finite, fit, points_mm[fit.used])
    nx, ny, nz = fit.normal.tolist()
    x, y, z = fit.centre_mm.tolist()
    return CloudReport(
        file=str(path),
        points=len(points_mm),
        used=int(np.sum(fit.used)),
        rms_um=fit.rms_mm * 1e3,
        form_um=fit.form_mm * 1e3,
        in_gate=unfiltered.points,
        range_all_um=unfiltered.range_mm * 1e3,
        normal=(nx, ny, nz),
        offset_mm=fit.offset_mm,
        centre_mm=(x, y, z),
        angle_arcsec=check.angle_arcsec,
        z_error_um=check.z_error_um,
        offset_error_um=check.offset_um,
    )


def _sphere_report(path: Path, points_mm: Floats, nominal: NominalSphere | None) -> CloudReport:
    check = check_sphere(points_mm, nominal)
    fit = check.fit
    finite, _ = finite_points(points_mm, 4, "sphere")
    known = nominal is not None and abs(nominal.radius_mm - fit.radius_mm) < GATE_MM / 2
    radius_mm = nominal.radius_mm if nominal is not None and known else fit.radius_mm
    unfiltered = sphere_form(finite, fit, radius_mm)
    x, y, z = fit.centre_mm.tolist()
    return CloudReport(
        file=str(path),
        points=len(points_mm),
        used=int(np.sum(fit.used)),
        rms_um=fit.rms_mm * 1e3,
        form_um=fit.form_mm * 1e3,
        in_gate=unfiltered.points,
        range_all_um=unfiltered.range_mm * 1e3,
        centre_mm=(x, y, z),
        radius_mm=fit.radius_mm,
        radius_error_um=check.radius_error_um,
        centre_error_um=check.centre_error_um,
    )


def _shape_error(found: Shape, wanted: Shape) -> OperationError:
    return OperationError(
        "nominal-of-another-shape",
        message("nominal-is-of", shape=found),
        message("is-to-be-verified", shape=wanted),
        message("give-gauges-own-nominal"),
    )


def _spreads(clouds: Sequence[CloudReport]) -> dict[str, SpreadReport]:
    if len(clouds) < 2:
        return {}
    found: dict[str, SpreadReport] = {}
    for name in FIGURES:
        values = [getattr(cloud, name) for cloud in clouds]
        if None not in values:
            over = compute_repeatability(values)
            found[name] = SpreadReport(
                mean=over.mean, standard_deviation=over.standard_deviation, range=over.range
            )
    return found


def report_table(report: GaugeReport) -> tuple[list[str], list[list[str]]]:
    """Headings and rows for printing: one row per cloud, then the scatter over several."""
    shown = [name for name in FIGURES if getattr(report.clouds[0], name) is not None]
    headings = ["cloud", "points", "used", *(FIGURES[name][0] for name in shown)]
    rows = [
        [
            cloud.file,
            str(cloud.points),
            str(cloud.used),
            *(f"{getattr(cloud, name):.{FIGURES[name][1]}f}" for name in shown),
        ]
        for cloud in report.clouds
    ]
    if report.spread:
        for title, field in (
            ("mean", "mean"),
            ("standard deviation", "standard_deviation"),
            ("range", "range"),
        ):
            figures = (
                f"{getattr(report.spread[name], field):.{FIGURES[name][1]}f}" for name in shown
            )
            rows.append([title, "", "", *figures])
    return headings, rows
