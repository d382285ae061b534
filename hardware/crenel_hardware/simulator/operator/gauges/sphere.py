"""The sphere on the simulated table in the one-sphere test: touched and scanned from directions."""

from collections.abc import Sequence

from crenel_hardware.simulator.operator.gauge_operator import GaugeOperator
from crenel_hardware.simulator.operator.on_sphere import path_onto_place, unit_vector
from crenel_hardware.simulator.scene.world import GaugeSphere


class SphereOperator(GaugeOperator):
    """Touches and scans the sphere."""

    def touch_sphere(self, outward: Sequence[float], stylus_from: Sequence[float]) -> bool:
        """Touches the sphere on the table at a place and presses the primary button; False when
        cancelled.

        Args:
            outward: (3,) direction of the place from the sphere's centre, arm frame.
            stylus_from: (3,) direction in which the stylus points away from the place.

        Raises UnreachableError where the arm cannot get there like that.
        """
        thing = self._scene.find_object("sphere")
        shape, centre = thing.shape, thing.T_arm_obj[:3, 3]
        assert isinstance(shape, GaugeSphere)
        place, stylus = unit_vector(outward), unit_vector(stylus_from)
        with self._executor.move("touching the sphere"):
            gap_mm = shape.radius_mm + self.planner.gap_mm()
            self._tap(
                lambda q: path_onto_place(self._arm, centre, gap_mm, place, stylus, q, self._rng)
            )
            return True
        return False

    def scan_sphere(self, seen_from: Sequence[float], slowness: float = 1.0) -> bool:
        """Passes the sensor over the sphere on the table so that it sees it from a direction
        (3,), arm frame; False when cancelled.

        Args:
            slowness: by how much slower than usual.

        Raises UnreachableError where the arm cannot hold the sensor like that.
        """
        thing = self._scene.find_object("sphere")
        shape = thing.shape
        assert isinstance(shape, GaugeSphere)
        with self._executor.move("scanning the sphere"):
            direction = thing.T_arm_obj[:3, :3].T @ unit_vector(seen_from)
            self._pass_over(thing.T_arm_obj, shape.radius_mm, [direction], slowness, (0.0, 1.0))
            return True
        return False
