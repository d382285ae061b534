"""From a session's folder to its calibration file."""

import getpass
import os
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Literal, TypeVar

import numpy as np

from app.errors import Refusal
from app.formats.atomic_write import checked_target
from app.formats.images import read_grey
from app.formats.io_errors import refusals_naming
from app.formats.json_document import sha256_of
from app.formats.results.calibration import CalibrationFile, Input, SerialNumbers
from app.formats.results.calibration_builder import Origin, board_sheet, joint_sheet, one_pose_sheet
from app.formats.session.calibration_session import BoardSession, Pose, Session, read_any_session
from app.metrology.adjustment.block.calibrate import JointInputs, calibrate_joint, see_pose
from app.metrology.adjustment.board.calibrate import calibrate_board, see_board
from app.metrology.adjustment.board.initial_guess import SeenBoard
from app.metrology.adjustment.board.problem import BoardInputs
from app.metrology.adjustment.core.observations import NotSeen, SeenPose
from app.metrology.calibration.one_pose import OnePoseInputs, calibrate_one_pose
from app.metrology.image import Image
from app.metrology.limits import LIMITS, Limits
from app.metrology.targets.chessboard import Chessboard
from app.metrology.targets.crenellated_block import Crenellated
from app.progress import Progress, no_progress

Method = Literal["one-pose", "joint"]
AnySeen = SeenPose | SeenBoard
NOTHING_KNOWN: Mapping[int, AnySeen | Refusal] = {}
# Share of the time that looking at the pictures takes.
LOOKING = 0.8
Seen = TypeVar("Seen", SeenPose, SeenBoard)
Target = TypeVar("Target", Crenellated, Chessboard)


def calibrate_session(
    folder: Path,
    output: Path,
    progress: Progress = no_progress,
    method: Method = "joint",
    limits: Limits = LIMITS,
) -> tuple[CalibrationFile, list[str]]:
    """Calibrates a session, and writes the result to ``output``.

    Args:
        method: ``joint`` takes all poses in one adjustment; ``one-pose`` is the
            paper's, from the first pose alone.
        limits: what the verdict goes by.

    Returns:
        What was written, and what whoever asked for it should know beside it.

    Raises:
        Refusal: the session or the place to write to is not in order, or no
            calibration follows from it; nothing is then written.
    """
    checked_target(output)
    session = read_any_session(folder)
    checked_target(output, session.files)
    with refusals_naming(folder):
        if isinstance(session, BoardSession):
            sheet = _by_board(session, method, limits, progress)
        elif method == "one-pose":
            sheet = _by_one_pose(session, progress)
        else:
            sheet = _by_all_poses(session, limits, progress)
    sheet.write(output)
    unused = len(session.poses) - 1 if method == "one-pose" else 0
    warnings = (
        [f"pose {session.poses[0].number} was used; the other {unused} are not, by one-pose"]
        if unused
        else []
    )
    return sheet, warnings


def _by_one_pose(session: Session, progress: Progress) -> CalibrationFile:
    pose = session.poses[0]
    result = calibrate_one_pose(
        one_pose_inputs(session, pose), lambda text, share: progress(share, text)
    )
    return one_pose_sheet(result, origin_of(session, (pose,), _user()))


def _by_all_poses(session: Session, limits: Limits, progress: Progress) -> CalibrationFile:
    result = calibrate_joint(joint_inputs(session, limits, progress), _solving(progress))
    return joint_sheet(result, origin_of(session, session.poses, _user()))


def _by_board(
    session: BoardSession, method: Method, limits: Limits, progress: Progress
) -> CalibrationFile:
    if method == "one-pose":
        raise Refusal(
            "one-pose-on-board",
            f"one pose is not enough on {session.board.name}",
            "one picture of a flat board tells neither the focal length nor the laser's plane",
            "use --method joint, with pictures of the board from several sides",
        )
    result = calibrate_board(board_inputs(session, limits, progress), _solving(progress))
    return board_sheet(result, origin_of(session, session.poses, _user()))


def _solving(progress: Progress) -> Callable[[str, float], None]:
    """Progress of what follows after the pictures were looked at."""
    return lambda text, share: progress(LOOKING + (1 - LOOKING) * share, text)


def one_pose_inputs(session: Session, pose: Pose) -> OnePoseInputs:
    """The pictures of a pose read, and what goes with them; ``Refusal`` if damaged."""
    return OnePoseInputs(
        arm=session.arm,
        block=session.block,
        features=session.contacts.features,
        contact_q_rad=session.contacts.q_rad,
        pose_q_rad=pose.q_rad,
        ambient=read_grey(pose.ambient),
        laser=None if pose.laser is None else read_grey(pose.laser),
        stripe_axis=session.sensor.stripe_axis,
        size_px=(session.sensor.width_px, session.sensor.height_px),
    )


def joint_inputs(
    session: Session,
    limits: Limits = LIMITS,
    progress: Progress = no_progress,
    known: Mapping[int, AnySeen | Refusal] = NOTHING_KNOWN,
) -> JointInputs:
    """The pictures of all poses read and looked at, on all cores.

    Poses that show nothing usable are kept with the reason; ``Refusal`` if a file is
    damaged. What is ``known`` of a pose, by number, is not looked at again.
    """

    def look(pose: Pose) -> SeenPose | Refusal:
        before = known.get(pose.number)
        if isinstance(before, SeenPose | Refusal):
            return before
        return _seen(see_pose, session.block, session, pose)

    seen, unseen = _looked_at(session.poses, look, progress)
    return JointInputs(
        arm=session.arm,
        block=session.block,
        features=session.contacts.features,
        contact_q_rad=session.contacts.q_rad,
        seen=tuple(one for _, one in seen),
        q_rad=np.array([pose.q_rad for pose, _ in seen]).reshape(-1, session.arm.joint_count),
        unseen=unseen,
        limits=limits,
    )


def board_inputs(
    session: BoardSession,
    limits: Limits = LIMITS,
    progress: Progress = no_progress,
    known: Mapping[int, AnySeen | Refusal] = NOTHING_KNOWN,
) -> BoardInputs:
    """The same of a session on a chessboard."""

    def look(pose: Pose) -> SeenBoard | Refusal:
        before = known.get(pose.number)
        if isinstance(before, SeenBoard | Refusal):
            return before
        return _seen(see_board, session.board, session, pose)

    seen, unseen = _looked_at(session.poses, look, progress)
    return BoardInputs(
        arm=session.arm,
        board=session.board,
        seen=tuple(one for _, one in seen),
        readings=np.array([pose.reading for pose, _ in seen]),
        size_px=(session.sensor.width_px, session.sensor.height_px),
        contact_readings=session.contacts.readings if session.contacts else None,
        unseen=unseen,
        limits=limits,
    )


def _looked_at(
    poses: Sequence[Pose], look: Callable[[Pose], Seen | Refusal], progress: Progress
) -> tuple[list[tuple[Pose, Seen]], tuple[NotSeen, ...]]:
    """What the poses' pictures show, on all cores, and those that show nothing usable."""
    seen: list[tuple[Pose, Seen]] = []
    unseen: list[NotSeen] = []
    with ThreadPoolExecutor(max_workers=os.cpu_count() or 1) as looking:
        for done, (pose, one) in enumerate(
            zip(poses, looking.map(look, poses), strict=True), start=1
        ):
            progress(LOOKING * done / len(poses), f"Looked at pose {pose.number}")
            if isinstance(one, Refusal):
                unseen.append(NotSeen(pose.number, one))
            else:
                seen.append((pose, one))
    return seen, tuple(unseen)


def _seen(
    see: Callable[[int, Target, Image, Image | None, str], Seen],
    target: Target,
    session: Session | BoardSession,
    pose: Pose,
) -> Seen | Refusal:
    """A pose's pictures looked at; the refusal where they show nothing usable."""
    ambient = read_grey(pose.ambient)
    laser = None if pose.laser is None else read_grey(pose.laser)
    try:
        return see(pose.number, target, ambient, laser, session.sensor.stripe_axis)
    except Refusal as refusal:
        return refusal


def origin_of(session: Session | BoardSession, poses: Sequence[Pose], operator: str) -> Origin:
    """Serial numbers, and the SHA-256 of every file that the calibration used."""
    folder = session.folder
    target = session.board if isinstance(session, BoardSession) else session.block
    return Origin(
        serial_numbers=SerialNumbers(
            arm=session.arm.serial_number,
            object=target.serial_number,
            sensor=session.sensor.serial_number,
        ),
        stripe_axis=session.sensor.stripe_axis,
        inputs=tuple(
            Input(file=path.relative_to(folder).as_posix(), sha256=sha256_of(path))
            for path in (*session.tables, *(file for pose in poses for file in pose.files))
        ),
        operator=operator,
    )


def _user() -> str:
    """Who runs the program, where the system knows."""
    try:
        return getpass.getuser()
    except (KeyError, OSError):
        return ""
