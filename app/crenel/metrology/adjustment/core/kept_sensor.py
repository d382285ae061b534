"""A camera and its mounting as an earlier calibration left them: values, and their covariance as
that of the unknowns of an adjustment in which they are held."""

from dataclasses import dataclass, replace

import numpy as np

from crenel.metrology.adjustment.core.gauss_newton import AdjustmentResult
from crenel.metrology.adjustment.core.parameters import (
    CAMERA,
    INTRINSIC,
    MOUNT,
    AdjustmentState,
)
from crenel.metrology.adjustment.core.uncertainty import NAMES, derivatives_of_names
from crenel.metrology.calibration.uncertainty_budget import PROBE_NAMES
from crenel.metrology.sensor.camera import Camera
from crenel.metrology.transforms import Floats, inverse, rigid

HELD = np.r_[CAMERA, MOUNT]


@dataclass(frozen=True)
class KeptSensor:
    """Camera and mounting of an earlier calibration.

    ``camera`` and ``T_flange_sensor`` (4, 4) are in its sensor frame; ``covariance`` (K, K) belongs
    to ``names``, of ``uncertainty.NAMES``, with the mounting's twist about ``pivot_mm`` (3,).
    """

    camera: Camera
    T_flange_sensor: Floats
    names: tuple[str, ...]
    covariance: Floats
    pivot_mm: Floats

    @property
    def sensor_pose(self) -> Floats:
        """``T_cam_sensor`` (4, 4)."""
        return rigid(self.camera.rotation, self.camera.translation_mm)

    def apply_to(self, state: AdjustmentState) -> AdjustmentState:
        """The state with this camera and mounting."""
        camera = replace(self.camera, rotation=np.eye(3), translation_mm=np.zeros(3))
        mount = self.T_flange_sensor @ inverse(self.sensor_pose)
        return replace(state, camera=camera, T_flange_cam=mount)

    def carry_into(self, found: AdjustmentResult) -> AdjustmentResult:
        """The adjustment that held this sensor, with the sensor's covariance carried into all its
        unknowns."""
        N = np.sum(list(found.parts.values()), axis=0)
        by_held = -(found.covariance @ N)[:, HELD]
        by_held[HELD] = np.eye(len(HELD))
        return replace(found, by_kept=by_held @ self._covariance_of_held(found.state) @ by_held.T)

    def _covariance_of_held(self, state: AdjustmentState) -> Floats:
        """(14, 14) of the unknowns of camera and mounting."""
        own = (*INTRINSIC, *PROBE_NAMES)
        M = derivatives_of_names(state, self.sensor_pose, self.pivot_mm)
        to_unknowns = np.linalg.inv(M[np.ix_([NAMES.index(name) for name in own], HELD)])
        at = [self.names.index(name) for name in own]
        return np.asarray(to_unknowns @ self.covariance[np.ix_(at, at)] @ to_unknowns.T)
