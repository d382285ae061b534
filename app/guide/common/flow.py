"""What the views of all guided sessions consist of. Pure."""

from collections.abc import Mapping

from app.findings import Finding, Quality
from app.guide.common.view import Step, StepState
from app.messages.message import Text, join, message
from app.station.devices.link_state import DeviceState

DECISION_QUALITY: dict[str, Quality] = {
    "pass": "good",
    "fail": "bad",
    "uncertain": "attention",
    "none": "neutral",
}
"""Of a figure against its limit."""


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


def lost_device_findings(*links: DeviceState) -> list[Finding]:
    """A device that went away while the operator is at work; nothing is lost by it."""
    return [
        Finding("bad", join([link.title, link.text], ": "), message("wait-check-what-taken-kept"))
        for link in links
        if link.state != "connected"
    ]
