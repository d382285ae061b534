"""Form of a scanned plane."""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import ConvexHull

from crenel.errors import OperationError
from crenel.gauges.judgement.evaluate import Measured, refuse
from crenel.gauges.judgement.evaluate_kind import Evaluated, Evaluation
from crenel.gauges.judgement.evaluate_measured_data import MeasuredData, ScanCloud, thin_points
from crenel.gauges.judgement.maths_value_uncertainty import PlateCertificate, plane_effect_um
from crenel.gauges.plan.document import ORIENTATIONS, PerformancePlan, PlatePart, plane_scan
from crenel.gauges.plan.evaluate_artefacts import LEAST_WIDTH_MM
from crenel.gauges.plane.maths import least_squares_plane
from crenel.messages.limits import beside_limit
from crenel.messages.message import Text, message, quantity
from crenel.metrology.fitting.reference_sphere import dispersion_mm
from crenel.metrology.transforms import Floats, vector_from_rotation

LEAST_TURN_DEG = 30.0
"""The least turn of the sensor between the two orientations; a choice of this program."""
LEAST_POINTS = 1000
NEAR_MM = 2.0
"""Points within this of the plane that holds most of them tell where the plate is, and how far it
reaches."""
RIM_MM = 1.0
"""Points nearer to the plate's outline do not take part: they may lie on its sides."""
TRIALS = 200
MOST_OUTLINE_POINTS = 20_000


class PlaneEvaluation(Evaluation):
    """The evaluation of the test on a plate."""

    has_size = False

    def artefact(self, plan: PerformancePlan) -> PlatePart | None:
        return plan.plate

    def notes(self, plan: PerformancePlan, filtered: bool) -> list[Text]:
        return [message("performance-plane-is-addition")]

    def measure(self, data: MeasuredData, problems: list[Text]) -> Evaluated:
        found = measure_plane(data)
        return replace(found, measured=tuple(refuse(one, problems) for one in found.measured))


@dataclass(frozen=True, eq=False)
class ScannedPlate:
    """What one scan shows of the plate."""

    dispersion_um: float
    """Width of the narrowest slab along its plane that holds 95 % of all points."""
    width_mm: float
    """The width of the scanned part, in its narrower direction."""
    points_mm: Floats  # (N, 3) of the plate, arm frame
    outside: int
    """Points that are not the plate's."""
    R_arm_sensor: Floats  # (3, 3), as of ``ScanCloud``


def measure_plate_scan(cloud: ScanCloud, shell_mm: float) -> ScannedPlate:
    """Measures a scan of the plate by all points over it.

    Raises:
        OperationError: it shows too little of a plate.
    """
    points = cloud.points_mm
    if len(points) < LEAST_POINTS:
        raise OperationError(
            "cloud-too-small",
            message("plate-scan-too-few-points", count=len(points), least=LEAST_POINTS),
            remedy=message("scan-plate-in-strips"),
        )
    kept = find_on_plate(points, shell_mm)
    width_mm = _width_mm(points[kept])
    if width_mm < LEAST_WIDTH_MM:
        width, least = beside_limit(width_mm, LEAST_WIDTH_MM, "mm")
        raise OperationError(
            "cloud-too-small",
            message("plate-scan-too-narrow", width=width, least=least),
            remedy=message("scan-plate-in-strips"),
        )
    return ScannedPlate(
        1e3 * least_squares_plane(points[kept]).dispersion_mm,
        width_mm,
        points[kept],
        int((~kept).sum()),
        cloud.R_arm_sensor,
    )


def turn_between_deg(first: Floats, second: Floats) -> float:
    """By how much the sensor was turned from one scan to the other, of its orientations (3, 3)."""
    between = first.T @ second
    return float(np.degrees(np.linalg.norm(vector_from_rotation(between))))


def measure_plane(data: MeasuredData) -> Evaluated:
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
    if len(scanned) < ORIENTATIONS:
        return _no_value(message("plate-not-in-enough-orientations", count=ORIENTATIONS), scanned)
    plates: list[ScannedPlate] = []
    for name in scanned:
        try:
            plates.append(measure_plate_scan(data.scan(name), shell_mm))
        except OperationError as error:
            if error.code != "cloud-too-small":
                raise
            return _no_value(message("titled-text", title=name, text=error.what), scanned)
    values = tuple(one.dispersion_um for one in plates)
    outside = sum(one.outside for one in plates)
    worst = max(plates, key=lambda one: one.dispersion_um)
    certificate = PlateCertificate(plate.flatness_um, plate.flatness_sd_um)
    sd_um = plane_effect_um(certificate, worst.points_mm, dispersion_mm)
    measured = Measured("plane-scan", worst.dispersion_um, values, sd_um, "", scanned)
    gate = message(
        "performance-plane-gate",
        shell=quantity(shell_mm, "mm", 1),
        rim=quantity(RIM_MM, "mm", 1),
        count=outside,
    )
    undecided = tuple(_why_undecided(plates))
    return Evaluated((measured,), notes=(gate,), undecided=undecided)


def _why_undecided(plates: list[ScannedPlate]) -> Iterator[Text]:
    """Why a value of these scans is stated and not decided."""
    turn_deg = turn_between_deg(*(one.R_arm_sensor for one in plates))
    if turn_deg < LEAST_TURN_DEG:
        yield orientations_alike(turn_deg)


def orientations_alike(turn_deg: float) -> Text:
    """Said of two scans between which the sensor was turned too little."""
    turn, least = beside_limit(turn_deg, LEAST_TURN_DEG, "°")
    return message("plate-orientations-alike", turn=turn, least=least)


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


def _no_value(problem: Text, scanned: tuple[str, ...] = ()) -> Evaluated:
    return Evaluated((Measured("plane-scan", None, problem=problem, data=scanned),))
