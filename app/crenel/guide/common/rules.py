"""When the commands of a guided session are possible, and how they are offered. Pure."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Generic, Protocol, TypeVar

from crenel.findings import Finding
from crenel.guide.common.arguments import Args, Arguments
from crenel.guide.common.view import Action, Busy
from crenel.messages.message import Text, message


class SessionState(Protocol):
    """What all states have."""

    @property
    def session_id(self) -> str: ...
    @property
    def rev(self) -> int: ...
    @property
    def step(self) -> str: ...
    @property
    def ended(self) -> object:
        """True in some way once the session is over."""


@dataclass(frozen=True, kw_only=True)
class SessionLive:
    """The station as every session sees it, beside its journal."""

    has_simulation: bool
    simulation_running: bool
    busy: Busy | None
    """The work that is under way."""
    trouble: Finding | None
    """Why the last thing asked for was not done."""


State = TypeVar("State", bound=SessionState)
Live = TypeVar("Live", bound=SessionLive)
Rule = Callable[[State, Live, Args], Text]
"""Why a command cannot be done now; empty when it can."""


@dataclass(frozen=True)
class Command(Generic[State, Live]):
    """When a command is possible, and what it takes."""

    steps: tuple[str, ...] | Callable[[State], Sequence[str]] = ()
    """Those that it belongs to, also by the state; none named where it belongs to all."""
    rule: Rule[State, Live] | None = None
    """What else it waits for."""
    arguments: type[Arguments] = Arguments
    while_busy: bool = False
    """Whether it is possible while work is under way."""
    when_closed: bool = False
    """Whether a session that is over takes it, too."""

    def belongs_to(self, state: State) -> bool:
        """Whether the command belongs to the present step."""
        if callable(self.steps):
            return state.step in self.steps(state)
        return not self.steps or state.step in self.steps


@dataclass(frozen=True)
class CommandRules(Generic[State, Live]):
    """The commands of a kind of session."""

    commands: Mapping[str, Command[State, Live]]
    closed: Text
    """Said where the session is over, or none was begun."""
    elsewhere: Callable[[str], Text]
    """Said of a command of another step than the present one."""
    precondition: Callable[[State, Live, str], Text] | None = None
    """Asked before a command's own rule, with the command's name."""

    def arguments(self, name: str) -> type[Arguments]:
        """What a command takes; one that is not known takes nothing."""
        return self.commands[name].arguments if name in self.commands else Arguments

    def rejection_reason(self, state: State, live: Live, name: str, args: Args) -> Text:
        """Why a command cannot be done now; empty when it can."""
        command = self.commands.get(name)
        if command is None:
            return message("there-no-command", name=name)
        if name == "stop_simulation":
            return "" if live.simulation_running else message("simulation-not-moving")
        if (state.ended or not state.session_id) and not command.when_closed:
            return self.closed
        if live.busy is not None and not command.while_busy:
            return message("wait-because", text=live.busy.text)
        if not command.belongs_to(state):
            return self.elsewhere(state.step)
        if self.precondition and (reason := self.precondition(state, live, name)):
            return reason
        return command.rule(state, live, args) if command.rule else ""

    def offer(
        self,
        state: State,
        live: Live,
        name: str,
        label: Text,
        args: Args | None = None,
        primary: bool = False,
        confirm: Text = "",
    ) -> Action:
        """The action, enabled or with the reason why not."""
        reason = self.rejection_reason(state, live, name, args or {})
        return Action(name, label, args or {}, primary, not reason, reason, confirm)

    def offer_simulation(self, state: State, live: Live, whole: bool = False) -> list[Action]:
        """Starting the simulated operator, for the ``whole`` session too, or stopping it."""
        if live.simulation_running:
            label = message("stop-simulation")
            return [self.offer(state, live, "stop_simulation", label, primary=True)]
        if not live.has_simulation:
            return []
        actions = [self.offer(state, live, "run_simulation", message("let-simulation-do"))]
        if whole:
            label = message("let-simulation-do-everything")
            actions.append(self.offer(state, live, "run_simulation", label, {"all": True}))
        return actions


def no_simulation_reason(state: SessionState, live: SessionLive, args: Args) -> Text:
    """Why a station on real devices has no simulated operator."""
    return "" if live.has_simulation else message("there-no-simulation-real-devices")
