"""Compares clouds of gauges with their nominals (Eq. 10-12), as a report."""

from collections.abc import Mapping, Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Literal, get_args

import numpy as np

from crenel.errors import OperationError
from crenel.formats.clouds.files import read_cloud
from crenel.formats.clouds.points import Cloud
from crenel.formats.io_errors import prefix_errors
from crenel.gauges.plan.document_gauge import GaugeFile, read_gauge
from crenel.gauges.quick.clouds.document import CloudReport, GaugeReport, SpreadReport
from crenel.gauges.quick.clouds.document_nominal import read_nominal
from crenel.gauges.quick.document import FigureName
from crenel.gauges.quick.evaluate_value_uncertainty import (
    gauge_range_uncertainty,
    gauge_test_uncertainty,
)
from crenel.gauges.quick.maths.errors import NominalPlane, NominalSphere
from crenel.gauges.quick.maths.figure_budget import (
    Budget,
    K,
    Source,
    combine_budget,
    spread_statistics,
)
from crenel.gauges.quick.maths.gauge_figures import (
    GaugeFigures,
    as_frames,
    plane_figures,
    sphere_figures,
)
from crenel.gauges.quick.maths.scanned_gauge import LEAST_CAP_RAD
from crenel.messages.message import Text, message, quantity
from crenel.messages.uncertainty import uncertainty_quantity
from crenel.metrology.fitting.plane_sphere import finite_points
from crenel.metrology.transforms import Floats
from crenel.progress import Progress, no_progress
from crenel.units import MM_PER

Shape = Literal["plane", "sphere"]
Unit = Literal["mm", "m", "inch"]
MM: dict[Unit, float] = {unit: MM_PER[unit] for unit in get_args(Unit)}
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

FIGURES: dict[str, tuple[str, int]] = {
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
DISPERSIONS = ("rms_um", "form_um", "range_all_um")
NAMES: dict[str, FigureName] = {
    "angle_arcsec": "angle",
    "z_error_um": "z_error",
    "offset_error_um": "offset",
    "radius_error_um": "radius_error",
    "centre_error_um": "centre_error",
    "rms_um": "rms",
    "form_um": "form",
    "range_all_um": "range_all",
}
"""The figures of a verification that have the same uncertainty by their gauge."""
PLACE_ERRORS = ("z_error_um", "offset_error_um", "centre_error_um", "angle_arcsec")
"""What a cloud in other coordinates does not have."""
PARAMETERS: dict[Shape, int] = {"plane": 3, "sphere": 4}
EXACT_MM, MOST_EXACT = 5e-5, 0.95
"""An rms that prints as 0.0 µm; with it, this share of the points is used unless others, which are
not exact, show that the exact ones were not measured."""
LARGEST_SHAPE_MM = 5e5


def verify_clouds(
    shape: Shape,
    clouds: Sequence[Path],
    nominal_path: Path | None = None,
    progress: Progress = no_progress,
    unit: Unit | None = None,
    columns: Sequence[str] | None = None,
) -> tuple[GaugeReport, list[Text]]:
    """Fits every cloud and, given a nominal, says how far it is off.

    Args:
        unit: of the numbers in the clouds; by default as ``read_cloud`` has it.
        columns: of x, y and z, as in ``read_cloud``.

    Returns:
        The report, and what the user should know in addition.

    Raises:
        OperationError: a cloud or the nominal cannot be read, the nominal has another shape, or
            a cloud determines no plane or sphere.
    """
    nominal = None if nominal_path is None else read_nominal(nominal_path)
    gauge = None if nominal_path is None else read_gauge(nominal_path)
    found: list[CloudReport] = []
    warnings: list[Text] = []
    for done, path in enumerate(clouds):
        progress(done / len(clouds), path.name)
        read = read_cloud(path, columns, None if unit is None else MM[unit])
        with prefix_errors(path):
            cloud, findings = _check_cloud(shape, path, read, nominal, gauge)
        found.append(cloud)
        warnings += _describe_left_out(cloud)
        if other := _unit_by_radius(cloud, nominal, read.mm_per_unit):
            warnings.append(message("cloud-of-another-unit", file=cloud.file, unit=other))
        else:
            warnings += findings + _find_implausible(shape, cloud, read)
    progress(1.0, "")
    widths_mm = [cloud.width_mm for cloud in found if cloud.width_mm]
    report = GaugeReport(
        shape=shape,
        nominal=None if nominal_path is None else str(nominal_path),
        clouds=tuple(found),
        spread=_spreads(found, _gauge_parts(nominal, gauge, widths_mm)),
    )
    return report, warnings


def _describe_left_out(cloud: CloudReport) -> list[Text]:
    said: list[Text] = []
    if cloud.deleted:
        said.append(message("cloud-left-out-deleted", file=cloud.file, points=cloud.deleted))
    if cloud.missing:
        said.append(message("cloud-left-out-missing", file=cloud.file, points=cloud.missing))
    if cloud.repeated:
        said.append(message("cloud-left-out-repeated", file=cloud.file, points=cloud.repeated))
    return said


def _unit_by_radius(
    cloud: CloudReport, nominal: NominalPlane | NominalSphere | None, mm_per_unit: float
) -> Unit | None:
    """The other unit in which a sphere has its certified radius, if there is one."""
    if not isinstance(nominal, NominalSphere) or cloud.radius_mm is None:
        return None
    for other, mm in MM.items():
        off = cloud.radius_mm * mm / mm_per_unit / nominal.radius_mm - 1
        if mm != mm_per_unit and abs(off) < SAME_RADIUS:
            return other
    return None


def _find_implausible(shape: Shape, cloud: CloudReport, read: Cloud) -> list[Text]:
    """Whether a cloud is of a size or a shape that it can hardly have."""
    finite = read.points_mm[np.isfinite(read.points_mm).all(axis=1)]
    between = np.percentile(finite, [FEW, 100 - FEW], axis=0)
    size_mm = float(np.linalg.norm(between[1] - between[0]))
    found: list[Text] = []
    if not SMALLEST_MM <= size_mm <= LARGEST_MM:
        size = quantity(size_mm, "mm", 0 if size_mm > LARGEST_MM else 3)
        mm = read.mm_per_unit
        unit = next((name for name in MM if MM[name] == mm), f"{mm:g} mm")
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
    read: Cloud,
    nominal: NominalPlane | NominalSphere | None,
    gauge: GaugeFile | None,
) -> tuple[CloudReport, list[Text]]:
    """One cloud's figures with their uncertainties, and what to know of them."""
    finite, mask = finite_points(read.points_mm, 3 if shape == "plane" else 4, shape)
    frame = None if read.frame is None else as_frames(read.frame[mask])
    if shape == "plane":
        if isinstance(nominal, NominalSphere):
            raise _shape_error("sphere", shape)
        figures = plane_figures(finite, frame, nominal)
    else:
        if isinstance(nominal, NominalPlane):
            raise _shape_error("plane", shape)
        figures = sphere_figures(finite, frame, nominal)
    _refuse_exact(shape, figures, len(finite))
    _refuse_huge(shape, figures)
    findings = _find_weak(path, figures)
    away_um = max((abs(figures.errors.get(name) or 0.0) for name in PLACE_ERRORS), default=0.0)
    if away_um > LARGEST_MM * 1e3:
        distance = quantity(away_um * 1e-6, "m", 0)
        findings.append(message("cloud-in-other-coordinates", file=str(path), distance=distance))
        figures = figures.without(PLACE_ERRORS)
    found = figures.fields()
    budget = _budgets(figures, nominal, gauge)
    budget = {name: one for name, one in budget.items() if found.get(name) is not None}
    fields = {
        "file": str(path),
        "points": len(read.points_mm),
        **asdict(read.left_out),
        **found,
        "expanded_uncertainty": {name: combine_budget(one) for name, one in budget.items()},
        "budget": budget,
    }
    cloud = CloudReport.model_validate(fields)
    return cloud, findings


def _budgets(
    figures: GaugeFigures, nominal: NominalPlane | NominalSphere | None, gauge: GaugeFile | None
) -> dict[str, dict[Source, float]]:
    """The budgets of every figure: what its gauge and the scatter of its points contribute, k =
    1."""
    found: dict[str, dict[Source, float]] = {}
    widths_mm = [figures.width_mm] if figures.width_mm else []
    certified = _gauge_parts(nominal, gauge, widths_mm)
    for name, sd in figures.sd.items():
        known = certified.get(NAMES[name]) if name in NAMES else None
        found[name] = {"points": sd} if known is None else {"gauge": known, "points": sd}
    return found


def _refuse_exact(shape: Shape, figures: GaugeFigures, points: int) -> None:
    """Refuses a shape on which some points lie exactly, and others do not."""
    used = figures.used
    if used > PARAMETERS[shape] and figures.rms_mm < EXACT_MM and used < MOST_EXACT * points:
        raise OperationError(
            "cloud-exact",
            message("cloud-exact", used=used, points=points, shape=shape),
            message("cloud-exact-remedy"),
        )


def _refuse_huge(shape: Shape, figures: GaugeFigures) -> None:
    """Refuses a shape of a size that no report states: it is that of something else."""
    size_mm = max(figures.form_mm, figures.range_mm, figures.radius_mm or 0.0)
    if size_mm > LARGEST_SHAPE_MM:
        raise OperationError(
            "cloud-too-large-for-a-gauge",
            message(
                "cloud-too-large-for-a-gauge", shape=shape, size=quantity(size_mm / 1e3, "m", 0)
            ),
            message("cloud-check-shape-and-unit"),
        )


def _find_weak(path: Path, figures: GaugeFigures) -> list[Text]:
    """Whether the points cover too little of a sphere to determine it well."""
    sd_um = figures.sd.get("radius_mm")
    if figures.cap_rad is None or sd_um is None or figures.cap_rad >= LEAST_CAP_RAD:
        return []
    share = (1 - np.cos(figures.cap_rad)) / 2
    return [
        message(
            "cloud-covers-little",
            file=str(path),
            share=quantity(100 * share, "%", 1),
            uncertainty=uncertainty_quantity(K * sd_um * 1e3, "µm"),
        )
    ]


def _shape_error(found: Shape, wanted: Shape) -> OperationError:
    return OperationError(
        "nominal-of-another-shape",
        message("nominal-is-of", shape=found),
        message("is-to-be-verified", shape=wanted),
        message("give-gauges-own-nominal"),
    )


def _gauge_parts(
    nominal: NominalPlane | NominalSphere | None,
    gauge: GaugeFile | None,
    widths_mm: Sequence[float],
) -> Mapping[FigureName, float]:
    """What the gauge contributes to each figure, k = 1; empty without a nominal."""
    if gauge is None:
        return {}
    steepness = abs(float(nominal.normal[2])) if isinstance(nominal, NominalPlane) else 1.0
    return gauge_test_uncertainty(gauge, widths_mm, max(steepness, 1e-9))


def _spreads(
    clouds: Sequence[CloudReport], certified: Mapping[FigureName, float]
) -> dict[str, SpreadReport]:
    if len(clouds) < 2:
        return {}
    found: dict[str, SpreadReport] = {}
    for name in FIGURES:
        values = [getattr(cloud, name) for cloud in clouds]
        if None not in values:
            figure = NAMES.get(name)
            known = gauge_range_uncertainty(figure, certified) if figure and certified else 0.0
            found[name] = _spread(values, [cloud.budget.get(name, {}) for cloud in clouds], known)
    return found


def _spread(values: Sequence[float], budgets: Sequence[Budget], gauge_range: float) -> SpreadReport:
    over = spread_statistics(values, budgets, gauge_range)
    budget = {name: one.budget for name, one in over.items()} if all(budgets) else {}
    fields: dict[str, object] = {name: one.value for name, one in over.items()}
    fields["expanded_uncertainty"] = {name: combine_budget(one) for name, one in budget.items()}
    return SpreadReport.model_validate({**fields, "budget": budget})
