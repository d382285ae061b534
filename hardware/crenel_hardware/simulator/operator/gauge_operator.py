"""The simulated operator's moves on gauges: spheres, bars and plates, touched and scanned."""

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
from crenel_hardware.simulator.operator.in_seat import path_into_held_seat
from crenel_hardware.simulator.operator.moving import MoveExecutor, OperatorState
from crenel_hardware.simulator.operator.on_bar import path_onto_bar, view_directions
from crenel_hardware.simulator.operator.on_face import path_onto_face
from crenel_hardware.simulator.operator.on_sphere import PASS_S as SPHERE_PASS_S
from crenel_hardware.simulator.operator.on_sphere import path_onto_place, plan_view
from crenel_hardware.simulator.operator.paths import PathPlanner
from crenel_hardware.simulator.operator.sweeping import PLATE_TURNS_RAD, plan_strips, sweep_poses
from crenel_hardware.simulator.operator.swinging import (
    BAR_MM,
    LIFT_MM,
    LIFT_S,
    SPHERE_MM,
    choose_plate_point,
    path_onto_plate,
    path_onto_sphere,
    seat_centre,
)
from crenel_hardware.simulator.scene.ball_bar import bar_ends, with_bar
from crenel_hardware.simulator.scene.flat_plate import SIDE_MM, plate_pose, with_flat_plate
from crenel_hardware.simulator.scene.step_gauge import (
    StepGauge,
    draw_true_step_gauge,
    gauge_start_mm,
)
from crenel_hardware.simulator.scene.world import Box, GaugeSphere, SimulatedScene

GAUGE = "gauge"
"""Instead of a face's name, after a gauge was touched."""
PATH_TRIES = 8
"""How many paths are tried; the shortest is taken."""
INDEX_OFFSETS = (0.0, 0.3, 0.6, -0.3)
"""Places on a sphere between its numbered ones, tried where the arm does not get to one."""
GAUGE_SD_MM = 0.0005
"""The standard deviation of the step gauge's lengths, as its certificate has it."""
MIN_HEIGHT = 0.15
"""Over a sphere's middle, as a share of its radius, that is touched: its foot is below."""


class GaugeOperator:
    """Touches and scans gauges with one station's arm.

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
        self.step_gauge = StepGauge()
        """As its certificate has it."""
        self._true_gauge = draw_true_step_gauge(
            self.step_gauge, GAUGE_SD_MM, np.random.default_rng(seed)
        )
        off = np.random.default_rng([seed, 1]).normal(0.0, GAUGE_SD_MM)
        self._true_bar_mm = BAR_MM + float(off)

    @property
    def state(self) -> OperatorState:
        return self._executor.state

    @property
    def bar_mm(self) -> float:
        """The ball bar's length."""
        return BAR_MM

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
        place, stylus = _unit(outward), _unit(stylus_from)
        with self._executor.move("touching the sphere"):
            gap_mm = shape.radius_mm + self.planner.gap_mm()
            self._tap(
                lambda q: path_onto_place(self._arm, centre, gap_mm, place, stylus, q, self._rng)
            )
            return True
        return False

    def touch_length(
        self, middle_mm: Sequence[float], along: Sequence[float], length_mm: float, end: int
    ) -> bool:
        """Touches an end (0 or 1) of a length of the step gauge and presses the primary button;
        False when cancelled.

        Args:
            middle_mm: (3,) of the gauge where it is set up, arm frame.
            along: (3,) its direction, arm frame.

        Raises KeyError for a length that it does not have, UnreachableError where the arm cannot
        get there.
        """
        direction = _unit(along)
        start = gauge_start_mm(self.step_gauge, np.asarray(middle_mm), direction)
        at_mm = self._true_gauge.face_mm(self.step_gauge, length_mm, end)
        with self._executor.move("touching the step gauge"):
            gap_mm = self.planner.gap_mm()
            self._tap(
                lambda q: path_onto_face(
                    self._arm, start + at_mm * direction, gap_mm, -direction, q, self._rng
                )
            )
            return True
        return False

    def touch_bar(
        self, middle_mm: Sequence[float], along: Sequence[float], end: int, touch: int
    ) -> bool:
        """Touches the sphere at an end (0 or 1) of the ball bar at one of four places, from
        0, and presses the primary button; False when cancelled.

        Args:
            middle_mm: (3,) of the bar where it is set up, arm frame.
            along: (3,) its direction, arm frame.

        Raises UnreachableError where the arm cannot get there.
        """
        ends = bar_ends(np.asarray(middle_mm), np.asarray(along), self._true_bar_mm)
        with self._executor.move("touching the ball bar"):
            gap_mm = SPHERE_MM / 2 + self.planner.gap_mm()
            self._tap(lambda q: path_onto_bar(self._arm, ends, end, touch, gap_mm, q, self._rng))
            return True
        return False

    def scan_bar(
        self, middle_mm: Sequence[float], along: Sequence[float], slowness: float = 1.0
    ) -> bool:
        """Passes the sensor over both spheres of the ball bar, which is set up as of ``touch_bar``;
        False when cancelled.

        Args:
            slowness: by how much slower than usual.

        Raises UnreachableError where the arm cannot hold the sensor over a sphere.
        """
        direction = _unit(along)
        ends = bar_ends(np.asarray(middle_mm), direction, self._true_bar_mm)
        with self._executor.move("scanning the ball bar"):
            self._show(with_bar(self._scene, ends, SPHERE_MM))
            try:
                for begin, centre in zip((0.0, 0.5), ends, strict=True):
                    T, views = translation(*centre.tolist()), view_directions(centre, direction)
                    self._pass_over(T, SPHERE_MM / 2, views, slowness, (begin, begin + 0.5))
            finally:
                self._show(self._scene)
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
            direction = thing.T_arm_obj[:3, :3].T @ _unit(seen_from)
            self._pass_over(thing.T_arm_obj, shape.radius_mm, [direction], slowness, (0.0, 1.0))
            return True
        return False

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

    def touch_seat(self, centre_mm: Sequence[float], number: int) -> bool:
        """Puts the tip into a seat, with the arm articulated in the ``number``-th way, and presses
        the primary button; False when cancelled.

        Args:
            centre_mm: (3,) where the seat holds the tip's centre, arm frame.

        Raises UnreachableError where the arm cannot get there.
        """
        with self._executor.move("touching the seat"):
            # a seat holds the tip's centre: what a contact is off by is all that is left
            off_mm = self.planner.gap_mm() - self._arm.tip_diameter_mm / 2
            self._tap(
                lambda q: path_into_held_seat(
                    self._arm, np.asarray(centre_mm), off_mm, number, q, self._rng
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


def _unit(direction: Sequence[float]) -> Floats:
    found = np.asarray(direction, dtype=np.float64)
    return np.asarray(found / np.linalg.norm(found))
