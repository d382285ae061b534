"""The steps 'place', 'capture' and 'solve': the calibration picture. Pure."""

from collections.abc import Sequence

from crenel.errors import sentence
from crenel.findings import Finding, Quality
from crenel.guide.calibration.live import CalibrationLive
from crenel.guide.calibration.poses.advice import ENOUGH_OF_A_BOARD, ENOUGH_POSES, Advice
from crenel.guide.calibration.poses.board_views import plan_view, view_instruction
from crenel.guide.calibration.rules import can_take_poses, offer
from crenel.guide.calibration.state import CAMERA, CalibrationState, SolveFailure
from crenel.guide.calibration.steps.body import StepView
from crenel.guide.calibration.steps.first_pose import first_outline
from crenel.guide.calibration.steps.line import line_form
from crenel.guide.calibration.steps.poses import pose_pictures
from crenel.guide.common.flow import device_findings
from crenel.guide.common.view import (
    Action,
    CameraPicture,
    LiveNumber,
    StepProgress,
    StillPicture,
)
from crenel.messages.message import Text, mentions, message, quantity
from crenel.metrology.adjustment.board.laser_lines import FEWEST_LINES
from crenel.metrology.adjustment.planning.next_pose import PoseDelta

FEWEST_CORNERS = 8
# A hold is the advised one within these.
NEAR_DEG, NEAR_MM = 5.0, 5.0


def place_step(state: CalibrationState, live: CalibrationLive) -> StepView:
    """Bring the sensor over the object and clamp the arm."""
    found = live.corners_detected >= FEWEST_CORNERS
    there = live.to_move is None or is_reached(live.to_move)
    planned, picture = _plan_view(state, live), _camera(state, live)
    goal: Text = message("hold-sensor-over-object-another-way")
    if picture.target:
        goal = message("hold-sensor-over-object-so-lies")
    if planned is not None:
        goal = view_instruction(planned)
    elif live.advice is not None and not there:
        goal = message("next-pose-follow-dashed-outline", words=live.advice.words)
    return StepView(
        instruction=(
            message("object-picture-hold-arm-there-clamp")
            if found and there and planned is None
            else goal
        ),
        picture=picture,
        number=_to_go(live) or _stillness(live),
        progress=_poses(state, live),
        findings=[
            *device_findings(*live.links),
            *_picture_findings(live),
            *_about_line(live),
        ],
        actions=[
            offer(state, live, "confirm_place", message("object-picture"), primary=True),
            *_offer_taking(state, live),
            *_enough(state, live),
        ],
    )


def capture_step(state: CalibrationState, live: CalibrationLive) -> StepView:
    """Take the picture while the arm is still."""
    return StepView(
        instruction=message("hold-still-take-picture-laser-switches"),
        picture=_camera(state, live),
        number=_stillness(live),
        progress=_poses(state, live),
        findings=[*device_findings(*live.links), *_picture_findings(live)],
        actions=[
            offer(state, live, "capture", message("take-picture"), primary=True),
            *_enough(state, live),
        ],
    )


def _offer_taking(state: CalibrationState, live: CalibrationLive) -> list[Action]:
    """Offers that pictures are taken whenever a robot with a board rests."""
    if not can_take_poses(live) or live.taking_poses:
        return []
    return [offer(state, live, "take_poses", message("picture-whenever-robot-rests"))]


def _poses(state: CalibrationState, live: CalibrationLive) -> StepProgress:
    """How many poses there are, of as many as are asked for while they help."""
    done = len(state.pictures)
    if live.advice is not None and not live.advice.worth_it:
        return StepProgress(done, done, message("poses-enough", done=done))
    enough = ENOUGH_POSES if live.chosen.board is None else ENOUGH_OF_A_BOARD
    of = max(done, enough)
    return StepProgress(done, of, message("up-poses", done=done, of=of))


def _enough(state: CalibrationState, live: CalibrationLive) -> list[Action]:
    """The way on without another pose, where there are some."""
    count = len(state.pictures)
    if not count:
        return []
    label = message("go-pose-count-one-other-s", count=count)
    return [offer(state, live, "keep_picture", label)]


def _camera(state: CalibrationState, live: CalibrationLive) -> CameraPicture:
    """With the outline to match: of the advised pose, or of a good first one."""
    item, sensor = live.chosen.object, live.chosen.sensor
    planned = _plan_view(state, live)
    if item is None or sensor is None:
        return CameraPicture()
    size_px, upright = (sensor.width_px, sensor.height_px), sensor.stripe_axis == "u"
    if planned is not None:
        return CameraPicture(first_outline(item, *size_px, upright, planned))
    if live.advice is not None:
        return CameraPicture(live.advice.outline)
    return CameraPicture(() if state.pictures else first_outline(item, *size_px, upright))


def _plan_view(state: CalibrationState, live: CalibrationLive) -> PoseDelta | None:
    """A view of the plan for the first views of a chessboard; there is no advice before them."""
    return plan_view(state.listed) if live.chosen.board is not None else None


def _about_line(live: CalibrationLive) -> list[Finding]:
    """A block is crossed by the line wherever it is sharp; a board, only where it is held so."""
    if live.chosen.board is None or live.laser_on:
        return []
    return [
        Finding(
            "neutral",
            message("lasers-line-must-cross-chessboard", fewest=FEWEST_LINES),
            message("switch-laser-look-where-lies"),
        )
    ]


def _to_go(live: CalibrationLive) -> LiveNumber | None:
    """How far the present hold is from the advised one."""
    if live.to_move is None:
        return None
    left = live.to_move
    there = is_reached(left)
    return LiveNumber(
        message("still-turn"),
        left.largest_deg,
        "°",
        0,
        "good" if there else "attention",
        message("hold-there") if there else message("capital", text=left.words),
    )


def is_reached(left: PoseDelta) -> bool:
    """Whether a hold is as good as the advised one."""
    return left.largest_deg < NEAR_DEG and abs(left.higher_mm) < NEAR_MM


def solve_step(state: CalibrationState, live: CalibrationLive) -> StepView:
    """Take another pose, or compute the calibration from the points and the pictures."""
    advice = live.advice
    findings = list(live.latest_outcome.findings) if live.latest_outcome else []
    findings.sort(key=lambda finding: finding.quality != "bad")
    refused = state.refused if state.refused and state.refused.inputs == state.inputs else None
    if refused is not None:
        quality: Quality = "attention" if _only_lines_missing(refused, live) else "bad"
        error = refused.error.finding(quality, message("go-back-take-picture-points-again"))
        # a finding about the shown picture may give the same reason
        if not any(mentions(finding.text, error.text) for finding in findings):
            findings.insert(0, error)
    lines_missing = refused is not None and _only_lines_missing(refused, live)
    unusable = (refused is not None and not lines_missing) or any(
        finding.quality == "bad" for finding in findings
    )
    planned = _plan_view(state, live)
    wanted = planned is not None or (advice is not None and advice.worth_it)
    more = not unusable and (lines_missing or wanted)
    if advice is not None and not (more or unusable):
        findings.append(_advice_finding(advice))
    return StepView(
        instruction=_solve_instruction(state, live, refused is not None, unusable, more),
        picture=_pose_gallery(state, live),
        number=_uncertainty_number(advice) if advice else None,
        progress=_poses(state, live),
        findings=findings,
        actions=[
            offer(state, live, "another_pose", message("take-another-pose"), primary=more),
            offer(state, live, "solve", message("calibrate"), primary=not (unusable or more)),
            *_offer_without_laser(state, live, lines_missing),
            offer(state, live, "retake", message("take-picture-again"), primary=unusable),
            offer(state, live, "back", message("back-points"), {"to": "touch"}),
        ],
    )


def _offer_without_laser(
    state: CalibrationState, live: CalibrationLive, lines_missing: bool
) -> list[Action]:
    """Where the pictures of a board do for camera and mounting, and not for the laser."""
    if not lines_missing or state.choices.get(CAMERA):
        return []
    return [offer(state, live, "solve_without_laser", message("calibrate-without-the-laser"))]


def _only_lines_missing(refused: SolveFailure, live: CalibrationLive) -> bool:
    """Whether the pictures of a chessboard are good, and too few of them show the laser's line."""
    return live.chosen.board is not None and refused.error.code == "stripe-not-found"


def _solve_instruction(
    state: CalibrationState, live: CalibrationLive, refused: bool, unusable: bool, more: bool
) -> Text:
    if refused:
        return message("not-computed-data-kept")
    if unusable:
        others = "yes" if len(state.pictures) > 1 else "no"
        return message("picture-cannot-be-used-take-it-again", others=others)
    count = len(state.pictures)
    taken = message("pose-count-one-other-s-taken", count=count)
    planned = _plan_view(state, live)
    if more and planned is not None:
        return message("take-another", taken=taken, words=planned.words)
    if more and live.advice is not None:
        return message("take-another", taken=taken, words=live.advice.words)
    return message("compute-calibration-take-another-pose", taken=taken)


def _advice_finding(advice: Advice) -> Finding:
    return Finding(
        "neutral",
        message(
            "pose-would-help-most-scanned-point",
            words=advice.words,
            now=quantity(advice.now_um, "µm"),
            then=quantity(advice.then_um, "µm"),
        ),
        "" if advice.worth_it else message("more-poses-would-bring-little"),
    )


def _uncertainty_number(advice: Advice) -> LiveNumber:
    return LiveNumber(
        message("uncertainty-scanned-point-so-far-k"),
        advice.now_um,
        "µm",
        0,
        "neutral",
        message("after-advised-pose", then=quantity(advice.then_um, "µm")),
    )


def _pose_gallery(state: CalibrationState, live: CalibrationLive) -> StillPicture | CameraPicture:
    """The poses taken so far, the newest shown first."""
    if state.picture is None:
        return CameraPicture()
    return StillPicture(pose_pictures(state, live), state.picture.number, line_form(state, live))


def _stillness(live: CalibrationLive) -> LiveNumber:
    still = live.stillness
    moved_um = None if still.moved_um != still.moved_um else still.moved_um
    return LiveNumber(
        message("movement-tip"),
        moved_um,
        "µm",
        0,
        "good" if still.still else "attention",
        still.text,
    )


def _picture_findings(live: CalibrationLive) -> list[Finding]:
    """What is to be said of the live picture, each thing once."""
    if live.corners_detected >= FEWEST_CORNERS:
        found = Finding(
            "good", message("corners-object-found", corners_detected=live.corners_detected)
        )
        # their number stands below the picture, too: what needs attention has the space
        return _once(live.picture_findings) or [found]
    if live.laser_on:
        return [
            Finding(
                "neutral",
                message("laser-beside-object-may-too-dark"),
                message("switch-off-aim-picture-switched-itself"),
            )
        ]
    return _once(live.picture_findings)


def _once(findings: Sequence[Finding]) -> list[Finding]:
    """Each once, and none that another one gives as its reason."""
    once: dict[Text, Finding] = {}
    for finding in findings:
        others = (other.text for other in findings if other.text != finding.text)
        if not any(mentions(other, finding.text) for other in others):
            text, remedy = sentence(finding.text), sentence(finding.remedy)
            once[text] = Finding(finding.quality, text, remedy)
    return list(once.values())
