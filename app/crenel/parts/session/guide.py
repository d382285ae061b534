"""The one guided inspection of a station: its journal, its touches, and what is shown of it."""

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from crenel.errors import OperationError
from crenel.formats.atomic_write import ensure_folder, write_atomically
from crenel.formats.datasheets.arm import read_any_arm
from crenel.formats.io_errors import convert_io_errors
from crenel.formats.open_file import read_bounded
from crenel.formats.results.calibration import CALIBRATION
from crenel.formats.session.calibration_session import ARM, contact_readings, write_contacts
from crenel.gauges.session.gauge_session import GaugeServices, Memo
from crenel.guide.common.datasheet_library import FolderContent
from crenel.guide.common.flow import Flow
from crenel.guide.common.guided_session import (
    NO_PROVENANCE,
    Provenance,
    new_session_id,
)
from crenel.guide.common.journal import Calibrations, Journal, StoredCalibration
from crenel.messages.message import Text, message
from crenel.metrology.arm.kinematics import tip_of
from crenel.metrology.decision import GUARDED_95, DecisionRule
from crenel.parts.session.flow import build_view
from crenel.parts.session.measuring import MeasuringSession
from crenel.parts.session.programs import Programs, means_reason, read_programs
from crenel.parts.session.rules import RULES, PartLive
from crenel.parts.session.state import PartState, apply_row
from crenel.parts.session.view import PartView
from crenel.store.session_records import InspectionStore

if TYPE_CHECKING:
    from crenel.parts.document_program import ProgramFile
    from crenel.parts.session.evaluate_outline import Line

    Outlines = Mapping[str, tuple[Line, ...]]

KIND = "parts"
FLOW = Flow(KIND, KIND, PartState(), apply_row, build_view, RULES)


class PartGuide(MeasuringSession):
    """The latest inspection."""

    station: GaugeServices

    def __init__(
        self,
        station: GaugeServices,
        journal: Journal,
        calibrations: Calibrations,
        inspections: InspectionStore,
        data_folder: Path,
        provenance: Provenance = NO_PROVENANCE,
        rule: DecisionRule = GUARDED_95,
    ) -> None:
        super().__init__(station, journal, FLOW, data_folder, provenance, rule)
        self.calibrations, self.inspections = calibrations, inspections
        self._programs = FolderContent[Programs](read_programs, data_folder)
        self._outlines, self._reason = Memo["Outlines"](), Memo[Text]()
        self.resume()

    def active(self) -> StoredCalibration | None:
        """The calibration in use of the selected sensor."""
        return self.calibrations.active(self.station.rig.selected)

    # -- what is shown -------------------------------------------------------

    def live(self) -> PartLive:
        """The station as the session sees it."""
        station, active, state = self.station, self.active(), self.state
        stillness = station.rig.arm.stillness()
        choosing = self.running and state.step == "setup"
        programs = self._programs.latest(choosing) if choosing else Programs({}, ())
        program = self.program(programs)
        found = self.find()
        return PartLive(
            programs=programs,
            program=program,
            outlines={} if program is None else self._outlines_of(program),
            set_up_reason=self._set_up_reason(program, active) if choosing else "",
            found=found,
            by_feature=self.by_feature(found),
            tips_mm=self.tips_mm(found),
            result=self.result(),
            active_id=active.id if active else "",
            active_name=active.name if active else "",
            arm=None,
            arm_link=station.rig.arm.link(),
            sensor_link=station.rig.sensor.link(),
            still=stillness.still,
            strain=stillness.strain,
            scan_why_not="",
            scan_points=0,
            has_simulation=station.simulated_operator is not None,
            simulation_running=self.simulation_running,
            busy=self.busy,
            trouble=self._trouble,
        )

    def forget_datasheets(self) -> None:
        self._programs.forget()

    def program(self, programs: Programs) -> "ProgramFile | None":
        """The chosen one, or the session's own copy from the set-up on."""
        if not self.running:
            return None
        if self.state.step == "setup":
            entry = programs.known.get(self.state.program)
            return entry.program if entry else None
        part = self.part()
        return None if part is None or isinstance(part, OperationError) else part.program

    def _outlines_of(self, program: "ProgramFile") -> "Outlines":
        from crenel.parts.session.evaluate_outline import feature_lines

        return self._outlines.get(
            program, lambda: {one.id: feature_lines(one) for one in program.features}
        )

    def _set_up_reason(
        self, program: "ProgramFile | None", active: StoredCalibration | None
    ) -> Text:
        """Why the chosen program cannot be measured with calibration and arm in use."""
        if program is None or active is None:
            return ""
        from crenel.parts.evaluate_folder import read_station

        def look() -> Text:
            try:
                station = read_station(active.file, active.file.parent / ARM)
                tip_of(station.arm)
            except OperationError as refusal:
                return refusal.text
            return means_reason(program)

        return self._reason.get((active.id, program), look)

    # -- sessions ------------------------------------------------------------

    def start(self) -> PartView:
        """Begins an inspection; an open one is resumed instead.

        Raises:
            OperationError: there is no calibration in use.
        """
        with self.lock, self.use_arm():
            if not self.running:
                self.begin(None)
            return self.refresh()

    def begin(self, key: str | None) -> None:
        """A new inspection with the program of the last, or the first one."""
        active = self.active()
        if active is None:
            raise OperationError(
                "no-calibration",
                message("inspection-cannot-begin"),
                message("inspection-no-calibration"),
                message("inspection-calibrate-first"),
            )
        self._programs.forget()
        known = self._programs.latest(True).known
        chosen = self.state.program if self.state.program in known else next(iter(known), "")
        payload = {
            "calibration_id": active.id,
            "program": chosen,
            "operator": self.provenance.operator(),
        }
        self.begin_session(PartState(session_id=new_session_id()), payload, key)

    def confirm_setup(self, key: str | None) -> None:
        """From here on the inspection uses its own copies of program, arm and calibration.

        Raises:
            OperationError: a file cannot be read or written.
        """
        from crenel.parts.document_nominal import ADVISED_TOUCHES, LEAST_TOUCHES

        entry = self._programs.latest(True).known[self.state.program]
        active = self.active()
        assert active is not None
        folder = self.folder
        with convert_io_errors(folder):
            ensure_folder(folder)
            sources = ((active.file.parent / ARM, ARM), (active.file, CALIBRATION))
            for source, name in sources:
                write_atomically(folder / name, read_bounded(source))
        self.write_program(entry.program)
        self.forget_files()
        datums = entry.program.alignment.used if entry.program.alignment is not None else ()
        features = [
            {
                "id": one.id,
                "is_datum": one.id in datums,
                "least": LEAST_TOUCHES[one.kind],
                "advised": ADVISED_TOUCHES[one.kind],
            }
            for one in entry.program.features
        ]
        self.append("set_up", {"features": features, "calibration_id": active.id}, key)

    def write_program(self, program: "ProgramFile") -> None:
        """The session's own copy, with the part's serial number and what is skipped."""
        from crenel.parts.document_program import PROGRAM, SkippedPart

        skipped = tuple(
            SkippedPart(feature=name, reason=why) for name, why in self.state.skipped.items()
        )
        part = program.part.model_copy(update={"serial_number": self.state.serial_number})
        program.model_copy(update={"part": part, "skipped": skipped}).write(self.folder / PROGRAM)

    # -- touches -------------------------------------------------------------

    def touch(self, until_ns: int | None, key: str | None) -> None:
        """Takes the place that the tip touches, or touched at ``until_ns``.

        Raises:
            OperationError: the arm is lost or moves, or it cannot be a touch of the feature.
        """
        from crenel.parts.session.evaluate_so_far import refuse_touch

        part = self.part()
        if isinstance(part, OperationError):
            raise part
        assert part is not None
        side, target = self.station.rig.arm, self.state.target
        if not target:
            raise OperationError("not-now", message("inspection-all-skipped"))
        side.set_model(read_any_arm(self.folder / ARM))  # by which it is judged whether it is still
        mean = side.average(until_ns=until_ns)
        side.refuse_scan_end(mean.reading)
        refuse_touch(part, self.gather_touches(), self.find().frame, target, mean.reading)
        self.append("touched", {"feature": target, "reading": mean.reading.tolist()}, key)
        count = self.state.count(target)
        text = message("inspection-touch-taken", feature=target, count=count)
        self.station.bus.event("point_taken", text)
        self.keep_touches()

    def keep_touches(self) -> None:
        """Brings the session's table of touches up to date; without touches there is none."""
        from crenel.parts.evaluate_folder import TOUCHES

        path, counted = self.folder / TOUCHES, self.state.counted
        if not counted:
            path.unlink(missing_ok=True)
            return
        part = self.part()
        assert part is not None
        assert not isinstance(part, OperationError)
        touched = self.gather_touches()
        contacts = contact_readings(touched.features, part.station.arm, touched.readings)
        write_contacts(path, contacts, [one.at for one in counted])
