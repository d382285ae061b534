"""Walks the operator through the calibration: journal, station and view, brought together."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path

import numpy as np

from crenel.errors import OperationError, StaleViewError
from crenel.findings import Finding
from crenel.guide.calibration.accepted import read_camera_calibration
from crenel.guide.calibration.flow import build_view
from crenel.guide.calibration.live import (
    CalibrationLive,
    CameraCalibration,
    ConnectedArm,
    ConnectedSensor,
)
from crenel.guide.calibration.outcome import CalibrationOutcome, from_payload
from crenel.guide.calibration.poses.advice import Advice, remaining
from crenel.guide.calibration.poses.advice import from_payload as advice_from
from crenel.guide.calibration.poses.detection import DetectionCache
from crenel.guide.calibration.rules import RULES
from crenel.guide.calibration.session_datasheets import (
    CHOOSING,
    SessionDatasheets,
    best_guess,
    guess_for_connected,
)
from crenel.guide.calibration.session_folder import SessionFolder
from crenel.guide.calibration.state import CAMERA, DEVICE, FIELDS, CalibrationState, apply_row
from crenel.guide.common.flow import Flow
from crenel.guide.common.guided_session import (
    NO_PROVENANCE,
    GuidedSession,
    Provenance,
    StationServices,
    new_session_id,
)
from crenel.guide.common.journal import Calibrations, Journal
from crenel.guide.common.result_view import CalibrationResult
from crenel.guide.common.view import FlowView
from crenel.messages.message import message
from crenel.metrology.adjustment.planning.next_pose import PoseDelta
from crenel.metrology.arm.kinematics import flange_pose
from crenel.metrology.decision import GUARDED_95, DecisionRule
from crenel.metrology.limits import LIMITS, Limits
from crenel.metrology.transforms import Floats
from crenel.station.devices.rig import NamedSensor
from crenel.station.jobs import Progress
from crenel.station.preview.preview import Preview
from crenel.station.scan.state import ScanState
from crenel.station.view3d.scene import Scene
from crenel.workflows.calibrate import AnyDetection

KIND = "calibration"
FLOW = Flow(KIND, "flow", CalibrationState(), apply_row, build_view, RULES)


@dataclass(frozen=True)
class CalibrationServices(StationServices):
    """The station's parts that the guide works with."""

    preview: Preview
    scene: Scene


class CalibrationGuide(GuidedSession[CalibrationState, CalibrationLive, FlowView]):
    """The one calibration session of a station: its journal, and what is shown of it.

    ``on_closed`` is called after a session was accepted or abandoned.
    """

    station: CalibrationServices

    def __init__(
        self,
        station: CalibrationServices,
        journal: Journal,
        calibrations: Calibrations,
        data_folder: Path,
        on_closed: Callable[[], None],
        limits: Limits = LIMITS,
        signing: Provenance = NO_PROVENANCE,
        rule: DecisionRule = GUARDED_95,
    ) -> None:
        super().__init__(station, journal, FLOW, data_folder, signing)
        self.rule = rule
        self.limits = limits
        """What a calibration's verdict goes by."""
        self.detections = DetectionCache()
        self.calibrations = calibrations
        self.tip: Callable[[], Finding | None] = lambda: None
        """What the last check of the tip says."""
        self.taking_poses = False
        """Whether pictures are taken by themselves."""
        self._sessions = data_folder / "sessions"
        self._on_closed = on_closed
        self._datasheets: SessionDatasheets | None = None
        self._outcome: tuple[Mapping[str, object] | None, CalibrationOutcome | None] = (None, None)
        self._captured: dict[int, tuple[Mapping[str, object], CalibrationOutcome]] = {}
        self._advised: tuple[Mapping[str, object] | None, Advice | None] = (None, None)
        self._in_use: tuple[str, CameraCalibration | None] = ("", None)
        self.resume()

    @property
    def datasheets(self) -> SessionDatasheets:
        """What the present session chooses from, and chose."""
        path = self._sessions / (self.state.session_id or "none")
        if self._datasheets is None or self._datasheets.folder.path != path:
            self._datasheets = SessionDatasheets(SessionFolder(path), self.limits)
        return self._datasheets

    @property
    def folder(self) -> SessionFolder:
        """The present session's folder."""
        return self.datasheets.folder

    def pose_detections(self) -> Mapping[int, AnyDetection | OperationError]:
        """What the pictures of this session's poses show, by number, as far as remembered."""
        return self.detections.of(self.state.session_id)

    # -- what is shown -------------------------------------------------------

    def live(self) -> CalibrationLive:
        """The station as the flow sees it."""
        rig, state = self.station.rig, self.state
        preview = self.station.preview.latest()
        return CalibrationLive(
            rev=self.rev,
            arm_link=rig.arm.link(),
            sensor_link=rig.sensor.link(),
            arm=self.describe_arm(),
            sensor=self.describe_sensor(),
            devices=self._devices(),
            without_laser=self._without_laser(),
            stillness=rig.arm.stillness(),
            library=self.datasheets.library(state.step in CHOOSING),
            chosen=self.datasheets.selection(state),
            touch=self.datasheets.touch(state),
            laser_on=rig.sensor.is_taken_as_lit,
            corners_detected=len(preview.header.corners) if preview else 0,
            picture_findings=tuple(preview.header.findings) if preview else (),
            latest_outcome=self._latest_outcome(),
            capture_outcomes=self._capture_outcomes(),
            advice=self._advice(),
            to_move=self._to_move(),
            scanning=self._scanning(),
            tip=self.tip() if state.step == "setup" else None,
            has_simulation=self.station.simulated_operator is not None,
            busy=self.busy,
            simulation_running=self.simulation_running,
            taking_poses=self.taking_poses,
            trouble=self._trouble,
        )

    def _latest_outcome(self) -> CalibrationOutcome | None:
        """The outcome of the solve, or before one of the capture; parsed once."""
        picture = self.state.picture
        payload = self.state.outcome or (picture.outcome if picture else None)
        if self.state.step == "review" and self.state.solved is not None:
            payload = self.state.solved.outcome
        if self._outcome[0] is not payload:
            self._outcome = (payload, from_payload(payload) if payload else None)
        return self._outcome[1]

    def _capture_outcomes(self) -> Mapping[int, CalibrationOutcome]:
        """What the captures showed, each parsed once."""
        for capture in self.state.captures:
            known = self._captured.get(capture.number)
            if known is None or known[0] is not capture.outcome:
                self._captured[capture.number] = (capture.outcome, from_payload(capture.outcome))
        return {
            capture.number: self._captured[capture.number][1] for capture in self.state.captures
        }

    def _advice(self) -> Advice | None:
        """The advice on the next pose, parsed once."""
        payload = self.state.advice
        if self._advised[0] is not payload:
            self._advised = (payload, advice_from(payload) if payload else None)
        return self._advised[1]

    def _to_move(self) -> PoseDelta | None:
        """What is still to be moved to the advised hold, while the sensor is aimed."""
        advice, chosen = self._advice(), self.datasheets.selection(self.state)
        newest = self.station.rig.arm.latest()
        aiming = self.state.step in ("place", "capture")
        if not aiming or advice is None or chosen.arm is None or chosen.object is None:
            return None
        if newest is None or len(newest.reading) != chosen.arm.reading_size:
            return None
        T_arm_flange = flange_pose(chosen.arm, np.array(newest.reading))
        return remaining(advice, T_arm_flange, chosen.object)

    def _scanning(self) -> bool:
        scan = self.station.bus.latest("scan")
        return isinstance(scan, ScanState) and scan.state in ("running", "stopping")

    def describe_arm(self) -> ConnectedArm | None:
        """What the arm on the line says of itself; None without one."""
        info = self.station.rig.arm.info
        if info is None:
            return None
        return ConnectedArm(info.serial_number, info.joint_count, info.reports)

    def describe_sensor(self) -> ConnectedSensor | None:
        """The same of the sensor."""
        info = self.station.rig.sensor.info
        if info is None:
            return None
        return ConnectedSensor(info.serial_number, info.width_px, info.height_px)

    def _without_laser(self) -> CameraCalibration | None:
        """The calibration in use, if it is of the chosen devices and has no laser plane."""
        state = self.state
        if state.step not in CHOOSING and state.ended != "accepted":
            return None
        stored, chosen = self.calibrations.active(self.station.rig.selected), self.device_serials()
        if stored is None or chosen is None:
            return None
        if self._in_use[0] != stored.id:
            self._in_use = (stored.id, read_camera_calibration(stored))
        found = self._in_use[1]
        if found is None or (found.arm_serial, found.sensor_serial) != chosen:
            return None
        return found

    def device_serials(self) -> tuple[str, str] | None:
        """Serial numbers of the chosen arm and sensor; None where one is not chosen."""
        chosen = self.datasheets.selection(self.state)
        if chosen.arm is None or chosen.sensor is None:
            return None
        return chosen.arm.serial_number, chosen.sensor.serial_number

    def _devices(self) -> tuple[NamedSensor, ...]:
        """The sensors to choose from; none of a station with one."""
        rig = self.station.rig
        return rig.sensor_choice().sensors if len(rig.sensors) > 1 else ()

    # -- sessions ------------------------------------------------------------

    def start(self) -> FlowView:
        """Begins a session; an open one is resumed instead."""
        with self.lock, self.use_arm():
            if not self.running:
                self._begin("devices", None)
            return self.refresh()

    def repeat(self, key: str | None) -> None:
        """Closes the session if it is open, and begins the next with the same set-up."""
        with self.lock:
            camera = self.state.choices.get(CAMERA, "") if self.running else ""
            if self.running:
                self.append("repeated", {})
            if camera:
                self._begin("setup", key, {CAMERA: camera})
                return
            library = self.datasheets.library(True)
            known = all(library.has(name, self.state.choices.get(name, "")) for name in FIELDS)
            self._begin("touch" if known else "devices", key)

    def begin_laser(self, key: str | None) -> None:
        """Begins a session that adds the laser to the camera and mounting in use."""
        with self.lock:
            kept = self._without_laser()
            assert kept is not None
            self._begin("setup", key, {CAMERA: kept.id})

    def keep_camera(self) -> None:
        """The session's folder has the calibration whose camera and mounting are kept, if any."""
        stored = self.calibrations.active(self.station.rig.selected)
        keeps = stored is not None and stored.id == self.state.choices.get(CAMERA)
        self.folder.keep_camera(stored.file if stored is not None and keeps else None)

    def _begin(self, step: str, key: str | None, more: Mapping[str, str] | None = None) -> None:
        library = self.datasheets.library(True)
        before = {name: one for name, one in self.state.choices.items() if name != CAMERA}
        choices = {**before, **(more or {})}
        if step == "devices":
            choices = best_guess(library, self.state, self.describe_arm(), self.describe_sensor())
            if len(self.station.rig.sensors) > 1:
                choices[DEVICE] = self.station.rig.selected
        session_id = new_session_id()
        if step == "touch":
            SessionFolder(self._sessions / session_id).keep_datasheets(library, choices)
        state = CalibrationState(session_id=session_id, choices=choices)
        self.begin_session(state, {"choices": choices, "step": step}, key)

    def choose_for_connected(self) -> None:
        """Chooses again what cannot belong to the devices that are connected by now."""
        library = self.datasheets.library(True)
        better = guess_for_connected(
            library, self.state, self.describe_arm(), self.describe_sensor()
        )
        for field, found in better.items():
            self.append("chosen", {"field": field, "id": found})

    def forget_datasheets(self) -> None:
        self.datasheets.forget()

    def note_datasheets(self) -> None:
        """While the operator chooses, what is now clear is chosen."""
        with self.lock:
            self.forget_datasheets()
            if self.running and self.state.step == "setup":
                self.choose_for_connected()
            self.refresh()

    # -- pictures by themselves ----------------------------------------------

    def start_taking_poses(self, work: Callable[[Progress], None]) -> None:
        """Takes pictures by themselves; raises ``OperationError`` while another job runs."""

        def run(progress: Progress) -> None:
            try:
                work(progress)
            finally:
                self.taking_poses = False

        self.taking_poses = True
        try:
            self.start_job(message("pictures-by-themselves"), run)
        except OperationError:
            self.taking_poses = False
            raise

    def stop_work(self) -> None:
        self.taking_poses = False
        super().stop_work()

    # -- changes -------------------------------------------------------------

    def accept(self, result: CalibrationResult, key: str | None) -> None:
        """Makes the session's calibration the one in use."""
        with self.lock:
            chosen = self.datasheets.selection(self.state)
            figures = {
                "total_um": result.total_um,
                "verdict": result.verdict,
                "arm_serial": chosen.arm.serial_number if chosen.arm else "",
                "object_serial": chosen.object.serial_number if chosen.object else "",
                "sensor_serial": chosen.sensor.serial_number if chosen.sensor else "",
            }
            name = str(message("calibration-utc", now=f"{datetime.now(UTC):%Y-%m-%d %H:%M}"))
            sensor = self.station.rig.selected
            name = f"{name}, {sensor}" if sensor else name
            file = self.folder.calibration
            self.folder.keep_acceptance(name, result, self.provenance, self.rule)
            session_id = self.state.session_id
            self.keep(
                lambda check: self.calibrations.accept(
                    session_id, name, file, figures, key, check, sensor
                )
            )
            self.station.bus.event("accepted", message("in-use-named", name=name), "good")
            self.after_change()

    def after_change(self) -> None:
        self.sync_station()
        super().after_change()
        if self.state.ended in ("accepted", "abandoned"):
            self._on_closed()

    def sync_station(self) -> None:
        """The rig, the preview and the 3D view work with what the session chose."""
        state, station = self.state, self.station
        if not self.running:
            station.preview.detect(None)
            return
        chosen = self.datasheets.selection(state)
        self._use_chosen_device()
        station.rig.arm.set_model(chosen.arm)
        if chosen.sensor is not None:
            station.preview.set_stripe_axis(chosen.sensor.stripe_axis)
        aiming = state.step in ("place", "capture")
        station.preview.detect(chosen.object if aiming else None)
        if chosen.arm is not None:
            station.scene.set_arm_model(chosen.arm)
        T_arm_obj = self._place_of_object()
        if T_arm_obj is not None and chosen.object is not None:
            station.scene.set_object(T_arm_obj, chosen.object)
        else:
            station.scene.clear_object()

    def _use_chosen_device(self) -> None:
        """The session's sensor is the selected one, of several."""
        rig, name = self.station.rig, self.state.choices.get(DEVICE, "")
        if name in rig.sensors and name != rig.selected:
            rig.select(name)
            self.station.preview.use_sensor(rig.sensor)
            self.station.preview.set_calibration(None)

    def _place_of_object(self) -> Floats | None:
        """``T_arm_obj`` (4, 4) by the contacts, or by the pictures so far; None before."""
        touch, advice = self.datasheets.touch(self.state), self._advice()
        if touch is not None and touch.alignment is not None:
            return touch.alignment.T_arm_obj
        return np.array(advice.T_arm_obj) if advice is not None else None

    @property
    def rev(self) -> int:
        return self._journal.last_number()

    def stale(self) -> StaleViewError:
        return StaleViewError(self.view())
