"""The contact tests of ASME B89.4.22: effective diameter, articulation in seats, volume."""

import numpy as np

from app.messages.message import Text, message
from app.metrology.arm.kinematics import tip_of
from app.metrology.performance.contact_tests import (
    PLACEMENTS,
    SEAT_POINTS,
    SEATS,
    SPHERE_POINTS,
    SPHERES,
    effective_diameter,
    seat_articulation,
    volumetric_length,
)
from app.metrology.performance.lengths import length_of_bar_mm
from app.metrology.performance.sphere import sphere_centre
from app.metrology.performance.value_uncertainty import SphereCertificate, size_uncertainty_um
from app.workflows.performance.judge import Measured
from app.workflows.performance.measured_data import MeasuredData

LEAST_BAR_TOUCHES = 4


def diameter_feature(number: int) -> str:
    """Touches of one measurement of the master sphere: ``d1``."""
    return f"d{number}"


def seat_feature(number: int) -> str:
    """Touches in one seat: ``s1`` near, ``s2`` in the middle, ``s3`` far."""
    return f"s{number}"


def bar_feature(placement: int, end: int) -> str:
    """Touches on an end (0 or 1) of the bar in one placement: ``b1-0``."""
    return f"b{placement}-{end}"


def contact_features() -> list[str]:
    """All groups of touches of the contact test."""
    return [
        *(diameter_feature(i + 1) for i in range(SPHERES)),
        *(seat_feature(i + 1) for i in range(SEATS)),
        *(bar_feature(i + 1, end) for i in range(PLACEMENTS) for end in (0, 1)),
    ]


def measure_contact_test(data: MeasuredData) -> list[Measured]:
    """Every figure that the touches allow."""
    return [*_measure_diameter(data), *_measure_seats(data), *_measure_volume(data)]


def _measure_diameter(data: MeasuredData) -> list[Measured]:
    sphere = data.plan.sphere
    names = [diameter_feature(i + 1) for i in range(SPHERES)]
    groups = [data.tips_mm.get(name, np.zeros((0, 3))) for name in names]
    if sphere is None or any(len(tips) < SPHERE_POINTS for tips in groups):
        missing = message("master-sphere-not-measured", count=SPHERES, points=SPHERE_POINTS)
        return [Measured("effective-diameter", None, problem=missing)]
    found = effective_diameter(groups, tip_of(data.arm).diameter_mm, sphere.diameter_mm)
    certificate = SphereCertificate(sphere.diameter_mm, sphere.diameter_sd_um, sphere.form_um)
    sd_um = size_uncertainty_um(certificate)
    mean, each = found.mean_error_um, found.errors_um
    return [Measured("effective-diameter", mean, each, sd_um, "", tuple(names))]


def _measure_seats(data: MeasuredData) -> list[Measured]:
    names = [seat_feature(i + 1) for i in range(SEATS)]
    groups = [data.tips_mm.get(name, np.zeros((0, 3))) for name in names]
    problem: Text = ""
    if any(len(tips) < SEAT_POINTS for tips in groups):
        problem = message("seats-not-measured", count=SEATS, points=SEAT_POINTS)
        return [
            Measured("articulation-largest", None, problem=problem),
            Measured("articulation-two-s", None, problem=problem),
        ]
    found = [seat_articulation(tips) for tips in groups]
    largest = tuple(one.largest_um for one in found)
    two_s = tuple(one.two_s_um for one in found)
    return [
        Measured("articulation-largest", max(largest), largest, 0.0, "", tuple(names)),
        Measured("articulation-two-s", max(two_s), two_s, 0.0, "", tuple(names)),
    ]


def _measure_volume(data: MeasuredData) -> list[Measured]:
    standard = data.plan.length
    deviations: list[float] = []
    names: list[str] = []
    for placement in range(1, PLACEMENTS + 1):
        ends = [bar_feature(placement, end) for end in (0, 1)]
        groups = [data.tips_mm.get(name, np.zeros((0, 3))) for name in ends]
        if standard is None or any(len(tips) < LEAST_BAR_TOUCHES for tips in groups):
            continue
        diameter = (standard.sphere_diameter_mm or 0.0) + tip_of(data.arm).diameter_mm
        length = length_of_bar_mm(*(sphere_centre(tips, diameter) for tips in groups))
        nearest = min(standard.lengths, key=lambda part: abs(part.length_mm - length))
        deviations.append(1e3 * (length - nearest.length_mm))
        names += ends
    if len(deviations) < PLACEMENTS or standard is None:
        problem = message("bar-not-placed", count=len(deviations), needed=PLACEMENTS)
        return [
            Measured("volumetric-largest", None, problem=problem),
            Measured("volumetric-two-rms", None, problem=problem),
        ]
    found = volumetric_length(deviations)
    sd_um = max(part.standard_uncertainty_um for part in standard.lengths)
    return [
        Measured(
            "volumetric-largest", found.largest_um, found.deviations_um, sd_um, "", tuple(names)
        ),
        Measured("volumetric-two-rms", found.two_rms_um, (), sd_um, "", tuple(names)),
    ]
