"""The step 'touch': contact points on the object's faces. Pure."""

from crenel.findings import Finding, Quality
from crenel.guide.calibration.live import CalibrationLive, TouchReport
from crenel.guide.calibration.rules import offer
from crenel.guide.calibration.state import CalibrationState
from crenel.guide.calibration.steps.body import StepView, geometry
from crenel.guide.calibration.touch.block import TITLES
from crenel.guide.calibration.touch.report import face_in_use, face_progress, next_face
from crenel.guide.common.flow import device_findings, strain_findings
from crenel.guide.common.view import Action, DevicesPicture, FaceProgress, LiveNumber, ObjectPicture
from crenel.guide.common.view import StepProgress as Progress
from crenel.messages.message import Text, Value, message, quantity
from crenel.metrology.targets.chessboard import Chessboard
from crenel.metrology.targets.crenellated_block import on_face

LISTED_QUESTIONABLE, LISTED_FACES = 3, 3


def touch_step(state: CalibrationState, live: CalibrationLive) -> StepView:
    """Where to touch, how many points there are, and how well they agree."""
    item, touch = live.chosen.object, live.touch
    if item is None or touch is None:
        return StepView(
            instruction=message("arm-object-chosen-cannot-read-any"),
            picture=DevicesPicture([]),
            actions=[],
            findings=live.library.findings,
        )
    if isinstance(item, Chessboard):
        return _on_board(state, live, touch, item)
    selected = face_in_use(state.face, item)
    faces = face_progress(touch, selected, item)
    done = sum(min(face.taken, face.wanted) for face in faces)
    wanted = sum(face.wanted for face in faces)
    return StepView(
        instruction=_instruction(faces, selected, done >= wanted, touch),
        picture=ObjectPicture(geometry(item), faces, touch.points),
        number=_number(touch),
        progress=Progress(done, wanted, message("points-of", taken=done, wanted=wanted)),
        findings=[
            *device_findings(*live.links)[:1],
            *strain_findings(live.stillness.strain),
            *touch.findings,
            *_advice(touch),
        ],
        actions=_actions(state, live, touch, done >= wanted),
    )


def _on_board(
    state: CalibrationState, live: CalibrationLive, touch: TouchReport, board: Chessboard
) -> StepView:
    """A board need not be touched: touches check its squares' size, and where it lies."""
    (face,) = face_progress(touch, state.face, board)
    wanted = face.wanted
    done = min(face.taken, wanted)
    left = wanted - done
    if touch.questionable:
        instruction = _remove_first(touch)
    elif done == 0:
        instruction = message("go-pictures-touches-spread-over-printed", wanted=wanted)
    elif left == 1:
        instruction = message("touch-printed-side-once-more-far")
    elif left > 0:
        instruction = message("touch-printed-side-more-times-spread", left=left)
    else:
        instruction = message("all-points-there-go-pictures")
    return StepView(
        instruction=instruction,
        picture=ObjectPicture(geometry(board), [face], touch.points),
        progress=Progress(done, wanted, message("points-of", taken=done, wanted=wanted)),
        findings=[
            *device_findings(*live.links)[:1],
            *strain_findings(live.stillness.strain),
            *touch.findings,
        ],
        actions=_actions(state, live, touch, done == 0 or left <= 0),
    )


def _actions(
    state: CalibrationState, live: CalibrationLive, touch: TouchReport, complete: bool
) -> list[Action]:
    listed = touch.questionable[:LISTED_QUESTIONABLE]
    return [
        offer(state, live, "take_point", message("take-point"), primary=not complete),
        offer(state, live, "confirm_touch", message("continue"), primary=complete),
        offer(state, live, "undo", message("undo-last-point")),
        *(
            offer(state, live, "redo", message("put-point-back", i=i + 1))
            for i in state.undone[-1:]
        ),
        *(
            offer(
                state,
                live,
                "void_point",
                message("remove-point", index=index + 1),
                {"index": index},
            )
            for index in listed
        ),
    ]


def _instruction(
    faces: list[FaceProgress], selected: str, complete: bool, touch: TouchReport
) -> Text:
    if complete and touch.questionable:
        return _remove_first(touch)
    if complete:
        more = touch.advice is not None and touch.advice.more
        return message("all-points-there-go-add", more="yes" if more else "no")
    here = next(face for face in faces if face.face == selected)
    if here.wanted == 0:
        return message("points-here-welcome-beside-those-other", place=_place(selected))
    goal = next_face(faces, selected)
    if goal != selected:
        return message("face-has-points-go", face=TITLES[goal])
    return message(
        "spread-points-hold-still-press-arms", place=_place(selected), wanted=here.wanted
    )


def _remove_first(touch: TouchReport) -> Text:
    if len(touch.questionable) == 1:
        return message("point-off-face-remove-then-go", point=touch.questionable[0] + 1)
    return message("some-points-off-their-face-remove")


def _place(face: str) -> Text:
    places = {
        "crest": message("touch-tops-merlons"),
        "floor": message("touch-floors-grooves"),
        "front": message("touch-front-face"),
        "back": message("touch-back-face"),
        "left": message("touch-left-end"),
        "right": message("touch-right-end"),
    }
    return places[face]


def _number(touch: TouchReport) -> LiveNumber:
    label = message("objects-place-k-1")
    if touch.alignment is None or touch.advice is None:
        return LiveNumber(
            label, None, "µm", 0, "neutral", message("after-three-points-three-faces")
        )
    fine = touch.advice.now_um <= touch.target_um
    quality: Quality = "attention" if touch.questionable else ("good" if fine else "neutral")
    note = message(
        "wanted-points-fit",
        target=quantity(touch.target_um, "µm"),
        rms=quantity(1000.0 * touch.alignment.rms_mm, "µm"),
    )
    return LiveNumber(label, touch.advice.now_um, "µm", 0, quality, note)


def _advice(touch: TouchReport) -> list[Finding]:
    """How many more points on which face, and what they bring."""
    if touch.alignment is None or touch.advice is None:
        missing = touch.missing if not touch.findings else ""
        return [Finding("neutral", missing)] if missing else []
    advice = touch.advice
    if not advice.more:
        return []
    total = sum(count for _, count in advice.more)
    words = advice.words
    if len(advice.more) > LISTED_FACES:
        face, most = advice.more[0]
        words = message("touches-over-all-faces", total=total, most=most, where=on_face(face))
    values: dict[str, Value] = {
        "total": total,
        "words": words,
        "now": quantity(advice.now_um, "µm"),
        "then": quantity(advice.then_um, "µm"),
    }
    text = (
        message("touches-would-bring", **values)
        if advice.reaches
        else message("touches-would-not-reach", **values, target=quantity(touch.target_um, "µm"))
    )
    return [Finding("neutral", text, message("spread-them-wide-clear-edges"))]
