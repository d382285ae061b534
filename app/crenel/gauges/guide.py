"""The one performance test of a station: its journal, its touches and scans, and what is shown."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Protocol, TypeVar

import numpy as np

from crenel.errors import OperationError
from crenel.formats.atomic_write import sync_file, sync_folder
from crenel.formats.io_errors import convert_io_errors
from crenel.formats.json_document import file_sha256
from crenel.formats.results.calibration import Calibration
from crenel.gauges.contact.guide_so_far import ContactSoFar, measure_contact_so_far
from crenel.gauges.contact.guide_state import ContactState
from crenel.gauges.contact.guide_touches import check_contact
from crenel.gauges.guide_flow import build_view, gauge_options
from crenel.gauges.guide_live import PerformanceLive, Places
from crenel.gauges.guide_plan import build_plan
from crenel.gauges.guide_rules import RULES
from crenel.gauges.guide_state import STATES, apply_row
from crenel.gauges.guide_view import ArtefactOption, PerformanceView
from crenel.gauges.judgement.document import PerformanceFile, read_performance
from crenel.gauges.judgement.evaluate_measured_data import RECORDING, ScanCloud, read_scan
from crenel.gauges.length.guide_so_far import LengthsSoFar, check_touch, measure_so_far
from crenel.gauges.length.guide_state import LengthState
from crenel.gauges.plan.document import PLAN, TOUCHES, Kind, PerformancePlan, read_station_limits
from crenel.gauges.plan.maths_temperature import TEMPERATURE_LIMITS, TemperatureLimits
from crenel.gauges.session.artefacts import ArtefactSession
from crenel.gauges.session.entries import AnyScan
from crenel.gauges.session.gauge_session import GaugeServices, Memo
from crenel.gauges.session.gauges import bars_of, gauges_of_test
from crenel.gauges.session.state import PerformanceState
from crenel.gauges.sphere.guide_coverage import LiveCoverage
from crenel.gauges.sphere.guide_places import (
    PartPlaces,
    find_touched_place,
    flat_pattern,
    live_places,
    off_articulation_deg,
    places_of,
    sphere_centre_of,
)
from crenel.gauges.sphere.guide_state import SphereState
from crenel.guide.common.flow import Flow
from crenel.guide.common.guided_session import (
    NO_PROVENANCE,
    Provenance,
    new_session_id,
)
from crenel.guide.common.journal import (
    Calibrations,
    Check,
    Journal,
    JournalEntry,
)
from crenel.messages.message import message
from crenel.metrology.arm.kinematics import AnyArm
from crenel.metrology.decision import GUARDED_95, DecisionRule
from crenel.metrology.transforms import Floats

KIND = "performance"
OneState = TypeVar("OneState", bound=PerformanceState)
FLOW: Flow[PerformanceState, PerformanceLive, PerformanceView] = Flow(
    KIND, KIND, SphereState(), apply_row, build_view, RULES
)


@dataclass(frozen=True)
class PerformanceServices(GaugeServices):
    """The station's parts that a performance test works with."""

    scan_setup: Callable[[], Mapping[str, object]]
    """The settings of scans as they are now."""


class Performances(Protocol):
    """Where tests are listed."""

    def close(
        self,
        session_id: str,
        kind: str,
        payload: Mapping[str, object],
        calibration_id: str,
        folder: Path,
        figures: Mapping[str, Any],
        key: str | None,
        check: Check,
    ) -> JournalEntry: ...


class PerformanceGuide(ArtefactSession[PerformanceLive, PerformanceView]):
    """The latest performance test."""

    station: PerformanceServices

    def __init__(
        self,
        station: PerformanceServices,
        journal: Journal,
        calibrations: Calibrations,
        performances: Performances,
        data_folder: Path,
        signing: Provenance = NO_PROVENANCE,
        rule: DecisionRule = GUARDED_95,
        temperature_limits: TemperatureLimits = TEMPERATURE_LIMITS,
    ) -> None:
        super().__init__(station, journal, FLOW, calibrations, data_folder, signing, rule)
        self.performances = performances
        self.temperature_limits = temperature_limits
        self.coverage = LiveCoverage()
        self._lengths, self._contact = Memo[LengthsSoFar](), Memo[ContactSoFar]()
        self._result, self._calibration = Memo[PerformanceFile](), Memo[Calibration]()
        self._centre = Memo[Floats | None]()
        self.resume()

    @property
    def folder(self) -> Path:
        """The present session's folder."""
        return self.data_folder / "performance" / self.state.session_id

    def state_of(self, kind: type[OneState]) -> OneState:
        """The state of a test of a kind."""
        assert isinstance(self.state, kind)
        return self.state

    # -- what is shown -------------------------------------------------------

    def live(self) -> PerformanceLive:
        """The station as the session sees it."""
        station, state = self.station, self.state
        side, active = station.rig.arm, self.active()
        stillness = side.stillness()
        gauges, bars, artefacts = self.gauges(), self.bars(), self.artefacts()
        blocked = station.scanner.why_not() if state.in_scan or state.whole_place else None
        return PerformanceLive(
            active_id=active.id if active else "",
            active_name=active.name if active else "",
            gauges=gauges,
            bars=bars,
            artefacts=tuple(artefacts.values()),
            artefact_problems=tuple(
                problem
                for name, artefact in artefacts.items()
                for problem in self.problems_of(name, artefact, state.test)
            ),
            obstacles={
                **self.obstacles_of(gauges, state.test),
                **self.obstacles_of(bars, state.test),
            },
            setup_now=station.scan_setup(),
            plan_changed=self.running and state.frozen and self._is_plan_changed(),
            arm=self.arm(),
            places=self._live_places(),
            lengths=self.lengths(),
            contact=self.contact(),
            temperature_limits=self.temperature_limits,
            pattern_flat_deg=flat_pattern(self.centre_mm()),
            result=self.result(),
            arm_link=side.link(),
            sensor_link=station.rig.sensor.link(),
            still=stillness.still,
            strain=stillness.strain,
            off_deg=self._off_deg(),
            scan_why_not=blocked.text if blocked else "",
            scan_points=station.scanner.state().points if state.open_scan else 0,
            seen=self.coverage.counts(state) if isinstance(state, SphereState) else None,
            has_simulation=station.simulated_operator is not None,
            simulation_running=self.simulation_running,
            busy=self.busy,
            trouble=self._trouble,
        )

    def plan(self) -> PerformancePlan:
        """The plan as it would be frozen now; an artefact must be chosen."""
        return build_plan(
            self.state,
            self.gauge() or self.standard(),
            self.provenance,
            self.rule,
            self.temperature_limits,
            self.bar(),
        )

    def result(self) -> PerformanceFile | None:
        """What the test found; None before it was evaluated, or if it cannot be read."""
        state = self.state
        if not state.result:
            self._result.forget()
            return None
        try:
            return self._result.get(state.session_id, lambda: read_performance(self.folder))
        except OperationError:
            return None

    def centre_mm(self) -> Floats | None:
        """(3,) of the sphere at this position, by the touches of its pattern; None before the
        first. Fitted once for each state."""
        state, gauge, arm = self.state, self.gauge(), self.arm()
        if not isinstance(state, SphereState) or arm is None or gauge is None:
            return None
        return self._centre.get(state, lambda: sphere_centre_of(state, arm, gauge))

    def part_places(self) -> PartPlaces | None:
        """The places of the part of the test that is touched now; None if there is none."""
        state = self.state
        return places_of(state, self.centre_mm()) if isinstance(state, SphereState) else None

    def _off_deg(self) -> float | None:
        """How far stylus or camera is from the direction of the present articulation."""
        state, newest = self.state, self.station.rig.arm.latest()
        arm, centre = self.arm(), self.centre_mm()
        if not isinstance(state, SphereState) or newest is None or arm is None or centre is None:
            return None
        return off_articulation_deg(
            state, arm, np.array(newest.reading), centre, self._calibration_in_use()
        )

    def _calibration_in_use(self) -> Calibration | None:
        """The session's own copy, read once; None if it cannot be read."""
        try:
            return self._calibration.get(self.state.session_id, self.calibration)
        except OperationError:
            return None

    def _live_places(self) -> Places | None:
        state, part, centre = self.state, self.part_places(), self.centre_mm()
        if not isinstance(state, SphereState) or part is None:
            return None
        tip = self.station.rig.arm.tip_mm() if centre is not None else None
        return live_places(state, part, centre, None if tip is None else np.array(tip))

    def lengths(self) -> LengthsSoFar | None:
        """What is known of a length test; None of another, and before its standard was confirmed.
        Computed once for each state."""
        state, standard, arm = self.state, self.standard(), self.arm()
        if not isinstance(state, LengthState) or standard is None or arm is None:
            return None
        return self._lengths.get(state, lambda: measure_so_far(state, standard, arm))

    def contact(self) -> ContactSoFar | None:
        """What is known of a contact test; None of another, and before its artefacts were
        confirmed. Computed once for each state."""
        state, arm = self.state, self.arm()
        if not isinstance(state, ContactState) or arm is None:
            return None
        return self._contact.get(
            state, lambda: measure_contact_so_far(state, self.gauge(), self.bar(), arm)
        )

    def sphere_option(self, gauge: str) -> ArtefactOption | None:
        """What one of the gauges is worth in a test of a sphere; None where it is none."""
        with self.lock:
            gauges = gauges_of_test(self.all_gauges(), "sphere")
            options = gauge_options(gauges, self.obstacles_of(gauges, "sphere"))
            return next((one for one in options if one.id == gauge), None)

    def _is_plan_changed(self) -> bool:
        try:
            return file_sha256(self.folder / PLAN) != self.state.plan_sha256
        except (OperationError, OSError):
            return True

    # -- sessions ------------------------------------------------------------

    def start_test(self, test: Kind) -> PerformanceView:
        """Begins a test of a kind; an open one is resumed instead.

        Raises:
            OperationError: there is no calibration in use.
        """
        with self.lock, self.use_arm():
            if not self.running:
                self._begin(test, None)
            return self.refresh()

    def begin(self, key: str | None) -> None:
        """A new session of the calibration in use, of the kind and with the artefact and the limits
        of the last."""
        self._begin(self.state.test, key)

    def _begin(self, test: Kind, key: str | None) -> None:
        usable = self.usable_of(gauges_of_test(self.all_gauges(), test), test)
        bars = self.usable_of(bars_of(self.all_gauges()), test) if test == "contact" else [""]
        payload = {
            **self.first_choices(test, usable),
            "test": test,
            "bar": self.state.bar if self.state.bar in bars else next(iter(bars), ""),
            "positions": self.state.positions,
            "by_scan": self.state.by_scan and self.active() is not None,
            "limits": {
                one.quantity: {"a_um": one.a_um, "k": one.k, "b_um": one.b_um}
                for one in read_station_limits(self.data_folder)
            },
        }
        self.begin_session(STATES[test](session_id=new_session_id()), payload, key)

    # -- touches -------------------------------------------------------------

    def touch(self, until_ns: int | None, key: str | None) -> None:
        """Takes the place that the tip touches, or touched at ``until_ns``.

        Raises:
            OperationError: the arm is lost or moves, or no free place is near.
        """
        arm, mean = self.average_touch(until_ns)
        feature, place = self.state.feature, self._place_of(arm, mean.reading)
        if not self.state.frozen:
            self.freeze()
        payload = {"feature": feature, "place": place, "reading": mean.reading.tolist()}
        self.append("touched", payload, key)
        text = message(
            "performance-touch-taken", count=len(self.state.of_step), test=self.state.test
        )
        self.station.bus.event("point_taken", text)
        self.keep_touches()

    def _place_of(self, arm: AnyArm, reading: Floats) -> int:
        state = self.state
        if isinstance(state, ContactState):
            return check_contact(state, self.gauge(), self.bar(), arm, reading)
        standard = self.standard()
        if isinstance(state, LengthState) and standard is not None:
            return check_touch(state, standard, arm, reading)
        part, centre = self.part_places(), self.centre_mm()
        if not isinstance(state, SphereState) or part is None:
            raise OperationError("not-now", message("performance-all-touched"))
        if centre is None:
            return 0  # the first touch finds the sphere
        return find_touched_place(state, part, centre, self.gauge(), arm, reading)

    def freeze(self) -> None:
        """Writes the plan, which stands from now on."""
        self.plan().write(self.folder / PLAN)
        payload = {
            "plan_sha256": file_sha256(self.folder / PLAN),
            "setup": dict(self.station.scan_setup()),
        }
        self.append("plan_frozen", payload)

    def keep_touches(self) -> None:
        """Brings the test's table of touches up to date."""
        counted = self.state.counted
        features, touched_at = [one.feature for one in counted], [one.at for one in counted]
        self.write_touches(TOUCHES, features, counted, touched_at)

    # -- scans ---------------------------------------------------------------

    def read_cloud(self, scan: AnyScan, arm: AnyArm) -> ScanCloud:
        """A scan, rebuilt from its recording with the session's calibration.

        Raises:
            OperationError: it cannot be rebuilt.
        """
        path = self.folder / scan.name / RECORDING
        with convert_io_errors(path):  # a killed process left it in memory alone
            sync_file(path)
            sync_folder(path.parent)
        return read_scan(path, self.calibration(), arm)

    # -- what waits ----------------------------------------------------------

    def end_lost_scan(self) -> None:
        """Ends a scan that ended without the operator's word, as by Stop, a full disk or a killed
        server."""
        with self.lock:
            scan = self.state.open_scan if self.running else None
            if scan is not None and self.station.scanner.recording() != self.folder / scan.name:
                self.append("scan_ended", {"number": scan.number})
