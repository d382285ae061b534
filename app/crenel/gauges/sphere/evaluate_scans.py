"""The scans of the one-sphere test: its figures over all points within the gate."""

from collections.abc import Sequence

import numpy as np

from crenel.errors import OperationError
from crenel.gauges.judgement.document import PatchPart
from crenel.gauges.judgement.evaluate_measured_data import MeasuredData, ScanCloud, thin_points
from crenel.gauges.judgement.maths_value_uncertainty import SphereDrift, form_effect_um
from crenel.gauges.plan.document import ARTICULATIONS, SpherePart, sphere_scan
from crenel.gauges.plan.document_symbols import Quantity
from crenel.gauges.plan.maths_gate import gate_sphere
from crenel.gauges.sphere.evaluate_articulations import (
    articulation_notes,
    articulations_alike,
)
from crenel.gauges.sphere.evaluate_position import PositionResult, sphere_certificate
from crenel.gauges.sphere.maths_articulation import articulation_directions, mean_direction
from crenel.gauges.sphere.maths_location import location_error_mm
from crenel.gauges.sphere.maths_pattern import (
    Patches,
    pattern_directions,
    representative_points,
    scan_patches,
)
from crenel.messages.message import Text, message
from crenel.metrology.fitting.reference_sphere import (
    dispersion_mm,
    free_dispersion_mm,
    least_squares_sphere,
    sphere_centre,
)
from crenel.metrology.transforms import Floats

LEAST_POINTS, LEAST_FRAMES = 20, 2
"""The fewest points and frames of a patch that counts as covered."""
LEAST_PATCHES = 6
"""The fewest patches of an articulation, which sees only a part of the sphere."""
SCANS_TAKE = 0.4
"""The share of the time of a test from the first scan to the last."""
OUTLIER_SD = 3.5
MOST_FREE = 20_000
"""Points for the dispersion about a free centre, which costs hundreds of passes."""


def scans_of(data: MeasuredData, position: int) -> list[str]:
    """The names of the scans that there are of a position of the sphere."""
    names = [sphere_scan(position, i + 1) for i in range(ARTICULATIONS)]
    return [name for name in names if data.has_scan(name)]


def articulations_not_scanned(count: int) -> Text:
    """Said where only some articulations were scanned."""
    return message("articulations-not-scanned", count=count, needed=ARTICULATIONS)


def measure_scans(
    data: MeasuredData,
    sphere: SpherePart,
    position: int,
    result: PositionResult,
    touched_mm: Floats | None,
) -> tuple[Floats, Floats] | None:
    """Figures of the scans; the centre of all points, and the representative points."""
    of_all: tuple[Quantity, ...] = ("size-scan", "size-all-scan", "form-scan", "dispersion-scan")
    both: tuple[Quantity, ...] = ("size-both", "form-both", "location-both")
    names = scans_of(data, position)
    if not names:
        result.refuse(message("sphere-was-not-scanned"), *of_all, "location-scan", *both)
        return None
    clouds = [_gate_scan(data, sphere, name, touched_mm) for name in names]
    inside = [cloud for cloud, _ in clouds]
    points = np.concatenate([cloud.points_mm for cloud in inside])
    counts = [sum(len(cloud.points_mm) for cloud in inside), sum(out for _, out in clouds)]
    result.details |= {"points": counts[0], "points_outside": counts[1]}
    _measure_location(data, sphere, names, inside, result)
    try:
        found = least_squares_sphere(points)
    except OperationError as error:
        result.refuse(error.text, *of_all, *both)
        return None
    directions = pattern_directions(np.array(data.plan.gate.pole))
    patches = scan_patches(points, _number_frames(inside), found.centre_mm, directions)
    result.details["scanned_centre_mm"] = found.centre_mm.tolist()
    result.details["patches"] = _patch_parts(patches)
    missing = _missing_patches(patches)
    if missing:
        text = message("patches-not-covered", patches=", ".join(map(str, missing)))
        result.refuse(text, *of_all, *both)
        return None
    distances = np.linalg.norm(points - found.centre_mm, axis=1)
    result.note("size-all-scan", found.diameter_mm - sphere.diameter_mm, *names)
    result.note("dispersion-scan", dispersion_mm(distances), *names)
    result.outlier_share = _outlier_share(distances)
    free_um = 1e3 * free_dispersion_mm(thin_points(points, MOST_FREE), found.centre_mm)
    result.details["free_dispersion_um"] = free_um
    represented = representative_points(patches, found.centre_mm, directions)
    of_25 = least_squares_sphere(represented)
    result.note("size-scan", of_25.diameter_mm - sphere.diameter_mm, *names)
    result.note("form-scan", of_25.form_mm, *names)
    certificate = sphere_certificate(sphere)
    drift = SphereDrift(result.moved_mm, _times_of_scans(inside))
    result.form_effects_um |= {
        "form-scan": form_effect_um(certificate, represented, of_25.centre_mm, np.ptp),
        "dispersion-scan": form_effect_um(
            certificate, points, found.centre_mm, dispersion_mm, drift
        ),
    }
    off_mm = np.linalg.norm(represented - of_25.centre_mm, axis=1) - of_25.diameter_mm / 2
    result.details["patches"] = _patch_parts(patches, 1e3 * off_mm)
    return of_25.centre_mm, represented


def _gate_scan(
    data: MeasuredData, sphere: SpherePart, name: str, touched_mm: Floats | None
) -> tuple[ScanCloud, int]:
    """The points of the sphere in one scan, and how many others there were."""
    cloud, gate = data.scan(name), data.plan.gate
    start = np.median(cloud.points_mm, axis=0) if touched_mm is None else touched_mm
    found = gate_sphere(
        cloud.points_mm, cloud.views, sphere.diameter_mm, np.array(gate.pole), start, gate.gate
    )
    kept = ScanCloud(
        cloud.points_mm[found.inside],
        cloud.frame[found.inside],
        cloud.views[found.inside],
        cloud.R_arm_sensor,
    )
    return kept, int((~found.inside).sum())


def _measure_location(
    data: MeasuredData,
    sphere: SpherePart,
    names: Sequence[str],
    clouds: Sequence[ScanCloud],
    result: PositionResult,
) -> None:
    """Location over the articulations, each by the representative points of what it saw."""
    if len(names) < ARTICULATIONS:
        missing = articulations_not_scanned(len(names))
        result.refuse(missing, "location-scan")
        return
    free, fixed = [], []
    directions = pattern_directions(np.array(data.plan.gate.pole))
    for name, cloud in zip(names, clouds, strict=True):
        try:
            whole = least_squares_sphere(cloud.points_mm)
            patches = scan_patches(cloud.points_mm, cloud.frame, whole.centre_mm, directions)
            seen = (patches.points >= LEAST_POINTS) & (patches.frames >= LEAST_FRAMES)
            if seen.sum() < LEAST_PATCHES:
                raise OperationError(
                    "cloud-too-small",
                    message("scan-covers-patches", name=name, count=int(seen.sum())),
                )
            chosen = Patches(np.where(seen, patches.points, 0), patches.frames, patches.radii_mm)
            points = representative_points(chosen, whole.centre_mm, directions)
            free.append(least_squares_sphere(points).centre_mm)
            fixed.append(sphere_centre(points, sphere.diameter_mm))
        except OperationError as error:
            result.refuse(error.text, "location-scan")
            return
    centres = np.array(free)
    views = np.array([mean_direction(cloud.views) for cloud in clouds])
    wanted = directions_to_hold(data, centres)
    result.notes += articulation_notes(views, wanted, "scan", result.position)
    if alike := articulations_alike(views):
        result.refuse(alike, "location-scan")
    else:
        result.note("location-scan", location_error_mm(centres), *names)
    result.details |= {
        "view_directions": views.tolist(),
        "scan_centres_mm": centres.tolist(),
        "fixed_centres_mm": np.array(fixed).tolist(),
        "location_fixed_um": 1e3 * location_error_mm(np.array(fixed)),
    }
    result.centres_mm = np.array(fixed)
    result.R_arm_sensor = np.array([cloud.R_arm_sensor for cloud in clouds])


def directions_to_hold(data: MeasuredData, centres_mm: Floats) -> Floats:
    """(5, 3) of the articulations about the centre of a sphere, the arm's base at the origin."""
    return articulation_directions(np.array(data.plan.gate.pole), -centres_mm.mean(axis=0))


def _patch_parts(patches: Patches, off_um: Floats | None = None) -> list[PatchPart]:
    deviations = [None] * len(patches.points) if off_um is None else off_um.tolist()
    return [
        PatchPart(points=int(p), frames=int(f), deviation_um=off)
        for p, f, off in zip(patches.points, patches.frames, deviations, strict=True)
    ]


def _missing_patches(patches: Patches) -> list[int]:
    short = (patches.points < LEAST_POINTS) | (patches.frames < LEAST_FRAMES)
    return [int(i) + 1 for i in np.flatnonzero(short)]


def _number_frames(clouds: Sequence[ScanCloud]) -> np.ndarray:
    """Frame numbers over all scans, none twice."""
    numbers, first = [], 0
    for cloud in clouds:
        numbers.append(cloud.frame + first)
        first += int(cloud.frame.max(initial=0)) + 1
    return np.concatenate(numbers)


def _outlier_share(distances_mm: Floats) -> float:
    """The share of points further from the median than noise ever is, for a normal distribution
    0.05 %."""
    off = np.abs(distances_mm - np.median(distances_mm))
    return float(np.mean(off > OUTLIER_SD * 1.4826 * np.median(off)))


def _times_of_scans(clouds: Sequence[ScanCloud]) -> Floats:
    """When each point was taken, of a test that takes 1."""
    times = np.linspace(0.0, SCANS_TAKE, len(clouds))
    return np.repeat(times, [len(cloud.points_mm) for cloud in clouds])
