"""What a fresh capture shows, so that a useless picture is told of at once."""

from collections.abc import Mapping, Sequence

from app.errors import Refusal
from app.findings import Finding
from app.guide.calibration.live import Chosen
from app.guide.calibration.outcome import Outcome
from app.guide.common.view import ImageCorner, sentence
from app.metrology.adjustment.block.calibrate import see_pose
from app.metrology.adjustment.board.calibrate import see_board
from app.metrology.adjustment.board.initial_guess import SeenBoard
from app.metrology.detection.failure_evidence import DetectionRefusal
from app.metrology.stripe import Stripe, extract_stripe
from app.metrology.targets.chessboard import Chessboard
from app.metrology.targets.crenellated_block import Crenellated
from app.metrology.targets.target import CalibrationObject
from app.station.devices.capture import Capture
from app.station.preview.image_quality import picture_words, refused
from app.station.preview.target_overlay import Drawn, block_drawn, board_drawn
from app.workflows.calibrate import AnySeen

SHOWN_STRIPE_POINTS = 300


def look_at(taken: Capture, chosen: Chosen, number: int) -> tuple[Outcome, AnySeen | Refusal]:
    """What the pictures of a pose show by themselves, in words and for the adjustment."""
    item = chosen.object
    assert item is not None
    assert chosen.sensor is not None
    ambient = taken.ambient.image
    laser = None if taken.laser is None else taken.laser.image
    findings = [_told(finding) for finding in picture_words(ambient)]
    stripe = extract_stripe(ambient if laser is None else laser, chosen.sensor.stripe_axis)
    if len(stripe.u) == 0:
        findings.append(
            Finding(
                "bad",
                "No laser stripe is in the picture.",
                "Check the laser and the exposure, then take a new picture.",
            )
        )
    seen: AnySeen
    try:
        if isinstance(item, Chessboard):
            seen = see_board(number, item, ambient, laser, chosen.sensor.stripe_axis)
        else:
            seen = see_pose(number, item, ambient, laser, chosen.sensor.stripe_axis)
    except Refusal as refusal:
        return _unusable(refusal, stripe, findings), refusal
    found = drawn(seen, item)
    corners = [
        ImageCorner(corner.name, corner.u, corner.v, corner.residual_px) for corner in found.corners
    ]
    return Outcome(corners, found.outline, shown(stripe), findings, None), seen


def drawn(seen: AnySeen, item: CalibrationObject) -> Drawn:
    """What a pose showed of the object, for drawing."""
    if isinstance(seen, SeenBoard):
        assert isinstance(item, Chessboard)
        return board_drawn(seen.detection, item)
    assert isinstance(item, Crenellated)
    return block_drawn(seen.detection, item)


def _told(finding: Finding) -> Finding:
    return Finding(finding.quality, sentence(finding.text), sentence(finding.remedy))


def _unusable(refusal: Refusal, stripe: Stripe, findings: Sequence[Finding]) -> Outcome:
    """A picture that was declined: which of exposure, focus, framing, object or lighting is at
    fault, and what shows it."""
    told = _told(refused(refusal))
    if not isinstance(refusal, DetectionRefusal):
        first = Finding("bad", told.text, told.remedy)
        return Outcome((), (), shown(stripe), [first, *findings], None)
    named = f"{refusal.fault.capitalize()} is at fault. {told.text}"
    # the picture's own words say the same again
    others = [] if refusal.fault in ("exposure", "focus") else findings
    return Outcome(
        corners=(),
        outline=(),
        stripe=shown(stripe),
        findings=[Finding("bad", named, told.remedy), *others],
        result=None,
        marks=refusal.marks,
        fault=refusal.fault,
    )


def shown(stripe: Stripe) -> list[tuple[float, float]]:
    """The stripe thinned for drawing."""
    step = max(1, -(-len(stripe.u) // SHOWN_STRIPE_POINTS))
    return [
        (round(float(u), 2), round(float(v), 2))
        for u, v in zip(stripe.u[::step], stripe.v[::step], strict=True)
    ]


class SeenPoses:
    """Of one session at a time; what is not remembered is looked at again from its files."""

    def __init__(self) -> None:
        self._session_id = ""
        self._seen: dict[int, AnySeen | Refusal] = {}

    def keep(self, session_id: str, number: int, seen: AnySeen | Refusal) -> None:
        """Remembers what a pose's pictures showed."""
        if session_id != self._session_id:
            self._session_id, self._seen = session_id, {}
        self._seen[number] = seen

    def of(self, session_id: str) -> Mapping[int, AnySeen | Refusal]:
        """What is known of a session's poses, by number."""
        return dict(self._seen) if session_id == self._session_id else {}
