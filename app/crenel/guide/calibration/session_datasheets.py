"""Which arm, object and sensor a session uses, and how its points agree with them."""

from crenel.guide.calibration.live import (
    ConnectedArm,
    ConnectedSensor,
    SelectedDatasheets,
    TouchReport,
)
from crenel.guide.calibration.session_folder import SessionFolder
from crenel.guide.calibration.state import FIELDS, CalibrationState
from crenel.guide.calibration.touch.report import touch_report
from crenel.guide.common.datasheet_library import (
    DatasheetLibrary,
    FolderContent,
    guess_entry,
    read_library,
)
from crenel.metrology.limits import Limits
from crenel.metrology.targets.chessboard import Chessboard
from crenel.metrology.targets.crenellated_block import Crenellated
from crenel.metrology.targets.target import CalibrationTarget

CHOOSING = ("devices", "setup")
TARGET_SHARE = 0.3
"""The contacts may take so much of what a good calibration may be uncertain by."""


class SessionDatasheets:
    """Reads the datasheets again only when they may have changed; not thread-safe."""

    def __init__(self, folder: SessionFolder, limits: Limits) -> None:
        self._target_um = TARGET_SHARE * limits.good_um
        self.folder = folder
        self._library = FolderContent(read_library, folder.path.parent.parent)
        self._session_copies: SelectedDatasheets | None = None
        self._report: tuple[object, TouchReport | None] = (None, None)

    def library(self, choosing: bool) -> DatasheetLibrary:
        """What the station knows."""
        return self._library.latest(choosing)

    def forget(self) -> None:
        """Has the station's datasheets read again at the next look."""
        self._library.forget()

    def selection(self, state: CalibrationState) -> SelectedDatasheets:
        """The library's datasheets while choosing; later the session's own copies."""
        if state.step in CHOOSING or not state.session_id:
            self._session_copies = None
            library = self.library(True)
            arm, item, sensor = (state.choices.get(name, "") for name in FIELDS)
            return SelectedDatasheets(
                library.arms[arm].datasheet if arm in library.arms else None,
                library.objects[item].datasheet if item in library.objects else None,
                library.sensors[sensor].datasheet if sensor in library.sensors else None,
            )
        if self._session_copies is None:
            self._session_copies = self.folder.datasheets()
        return self._session_copies

    def touch(self, state: CalibrationState) -> TouchReport | None:
        """The touch report of the points that count; computed once for the same points."""
        chosen = self.selection(state)
        key = (state.counted, chosen.arm, chosen.object)
        if self._report[0] != key:
            report = None
            if chosen.arm is not None and chosen.object is not None:
                report = touch_report(state.counted, chosen.arm, chosen.object, self._target_um)
            self._report = (key, report)
        return self._report[1]


def best_guess(
    library: DatasheetLibrary,
    before: CalibrationState,
    arm: ConnectedArm | None,
    sensor: ConnectedSensor | None,
) -> dict[str, str]:
    """What a new session begins with: the connected devices' datasheets, else the last choice,
    else the only one there is; of objects the only block beside any chessboards, or, for an arm
    that reports poses, the only chessboard."""
    guess: dict[str, str] = {}
    arms = {
        entry.id: entry.datasheet.serial_number
        for entry in library.arms.values()
        if arm is None or entry.datasheet.reading_kind == arm.reports
    }
    sensors = {entry.id: entry.datasheet.serial_number for entry in library.sensors.values()}
    fitting = {
        entry.id: entry.datasheet
        for entry in library.objects.values()
        if _can_use(arm, entry.datasheet)
    }
    blocks = [one for one, target in fitting.items() if isinstance(target, Crenellated)]
    for field, known, serial_number in (
        ("arm", arms, arm.serial_number if arm else ""),
        ("object", dict.fromkeys(fitting, ""), ""),
        ("sensor", sensors, sensor.serial_number if sensor else ""),
    ):
        if found := guess_entry(known, serial_number, before.choices.get(field, "")):
            guess[field] = found
        elif field == "object" and len(blocks) == 1:
            guess[field] = blocks[0]
    return guess


def guess_for_connected(
    library: DatasheetLibrary,
    state: CalibrationState,
    arm: ConnectedArm | None,
    sensor: ConnectedSensor | None,
) -> dict[str, str]:
    """Better choices for those that the session began with before the devices were connected: where
    nothing is chosen, and where it cannot belong to the connected arm."""
    guess = best_guess(library, state, arm, sensor)
    chosen = library.objects.get(state.choices.get("object", ""))
    is_fitting = {
        "arm": guess.get("arm") == state.choices.get("arm"),
        "object": chosen is not None and _can_use(arm, chosen.datasheet),
        "sensor": library.has("sensor", state.choices.get("sensor", "")),
    }
    return {field: found for field, found in guess.items() if not is_fitting[field]}


def _can_use(arm: ConnectedArm | None, target: CalibrationTarget) -> bool:
    """An arm that reports poses touches nothing, and needs a chessboard."""
    return arm is None or arm.reports != "pose" or isinstance(target, Chessboard)
