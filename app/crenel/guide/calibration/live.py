"""What the flow's view depends on beside the journal. Pure."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace

from crenel.errors import sentence
from crenel.findings import Finding
from crenel.formats.datasheets.sensor import SensorDatasheet
from crenel.guide.calibration.outcome import CalibrationOutcome
from crenel.guide.calibration.poses.advice import Advice
from crenel.guide.common.datasheet_library import DatasheetLibrary
from crenel.guide.common.rules import SessionLive
from crenel.guide.common.view import TouchedPoint
from crenel.messages.message import Text, message
from crenel.metrology.adjustment.planning.next_pose import PoseDelta
from crenel.metrology.adjustment.planning.next_touches import TouchAdvice
from crenel.metrology.arm.kinematics import AnyArm
from crenel.metrology.arm.reported_poses import ReadingKind
from crenel.metrology.probing.alignment import Alignment
from crenel.metrology.targets.chessboard import Chessboard
from crenel.metrology.targets.target import CalibrationTarget
from crenel.station.devices.link_state import DeviceState
from crenel.station.devices.rig import NamedSensor
from crenel.station.devices.stillness import Stillness


@dataclass(frozen=True)
class ConnectedArm:
    """What the arm on the line says of itself."""

    serial_number: str
    joint_count: int
    reports: ReadingKind


@dataclass(frozen=True)
class ConnectedSensor:
    """What the sensor on the line says of itself."""

    serial_number: str
    width_px: int
    height_px: int


@dataclass(frozen=True)
class CameraCalibration:
    """The calibration in use where it has camera and mounting alone, and the devices it is of."""

    id: str
    name: str
    arm_serial: str
    sensor_serial: str


@dataclass(frozen=True)
class SelectedDatasheets:
    """The datasheets that the session's choices name; None where there is none (any more)."""

    arm: AnyArm | None
    object: CalibrationTarget | None
    sensor: SensorDatasheet | None

    @property
    def board(self) -> Chessboard | None:
        """The object where it is a chessboard."""
        return self.object if isinstance(self.object, Chessboard) else None


@dataclass(frozen=True)
class TouchReport:
    """The contact points taken so far, where they put the object, and the findings about them."""

    points: tuple[TouchedPoint, ...]
    alignment: Alignment | None
    """The block's place; None before it is known, and always on a board."""
    missing: Text
    """What to probe before anything can be computed; empty when nothing is missing."""
    findings: tuple[Finding, ...]
    questionable: tuple[int, ...]
    """Indices of points that should be taken away."""
    advice: TouchAdvice | None = None
    """How many more, on which face, make the object known as well as is wanted."""
    target_um: float = 0.0
    doubts: Mapping[int, Text] = field(default_factory=dict)
    """By the index of a point: that it or another one is off while nothing tells which."""

    def with_doubt(self, doubtful: Iterable[int]) -> "TouchReport":
        """The same, with a finding that one of these points is off, if there are any."""
        numbers = tuple(doubtful)
        if not numbers:
            return self
        listed = ", ".join(str(i + 1) for i in numbers)
        text = sentence(message("one-of-points-off", points=listed))
        finding = Finding("attention", text, message("touch-again-beside-these"))
        doubts = {**self.doubts, **dict.fromkeys(numbers, text)}
        return replace(self, findings=(*self.findings, finding), doubts=doubts)

    def face_rms_um(self, face: str) -> float | None:
        if self.alignment is None:
            return None
        return next((f.rms_mm * 1e3 for f in self.alignment.faces if f.face == face), None)


@dataclass(frozen=True)
class CalibrationLive(SessionLive):
    """The station as it is now."""

    rev: int
    """Number of the newest row in the station's whole journal."""
    arm_link: DeviceState
    sensor_link: DeviceState
    arm: ConnectedArm | None
    sensor: ConnectedSensor | None
    stillness: Stillness
    library: DatasheetLibrary
    chosen: SelectedDatasheets
    touch: TouchReport | None
    """None until an arm and an object are chosen."""
    taking_poses: bool
    """Whether pictures are taken by themselves."""
    laser_on: bool
    corners_detected: int
    """Corners of the object found in the live picture."""
    picture_findings: tuple[Finding, ...]
    """Exposure, saturation and sharpness of the live picture."""
    latest_outcome: CalibrationOutcome | None
    """What the solve, or before it the capture, found in the pictures; in the review the
    last solve's, even where a pose was set aside or taken back since."""
    capture_outcomes: Mapping[int, CalibrationOutcome]
    """What each capture showed as it was taken, by the pose's number."""
    advice: Advice | None
    """Which pose to take next, for the points and pictures as they are."""
    to_move: PoseDelta | None
    """What is still to be moved to the advised hold."""
    scanning: bool
    tip: Finding | None
    """What the last check of the tip says, while the set-up is looked at."""
    devices: tuple[NamedSensor, ...] = ()
    """The sensors to choose from, at a station with several."""
    without_laser: CameraCalibration | None = None
    """The calibration in use, if the laser can be added to it with the chosen datasheets."""

    @property
    def links(self) -> tuple[DeviceState, DeviceState]:
        """The links of the arm and of the sensor."""
        return self.arm_link, self.sensor_link
