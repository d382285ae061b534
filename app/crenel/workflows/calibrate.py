"""From a session's folder to its calibration file."""

import getpass
import os
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from typing import Literal, TypeVar

import numpy as np

from crenel.errors import OperationError
from crenel.formats.atomic_write import check_output_path
from crenel.formats.file_names import display_path
from crenel.formats.images import GreyImage, channel_text, image_size, read_colours, read_grey
from crenel.formats.io_errors import prefix_errors
from crenel.formats.json_document import file_sha256
from crenel.formats.results.calibration import CalibrationFile, Input, SerialNumbers
from crenel.formats.results.calibration_builder import (
    Origin,
    board_document,
    joint_document,
    one_pose_document,
)
from crenel.formats.results.kept_calibration import KeptCalibration, read_kept_calibration
from crenel.formats.session.calibration_session import BlockSession, BoardSession, read_any_session
from crenel.formats.session.pose_pictures import Pose, check_size
from crenel.formats.settings.line_settings import LineSettings
from crenel.messages.message import Text, message
from crenel.metrology.adjustment.block.calibrate import calibrate_block, observe_block
from crenel.metrology.adjustment.block.problem import BlockInputs
from crenel.metrology.adjustment.board.add_laser import add_laser
from crenel.metrology.adjustment.board.calibrate import (
    BoardCalibration,
    calibrate_board,
    observe_board,
)
from crenel.metrology.adjustment.board.initial_guess import BoardObservation
from crenel.metrology.adjustment.board.problem import BoardInputs
from crenel.metrology.adjustment.core.observations import (
    PICTURE_TWICE,
    BlockObservation,
    FailedPose,
)
from crenel.metrology.bayer import BayerPlane
from crenel.metrology.calibration.one_pose import OnePoseInputs, calibrate_one_pose
from crenel.metrology.channel import Channel, describe_channel
from crenel.metrology.colour import find_weights
from crenel.metrology.limits import LIMITS, Limits
from crenel.metrology.stripe import check_settings
from crenel.progress import Progress, no_progress
from crenel.workflows.pictures.raw_observations import raw_block, raw_board

Method = Literal["one-pose", "joint"]
LaserUse = Literal["auto", "none"]
AnyDetection = BlockObservation | BoardObservation
NO_DETECTIONS: Mapping[int, AnyDetection | OperationError] = {}
# Share of the time that looking at the pictures takes.
DETECTION_SHARE = 0.8
DetectionT = TypeVar("DetectionT", BlockObservation, BoardObservation)


def calibrate_session(
    folder: Path,
    output: Path,
    progress: Progress = no_progress,
    method: Method = "joint",
    limits: Limits = LIMITS,
    laser: LaserUse = "auto",
    camera_from: Path | None = None,
    line: LineSettings | None = None,
) -> tuple[CalibrationFile, list[Text]]:
    """Calibrates a session, and writes the result to ``output``.

    Args:
        method: ``joint`` takes all poses in one adjustment; ``one-pose`` is the
            article's, from the first pose alone.
        limits: what the verdict goes by.
        laser: ``none`` calibrates camera and mounting alone on a chessboard, whatever line the
            pictures show; ``auto`` does so if the laser was on in none of them.
        camera_from: an earlier calibration on a chessboard whose camera and mounting are kept,
            so that the session adds the laser plane alone.
        line: what is set of the line, instead of what the session's folder says.

    Returns:
        What was written, and what the user should know in addition.

    Raises:
        OperationError: the session or the place to write to is not in order, or no
            calibration follows from it; nothing is then written.
    """
    check_output_path(output)
    session = read_any_session(folder)
    if line is not None:
        session = replace(session, line=line)
    check_settings(session.line.stripe)
    check_output_path(
        output, session.files if camera_from is None else [*session.files, camera_from]
    )
    kept = None if camera_from is None else read_kept_calibration(camera_from)
    with prefix_errors(folder):
        if isinstance(session, BoardSession):
            document = _calibrate_on_board(session, method, limits, progress, laser, kept)
        elif laser == "none" or kept is not None:
            raise OperationError(
                "camera-alone-on-block",
                message("camera-and-laser-apart-on-a-board-only"),
                "",
                message("use-a-chessboard-or-leave-out-the-option"),
            )
        elif method == "one-pose":
            document = _calibrate_from_one_pose(session, progress)
        else:
            document = _calibrate_from_all_poses(session, limits, progress)
    document.write(output)
    unused = len(session.poses) - 1 if method == "one-pose" else 0
    if not unused:
        return document, []
    first = session.poses[0].number
    return document, [message("pose-used-other-one-pose", number=first, unused=unused)]


def _calibrate_from_one_pose(session: BlockSession, progress: Progress) -> CalibrationFile:
    if isinstance(session.sensor.channel, BayerPlane):
        raise OperationError(
            "one-pose-of-raw",
            message("one-pose-takes-no-raw"),
            "",
            message("use-method-joint"),
        )
    pose = session.poses[0]
    result = calibrate_one_pose(one_pose_inputs(session, pose), progress)
    return one_pose_document(result, calibration_origin(session, (pose,), _user_name()))


def _calibrate_from_all_poses(
    session: BlockSession, limits: Limits, progress: Progress
) -> CalibrationFile:
    result = calibrate_block(joint_inputs(session, limits, progress), _solve_progress(progress))
    return joint_document(result, calibration_origin(session, session.poses, _user_name()))


def _calibrate_on_board(
    session: BoardSession,
    method: Method,
    limits: Limits,
    progress: Progress,
    laser: LaserUse,
    kept: KeptCalibration | None,
) -> CalibrationFile:
    if method == "one-pose":
        raise OperationError(
            "one-pose-on-board",
            message("one-pose-not-enough", name=session.board.name),
            message("one-picture-flat-board-tells-neither"),
            message("use-method-joint-pictures-board-several"),
        )
    inputs = board_inputs(session, limits, progress, laser=laser)
    origin = calibration_origin(session, session.poses, _user_name())
    return solve_board(inputs, origin, _solve_progress(progress), kept)[1]


def solve_board(
    inputs: BoardInputs, origin: Origin, progress: Progress, kept: KeptCalibration | None
) -> tuple[BoardCalibration, CalibrationFile]:
    """The calibration on a chessboard and its file; ``kept``: only the laser is added to it.

    Raises:
        OperationError: as ``calibrate_board`` and ``add_laser``.
    """
    if kept is None:
        result = calibrate_board(inputs, progress)
        return result, board_document(result, origin)
    result = add_laser(inputs, kept.sensor, progress)
    return result, board_document(result, origin).model_copy(update={"camera_from": kept.source})


def _solve_progress(progress: Progress) -> Progress:
    """Progress of what follows after the detection in the pictures."""
    return lambda share, text: progress(DETECTION_SHARE + (1 - DETECTION_SHARE) * share, text)


def one_pose_inputs(session: BlockSession, pose: Pose) -> OnePoseInputs:
    """The pictures of a pose read, and what goes with them; ``OperationError`` if damaged."""
    channel = session_channel(session)
    return OnePoseInputs(
        arm=session.arm,
        block=session.block,
        features=session.contacts.features,
        contact_q_rad=session.contacts.q_rad,
        pose_q_rad=pose.q_rad,
        ambient=read_grey(pose.ambient, channel),
        laser=None if pose.laser is None else read_grey(pose.laser, channel),
        stripe_axis=session.sensor.stripe_axis,
        size_px=(session.sensor.width_px, session.sensor.height_px),
        search=session.line.search(),
    )


def joint_inputs(
    session: BlockSession,
    limits: Limits = LIMITS,
    progress: Progress = no_progress,
    known: Mapping[int, AnyDetection | OperationError] = NO_DETECTIONS,
) -> BlockInputs:
    """The pictures of all poses read and looked at, on all cores.

    Poses whose pictures are damaged or show nothing usable are kept with the reason. What is
    ``known`` of a pose, by number, is not looked at again.
    """
    channel = session_channel(session)
    seen, unseen = _detect_all(
        session.poses,
        BlockObservation,
        known,
        lambda pose: _observe_block(session, pose, channel),
        progress,
    )
    return BlockInputs(
        arm=session.arm,
        block=session.block,
        features=session.contacts.features,
        contact_q_rad=session.contacts.q_rad,
        observations=tuple(one for _, one in seen),
        q_rad=np.array([pose.q_rad for pose, _ in seen]).reshape(-1, session.arm.joint_count),
        failed_poses=unseen,
        limits=limits,
    )


def board_inputs(
    session: BoardSession,
    limits: Limits = LIMITS,
    progress: Progress = no_progress,
    known: Mapping[int, AnyDetection | OperationError] = NO_DETECTIONS,
    laser: LaserUse = "auto",
) -> BoardInputs:
    """The same of a session on a chessboard; ``laser`` as in ``calibrate_session``."""
    channel = session_channel(session)
    seen, unseen = _detect_all(
        session.poses,
        BoardObservation,
        known,
        lambda pose: _observe_board(session, pose, channel),
        progress,
    )
    return BoardInputs(
        arm=session.arm,
        board=session.board,
        observations=tuple(one for _, one in seen),
        readings=np.array([pose.reading for pose, _ in seen]),
        size_px=(session.sensor.width_px, session.sensor.height_px),
        contact_readings=session.contacts.readings if session.contacts else None,
        failed_poses=unseen,
        limits=limits,
        with_laser=laser == "auto" and any(pose.laser_on for pose in session.poses),
    )


def _detect_all(
    poses: Sequence[Pose],
    kind: type[DetectionT],
    known: Mapping[int, AnyDetection | OperationError],
    see: Callable[[Pose], DetectionT | OperationError],
    progress: Progress,
) -> tuple[list[tuple[Pose, DetectionT]], tuple[FailedPose, ...]]:
    """What the poses' pictures show, on all cores, and those that show nothing usable."""

    def look(pose: Pose) -> DetectionT | OperationError:
        before = known.get(pose.number)
        return before if isinstance(before, (kind, OperationError)) else see(pose)

    seen: list[tuple[Pose, DetectionT]] = []
    unseen: list[FailedPose] = []
    # by the corners' places: noise makes those of two pictures differ, whatever their files
    first_with: dict[bytes, int] = {}
    with ThreadPoolExecutor(max_workers=os.cpu_count() or 1) as looking:
        for done, (pose, one) in enumerate(
            zip(poses, looking.map(look, poses), strict=True), start=1
        ):
            progress(
                DETECTION_SHARE * done / len(poses), message("looked-pose", number=pose.number)
            )
            if isinstance(one, OperationError):
                unseen.append(FailedPose(pose.number, one))
            elif (first := first_with.setdefault(one.fingerprint, pose.number)) != pose.number:
                unseen.append(FailedPose(pose.number, _same_picture(pose.ambient, first)))
            else:
                seen.append((pose, one))
    return seen, tuple(unseen)


def _same_picture(path: Path, first: int) -> OperationError:
    return OperationError(
        PICTURE_TWICE,
        message("same-picture-as-pose", name=display_path(path), number=first),
        message("same-picture-counts-once"),
        message("take-a-picture-in-each-pose"),
    )


def _observe_block(
    session: BlockSession, pose: Pose, channel: Channel | None
) -> BlockObservation | OperationError:
    """What a pose's pictures show; the refusal where they show nothing usable."""
    sensor = session.sensor
    try:
        ambient = _read_picture(pose.ambient, session, channel)
        laser = None if pose.laser is None else _read_picture(pose.laser, session, channel)
        search = session.line.search(channel)
        seen = observe_block(pose.number, session.block, ambient, laser, sensor.stripe_axis, search)
    except OperationError as refusal:
        return refusal
    if isinstance(channel, BayerPlane):
        return raw_block(seen, channel, (sensor.width_px, sensor.height_px))
    return seen


def _observe_board(
    session: BoardSession, pose: Pose, channel: Channel | None
) -> BoardObservation | OperationError:
    """The same of a chessboard, which needs no laser picture; a damaged one is named."""
    sensor, laser, unreadable = session.sensor, None, None
    try:
        ambient = _read_picture(pose.ambient, session, channel)
        try:
            laser = None if pose.laser is None else _read_picture(pose.laser, session, channel)
        except OperationError as error:
            unreadable = error
        laser_on = pose.laser_on and unreadable is None
        seen = observe_board(
            pose.number,
            session.board,
            ambient,
            laser,
            sensor.stripe_axis,
            laser_on,
            session.line.search(channel),
        )
    except OperationError as refusal:
        return refusal
    seen = replace(seen, laser_error=unreadable)
    return raw_board(seen, channel) if isinstance(channel, BayerPlane) else seen


def _read_picture(
    path: Path, session: BlockSession | BoardSession, channel: Channel | None
) -> GreyImage:
    """What is measured of a picture of the sensor's size; raises ``OperationError``."""
    size_px = image_size(path)
    check_size(path, size_px, session.sensor)
    session.line.check_size(path, *size_px)
    return read_grey(path, channel)


def session_channel(session: BlockSession | BoardSession) -> Channel | None:
    """What of the pictures is measured: as is set, or by the datasheet; or, of colour pictures of
    an unknown laser, by the first pose that has a picture with the laser and one without."""
    stated = session.line.channel or session.sensor.channel
    if stated is not None:
        return stated
    for pose in session.poses:
        if pose.laser is None:
            continue
        try:
            lit, unlit = read_colours(pose.laser), read_colours(pose.ambient)
        except OperationError:  # a damaged picture excludes its own pose alone
            continue
        return None if lit is None or unlit is None else find_weights(lit, unlit)
    return None


def _channel_text(session: BlockSession | BoardSession, poses: Sequence[Pose]) -> Text:
    """What of the pictures was measured, by the first that can be read; or was taken of them."""
    taken = session.sensor.pictures_of
    if taken is not None:
        return describe_channel(taken)
    channel = session_channel(session)
    for pose in poses:
        with suppress(OperationError):
            return channel_text(pose.files[-1], channel)
    return message("channel-grey")


def calibration_origin(
    session: BlockSession | BoardSession, poses: Sequence[Pose], operator: str
) -> Origin:
    """Serial numbers, and the SHA-256 of every file that the calibration used."""
    folder = session.folder
    pictures = [file for pose in poses for file in pose.files if file.is_file()]
    target = session.board if isinstance(session, BoardSession) else session.block
    return Origin(
        serial_numbers=SerialNumbers(
            arm=session.arm.serial_number,
            object=target.serial_number,
            sensor=session.sensor.serial_number,
        ),
        stripe_axis=session.sensor.stripe_axis,
        channel=_channel_text(session, poses),
        extraction=session.line.text,
        inputs=tuple(
            Input(file=path.relative_to(folder).as_posix(), sha256=file_sha256(path))
            for path in (*session.tables, *pictures)
        ),
        operator=operator,
    )


def _user_name() -> str:
    """Who runs the program, where the system knows."""
    try:
        return getpass.getuser()
    except (KeyError, OSError):
        return ""
