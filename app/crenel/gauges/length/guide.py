"""The length test: what is said, shown and asked in its step. Pure."""

from collections.abc import Mapping
from dataclasses import replace
from typing import ClassVar

from crenel.errors import sentence
from crenel.findings import Finding
from crenel.gauges.guide_live import PerformanceLive
from crenel.gauges.guide_view import PerformancePicture
from crenel.gauges.length.guide_picture import (
    last_error,
    length_findings,
    length_instruction,
    length_progress,
    lengths_picture,
)
from crenel.gauges.length.guide_scan_lines import bar_scan_findings
from crenel.gauges.length.guide_scan_rules import bar_pass_reason
from crenel.gauges.length.guide_state import LengthState
from crenel.gauges.plan.document_length_standard import LengthStandardFile
from crenel.gauges.plan.maths_lengths import LENGTHS
from crenel.gauges.session.entries import BarScan
from crenel.gauges.session.kind import PerformanceKind
from crenel.guide.common.arguments import Args
from crenel.guide.common.view import LiveNumber, StepProgress
from crenel.messages.message import Text, message


class LengthKind(PerformanceKind[LengthState, BarScan]):
    """The length test."""

    titles: ClassVar[Mapping[str, Text]] = {"lengths": message("performance-step-lengths")}

    def title(self, state: LengthState) -> Text:
        return message("performance-place-title", number=state.place) if state.place else ""

    def instruction(self, state: LengthState, live: PerformanceLive) -> Text:
        return length_instruction(state, live.lengths)

    def number(self, state: LengthState, live: PerformanceLive) -> LiveNumber | None:
        return last_error(live.lengths) if state.step == "lengths" else None

    def progress(self, state: LengthState) -> StepProgress | None:
        if state.sequence is None:
            return super().progress(state)
        return length_progress(state, state.sequence)

    def draw(
        self, picture: PerformancePicture, state: LengthState, live: PerformanceLive
    ) -> PerformancePicture:
        if live.lengths is None:
            return picture
        return replace(picture, lengths=lengths_picture(state, live.lengths))

    def artefact_findings(self, state: LengthState, live: PerformanceLive) -> list[Finding]:
        standard = live.artefact
        if not isinstance(standard, LengthStandardFile) or len(standard.lengths) >= LENGTHS:
            return []
        text = message("performance-fewer-lengths", count=len(standard.lengths))
        return [Finding("attention", sentence(text))]

    def findings(self, state: LengthState, live: PerformanceLive) -> list[Finding]:
        if state.step != "lengths":
            return []
        return [*length_findings(live.lengths), *bar_scan_findings(state)]

    def confirm_reason(self, state: LengthState) -> Text:
        if state.due is not None:
            return message("performance-scan-bar-first")
        return super().confirm_reason(state)

    def begin_scan_reason(self, state: LengthState, args: Args) -> Text:
        return bar_pass_reason(state, args)

    def scan_title(self, scan: BarScan) -> Text:
        return message("performance-bar-run", place=scan.of.place, repeat=scan.of.repeat)

    def scan_text(self, scan: BarScan) -> Text:
        return message("performance-bar-scan-done", place=scan.of.place, repeat=scan.of.repeat)
