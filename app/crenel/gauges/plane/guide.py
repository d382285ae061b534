"""The test on a plate: what is said, shown and asked of its scans in two orientations."""

from collections.abc import Mapping
from typing import ClassVar

from crenel.errors import sentence
from crenel.findings import Finding
from crenel.gauges.guide_live import PerformanceLive
from crenel.gauges.guide_view import ArticulationLine, ArticulationState
from crenel.gauges.plan.document import ORIENTATIONS
from crenel.gauges.plane.guide_state import PlaneState
from crenel.gauges.session.entries import PlateScan
from crenel.gauges.session.kind import PerformanceKind, open_scan_reason
from crenel.guide.common.arguments import Args
from crenel.guide.common.journal import error_from_payload
from crenel.guide.common.view import StepProgress
from crenel.messages.message import Text, join, message, quantity

NUMBERS = range(1, ORIENTATIONS + 1)


class PlaneKind(PerformanceKind[PlaneState, PlateScan]):
    """The test on a plate."""

    titles: ClassVar[Mapping[str, Text]] = {"plate": message("performance-step-plate")}

    def title(self, state: PlaneState) -> Text:
        scanned = state.step == "plate" and state.orientation
        return orientation_title(state.orientation) if scanned else ""

    def instruction(self, state: PlaneState, live: PerformanceLive) -> Text:
        if state.open_scan is not None:
            return message("performance-pass-over-plate")
        if not state.orientation:
            return message("performance-plate-scanned")
        return message("performance-scan-plate", number=state.orientation)

    def progress(self, state: PlaneState) -> StepProgress | None:
        done = sum(scan.good for scan in state.plate_scans)
        text = message("performance-plate-scans-done", done=done, of=ORIENTATIONS)
        return StepProgress(done, ORIENTATIONS, text)

    def lines(self, state: PlaneState, live: PerformanceLive) -> list[ArticulationLine]:
        return [_line(state, number) for number in NUMBERS if state.step == "plate"]

    def findings(self, state: PlaneState, live: PerformanceLive) -> list[Finding]:
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
