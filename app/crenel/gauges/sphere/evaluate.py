"""The one-sphere test: size, form, dispersion and location of one sphere, by touch and by scan."""

from collections.abc import Sequence

import numpy as np

from crenel.errors import OperationError
from crenel.gauges.judgement.evaluate_loose_artefacts import loose_test_sphere_problems
from crenel.gauges.judgement.evaluate_measured_data import MeasuredData
from crenel.gauges.judgement.maths_value_uncertainty import form_effect_um
from crenel.gauges.plan.document import (
    ARTICULATIONS,
    LOCATION_TOUCHES,
    PATTERN_TOUCHES,
    SpherePart,
    location_features,
    sphere_feature,
)
from crenel.gauges.plan.document_symbols import Quantity
from crenel.gauges.sphere.evaluate_articulations import (
    articulation_notes,
    articulations_alike,
)
from crenel.gauges.sphere.evaluate_position import PositionResult, sphere_certificate
from crenel.gauges.sphere.evaluate_scans import (
    articulations_not_scanned,
    directions_to_hold,
    measure_scans,
    scans_of,
)
from crenel.gauges.sphere.maths_articulation import mean_direction
from crenel.gauges.sphere.maths_location import location_error_mm
from crenel.gauges.sphere.maths_pattern import (
    RIM_DEG,
    assign_touches,
    find_missed_places,
    pattern_directions,
)
from crenel.messages.message import Text, message
from crenel.metrology.arm.kinematics import tip_of
from crenel.metrology.fitting.reference_sphere import least_squares_sphere, sphere_centre
from crenel.metrology.transforms import Floats

_OF_PATTERN: tuple[Quantity, ...] = (
    "size-touch",
    "form-touch",
    "size-both",
    "form-both",
    "location-both",
)


def measure_position(data: MeasuredData, sphere: SpherePart, position: int) -> PositionResult:
    """All figures of one position of the sphere, over all points within the gate."""
    result = PositionResult(position)
    touched = _measure_pattern(data, sphere, position, result)
    _measure_tactile_location(data, position, result)
    _measure_drift(data, position, result)
    if touched is None and not scans_of(data, position):
        return result
    centre, compensated = (None, None) if touched is None else touched
    scanned = measure_scans(data, sphere, position, result, centre)
    if compensated is not None and scanned is not None:
        _measure_both(sphere, result, compensated, *scanned)
    return result


def find_unfinished(data: MeasuredData, results: Sequence[PositionResult]) -> list[Text]:
    """What a test that was stopped lacks: touches of the pattern, scans after the first one, or the
    touches at the end."""
    found: list[Text] = []
    for result in results:
        pattern = data.tips_mm.get(sphere_feature(result.position, "pattern"), ())
        if len(pattern) < PATTERN_TOUCHES:
            found.append(_pattern_is_short(len(pattern)))
        elif "moved_um" not in result.details:
            found.append(message("sphere-not-touched-again"))
        scans = len(scans_of(data, result.position))
        if 0 < scans < ARTICULATIONS:
            found.append(articulations_not_scanned(scans))
    return found


def find_loose(data: MeasuredData, result: PositionResult) -> list[Text]:
    """Where a sphere that was touched and scanned gives way while it is touched."""
    pattern = data.tips_mm.get(sphere_feature(result.position, "pattern"))
    dispersion_mm = result.values_mm.get("dispersion-scan")
    if pattern is None or len(pattern) < PATTERN_TOUCHES or dispersion_mm is None:
        return []
    features = {
        "pattern": [sphere_feature(result.position, "pattern")],
        "location": location_features(result.position),
        "end": [sphere_feature(result.position, "end")],
    }
    touches = {
        part: [data.tips_mm[name] for name in names if name in data.tips_mm]
        for part, names in features.items()
    }
    reach_mm = least_squares_sphere(pattern).diameter_mm / 2
    return loose_test_sphere_problems(touches, reach_mm, 1e3 * dispersion_mm, result.position)


def _pattern_is_short(count: int) -> Text:
    return message("touches-missing-of-pattern", count=count, needed=PATTERN_TOUCHES)


def _measure_pattern(
    data: MeasuredData, sphere: SpherePart, position: int, result: PositionResult
) -> tuple[Floats, Floats] | None:
    """Size and form of the 25 touches; the sphere's centre, and the compensated contact points."""
    name = sphere_feature(position, "pattern")
    tips = data.tips_mm.get(name, np.zeros((0, 3)))
    if len(tips) < PATTERN_TOUCHES:
        result.refuse(_pattern_is_short(len(tips)), *_OF_PATTERN)
        return None
    found = least_squares_sphere(tips)
    directions = pattern_directions(np.array(data.plan.gate.pole), RIM_DEG)
    if missed := find_missed_places(tips, found.centre_mm, directions):
        text = message("touches-miss-places", places=", ".join(str(i + 1) for i in missed))
        result.refuse(text, *_OF_PATTERN)
        return None
    tip_mm = tip_of(data.arm).diameter_mm
    result.note("size-touch", found.diameter_mm - tip_mm - sphere.diameter_mm, name)
    result.note("form-touch", found.form_mm, name)
    result.touch_sd_mm = found.scatter_mm
    certificate = sphere_certificate(sphere)
    result.form_effects_um["form-touch"] = form_effect_um(
        certificate, tips, found.centre_mm, np.ptp
    )
    result.details["touched_centre_mm"] = found.centre_mm.tolist()
    inward = tips - found.centre_mm
    distances = np.linalg.norm(inward, axis=1)
    inward /= distances[:, None]
    result.details["touch_deviations_um"] = _by_place(
        tips, found.centre_mm, 1e3 * (distances - found.diameter_mm / 2), directions
    )
    return found.centre_mm, tips - inward * tip_mm / 2


def _by_place(
    tips_mm: Floats, centre_mm: Floats, off_um: Floats, directions: Floats
) -> list[float | None]:
    """The deviations of touches by their places in the pattern; None where there was none."""
    places = assign_touches(tips_mm, centre_mm, directions)
    found: list[float | None] = [None] * len(directions)
    for place, off in zip(places.tolist(), off_um.tolist(), strict=True):
        if place >= 0:
            found[place] = off
    return found


def _measure_tactile_location(data: MeasuredData, position: int, result: PositionResult) -> None:
    names = location_features(position)
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
    result.tactile_sd_mm = float(np.sqrt(np.mean(np.var(centres, axis=0, ddof=1))))
    directions = np.array([mean_direction(data.styli[name]) for name in names])
    result.details["stylus_directions"] = directions.tolist()
    wanted = directions_to_hold(data, centres)
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
