"""The simulated operator in a calibration: a step's whole job, or all up to the review."""

import time
from collections.abc import Callable

import numpy as np

from crenel.errors import OperationError
from crenel.guide.calibration import tasks
from crenel.guide.calibration.guide import CalibrationGuide
from crenel.guide.calibration.poses.board_views import next_view
from crenel.guide.calibration.tasks import confirm
from crenel.guide.calibration.touch.report import face_in_use, face_progress, where_on_object
from crenel.guide.common.simulated_operator import SimulatedOperator
from crenel.guide.common.simulation import (
    ATTEMPTS,
    TIMEOUT_S,
    StepWork,
    act_as_operator,
    touch_until_taken,
    work_on_steps,
)
from crenel.messages.message import message
from crenel.metrology.arm.kinematics import RobotArm
from crenel.metrology.arm.reported_poses import transforms_from_poses
from crenel.station.jobs import Progress

SENSOR_TIMEOUT_S = 10.0
POSES, BOARD_POSES = 5, 9


def simulate(
    guide: CalibrationGuide, operator: SimulatedOperator, whole: bool, progress: Progress
) -> None:
    """Does the present step, or goes on up to the review."""
    # the sensor may have been elsewhere since: a simulated arm begins at its rest
    if guide.state.step != "capture" or _hold(guide, operator, progress):
        work_on_steps(STEPS, guide, operator, whole, progress)


def _confirm(guide: CalibrationGuide, name: str) -> None:
    """Goes on once that is possible."""
    _await(guide, lambda: _possible(guide, name), TIMEOUT_S)
    act_as_operator(guide, name, lambda: confirm(guide, name, None))


def _possible(guide: CalibrationGuide, name: str) -> bool:
    try:
        guide.check_allowed(name, {}, None, by_simulation=True)
    except OperationError:
        return False
    return True


def _devices(guide: CalibrationGuide, operator: SimulatedOperator, progress: Progress) -> None:
    _confirm(guide, "confirm_devices")


def _setup(guide: CalibrationGuide, operator: SimulatedOperator, progress: Progress) -> None:
    _confirm(guide, "confirm_setup")


def _touch(guide: CalibrationGuide, operator: SimulatedOperator, progress: Progress) -> None:
    """Takes the points that are still wanted, by the arm's own button."""
    item, report = (
        guide.datasheets.selection(guide.state).object,
        guide.datasheets.touch(guide.state),
    )
    assert item is not None
    assert report is not None
    faces = face_progress(report, guide.state.face, item)
    todo = [(face, i) for face in faces for i in range(face.taken, face.wanted)]
    for done, (face, index) in enumerate(todo):
        progress(message("simulation-touches", face=face.title), done / len(todo))
        if not guide.simulation_running or not _touch_one(guide, operator, face.face, index):
            return
    _confirm(guide, "confirm_touch")


def _touch_one(guide: CalibrationGuide, operator: SimulatedOperator, face: str, index: int) -> bool:
    def touch(attempt: int) -> bool:
        with guide.lock:
            item = guide.datasheets.selection(guide.state).object
            if item is not None and face_in_use(guide.state.face, item) != face:
                guide.append("face_selected", {"face": face})
        return operator.touch(face, index + 100 * attempt)

    return touch_until_taken(
        guide,
        touch,
        lambda: len(guide.state.contacts),
        message(
            "hands-point-face-declined-times",
            index=index + 1,
            where=where_on_object(face),
            attempts=ATTEMPTS,
        ),
    )


def _hold(guide: CalibrationGuide, operator: SimulatedOperator, progress: Progress) -> bool:
    """Brings the sensor to where the next picture is wanted; False when it was stopped."""
    advice = guide.live().advice
    if advice is None:
        progress(message("simulation-holds-sensor-over-object"), 0.2)
        if guide.datasheets.selection(guide.state).board is None:
            return operator.hold_over("block")
        view = next_view(guide.state.listed)
        return operator.hold_over("board", len(guide.state.pictures) if view is None else view)
    progress(message("simulation-goes-next-pose", words=advice.words), 0.2)
    if isinstance(guide.datasheets.selection(guide.state).arm, RobotArm):
        return operator.hold_flange_at(transforms_from_poses(np.array([advice.reading]))[0])
    return operator.hold_at(advice.reading)


def _place(guide: CalibrationGuide, operator: SimulatedOperator, progress: Progress) -> None:
    if _hold(guide, operator, progress):
        progress(message("simulation-holds-still"), 0.8)
        _await(guide, lambda: _ready_to_capture(guide), SENSOR_TIMEOUT_S)
        _confirm(guide, "confirm_place")


def _capture(guide: CalibrationGuide, operator: SimulatedOperator, progress: Progress) -> None:
    """Takes the picture, again where the arm or the camera was not ready for it."""
    for attempt in range(ATTEMPTS):
        _await(guide, lambda: _ready_to_capture(guide), SENSOR_TIMEOUT_S)
        try:
            tasks.capture(guide, progress)
        except OperationError:
            if attempt == ATTEMPTS - 1 or not guide.simulation_running:
                raise
        else:
            break


def _ready_to_capture(guide: CalibrationGuide) -> bool:
    rig = guide.station.rig
    return rig.arm.stillness().still and rig.sensor.fresh


def _solve(guide: CalibrationGuide, operator: SimulatedOperator, progress: Progress) -> None:
    """Takes the pictures that a person would be asked for, then calibrates."""
    if _should_retake(guide):
        guide.append("retaken", {})
        _hold(guide, operator, progress)  # what the picture shows from here is not enough
    elif _another_helps(guide):
        guide.append("another_pose", {})
    else:
        tasks.calibrate(guide, progress)


def _should_retake(guide: CalibrationGuide) -> bool:
    """Whether the guide advises to take the newest picture again, and it was not done often."""
    retaken = sum(capture.gone == "retaken" for capture in guide.state.captures)
    advised = any(action.name == "retake" and action.primary for action in guide.view().actions)
    return advised and retaken < ATTEMPTS


def _another_helps(guide: CalibrationGuide) -> bool:
    advice, taken = guide.live().advice, len(guide.state.pictures)
    most = POSES
    if guide.datasheets.selection(guide.state).board is not None:
        if next_view(guide.state.listed) is not None:
            return True
        most = BOARD_POSES
    return advice is not None and advice.worth_it and taken < most


def _await(guide: CalibrationGuide, ready: Callable[[], bool], timeout_s: float) -> None:
    """Waits a little for the station to be ready; what follows judges it again."""
    deadline_s = time.monotonic() + timeout_s
    with guide.changed:
        while guide.simulation_running and not ready() and time.monotonic() < deadline_s:
            guide.changed.wait(0.1)


STEPS: dict[str, StepWork[CalibrationGuide]] = {
    "devices": _devices,
    "setup": _setup,
    "touch": _touch,
    "place": _place,
    "capture": _capture,
    "solve": _solve,
}
