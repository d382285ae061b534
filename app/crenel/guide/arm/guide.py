"""The one arm session of a station: its journal, its points, and what is shown of it."""

from collections.abc import Mapping
from dataclasses import asdict, replace
from pathlib import Path

import numpy as np

from crenel.errors import OperationError
from crenel.formats.atomic_write import ensure_folder, write_atomically
from crenel.formats.datasheets.arm import read_arm
from crenel.formats.io_errors import convert_all_errors, convert_io_errors
from crenel.formats.open_file import read_bounded
from crenel.formats.session.arm_session import ARM, write_observations
from crenel.formats.session.coordinates_table import COORDINATES, parse_coordinates
from crenel.gauges.session.off_gauge import refuse_off_sphere
from crenel.guide.arm.flow import build_view
from crenel.guide.arm.history import KIND, ArmHistory, ArmJournal
from crenel.guide.arm.observations import HOLD_NS, collect_observations, sample_points
from crenel.guide.arm.rules import RULES
from crenel.guide.arm.state import (
    POINTS,
    ArmLive,
    ArmState,
    Artefact,
    Purpose,
    apply_row,
    place_name,
)
from crenel.guide.arm.view import ArmView
from crenel.guide.common.datasheet_library import (
    DatasheetLibrary,
    FolderContent,
    guess_arm,
    read_gauges,
    read_library,
)
from crenel.guide.common.flow import Flow
from crenel.guide.common.guided_session import (
    NO_PROVENANCE,
    GuidedSession,
    Provenance,
    StationServices,
    new_session_id,
)
from crenel.messages.message import message
from crenel.metrology.arm.kinematics import Arm, tip_centres
from crenel.metrology.decision import GUARDED_95, DecisionRule
from crenel.metrology.transforms import Floats

FLOW = Flow(KIND, "arm", ArmState(), apply_row, build_view, RULES, (POINTS,))


class ArmGuide(GuidedSession[ArmState, ArmLive, ArmView]):
    """The latest check, tip check or identification."""

    def __init__(
        self,
        station: StationServices,
        journal: ArmJournal,
        data_folder: Path,
        signing: Provenance = NO_PROVENANCE,
        rule: DecisionRule = GUARDED_95,
    ) -> None:
        super().__init__(station, journal, FLOW, data_folder, signing)
        self.rule = rule
        self.history = ArmHistory(journal)
        self._left_mm: float | None = None
        self._sampled_ns = 0
        self._library = FolderContent(read_library, data_folder)
        self._session_arm: tuple[str, Arm | None] = ("", None)
        self.resume()

    @property
    def folder(self) -> Path:
        """The present session's folder, as ``crenel identify`` and ``articulation`` take it."""
        return self.data_folder / "sessions" / self.state.session_id

    def forget_datasheets(self) -> None:
        self._library.forget()

    # -- what is shown -------------------------------------------------------

    def refresh(self) -> ArmView:
        """Takes the points that have come, and publishes the view if it changed."""
        with self.lock:
            self._take_points()
            return super().refresh()

    def live(self) -> ArmLive:
        """The station as the session sees it."""
        side = self.station.rig.arm
        newest = side.latest() if self.running else None
        return ArmLive(
            library=self.library(),
            arm=self.arm(),
            link=side.link(),
            connected_joints=side.info.joint_count if side.info else None,
            q_rad=None if newest is None else tuple(float(q) for q in newest.reading),
            left_mm=self._left_mm,
            has_simulation=self.station.simulated_operator is not None,
            simulation_running=self.simulation_running,
            busy=self.busy,
            trouble=self._trouble,
        )

    def library(self) -> DatasheetLibrary:
        """The arms with joints that the station knows; read again only while one can be chosen."""
        library = self._library.latest(choosing=not self.running or not self.state.has_points)
        joints = {
            name: entry for name, entry in library.arms.items() if isinstance(entry.datasheet, Arm)
        }
        return replace(library, arms=joints)

    def arm(self) -> Arm | None:
        """The session's own copy of the arm once points were taken, before it the library's."""
        if not self.state.has_points:
            entry = self.library().arms.get(self.state.arm)
            return entry.datasheet if entry and isinstance(entry.datasheet, Arm) else None
        if self._session_arm[0] != self.state.session_id:
            try:
                with convert_all_errors(self.folder):
                    self._session_arm = (self.state.session_id, read_arm(self.folder / ARM))
            except OperationError:
                self._session_arm = (self.state.session_id, None)
        return self._session_arm[1]

    # -- sessions ------------------------------------------------------------

    def start(self, purpose: Purpose) -> ArmView:
        """Begins a session; an open one is resumed instead."""
        with self.lock, self.use_arm():
            if not self.running:
                self.begin(purpose, None)
            return self.refresh()

    def begin(self, purpose: Purpose, key: str | None) -> None:
        """A new session with the last one's limit, and the connected arm's datasheet."""
        payload = {
            "purpose": purpose,
            "arm": self._best_guess(),
            "limit_um": self._last_limit_um(purpose),
        }
        sphere = self._last_sphere() if purpose == "tip" else None
        self.begin_session(ArmState(session_id=new_session_id()), payload, key)
        if sphere is not None:
            self.append("artefact_chosen", asdict(sphere))

    def _last_limit_um(self, purpose: Purpose) -> float | None:
        """The one set last for the same; an open session's may be not in its history yet."""
        if self.state.purpose == purpose and self.state.session_id:
            return self.state.limit_um
        return self.history.last_limit_um(purpose)

    def _last_sphere(self) -> Artefact | None:
        """The sphere that the tip was checked on last, or the only one that is known."""
        operator = self.station.simulated_operator
        if operator is not None:
            return Artefact("sphere", operator.ball_mm)
        if (last := self.history.last_sphere()) is not None:
            return last
        spheres = [
            entry.datasheet
            for entry in read_gauges(self.data_folder).known.values()
            if entry.datasheet.radius_mm is not None
        ]
        if len(spheres) != 1 or spheres[0].radius_mm is None:
            return None
        sd_mm = 2 * spheres[0].standard_uncertainty_um / 1e3
        return Artefact("sphere", 2 * spheres[0].radius_mm, sd_mm)

    def _best_guess(self) -> str:
        info = self.station.rig.arm.info
        return guess_arm(self.library().arms, info.serial_number if info else "", self.state.arm)

    # -- changes -------------------------------------------------------------

    def after_change(self) -> None:
        """A command's rows are published once it is done, and points with the next refresh."""
        self.changed.notify_all()

    # -- seats ---------------------------------------------------------------

    def begin_seat(self, key: str | None) -> None:
        """From now on points are taken while the arm swings."""
        if not self.state.has_points:
            self._keep_arm()
        newest = self.station.rig.arm.latest()
        self._sampled_ns = newest.stamp_ns if newest else 0
        self._left_mm = None
        artefact = self.state.artefact if self.state.purpose != "check" else Artefact()
        self.append("seat_begun", {"name": self._next_name(), "artefact": asdict(artefact)}, key)

    def _next_name(self) -> str:
        state = self.state
        if state.purpose == "identify" and state.artefact.kind == "bar":
            return place_name("bar", state.bar_ends // 2 + 1, "AB"[state.bar_ends % 2])
        known = {seat.name for seat in state.seats}
        names = (place_name(state.artefact.kind, n) for n in range(1, 1000))
        return next(name for name in names if name not in known)

    def choose_artefact(self, args: Mapping[str, object], key: str | None) -> None:
        """What the tip is put to next; the simulated ones have the sizes of their certificates."""
        kind, size, operator = args["kind"], args.get("size_mm"), self.station.simulated_operator
        if size is None and operator is not None and kind != "seat":
            size = operator.bar_mm if kind == "bar" else operator.ball_mm
        unsure = args.get("standard_uncertainty_mm", 0.0)
        payload = {"kind": kind, "size_mm": size, "standard_uncertainty_mm": unsure}
        self.append("artefact_chosen", payload, key)

    def touch(self, until_ns: int | None, key: str | None) -> None:
        """Takes the point of the sphere that the tip touches, or touched at ``until_ns``.

        Raises:
            OperationError: the arm is lost or moves, or the point is not on the sphere of those
                before.
        """
        side = self.station.rig.arm
        side.set_model(self.arm())  # by which it is judged whether the arm is still
        mean = side.average(until_ns=until_ns)
        side.refuse_scan_end(mean.reading)
        self._refuse_off_sphere(mean.reading)
        self.append(POINTS, {"q_rad": [mean.reading.tolist()]}, key)
        seat = self.state.seats[-1]
        self.station.bus.event(
            "point_taken", message("point", number=len(seat.q_rad), place=seat.place)
        )

    def _refuse_off_sphere(self, reading: Floats) -> None:
        arm, seat = self.arm(), self.state.seats[-1]
        if arm is None or seat.artefact.size_mm is None or not seat.q_rad:
            return
        tips = tip_centres(arm, np.array([*seat.q_rad, reading]))
        reach_mm = seat.artefact.size_mm / 2 + arm.tip.radius_mm
        refuse_off_sphere(tips[:-1], tips[-1], reach_mm)

    def end_seat(self, key: str | None) -> None:
        """Ends the swing, with the points up to now."""
        self._take_points(hold_ns=0)
        self.append("seat_ended", {}, key)
        self.keep_seats()

    def _take_points(self, hold_ns: int = HOLD_NS) -> None:
        """Brings the points up to date with the joints that have streamed in.

        The newest wait for ``hold_ns``, until it is known that the tip stays in the seat.
        """
        arm = self.arm() if self.state.swinging and not self.state.ended else None
        if arm is None or self.state.touching:
            return
        side = self.station.rig.arm
        newest = side.latest()
        if newest is None:
            return
        # after a restart the swing goes on from now
        first_ns, last_ns = self._sampled_ns or newest.stamp_ns, newest.stamp_ns - hold_ns
        if last_ns < first_ns:
            return
        window = side.window(first_ns - HOLD_NS, newest.stamp_ns)
        self._sampled_ns = last_ns + 1
        if window is None or window.readings.shape[1] != arm.joint_count:
            return
        picked = sample_points(arm, self.state.seats[-1].q_rad, window, first_ns, last_ns)
        self._left_mm = picked.left_mm
        if picked.q_rad:
            self.append(POINTS, {"q_rad": picked.q_rad})

    # -- coordinates -----------------------------------------------------------

    def take_coordinates(self, text: str, name: str, key: str | None) -> None:
        """Takes the text of a ``coordinates.csv`` for those of the session, in place of earlier
        ones.

        Args:
            name: of the file that the operator chose.

        Raises:
            OperationError: the table is not in order; earlier coordinates then stay.
        """
        arm = self.arm()
        assert arm is not None
        found = parse_coordinates(text, Path(name), arm)
        if not self.state.has_points:
            self._keep_arm()
        path = self.folder / COORDINATES
        with convert_io_errors(path):
            write_atomically(path, text.encode())
        points = sum(len(one.q_rad) for one in found)
        self.append("coordinates_taken", {"points": points}, key)

    def drop_coordinates(self, key: str | None) -> None:
        """The session goes on without the coordinates."""
        with convert_io_errors(self.folder):
            (self.folder / COORDINATES).unlink(missing_ok=True)
        self.append("coordinates_dropped", {}, key)

    # -- the session's folder -------------------------------------------------

    def _keep_arm(self) -> None:
        entry = self.library().arms[self.state.arm]
        with convert_io_errors(self.folder):
            ensure_folder(self.folder)
            write_atomically(self.folder / ARM, read_bounded(entry.path))

    def keep_seats(self) -> None:
        """Brings the session's tables up to date."""
        write_observations(self.folder, collect_observations(self.state))
