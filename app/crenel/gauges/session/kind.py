"""What the guide of a performance test asks of the kind of the test. Pure."""

from abc import ABC, abstractmethod
from collections.abc import Mapping
from typing import ClassVar, Generic, TypeVar

from crenel.findings import Finding
from crenel.gauges.guide_live import PerformanceLive
from crenel.gauges.guide_view import ArticulationLine, PerformancePicture
from crenel.gauges.session.entries import AnyScan
from crenel.gauges.session.state import PerformanceState
from crenel.guide.common.arguments import Args
from crenel.guide.common.view import LiveNumber, StepProgress
from crenel.messages.message import Text, message

State = TypeVar("State", bound=PerformanceState)
Scan = TypeVar("Scan", bound=AnyScan)


class PerformanceKind(ABC, Generic[State, Scan]):
    """A kind of performance test: what is said, shown and asked in its own steps."""

    titles: ClassVar[Mapping[str, Text]]
    """Of its own steps."""

    def title(self, state: State) -> Text:
        """Of the step now, if it says more than the step's own; empty if it does not."""
        return ""

    @abstractmethod
    def instruction(self, state: State, live: PerformanceLive) -> Text:
        """What to do in a step of its own."""

    def number(self, state: State, live: PerformanceLive) -> LiveNumber | None:
        """The value to be shown large."""
        return None

    def progress(self, state: State) -> StepProgress | None:
        """How much of a step of its own is done."""
        done, of = len(state.of_step), state.wanted
        return StepProgress(done, of, message("touches", done=done, of=of))

    def lines(self, state: State, live: PerformanceLive) -> list[ArticulationLine]:
        """What is done and what is left in the step now."""
        return []

    def draw(
        self, picture: PerformancePicture, state: State, live: PerformanceLive
    ) -> PerformancePicture:
        """Adds to the picture what this kind alone shows."""
        return picture

    def artefact_findings(self, state: State, live: PerformanceLive) -> list[Finding]:
        """What should be known of the artefact before it is confirmed."""
        return []

    def findings(self, state: State, live: PerformanceLive) -> list[Finding]:
        """What is wrong in the step now."""
        return []

    # -- rules: an empty reason means that it is possible --------------------------

    def confirm_reason(self, state: State) -> Text:
        """Why a step of its own is not done yet."""
        missing = state.wanted - len(state.of_step)
        return message("performance-touches-missing", missing=missing) if missing > 0 else ""

    def begin_scan_reason(self, state: State, args: Args) -> Text:
        """Why there is no scan that a command could mean."""
        return message("performance-by-touch-alone")

    # -- scans ----------------------------------------------------------------------

    def is_scan_left(self, state: State) -> bool:
        """Whether the step now lacks a scan."""
        return False

    def scans_again(self, state: State) -> list[tuple[Text, Args]]:
        """The scans that can be repeated once none is left: a label, and the arguments."""
        return []

    def scan_title(self, scan: Scan) -> Text:
        """Which scan it was, in the notes of the result."""
        return ""

    def scan_text(self, scan: Scan) -> Text:
        """A scan that was measured, in a sentence."""
        return ""


def open_scan_reason(state: PerformanceState) -> Text:
    """Said while a scan runs or is measured."""
    if state.open_scan is not None:
        return message("performance-finish-scan-first")
    if any(scan.waiting for scan in state.scans):
        return message("performance-scan-is-measured")
    return ""
