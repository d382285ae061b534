"""What a fresh capture shows, so that a useless picture is reported at once."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from crenel.errors import OperationError, sentence
from crenel.findings import Finding
from crenel.formats.settings.line_settings import AUTOMATIC_LINE, LineSettings
from crenel.guide.calibration.live import SelectedDatasheets
from crenel.guide.calibration.outcome import CalibrationOutcome
from crenel.guide.common.view import ImageCorner
from crenel.messages.message import message, word
from crenel.metrology.adjustment.block.calibrate import observe_block
from crenel.metrology.adjustment.board.calibrate import observe_board
from crenel.metrology.adjustment.board.initial_guess import BoardObservation
from crenel.metrology.adjustment.board.laser_lines import FEWEST_LINES
from crenel.metrology.detection.failure_evidence import DetectionError
from crenel.metrology.image import Image
from crenel.metrology.stripe import (
    LaserAlone,
    LineSearch,
    Stripe,
    empty_stripe,
    picture_with_line,
)
from crenel.metrology.targets.chessboard import Chessboard
from crenel.metrology.targets.crenellated_block import Crenellated
from crenel.metrology.targets.target import CalibrationTarget
from crenel.station.devices.capture import Capture, Lighting
from crenel.station.preview.image_quality import image_findings
from crenel.station.preview.target_overlay import TargetOverlay, block_overlay, board_overlay
from crenel.workflows.calibrate import AnyDetection

DRAWN_STRIPE_POINTS = 300


@dataclass(frozen=True)
class PosePictures:
    """The pictures (H, W) of a pose, as they were lit."""

    ambient: Image
    laser: Image | None
    lighting: Lighting


def detect_in_capture(
    taken: Capture,
    chosen: SelectedDatasheets,
    number: int,
    line: LineSettings = AUTOMATIC_LINE,
) -> tuple[CalibrationOutcome, AnyDetection | OperationError]:
    """What the pictures of a pose show by themselves, in words and for the adjustment."""
    laser = None if taken.laser is None else taken.laser.image
    pictures = PosePictures(taken.ambient.image, laser, taken.lighting)
    return detect_in_pictures(pictures, chosen, number, line)


def detect_in_pictures(
    taken: PosePictures, chosen: SelectedDatasheets, number: int, line: LineSettings
) -> tuple[CalibrationOutcome, AnyDetection | OperationError]:
    """The same of pictures that were kept, by what is set of the line."""
    item = chosen.object
    assert item is not None
    assert chosen.sensor is not None
    ambient, laser, search = taken.ambient, taken.laser, line.search()
    findings = [_as_sentences(finding) for finding in image_findings(ambient)]
    axis = chosen.sensor.stripe_axis
    seen: AnyDetection
    try:
        if isinstance(item, Chessboard):
            laser_on = taken.lighting != "ambient"
            seen = observe_board(number, item, ambient, laser, axis, laser_on, search)
        else:
            seen = observe_block(number, item, ambient, laser, axis, search)
    except OperationError as refusal:
        stripe = empty_stripe(axis)
        if taken.lighting != "ambient":
            stripe = _line_alone(picture_with_line(ambient, laser), axis, search)
        if isinstance(item, Crenellated) and not len(stripe.u):
            findings.append(_line_missing(item, taken))
        return _unusable(refusal, stripe, findings), refusal
    if not len(seen.stripe.u):
        findings.append(_line_missing(item, taken))
    if isinstance(seen, BoardObservation) and seen.two_lines:
        remedy = sentence(message("switch-one-laser-off-or-cover-it"))
        findings.append(Finding("attention", message("two-lines-in-this-picture"), remedy))
    found = draw_detection(seen, item)
    corners = [
        ImageCorner(corner.name, corner.u, corner.v, corner.residual_px) for corner in found.corners
    ]
    return CalibrationOutcome(
        corners, found.outline, thin_stripe(seen.stripe), findings, None
    ), seen


def _line_alone(picture: LaserAlone, axis: str, search: LineSearch) -> Stripe:
    """The line of a picture without the object; none where what is set is of another picture."""
    try:
        return search.extract(picture, axis)
    except OperationError:
        return empty_stripe(axis)


def draw_detection(seen: AnyDetection, item: CalibrationTarget) -> TargetOverlay:
    """What a pose showed of the object, for drawing."""
    if isinstance(seen, BoardObservation):
        assert isinstance(item, Chessboard)
        return board_overlay(seen.detection, item)
    assert isinstance(item, Crenellated)
    return block_overlay(seen.detection, item)


def _line_missing(item: CalibrationTarget, taken: PosePictures) -> Finding:
    """A block needs the line in every picture; a board, in some."""
    if taken.lighting == "ambient":
        return Finding(
            "attention",
            message("laser-did-not-switch-on"),
            sentence(message("check-lasers-interlock-key-switch-capture")),
        )
    if isinstance(item, Chessboard):
        return Finding(
            "attention",
            message("no-laser-stripe-picture-serves-camera"),
            message("plane-needs-lines-in-some", fewest=FEWEST_LINES),
        )
    return Finding(
        "bad", message("no-laser-stripe-picture"), message("check-laser-exposure-then-take-new")
    )


def _as_sentences(finding: Finding) -> Finding:
    return Finding(finding.quality, sentence(finding.text), sentence(finding.remedy))


def _unusable(
    error: OperationError, stripe: Stripe, findings: Sequence[Finding]
) -> CalibrationOutcome:
    """A picture that was declined: which of exposure, focus, framing, object or lighting is at
    fault, and what shows it."""
    reason, remedy = error.reason, sentence(error.remedy)
    if not isinstance(error, DetectionError):
        first = Finding("bad", reason, remedy)
        return CalibrationOutcome((), (), thin_stripe(stripe), [first, *findings], None)
    named = message("fault", fault=word(error.fault), text=reason)
    # the findings about the picture itself give the same reason
    others = [] if error.fault in ("exposure", "focus") else findings
    return CalibrationOutcome(
        corners=(),
        outline=(),
        stripe=thin_stripe(stripe),
        findings=[Finding("bad", named, remedy), *others],
        result=None,
        marks=error.marks,
        fault=error.fault,
    )


def thin_stripe(stripe: Stripe) -> list[tuple[float, float]]:
    """The stripe thinned for drawing."""
    step = max(1, -(-len(stripe.u) // DRAWN_STRIPE_POINTS))
    return [
        (round(float(u), 2), round(float(v), 2))
        for u, v in zip(stripe.u[::step], stripe.v[::step], strict=True)
    ]


class DetectionCache:
    """The detections of one session at a time; what is not remembered is looked at again from its
    files."""

    def __init__(self) -> None:
        self._session_id = ""
        self._detections: dict[int, AnyDetection | OperationError] = {}

    def keep(self, session_id: str, number: int, seen: AnyDetection | OperationError) -> None:
        """Remembers what a pose's pictures showed."""
        if session_id != self._session_id:
            self._session_id, self._detections = session_id, {}
        self._detections[number] = seen

    def of(self, session_id: str) -> Mapping[int, AnyDetection | OperationError]:
        """What is known of a session's poses, by number."""
        return dict(self._detections) if session_id == self._session_id else {}
