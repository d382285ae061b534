"""Form of a scanned plane."""

import numpy as np

from app.errors import OperationError
from app.messages.message import message
from app.metrology.performance.plane import least_squares_plane
from app.metrology.performance.value_uncertainty import plane_uncertainty_um
from app.workflows.performance.judge import Measured
from app.workflows.performance.measured_data import MeasuredData

ORIENTATIONS = 2
LEAST_WIDTH_MM = 50.0
NEAR_MM = 2.0
"""Points further than this from the plate are not of it: a gate, by the plate's own place."""
TRIALS = 200


def plane_scan(orientation: int) -> str:
    """The folder of a scan of the plate.

    Example:
        >>> plane_scan(1)
        'plane-1'
    """
    return f"plane-{orientation}"


def measure_plane(data: MeasuredData) -> list[Measured]:
    """The worse of the orientations that were scanned."""
    plate = data.plan.plate
    assert plate is not None, "a plan of this kind has a plate"
    names = [plane_scan(i + 1) for i in range(ORIENTATIONS)]
    scanned = [name for name in names if data.has_scan(name)]
    if not scanned:
        return [Measured("plane-scan", None, problem=message("plate-was-not-scanned"))]
    values, problem = [], ""
    for name in scanned:
        points = _on_plate(data.scan(name).points_mm)
        if _width_mm(points) < LEAST_WIDTH_MM:
            return [
                Measured(
                    "plane-scan",
                    None,
                    problem=message("plate-scan-too-narrow", name=name),
                    data=tuple(scanned),
                )
            ]
        values.append(1e3 * least_squares_plane(points).dispersion_mm)
    return [
        Measured(
            "plane-scan",
            max(values),
            tuple(values),
            plane_uncertainty_um(plate.flatness_um, plate.flatness_sd_um),
            problem,
            tuple(scanned),
        )
    ]


def _on_plate(points_mm: np.ndarray) -> np.ndarray:
    """The points within ``NEAR_MM`` of the plane that holds most of them."""
    rng = np.random.default_rng(0)
    best: np.ndarray | None = None
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
    return np.asarray(points_mm[best])


def _width_mm(points_mm: np.ndarray) -> float:
    """Width of the cloud in its narrower direction."""
    away = points_mm - points_mm.mean(axis=0)
    _, _, axes = np.linalg.svd(away[:: max(1, len(away) // 5000)], full_matrices=False)
    return float(np.ptp(away @ axes[1]))
