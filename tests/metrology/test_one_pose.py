"""The article's one-pose calibration: on the samples with their truth, and in its refusals."""

import csv
import json
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import pytest

from app.errors import OperationError
from app.metrology.arm.kinematics import Arm, Joint, Tip, flange_pose
from app.metrology.arm.link_error import LinkError
from app.metrology.calibration.one_pose import (
    OnePoseCalibration,
    OnePoseInputs,
    calibrate_one_pose,
    probe_matrix,
)
from app.metrology.sensor.laser_plane import in_frame
from app.metrology.sensor.triangulation import sensor_points
from app.metrology.targets.crenellated_block import Crenellated, corners
from app.metrology.transforms import Floats, apply, rigid, rigid_fit, rotation_from_vector
from tests.pictures import read_picture
from tests.running.usual import usual

pytestmark = pytest.mark.slow

SESSIONS = ("one-pose", "many-poses", "metal")


def read_arm(path: Path) -> Arm:
    document = json.loads(path.read_text())
    turn = np.radians
    joints = []
    for j in document["joints"]:
        e = j.get("error") or dict.fromkeys(
            ("x_mm", "y_mm", "z_mm", "rx_deg", "ry_deg", "rz_deg"), 0
        )
        error = LinkError(
            e["x_mm"],
            e["y_mm"],
            e["z_mm"],
            *(float(turn(e[k])) for k in ("rx_deg", "ry_deg", "rz_deg")),
        )
        joints.append(
            Joint(
                j["name"],
                j["a_mm"],
                float(turn(j["alpha_deg"])),
                j["d_mm"],
                float(turn(j["theta_deg"])),
                j["sign"],
                (-np.pi, np.pi),
                float(turn(j["encoder_sd_deg"])),
                error,
            )
        )
    tip = document["tip"]
    return Arm(
        "arm", "1", tuple(joints), Tip(tip["x_mm"], tip["y_mm"], tip["z_mm"], tip["diameter_mm"])
    )


def read_inputs(folder: Path, pose: int = 0) -> OnePoseInputs:
    document = json.loads((folder / "object.json").read_text())
    keys = ("front_y_mm", "back_y_mm", "crest_z_mm", "floor_z_mm", "base_z_mm")
    block = Crenellated(
        "b",
        "1",
        tuple(document["edges_x_mm"]),
        **{key: document[key] for key in (*keys, "standard_uncertainty_mm")},
    )
    with (folder / "probing.csv").open() as file:
        contacts = list(csv.DictReader(file))
    with (folder / "images.csv").open() as file:
        rows = [row for row in csv.DictReader(file) if int(row["pose"]) == pose]

    def angles(row: dict[str, str]) -> list[float]:
        return [float(np.radians(float(row[key]))) for key in row if key.startswith("q")]

    pictures = {row["lighting"]: read_picture(folder / row["file"]) for row in rows}
    return OnePoseInputs(
        arm=read_arm(folder / "arm.json"),
        block=block,
        features=tuple(row["feature"] for row in contacts),
        contact_q_rad=np.array([angles(row) for row in contacts]),
        pose_q_rad=np.array(angles(rows[0])),
        ambient=pictures["ambient"],
        laser=pictures["laser"],
        size_px=(1280, 1024),
    )


class Truth:
    """Pixels, and where the light that fell there came from."""

    def __init__(self, folder: Path) -> None:
        document = json.loads((folder / "truth.json").read_text())
        self.uv_px = np.array(document["pixels"])
        self.sensor_mm = np.array(document["points_sensor_frame_mm"])
        self.flange_mm = np.array(document["points_flange_frame_mm"])

    def sensor_rms_um(self, found: OnePoseCalibration) -> float:
        points = sensor_points(found.camera, found.plane, self.uv_px)
        T = rigid_fit(self.sensor_mm, points)
        return rms_um(apply(T, points) - self.sensor_mm)

    def flange_rms_um(self, found: OnePoseCalibration) -> float:
        points = sensor_points(found.camera, found.plane, self.uv_px)
        return rms_um(apply(found.T_flange_sensor, points) - self.flange_mm)


def rms_um(off_mm: Floats) -> float:
    return 1e3 * float(np.sqrt(np.mean(np.sum(off_mm**2, axis=1))))


@pytest.fixture(scope="module")
def calibrated(samples: Path) -> dict[str, OnePoseCalibration]:
    return {name: calibrate_one_pose(read_inputs(samples / name)) for name in SESSIONS}


def test_the_articles_case_reaches_micrometres(
    samples: Path, calibrated: dict[str, OnePoseCalibration]
) -> None:
    truth, found = Truth(samples / "one-pose"), calibrated["one-pose"]
    assert truth.sensor_rms_um(found) <= 3
    assert truth.flange_rms_um(found) <= 20
    assert found.faugeras.condition_number < 10
    assert found.reprojection_rms_px < 0.15
    assert found.findings[0].quality == "good"


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


def test_one_picture_with_both_lights_is_as_good(samples: Path) -> None:
    inputs = read_inputs(samples / "one-pose")
    assert inputs.laser is not None
    both = np.asarray(cv2.add(inputs.ambient, inputs.laser), dtype=np.uint8)
    found = calibrate_one_pose(replace(inputs, ambient=both, laser=None))
    assert Truth(samples / "one-pose").sensor_rms_um(found) <= 4


def test_a_rotated_camera_is_as_good(samples: Path) -> None:
    """The same picture turned by a quarter: one stripe point a row, u and v exchanged."""
    inputs = read_inputs(samples / "one-pose")
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
    samples: Path, calibrated: dict[str, OnePoseCalibration]
) -> None:
    found = calibrated["one-pose"]
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
    assert Truth(samples / "one-pose").flange_rms_um(found) < 2 * found.total_um
    assert found.covariance.shape == (23, 23)
    assert np.linalg.eigvalsh(found.covariance).min() > -1e-9
    near, far = found.depth_range_mm
    step = read_inputs(samples / "one-pose").block
    assert 0.5 * (step.crest_z_mm - step.floor_z_mm) < far - near < 40


def test_the_worst_points_and_the_findings_are_named(
    calibrated: dict[str, OnePoseCalibration],
) -> None:
    found = calibrated["one-pose"]
    kinds = [point.kind for point in found.worst]
    assert {kinds.count(kind) for kind in ("contact", "corner", "stripe")} == {3}
    contacts = [point.value for point in found.worst if point.kind == "contact"]
    assert contacts[0] == pytest.approx(1e3 * np.abs(found.alignment.residuals_mm).max())
    assert {"uncertainty", "contacts", "edges", "laser-plane"} <= {f.code for f in found.findings}


def test_any_other_sensor_frame_gives_the_same_points(
    samples: Path, calibrated: dict[str, OnePoseCalibration]
) -> None:
    """Eq. 5 in place of Eq. 6: conjugated pairs of the object's corners, least squares."""
    found, inputs = calibrated["one-pose"], read_inputs(samples / "one-pose")
    T_new_obj = rigid(rotation_from_vector(np.array([0.4, -1.1, 0.7])), np.array([30.0, -80, 250]))
    camera, plane = in_frame(found.camera, found.plane, T_new_obj)
    in_obj = np.array(list(corners(inputs.block).values()), dtype=np.float64)
    T_arm_new = rigid_fit(apply(found.alignment.T_arm_obj, in_obj), apply(T_new_obj, in_obj))
    T_arm_flange = flange_pose(inputs.arm, inputs.pose_q_rad)
    uv = Truth(samples / "one-pose").uv_px
    T_arm_sensor = T_arm_flange @ found.T_flange_sensor
    one = apply(T_arm_sensor, sensor_points(found.camera, found.plane, uv))
    T_arm_other = T_arm_flange @ probe_matrix(T_arm_flange, T_arm_new)
    other = apply(T_arm_other, sensor_points(camera, plane, uv))
    np.testing.assert_allclose(one, other, atol=1e-6)


def test_progress_is_reported_from_beginning_to_end(samples: Path) -> None:
    shares: list[float] = []
    calibrate_one_pose(read_inputs(samples / "metal"), lambda share, _: shares.append(share))
    assert shares == sorted(shares)
    assert (shares[0], shares[-1]) == (0.0, 1.0)
    assert len(shares) >= 5


@pytest.fixture(scope="module")
def inputs(samples: Path) -> OnePoseInputs:
    return read_inputs(samples / "one-pose")


def refused(inputs: OnePoseInputs) -> str:
    with pytest.raises(OperationError) as refusal:
        calibrate_one_pose(inputs)
    assert refusal.value.what
    return refusal.value.code


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
