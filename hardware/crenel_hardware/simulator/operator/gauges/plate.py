"""The flat plate that the simulated operator sets up and scans; it is rendered meanwhile."""

from dataclasses import replace

import numpy as np

from crenel_hardware.simulator.devices.kinematics import Floats, rotation_about, translation
from crenel_hardware.simulator.operator.gauge_operator import GaugeOperator
from crenel_hardware.simulator.operator.sweeping import Sweep, sweep_poses
from crenel_hardware.simulator.scene.datasheets import JsonObject
from crenel_hardware.simulator.scene.world import Box, SceneObject, SimulatedScene

SIDE_MM, THICK_MM = 100.0, 15.0
MIDDLE_MM, TURN_RAD = (690.0, -10.0, 120.0), 0.3
"""Where it lies, over all that stands on the table, arm frame."""
LEAN_RAD = 0.01
"""Nobody levels it."""
STRIPS_MM = (-22.0, 22.0)
"""From the middle of a plate to the middles of the strips, which overlap."""
PLATE_TURNS_RAD = (-np.pi / 4, np.pi / 4)
"""The turns of the sensor over a plate in its two orientations."""


def flat_plate_datasheet() -> JsonObject:
    """*.nominal.json of a larger plate, which is set up anywhere."""
    return {
        "format": "crenel/nominal",
        "version": 1,
        "shape": "plane",
        "name": "Simulated flat plate",
        "serial_number": "TWIN-P2",
        "certificate": "simulated",
        "standard_uncertainty_um": 0.5,
        "form_um": 1.0,
        "width_mm": SIDE_MM,
    }


def plate_pose() -> Floats:
    """``T_arm_plate`` (4, 4): the middle of its top."""
    lies = rotation_about("z", TURN_RAD) @ rotation_about("x", LEAN_RAD)
    return np.asarray(translation(*MIDDLE_MM) @ lies)


def with_flat_plate(scene: SimulatedScene) -> SimulatedScene:
    """A scene in which the plate is set up."""
    half = SIDE_MM / 2
    plate = Box((-half, -half, -THICK_MM), (half, half, 0.0))
    thing = SceneObject("flat plate", plate, plate_pose(), 0.8)
    return replace(scene, objects=(*scene.objects, thing))


def plan_strips(half_mm: float, turn_rad: float) -> list[Sweep]:
    """How a flat plate is scanned in one orientation: there and back, in strips side by side.

    Args:
        half_mm: half the side of the plate.
        turn_rad: of the sensor about the plate's normal.
    """
    turned = rotation_about("z", turn_rad)
    strips = []
    for i, x in enumerate(STRIPS_MM):
        ends = [turned @ translation(x, y, 0.0) for y in (-half_mm, half_mm)]
        strips.append(Sweep(*(ends if i % 2 == 0 else ends[::-1])))
    return strips


class PlateOperator(GaugeOperator):
    """Scans the flat plate."""

    def scan_plate(self, orientation: int) -> bool:
        """Sets the flat plate up and passes the sensor over it in strips side by side; False when
        cancelled.

        Args:
            orientation: 1 or 2, in which the stripe lies across that of the other.

        Raises UnreachableError where the arm cannot hold the sensor like that.
        """
        with self._executor.move("scanning the flat plate"):
            self._show(with_flat_plate(self._scene))
            try:
                sweeps = plan_strips(SIDE_MM / 2, PLATE_TURNS_RAD[orientation - 1])
                for i, sweep in enumerate(sweeps):
                    begin, share = i / len(sweeps), 1 / len(sweeps)
                    poses = sweep_poses(plate_pose(), sweep) @ self._T_sensor_flange
                    to_start = self.planner.path_to(poses[0], 20.0)
                    self._executor.play(to_start, begin, begin + 0.25 * share)
                    path = self.planner.path_through(poses, sweep.duration_s)
                    self._executor.play(path, begin + 0.25 * share, begin + share)
            finally:
                self._show(self._scene)
            return True
        return False
