"""The guides of a station, and which of them a press of the arm's button belongs to."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any

from crenel.gauges.guide import PerformanceGuide, PerformanceServices
from crenel.gauges.guide_commands import COMMANDS as PERFORMANCE_COMMANDS
from crenel.gauges.kinds import KINDS
from crenel.gauges.quick.guide.commands import COMMANDS as VERIFICATION_COMMANDS
from crenel.gauges.quick.guide.guide import VerifyGuide
from crenel.gauges.session.gauge_session import GaugeServices
from crenel.guide.arm.commands import COMMANDS as ARM_COMMANDS
from crenel.guide.arm.guide import ArmGuide
from crenel.guide.calibration.commands import COMMANDS as CALIBRATION_COMMANDS
from crenel.guide.calibration.guide import CalibrationGuide, CalibrationServices
from crenel.guide.common.buttons import Press
from crenel.guide.common.guided_session import GuidedSession, Provenance, StationServices
from crenel.messages.message import Text, message
from crenel.operations.home import last_tip_finding
from crenel.parts.session.commands import COMMANDS as PART_COMMANDS
from crenel.parts.session.guide import PartGuide
from crenel.server.live_station import LiveStation
from crenel.server.station_parts import StationParts
from crenel.station.activity import Activities, ActivityKind
from crenel.store.store import Store


@dataclass(frozen=True)
class StationGuides:
    """One guide for each kind of session."""

    calibration: CalibrationGuide
    arm: ArmGuide
    verify: VerifyGuide
    performance: PerformanceGuide
    part: PartGuide

    @property
    def by_activity(self) -> Mapping[ActivityKind, GuidedSession[Any, Any, Any]]:
        return {
            "calibration": self.calibration,
            "arm": self.arm,
            "verification": self.verify,
            "performance": self.performance,
            "inspection": self.part,
        }

    def name_open(self) -> Text:
        """That a session is open, and on which page; empty if none is."""
        kinds = (kind for kind, session in self.by_activity.items() if session.running)
        kind = next(kinds, None)
        return "" if kind is None else message("guided-session-is-open", kind=kind)

    def any_simulated(self) -> bool:
        """Whether the simulated operator works in a session."""
        return any(one.simulation_running for one in self.by_activity.values())

    def share_arm(self, activities: Activities) -> None:
        """One session has the arm at a time; of several that a restart found open, the one that
        was used last."""
        for kind, session in self.by_activity.items():
            activities.add(kind, partial(getattr, session, "running"))
            session.use_arm = partial(activities.using, kind)
        last_first = sorted(self.by_activity.items(), key=lambda one: -one[1].state.rev)
        for kind, session in last_first:
            if session.running:
                activities.resume(kind, session.started_at)

    def note_datasheets(self) -> None:
        """Every session goes by the datasheets, which have been changed."""
        for session in self.by_activity.values():
            session.note_datasheets()

    def press(self, event: Press) -> None:
        """A press belongs to the open session that waits for it and was used last."""
        sessions: list[tuple[int, Callable[[], bool]]] = [
            (
                self.calibration.state.rev,
                lambda: CALIBRATION_COMMANDS.press(self.calibration, event),
            ),
            (self.verify.state.rev, lambda: VERIFICATION_COMMANDS.press(self.verify, event)),
            (
                self.performance.state.rev,
                lambda: PERFORMANCE_COMMANDS.press(self.performance, event),
            ),
            (self.part.state.rev, lambda: PART_COMMANDS.press(self.part, event)),
            (self.arm.state.rev, lambda: ARM_COMMANDS.press(self.arm, event)),
        ]
        for _, takes in sorted(sessions, key=lambda one: one[0], reverse=True):
            if takes():
                return


def open_guides(
    parts: StationParts,
    store: Store,
    live: LiveStation,
    provenance: Provenance,
    on_calibrated: Callable[[], None],
) -> StationGuides:
    """The guides, each at the step where its last session stands.

    Args:
        on_calibrated: called when a calibration session ends.
    """
    shared = live.bus, live.rig, live.jobs, parts.simulated_operator
    calibration = CalibrationGuide(
        CalibrationServices(*shared, live.preview, live.scene),
        store.journal,
        store.calibrations,
        store.folder,
        on_calibrated,
        parts.limits,
        provenance,
        parts.rule,
    )
    arm = ArmGuide(StationServices(*shared), store.journal, store.folder, provenance, parts.rule)
    calibration.tip = lambda: last_tip_finding(arm, parts.due)
    verify = VerifyGuide(
        GaugeServices(*shared, live.scanner, live.scene),
        store.journal,
        store.calibrations,
        store.verifications,
        store.folder,
        parts.verification,
        provenance,
        parts.rule,
    )
    performance = PerformanceGuide(
        KINDS,
        PerformanceServices(
            *shared,
            live.scanner,
            live.scene,
            lambda: live.settings.settings.model_dump(mode="json"),
        ),
        store.journal,
        store.calibrations,
        store.performances,
        store.folder,
        provenance,
        parts.rule,
        parts.temperature_limits,
    )
    part = PartGuide(
        GaugeServices(*shared, live.scanner, live.scene),
        store.journal,
        store.calibrations,
        store.inspections,
        store.folder,
        provenance,
        parts.rule,
    )
    return StationGuides(calibration, arm, verify, performance, part)
