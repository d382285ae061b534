"""How far stylus and camera are from the articulation that is wanted."""

from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from crenel.formats.datasheets.arm import read_any_arm
from crenel.formats.results.calibration import read_calibration
from crenel.gauges.sphere.guide_places import directions_of_articulations, off_articulation_deg
from crenel.gauges.sphere.guide_state import SphereScan, SphereState
from crenel.metrology.arm.kinematics import AnyArm
from crenel.metrology.arm.reported_poses import pose_from_transform
from crenel.metrology.transforms import Floats, inverse, rigid
from tests.bench.metrology.synthetic_arm import TIP, PoseArm
from tests.bench.metrology.synthetic_sphere import CENTRE, write_calibration

STYLUS = np.array([TIP.x_mm, TIP.y_mm, TIP.z_mm])


@pytest.fixture
def arm(tmp_path: Path) -> AnyArm:
    PoseArm().write(tmp_path / "arm.json")
    return read_any_arm(tmp_path / "arm.json")


def with_stylus_from(direction: Floats) -> Floats:
    """The reading with the wrist in a direction from the tip, and the tip at the sphere."""
    R = Rotation.align_vectors([-direction], [STYLUS / np.linalg.norm(STYLUS)])[0].as_matrix()
    return pose_from_transform(rigid(R, CENTRE - R @ STYLUS))


def test_the_stylus_is_compared_with_the_articulation_that_is_touched(arm: AnyArm) -> None:
    state = SphereState(step="location")
    wanted = directions_of_articulations(CENTRE)
    for held, expected_deg in ((0, 0.0), (1, 45.0)):
        off_deg = off_articulation_deg(state, arm, with_stylus_from(wanted[held]), CENTRE, None)
        assert off_deg == pytest.approx(expected_deg, abs=1e-6)


def test_the_camera_is_compared_with_the_scanned_articulation(arm: AnyArm, tmp_path: Path) -> None:
    write_calibration(tmp_path / "calibration.json")
    calibration = read_calibration(tmp_path / "calibration.json")
    first = SphereScan(
        number=1, at="", position=1, articulation=1, ended=True, patches=((100, 10),)
    )
    state = SphereState(step="scan", scans=(first,))
    wanted = directions_of_articulations(CENTRE)[1]
    camera = calibration.camera.centre_mm
    R = Rotation.align_vectors([wanted], [camera / np.linalg.norm(camera)])[0].as_matrix()
    # the camera straight over the sphere's centre in the second articulation
    T = rigid(R, CENTRE) @ inverse(calibration.T_flange_sensor)
    reading = pose_from_transform(T)
    off_deg = off_articulation_deg(state, arm, reading, CENTRE, calibration)
    assert off_deg == pytest.approx(0.0, abs=1e-5)


def test_nothing_is_compared_in_other_steps(arm: AnyArm) -> None:
    reading = with_stylus_from(np.array([0.0, 0.0, 1.0]))
    state = SphereState(step="pattern")
    assert off_articulation_deg(state, arm, reading, CENTRE, None) is None
