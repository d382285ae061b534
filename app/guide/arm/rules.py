"""Why a command of an arm session is not possible now; empty means that it is. Pure."""

from collections.abc import Callable, Mapping, Sequence

import numpy as np

from app.guide.arm.live import ArmLive
from app.guide.arm.state import Angles, ArmState, Kind

WANTED = 60
"""Points in a seat, so that the range no longer grows much with more of them."""
LEAST = 30
LEAST_SWING_DEG = 60.0
SEATS_WANTED, SEATS_LEAST = 6, 4
TOUCHES_WANTED, TOUCHES_LEAST = 15, 8
"""Of one sphere."""
TIP_WANTED, TIP_LEAST = 9, 5
"""Of the sphere that the tip is checked on; from eight on a bend is told from a size."""
SIZES_MM: dict[Kind, tuple[float, float]] = {"bar": (20.0, 5000.0), "sphere": (3.0, 300.0)}
LARGEST_UNCERTAINTY_MM = 1.0

ONLY_IN = {
    "choose_arm": ("seat",),
    "set_limit": ("seat", "swing", "result"),
    "choose_artefact": ("seat",),
    "begin": ("seat",),
    "touch": ("swing",),
    "finish": ("swing",),
    "drop_swing": ("swing",),
    "drop_seat": ("seat",),
    "fit": ("seat",),
    "save": ("result",),
    "restore": ("result",),
    "reopen": ("result",),
    "again": ("result",),
    "let_hand": ("seat", "swing"),
    "stop_hand": ("seat", "swing", "result"),
    "end": ("seat", "swing", "result"),
}


def rejection_reason(state: ArmState, live: ArmLive, name: str, args: Mapping[str, object]) -> str:
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


def places_taken(state: ArmState) -> int:
    """Seats, spheres and positions of a bar, whose two ends are one place to the fit."""
    return len(state.seats) - state.bar_ends + state.bar_ends // 2


def touches_wanted(state: ArmState) -> int:
    """Of the sphere."""
    return TIP_WANTED if state.purpose == "tip" else TOUCHES_WANTED


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


def _choose_artefact(state: ArmState, live: ArmLive, args: Mapping[str, object]) -> str:
    kind, size = args.get("kind"), args.get("size_mm")
    known = {"identify": ("seat", "bar", "sphere"), "tip": ("sphere",), "check": ()}
    if kind not in known[state.purpose]:
        return "There is no such artefact here."
    if state.half_bar:
        return "Take the bar's other end first, or drop the last."
    if kind != "seat" and size is not None:
        low, high = SIZES_MM["bar" if kind == "bar" else "sphere"]
        if not _number(size) or not low <= float(str(size)) <= high:
            return f"A {kind} has {low:g} to {high:g} mm."
    unsure = args.get("standard_uncertainty_mm", 0.0)
    if not _number(unsure) or not 0 <= float(str(unsure)) <= LARGEST_UNCERTAINTY_MM:
        return f"A standard uncertainty is 0 to {LARGEST_UNCERTAINTY_MM:g} mm."
    return ""


def _number(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)


def _begin(state: ArmState, live: ArmLive, args: Mapping[str, object]) -> str:
    missing = state.artefact.kind != "seat" and state.artefact.size_mm is None
    if missing and state.purpose != "check":
        what = "bar's length" if state.artefact.kind == "bar" else "sphere's diameter"
        return f"Give the {what} by its certificate first."
    return _arm_ready(state, live, args)


def _touch(state: ArmState, live: ArmLive, args: Mapping[str, object]) -> str:
    if not state.touching:
        return "Points are taken by themselves while the arm swings."
    return _arm_ready(state, live, args)


def _finish(state: ArmState, live: ArmLive, args: Mapping[str, object]) -> str:
    taken = state.seats[-1].q_rad
    if state.touching:
        least = TIP_LEAST if state.purpose == "tip" else TOUCHES_LEAST
        few = len(taken) < least
        return f"Touch it more: {len(taken)} of at least {least} points." if few else ""
    if len(taken) < LEAST:
        return f"Go on swinging: {len(taken)} of at least {LEAST} points."
    swing = swing_deg(taken)
    if swing < LEAST_SWING_DEG:
        return f"Swing further: {swing:.0f}° of at least {LEAST_SWING_DEG:.0f}°."
    return ""


def _fit(state: ArmState, live: ArmLive, args: Mapping[str, object]) -> str:
    if state.purpose != "identify":
        return "This is a check of one seat."
    if places_taken(state) < SEATS_LEAST:
        return f"{places_taken(state)} of at least {SEATS_LEAST} places are taken."
    if state.half_bar:
        return "Take the bar's other end first, or drop the last."
    return ""


def _choose_arm(state: ArmState, live: ArmLive, args: Mapping[str, object]) -> str:
    if state.seats:
        return "The seats were taken with another arm."
    chosen = args.get("id")
    known = isinstance(chosen, str) and chosen in live.library.arms
    return "" if known else "There is no such arm."


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


def _restore(state: ArmState, live: ArmLive, args: Mapping[str, object]) -> str:
    return "" if state.saved else "The arm is as it was."


def _simulation(state: ArmState, live: ArmLive, args: Mapping[str, object]) -> str:
    return "" if live.has_hand else "There is no simulated hand on real devices."


Rule = Callable[[ArmState, ArmLive, Mapping[str, object]], str]
RULES: dict[str, Rule] = {
    "choose_artefact": _choose_artefact,
    "begin": _begin,
    "touch": _touch,
    "finish": _finish,
    "fit": _fit,
    "choose_arm": _choose_arm,
    "set_limit": _set_limit,
    "drop_seat": _drop_seat,
    "save": _save,
    "restore": _restore,
    "let_hand": _simulation,
}
