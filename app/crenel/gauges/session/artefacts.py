"""The artefacts of a performance test: those that can be chosen, and what speaks against one."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Generic

from crenel.errors import OperationError
from crenel.formats.datasheets.arm import read_any_arm
from crenel.formats.io_errors import convert_all_errors
from crenel.formats.results.calibration import read_calibration
from crenel.formats.session.calibration_session import ARM
from crenel.gauges.guide_plan import choose_lengths, plate_part, sphere_part
from crenel.gauges.plan.document_gauge import GaugeFile
from crenel.gauges.plan.document_length_standard import LengthStandardFile, read_length_standard
from crenel.gauges.plan.evaluate_artefacts import list_problems
from crenel.gauges.quick.document import GAUGE
from crenel.gauges.session.gauge_session import GaugeServices, GaugeSession, Memo
from crenel.gauges.session.state import ArtefactShape, PerformanceState
from crenel.guide.common.datasheet_library import (
    AnyGauge,
    DatasheetEntry,
    FolderContent,
    Gauges,
    guess_arm,
    read_any_gauge,
    read_any_gauges,
    read_arms,
)
from crenel.guide.common.flow import Flow, View
from crenel.guide.common.guided_session import Provenance
from crenel.guide.common.journal import Calibrations, Journal
from crenel.guide.common.rules import Live
from crenel.messages.message import Text, message
from crenel.metrology.arm.kinematics import AnyArm
from crenel.metrology.decision import DecisionRule
from crenel.timestamps import utc_now

BAR = "bar.json"
"""The file in a test's folder with the bar of a contact test, which has a sphere, too."""


@dataclass(frozen=True, eq=False)
class CalibratedWith:
    """What a sensor was calibrated with; of one that is not, the arm alone."""

    object_serial: str
    arm: AnyArm | None
    """None if it is not known."""


def _shape_of(gauge: AnyGauge) -> ArtefactShape:
    return "length" if isinstance(gauge, LengthStandardFile) else gauge.shape


def gauges_of_shape(found: Gauges[AnyGauge], shape: ArtefactShape) -> Gauges[AnyGauge]:
    """Those of a shape; certificates are of spheres."""
    known = {
        name: entry for name, entry in found.known.items() if _shape_of(entry.datasheet) == shape
    }
    return Gauges(known, found.findings, found.refused if shape == "sphere" else ())


def bars_of(found: Gauges[AnyGauge]) -> Gauges[AnyGauge]:
    """The ball bars among the data folder's gauges."""
    known = {
        name: entry
        for name, entry in found.known.items()
        if isinstance(entry.datasheet, LengthStandardFile) and entry.datasheet.kind == "ball-bar"
    }
    return Gauges(known, ())


def problems_in_test(
    name: str, gauge: AnyGauge, as_bar: bool, day: str, calibrated: CalibratedWith
) -> list[Text]:
    """Why a gauge cannot serve in a kind of test; empty if it can.

    Args:
        name: of its file.
        as_bar: whether a length standard is the bar of a contact test.
        day: of the test, ISO 8601.
        calibrated: what the sensor was calibrated with.
    """
    if isinstance(gauge, LengthStandardFile):
        # the reach is not checked in a contact test: a bar across the arm's column may be longer
        arm = None if as_bar else calibrated.arm
        problems = list_problems(gauge, day, calibrated.object_serial, arm)
        if as_bar and gauge.sphere_diameter_mm is None:
            problems.append(message("bar-without-sphere-diameter"))
        return problems
    part = sphere_part(name, gauge) if gauge.shape == "sphere" else plate_part(name, gauge)
    return list_problems(part, day, calibrated.object_serial)


def read_calibrated_with(calibration: Path) -> CalibratedWith | OperationError:
    """The object and the arm of a calibration's file, or why they cannot be read."""
    try:
        with convert_all_errors(calibration):
            serial = read_calibration(calibration).serial_numbers.object
            return CalibratedWith(serial, read_any_arm(calibration.parent / ARM))
    except OperationError as error:
        return error


class ArtefactSession(GaugeSession[PerformanceState, Live, View, AnyGauge], Generic[Live, View]):
    """A session on a sphere, a plate or a length standard, or on a sphere and a ball bar."""

    def __init__(
        self,
        station: GaugeServices,
        journal: Journal,
        flow: Flow[PerformanceState, Live, View],
        calibrations: Calibrations,
        data_folder: Path,
        provenance: Provenance,
        rule: DecisionRule,
    ) -> None:
        super().__init__(
            station,
            journal,
            flow,
            calibrations,
            data_folder,
            provenance,
            rule,
            read_any_gauges,
            read_any_gauge,
        )
        self._arms = FolderContent(read_arms, data_folder)
        self._calibrated_with = Memo[CalibratedWith | OperationError]()
        self._bar = Memo[LengthStandardFile]()

    def forget_datasheets(self) -> None:
        super().forget_datasheets()
        self._arms.forget()

    def first_choices(
        self, test: type[PerformanceState], usable: Iterable[str]
    ) -> Mapping[str, object]:
        """Calibration and artefact; of a test by touch without a calibration, arm and artefact."""
        if not test.by_touch or self.active() is not None:
            return self.first_payload(message("performance-nothing-to-test"), usable)
        self._arms.forget()  # the operator may just have put a file there
        guess = self._guess_arm()
        if not guess:
            raise self._no_arm_error()
        return {"calibration_id": "", "gauge": self.first_gauge(usable), "arm": guess}

    def _guess_arm(self) -> str:
        """The datasheet of the connected arm, for a test without a calibration; empty if it is not
        clear."""
        info = self.station.rig.arm.info
        return guess_arm(self._arms_with_tip(), info.serial_number if info else "", self.state.arm)

    def _arms_with_tip(self) -> Mapping[str, DatasheetEntry[AnyArm]]:
        arms = self._arms.latest(self.is_choosing()).items()
        return {name: entry for name, entry in arms if entry.datasheet.tip is not None}

    def _no_arm_error(self) -> OperationError:
        return OperationError(
            "no-arm",
            message("performance-nothing-to-test"),
            message("performance-no-arm"),
            message("performance-put-arm-json"),
        )

    def sources(self) -> list[tuple[Path, str]]:
        """The sources of a test without a calibration: the arm's alone."""
        if self.state.calibration_id:
            return super().sources()
        self._arms.forget()
        entry = self._arms_with_tip().get(self.state.arm)
        if entry is None:
            raise self._no_arm_error()
        return [(entry.path, ARM)]

    def gauges(self) -> Gauges[AnyGauge]:
        """The data folder's spheres, plates or length standards, by the kind of the test."""
        return gauges_of_shape(self.all_gauges(), self.state.shape)

    def all_gauges(self) -> Gauges[AnyGauge]:
        """All of the data folder."""
        return super().gauges()

    def bars(self) -> Gauges[AnyGauge]:
        """The data folder's ball bars; of a contact test alone."""
        return bars_of(self.all_gauges()) if self.state.with_bar else Gauges({}, ())

    def gauge_entries(self) -> Mapping[str, DatasheetEntry[AnyGauge]]:
        """The gauges that the test is done on, by the names of their copies."""
        found = {
            GAUGE: self.gauges().known.get(self.state.gauge),
            BAR: self.bars().known.get(self.state.bar),
        }
        return {name: entry for name, entry in found.items() if entry is not None}

    def artefacts(self) -> Mapping[str, AnyGauge]:
        """What the test is done on by the names of the gauges' files, the session's own copies once
        it was confirmed: a sphere, a plate or a standard; of a contact test a sphere, a bar, or
        both."""
        state = self.state
        found = {state.gauge: self.gauge() or self.standard(), state.bar: self.bar()}
        return {name: artefact for name, artefact in found.items() if name and artefact}

    def gauge(self) -> GaugeFile | None:
        """The sphere, or the plate."""
        found = self.datasheets()[0]
        return found if isinstance(found, GaugeFile) else None

    def standard(self) -> LengthStandardFile | None:
        """The standard of a length test, with the lengths that are measured."""
        found = self.datasheets()[0]
        return choose_lengths(found) if isinstance(found, LengthStandardFile) else None

    def bar(self) -> LengthStandardFile | None:
        """The bar of a contact test; None if it is done without one, or if it cannot be read."""
        state = self.state
        if not state.with_bar or not state.bar:
            return None
        if state.step == "artefact" or state.ended:
            entry = self.bars().known.get(state.bar)
            found = None if entry is None else entry.datasheet
            return found if isinstance(found, LengthStandardFile) else None
        try:
            with convert_all_errors(self.folder):
                return self._bar.get(
                    (state.session_id, state.bar), lambda: read_length_standard(self.folder / BAR)
                )
        except OperationError:
            return None

    def arm(self) -> AnyArm | None:
        """The session's own copy, once the sphere was confirmed."""
        return self.datasheets()[1]

    def problems_of(self, name: str, gauge: AnyGauge) -> tuple[Text, ...]:
        """Why a gauge cannot serve in this test."""
        return self._problems_of(name, gauge, type(self.state), self._read_calibrated_with())

    def _problems_of(
        self,
        name: str,
        gauge: AnyGauge,
        test: type[PerformanceState],
        known: CalibratedWith | OperationError,
    ) -> tuple[Text, ...]:
        if isinstance(known, OperationError):
            return (known.text,)
        day = (self.state.started_at if self.running else utc_now())[:10]
        try:
            with convert_all_errors(name):
                return tuple(problems_in_test(name, gauge, test.with_bar, day, known))
        except OperationError as error:
            return (error.text,)

    def _read_calibrated_with(self) -> CalibratedWith | OperationError:
        """Reads what the calibration in use was made with; without one, the arm that touches."""
        active = self.active()
        if active is None:
            entry = self._arms_with_tip().get(self.state.arm or self._guess_arm())
            return CalibratedWith("", None if entry is None else entry.datasheet)
        return self._calibrated_with.get(active.id, lambda: read_calibrated_with(active.file))

    def obstacles_of(
        self, gauges: Gauges[AnyGauge], test: type[PerformanceState]
    ) -> dict[str, Text]:
        """Why the gauges that cannot serve in a kind of test cannot."""
        known = self._read_calibrated_with()
        found = {
            name: self._problems_of(name, entry.datasheet, test, known)
            for name, entry in gauges.known.items()
        }
        return {name: problems[0] for name, problems in found.items() if problems}

    def usable_of(self, gauges: Gauges[AnyGauge], test: type[PerformanceState]) -> list[str]:
        """The names of those that can serve."""
        obstacles = self.obstacles_of(gauges, test)
        return [name for name in gauges.known if name not in obstacles]
