"""What a kind of performance test is: its state, its evaluation, its scans, what its own steps say
and show, and how the simulated operator does them."""

from abc import ABC, abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar, Generic, TypeAlias, TypeVar

from crenel.errors import OperationError
from crenel.findings import Finding
from crenel.gauges.guide_view import ArticulationLine, PerformancePicture
from crenel.gauges.judgement.document import PerformanceFile
from crenel.gauges.judgement.evaluate_kind import Evaluation
from crenel.gauges.plan.maths_temperature import TemperatureLimits
from crenel.gauges.session.acts import GaugeLive
from crenel.gauges.session.changes import Payload
from crenel.gauges.session.entries import TestScan
from crenel.gauges.session.state import PerformanceState
from crenel.guide.common.arguments import Args
from crenel.guide.common.datasheet_library import AnyGauge, Gauges
from crenel.guide.common.simulation import StepWork
from crenel.guide.common.view import LiveNumber, StepProgress
from crenel.messages.message import Text, message
from crenel.metrology.arm.kinematics import AnyArm
from crenel.metrology.transforms import Floats

Guide = TypeVar("Guide")
"""The session on a station."""
State = TypeVar("State", bound=PerformanceState)
Scan = TypeVar("Scan", bound=TestScan)
Known = TypeVar("Known")
"""What a kind knows of the test at any moment, beside its state."""


@dataclass(frozen=True, eq=False, kw_only=True)
class PerformanceLive(GaugeLive, Generic[Known]):
    """The station as the performance test sees it."""

    kind: "AnyKind"
    known: Known
    gauges: Gauges[AnyGauge]
    """The spheres, plates or length standards among the data folder's gauges."""
    bars: Gauges[AnyGauge]
    """The ball bars, if the test is done with one beside the gauge."""
    artefacts: tuple[AnyGauge, ...]
    """The chosen ones."""
    artefact_problems: tuple[Text, ...]
    """Why they cannot serve."""
    obstacles: Mapping[str, Text]
    """Why gauges cannot serve, by their id."""
    setup_now: Mapping[str, object]
    """The station's settings of scans."""
    plan_changed: bool
    """Whether the plan's file is no longer the one of the first touch."""
    temperature_limits: TemperatureLimits
    """How steady artefact and arm have to be."""
    result: PerformanceFile | None

    @property
    def artefact(self) -> AnyGauge | None:
        """The chosen one; the gauge if there is a bar, too; None: none is chosen."""
        return next(iter(self.artefacts), None)


class PerformanceKind(ABC, Generic[Guide, State, Scan, Known]):
    """A kind of performance test."""

    state: ClassVar[type[PerformanceState]]
    evaluation: ClassVar[Evaluation]
    titles: ClassVar[Mapping[str, Text]]
    """The titles of its own steps."""
    work: ClassVar[Mapping[str, StepWork[Any]]]
    """What the simulated operator does in its own steps."""

    # -- what is known, said and shown -----------------------------------------------

    @abstractmethod
    def know(self, guide: Guide) -> Known:
        """What it knows of the test at this moment; called for every view."""

    def begin_payload(self, guide: Guide) -> Payload:
        """What the row has with which the artefact is confirmed."""
        return {}

    def title(self, state: State) -> Text:
        """The title of the step now, if it says more than the step's own; empty if it does not."""
        return ""

    @abstractmethod
    def instruction(self, state: State, live: PerformanceLive[Known]) -> Text:
        """What to do in a step of its own."""

    def number(self, state: State, live: PerformanceLive[Known]) -> LiveNumber | None:
        """The value to be shown large."""
        return None

    def progress(self, state: State) -> StepProgress | None:
        """How much of a step of its own is done."""
        done, of = len(state.of_step), state.wanted
        return StepProgress(done, of, message("touches", done=done, of=of))

    def lines(self, state: State, live: PerformanceLive[Known]) -> list[ArticulationLine]:
        """What is done and what is left in the step now."""
        return []

    def draw(
        self, picture: PerformancePicture, state: State, live: PerformanceLive[Known]
    ) -> PerformancePicture:
        """Adds to the picture what this kind alone shows."""
        return picture

    def artefact_findings(self, state: State, live: PerformanceLive[Known]) -> list[Finding]:
        """What should be known of the artefact before it is confirmed."""
        return []

    def findings(self, state: State, live: PerformanceLive[Known]) -> list[Finding]:
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

    # -- touches ---------------------------------------------------------------------

    def place_of(self, guide: Guide, arm: AnyArm, reading: Floats) -> int:
        """The place of the step's part that a touch belongs to.

        Raises:
            OperationError: all are touched, or it can be none of them.
        """
        raise OperationError("not-now", message("performance-all-touched"))

    # -- scans -----------------------------------------------------------------------

    def is_scan_left(self, state: State) -> bool:
        """Whether the step now lacks a scan."""
        return False

    def scans_again(self, state: State) -> list[tuple[Text, Args]]:
        """The scans that can be repeated once none is left: a label, and the arguments."""
        return []

    def begin_scan(self, guide: Guide, args: Args, key: str | None) -> None:
        """Starts the scan that a command is about; an earlier one of the same is kept aside.

        Raises:
            OperationError: it cannot start.
        """
        raise OperationError("not-now", message("performance-by-touch-alone"))

    def measure_scan(self, guide: Guide, scan: Scan) -> Payload:
        """What a scan shows, as its row has it.

        Raises:
            OperationError: it cannot be rebuilt, or is of no use.
        """
        raise OperationError("not-now", message("performance-by-touch-alone"))

    def measuring_text(self, guide: Guide, scan: Scan) -> Text:
        """Said while a scan is measured."""
        return ""

    def scan_title(self, scan: Scan) -> Text:
        """Which scan it was, in the notes of the result."""
        return ""

    def scan_text(self, scan: Scan) -> Text:
        """A scan that was measured, in a sentence."""
        return ""


AnyKind: TypeAlias = PerformanceKind[Any, Any, Any, Any]
AnyLive: TypeAlias = PerformanceLive[Any]


def open_scan_reason(state: PerformanceState) -> Text:
    """Said while a scan runs or is measured."""
    if state.open_scan is not None:
        return message("performance-finish-scan-first")
    if any(scan.waiting for scan in state.scans):
        return message("performance-scan-is-measured")
    return ""
