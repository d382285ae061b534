"""The commands of a guided session: from the browser, and from the arm's buttons."""

from collections.abc import Callable, Mapping
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass, field
from typing import Any, Generic, TypeVar

from crenel.errors import OperationError
from crenel.guide.common.arguments import Args
from crenel.guide.common.buttons import ButtonName, Press
from crenel.guide.common.guided_session import GuidedSession
from crenel.guide.common.simulated_operator import SimulatedOperator
from crenel.station.jobs import Progress

AT_ANY_REV = ("stop_simulation", "stop_poses")
"""Stopping must not wait for a fresh view."""
WITHOUT_ARM = ("stop_simulation", "stop_poses", "abandon", "end")
"""Commands by which a session ends or rests, whatever has the arm meanwhile."""
Guide = TypeVar("Guide", bound=GuidedSession[Any, Any, Any])
Act = Callable[[Guide, Args, str | None], None]
"""Does a command with its arguments, once for its key; it leaves rows in the journal."""
SimulationWork = Callable[[Guide, SimulatedOperator, bool, Progress], None]
"""Does the present step, or all that follow, by the simulated operator."""


@dataclass(frozen=True)
class Commands(Generic[Guide]):
    """All that can be done in a kind of session."""

    acts: Mapping[str, Act[Guide]]
    """By the commands' names."""
    button_command: Callable[[Guide, ButtonName], str]
    """What a button of the arm does now; empty for nothing."""
    at_press: Mapping[str, Callable[[Guide, int], None]] = field(default_factory=dict)
    """What a button does otherwise than the browser, with the stamp of the press: whether the
    arm was still is judged as of then, not as of now."""
    has_buttons: bool = False
    """Whether an open session has the buttons, whatever they mean to it."""

    def run(self, guide: Guide, name: str, args: Args, rev: int, key: str) -> object:
        """Does a command of the browser, once for each ``key``; returns the view.

        Raises:
            OperationError: the command is not possible now, was given on an old view, or needs the
                arm while another activity has it.
        """
        with guide.lock:
            if not guide.knows_key(key):
                rev_seen = None if name in AT_ANY_REV else rev
                typed = guide.check_allowed(name, args, rev_seen)
                with _arm_for(guide, name):
                    self.acts[name](guide, typed, key)
            return guide.refresh()

    def press(self, guide: Guide, event: Press) -> bool:
        """Does what a button of the arm means now; False where it means nothing."""
        with guide.lock:
            name = self.button_command(guide, event.button) if guide.running else ""
            if not name:
                return self.has_buttons and guide.running
            try:
                with _arm_for(guide, name):
                    if name in self.at_press:
                        self.at_press[name](guide, event.stamp_ns)
                    else:
                        typed = guide.check_allowed(name, {}, None)
                        self.acts[name](guide, typed, None)
            except OperationError as refusal:
                guide.decline(refusal)
            guide.refresh()
            return True


def _arm_for(guide: GuidedSession[Any, Any, Any], name: str) -> AbstractContextManager[None]:
    return nullcontext() if name in WITHOUT_ARM else guide.use_arm()


def record(kind: str, *names: str, **values: object) -> Act[Any]:
    """A command that leaves one row: its arguments of these names, and what is always so."""

    def act(guide: GuidedSession[Any, Any, Any], args: Args, key: str | None) -> None:
        guide.append(kind, {**{name: args.get(name) for name in names}, **values}, key)

    return act


def go_back(steps: tuple[str, ...]) -> Act[Any]:
    """To the step that is asked for, or to the one before."""

    def act(guide: GuidedSession[Any, Any, Any], args: Args, key: str | None) -> None:
        before = steps[steps.index(guide.state.step) - 1]
        guide.append("went_back", {"to": args.get("to", before)}, key)

    return act


def simulation_acts(work: SimulationWork[Guide], has_whole: bool = True) -> dict[str, Act[Guide]]:
    """Starting and stopping the simulated operator; ``has_whole``: it can do a whole session."""

    def run(guide: Guide, args: Args, key: str | None) -> None:
        operator = guide.station.simulated_operator
        assert operator is not None
        whole = args.get("all") is True
        guide.append("simulation_started", {"all": whole} if has_whole else {}, key)
        guide.start_simulation(lambda progress: work(guide, operator, whole, progress))

    def stop(guide: Guide, args: Args, key: str | None) -> None:
        guide.stop_simulation()
        guide.append("simulation_stopped", {}, key)

    return {"run_simulation": run, "stop_simulation": stop}
