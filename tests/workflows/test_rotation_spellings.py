"""One set of poses in the words of many controllers: each is read, or what it is is named."""

import shutil
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from crenel.formats.csv_table import parse_table
from crenel.formats.session.calibration_session import BoardSession, read_any_session
from crenel.formats.session.pose_columns import ArmReadings
from crenel.metrology.adjustment.board.calibrate import calibrate_board
from crenel.metrology.adjustment.board.problem import BoardInputs
from crenel.metrology.adjustment.core.arm_readings import flange_motion
from crenel.metrology.arm.kinematics import RobotArm
from crenel.metrology.transforms import Floats
from crenel.workflows.calibrate import board_inputs
from tests.conftest import SHARED
from tests.metrology.boards import inputs as rendered
from tests.real_sessions import write_real_session
from tests.refusals import refused, refused_as
from tests.running.usual import usual

pytestmark = pytest.mark.slow


@dataclass(frozen=True)
class Spelling:
    """How a program writes a rotation, and what is stated of it."""

    columns: str
    write: Callable[[Rotation], Floats]
    rotation: str = ""
    named: str = ""
    """What is said of poses that are taken for others; empty where they are read."""
    position: str = "mm"


def angles(axes: str) -> Callable[[Rotation], Floats]:
    """Angles in degrees, as SciPy names them."""
    return lambda turned: np.asarray(turned.as_euler(axes, degrees=True))


QUATERNION = "qx,qy,qz,qw"
SPELLINGS = {
    "quaternion": Spelling(QUATERNION, Rotation.as_quat),
    "metres": Spelling(QUATERNION, Rotation.as_quat, position="m"),
    "abb": Spelling("q1,q2,q3,q4", lambda turned: np.roll(turned.as_quat(), 1, 1), "abb"),
    "ur": Spelling("rx_rad,ry_rad,rz_rad", Rotation.as_rotvec, "universal-robots", "", "m"),
    "kuka": Spelling("a_deg,b_deg,c_deg", angles("ZYX"), "kuka"),
    "fanuc": Spelling("w_deg,p_deg,r_deg", angles("xyz"), "fanuc"),
    "doosan": Spelling("a_deg,b_deg,c_deg", angles("ZYZ"), "doosan"),
    "staubli": Spelling("rx_deg,ry_deg,rz_deg", angles("XYZ"), "staubli"),
    "scalar first": Spelling(
        QUATERNION, lambda turned: np.roll(turned.as_quat(), 1, 1), "", "scalar of the quaternion"
    ),
    "staubli as yaskawa": Spelling(
        "rx_deg,ry_deg,rz_deg", angles("XYZ"), "yaskawa", "with the angles as XYZ"
    ),
    "ur as yaskawa": Spelling(
        "rx_rad,ry_rad,rz_rad", Rotation.as_rotvec, "yaskawa", "with rotation vectors"
    ),
    "doosan as kuka": Spelling(
        "a_deg,b_deg,c_deg", angles("ZYZ"), "kuka", "with the angles as ZYZ"
    ),
}


@pytest.fixture(
    scope="module",
    params=usual(["rendered", "ten-real-poses", "calib1", "calib3"], 2, pytest.mark.soak),
)
def recording(
    request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory
) -> BoardInputs:
    """What is seen of a board in all pictures, with the true poses."""
    if request.param == "rendered":
        return rendered()
    real, case = SHARED / "real/robot-laser-chessboard", SHARED / "cases/ten-real-poses"
    if not (real.exists() and case.exists()):
        pytest.skip("the sample recordings are not there")
    folder = tmp_path_factory.mktemp("recording") / "s"
    if request.param == "ten-real-poses":
        shutil.copytree(case, folder)
    else:
        write_real_session(real / request.param, folder)
    session = read_any_session(folder)
    assert isinstance(session, BoardSession)
    return board_inputs(session)


def read_back(given: BoardInputs, spelling: Spelling) -> Floats:
    """(P, 4, 4) of the table that a program writes."""
    true = flange_motion(given.arm, given.readings).T_arm_flange
    numbers = spelling.write(Rotation.from_matrix(true[:, :3, :3]))
    scale = {"mm": 1.0, "m": 1e-3}[spelling.position]
    axes = ",".join(f"{axis}_{spelling.position}" for axis in "xyz")
    rows = np.hstack([scale * true[:, :3, 3], numbers])
    lines = [",".join(f"{value:.9f}" for value in row) for row in rows]
    table = parse_table("\n".join([f"{axes},{spelling.columns}", *lines]), Path("images.csv"), ())
    arm = RobotArm("Robot", "", rotation=spelling.rotation)
    poses = ArmReadings(table, arm).read_rows(table.rows)[1]
    assert poses is not None
    return poses


@pytest.mark.parametrize("name", SPELLINGS)
def test_each_spelling_is_read_or_named(recording: BoardInputs, name: str) -> None:
    spelling = SPELLINGS[name]
    true = flange_motion(recording.arm, recording.readings).T_arm_flange
    read = read_back(recording, spelling)
    if not spelling.named:
        np.testing.assert_allclose(read, true, atol=2e-6)
        return
    assert np.abs(read[:, :3, :3] - true[:, :3, :3]).max() > 0.1
    with refused("poses-read-otherwise") as caught:
        calibrate_board(replace(recording, readings=read))
    assert spelling.named in caught.value.line
    assert f"{len(true)} of {len(true)} poses agree" in caught.value.line


def test_what_a_controller_means_is_never_assumed(recording: BoardInputs) -> None:
    for spelling in SPELLINGS.values():
        if spelling.rotation:
            with refused_as("rotation-not-stated", "State the controller as rotation"):
                read_back(recording, replace(spelling, rotation=""))
    for name, columns in (("kuka", "a_rad,b_rad,c_rad"), ("ur", "rx_deg,ry_deg,rz_deg")):
        with refused("angles-in-other-unit"):
            read_back(recording, replace(SPELLINGS[name], columns=columns))
