"""What the simulated operator does alike on all gauges, and how gauges on the table are touched."""

from collections.abc import Callable, Sequence
from contextlib import suppress

import numpy as np

from crenel_hardware.interfaces import Button
from crenel_hardware.simulator.devices.kinematics import (
    ArmModel,
    Floats,
    UnreachableError,
    flange_pose,
    translation,
)
from crenel_hardware.simulator.devices.motion import JointPath, Motion, plan_path
from crenel_hardware.simulator.operator.holding import SensorMount
from crenel_hardware.simulator.operator.moving import MoveExecutor, OperatorState
from crenel_hardware.simulator.operator.on_sphere import PASS_S as SPHERE_PASS_S
from crenel_hardware.simulator.operator.on_sphere import plan_view
from crenel_hardware.simulator.operator.paths import PathPlanner
from crenel_hardware.simulator.operator.sweeping import sweep_poses
from crenel_hardware.simulator.operator.swinging import (
    LIFT_MM,
    LIFT_S,
    SPHERE_MM,
    choose_plate_point,
    path_onto_plate,
    path_onto_sphere,
    seat_centre,
)
from crenel_hardware.simulator.scene.world import Box, GaugeSphere, SimulatedScene

GAUGE = "gauge"
"""Instead of a face's name, after a gauge was touched."""
PATH_TRIES = 8
"""How many paths are tried; the shortest is taken."""
INDEX_OFFSETS = (0.0, 0.3, 0.6, -0.3)
"""Places on a sphere between its numbered ones, tried where the arm does not get to one."""
MIN_HEIGHT = 0.15
"""Over a sphere's middle, as a share of its radius, that is touched: its foot is below."""


class GaugeOperator:
    """Moves one station's arm to touch and scan gauges.

    Args:
        press: called with a button, whether it goes down, and when.
        show: called with the scene when something was set up or put away.
        pace: 1 is an operator's speed; 2 is twice as fast.
    """

    def __init__(
        self,
        arm: ArmModel,
        motion: Motion,
        scene: SimulatedScene,
        sight: SensorMount,
        press: Callable[[Button, bool, int], None],
        show: Callable[[SimulatedScene], None],
        contact_sd_mm: float = 0.006,
        pace: float = 1.0,
        seed: int = 0,
    ) -> None:
        self._arm, self._scene, self._show = arm, scene, show
        self._sensor_mount, self._T_sensor_flange = sight, np.linalg.inv(sight.T_flange_sensor)
        self._contact_sd_mm = contact_sd_mm
        self._rng = np.random.default_rng(seed)
        self.planner = PathPlanner(arm, motion, pace, contact_sd_mm, self._rng)
        self._executor = MoveExecutor(motion, press, self._forget_contact)
        self._last_contact: str | None = None
        self._seed = seed

    @property
    def state(self) -> OperatorState:
        return self._executor.state

    @property
    def ball_mm(self) -> float:
        """The sphere's diameter."""
        return SPHERE_MM

    def cancel(self) -> None:
        """Makes the move under way stop smoothly and end; later moves are not affected."""
        self._executor.cancel()

    def touch_ball(self, ball: int, index: int) -> bool:
        """Touches the sphere in its ``ball``-th place and presses the primary button."""
        with self._executor.move("touching the sphere"):
            centre = seat_centre(self._arm, ball)
            self._tap(lambda q: self._path_onto_sphere(centre, SPHERE_MM / 2, index, q))
            return True
        return False

    def touch_gauge(self, name: str, index: int) -> bool:
        """Touches the ``index``-th place of the plate or the sphere on the table and presses
        the primary button; False when cancelled. Raises KeyError for any other name."""
        thing = self._scene.find_object(name)
        shape, T = thing.shape, thing.T_arm_obj
        if not isinstance(shape, GaugeSphere | Box):
            raise KeyError(f"{name!r} is no gauge")
        with self._executor.move(f"touching the {name}"):
            if isinstance(shape, GaugeSphere):
                radius, centre = shape.radius_mm, T[:3, 3]
                self._tap(
                    lambda q: self._path_onto_sphere(
                        centre, radius, index, q, MIN_HEIGHT, PATH_TRIES
                    )
                )
            else:
                low, high = np.array(shape.low_mm), np.array(shape.high_mm)
                spot = choose_plate_point(low, high, index, self._rng)
                self._tap(
                    lambda q: path_onto_plate(
                        self._arm, T, spot, self.planner.gap_mm(), q, self._rng
                    )
                )
            return True
        return False

    def _pass_over(
        self,
        T_arm_ball: Floats,
        radius_mm: float,
        seen_from: Sequence[Floats],
        slowness: float,
        progress: tuple[float, float],
    ) -> None:
        """There and back over a ball, seen from the first direction (3,), in its frame, in which
        the arm can hold the sensor.

        Raises UnreachableError where it cannot in any.
        """
        begin, end = progress
        camera = self._sensor_mount.optics.centre_mm
        for sweep in (one for view in seen_from for one in plan_view(radius_mm, view, camera)):
            poses = sweep_poses(T_arm_ball, sweep) @ self._T_sensor_flange
            with suppress(UnreachableError):
                to_start = self.planner.path_to(poses[0], 50.0)
                plan_path(self._arm, poses, to_start.q_rad[-1], SPHERE_PASS_S)
                there, back = (begin + share * (end - begin) for share in (0.3, 0.65))
                self._executor.play(to_start, begin, there)
                seconds = SPHERE_PASS_S * slowness * self.planner.pace
                self._executor.play(self.planner.path_through(poses, seconds), there, back)
                self._executor.play(self.planner.path_through(poses[::-1], seconds), back, end)
                return
        raise UnreachableError("the arm cannot hold the sensor over the sphere like that")

    def _forget_contact(self) -> None:
        self._last_contact = None

    def _path_onto_sphere(
        self,
        centre: Floats,
        radius_mm: float,
        index: int,
        q: Floats,
        lowest: float = -0.1,
        ways: int = 1,
    ) -> JointPath:
        reach_mm = radius_mm + self.planner.gap_mm()
        for beside in INDEX_OFFSETS:
            with suppress(UnreachableError):
                place = index + beside
                return path_onto_sphere(
                    self._arm, centre, reach_mm, place, q, self._rng, lowest, ways
                )
        raise UnreachableError("the arm cannot touch the ball there")

    def _tap(self, way: Callable[[Floats], JointPath]) -> None:
        """Goes the way onto something from where the arm is, presses, and goes back off."""
        onto = self.planner.apply_pace(way(self.planner.current_joints()))
        up = translation(0.0, 0.0, LIFT_MM) @ flange_pose(self._arm, self.planner.current_joints())
        if self._last_contact != GAUGE:
            with suppress(UnreachableError):
                self._executor.play(self.planner.straight_path(up, LIFT_S), 0.0, 0.1)
        self._executor.play(self.planner.turn_joints(onto.q_rad[0]), 0.1, 0.5)
        self._executor.play(onto, 0.5, 0.6)
        self._executor.press_primary()
        self._executor.play(JointPath(onto.times_s, onto.q_rad[::-1].copy()), 0.9, 1.0)
        self._last_contact = GAUGE
