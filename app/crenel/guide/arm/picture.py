"""The large picture of an arm session: the seat's points, the joints' swing, the result. Pure."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from pydantic import TypeAdapter

from crenel.gauges.quick.guide.view import TouchLine
from crenel.guide.arm.state import Angles, ArmLive, ArmState, SeatSamples
from crenel.guide.arm.tip import tip_result
from crenel.guide.arm.view import (
    ArmPicture,
    ArmResult,
    JointSwing,
    SeatLine,
)
from crenel.guide.common.view import Vec3
from crenel.messages.message import Text, message, signed
from crenel.metrology.arm.identification.articulation import tip_spread_um
from crenel.metrology.arm.kinematics import Arm, tip_centres, tip_covariances, tips_with_covariances
from crenel.metrology.fitting.deviation_map import flat_places
from crenel.metrology.fitting.touched_shape import agree_on_sphere
from crenel.metrology.probing.seat_articulation import seat_articulation
from crenel.metrology.transforms import Floats

DRAWN_POINTS = 240
"""Points of a seat that are drawn."""
FEWEST_ON_BALL, STEPS = 5, 8
_RESULT = TypeAdapter(ArmResult)


def build_picture(state: ArmState, live: ArmLive, seat: SeatSamples | None) -> ArmPicture:
    arm = live.arm
    shown = seat if state.step != "seat" else None
    result = _result(state)
    if state.purpose == "tip":
        return _tip_picture(state, arm, seat)
    if arm is None:
        return ArmPicture((), None, None, None, state.limit_um, (), (), result)
    joints = _joints(arm, shown, live.q_rad)
    seats = _seat_lines(arm, state.seats)
    fewest = FEWEST_ON_BALL if state.touching else 2
    if shown is None or len(shown.q_rad) < fewest:
        return ArmPicture((), None, None, None, state.limit_um, joints, seats, result)
    q_rad = np.array(shown.q_rad)
    tips, covariances = tips_with_covariances(arm, q_rad)
    off_mm = _off_mm(arm, shown, tips)
    half_range, two_sigma = tip_spread_um(off_mm)
    in_space = None if shown.artefact.kind == "sphere" else seat_articulation(tips)
    encoders = np.mean(np.diagonal(covariances, axis1=1, axis2=2), axis=0)
    return ArmPicture(
        [_vec(np.round(off, 2)) for off in off_mm[-DRAWN_POINTS:] * 1e3],
        _vec(half_range),
        _vec(two_sigma),
        _vec(2e3 * np.sqrt(encoders)),
        state.limit_um,
        joints,
        seats,
        result,
        largest_um=None if in_space is None else in_space.largest_um,
        two_s_um=None if in_space is None else in_space.two_s_um,
    )


def _tip_picture(state: ArmState, arm: Arm | None, seat: SeatSamples | None) -> ArmPicture:
    """The touches of the sphere from above, and what they show of the tip."""
    checked = state.checked
    nothing = ArmPicture((), None, None, None, state.limit_um, (), (), None)
    if arm is None or seat is None or seat.artefact.size_mm is None:
        return nothing
    touches = [TouchLine(i, None, None, None) for i in range(len(seat.q_rad))]
    half_range = None
    if len(seat.q_rad) >= FEWEST_ON_BALL:
        radius_mm = seat.artefact.size_mm / 2
        tips = tip_centres(arm, np.array(seat.q_rad))
        reach_mm = radius_mm + arm.tip.radius_mm
        kept = agree_on_sphere(tips, tip_covariances(arm, np.array(seat.q_rad)), reach_mm).kept
        away = tips - _ball_centre(tips[kept], reach_mm)
        far = np.linalg.norm(away, axis=1)
        flat = flat_places(away / far[:, None] * radius_mm, np.array([0.0, 0.0, 1.0]))
        off_um = 1e3 * (far - reach_mm)
        touches = [
            TouchLine(i, float(x), float(y), float(off), not agrees)
            for i, ((x, y), off, agrees) in enumerate(zip(flat, off_um, kept, strict=True))
        ]
        largest = float(np.max(np.abs(off_um)))
        half_range = (largest, largest, largest)
    return replace(
        nothing,
        half_range_um=half_range,
        touches=touches,
        sphere_mm=seat.artefact.size_mm / 2,
        tip=tip_result(checked) if checked is not None else None,
    )


def _seat_lines(arm: Arm, seats: Sequence[SeatSamples]) -> list[SeatLine]:
    lines: list[SeatLine] = []
    other: Floats | None = None
    for seat in seats:
        if len(seat.q_rad) < (FEWEST_ON_BALL if seat.artefact.kind == "sphere" else 1):
            continue
        tips = tip_centres(arm, np.array(seat.q_rad))
        half_range, _ = tip_spread_um(_off_mm(arm, seat, tips))
        note: Text = ""
        if seat.artefact.kind == "bar":
            here = (tips.max(axis=0) + tips.min(axis=0)) / 2
            if other is not None:
                longer_mm = np.linalg.norm(here - other) - (seat.artefact.size_mm or 0.0)
                note = message("length", longer=signed(1e3 * float(longer_mm), "µm"))
            other = here if other is None else None
        lines.append(SeatLine(seat.title, len(seat.q_rad), float(half_range.max()), note))
    return lines


def _off_mm(arm: Arm, seat: SeatSamples, tips: Floats) -> Floats:
    """(N, 3) of the tips from the middle of a seat, or outward from a sphere."""
    if seat.artefact.kind != "sphere":
        return np.asarray(tips - (tips.max(axis=0) + tips.min(axis=0)) / 2)
    radius_mm = ((seat.artefact.size_mm or 0.0) + arm.tip.diameter_mm) / 2
    centre = _ball_centre(tips, radius_mm)
    away = tips - centre
    far = np.linalg.norm(away, axis=1, keepdims=True)
    return np.asarray(away / far * (far - radius_mm))


def _ball_centre(tips: Floats, radius_mm: float) -> Floats:
    """(3,) of the sphere of a known radius nearest to the tips, by Gauss-Newton."""
    system = np.column_stack([2 * tips, np.ones(len(tips))])
    centre: Floats = np.linalg.lstsq(system, np.sum(tips**2, axis=1), rcond=None)[0][:3]
    for _ in range(STEPS):
        away = tips - centre
        far = np.linalg.norm(away, axis=1)
        centre = centre + np.linalg.lstsq(away / far[:, None], far - radius_mm, rcond=None)[0]
    return centre


def _joints(arm: Arm, seat: SeatSamples | None, now: Angles | None) -> list[JointSwing]:
    q_deg = np.rad2deg(np.array(seat.q_rad)) if seat and seat.q_rad else None
    lines = []
    for i, joint in enumerate(arm.joints):
        low, high = np.rad2deg(joint.limits_rad)
        lines.append(
            JointSwing(
                joint.name,
                None if q_deg is None else round(float(q_deg[:, i].min()), 1),
                None if q_deg is None else round(float(q_deg[:, i].max()), 1),
                None if now is None else round(float(np.rad2deg(now[i])), 0),
                float(low),
                float(high),
            )
        )
    return lines


def _result(state: ArmState) -> ArmResult | None:
    return None if state.solved is None else _RESULT.validate_python(state.solved)


def _vec(values: Floats) -> Vec3:
    return float(values[0]), float(values[1]), float(values[2])
