"""The one performance test of a station: its journal, its touches and scans, and what is shown."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Protocol

import numpy as np

from app.errors import OperationError
from app.formats.datasheets.gauge import GaugeFile
from app.formats.json_document import file_sha256
from app.formats.performance.plan import PLAN, TOUCHES, PerformancePlan
from app.formats.performance.results import PerformanceFile, read_performance
from app.formats.performance.station_limits import read_station_limits
from app.formats.results.calibration import Calibration, read_calibration
from app.guide.common.datasheet_library import Gauges, read_gauges
from app.guide.common.flow import Flow
from app.guide.common.guided_session import (
    NO_PROVENANCE,
    Provenance,
    new_session_id,
)
from app.guide.common.journal import (
    Calibrations,
    Check,
    Journal,
    JournalEntry,
)
from app.guide.gauge.certificates import store_certificate
from app.guide.gauge.session import GaugeServices, GaugeSession
from app.guide.performance.flow import build_view, sphere_options
from app.guide.performance.live import PerformanceLive, Places
from app.guide.performance.places import (
    PartPlaces,
    flat_pattern,
    off_articulation_deg,
    places_of,
    sphere_centre_of,
)
from app.guide.performance.plan import build_plan, sphere_part
from app.guide.performance.rules import RULES
from app.guide.performance.state import PerformanceState, apply_row
from app.guide.performance.view import PerformanceView, SphereOption
from app.messages.message import Text, message
from app.metrology.arm.kinematics import AnyArm, tip_centres
from app.metrology.decision import GUARDED_95, DecisionRule
from app.metrology.performance.articulation import (
    assign_places,
    flat_deg,
    nearest_free,
)
from app.metrology.transforms import Floats
from app.timestamps import utc_now
from app.workflows.performance.artefact_checks import list_problems

KIND = "performance"
FLOW = Flow(KIND, KIND, PerformanceState(), apply_row, build_view, RULES)


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


class PerformanceGuide(GaugeSession[PerformanceState, PerformanceLive, PerformanceView]):
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
    ) -> None:
        super().__init__(
            station, journal, FLOW, calibrations, data_folder, signing, rule, _read_spheres
        )
        self.performances = performances
        self._object: tuple[str, str | OperationError] = ("", "")
        self._result: tuple[str, PerformanceFile | None] = ("", None)
        self._calibration: tuple[str, Calibration | None] = ("", None)
        self._centre: tuple[PerformanceState | None, Floats | None] = (None, None)
        self.resume()

    @property
    def folder(self) -> Path:
        """The present session's folder."""
        return self.data_folder / "performance" / self.state.session_id

    # -- what is shown -------------------------------------------------------

    def live(self) -> PerformanceLive:
        """The station as the session sees it."""
        station, state = self.station, self.state
        side, active = station.rig.arm, self.active()
        stillness = side.stillness()
        gauges, gauge = self.gauges(), self.gauge()
        blocked = station.scanner.why_not() if state.step == "scan" else None
        return PerformanceLive(
            active_id=active.id if active else "",
            active_name=active.name if active else "",
            gauges=gauges,
            gauge=gauge,
            artefact_problems=self._sphere_problems(state.gauge, gauge) if gauge else (),
            obstacles=self._obstacles(gauges),
            setup_now=station.scan_setup(),
            plan_changed=self.running and state.frozen and self._is_plan_changed(),
            arm=self.arm(),
            places=self._live_places(),
            pattern_flat_deg=flat_pattern(self.centre_mm()),
            result=self.result(),
            arm_link=side.link(),
            sensor_link=station.rig.sensor.link(),
            still=stillness.still,
            strain=stillness.strain,
            off_deg=self._off_deg(),
            scan_why_not=blocked.text if blocked else "",
            scan_points=station.scanner.state().points if state.open_scan else 0,
            has_simulation=station.simulated_operator is not None,
            simulation_running=self.simulation_running,
            busy=self.busy,
            trouble=self._trouble,
        )

    def gauge(self) -> GaugeFile | None:
        """The chosen sphere, the session's own copy once it was confirmed."""
        return self.datasheets()[0]

    def arm(self) -> AnyArm | None:
        """The session's own copy, once the sphere was confirmed."""
        return self.datasheets()[1]

    def plan(self) -> PerformancePlan:
        """The plan as it would be frozen now; a sphere must be chosen."""
        gauge = self.gauge()
        assert gauge is not None
        return build_plan(self.state, gauge, self.provenance, self.rule)

    def result(self) -> PerformanceFile | None:
        """What the test found; None before it was evaluated, or if it cannot be read."""
        state = self.state
        if not state.result:
            return None
        if self._result[0] != state.session_id:
            try:
                self._result = (state.session_id, read_performance(self.folder))
            except OperationError:
                return None
        return self._result[1]

    def centre_mm(self) -> Floats | None:
        """(3,) of the sphere at this position, by the touches of its pattern; None before the
        first. Fitted once for each state."""
        gauge, arm = self.datasheets()
        if arm is None or gauge is None:
            return None
        if self._centre[0] is not self.state:
            self._centre = (self.state, sphere_centre_of(self.state, arm, gauge))
        return self._centre[1]

    def part_places(self) -> PartPlaces | None:
        """The places of the part of the test that is touched now; None if there is none."""
        return places_of(self.state, self.centre_mm())

    def _off_deg(self) -> float | None:
        """How far stylus or camera is from the direction of the present articulation."""
        newest, arm, centre = self.station.rig.arm.latest(), self.arm(), self.centre_mm()
        if newest is None or arm is None or centre is None:
            return None
        return off_articulation_deg(
            self.state, arm, np.array(newest.reading), centre, self._calibration_in_use()
        )

    def _calibration_in_use(self) -> Calibration | None:
        """The session's own copy, read once; None if it cannot be read."""
        if self._calibration[0] != self.state.session_id:
            try:
                self._calibration = (self.state.session_id, self.calibration())
            except OperationError:
                return None
        return self._calibration[1]

    def _live_places(self) -> Places | None:
        part, centre = self.part_places(), self.centre_mm()
        if part is None:
            return None
        taken = frozenset(touch.place for touch in self.state.of(self.state.feature))
        tip = self.station.rig.arm.tip_mm() if centre is not None else None
        free = [place for place in range(len(part.directions)) if place not in taken]
        following = free[0] if free else -1
        tip_deg: tuple[float, float] | None = None
        if tip is not None and centre is not None:
            at = np.array(tip)
            following = nearest_free(at, centre, part.directions, sorted(taken))
            away = (at - centre) / max(float(np.linalg.norm(at - centre)), 1e-9)
            right_deg, away_deg = flat_deg(away[None], part.pole, part.towards)[0].tolist()
            tip_deg = (round(right_deg), round(away_deg))
        flat = flat_deg(part.directions, part.pole, part.towards)
        return Places(part.directions, flat, taken, following, tip_deg)

    def _sphere_problems(self, name: str, gauge: GaugeFile) -> tuple[Text, ...]:
        """Why a sphere cannot serve in this test, or in one that would begin now."""
        active = self.active()
        if active is None:
            return ()
        if self._object[0] != active.id:
            self._object = (active.id, _calibration_object(active.file))
        own = self._object[1]
        if isinstance(own, OperationError):
            return (own.text,)
        day = (self.state.started_at if self.running else utc_now())[:10]
        return tuple(list_problems(sphere_part(name, gauge), day, own))

    def _obstacles(self, gauges: Gauges) -> dict[str, Text]:
        """Of the spheres that cannot serve, why."""
        found = {
            name: self._sphere_problems(name, entry.datasheet)
            for name, entry in gauges.known.items()
        }
        return {name: problems[0] for name, problems in found.items() if problems}

    def add_certificate(self, name: str, text: str) -> SphereOption:
        """Puts a sphere's digital certificate into the folder of gauges; what it is worth.

        Raises:
            OperationError: it is no such certificate, or cannot be stored.
        """
        with self.lock:
            added = store_certificate(self.data_folder, name, text)
            self._gauges.forget()
            self.refresh()
            gauges = self.gauges()
            options = sphere_options(gauges, self._obstacles(gauges))
            return next(one for one in options if one.id == added)

    def _is_plan_changed(self) -> bool:
        try:
            return file_sha256(self.folder / PLAN) != self.state.plan_sha256
        except (OperationError, OSError):
            return True

    # -- sessions ------------------------------------------------------------

    def begin(self, key: str | None) -> None:
        """A new session of the calibration in use, with the sphere and the limits of the last."""
        first = self.first_payload(message("performance-nothing-to-test"))
        gauges = self.gauges()
        obstacles = self._obstacles(gauges)
        usable = [name for name in gauges.known if name not in obstacles]
        payload = {
            **first,
            "gauge": first["gauge"] if first["gauge"] in usable else next(iter(usable), ""),
            "positions": self.state.positions,
            "limits": {one.quantity: one.a_um for one in read_station_limits(self.data_folder)},
        }
        self.begin_session(PerformanceState(session_id=new_session_id()), payload, key)

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
        text = message("performance-touch-taken", count=len(self.state.of_step))
        self.station.bus.event("point_taken", text)
        self.keep_touches()

    def _place_of(self, arm: AnyArm, reading: Floats) -> int:
        part, centre = self.part_places(), self.centre_mm()
        if part is None:
            raise OperationError("not-now", message("performance-all-touched"))
        if centre is None:
            return 0  # the first touch finds the sphere
        before = self.state.of(self.state.feature)
        readings = np.array([*(touch.reading for touch in before), reading])
        tips = tip_centres(arm, readings)
        taken = [touch.place for touch in before]
        free = np.array([i for i in range(len(part.directions)) if i not in taken], dtype=np.int64)
        found = assign_places(tips[-1:], centre, part.directions[free], part.catch_deg)
        if found[0] >= 0:
            return int(free[found[0]])
        wanted = nearest_free(tips[-1], centre, part.directions, taken)
        raise OperationError(
            "no-free-place",
            message("performance-no-free-place"),
            remedy=message("performance-touch-place", number=wanted + 1),
        )

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
        self.write_touches(TOUCHES, [touch.feature for touch in counted], counted)

    # -- what waits ----------------------------------------------------------

    def end_lost_scan(self) -> None:
        """Ends a scan that ended without the operator's word, as by Stop, a full disk or a killed
        server."""
        with self.lock:
            scan = self.state.open_scan if self.running else None
            if scan is not None and self.station.scanner.recording() != self.folder / scan.name:
                self.append("scan_ended", {"number": scan.number})


def _calibration_object(file: Path) -> str | OperationError:
    """The serial number of a calibration's own object, or why it cannot be read."""
    try:
        return read_calibration(file).serial_numbers.object
    except OperationError as error:
        return error


def _read_spheres(data_folder: Path) -> Gauges:
    """The spheres among the data folder's gauges."""
    found = read_gauges(data_folder)
    spheres = {
        name: entry for name, entry in found.known.items() if entry.datasheet.shape == "sphere"
    }
    return replace(found, known=spheres)
