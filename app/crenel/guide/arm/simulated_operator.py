"""The simulated operator in an arm session: seats, bars and spheres, one after another."""

import time

from crenel.guide.arm.evaluate import finish_seat
from crenel.guide.arm.guide import ArmGuide
from crenel.guide.arm.rules import SEATS_WANTED, touches_wanted
from crenel.guide.arm.state import Kind, Purpose
from crenel.guide.common.simulated_operator import SimulatedOperator
from crenel.guide.common.simulation import ATTEMPTS, act_as_operator, touch_until_taken
from crenel.messages.message import message
from crenel.station.jobs import Progress

SETTLE_S = 0.5
"""The joints' last samples come in after the arm has come to rest."""
POSTURES: dict[Purpose, int] = {"check": 1, "tip": 1, "identify": 2}
"""How often the operator puts the tip into a seat, each time with the elbow elsewhere."""


def simulate(guide: ArmGuide, operator: SimulatedOperator, whole: bool, progress: Progress) -> None:
    """Takes the one seat of a check; of an identification all that are still wanted of the
    chosen artefact, of a sphere one."""
    if guide.state.swinging:
        guide.append("seat_dropped", {"name": guide.state.seats[-1].name})
    if guide.state.purpose != "check" and guide.state.artefact.kind == "sphere":
        _take_sphere(guide, operator, progress)
        return
    wanted = SEATS_WANTED if guide.state.purpose == "identify" else 1
    wanted = max(wanted, len(guide.state.seats) + 1)
    while guide.simulation_running:
        done = len(guide.state.seats)
        if done >= wanted and not guide.state.half_bar:
            return
        if not _take_seat(guide, operator, min(done / wanted, 1.0), progress):
            return


def _count_artefacts(guide: ArmGuide, kind: Kind) -> int:
    return sum(seat.artefact.kind == kind for seat in guide.state.seats)


def _take_seat(
    guide: ArmGuide, operator: SimulatedOperator, share: float, progress: Progress
) -> bool:
    """One seat, or one end of the bar, from the approach to the end of the swing; False when
    the operator was stopped."""
    on_bar = guide.state.purpose == "identify" and guide.state.artefact.kind == "bar"
    position, end = divmod(_count_artefacts(guide, "bar"), 2)
    seat = _count_artefacts(guide, "seat")

    def go(posture: int) -> bool:
        if on_bar:
            return operator.go_to_bar(position, end, posture)
        return operator.go_to_seat(seat, posture)

    name = message("bars-end", value="AB"[end]) if on_bar else message("seat-named", name=seat + 1)
    progress(message("simulation-goes", name=name), share)
    if not go(0):
        return False
    time.sleep(SETTLE_S)
    if not _begin(guide):
        return False
    progress(message("simulation-swings-arm-about", name=name), share)
    for posture in range(POSTURES[guide.state.purpose]):
        if posture and not go(posture):
            return False
        time.sleep(SETTLE_S)
        if not guide.simulation_running or not operator.swing_in_seat():
            return False
    time.sleep(SETTLE_S)
    _finish(guide)
    return True


def _take_sphere(guide: ArmGuide, operator: SimulatedOperator, progress: Progress) -> None:
    """One sphere, touched all over its top."""
    ball = _count_artefacts(guide, "sphere")
    if not _begin(guide):
        return
    of = touches_wanted(guide.state)
    for index in range(of):
        progress(message("simulation-touches-sphere"), index / of)
        if not guide.simulation_running or not _touch(guide, operator, ball, index):
            return
    time.sleep(SETTLE_S)
    _finish(guide)


def _touch(guide: ArmGuide, operator: SimulatedOperator, ball: int, index: int) -> bool:
    """One place of the sphere; False when the operator was stopped."""
    return touch_until_taken(
        guide,
        lambda attempt: operator.touch_ball(ball, index),
        lambda: len(guide.state.seats[-1].q_rad),
        message("hands-touch-declined-times", index=index + 1, attempts=ATTEMPTS),
    )


def _begin(guide: ArmGuide) -> bool:
    return act_as_operator(guide, "begin", lambda: guide.begin_seat(None))


def _finish(guide: ArmGuide) -> None:
    guide.refresh()
    act_as_operator(guide, "finish", lambda: finish_seat(guide, None))
