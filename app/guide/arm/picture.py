"""The large picture of an arm session: the seat's points, the joints' swing, the result. Pure."""

import numpy as np

from app.guide.arm.live import ArmLive
from app.guide.arm.state import Angles, ArmState, SeatTaken
from app.guide.arm.view import (
    ArmPicture,
    ArmResult,
    Before,
    JointSwing,
    ParameterLine,
    SeatLine,
)
from app.guide.view import Vec3
from app.metrology.arm import Arm, tip_centres
from app.metrology.arm_model.articulation import spread_um
from app.metrology.arm_model.parameters import encoder_covariances, tip_jacobian
from app.metrology.frames import Floats

SHOWN = 240
"""Points of a seat that are drawn."""


def picture_of(state: ArmState, live: ArmLive, seat: SeatTaken | None) -> ArmPicture:
    arm = live.arm
    shown = seat if state.step != "seat" else None
    result = _result(state)
    if arm is None:
        return ArmPicture((), None, None, None, state.limit_um, (), (), result)
    joints = _joints(arm, shown, live.q_rad)
    seats = [_seat_line(arm, taken) for taken in state.seats if taken.q_rad]
    if shown is None or len(shown.q_rad) < 2:
        return ArmPicture((), None, None, None, state.limit_um, joints, seats, result)
    q = np.array(shown.q_rad)
    tips, J = tip_jacobian(arm, q)
    half_range, two_sigma = spread_um(tips)
    encoders = np.mean(np.diagonal(encoder_covariances(arm, J), axis1=1, axis2=2), axis=0)
    middle = (tips.max(axis=0) + tips.min(axis=0)) / 2
    off_um = (tips - middle)[-SHOWN:] * 1e3
    return ArmPicture(
        [_vec(np.round(off, 2)) for off in off_um],
        _vec(half_range),
        _vec(two_sigma),
        _vec(2e3 * np.sqrt(encoders)),
        state.limit_um,
        joints,
        seats,
        result,
    )


def _seat_line(arm: Arm, seat: SeatTaken) -> SeatLine:
    half_range, _ = spread_um(tip_centres(arm, np.array(seat.q_rad)))
    return SeatLine(seat.name, len(seat.q_rad), float(half_range.max()))


def _joints(arm: Arm, seat: SeatTaken | None, now: Angles | None) -> list[JointSwing]:
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
    solved = state.solved
    if solved is None:
        return None
    return ArmResult(
        solved["volume_before_um"],
        solved["volume_after_um"],
        solved["size_known"],
        solved["places"],
        [Before(**line) for line in solved["lines"]],
        [ParameterLine(**line) for line in solved["parameters"]],
    )


def _vec(values: Floats) -> Vec3:
    return float(values[0]), float(values[1]), float(values[2])
