"""The step 'touch': contact points on the object's faces. Pure."""

from app.findings import Finding, Quality
from app.guide.calibration.live import CalibrationLive
from app.guide.calibration.state import CalibrationState
from app.guide.calibration.steps.body import StepView, device_findings, geometry, offer
from app.guide.calibration.touch.block import TITLES
from app.guide.calibration.touch.report import face_in_use, face_progress, next_face
from app.guide.calibration.touch.touch_report import TouchReport
from app.guide.common.view import Action, DevicesPicture, FaceProgress, LiveNumber, ObjectPicture
from app.guide.common.view import StepProgress as Progress
from app.metrology.targets.chessboard import Chessboard

LISTED_SUSPECTS, LISTED_FACES = 3, 3


def touch_step(state: CalibrationState, live: CalibrationLive) -> StepView:
    """Where to touch, how many points there are, and how well they agree."""
    item, touch = live.chosen.object, live.touch
    if item is None or touch is None:
        return StepView(
            instruction="The arm or the object that was chosen cannot be read any more.",
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
        progress=Progress(done, wanted, f"{done} of {wanted} points"),
        findings=[*device_findings(live)[:1], *touch.findings, *_advice(touch)],
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
    if touch.suspects:
        instruction = _remove_first(touch)
    elif done == 0:
        instruction = (
            f"Go on to the pictures. {wanted} touches, spread over the printed side, would "
            "check the size of its squares."
        )
    elif left == 1:
        instruction = "Touch the printed side once more, far from the others. Or go on."
    elif left > 0:
        instruction = f"Touch the printed side {left} more times, spread wide. Or go on."
    else:
        instruction = "All points are there. Go on to the pictures."
    return StepView(
        instruction=instruction,
        picture=ObjectPicture(geometry(board), [face], touch.points),
        progress=Progress(done, wanted, f"{done} of {wanted} points"),
        findings=[*device_findings(live)[:1], *touch.findings],
        actions=_actions(state, live, touch, done == 0 or left <= 0),
    )


def _actions(
    state: CalibrationState, live: CalibrationLive, touch: TouchReport, complete: bool
) -> list[Action]:
    suspects = touch.suspects[:LISTED_SUSPECTS]
    return [
        offer(state, live, "take_point", "Take the point", primary=not complete),
        offer(state, live, "confirm_touch", "Continue", primary=complete),
        offer(state, live, "undo", "Undo the last point"),
        *(offer(state, live, "redo", f"Put point {i + 1} back") for i in state.undone[-1:]),
        *(
            offer(state, live, "void_point", f"Remove point {index + 1}", {"index": index})
            for index in suspects
        ),
    ]


def _instruction(
    faces: list[FaceProgress], selected: str, complete: bool, touch: TouchReport
) -> str:
    if complete and touch.suspects:
        return _remove_first(touch)
    if complete:
        more = touch.advice is not None and touch.advice.more
        return f"All points are there. Go on, or add {'more as told below' if more else 'some'}."
    here = next(face for face in faces if face.face == selected)
    if here.wanted == 0:
        return f"{_place(selected)} Points here are welcome beside those on the other faces."
    goal = next_face(faces, selected)
    if goal != selected:
        return f"This face has its points. Go on with: {TITLES[goal].lower()}."
    return (
        f"{_place(selected)} Spread {here.wanted} points, hold still, and press the arm's button."
    )


def _remove_first(touch: TouchReport) -> str:
    if len(touch.suspects) == 1:
        return f"Point {touch.suspects[0] + 1} is off its face. Remove it, then go on."
    return "Some points are off their face. Remove them, then go on."


def _place(face: str) -> str:
    places = {
        "crest": "Touch the tops of the merlons.",
        "floor": "Touch the floors of the grooves.",
        "front": "Touch the front face.",
        "back": "Touch the back face.",
        "left": "Touch the left end.",
        "right": "Touch the right end.",
    }
    return places[face]


def _number(touch: TouchReport) -> LiveNumber:
    label = "Object's place (k = 1)"
    if touch.alignment is None or touch.advice is None:
        return LiveNumber(label, None, "µm", 0, "neutral", "after three points on three faces")
    fine = touch.advice.now_um <= touch.target_um
    quality: Quality = "attention" if touch.suspects else ("good" if fine else "neutral")
    note = f"wanted: {touch.target_um:.0f} µm; points fit to {1e3 * touch.alignment.rms_mm:.0f} µm"
    return LiveNumber(label, touch.advice.now_um, "µm", 0, quality, note)


def _advice(touch: TouchReport) -> list[Finding]:
    """How many more points on which face, and what they bring."""
    if touch.alignment is None or touch.advice is None:
        missing = touch.missing if not touch.findings else ""
        return [Finding("neutral", missing)] if missing else []
    told = touch.advice
    known = f"Object known to {told.now_um:.0f} µm (k = 1)"
    if not told.more:
        return []
    total = sum(count for _, count in told.more)
    words = told.words
    if len(told.more) > LISTED_FACES:
        face, most = told.more[0]
        words = f"{total} more over all faces, {most} of them on the {face} face,"
    text = f"{known}; {words} {'brings' if total == 1 else 'bring'} {told.then_um:.0f} µm."
    if not told.reaches:
        text = f"{text[:-1]}, {touch.target_um:.0f} µm are wanted."
    return [Finding("neutral", text, "Spread them wide, clear of the edges.")]
