"""What a fresh capture shows, so that a useless picture is told of at once."""

from collections.abc import Sequence

from app.files.calibrate import AnySeen
from app.guide.live import Chosen
from app.guide.outcome import Outcome
from app.guide.view import ImageCorner
from app.guide.wording import sentence
from app.metrology.adjustment.board_joint import see_board
from app.metrology.adjustment.board_start import SeenBoard
from app.metrology.adjustment.joint import see_pose
from app.metrology.chessboard.board import Chessboard
from app.metrology.crenellated import Crenellated
from app.metrology.detection.evidence import DetectionRefusal
from app.metrology.objects import CalibrationObject
from app.metrology.refusal import Refusal
from app.metrology.stripe import Stripe, extract_stripe
from app.station.capture import Capture
from app.station.findings import Finding
from app.station.picture_words import picture_words, refused
from app.station.seen_object import Drawn, block_drawn, board_drawn

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
