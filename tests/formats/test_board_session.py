"""Sessions on a chessboard, with a robot's flange poses or an arm's joints."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from crenel.errors import OperationError
from crenel.formats.datasheets.arm import read_any_arm
from crenel.formats.datasheets.target import read_block, read_object
from crenel.formats.session.calibration_session import (
    BoardSession,
    ContactReadings,
    read_any_session,
    read_session,
    write_contacts,
)
from crenel.formats.session.pose_pictures import ImageRow, write_images
from crenel.metrology.arm.kinematics import RobotArm, Tip
from crenel.metrology.targets.chessboard import Chessboard, Markers
from crenel.metrology.transforms import Floats, rigid
from tests.datasheets import write_arm, write_object
from tests.formats.builders import ARM, edit_json, edit_text, write_session
from tests.real_sessions import write_real_session
from tests.refusals import refused_as

BOARD = Chessboard("board", "C-1", (7, 6), 10.0, 0.02)
ROBOT = RobotArm("robot", "R-1", Tip(1.0, 2.0, 150.0, 6.0))
TURNS = Rotation.from_rotvec([[0.1 * k, 0.2, -0.3] for k in range(3)]).as_matrix()
POSES = np.array([rigid(R, np.array([1500.0, 20.0 * k, 900.0])) for k, R in enumerate(TURNS)])
NONE = np.zeros(0)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A robot's session with a chessboard and two pictures."""
    folder = write_session(tmp_path / "s")
    write_arm(folder / "arm.json", ROBOT)
    write_object(folder / "object.json", BOARD)
    (folder / "probing.csv").unlink()
    write_poses(folder, (1, "a", "both", POSES[0]), (2, "l", "both", POSES[1]))
    return folder


def write_poses(folder: Path, *rows: tuple[int, str, str, Floats]) -> None:
    """The table of pictures: number, picture, lighting and flange pose of each row."""
    write_images(
        folder / "images.csv",
        [
            ImageRow(number, f"images/{name}.png", lighting, NONE, T)
            for number, name, lighting, T in rows
        ],
    )


def read_board(folder: Path) -> BoardSession:
    session = read_any_session(folder)
    assert isinstance(session, BoardSession)
    return session


def test_a_robots_session_reads_without_contacts(folder: Path) -> None:
    session = read_board(folder)
    assert session.board == BOARD
    assert session.arm == ROBOT
    assert session.contacts is None
    assert [pose.number for pose in session.poses] == [1, 2]
    readings = [pose.reading for pose in session.poses]
    assert np.allclose(readings, POSES[:2], atol=1e-12)


def test_contacts_on_the_board_read_back(folder: Path) -> None:
    write_contacts(folder / "probing.csv", ContactReadings(("board",) * 3, np.zeros((3, 0)), POSES))
    session = read_board(folder)
    assert session.contacts is not None
    assert np.allclose(session.contacts.readings, POSES, atol=1e-12)
    edit_text(folder / "probing.csv", "board", "crest")
    with pytest.raises(OperationError, match="the faces are board"):
        read_any_session(folder)


def test_an_arm_with_joints_may_look_at_a_board(tmp_path: Path) -> None:
    folder = write_session(tmp_path / "s")
    write_object(folder / "object.json", BOARD)
    (folder / "probing.csv").unlink()
    session = read_board(folder)
    assert session.arm.name == ARM.name
    assert session.poses[0].reading.shape == (6,)


def test_what_needs_a_block_refuses_a_board_and_a_robot(folder: Path) -> None:
    assert read_object(folder / "object.json") == BOARD
    assert read_any_arm(folder / "arm.json") == ROBOT
    with pytest.raises(OperationError, match="chessboard"):
        read_block(folder / "object.json")
    with pytest.raises(OperationError, match="joint angles"):
        read_session(folder)


def metres(folder: Path) -> None:
    poses = [rigid(T[:3, :3], T[:3, 3] / 1e3) for T in POSES[:2]]
    write_poses(folder, (1, "a", "both", poses[0]), (2, "l", "both", poses[1]))


def certified(**fields: object) -> Callable[[Path], object]:
    return lambda folder: edit_json(folder / "object.json", lambda known: known.update(fields))


def quaternion(*cells: str) -> Callable[[Path], None]:
    """The last cells of the first row become these."""

    def spoil(folder: Path) -> None:
        head, first, *rows = (folder / "images.csv").read_text().splitlines()
        first = ",".join([*first.split(",")[: -len(cells)], *cells])
        (folder / "images.csv").write_text("\n".join([head, first, *rows]) + "\n")

    return spoil


OF_TWO_DIGITS = ("0.02", "0.66", "-0.05", "0.74")


def moved(folder: Path) -> None:
    """The robot, between two pictures of one pose."""
    write_poses(folder, (1, "a", "ambient", POSES[0]), (1, "l", "laser", POSES[1]))


@pytest.mark.parametrize(
    ("spoil", "code", "words"),
    [
        (metres, "poses-in-metres", ""),
        (lambda s: edit_text(s / "images.csv", "x_mm", "x"), "columns-missing", ""),
        (lambda s: edit_text(s / "images.csv", ",qw", ",q1_deg"), "columns-missing", ""),
        (certified(square_mm=0.01), "field-invalid", ""),
        (certified(inner_corners=[7, 2]), "field-invalid", ""),
        (certified(flatness_mm=50), "field-invalid", ""),
        (quaternion("0.5"), "quaternion-not-unit", "length 1"),
        (quaternion(*OF_TWO_DIGITS), "quaternion-not-unit", "at least four digits"),
        (moved, "pose-moved", "the flange differs by"),
    ],
)
def test_a_spoilt_board_session_is_refused(
    folder: Path, spoil: Callable[[Path], object], code: str, words: str
) -> None:
    spoil(folder)
    with refused_as(code, words):
        read_any_session(folder)


@pytest.mark.slow
@pytest.mark.parametrize(("name", "count"), [("calib1", 8), ("calib3", 16)])
def test_the_real_recordings_read(real: Path, tmp_path: Path, name: str, count: int) -> None:
    folder = write_real_session(real / "robot-laser-chessboard" / name, tmp_path / "s")
    assert len(read_board(folder).poses) == count


def test_a_pose_may_have_no_laser_picture(folder: Path) -> None:
    first = ((1, "a", "ambient", POSES[0]), (1, "l", "laser", POSES[0]))
    write_poses(folder, *first, (2, "a", "ambient", POSES[1]))
    session = read_any_session(folder)
    assert [pose.laser is not None for pose in session.poses] == [True, False]
    assert [pose.laser_on for pose in session.poses] == [True, False]
    write_poses(folder, *first, (2, "l", "laser", POSES[1]))
    with pytest.raises(OperationError, match=r"pose 2 has no 'ambient' picture.*may be missing"):
        read_any_session(folder)


CHARUCO = Chessboard(
    "marked", "C-2", (7, 6), 10.0, 0.02, 0.1, Markers("DICT_5X5_100", 7.0, True, 28)
)


def test_a_charuco_board_reads_back(folder: Path) -> None:
    write_object(folder / "object.json", CHARUCO)
    session = read_board(folder)
    assert session.board == CHARUCO


@pytest.mark.parametrize(
    ("fields", "words"),
    [
        ({"first_id": 73}, "first_id: at most 72 for these markers of DICT_5X5_100"),
        ({"dictionary": "DICT_8X8_50"}, "dictionary is one of DICT_4X4_50"),
        ({"dictionary": "DICT_APRILTAG_16h5", "squares_x": 12}, "42 markers"),
        ({"marker_mm": 10}, "marker_mm must be less than square_mm"),
        ({"squares_x": 3}, "squares_x"),
        ({"squares_y": 2.5}, "squares_y"),
        ({"square_mm": 0.01, "marker_mm": 0.007}, "is it in metres"),
        ({"kind": "aruco"}, "'crenellated', 'chessboard' or 'charuco'"),
    ],
)
def test_another_charuco_is_refused(tmp_path: Path, fields: dict[str, object], words: str) -> None:
    write_object(tmp_path / "object.json", CHARUCO)
    certified(**fields)(tmp_path)
    with pytest.raises(OperationError) as refused:
        read_object(tmp_path / "object.json")
    assert words in refused.value.line
