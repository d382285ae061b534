"""What the commands of an arm session take, and why one is not possible now. Pure.

An empty reason means that it is possible.
"""

from collections.abc import Sequence

import numpy as np

from crenel.formats.session.coordinates_table import COORDINATES
from crenel.guide.arm.state import Angles, ArmLive, ArmState, Kind
from crenel.guide.common.arguments import (
    Args,
    Arguments,
    IdArguments,
    OperatorArguments,
    ShortText,
)
from crenel.guide.common.rules import Command, CommandRules, no_simulation_reason
from crenel.messages.message import Text, message, quantity, rounded

WANTED = 60
"""Points in a seat, so that the range no longer grows much with more of them."""
LEAST = 30
LEAST_SWING_DEG = 60.0
SEATS_WANTED, SEATS_LEAST = 6, 4
TOUCHES_WANTED, TOUCHES_LEAST = 15, 8
"""How many touches of one sphere are wanted, and the fewest."""
TIP_WANTED, TIP_LEAST = 9, 5
"""How many touches of the sphere that the tip is checked on are wanted, and the fewest; from eight
on a bend is distinguished from a size."""
SIZES_MM: dict[Kind, tuple[float, float]] = {"bar": (20.0, 5000.0), "sphere": (3.0, 300.0)}
LARGEST_UNCERTAINTY_MM = 1.0


def swing_deg(q_rad: Sequence[Angles]) -> float:
    """How far the joint that turned most has turned."""
    return float(np.rad2deg(np.ptp(np.array(q_rad), axis=0).max())) if q_rad else 0.0


def places_taken(state: ArmState) -> int:
    """Seats, spheres and positions of a bar, whose two ends are one place to the fit."""
    return len(state.seats) - state.bar_ends + state.bar_ends // 2


def touches_wanted(state: ArmState) -> int:
    """How many touches of the sphere are wanted."""
    return TIP_WANTED if state.purpose == "tip" else TOUCHES_WANTED


def _arm_ready(state: ArmState, live: ArmLive, args: Args) -> Text:
    if live.connected_joints == 0:
        return message("arm-reports-poses-not-checked-here")
    if live.arm is None:
        return message("choose-arm-first")
    if live.link.state != "connected":
        return message("arm-says", text=live.link.text)
    if live.connected_joints is not None and live.connected_joints != live.arm.joint_count:
        return message(
            "connected-arm-has-joints-has-choose",
            connected_joints=live.connected_joints,
            name=live.arm.name,
            joint_count=live.arm.joint_count,
        )
    return ""


def _choose_artefact(state: ArmState, live: ArmLive, args: Args) -> Text:
    kind, size = args.get("kind"), args.get("size_mm")
    known = {"identify": ("seat", "bar", "sphere"), "tip": ("sphere",), "check": ()}
    if kind not in known[state.purpose]:
        return message("there-no-such-artefact-here")
    if state.half_bar:
        return message("take-bars-other-end-first-drop")
    if kind != "seat" and size is not None:
        low, high = SIZES_MM["bar" if kind == "bar" else "sphere"]
        if not _number(size) or not low <= float(str(size)) <= high:
            limits = {"low": rounded(low, "mm"), "high": rounded(high, "mm")}
            return message("has-mm", kind=str(kind), **limits)
    unsure = args.get("standard_uncertainty_mm", 0.0)
    if not _number(unsure) or not 0 <= float(str(unsure)) <= LARGEST_UNCERTAINTY_MM:
        largest = rounded(LARGEST_UNCERTAINTY_MM, "mm")
        return message("standard-uncertainty-0-mm", largest=largest)
    return ""


def _number(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)


def _begin(state: ArmState, live: ArmLive, args: Args) -> Text:
    missing = state.artefact.kind != "seat" and state.artefact.size_mm is None
    if missing and state.purpose != "check":
        return message("give-certificate-first", kind=state.artefact.kind)
    return _arm_ready(state, live, args)


def _touch(state: ArmState, live: ArmLive, args: Args) -> Text:
    if not state.touching:
        return message("points-taken-themselves-while-arm-swings")
    return _arm_ready(state, live, args)


def _finish(state: ArmState, live: ArmLive, args: Args) -> Text:
    taken = state.seats[-1].q_rad
    if state.touching:
        least = TIP_LEAST if state.purpose == "tip" else TOUCHES_LEAST
        few = len(taken) < least
        return message("touch-more-least-points", taken=len(taken), least=least) if few else ""
    if len(taken) < LEAST:
        return message("go-swinging-least-points", taken=len(taken), least=LEAST)
    swing = swing_deg(taken)
    if swing < LEAST_SWING_DEG:
        return message(
            "swing-further-least",
            swing=quantity(swing, "°"),
            least_swing_deg=quantity(LEAST_SWING_DEG, "°"),
        )
    return ""


def _fit(state: ArmState, live: ArmLive, args: Args) -> Text:
    if state.purpose != "identify":
        return message("check-one-seat")
    if not state.coordinates and places_taken(state) < SEATS_LEAST:
        return message(
            "least-places-taken", places_taken=places_taken(state), seats_least=SEATS_LEAST
        )
    if state.half_bar:
        return message("take-bars-other-end-first-drop")
    return ""


def _choose_arm(state: ArmState, live: ArmLive, args: Args) -> Text:
    if state.has_points:
        return message("seats-were-taken-another-arm")
    chosen = args.get("id")
    known = isinstance(chosen, str) and chosen in live.library.arms
    return "" if known else message("there-no-such-arm")


def _set_limit(state: ArmState, live: ArmLive, args: Args) -> Text:
    limit = args.get("limit_um")
    fine = limit is None or (
        isinstance(limit, int | float) and not isinstance(limit, bool) and 1 <= limit <= 1e5
    )
    if state.checked:
        return message("check-recorded-limit-set-before-next")
    return "" if fine else message("limit-number-micrometres-1-100-000")


def _drop_seat(state: ArmState, live: ArmLive, args: Args) -> Text:
    return "" if state.seats else message("no-seat-taken-yet")


def _take_coordinates(state: ArmState, live: ArmLive, args: Args) -> Text:
    if state.purpose != "identify":
        return message("coordinates-identify-only")
    return message("choose-arm-first") if live.arm is None else ""


def _drop_coordinates(state: ArmState, live: ArmLive, args: Args) -> Text:
    return "" if state.coordinates else message("no-coordinates-taken-yet")


def _save(state: ArmState, live: ArmLive, args: Args) -> Text:
    if state.saved:
        return message("arm-use-already")
    return "" if state.solved else message("identify-arm-first")


def _restore(state: ArmState, live: ArmLive, args: Args) -> Text:
    return "" if state.saved else message("arm-unchanged")


class _Limit(Arguments):
    limit_um: float | None = None


class _Coordinates(Arguments):
    text: str
    """The text of the file."""
    file_name: ShortText = COORDINATES


class _Artefact(Arguments):
    kind: Kind
    size_mm: float | None = None
    standard_uncertainty_mm: float = 0.0


RULES = CommandRules[ArmState, ArmLive](
    {
        "choose_arm": Command(("seat",), _choose_arm, IdArguments),
        "set_limit": Command(rule=_set_limit, arguments=_Limit),
        "choose_artefact": Command(("seat",), _choose_artefact, _Artefact),
        "begin": Command(("seat",), _begin),
        "touch": Command(("swing",), _touch),
        "finish": Command(("swing",), _finish),
        "drop_swing": Command(("swing",)),
        "drop_seat": Command(("seat",), _drop_seat),
        "take_coordinates": Command(("seat",), _take_coordinates, _Coordinates),
        "drop_coordinates": Command(("seat",), _drop_coordinates),
        "fit": Command(("seat",), _fit),
        "save": Command(("result",), _save),
        "restore": Command(("result",), _restore),
        "reopen": Command(("result",)),
        "again": Command(("result",)),
        "run_simulation": Command(("seat", "swing"), no_simulation_reason, OperatorArguments),
        "stop_simulation": Command(),
        "end": Command(),
    },
    closed=message("session-closed-start-new-one"),
    elsewhere=lambda step: message("belongs-another-step-session-stands", step=step),
)
