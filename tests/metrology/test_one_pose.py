"""The article's one-pose calibration: on samples and random sessions, and in its refusals."""

from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import pytest

from crenel.formats.session.calibration_session import read_session
from crenel.metrology.arm.kinematics import flange_pose
from crenel.metrology.calibration.one_pose import (
    OnePoseCalibration,
    OnePoseInputs,
    calibrate_one_pose,
    probe_matrix,
)
from crenel.metrology.sensor.laser_plane import in_frame
from crenel.metrology.sensor.triangulation import sensor_points
from crenel.metrology.targets.crenellated_block import corners
from crenel.metrology.transforms import apply, rigid, rigid_fit, rotation_from_vector
from crenel.workflows.calibrate import one_pose_inputs
from crenel_hardware.simulator.session import SessionPlan, render_session
from tests.metrology.refusals import refusal_of
from tests.metrology.true_points import Truth
from tests.running.usual import usual

pytestmark = pytest.mark.slow

SESSIONS = ("one-pose", "many-poses", "metal")
PLANS = {
    "upside down, seven joints": SessionPlan(joints=7, roll_rad=np.pi),
    "stripe along the rows, both lights": SessionPlan(roll_rad=np.pi / 2, lighting="both"),
    # a column of the picture crosses crests and floors
    "turned by 30 degrees": SessionPlan(roll_rad=np.radians(30)),
    "turned by -35 degrees, both lights": SessionPlan(roll_rad=np.radians(-35), lighting="both"),
    "a barrel of a lens": SessionPlan(distortion=(-0.12, 0.0, 0.0, 0.0, 0.0)),
}


def read_inputs(folder: Path, pose: int = 0) -> OnePoseInputs:
    session = read_session(folder)
    return one_pose_inputs(session, session.poses[pose])


@pytest.fixture(scope="module")
def inputs(samples: Path) -> OnePoseInputs:
    return read_inputs(samples / "one-pose")


@pytest.fixture(scope="module")
def truth(samples: Path) -> Truth:
    return Truth(samples / "one-pose")


@pytest.fixture(scope="module")
def calibrated(samples: Path) -> dict[str, OnePoseCalibration]:
    return {name: calibrate_one_pose(read_inputs(samples / name)) for name in SESSIONS}


@pytest.fixture
def found(calibrated: dict[str, OnePoseCalibration]) -> OnePoseCalibration:
    return calibrated["one-pose"]


def test_the_articles_case_reaches_micrometres(found: OnePoseCalibration, truth: Truth) -> None:
    assert truth.sensor_rms_um(found) <= 3
    assert truth.flange_rms_um(found) <= 20
    assert found.faugeras.condition_number < 10
    assert found.reprojection_rms_px < 0.15
    assert found.findings[0].quality == "good"


@pytest.mark.parametrize(
    ("seed", "roll_rad"),
    usual([(9002, -1.2297), (9004, -2.6817), (9017, 0.4739)], 1, pytest.mark.soak),
)
def test_lit_faces_are_not_taken_for_the_line(seed: int, roll_rad: float, tmp_path: Path) -> None:
    """Nor does the line hide the block, where a column crosses it on a crest and on a floor."""
    render_session(tmp_path, seed, SessionPlan(joints=7, lighting="both", roll_rad=roll_rad))
    assert Truth(tmp_path).sensor_rms_um(calibrate_one_pose(read_inputs(tmp_path))) < 5


@pytest.mark.parametrize("session", ["many-poses", "metal"])
def test_the_first_pose_alone_is_enough_for_the_sensor(
    session: str, samples: Path, calibrated: dict[str, OnePoseCalibration]
) -> None:
    assert Truth(samples / session).sensor_rms_um(calibrated[session]) <= 4


@pytest.mark.parametrize(
    ("session", "pose"),
    usual([("many-poses", 3), ("many-poses", 6), ("metal", 2)], 1, pytest.mark.soak),
)
def test_every_other_pose_is_as_good(session: str, pose: int, samples: Path) -> None:
    found = calibrate_one_pose(read_inputs(samples / session, pose))
    assert Truth(samples / session).sensor_rms_um(found) <= 4


@pytest.mark.parametrize(
    ("seed", "plan"), usual(enumerate(PLANS.values(), 501), {0, 3, 4}, pytest.mark.soak), ids=PLANS
)
def test_points_lie_where_the_light_fell(seed: int, plan: SessionPlan, tmp_path: Path) -> None:
    render_session(tmp_path, seed, plan)
    found, truth = calibrate_one_pose(read_inputs(tmp_path)), Truth(tmp_path)
    assert truth.sensor_rms_um(found) < 4
    assert truth.flange_rms_um(found) < 3 * found.total_um


def test_one_picture_with_both_lights_is_as_good(inputs: OnePoseInputs, truth: Truth) -> None:
    assert inputs.laser is not None
    both = np.asarray(cv2.add(inputs.ambient, inputs.laser), dtype=np.uint8)
    found = calibrate_one_pose(replace(inputs, ambient=both, laser=None))
    assert truth.sensor_rms_um(found) <= 4


def test_a_rotated_camera_is_as_good(samples: Path, inputs: OnePoseInputs) -> None:
    """The same picture turned by a quarter: one stripe point a row, u and v exchanged."""
    assert inputs.laser is not None
    turned = replace(
        inputs,
        ambient=np.rot90(inputs.ambient).copy(),
        laser=np.rot90(inputs.laser).copy(),
        stripe_axis="v",
        size_px=(1024, 1280),
    )
    truth = Truth(samples / "one-pose")
    truth.uv_px = np.column_stack([truth.uv_px[:, 1], 1279 - truth.uv_px[:, 0]])
    assert truth.sensor_rms_um(calibrate_one_pose(turned)) <= 4


def test_the_budget_adds_up_and_contains_the_error(
    found: OnePoseCalibration, inputs: OnePoseInputs, truth: Truth
) -> None:
    squares = [row.value_um**2 for row in found.budget]
    assert found.total_um == pytest.approx(np.sqrt(sum(squares)))
    assert [row.source for row in found.budget] == [
        "contact points",
        "arm encoders",
        "object certificate",
        "edges and corners",
        "stripe",
        "distortion",
    ]
    assert truth.flange_rms_um(found) < 2 * found.total_um
    assert found.covariance.shape == (23, 23)
    assert np.linalg.eigvalsh(found.covariance).min() > -1e-9
    near, far = found.depth_range_mm
    assert 0.5 * (inputs.block.crest_z_mm - inputs.block.floor_z_mm) < far - near < 40


def test_the_worst_points_and_the_findings_are_named(found: OnePoseCalibration) -> None:
    kinds = [point.kind for point in found.worst]
    assert {kinds.count(kind) for kind in ("contact", "corner", "stripe")} == {3}
    contacts = [point.value for point in found.worst if point.kind == "contact"]
    assert contacts[0] == pytest.approx(1e3 * np.abs(found.alignment.residuals_mm).max())
    assert {"uncertainty", "contacts", "edges", "laser-plane"} <= {f.code for f in found.findings}


def test_any_other_sensor_frame_gives_the_same_points(
    found: OnePoseCalibration, inputs: OnePoseInputs, truth: Truth
) -> None:
    """Eq. 5 in place of Eq. 6: conjugated pairs of the object's corners, least squares."""
    T_new_obj = rigid(rotation_from_vector(np.array([0.4, -1.1, 0.7])), np.array([30.0, -80, 250]))
    camera, plane = in_frame(found.camera, found.plane, T_new_obj)
    in_obj = np.array(list(corners(inputs.block).values()), dtype=np.float64)
    T_arm_new = rigid_fit(apply(found.alignment.T_arm_obj, in_obj), apply(T_new_obj, in_obj))
    T_arm_flange = flange_pose(inputs.arm, inputs.pose_q_rad)
    T_arm_sensor = T_arm_flange @ found.T_flange_sensor
    one = apply(T_arm_sensor, sensor_points(found.camera, found.plane, truth.uv_px))
    T_arm_other = T_arm_flange @ probe_matrix(T_arm_flange, T_arm_new)
    other = apply(T_arm_other, sensor_points(camera, plane, truth.uv_px))
    np.testing.assert_allclose(one, other, atol=1e-6)


def test_progress_is_reported_from_beginning_to_end(samples: Path) -> None:
    shares: list[float] = []
    calibrate_one_pose(read_inputs(samples / "metal"), lambda share, _: shares.append(share))
    assert shares == sorted(shares)
    assert (shares[0], shares[-1]) == (0.0, 1.0)
    assert len(shares) >= 5


def refused(inputs: OnePoseInputs) -> str:
    refusal = refusal_of(calibrate_one_pose, inputs)
    assert refusal.what
    return refusal.code


def test_what_does_not_belong_together_is_refused(inputs: OnePoseInputs) -> None:
    assert inputs.laser is not None
    dark = np.zeros_like(inputs.ambient)
    assert refused(replace(inputs, size_px=(640, 480))) == "image-size"
    assert refused(replace(inputs, laser=inputs.laser[:, :-1])) == "image-size"
    assert refused(replace(inputs, pose_q_rad=np.zeros(7))) == "joint-count"
    assert refused(replace(inputs, contact_q_rad=inputs.contact_q_rad[:, :5])) == "joint-count"
    assert refused(replace(inputs, pose_q_rad=np.full(6, np.nan))) == "angles-not-finite"
    assert refused(replace(inputs, features=inputs.features[:-1])) == "contacts-malformed"
    assert refused(replace(inputs, laser=dark)) == "stripe-not-found"
    assert refused(replace(inputs, ambient=dark)) == "image-dark"


def test_a_block_that_is_not_in_the_picture_is_refused(inputs: OnePoseInputs) -> None:
    x = tuple(-value for value in reversed(inputs.block.edges_x_mm))
    mirrored = replace(inputs.block, edges_x_mm=x)
    assert refused(replace(inputs, block=mirrored)).startswith(("object-", "contact"))


def test_contacts_on_a_wrong_face_are_refused(inputs: OnePoseInputs) -> None:
    faces = ["front" if f == "crest" else "crest" if f == "front" else f for f in inputs.features]
    assert refused(replace(inputs, features=tuple(faces))).startswith("contact")
