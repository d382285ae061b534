"""The places to touch in each part of the one-sphere test, about the touched centre. Pure."""

from dataclasses import dataclass

import numpy as np

from app.formats.datasheets.gauge import GaugeFile
from app.formats.performance.plan import GatePart, sphere_feature
from app.formats.results.calibration import Calibration
from app.guide.performance.state import PerformanceState
from app.metrology.arm.kinematics import AnyArm, flange_pose, tip_centres, tip_of
from app.metrology.performance.articulation import (
    LOCATION_CATCH_DEG,
    angle_deg,
    articulation_directions,
    find_centre,
    flat_deg,
    location_places,
    mean_direction,
    stylus_directions,
)
from app.metrology.performance.pattern import CATCH_DEG, RIM_DEG, pattern_directions
from app.metrology.transforms import Floats

POLE = np.array(GatePart().pole)
"""(3,) away from the holder: the sphere stands on its foot."""
FRONT = np.array([0.0, -1.0, 0.0])
"""(3,) where the operator is assumed before the sphere is found."""


@dataclass(frozen=True, eq=False)
class PartPlaces:
    """The places of one part of the test."""

    directions: Floats
    """(P, 3) from the sphere's centre, arm frame."""
    catch_deg: float
    """A touch belongs to a place within this."""
    pole: Floats  # (3,)
    towards: Floats  # (3,) to the arm's base


def sphere_centre_of(state: PerformanceState, arm: AnyArm, gauge: GaugeFile) -> Floats | None:
    """(3,) of the sphere at the present position; None before its first touch."""
    touches = state.of(sphere_feature(state.position, "pattern"))
    if not touches or gauge.radius_mm is None or arm.tip is None:
        return None
    tips = tip_centres(arm, np.array([touch.reading for touch in touches]))
    return find_centre(tips, gauge.radius_mm + tip_of(arm).diameter_mm / 2, POLE)


def towards_base(centre_mm: Floats | None) -> Floats:
    """(3,) from the sphere to the arm's base."""
    return FRONT if centre_mm is None else -centre_mm


def directions_of_articulations(centre_mm: Floats | None) -> Floats:
    """(5, 3) as of ``articulation_directions``."""
    return articulation_directions(POLE, towards_base(centre_mm))


def off_articulation_deg(
    state: PerformanceState,
    arm: AnyArm,
    reading: Floats,
    centre_mm: Floats,
    calibration: Calibration | None,
) -> float | None:
    """The angle of stylus or camera from the direction of the articulation that is touched or
    scanned now; None while none is.

    Args:
        reading: (k,) of the arm.
        centre_mm: (3,) of the sphere.
    """
    if state.step not in ("location", "scan") or not state.articulation:
        return None
    if state.step == "location":
        held = stylus_directions(arm, reading[None])[0]
    elif calibration is None:
        return None
    else:
        T = flange_pose(arm, reading) @ calibration.T_flange_sensor
        away = T[:3, :3] @ calibration.camera.centre_mm + T[:3, 3] - centre_mm
        held = mean_direction(away[None])
    return angle_deg(held, directions_of_articulations(centre_mm)[state.articulation - 1])


def places_of(state: PerformanceState, centre_mm: Floats | None) -> PartPlaces | None:
    """The places of the part that is touched now; None if none is."""
    towards = towards_base(centre_mm)
    if not state.feature:
        return None
    if state.step == "pattern":
        return PartPlaces(pattern_directions(POLE, RIM_DEG), CATCH_DEG, POLE, towards)
    direction = POLE
    if state.step == "location":
        direction = directions_of_articulations(centre_mm)[state.articulation - 1]
    directions = location_places(direction, POLE, towards)
    return PartPlaces(directions, LOCATION_CATCH_DEG, POLE, towards)


def flat_pattern(centre_mm: Floats | None) -> Floats:
    """(25, 2) of the patches as seen along the pole, in degrees."""
    return flat_deg(pattern_directions(POLE), POLE, towards_base(centre_mm))
