"""What a kind of guided session consists of, and what all views have. Pure."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Generic, TypeVar

from crenel.findings import Finding, Quality
from crenel.guide.common.journal import JournalEntry
from crenel.guide.common.rules import CommandRules, Live, State
from crenel.guide.common.view import Step, StepState
from crenel.messages.message import Text, join, message
from crenel.metrology.arm.strained_pose import Strain
from crenel.station.devices.link_state import DeviceState

View = TypeVar("View")
DECISION_QUALITY: dict[str, Quality] = {
    "pass": "good",
    "fail": "bad",
    "uncertain": "attention",
    "none": "neutral",
}
"""The quality of each decision on a figure against its limit."""


@dataclass(frozen=True)
class Flow(Generic[State, Live, View]):
    """What is known of a kind of session without a station: pure functions of its state."""

    kind: str
    """The kind of the sessions in the journal."""
    topic: str
    """Under which the view is published."""
    empty: State
    """Before the first row."""
    after: Callable[[State, JournalEntry], State]
    """What a row makes of a state."""
    view_of: Callable[[State, Live], View]
    rules: CommandRules[State, Live]
    """When the commands are possible, and what they take."""
    automatic: tuple[str, ...] = ()
    """Rows that come by themselves: what was declined before them stays shown."""


def list_steps(
    titles: Mapping[str, Text], step: str, reached: str, over: bool = False
) -> list[Step]:
    """The steps in their order; what was ``reached`` before going back is stale, and all are done
    once the session is ``over``."""
    names = list(titles)
    here, furthest = names.index(step), names.index(reached)

    def state_of(place: int) -> StepState:
        if over or place < here:
            return "done"
        return "current" if place == here else "stale" if place <= furthest else "todo"

    return [Step(name, titles[name], state_of(place)) for place, name in enumerate(names)]


def strain_findings(strain: Strain | None) -> list[Finding]:
    """That the arm is in a pose in which it bends; empty in any other."""
    if strain is None:
        return []
    texts: dict[Strain, Text] = {
        "stop": message("arm-at-stop"),
        "straight": message("arm-stretched-out"),
        "base": message("arm-near-base"),
    }
    return [Finding("attention", texts[strain], message("touch-in-another-posture"))]


def device_findings(*links: DeviceState) -> list[Finding]:
    """A device that went away while the operator is at work; nothing is lost by it."""
    wait = message("wait-check-what-taken-kept")
    return [
        # no waiting brings one that nobody has chosen; its text says where that is done
        Finding("bad", join([one.title, one.text], ": "), "" if one.state == "absent" else wait)
        for one in links
        if one.state != "connected"
    ]
