"""Pictures of a board by themselves: one whenever a robot rests at a new pose, until they are
enough; then the calibration."""

from collections.abc import Callable

import numpy as np

from crenel.errors import OperationError
from crenel.guide.calibration import tasks
from crenel.guide.calibration.guide import CalibrationGuide
from crenel.guide.calibration.poses.advice import ENOUGH_OF_A_BOARD
from crenel.guide.calibration.poses.board_views import next_view
from crenel.guide.calibration.steps.capture import FEWEST_CORNERS
from crenel.guide.calibration.tasks import confirm
from crenel.messages.message import message
from crenel.metrology.adjustment.board.laser_lines import FEWEST_LINES
from crenel.metrology.arm.kinematics import flange_pose, flange_poses
from crenel.station.jobs import Progress

LOOK_S = 0.2
NEW_DEG, NEW_MM = 5.0, 10.0
"""A pose is new if it is turned or moved by so much against every other one with a picture."""
FRESH_PREVIEWS = 2
"""Live pictures since the robot rests, before one shows what the camera sees there."""


def start_taking(guide: CalibrationGuide) -> None:
    """Takes pictures from now on, in the background.

    Raises:
        OperationError: another job runs.
    """
    guide.start_taking_poses(lambda progress: take_poses(guide, progress))


def take_poses(guide: CalibrationGuide, progress: Progress) -> None:
    """Until the calibration is computed, or ``guide.taking_poses`` ends.

    A picture is taken only where the rules let a person take it, the object is in the live picture,
    and no picture was taken near this pose.
    """
    rest = _Rest(guide)
    while guide.taking_poses:
        step = guide.state.step
        if step == "solve" and not _go_on(guide, progress):
            return
        if step not in ("place", "capture", "solve"):
            return
        done = len(guide.state.pictures)
        progress(message("waits-for-new-rest"), min(done / ENOUGH_OF_A_BOARD, 1.0))
        if guide.state.step in ("place", "capture") and rest.is_new() and _take(guide, progress):
            continue
        with guide.changed:
            guide.changed.wait(LOOK_S)


def _go_on(guide: CalibrationGuide, progress: Progress) -> bool:
    """After a picture: on to the next one; False once they were enough and the rest is done."""
    newest = guide.state.picture
    if newest is not None and guide.live().capture_outcomes[newest.number].fault:
        return _act(guide, "retake", lambda: guide.append("retaken", {}))
    if not is_enough(guide):
        return _act(guide, "another_pose", lambda: guide.append("another_pose", {}))
    tasks.calibrate(guide, progress)
    return False


def is_enough(guide: CalibrationGuide) -> bool:
    """Whether the planned views are taken, enough pictures show the line, and more would bring
    little."""
    live, pictures = guide.live(), guide.state.pictures
    lines = sum(len(live.capture_outcomes[one.number].stripe) > 0 for one in pictures)
    if next_view(guide.state.listed) is not None or lines < FEWEST_LINES or live.advice is None:
        return False
    return not live.advice.worth_it or len(pictures) >= ENOUGH_OF_A_BOARD


def _take(guide: CalibrationGuide, progress: Progress) -> bool:
    """Whether a picture was taken; one that failed is taken at the next look, if it can be."""
    if guide.state.step == "place" and not _act(
        guide, "confirm_place", lambda: confirm(guide, "confirm_place", None)
    ):
        return False
    if not _act(guide, "capture", lambda: guide.append("capture_started", {})):
        return False
    try:
        tasks.capture(guide, progress)
    except OperationError as error:
        guide.decline(error)
        return False
    return True


def _act(guide: CalibrationGuide, name: str, act: Callable[[], None]) -> bool:
    """Does what a command does, where it is possible."""
    with guide.lock:
        if not guide.taking_poses or guide.why_not(name, {}, True):
            return False
        act()
        return True


class _Rest:
    """Notices that the robot rests at a new pose, with the object in the picture."""

    def __init__(self, guide: CalibrationGuide) -> None:
        self._guide = guide
        self._since: int | None = None
        """Number of the live picture with which the rest began."""

    def is_new(self) -> bool:
        """Whether a picture here is one more pose."""
        preview = self._guide.station.preview.latest()
        if preview is None or not self._guide.station.rig.arm.stillness().still:
            self._since = None
            return False
        header = preview.header
        if self._since is None:
            self._since = header.seq
        seen = header.seq - self._since >= FRESH_PREVIEWS and header.arm_still
        return seen and len(header.corners) >= FEWEST_CORNERS and self._is_elsewhere()

    def _is_elsewhere(self) -> bool:
        state = self._guide.state
        arm, newest = (
            self._guide.datasheets.selection(state).arm,
            self._guide.station.rig.arm.latest(),
        )
        if arm is None or newest is None or len(newest.reading) != arm.reading_size:
            return False
        taken = [one.reading for one in state.captures if one.arm == state.choices["arm"]]
        if not taken:
            return True
        here, there = flange_pose(arm, np.array(newest.reading)), flange_poses(arm, np.array(taken))
        traces = np.einsum("nij,ij->n", there[:, :3, :3], here[:3, :3])
        turned_deg = np.rad2deg(np.arccos(np.clip((traces - 1) / 2, -1, 1)))
        moved_mm = np.linalg.norm(there[:, :3, 3] - here[:3, 3], axis=1)
        return bool(np.all((turned_deg >= NEW_DEG) | (moved_mm >= NEW_MM)))
