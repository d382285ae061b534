"""The one-sphere test: what is said, shown and asked in its steps. Pure."""

from collections.abc import Mapping
from dataclasses import replace
from typing import ClassVar, TypeAlias

from crenel.errors import sentence
from crenel.findings import Finding
from crenel.gauges.guide import PerformanceGuide
from crenel.gauges.guide_view import ArticulationLine, PerformancePicture
from crenel.gauges.plan.document import ARTICULATIONS
from crenel.gauges.plan.document_gauge import GaugeFile
from crenel.gauges.plan.evaluate_artefacts import unknown_form
from crenel.gauges.session.changes import Payload
from crenel.gauges.session.kind import PerformanceKind, PerformanceLive, open_scan_reason
from crenel.gauges.sphere.evaluate_sphere import SphereEvaluation
from crenel.gauges.sphere.guide_picture import (
    articulation_title,
    missing_patches,
    patch_marks,
    place_marks,
    scan_line,
    touch_line,
)
from crenel.gauges.sphere.guide_places import find_touched_place
from crenel.gauges.sphere.guide_scans import (
    SphereKnown,
    begin_sphere_scan,
    measure_sphere_scan,
    part_places,
    sphere_centre_mm,
    sphere_known,
)
from crenel.gauges.sphere.guide_simulation import SPHERE_WORK
from crenel.gauges.sphere.guide_state import SphereScan, SphereState
from crenel.gauges.sphere.maths_articulation import HELD_DEG
from crenel.guide.common.arguments import Args
from crenel.guide.common.journal import error_from_payload
from crenel.guide.common.view import StepProgress
from crenel.messages.message import Text, message, quantity
from crenel.metrology.arm.kinematics import AnyArm
from crenel.metrology.transforms import Floats

Live: TypeAlias = PerformanceLive[SphereKnown]
NUMBERS = range(1, ARTICULATIONS + 1)


class SphereKind(PerformanceKind[PerformanceGuide, SphereState, SphereScan, SphereKnown]):
    """The one-sphere test."""

    state = SphereState
    evaluation = SphereEvaluation()
    work = SPHERE_WORK

    titles: ClassVar[Mapping[str, Text]] = {
        "pattern": message("performance-step-pattern"),
        "location": message("performance-step-location"),
        "scan": message("performance-step-scan"),
        "end": message("performance-step-end"),
    }

    def know(self, guide: PerformanceGuide) -> SphereKnown:
        return sphere_known(guide)

    def title(self, state: SphereState) -> Text:
        articulated = state.step in ("location", "scan") and state.articulation
        return articulation_title(state.articulation) if articulated else ""

    def instruction(self, state: SphereState, live: Live) -> Text:
        if state.step == "pattern":
            if state.of_step:
                return message("performance-touch-pattern")
            if state.position > 1:
                return message("performance-move-sphere")
            return message("performance-touch-top-first")
        if state.step == "location":
            return message("performance-touch-location", number=state.articulation)
        if state.step == "end":
            return message("performance-do-end")
        if state.open_scan is not None:
            return message("performance-pass-slowly")
        if not state.articulation:
            return message("performance-all-scanned")
        return message("performance-hold-sensor", number=state.articulation)

    def progress(self, state: SphereState) -> StepProgress | None:
        if state.step != "scan":
            return super().progress(state)
        done = sum(state.scan_of(number) is not None for number in NUMBERS)
        text = message("performance-scans-done", done=done, of=ARTICULATIONS)
        return StepProgress(done, ARTICULATIONS, text)

    def lines(self, state: SphereState, live: Live) -> list[ArticulationLine]:
        if state.step == "location":
            return [touch_line(state, number) for number in NUMBERS]
        return [scan_line(state, live.known, number) for number in NUMBERS if state.step == "scan"]

    def draw(
        self, picture: PerformancePicture, state: SphereState, live: Live
    ) -> PerformancePicture:
        known = live.known
        return replace(
            picture,
            places=place_marks(known),
            tip_deg=None if known.places is None else known.places.tip_flat_deg,
            patches=patch_marks(state, known) if state.step == "scan" else [],
        )

    def artefact_findings(self, state: SphereState, live: Live) -> list[Finding]:
        sphere = live.artefact
        if not isinstance(sphere, GaugeFile):
            return []
        unknown = unknown_form(sphere, sphere.name or state.gauge)
        return [Finding("attention", sentence(unknown))] if unknown else []

    def findings(self, state: SphereState, live: Live) -> list[Finding]:
        findings: list[Finding] = []
        off_deg = live.known.off_deg
        if off_deg is not None and off_deg > HELD_DEG:
            findings.append(_about_articulation(off_deg, state.step))
        return findings + (_about_scans(state) if state.step == "scan" else [])

    def confirm_reason(self, state: SphereState) -> Text:
        if state.step != "scan":
            return super().confirm_reason(state)
        if reason := open_scan_reason(state):
            return reason
        if state.articulation:
            left = sum(state.scan_of(number) is None for number in NUMBERS)
            return message("performance-articulations-missing", missing=left)
        missing = missing_patches(state)
        if missing:
            return message("patches-not-covered", patches=", ".join(map(str, missing)))
        return ""

    def begin_scan_reason(self, state: SphereState, args: Args) -> Text:
        done = args.get("articulation") is None and not state.articulation
        return message("performance-all-scanned") if done else ""

    def is_scan_left(self, state: SphereState) -> bool:
        return state.articulation > 0

    def scans_again(self, state: SphereState) -> list[tuple[Text, Args]]:
        return [
            (message("performance-repeat-scan", number=number), {"articulation": number})
            for number in NUMBERS
        ]

    def place_of(self, guide: PerformanceGuide, arm: AnyArm, reading: Floats) -> int:
        part, centre = part_places(guide), sphere_centre_mm(guide)
        if part is None:
            return super().place_of(guide, arm, reading)
        if centre is None:
            return 0  # the first touch finds the sphere
        state = guide.state_of(SphereState)
        return find_touched_place(state, part, centre, guide.gauge(), arm, reading)

    def begin_scan(self, guide: PerformanceGuide, args: Args, key: str | None) -> None:
        begin_sphere_scan(guide, args, key)

    def measure_scan(self, guide: PerformanceGuide, scan: SphereScan) -> Payload:
        return measure_sphere_scan(guide, scan)

    def measuring_text(self, guide: PerformanceGuide, scan: SphereScan) -> Text:
        return message("performance-measuring-scan", articulation=scan.articulation)

    def scan_title(self, scan: SphereScan) -> Text:
        return message("performance-run", position=scan.position, articulation=scan.articulation)

    def scan_text(self, scan: SphereScan) -> Text:
        return message("performance-scan-done", articulation=scan.articulation)


def _about_articulation(off_deg: float, step: str) -> Finding:
    off, most = quantity(off_deg, "°"), quantity(HELD_DEG, "°")
    if step == "location":
        text = message("performance-stylus-off-articulation", off=off, most=most)
    else:
        text = message("performance-camera-off-articulation", off=off, most=most)
    return Finding("attention", text, message("performance-turn-towards-articulation"))


def _about_scans(state: SphereState) -> list[Finding]:
    findings: list[Finding] = []
    last = state.here[-1] if state.here else None
    if last is not None and last.refused is not None and not last.aside:
        error = error_from_payload(last.refused)
        findings.append(Finding("attention", error.reason, sentence(error.remedy)))
    missing = missing_patches(state)
    if missing and any(scan.good for scan in state.here) and not state.articulation:
        text = message("patches-not-covered", patches=", ".join(map(str, missing)))
        remedy = message("performance-scan-missing")
        findings.append(Finding("attention", sentence(text), remedy))
    return findings
