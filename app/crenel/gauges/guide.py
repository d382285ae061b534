"""The one performance test of a station: its journal, its touches and scans, and what is shown."""

import shutil
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any, TypeVar, cast

from crenel.errors import OperationError
from crenel.formats.io_errors import convert_io_errors
from crenel.formats.json_document import file_sha256
from crenel.formats.results.calibration import Calibration
from crenel.gauges.guide_flow import build_view, gauge_options
from crenel.gauges.guide_plan import build_plan
from crenel.gauges.guide_rules import RULES
from crenel.gauges.guide_state import apply_row
from crenel.gauges.guide_view import ArtefactOption, PerformanceView
from crenel.gauges.judgement.document import PerformanceFile, read_performance
from crenel.gauges.judgement.evaluate_measured_data import ASIDE, ScanCloud, read_scan
from crenel.gauges.plan.document import PLAN, TOUCHES, Kind, PerformancePlan, read_station_limits
from crenel.gauges.plan.maths_temperature import TEMPERATURE_LIMITS, TemperatureLimits
from crenel.gauges.session.acts import is_recording, recording_of
from crenel.gauges.session.artefacts import ArtefactSession, bars_of, gauges_of_shape
from crenel.gauges.session.entries import TestScan
from crenel.gauges.session.gauge_session import GaugeServices, Memo
from crenel.gauges.session.kind import AnyKind, AnyLive, PerformanceLive
from crenel.gauges.session.state import PerformanceState
from crenel.guide.common.flow import Flow
from crenel.guide.common.guided_session import (
    NO_PROVENANCE,
    Provenance,
    new_session_id,
)
from crenel.guide.common.journal import (
    Calibrations,
    Journal,
)
from crenel.messages.message import Text, message
from crenel.metrology.arm.kinematics import AnyArm
from crenel.metrology.decision import GUARDED_95, DecisionRule
from crenel.station.scan.points import Show
from crenel.store.session_records import PerformanceStore

KIND = "performance"
OneState = TypeVar("OneState", bound=PerformanceState)
Value = TypeVar("Value")


@dataclass(frozen=True)
class PerformanceServices(GaugeServices):
    """The station's parts that a performance test works with."""

    scan_setup: Callable[[], Mapping[str, object]]
    """The settings of scans as they are now."""


class PerformanceGuide(ArtefactSession[AnyLive, PerformanceView]):
    """The latest performance test."""

    station: PerformanceServices

    def __init__(
        self,
        kinds: Mapping[Kind, AnyKind],
        station: PerformanceServices,
        journal: Journal,
        calibrations: Calibrations,
        performances: PerformanceStore,
        data_folder: Path,
        signing: Provenance = NO_PROVENANCE,
        rule: DecisionRule = GUARDED_95,
        temperature_limits: TemperatureLimits = TEMPERATURE_LIMITS,
    ) -> None:
        states = {name: kind.state for name, kind in kinds.items()}
        flow: Flow[PerformanceState, AnyLive, PerformanceView] = Flow(
            KIND, KIND, states["sphere"](), partial(apply_row, states), build_view, RULES
        )
        super().__init__(station, journal, flow, calibrations, data_folder, signing, rule)
        self.kinds = kinds
        self.performances = performances
        self.temperature_limits = temperature_limits
        self.follower: object = None
        """What follows the scan that runs, for its kind of test."""
        self._of_state = Memo[Any]()
        self._result, self._calibration = Memo[PerformanceFile](), Memo[Calibration]()
        self.resume()

    @property
    def kind(self) -> AnyKind:
        """The kind of the test."""
        return self.kinds[self.state.test]

    @property
    def folder(self) -> Path:
        """The present session's folder."""
        return self.data_folder / "performance" / self.state.session_id

    def state_of(self, kind: type[OneState]) -> OneState:
        """The state of a test of a kind."""
        assert isinstance(self.state, kind)
        return self.state

    # -- what is shown -------------------------------------------------------

    def live(self) -> AnyLive:
        """The station as the session sees it."""
        state, test = self.state, type(self.state)
        gauges, bars, artefacts = self.gauges(), self.bars(), self.artefacts()
        scans = state.in_scan or bool(state.whole_place)
        return PerformanceLive(
            kind=self.kind,
            known=self.kind.know(self),
            gauges=gauges,
            bars=bars,
            artefacts=tuple(artefacts.values()),
            artefact_problems=tuple(
                problem
                for name, artefact in artefacts.items()
                for problem in self.problems_of(name, artefact)
            ),
            obstacles={
                **self.obstacles_of(gauges, test),
                **self.obstacles_of(bars, test),
            },
            setup_now=self.station.scan_setup(),
            plan_changed=self.running and state.frozen and self._is_plan_changed(),
            temperature_limits=self.temperature_limits,
            result=self.result(),
            **self.live_fields(self.arm(), scans, state.open_scan is not None),
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

    def calibration_in_use(self) -> Calibration | None:
        """The session's own copy, read once; None if it cannot be read."""
        try:
            return self._calibration.get(self.state.session_id, self.calibration)
        except OperationError:
            return None

    def once(self, compute: Callable[[], Value]) -> Value:
        """What a kind of test computes from its state, computed once for each state."""
        return cast(Value, self._of_state.get(self.state, compute))

    def sphere_option(self, gauge: str) -> ArtefactOption | None:
        """What one of the gauges is worth in a test of a sphere; None where it is none."""
        with self.lock:
            gauges = gauges_of_shape(self.all_gauges(), "sphere")
            of_sphere = self.kinds["sphere"].state
            options = gauge_options(gauges, self.obstacles_of(gauges, of_sphere))
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
        known, of_test = self.all_gauges(), self.kinds[test].state
        usable = self.usable_of(gauges_of_shape(known, of_test.shape), of_test)
        bars = self.usable_of(bars_of(known), of_test) if of_test.with_bar else [""]
        payload = {
            **self.first_choices(of_test, usable),
            "test": test,
            "bar": self.state.bar if self.state.bar in bars else next(iter(bars), ""),
            "positions": self.state.positions,
            "by_scan": self.state.by_scan and self.active() is not None,
            "limits": {
                one.quantity: {"a_um": one.a_um, "k": one.k, "b_um": one.b_um}
                for one in read_station_limits(self.data_folder)
            },
        }
        self.begin_session(of_test(session_id=new_session_id()), payload, key)

    # -- touches -------------------------------------------------------------

    def touch(self, until_ns: int | None, key: str | None) -> None:
        arm, mean = self.average_touch(until_ns)
        feature, place = self.state.feature, self.kind.place_of(self, arm, mean.reading)
        if not self.state.frozen:
            self.freeze()
        payload = {"feature": feature, "place": place, "reading": mean.reading.tolist()}
        self.append("touched", payload, key)
        text = message(
            "performance-touch-taken", count=len(self.state.of_step), test=self.state.test
        )
        self.station.bus.event("point_taken", text)
        self.keep_touches()

    def freeze(self) -> None:
        """Writes the plan, which stands from now on."""
        self.plan().write(self.folder / PLAN)
        payload = {
            "plan_sha256": file_sha256(self.folder / PLAN),
            "setup": dict(self.station.scan_setup()),
        }
        self.append("plan_frozen", payload)

    def keep_touches(self) -> None:
        counted = self.state.counted
        features, touched_at = [one.feature for one in counted], [one.at for one in counted]
        self.write_touches(TOUCHES, features, counted, touched_at)

    # -- scans ---------------------------------------------------------------

    def record_scan(self, name: str, title: Text, watch: Show | None = None) -> None:
        """Starts the scanner; a folder of this name is kept aside.

        Raises:
            OperationError: it cannot start.
        """
        folder = self.folder / name
        if folder.exists():
            number = 1 + sum(1 for _ in self.folder.glob(f"{name}{ASIDE}*"))
            with convert_io_errors(folder):
                shutil.move(folder, self.folder / f"{name}{ASIDE}{number}")
        self.station.scanner.start(str(title), folder, watch)

    def read_cloud(self, scan: TestScan, arm: AnyArm) -> ScanCloud:
        """A scan, rebuilt from its recording with the session's calibration.

        Raises:
            OperationError: it cannot be rebuilt.
        """
        return read_scan(recording_of(self, scan.name), self.calibration(), arm)

    # -- what waits ----------------------------------------------------------

    def end_lost_scan(self) -> None:
        """Ends a scan that ended without the operator's word."""
        with self.lock:
            scan = self.state.open_scan if self.running else None
            if scan is not None and not is_recording(self, scan.name):
                self.append("scan_ended", {"number": scan.number})
