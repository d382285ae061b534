"""A session on a gauge with the calibration in use: its datasheets, its start, its touches."""

from abc import abstractmethod
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Generic, Protocol, TypeVar

import numpy as np

from crenel.errors import OperationError
from crenel.formats.atomic_write import ensure_folder, write_atomically
from crenel.formats.datasheets.arm import read_any_arm
from crenel.formats.io_errors import convert_all_errors, convert_io_errors
from crenel.formats.json_document import Document
from crenel.formats.open_file import read_bounded
from crenel.formats.results.calibration import CALIBRATION, Calibration, read_calibration
from crenel.formats.session.calibration_session import ARM, contact_readings, write_contacts
from crenel.gauges.quick.document import GAUGE
from crenel.guide.common.datasheet_library import (
    CERTIFICATE_ENDING,
    DatasheetEntry,
    FolderContent,
    Gauges,
)
from crenel.guide.common.flow import Flow, View
from crenel.guide.common.guided_session import GuidedSession, Provenance, StationServices
from crenel.guide.common.journal import Calibrations, Journal, StoredCalibration
from crenel.guide.common.rules import Live, SessionState
from crenel.messages.message import Text, message
from crenel.metrology.arm.kinematics import AnyArm
from crenel.metrology.decision import DecisionRule
from crenel.station.devices.reading_buffer import ReadingMean
from crenel.station.scan.scanner import Scanner
from crenel.station.view3d.scene import Scene

Value = TypeVar("Value")


@dataclass(frozen=True)
class GaugeServices(StationServices):
    """The station's parts that a session on a gauge works with."""

    scanner: Scanner
    scene: Scene


class Memo(Generic[Value]):
    """A value that is computed again only once what it depends on has changed."""

    def __init__(self) -> None:
        self._kept: tuple[object, Value] | None = None

    def get(self, key: object, compute: Callable[[], Value]) -> Value:
        """The value for a key; what ``compute`` raises is raised, and nothing is kept then."""
        if self._kept is None or self._kept[0] != key:
            self._kept = key, compute()
        return self._kept[1]

    def forget(self) -> None:
        """Has the value computed again."""
        self._kept = None


class GaugeState(SessionState, Protocol):
    """What the states of sessions on a gauge have."""

    @property
    def gauge(self) -> str:
        """The gauge of the data folder, by the name of its file."""


State = TypeVar("State", bound=GaugeState)
Gauge = TypeVar("Gauge", bound=Document)
"""Its datasheet."""


class TouchReading(Protocol):
    """A touch of the gauge."""

    @property
    def reading(self) -> tuple[float, ...]: ...


class GaugeSession(GuidedSession[State, Live, View], Generic[State, Live, View, Gauge]):
    """The latest session of a kind on a gauge. Its gauge is chosen in its first step.

    Args:
        read: the gauges of a data folder that can be chosen.
        read_one: the datasheet of one of them.
        rule: how values, uncertainties and limits become decisions.
    """

    station: GaugeServices

    def __init__(
        self,
        station: GaugeServices,
        journal: Journal,
        flow: Flow[State, Live, View],
        calibrations: Calibrations,
        data_folder: Path,
        provenance: Provenance,
        rule: DecisionRule,
        read: Callable[[Path], Gauges[Gauge]],
        read_one: Callable[[Path], Gauge],
    ) -> None:
        super().__init__(station, journal, flow, data_folder, provenance)
        self.rule = rule
        self.calibrations = calibrations
        self._first_step = flow.empty.step
        self._gauges, self._read_one = FolderContent(read, data_folder), read_one
        self._session_copies = Memo[tuple[Gauge | None, AnyArm | None]]()

    @property
    @abstractmethod
    def folder(self) -> Path:
        """The present session's folder."""

    # -- what is shown -------------------------------------------------------

    def live_fields(self, arm: AnyArm | None, scans: bool, scanning: bool) -> Mapping[str, Any]:
        """The fields of a ``GaugeLive``.

        Args:
            arm: of the session.
            scans: whether scans can be made now.
            scanning: whether one is under way.
        """
        station, active = self.station, self.active()
        side, scanner = station.rig.arm, station.scanner
        stillness, blocked = side.stillness(), scanner.why_not() if scans else None
        return {
            "active_id": active.id if active else "",
            "active_name": active.name if active else "",
            "arm": arm,
            "arm_link": side.link(),
            "sensor_link": station.rig.sensor.link(),
            "still": stillness.still,
            "strain": stillness.strain,
            "scan_why_not": blocked.text if blocked else "",
            "scan_points": scanner.state().points if scanning else 0,
            "has_simulation": station.simulated_operator is not None,
            "simulation_running": self.simulation_running,
            "busy": self.busy,
            "trouble": self._trouble,
        }

    # -- datasheets ----------------------------------------------------------

    def forget_datasheets(self) -> None:
        self._gauges.forget()

    def gauges(self) -> Gauges[Gauge]:
        """The data folder's; read again only while one can be chosen."""
        return self._gauges.latest(self.is_choosing())

    def is_choosing(self) -> bool:
        """Whether a gauge can be chosen now."""
        return not self.running or self.state.step == self._first_step

    def datasheets(self) -> tuple[Gauge | None, AnyArm | None]:
        """Gauge and arm: the session's own copies once the gauge was confirmed; None for what
        cannot be read."""
        state = self.state
        if state.step == self._first_step or state.ended:
            entry = self.gauges().known.get(state.gauge)
            return entry.datasheet if entry else None, None
        return self._session_copies.get((state.session_id, state.gauge), self._read_copies)

    def _read_copies(self) -> tuple[Gauge | None, AnyArm | None]:
        """Gauge and arm of a session; None, both, if one of them cannot be read. A session may be
        without a gauge."""
        try:
            with convert_all_errors(self.folder):
                gauge = self._read_one(self.folder / GAUGE) if self.state.gauge else None
                return gauge, read_any_arm(self.folder / ARM)
        except OperationError:
            return None, None

    def keep_datasheets(self) -> None:
        """Copies gauge, arm and calibration, which the session uses from now on.

        Raises:
            OperationError: a file cannot be read or written.
        """
        sources = self.sources()
        with convert_io_errors(self.folder):
            ensure_folder(self.folder)
            for name, entry in self.gauge_entries().items():
                if entry.path.suffix == CERTIFICATE_ENDING:
                    entry.datasheet.write(self.folder / name)
                else:
                    sources.append((entry.path, name))
            for source, name in sources:
                write_atomically(self.folder / name, read_bounded(source))
        self._session_copies.forget()

    def sources(self) -> list[tuple[Path, str]]:
        """The files of arm and calibration, with the names of their copies.

        Raises:
            OperationError: there is none.
        """
        active = self.active()
        assert active is not None
        return [(active.file.parent / ARM, ARM), (active.file, CALIBRATION)]

    def gauge_entries(self) -> Mapping[str, DatasheetEntry[Gauge]]:
        """The gauges that the session is done on, by the names of their copies."""
        return {GAUGE: self.gauges().known[self.state.gauge]}

    def active(self) -> StoredCalibration | None:
        """The calibration in use of the selected sensor."""
        return self.calibrations.active(self.station.rig.selected)

    def calibration(self) -> Calibration:
        """The session's own copy; raises ``OperationError``."""
        return read_calibration(self.folder / CALIBRATION)

    # -- sessions ------------------------------------------------------------

    def start(self) -> View:
        """Begins a session; an open one is resumed instead.

        Raises:
            OperationError: there is no calibration in use.
        """
        with self.lock, self.use_arm():
            if not self.running:
                self.begin(None)
            return self.refresh()

    @abstractmethod
    def begin(self, key: str | None) -> None:
        """A new session of the calibration in use, with the gauge of the last."""

    def first_payload(
        self, without_calibration: Text, known: Iterable[str]
    ) -> Mapping[str, object]:
        """The calibration in use, and of the ``known`` gauges that of the last session or the first
        one.

        Raises:
            OperationError: there is no calibration in use, with the text for this case.
        """
        active = self.active()
        if active is None:
            raise OperationError(
                "no-calibration",
                without_calibration,
                message("no-calibration-use-yet"),
                message("calibrate-first"),
            )
        return {"calibration_id": active.id, "gauge": self.first_gauge(known)}

    def first_gauge(self, known: Iterable[str]) -> str:
        """Chooses among the ``known`` gauges that of the last session, or the first one."""
        ids = list(known)
        return self.state.gauge if self.state.gauge in ids else next(iter(ids), "")

    # -- touches -------------------------------------------------------------

    @abstractmethod
    def touch(self, until_ns: int | None, key: str | None) -> None:
        """Takes the place that the tip touches, or touched at ``until_ns``.

        Raises:
            OperationError: the arm is lost or moves, or it cannot be a touch of the gauge.
        """

    @abstractmethod
    def keep_touches(self) -> None:
        """Brings the session's table of touches up to date."""

    def average_touch(self, until_ns: int | None) -> tuple[AnyArm, ReadingMean]:
        """The session's arm, and its mean reading while it touches, or touched at ``until_ns``.

        Raises:
            OperationError: the arm's datasheet cannot be read, or the arm is lost or moves, or
                has not moved since a scan.
        """
        side, (_, arm) = self.station.rig.arm, self.datasheets()
        if arm is None:
            raise OperationError(
                "no-arm-model", message("sessions-arm-cannot-read"), remedy=message("begin-new-one")
            )
        side.set_model(arm)  # by which it is judged whether the arm is still
        mean = side.average(until_ns=until_ns)
        side.refuse_scan_end(mean.reading)
        return arm, mean

    def write_touches(
        self,
        name: str,
        features: Sequence[str],
        touches: Sequence[TouchReading],
        touched_at: Sequence[str] = (),
    ) -> None:
        """Brings the session's table of touches up to date; without touches there is none."""
        path = self.folder / name
        if not touches:
            path.unlink(missing_ok=True)
            return
        readings = np.array([touch.reading for touch in touches])
        arm = read_any_arm(self.folder / ARM)
        write_contacts(path, contact_readings(features, arm, readings), touched_at)
