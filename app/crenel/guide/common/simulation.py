"""How the simulated operator works in a guided session: by the same rules as a person."""

from collections.abc import Callable, Mapping
from typing import Any, TypeVar

from crenel.errors import OperationError
from crenel.guide.common.guided_session import GuidedSession
from crenel.guide.common.simulated_operator import SimulatedOperator
from crenel.messages.message import Text, message
from crenel.station.jobs import Progress

Session = GuidedSession[Any, Any, Any]
Guide = TypeVar("Guide", bound=Session)
StepWork = Callable[[Guide, SimulatedOperator, Progress], None]
TIMEOUT_S = 4.0
ATTEMPTS = 3


def work_on_steps(
    steps: Mapping[str, StepWork[Guide]],
    guide: Guide,
    operator: SimulatedOperator,
    whole: bool,
    progress: Progress,
) -> None:
    """Does the present step; of a ``whole`` session all steps, while each leads on."""
    while guide.simulation_running and guide.state.step in steps:
        step = guide.state.step
        steps[step](guide, operator, progress)
        if not whole or guide.state.step == step:
            return


def act_as_operator(guide: Session, name: str, act: Callable[[], object]) -> bool:
    """Does what a command does, where it is possible; False once the operator was stopped."""
    with guide.lock:
        if not guide.simulation_running:
            return False
        guide.check_allowed(name, {}, None, by_simulation=True)
        act()
        return True


def touch_until_taken(
    guide: Session,
    touch: Callable[[int], bool],
    taken: Callable[[], int],
    declined_text: Text,
) -> bool:
    """One place, again where the point was declined; False when the operator was stopped.

    Args:
        touch: touches the place for an attempt (from 0); False when it was stopped.
        taken: how many points there are.
        declined_text: said where the last attempt was declined, too.
    """
    for attempt in range(ATTEMPTS):
        with guide.lock:
            before, declined = taken(), guide.declined
        if not touch(attempt):
            return False
        with guide.changed:  # the arm's bytes and the journal take their time
            guide.changed.wait_for(
                lambda: taken() > before or guide.declined > declined,  # noqa: B023
                TIMEOUT_S,
            )
            if taken() > before:
                return True
    raise OperationError(
        "simulation-declined",
        declined_text,
        remedy=message("look-last-message-let-simulation-try"),
    )
