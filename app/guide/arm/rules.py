"""Why a command of an arm session is not possible now; empty means that it is. Pure."""

from collections.abc import Callable, Mapping, Sequence

import numpy as np

from app.guide.arm.live import ArmLive
from app.guide.arm.state import Angles, ArmState

WANTED = 60
"""Points in a seat, so that the range no longer grows much with more of them."""
LEAST = 30
LEAST_SWING_DEG = 60.0
SEATS_WANTED, SEATS_LEAST = 6, 4

ONLY_IN = {
    "choose_arm": ("seat",),
    "set_limit": ("seat", "swing", "result"),
    "begin": ("seat",),
    "finish": ("swing",),
    "drop_swing": ("swing",),
    "drop_seat": ("seat",),
    "fit": ("seat",),
    "save": ("result",),
    "reopen": ("result",),
    "again": ("result",),
    "let_hand": ("seat", "swing"),
    "stop_hand": ("seat", "swing", "result"),
    "end": ("seat", "swing", "result"),
}


def why_not(state: ArmState, live: ArmLive, name: str, args: Mapping[str, object]) -> str:
    """Why a command cannot be done now; empty when it can."""
    if name not in ONLY_IN:
        return f"There is no command '{name}'."
    if name == "stop_hand":
        return "" if live.hand_running else "The hand is not moving."
    if state.ended or not state.session_id:
        return "This session is closed. Start a new one."
    if live.busy is not None:
        return f"Wait: {live.busy.text[0].lower()}{live.busy.text[1:]}."
    if state.step not in ONLY_IN[name]:
        return f"This belongs to another step; the session stands at '{state.step}'."
    rule = RULES.get(name)
    return rule(state, live, args) if rule else ""


def swing_deg(q_rad: Sequence[Angles]) -> float:
    """How far the joint that turned most has turned."""
    return float(np.rad2deg(np.ptp(np.array(q_rad), axis=0).max())) if q_rad else 0.0


def _arm_ready(state: ArmState, live: ArmLive, args: Mapping[str, object]) -> str:
    if live.arm is None:
        return "Choose the arm first."
    if live.link.state != "connected":
        return f"The arm: {live.link.text}"
    if live.connected_joints is not None and live.connected_joints != live.arm.joint_count:
        return (
            f"The connected arm has {live.connected_joints} joints, {live.arm.name} has "
            f"{live.arm.joint_count}. Choose the arm that is connected."
        )
    return ""


def _finish(state: ArmState, live: ArmLive, args: Mapping[str, object]) -> str:
    taken = state.seats[-1].q_rad
    if len(taken) < LEAST:
        return f"Go on swinging: {len(taken)} of at least {LEAST} points."
    swing = swing_deg(taken)
    if swing < LEAST_SWING_DEG:
        return f"Swing further: {swing:.0f}° of at least {LEAST_SWING_DEG:.0f}°."
    return ""


def _fit(state: ArmState, live: ArmLive, args: Mapping[str, object]) -> str:
    if state.purpose != "identify":
        return "This is a check of one seat."
    if len(state.seats) < SEATS_LEAST:
        return f"{len(state.seats)} of at least {SEATS_LEAST} seats are taken."
    return ""


def _choose_arm(state: ArmState, live: ArmLive, args: Mapping[str, object]) -> str:
    if state.seats:
        return "The seats were taken with another arm."
    return "" if args.get("id") in live.library.arms else "There is no such arm."


def _set_limit(state: ArmState, live: ArmLive, args: Mapping[str, object]) -> str:
    limit = args.get("limit_um")
    fine = limit is None or (
        isinstance(limit, int | float) and not isinstance(limit, bool) and 1 <= limit <= 1e5
    )
    if state.checked:
        return "This check is recorded with its limit. Set it before the next one."
    return "" if fine else "A limit is a number of micrometres from 1 to 100 000."


def _drop_seat(state: ArmState, live: ArmLive, args: Mapping[str, object]) -> str:
    return "" if state.seats else "No seat was taken yet."


def _save(state: ArmState, live: ArmLive, args: Mapping[str, object]) -> str:
    if state.saved:
        return "This arm is in use already."
    return "" if state.solved else "Identify the arm first."


def _hand(state: ArmState, live: ArmLive, args: Mapping[str, object]) -> str:
    return "" if live.has_hand else "There is no simulated hand on real devices."


Rule = Callable[[ArmState, ArmLive, Mapping[str, object]], str]
RULES: dict[str, Rule] = {
    "begin": _arm_ready,
    "finish": _finish,
    "fit": _fit,
    "choose_arm": _choose_arm,
    "set_limit": _set_limit,
    "drop_seat": _drop_seat,
    "save": _save,
    "let_hand": _hand,
}
