"""Form of a scanned plane."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import ConvexHull

from app.errors import OperationError
from app.messages.message import Text, message, quantity
from app.metrology.performance.plane import least_squares_plane
from app.metrology.performance.value_uncertainty import plane_uncertainty_um
from app.metrology.transforms import Floats
from app.workflows.performance.judge import Measured
from app.workflows.performance.measured_data import MeasuredData, thin_points

ORIENTATIONS = 2
LEAST_WIDTH_MM = 50.0
NEAR_MM = 2.0
"""Points within this of the plane that holds most of them tell where the plate is, and how far it
reaches."""
RIM_MM = 1.0
"""Points nearer to the plate's outline do not take part: they may lie on its sides."""
TRIALS = 200
MOST_OUTLINE_POINTS = 20_000


@dataclass(frozen=True)
class PlaneResult:
    """What the scans of a plate gave."""

    measured: tuple[Measured, ...]
    notes: tuple[Text, ...] = ()
    undecided: tuple[Text, ...] = ()
    """Why a value that is stated is not decided."""


def plane_scan(orientation: int) -> str:
    """The folder of a scan of the plate.

    Example:
        >>> plane_scan(1)
        'plane-1'
    """
    return f"plane-{orientation}"


def measure_plane(data: MeasuredData) -> PlaneResult:
    """The worse of the orientations that were scanned, over all points over the plate.

    Raises:
        OperationError: ``points-on-a-line``.
    """
    plate, shell_mm = data.plan.plate, data.plan.gate.shell_mm
    assert plate is not None, "a plan of this kind has a plate"
    names = [plane_scan(i + 1) for i in range(ORIENTATIONS)]
    scanned = tuple(name for name in names if data.has_scan(name))
    if not scanned:
        return _no_value(message("plate-was-not-scanned"))
    values, outside = [], 0
    for name in scanned:
        points = data.scan(name).points_mm
        kept = find_on_plate(points, shell_mm)
        if _width_mm(points[kept]) < LEAST_WIDTH_MM:
            return _no_value(message("plate-scan-too-narrow", name=name), scanned)
        outside += int((~kept).sum())
        values.append(1e3 * least_squares_plane(points[kept]).dispersion_mm)
    uncertainty_um = plane_uncertainty_um(plate.flatness_um, plate.flatness_sd_um)
    measured = Measured("plane-scan", max(values), tuple(values), uncertainty_um, "", scanned)
    gate = message(
        "performance-plane-gate",
        shell=quantity(shell_mm, "mm", 1),
        rim=quantity(RIM_MM, "mm", 1),
        count=outside,
    )
    undecided: tuple[Text, ...] = ()
    if len(scanned) < ORIENTATIONS:
        undecided = (message("plate-in-one-orientation", count=ORIENTATIONS),)
    return PlaneResult((measured,), (gate,), undecided)


def find_on_plate(points_mm: Floats, shell_mm: float) -> NDArray[np.bool_]:
    """Which points (N, 3) belong to the plate: (N,).

    The plane that holds most points gives its place, and those near it its convex outline. All
    points within the outline and ``shell_mm`` of that plane take part, whatever their residual.

    Raises:
        OperationError: ``points-on-a-line``.
    """
    near = _near_plane(points_mm)
    centre = points_mm[near].mean(axis=0)
    some = thin_points(points_mm[near], MOST_OUTLINE_POINTS)
    _, _, axes = np.linalg.svd(some - centre, full_matrices=False)
    across = (points_mm - centre) @ axes.T
    sides = ConvexHull((some - centre) @ axes[:2].T).equations
    within = np.ones(len(points_mm), dtype=np.bool_)
    for a, b, offset in sides:
        within &= a * across[:, 0] + b * across[:, 1] + offset <= -RIM_MM
    return np.asarray(within & (np.abs(across[:, 2]) <= shell_mm))


def _near_plane(points_mm: Floats) -> NDArray[np.bool_]:
    """The points within ``NEAR_MM`` of the plane that holds most of them."""
    rng = np.random.default_rng(0)
    best: NDArray[np.bool_] | None = None
    for three in points_mm[rng.integers(0, len(points_mm), (TRIALS, 3))]:
        normal = np.cross(three[1] - three[0], three[2] - three[0])
        length = float(np.linalg.norm(normal))
        if length < 1.0:
            continue
        near = np.abs((points_mm - three[0]) @ normal / length) <= NEAR_MM
        if best is None or near.sum() > best.sum():
            best = near
    if best is None:
        raise OperationError(
            "points-on-a-line", message("points-lie-one-line"), message("they-fix-no-plane")
        )
    return best


def _width_mm(points_mm: Floats) -> float:
    """Width of the cloud in its narrower direction."""
    if len(points_mm) < 3:
        return 0.0
    away = points_mm - points_mm.mean(axis=0)
    _, _, axes = np.linalg.svd(thin_points(away, MOST_OUTLINE_POINTS), full_matrices=False)
    return float(np.ptp(away @ axes[1]))


def _no_value(problem: Text, scanned: tuple[str, ...] = ()) -> PlaneResult:
    return PlaneResult((Measured("plane-scan", None, problem=problem, data=scanned),))
