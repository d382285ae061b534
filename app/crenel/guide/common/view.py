"""What the browser is shown of a guided session."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Literal

from crenel.findings import Finding, Quality
from crenel.guide.common.result_view import CalibrationResult
from crenel.messages.message import Text
from crenel.metrology.detection.failure_evidence import ImageAnnotation
from crenel.metrology.stripe import PeakChoice

Vec3 = tuple[float, float, float]
Segment = tuple[float, float, float, float]
StepState = Literal["done", "current", "todo", "stale"]


@dataclass(frozen=True)
class LiveNumber:
    """A number that the operator watches."""

    label: Text
    value: float | None
    unit: str
    decimals: int
    quality: Quality = "neutral"
    note: Text = ""


@dataclass(frozen=True)
class Action:
    """An action that the operator may perform now, or the reason why not."""

    name: str
    label: Text
    args: Mapping[str, object] = field(default_factory=dict)
    primary: bool = False
    enabled: bool = True
    why_not: Text = ""
    confirm: Text = ""


@dataclass(frozen=True)
class Step:
    id: str
    title: Text
    state: StepState


@dataclass(frozen=True)
class BlockGeometry:
    """The block for drawing, in mm, from its certificate."""

    edges_x_mm: Sequence[float]
    front_y_mm: float
    back_y_mm: float
    crest_z_mm: float
    floor_z_mm: float
    base_z_mm: float
    kind: Literal["block"] = "block"


@dataclass(frozen=True)
class BoardGeometry:
    """The chessboard for drawing, from its certificate: columns and rows of inner corners."""

    inner_corners: tuple[int, int]
    square_mm: float
    first_is_black: bool = True
    """The outermost square at the first inner corner."""
    kind: Literal["board"] = "board"


ObjectGeometry = BlockGeometry | BoardGeometry


@dataclass(frozen=True)
class TouchedPoint:
    index: int
    face: str
    at_mm: Vec3 | None
    residual_um: float | None
    outlier: bool


@dataclass(frozen=True)
class FaceProgress:
    face: str
    title: Text
    taken: int
    wanted: int
    selected: bool
    rms_um: float | None
    suggested_mm: Sequence[Vec3]


@dataclass(frozen=True)
class ChoiceOption:
    id: str
    label: Text
    detail: Text


@dataclass(frozen=True)
class Choice:
    field: str
    title: Text
    options: Sequence[ChoiceOption]
    selected: str


@dataclass(frozen=True)
class DeviceLine:
    title: Text
    quality: Quality
    text: Text


@dataclass(frozen=True)
class ImageCorner:
    """``off_px`` is detected minus computed (u, v), for a result; ``residual_px`` is its length."""

    name: str
    u: float
    v: float
    residual_px: float | None
    off_px: tuple[float, float] | None = None


@dataclass(frozen=True)
class DevicesPicture:
    devices: Sequence[DeviceLine]
    kind: Literal["devices"] = "devices"


@dataclass(frozen=True)
class ChoicesPicture:
    choices: Sequence[Choice]
    object: ObjectGeometry | None
    kind: Literal["choices"] = "choices"


@dataclass(frozen=True)
class ObjectPicture:
    object: ObjectGeometry
    faces: Sequence[FaceProgress]
    points: Sequence[TouchedPoint]
    kind: Literal["object"] = "object"


@dataclass(frozen=True)
class CameraPicture:
    """The live picture; ``target`` is the object as it would look from the suggested hold, or
    approximately for the first picture."""

    target: Sequence[Segment] = ()
    kind: Literal["camera"] = "camera"


@dataclass(frozen=True)
class PosePicture:
    """One pose: its picture with the detections in it, or with the reasons for none (``marks``).

    ``note`` says why it does not count; the figures are those of the result, if there is one.
    ``action`` excludes the pose or includes it again.
    """

    number: int
    state: Literal["taken", "used", "left_out", "aside"]
    note: Text
    image_url: str
    width_px: int
    height_px: int
    corners: Sequence[ImageCorner]
    outline: Sequence[Segment]
    stripe: Sequence[tuple[float, float]]
    marks: Sequence[ImageAnnotation]
    edges_rms_px: float | None
    stripe_rms_px: float | None
    off_um: float | None
    action: Action | None
    stripe_off: Sequence[Vec3] = ()
    """For a result: u, v of some of the stripe's points, and how far each lies off (px)."""
    bundle_url: str = ""
    """The address of a pose with trouble: its pictures with their context, as one file to send."""


@dataclass(frozen=True)
class LineForm:
    """What is set of the laser's line, None where it is automatic, and the action that sets it.

    ``refused``: numbers of the poses in whose pictures no line was found.
    """

    threshold: float | None
    min_width_px: float | None
    max_width_px: float | None
    choice: PeakChoice
    refused: Sequence[int]
    action: Action


@dataclass(frozen=True)
class StillPicture:
    """The poses taken so far; ``shown`` is the one in view. ``line`` is offered where a line was
    refused."""

    poses: Sequence[PosePicture]
    shown: int
    line: LineForm | None = None
    kind: Literal["still"] = "still"


@dataclass(frozen=True)
class ResultPicture:
    """A result; ``stale`` if a pose was excluded or included since."""

    result: CalibrationResult
    stale: bool
    object: ObjectGeometry
    points: Sequence[TouchedPoint]
    poses: Sequence[PosePicture]
    kind: Literal["result"] = "result"


Picture = (
    DevicesPicture | ChoicesPicture | ObjectPicture | CameraPicture | StillPicture | ResultPicture
)


@dataclass(frozen=True)
class StepProgress:
    done: int
    of: int
    text: Text


def progress_of(done: int, of: int, text: Text, enough: Text) -> StepProgress:
    """What a step has of what it wants; ``enough`` is said where it has more."""
    return StepProgress(min(done, of), of, text if done <= of else enough)


@dataclass(frozen=True)
class Busy:
    """A running job, or the simulated operator at work."""

    text: Text
    fraction: float | None


@dataclass(frozen=True)
class SessionView:
    """What every guided session shows, beside its picture."""

    session_id: str
    rev: int
    running: bool
    steps: Sequence[Step]
    step: str
    title: Text
    instruction: Text
    number: LiveNumber | None
    progress: StepProgress | None
    findings: Sequence[Finding]
    actions: Sequence[Action]
    busy: Busy | None


@dataclass(frozen=True)
class FlowView(SessionView):
    """The whole state of the guided calibration."""

    picture: Picture
