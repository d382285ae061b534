"""The length test: what is said, shown and asked in its step, its touches and its scans."""

from collections.abc import Mapping
from dataclasses import replace
from typing import ClassVar, TypeAlias

from crenel.errors import OperationError, sentence
from crenel.findings import Finding
from crenel.gauges.guide import PerformanceGuide
from crenel.gauges.guide_plan import measures_by_scan
from crenel.gauges.guide_view import PerformancePicture
from crenel.gauges.length.evaluate import LengthEvaluation
from crenel.gauges.length.evaluate_scans import lengths_in_scan
from crenel.gauges.length.guide_picture import (
    last_error,
    length_findings,
    length_instruction,
    length_progress,
    lengths_picture,
)
from crenel.gauges.length.guide_scan_lines import (
    bar_pass_reason,
    bar_scan_findings,
    find_bar_pass,
    pass_title,
)
from crenel.gauges.length.guide_sequence import BarScan
from crenel.gauges.length.guide_simulation import LENGTH_WORK
from crenel.gauges.length.guide_so_far import (
    LengthsSoFar,
    check_touch,
    lengths_so_far,
    touches_on_end,
)
from crenel.gauges.length.guide_state import LengthState
from crenel.gauges.plan.document_length_standard import LengthStandardFile
from crenel.gauges.plan.maths_lengths import LENGTHS
from crenel.gauges.session.changes import Payload
from crenel.gauges.session.kind import PerformanceKind, PerformanceLive
from crenel.guide.common.arguments import Args
from crenel.guide.common.view import LiveNumber, StepProgress
from crenel.messages.message import Text, message
from crenel.metrology.arm.kinematics import AnyArm
from crenel.metrology.transforms import Floats

Live: TypeAlias = PerformanceLive[LengthsSoFar | None]


class LengthKind(PerformanceKind[PerformanceGuide, LengthState, BarScan, LengthsSoFar | None]):
    """The length test."""

    state = LengthState
    evaluation = LengthEvaluation()
    work = LENGTH_WORK

    titles: ClassVar[Mapping[str, Text]] = {"lengths": message("performance-step-lengths")}

    def know(self, guide: PerformanceGuide) -> LengthsSoFar | None:
        return lengths_so_far(guide)

    def begin_payload(self, guide: PerformanceGuide) -> Payload:
        standard = guide.standard()
        if standard is None:
            return {}
        return {
            "lengths": len(standard.lengths),
            "touches_each": touches_on_end(standard),
            "by_scan": measures_by_scan(guide.state, standard),
        }

    def title(self, state: LengthState) -> Text:
        return message("performance-place-title", number=state.place) if state.place else ""

    def instruction(self, state: LengthState, live: Live) -> Text:
        return length_instruction(state, live.known)

    def number(self, state: LengthState, live: Live) -> LiveNumber | None:
        return last_error(live.known) if state.step == "lengths" else None

    def progress(self, state: LengthState) -> StepProgress | None:
        if state.sequence is None:
            return super().progress(state)
        return length_progress(state, state.sequence)

    def draw(
        self, picture: PerformancePicture, state: LengthState, live: Live
    ) -> PerformancePicture:
        if live.known is None:
            return picture
        return replace(picture, lengths=lengths_picture(state, live.known))

    def artefact_findings(self, state: LengthState, live: Live) -> list[Finding]:
        standard = live.artefact
        if not isinstance(standard, LengthStandardFile) or len(standard.lengths) >= LENGTHS:
            return []
        text = message("performance-fewer-lengths", count=len(standard.lengths))
        return [Finding("attention", sentence(text))]

    def findings(self, state: LengthState, live: Live) -> list[Finding]:
        if state.step != "lengths":
            return []
        return [*length_findings(live.known), *bar_scan_findings(state)]

    def confirm_reason(self, state: LengthState) -> Text:
        if state.due is not None:
            return message("performance-scan-bar-first")
        return super().confirm_reason(state)

    def begin_scan_reason(self, state: LengthState, args: Args) -> Text:
        return bar_pass_reason(state, args)

    def place_of(self, guide: PerformanceGuide, arm: AnyArm, reading: Floats) -> int:
        standard = guide.standard()
        if standard is None:
            return super().place_of(guide, arm, reading)
        return check_touch(guide.state_of(LengthState), standard, arm, reading)

    def begin_scan(self, guide: PerformanceGuide, args: Args, key: str | None) -> None:
        of = find_bar_pass(guide.state_of(LengthState), args)
        assert of is not None
        title = message("performance-bar-scan-name", place=of.place, repeat=of.repeat)
        guide.record_scan(of.name, title)
        payload = {"place": of.place, "repeat": of.repeat, "length": of.length}
        guide.append("scan_begun", payload, key)

    def measure_scan(self, guide: PerformanceGuide, scan: BarScan) -> Payload:
        """The lengths of a scan, and those that need a scan of their own, by their numbers."""
        with guide.lock:
            arm, standard = guide.arm(), guide.standard()
        if arm is None or standard is None:
            raise OperationError(
                "datasheets-unreadable", message("sessions-gauge-arm-cannot-read-any")
            )
        numbers = [scan.of.length] if scan.of.length else range(1, len(standard.lengths) + 1)
        cloud = guide.read_cloud(scan, arm)
        found = lengths_in_scan(standard, cloud, guide.plan().gate.gate, numbers)
        # the spheres of a single length are scanned by themselves already
        apart = bool(scan.of.length)
        for one in found:
            if one.measured_mm is None and (apart or not one.is_ambiguous):
                raise OperationError(
                    "length-not-scanned", one.problem, remedy=message("performance-scan-bar-again")
                )
        return {
            "lengths": [
                [one.number, one.measured_mm] for one in found if one.measured_mm is not None
            ],
            "alone": [one.number for one in found if one.measured_mm is None],
        }

    def measuring_text(self, guide: PerformanceGuide, scan: BarScan) -> Text:
        title = pass_title(scan.of, lengths_so_far(guide))
        return message("performance-measuring-bar-scan", scan=title)

    def scan_title(self, scan: BarScan) -> Text:
        return message("performance-bar-run", place=scan.of.place, repeat=scan.of.repeat)

    def scan_text(self, scan: BarScan) -> Text:
        return message("performance-bar-scan-done", place=scan.of.place, repeat=scan.of.repeat)
