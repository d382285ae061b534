"""Where the light that fell on pixels came from, as the truth beside a session has it."""

import json
from pathlib import Path

import numpy as np

from crenel.metrology.adjustment.block.calibrate import BlockCalibration
from crenel.metrology.calibration.one_pose import OnePoseCalibration
from crenel.metrology.sensor.triangulation import sensor_points
from crenel.metrology.transforms import apply, rigid_fit
from tests.metrology.numerics import rms_length
from tests.present import present

Calibration = OnePoseCalibration | BlockCalibration


class Truth:
    """Pixels, and the points that they show."""

    def __init__(self, folder: Path) -> None:
        document = json.loads((folder / "truth.json").read_text())
        self.uv_px = np.array(document["pixels"])
        self.sensor_mm = np.array(document["points_sensor_frame_mm"])
        self.flange_mm = np.array(document["points_flange_frame_mm"])

    def sensor_rms_um(self, found: Calibration) -> float:
        """Rms error of the points that a calibration rebuilds, its sensor frame laid best."""
        points = sensor_points(found.camera, present(found.plane), self.uv_px)
        return 1e3 * rms_length(apply(rigid_fit(self.sensor_mm, points), points) - self.sensor_mm)

    def flange_rms_um(self, found: Calibration) -> float:
        points = sensor_points(found.camera, present(found.plane), self.uv_px)
        return 1e3 * rms_length(apply(found.T_flange_sensor, points) - self.flange_mm)
