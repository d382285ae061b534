"""The places to touch in each part of the one-sphere test, about the touched centre. Pure."""

from dataclasses import dataclass

import numpy as np

from crenel.errors import OperationError
from crenel.formats.results.calibration import Calibration
from crenel.gauges.plan.document import GatePart, sphere_feature
from crenel.gauges.plan.document_gauge import GaugeFile
from crenel.gauges.session.off_gauge import refuse_off_sphere
from crenel.gauges.sphere.guide_state import SphereState
from crenel.gauges.sphere.maths_articulation import (
    LOCATION_CATCH_DEG,
    angle_deg,
    articulation_directions,
    assign_places,
    find_centre,
    flat_deg,
    location_places,
    mean_direction,
    nearest_free,
    stylus_directions,
)
from crenel.gauges.sphere.maths_pattern import CATCH_DEG, RIM_DEG, pattern_directions
from crenel.messages.message import message
from crenel.metrology.arm.kinematics import AnyArm, flange_pose, tip_centres, tip_of
from crenel.metrology.transforms import Floats

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


@dataclass(frozen=True, eq=False)
class Places:
    """The places of the part of the test that is touched now."""

    directions: Floats
    """(P, 3) from the sphere's centre, arm frame."""
    flat_deg: Floats
    """(P, 2) as seen along the pole: to the right and away from the arm, in degrees."""
    taken: frozenset[int]
    next: int
    """The one to touch now, -1 of none."""
    tip_flat_deg: tuple[float, float] | None
    """Where the tip is; None before the centre is known."""


def sphere_centre_of(state: SphereState, arm: AnyArm, gauge: GaugeFile) -> Floats | None:
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
    state: SphereState,
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


def places_of(state: SphereState, centre_mm: Floats | None) -> PartPlaces | None:
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


def live_places(
    state: SphereState, part: PartPlaces, centre_mm: Floats | None, tip_mm: Floats | None
) -> Places:
    """The places of a part with what is done, and the one that the tip is nearest to.

    Args:
        tip_mm: (3,) of the tip's centre now; None if it is not known.
    """
    taken = frozenset(touch.place for touch in state.of(state.feature))
    free = [place for place in range(len(part.directions)) if place not in taken]
    following = free[0] if free else -1
    tip_deg: tuple[float, float] | None = None
    if tip_mm is not None and centre_mm is not None:
        following = nearest_free(tip_mm, centre_mm, part.directions, sorted(taken))
        away = (tip_mm - centre_mm) / max(float(np.linalg.norm(tip_mm - centre_mm)), 1e-9)
        right_deg, away_deg = flat_deg(away[None], part.pole, part.towards)[0].tolist()
        tip_deg = (round(right_deg), round(away_deg))
    flat = flat_deg(part.directions, part.pole, part.towards)
    return Places(part.directions, flat, taken, following, tip_deg)


def find_touched_place(
    state: SphereState,
    part: PartPlaces,
    centre_mm: Floats,
    gauge: GaugeFile | None,
    arm: AnyArm,
    reading: Floats,
) -> int:
    """The free place of a part that a touch belongs to.

    Raises:
        OperationError: none is near, or the touch is not on the sphere of those before.
    """
    before = state.of(state.feature)
    tips = tip_centres(arm, np.array([*(touch.reading for touch in before), reading]))
    if gauge is not None and gauge.radius_mm is not None:
        refuse_off_sphere(tips[:-1], tips[-1], gauge.radius_mm + tip_of(arm).diameter_mm / 2)
    taken = [touch.place for touch in before]
    free = np.array([i for i in range(len(part.directions)) if i not in taken], dtype=np.int64)
    found = assign_places(tips[-1:], centre_mm, part.directions[free], part.catch_deg)
    if found[0] >= 0:
        return int(free[found[0]])
    wanted = nearest_free(tips[-1], centre_mm, part.directions, taken)
    raise OperationError(
        "no-free-place",
        message("performance-no-free-place"),
        remedy=message("performance-touch-place", number=wanted + 1),
    )
