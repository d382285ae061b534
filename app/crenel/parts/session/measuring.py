"""What an inspection has measured so far, worked out from its touches once for each state."""

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from crenel.errors import OperationError
from crenel.formats.io_errors import convert_all_errors
from crenel.gauges.session.gauge_session import Memo
from crenel.guide.common.flow import Flow
from crenel.guide.common.guided_session import GuidedSession, Provenance, StationServices
from crenel.guide.common.journal import Journal
from crenel.metrology.arm.kinematics import tip_centres
from crenel.metrology.decision import DecisionRule
from crenel.metrology.transforms import apply, inverse
from crenel.parts.session.evaluate_found import FoundSoFar
from crenel.parts.session.rules import TOUCHING, PartLive
from crenel.parts.session.state import PartState
from crenel.parts.session.view import PartView

if TYPE_CHECKING:
    from crenel.parts.document_results import DimensionResult, InspectionFile
    from crenel.parts.session.evaluate_so_far import PartKnowledge, TouchedSoFar

FOLDER = "inspections"


class MeasuringSession(GuidedSession[PartState, PartLive, PartView]):
    """The measurements of an inspection.

    Args:
        rule: how values, uncertainties and limits become decisions.
    """

    def __init__(
        self,
        station: StationServices,
        journal: Journal,
        flow: Flow[PartState, PartLive, PartView],
        data_folder: Path,
        provenance: Provenance,
        rule: DecisionRule,
    ) -> None:
        super().__init__(station, journal, flow, data_folder, provenance)
        self.rule = rule
        self._part, self._found = Memo["PartKnowledge | OperationError"](), Memo[FoundSoFar]()
        self._result = Memo["InspectionFile"]()
        self._stated: dict[str, tuple[object, tuple[DimensionResult, ...]]] = {}

    @property
    def folder(self) -> Path:
        """The present session's folder, an inspection folder."""
        return self.data_folder / FOLDER / self.state.session_id

    def part(self) -> "PartKnowledge | OperationError | None":
        """Program, calibration and arm of the session, read once; None before the set-up."""
        if not self.running or self.state.step == "setup":
            return None
        # measuring is loaded by the first inspection, not with the station
        from crenel.parts.document_program import ProgramFile
        from crenel.parts.evaluate_folder import find_files, read_station
        from crenel.parts.session.evaluate_so_far import PartKnowledge

        def read() -> PartKnowledge | OperationError:
            try:
                with convert_all_errors(self.folder):
                    files = find_files(self.folder)
                    station = read_station(files.calibration, files.arm)
                    program = ProgramFile.read(files.program)
                    return PartKnowledge(files, program, station, self.rule)
            except OperationError as refusal:
                return refusal

        return self._part.get(self.state.session_id, read)

    def forget_files(self) -> None:
        """Has the session's copies read again."""
        self._part.forget()

    def gather_touches(self) -> "TouchedSoFar":
        """The touches that count."""
        from crenel.parts.session.evaluate_so_far import TouchedSoFar

        counted = self.state.counted
        readings = np.array([one.reading for one in counted])
        return TouchedSoFar(tuple(one.feature for one in counted), readings)

    def find(self) -> FoundSoFar:
        """What the touches show of the feature in hand, worked out once for each state."""
        part = self.part()
        if isinstance(part, OperationError):
            return FoundSoFar(refusal=part)
        if part is None or self.state.step not in TOUCHING:
            return FoundSoFar()
        from crenel.parts.session.evaluate_so_far import find_so_far

        state = self.state
        wanted = {state.feature} - set(part.datums)
        key = state.session_id, state.counted, state.step, state.feature
        return self._found.get(key, lambda: find_so_far(part, self.gather_touches(), wanted))

    def by_feature(self, found: FoundSoFar) -> "dict[str, tuple[DimensionResult, ...]]":
        """What was stated of each feature with its present touches; after a restart what is not
        known any more is worked out again, once."""
        part = self.part()
        if part is None or isinstance(part, OperationError) or self.state.step != "measure":
            return {}
        from crenel.parts.session.evaluate_so_far import find_so_far

        state = self.state
        keys: dict[str, object] = {}
        for one in state.features:
            if not one.is_datum and state.count(one.id) >= one.least:
                of = {one.id, *part.datums}
                keys[one.id] = tuple(each.index for each in state.counted if each.feature in of)
        if state.feature in keys:
            self._state(part, state.feature, keys[state.feature], found)
        lacking = {
            name for name, key in keys.items() if self._stated.get(name, (None, ()))[0] != key
        }
        if lacking:
            again = find_so_far(part, self.gather_touches(), lacking)
            for name in lacking:
                self._state(part, name, keys[name], again)
        return {name: self._stated[name][1] for name in keys}

    def _state(self, part: "PartKnowledge", name: str, key: object, found: FoundSoFar) -> None:
        own = (one for one in part.program.dimensions if name in one.features)
        stated = tuple(found.dimensions[one.id] for one in own if one.id in found.dimensions)
        self._stated[name] = key, stated

    def tips_mm(self, found: FoundSoFar) -> dict[int, tuple[float, float, float]]:
        part, counted = self.part(), self.state.counted
        if found.frame is None or part is None or isinstance(part, OperationError) or not counted:
            return {}
        centres = tip_centres(part.station.arm, np.array([one.reading for one in counted]))
        places = apply(inverse(found.frame.T_arm_part), centres).round(2).tolist()
        return {one.index: (x, y, z) for one, (x, y, z) in zip(counted, places, strict=True)}

    def result(self) -> "InspectionFile | None":
        """What the inspection found; None before it was evaluated, or if it cannot be read."""
        state = self.state
        if not state.result:
            self._result.forget()
            return None
        from crenel.parts.document_results import RESULTS, InspectionFile

        try:
            return self._result.get(
                (state.session_id, state.rev), lambda: InspectionFile.read(self.folder / RESULTS)
            )
        except OperationError:
            return None
