"""What moved between two calibrations, estimated from their points."""

from dataclasses import replace

import numpy as np
import pytest

from app.metrology.calibration.drift import ARCSEC, Drift, MountedSensor, measure_drift
from app.metrology.sensor.laser_plane import LaserPlane
from app.metrology.transforms import rigid, rotation_from_vector
from tests.formats.builders import little_calibration

UV = np.array([(u, v) for u in (10, 20, 30, 40, 50) for v in (15, 24, 33)], dtype=float)


@pytest.fixture
def mounted() -> MountedSensor:
    found = little_calibration()
    return MountedSensor(found.camera, found.plane, found.T_flange_sensor)


def drift_of(before: MountedSensor, after: MountedSensor) -> Drift:
    found = measure_drift(before, after, UV)
    assert found is not None
    return found


def test_a_sensor_that_stayed_did_not_move(mounted: MountedSensor) -> None:
    found = drift_of(mounted, mounted)
    assert (found.sensor_um, found.plane_um, found.points_um) == (0, 0, 0)
    assert found.sensor_arcsec == pytest.approx(0, abs=1e-2)


def test_a_shift_and_a_turn_are_distinguished(mounted: MountedSensor) -> None:
    T = mounted.T_flange_sensor
    shifted = replace(mounted, T_flange_sensor=rigid(np.eye(3), np.array([0.03, 0, 0.04])) @ T)
    found = drift_of(mounted, shifted)
    assert found.sensor_um == pytest.approx(50)
    assert found.points_um == pytest.approx(50)
    assert found.sensor_arcsec == pytest.approx(0, abs=1e-2)
    assert found.plane_um <= 50
    turn = rotation_from_vector(np.array([0, 60 / ARCSEC, 0]))
    turned = replace(mounted, T_flange_sensor=T @ rigid(turn, np.zeros(3)))
    assert drift_of(mounted, turned).sensor_arcsec == pytest.approx(60, rel=1e-6)


def test_a_plane_that_tilts_is_reported_in_seconds_of_arc(mounted: MountedSensor) -> None:
    plane = mounted.plane
    along = np.cross(plane.normal, [1.0, 0.0, 0.0])
    tilt = rotation_from_vector(along / np.linalg.norm(along) * 30 / ARCSEC)
    flipped = LaserPlane(-(tilt @ plane.normal), -plane.offset_mm)
    assert drift_of(mounted, replace(mounted, plane=flipped)).plane_arcsec == pytest.approx(
        30, rel=1e-6
    )


def test_too_few_common_points_give_no_drift(mounted: MountedSensor) -> None:
    assert measure_drift(mounted, mounted, UV[:5]) is None
