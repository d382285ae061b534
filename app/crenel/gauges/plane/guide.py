"""The test on a plate: its state, what its step says and shows, its scans in two orientations.

Nothing is touched.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import partial
from typing import ClassVar

from crenel.errors import OperationError, sentence
from crenel.findings import Finding
from crenel.gauges.guide import PerformanceGuide
from crenel.gauges.guide_view import ArticulationLine, ArticulationState
from crenel.gauges.judgement.evaluate_measured_data import ScanCloud
from crenel.gauges.plan.document import ORIENTATIONS, Kind, plane_scan
from crenel.gauges.plan.document_symbols import Quantity
from crenel.gauges.plane.evaluate import (
    LEAST_TURN_DEG,
    PlaneEvaluation,
    measure_plate_scan,
    orientations_alike,
    turn_between_deg,
)
from crenel.gauges.session.changes import Payload
from crenel.gauges.session.entries import SphereContact, TestScan
from crenel.gauges.session.kind import PerformanceKind, PerformanceLive, open_scan_reason
from crenel.gauges.session.simulation import SCAN_ATTEMPTS, confirm, scan_once
from crenel.gauges.session.state import ArtefactShape, PerformanceState
from crenel.guide.common.arguments import Args
from crenel.guide.common.journal import error_from_payload
from crenel.guide.common.simulated_operator import SimulatedOperator
from crenel.guide.common.simulation import StepWork
from crenel.guide.common.view import StepProgress
from crenel.messages.message import Text, join, message, quantity
from crenel.metrology.transforms import Floats
from crenel.station.jobs import Progress

NUMBERS = range(1, ORIENTATIONS + 1)


@dataclass(frozen=True, kw_only=True)
class PlateScan(TestScan):
    """One scan of a plate in an orientation."""

    orientation: int
    """From 1."""
    points: int = 0
    """The points of the plate; 0 until it is measured."""
    width_mm: float = 0.0
    """The width of the part that it shows, in its narrower direction."""
    dispersion_um: float = 0.0
    """``E_Form.Pla.D95%`` by this scan."""
    turn_deg: float | None = None
    """The turn of the sensor since the scan of the other orientation; None before there is one."""

    @property
    def name(self) -> str:
        return plane_scan(self.orientation)

    @property
    def measured(self) -> bool:
        return self.points > 0


@dataclass(frozen=True)
class PlaneState(PerformanceState):
    """Where a test on a plate stands; nothing is touched."""

    test: ClassVar[Kind] = "plane"
    shape: ClassVar[ArtefactShape] = "plane"
    quantities: ClassVar[tuple[Quantity, ...]] = ("plane-scan",)
    between: ClassVar[tuple[str, ...]] = ("plate",)
    first: ClassVar[tuple[str, ...]] = ("plate",)
    scanning: ClassVar[tuple[str, ...]] = ("plate",)

    @property
    def feature(self) -> str:
        return ""

    @property
    def of_step(self) -> tuple[SphereContact, ...]:
        return ()

    @property
    def wanted(self) -> int:
        return 0

    @property
    def plate_scans(self) -> tuple[PlateScan, ...]:
        """Scans of the plate, those set aside, too."""
        return tuple(scan for scan in self.scans if isinstance(scan, PlateScan))

    def scan_of_row(self, payload: Payload, number: int) -> PlateScan:
        return PlateScan(number=number, at=payload["at"], orientation=payload["orientation"])

    def scan_values(self, payload: Payload) -> Payload:
        return {name: payload[name] for name in ("points", "width_mm", "dispersion_um", "turn_deg")}

    @property
    def orientation(self) -> int:
        done = {scan.orientation for scan in self.plate_scans if scan.good}
        left = (number for number in range(1, ORIENTATIONS + 1) if number not in done)
        return next(left, 0)


def _scan_plate(guide: PerformanceGuide, operator: SimulatedOperator, progress: Progress) -> None:
    refused = 0
    while (orientation := guide.state_of(PlaneState).orientation) and refused < SCAN_ATTEMPTS:
        text = message("performance-simulation-scans-plate", number=orientation)
        progress(text, (orientation - 1) / ORIENTATIONS)
        sweep = partial(operator.scan_plate, orientation)
        if not scan_once(guide, {"orientation": orientation}, sweep, progress):
            return
        refused = refused + 1 if guide.state_of(PlaneState).orientation == orientation else 0
    confirm(guide)


class PlaneKind(PerformanceKind[PerformanceGuide, PlaneState, PlateScan, None]):
    """The test on a plate."""

    state = PlaneState
    evaluation = PlaneEvaluation()

    titles: ClassVar[Mapping[str, Text]] = {"plate": message("performance-step-plate")}
    work: ClassVar[Mapping[str, StepWork[PerformanceGuide]]] = {"plate": _scan_plate}

    def know(self, guide: PerformanceGuide) -> None:
        return None

    def title(self, state: PlaneState) -> Text:
        scanned = state.step == "plate" and state.orientation
        return orientation_title(state.orientation) if scanned else ""

    def instruction(self, state: PlaneState, live: PerformanceLive[None]) -> Text:
        if state.open_scan is not None:
            return message("performance-pass-over-plate")
        if not state.orientation:
            return message("performance-plate-scanned")
        return message("performance-scan-plate", number=state.orientation)

    def progress(self, state: PlaneState) -> StepProgress | None:
        done = sum(scan.good for scan in state.plate_scans)
        text = message("performance-plate-scans-done", done=done, of=ORIENTATIONS)
        return StepProgress(done, ORIENTATIONS, text)

    def lines(self, state: PlaneState, live: PerformanceLive[None]) -> list[ArticulationLine]:
        return [_line(state, number) for number in NUMBERS if state.step == "plate"]

    def findings(self, state: PlaneState, live: PerformanceLive[None]) -> list[Finding]:
        """Why the last scan of the present orientation is of no use."""
        last = _last_scan(state, state.orientation) if state.step == "plate" else None
        if last is None or last.refused is None:
            return []
        error = error_from_payload(last.refused)
        return [Finding("attention", error.reason, sentence(error.remedy))]

    def confirm_reason(self, state: PlaneState) -> Text:
        missing = message("performance-orientation-missing") if state.orientation else ""
        return open_scan_reason(state) or missing

    def begin_scan_reason(self, state: PlaneState, args: Args) -> Text:
        done = args.get("orientation") is None and not state.orientation
        return message("performance-plate-scanned") if done else ""

    def is_scan_left(self, state: PlaneState) -> bool:
        return state.orientation > 0

    def scans_again(self, state: PlaneState) -> list[tuple[Text, Args]]:
        label = message("performance-scan-plate-again")
        return [(label, {"orientation": number}) for number in NUMBERS]

    def begin_scan(self, guide: PerformanceGuide, args: Args, key: str | None) -> None:
        """The first scan of the test freezes its plan."""
        wanted = args.get("orientation")
        orientation = wanted if isinstance(wanted, int) else guide.state_of(PlaneState).orientation
        if not guide.state.frozen:
            guide.freeze()
        title = message("performance-plate-scan-name", number=orientation)
        guide.record_scan(plane_scan(orientation), title)
        guide.append("scan_begun", {"orientation": orientation}, key)

    def measure_scan(self, guide: PerformanceGuide, scan: PlateScan) -> Payload:
        """What it shows, beside the good scan of the other orientation."""
        with guide.lock:
            arm, scans = guide.arm(), guide.state_of(PlaneState).plate_scans
        if arm is None:
            raise OperationError(
                "datasheets-unreadable", message("sessions-gauge-arm-cannot-read-any")
            )
        others = [one for one in scans if one.good and one.orientation != scan.orientation]
        other = guide.read_cloud(others[-1], arm).R_arm_sensor if others else None
        return measure_plate(guide.read_cloud(scan, arm), guide.plan().gate.shell_mm, other)

    def measuring_text(self, guide: PerformanceGuide, scan: PlateScan) -> Text:
        return message("performance-measuring-plate-scan", number=scan.orientation)

    def scan_title(self, scan: PlateScan) -> Text:
        return message("performance-plate-run", number=scan.orientation)

    def scan_text(self, scan: PlateScan) -> Text:
        return message("performance-plate-scan-done", number=scan.orientation)


def orientation_title(number: int) -> Text:
    """How the sensor is held over the plate."""
    return message("performance-orientation", number=number)


def _line(state: PlaneState, number: int) -> ArticulationLine:
    title, last = orientation_title(number), _last_scan(state, number)
    text: Text = ""
    if last is None:
        shown: ArticulationState = "now" if number == state.orientation else "todo"
    elif last.refused is not None:
        shown, text = "refused", error_from_payload(last.refused).reason
    elif last.good:
        shown = "done"
        text = join(
            [
                message("performance-plate-form", form=quantity(last.dispersion_um, "µm", 1)),
                message("performance-plate-width", width=quantity(last.width_mm, "mm")),
            ]
        )
    else:
        shown = "measuring" if last.ended else "scanning"
    return ArticulationLine(number, title, shown, text)


def _last_scan(state: PlaneState, number: int) -> PlateScan | None:
    found = [one for one in state.plate_scans if one.orientation == number and not one.aside]
    return found[-1] if found else None


def measure_plate(cloud: ScanCloud, shell_mm: float, other: Floats | None) -> Payload:
    """What a scan of the plate shows, as its row has it.

    Args:
        other: (3, 3) orientation of the sensor in the scan of the other orientation; None before
            there is one.

    Raises:
        OperationError: it shows too little of the plate, or the sensor was held as in the other.
    """
    found = measure_plate_scan(cloud, shell_mm)
    turn_deg = None if other is None else turn_between_deg(other, found.R_arm_sensor)
    if turn_deg is not None and turn_deg < LEAST_TURN_DEG:
        raise OperationError(
            "orientations-alike",
            orientations_alike(turn_deg),
            remedy=message("performance-turn-sensor"),
        )
    return {
        "points": len(found.points_mm),
        "width_mm": found.width_mm,
        "dispersion_um": found.dispersion_um,
        "turn_deg": turn_deg,
    }
