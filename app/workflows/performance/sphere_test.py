"""The one-sphere test: size, form, dispersion and location of one sphere, by touch and by scan."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from app.errors import OperationError
from app.formats.performance.plan import (
    ARTICULATIONS,
    LOCATION_TOUCHES,
    PATTERN_TOUCHES,
    SpherePart,
    sphere_feature,
    sphere_scan,
)
from app.formats.performance.results import PatchPart, SphereMeasurement
from app.formats.performance.symbols import Quantity
from app.messages.message import Text, message
from app.metrology.arm.kinematics import tip_of
from app.metrology.performance.articulation import articulation_directions, mean_direction
from app.metrology.performance.gate import gate_sphere
from app.metrology.performance.location import location_error_mm
from app.metrology.performance.pattern import (
    RIM_DEG,
    Patches,
    assign_touches,
    pattern_directions,
    representative_points,
    scan_patches,
)
from app.metrology.performance.sphere import (
    dispersion_mm,
    free_dispersion_mm,
    least_squares_sphere,
    sphere_centre,
)
from app.metrology.performance.value_uncertainty import SphereDrift, form_effect_um
from app.metrology.transforms import Floats
from app.workflows.performance.articulation_checks import articulation_notes, articulations_alike
from app.workflows.performance.measured_data import MeasuredData, ScanCloud
from app.workflows.performance.sphere_uncertainty import sphere_certificate

LEAST_POINTS, LEAST_FRAMES = 20, 2
"""Of a patch that counts as covered."""
SCANS_TAKE = 0.4
"""Of the time of a test, from the first scan to the last."""
LEAST_PATCHES = 6
"""Of an articulation, which sees only a part of the sphere."""


@dataclass
class PositionResult:
    """What one position of the sphere gave."""

    position: int
    values_mm: dict[Quantity, float] = field(default_factory=dict)
    problems: dict[Quantity, Text] = field(default_factory=dict)
    data: dict[Quantity, tuple[str, ...]] = field(default_factory=dict)
    details: dict[str, object] = field(default_factory=dict)
    """Fields of ``SphereMeasurement``."""
    centres_mm: Floats | None = None
    """(A, 3) of the articulations by scan."""
    R_arm_sensor: Floats | None = None
    """(A, 3, 3) of the sensor in them."""
    notes: list[Text] = field(default_factory=list)
    """Articulations that were not held as wanted."""
    form_effects_um: dict[Quantity, float] = field(default_factory=dict)
    """What the form of the sphere makes of forms and dispersion, k = 1."""
    moved_mm: Floats = field(default_factory=lambda: np.zeros(3))
    """(3,) of the sphere, between the first touches and the last; 0 if not touched again."""

    @property
    def moved_um(self) -> float:
        return 1e3 * float(np.linalg.norm(self.moved_mm))

    def measurement(self) -> SphereMeasurement:
        return SphereMeasurement.model_validate({"position": self.position, **self.details})

    def note(self, quantity: Quantity, value_mm: float, *data: str) -> None:
        self.values_mm[quantity], self.data[quantity] = value_mm, data

    def refuse(self, problem: Text, *quantities: Quantity) -> None:
        for one in quantities:
            self.problems.setdefault(one, problem)


def measure_position(data: MeasuredData, sphere: SpherePart, position: int) -> PositionResult:
    """All figures of one position of the sphere, over all points within the gate."""
    result = PositionResult(position)
    touched = _measure_pattern(data, sphere, position, result)
    _measure_tactile_location(data, position, result)
    _measure_drift(data, position, result)
    if touched is None and not _scans(data, position):
        return result
    centre, compensated = (None, None) if touched is None else touched
    scanned = _measure_scans(data, sphere, position, result, centre)
    if compensated is not None and scanned is not None:
        _measure_both(sphere, result, compensated, *scanned)
    return result


def bring_sizes_to_20(result: PositionResult, sphere: SpherePart, off_c: float) -> None:
    """Errors of size with the sphere at 20 °C.

    Args:
        off_c: its temperature in the test minus 20 °C.
    """
    growth = 1 + sphere.expansion_per_c * off_c
    for of, error_mm in result.values_mm.items():
        if of.startswith("size"):
            at_20_mm = (error_mm + sphere.diameter_mm) / growth
            result.values_mm[of] = at_20_mm - sphere.diameter_mm


def _measure_pattern(
    data: MeasuredData, sphere: SpherePart, position: int, result: PositionResult
) -> tuple[Floats, Floats] | None:
    """Size and form of the 25 touches; the sphere's centre, and the compensated contact points."""
    name = sphere_feature(position, "pattern")
    tips = data.tips_mm.get(name, np.zeros((0, 3)))
    if len(tips) < PATTERN_TOUCHES:
        text = message("touches-missing-of-pattern", count=len(tips), needed=PATTERN_TOUCHES)
        result.refuse(text, "size-touch", "form-touch", "size-both", "form-both", "location-both")
        return None
    found = least_squares_sphere(tips)
    tip_mm = tip_of(data.arm).diameter_mm
    result.note("size-touch", found.diameter_mm - tip_mm - sphere.diameter_mm, name)
    result.note("form-touch", found.form_mm, name)
    certificate = sphere_certificate(sphere)
    result.form_effects_um["form-touch"] = form_effect_um(
        certificate, tips, found.centre_mm, np.ptp
    )
    result.details["touched_centre_mm"] = found.centre_mm.tolist()
    inward = tips - found.centre_mm
    distances = np.linalg.norm(inward, axis=1)
    inward /= distances[:, None]
    result.details["touch_deviations_um"] = _by_place(
        tips, found.centre_mm, 1e3 * (distances - found.diameter_mm / 2), data.plan.gate.pole
    )
    return found.centre_mm, tips - inward * tip_mm / 2


def _by_place(
    tips_mm: Floats, centre_mm: Floats, off_um: Floats, pole: Sequence[float]
) -> list[float | None]:
    """The deviations of touches by their places in the pattern; None where there was none."""
    directions = pattern_directions(np.array(pole), RIM_DEG)
    places = assign_touches(tips_mm, centre_mm, directions)
    found: list[float | None] = [None] * len(directions)
    for place, off in zip(places.tolist(), off_um.tolist(), strict=True):
        if place >= 0:
            found[place] = off
    return found


def _patch_parts(patches: Patches, off_um: Floats | None = None) -> list[PatchPart]:
    deviations = [None] * len(patches.points) if off_um is None else off_um.tolist()
    return [
        PatchPart(points=int(p), frames=int(f), deviation_um=off)
        for p, f, off in zip(patches.points, patches.frames, deviations, strict=True)
    ]


def _measure_tactile_location(data: MeasuredData, position: int, result: PositionResult) -> None:
    names = [sphere_feature(position, "location", i + 1) for i in range(ARTICULATIONS)]
    groups = [data.tips_mm.get(name, np.zeros((0, 3))) for name in names]
    short = [i + 1 for i, tips in enumerate(groups) if len(tips) < LOCATION_TOUCHES]
    if short:
        text = message("articulations-without-touches", names=", ".join(map(str, short)))
        result.refuse(text, "location-touch")
        return
    try:
        centres = np.array([least_squares_sphere(tips).centre_mm for tips in groups])
    except OperationError as error:
        result.refuse(error.text, "location-touch")
        return
    result.details["tactile_centres_mm"] = centres.tolist()
    directions = np.array([mean_direction(data.styli[name]) for name in names])
    result.details["stylus_directions"] = directions.tolist()
    wanted = _directions_to_hold(data, centres)
    result.notes += articulation_notes(directions, wanted, "touch", position)
    if alike := articulations_alike(directions):
        result.refuse(alike, "location-touch")
        return
    result.note("location-touch", location_error_mm(centres), *names)


def _measure_drift(data: MeasuredData, position: int, result: PositionResult) -> None:
    """How far the sphere moved from the first touches to the last, with the diameter of the
    first: a worn tip does not look like a movement."""
    first = data.tips_mm.get(sphere_feature(position, "pattern"))
    last = data.tips_mm.get(sphere_feature(position, "end"))
    if first is None or last is None or len(first) < PATTERN_TOUCHES or len(last) < 4:
        return
    found = least_squares_sphere(first)
    begin, end = found.centre_mm, sphere_centre(last, found.diameter_mm)
    result.details["end_centre_mm"] = end.tolist()
    result.moved_mm = end - begin
    result.details["moved_um"] = result.moved_um


def _scans(data: MeasuredData, position: int) -> list[str]:
    names = [sphere_scan(position, i + 1) for i in range(ARTICULATIONS)]
    return [name for name in names if data.has_scan(name)]


def _measure_scans(
    data: MeasuredData,
    sphere: SpherePart,
    position: int,
    result: PositionResult,
    touched_mm: Floats | None,
) -> tuple[Floats, Floats] | None:
    """Figures of the scans; the centre of all points, and the representative points."""
    of_all: tuple[Quantity, ...] = ("size-scan", "size-all-scan", "form-scan", "dispersion-scan")
    both: tuple[Quantity, ...] = ("size-both", "form-both", "location-both")
    names = _scans(data, position)
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
    free_um = 1e3 * free_dispersion_mm(_thin_points(points), found.centre_mm)
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
        missing = message("articulations-not-scanned", count=len(names), needed=ARTICULATIONS)
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
    wanted = _directions_to_hold(data, centres)
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


def _directions_to_hold(data: MeasuredData, centres_mm: Floats) -> Floats:
    """(5, 3) of the articulations about the centre of a sphere, the arm's base at the origin."""
    return articulation_directions(np.array(data.plan.gate.pole), -centres_mm.mean(axis=0))


def _measure_both(
    sphere: SpherePart,
    result: PositionResult,
    touched: Floats,
    scanned_centre: Floats,
    scanned: Floats,
) -> None:
    """Touch against scan: one sphere through both, and the distance of their centres."""
    both = least_squares_sphere(np.concatenate([touched, scanned]))
    data = (*result.data["size-touch"], *result.data["size-scan"])
    result.note("size-both", both.diameter_mm - sphere.diameter_mm, *data)
    result.note("form-both", both.form_mm, *data)
    centres = np.array([least_squares_sphere(touched).centre_mm, scanned_centre])
    result.note("location-both", location_error_mm(centres), *data)


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


def _times_of_scans(clouds: Sequence[ScanCloud]) -> Floats:
    """When each point was taken, of a test that takes 1."""
    times = np.linspace(0.0, SCANS_TAKE, len(clouds))
    return np.repeat(times, [len(cloud.points_mm) for cloud in clouds])


MOST_FREE = 20_000


def _thin_points(points: Floats) -> Floats:
    """Points enough for the dispersion about a free centre, which costs hundreds of passes."""
    return points[:: max(1, len(points) // MOST_FREE)]


def worst(results: Sequence[PositionResult], of: Quantity) -> float | None:
    """The value of larger magnitude in µm; None unless every position has one."""
    values = [result.values_mm.get(of) for result in results]
    known = [value for value in values if value is not None]
    return 1e3 * max(known, key=abs) if len(known) == len(values) and known else None


def largest_form_effect(results: Sequence[PositionResult], of: Quantity) -> float | None:
    """What the sphere's form makes of a quantity in µm, k = 1; None if that is unknown."""
    return max(
        (one.form_effects_um[of] for one in results if of in one.form_effects_um), default=None
    )


def problems_of(results: Sequence[PositionResult], of: Quantity) -> Text:
    """Why a quantity cannot be stated; empty if it can."""
    found: Mapping[int, Text] = {
        one.position: one.problems[of] for one in results if of in one.problems
    }
    if not found:
        return ""
    position, text = next(iter(found.items()))
    return text if len(results) == 1 else message("at-position", position=position, text=text)
