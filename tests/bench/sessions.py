"""Sessions of random blocks, arms and cameras, and how far a calibration is off the truth."""

import json
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TypedDict

import numpy as np

from crenel.metrology.adjustment.block.calibrate import BlockCalibration
from crenel.metrology.calibration.one_pose import OnePoseCalibration
from crenel.metrology.sensor.camera import Camera
from crenel.metrology.sensor.laser_plane import LaserPlane
from crenel.metrology.sensor.triangulation import sensor_points
from crenel.metrology.transforms import apply, rigid_fit
from crenel_hardware.simulator.devices.kinematics import UnreachableError
from crenel_hardware.simulator.session import SessionPlan, render_session
from tests.bench.board_measures import PeerCalibration
from tests.metrology.numerics import rms_length

Calibrated = OnePoseCalibration | BlockCalibration | PeerCalibration


def draw_sessions(
    wanted: int, seed: int, draw: Callable[[np.random.Generator], SessionPlan], folder: Path
) -> Iterator[Path]:
    """So many sessions, each in a folder named by its seed, but for those that no arm reaches."""
    while wanted:
        try:
            render_session(folder / str(seed), seed, draw(np.random.default_rng(seed)))
        except UnreachableError:
            pass
        else:
            wanted -= 1
            yield folder / str(seed)
        seed += 1


class TurnedCamera(TypedDict):
    """Of a ``SessionPlan``."""

    roll_rad: float
    distortion: tuple[float, float, float, float, float]


def draw_camera(rng: np.random.Generator) -> TurnedCamera:
    turn, bend = float(rng.uniform(-np.pi, np.pi)), float(rng.uniform(-0.1, 0.05))
    return {"roll_rad": turn, "distortion": (bend, 0.0, 0.0, 0.0, 0.0)}


def in_sensor_um(camera: Camera, plane: LaserPlane, folder: Path) -> float:
    """Rms error in the sensor's frame after one rigid fit: the choice of frame is free."""
    truth = json.loads((folder / "truth.json").read_text())
    rebuilt = sensor_points(camera, plane, np.array(truth["pixels"]))
    true = np.array(truth["points_sensor_frame_mm"])
    return 1e3 * rms_length(apply(rigid_fit(true, rebuilt), rebuilt) - true)


def errors_um(found: Calibrated, folder: Path) -> tuple[float, float]:
    """Rms of the truth's points rebuilt: after one rigid fit, and in the flange's frame."""
    truth = json.loads((folder / "truth.json").read_text())
    assert found.plane is not None
    rebuilt = sensor_points(found.camera, found.plane, np.array(truth["pixels"]))
    off_mm = apply(found.T_flange_sensor, rebuilt) - np.array(truth["points_flange_frame_mm"])
    return in_sensor_um(found.camera, found.plane, folder), 1e3 * rms_length(off_mm)
