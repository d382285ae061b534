"""The simulated operator moves the true arm as a person would: touches, holds and scans.

Moves block until they are done. Any other thread may read ``state`` and ``cancel``.
"""

from collections.abc import Sequence
from contextlib import suppress
from functools import cached_property

import numpy as np

from crenel_hardware.simulator.devices.kinematics import (
    Floats,
    UnreachableError,
    flange_pose,
    translation,
)
from crenel_hardware.simulator.operator.contact import (
    BOARD,
    choose_contact_point,
    outward_normal,
    reachable_faces,
)
from crenel_hardware.simulator.operator.gauge_operator import GAUGE
from crenel_hardware.simulator.operator.gauges.bar import BarOperator
from crenel_hardware.simulator.operator.gauges.part import PartOperator
from crenel_hardware.simulator.operator.gauges.plate import PlateOperator
from crenel_hardware.simulator.operator.gauges.seat import SeatOperator
from crenel_hardware.simulator.operator.gauges.sphere import SphereOperator
from crenel_hardware.simulator.operator.gauges.step_gauge import StepGaugeOperator
from crenel_hardware.simulator.operator.holding import sensor_over_block, sensor_over_board
from crenel_hardware.simulator.operator.paths import PASS_S, passing_poses
from crenel_hardware.simulator.operator.sweeping import plan_sweeps, sweep_poses
from crenel_hardware.simulator.operator.swinging import (
    LIFT_MM,
    LIFT_S,
    bar_end,
    path_into_seat,
    seat_centre,
    swing_path,
)
from crenel_hardware.simulator.scene.world import Board, Box, CrenellatedBlock

CLEAR_MM = 3.0
"""From here the tip goes straight to the face, and back."""
APPROACH_S, RETRACT_S = 0.09, 0.06
TRIES = 12


class ScriptedOperator(
    SphereOperator, BarOperator, StepGaugeOperator, PlateOperator, SeatOperator, PartOperator
):
    """Moves one station's arm.

    Args:
        press: called with a button, whether it goes down, and when.
        show: called with the scene when something was set up or put away.
        pace: 1 is an operator's speed; 2 is twice as fast.
    """

    @cached_property
    def faces(self) -> tuple[str, ...]:
        """Faces of the block that ``touch`` takes."""
        block = self._scene.find_object("block").shape
        assert isinstance(block, CrenellatedBlock)
        return reachable_faces(block, self._arm.tip_diameter_mm / 2)

    @cached_property
    def parts(self) -> tuple[str, ...]:
        """Parts that ``scan_part`` takes."""
        things = self._scene.objects
        return tuple(one.name for one in things if plan_sweeps(one) and one.name != "block")

    def touch(self, face: str, index: int) -> bool:
        """Touches the ``index``-th place of a face and presses the primary button.

        Returns False when cancelled. Raises KeyError for what is neither in ``faces`` nor
        "board", UnreachableError where the arm cannot get there.
        """
        if face not in (*self.faces, BOARD):
            known = ", ".join((*self.faces, BOARD))
            raise KeyError(f"the simulated operator cannot touch {face!r}; it can touch {known}")
        thing = self._scene.find_object("board" if face == BOARD else "block")
        assert isinstance(thing.shape, CrenellatedBlock | Board)
        with self._executor.move(
            "touching the board" if face == BOARD else f"touching the {face} face"
        ):
            spot = choose_contact_point(
                thing.shape, face, index, self._arm.tip_diameter_mm / 2, self._rng
            )
            away = thing.T_arm_obj[:3, :3] @ outward_normal(face)
            clear = (CLEAR_MM + _depth(thing.shape, face)) * away
            left = None if self._last_contact == GAUGE else self._last_contact
            to_spot, contact = self.planner.path_to_contact(
                thing.T_arm_obj, face, spot, clear, left
            )
            self._executor.play(to_spot, 0.0, 0.4)
            slower = 1.5 if face == "floor" else 1.0
            self._executor.play(self.planner.straight_path(contact, slower * APPROACH_S), 0.4, 0.5)
            self._executor.press_primary()
            lifted = translation(*clear.tolist()) @ contact
            self._executor.play(self.planner.straight_path(lifted, slower * RETRACT_S), 0.9, 1.0)
            self._last_contact = face
            return True
        return False

    def hold_over(self, name: str, view: int = 0) -> bool:
        """Holds the sensor where the camera frames the "block", or the "board" in the
        ``view``-th of ``holding.VIEWS``.

        Returns False when cancelled. Raises KeyError for any other name.
        """
        thing = self._scene.find_object(name)
        if not isinstance(thing.shape, CrenellatedBlock | Board):
            raise KeyError(f"the simulated operator does not hold the sensor over {name!r}")
        with self._executor.move("placing the sensor"):
            for _ in range(TRIES):
                T = thing.T_arm_obj @ self._draw_sensor_pose(thing.shape, view)
                try:
                    path = self.planner.path_to(T @ self._T_sensor_flange, 60.0)
                except UnreachableError:
                    continue
                self._executor.play(path, 0.0, 1.0, trembles=True)
                return True
            raise UnreachableError(f"the arm cannot hold the sensor over the {name}")
        return False

    def _draw_sensor_pose(self, shape: CrenellatedBlock | Board, view: int) -> Floats:
        """``T_obj_sensor`` (4, 4), another one each time."""
        if isinstance(shape, Board):
            return sensor_over_board(shape, self._sensor_mount, view, self._rng)
        return sensor_over_block(shape, self._rng)

    def hold_at(self, q_rad: Sequence[float]) -> bool:
        """Holds the arm at joint angles, as well as an operator can; False when cancelled."""
        with self._executor.move("going to the next pose"):
            self._executor.play(
                self.planner.turn_joints(np.asarray(q_rad, dtype=np.float64)), 0.0, 0.9
            )
            self._executor.play(
                self.planner.turn_joints(self.planner.current_joints()), 0.9, 1.0, trembles=True
            )
            return True
        return False

    def hold_flange_at(self, T_arm_flange: Floats) -> bool:
        """Holds the flange at a pose (4, 4), as well as an operator can; False when cancelled.

        Raises UnreachableError where the arm cannot get there.
        """
        with self._executor.move("going to the next pose"):
            path = self.planner.path_to(np.asarray(T_arm_flange), 30.0)
            self._executor.play(path, 0.0, 1.0, trembles=True)
            return True
        return False

    def scan_part(self, name: str) -> bool:
        """Sweeps the sensor over one of ``parts``; False when cancelled. Raises KeyError."""
        if name not in self.parts:
            raise KeyError(f"there is no part {name!r}; there are {', '.join(self.parts)}")
        thing = self._scene.find_object(name)
        with self._executor.move(f"scanning the {name}"):
            sweeps = plan_sweeps(thing)
            for i, sweep in enumerate(sweeps):
                begin, share = i / len(sweeps), 1 / len(sweeps)
                start = thing.T_arm_obj @ sweep.start @ self._T_sensor_flange
                self._executor.play(self.planner.path_to(start, 50.0), begin, begin + 0.25 * share)
                poses = sweep_poses(thing.T_arm_obj, sweep) @ self._T_sensor_flange
                path = self.planner.path_of_scan(poses, sweep.duration_s)
                self._executor.play(path, begin + 0.25 * share, begin + share)
            return True
        return False

    def pass_over_plate(self) -> bool:
        """Goes over the plate and back, nearer and away again; False when cancelled."""
        plate = self._scene.find_object("plate")
        assert isinstance(plate.shape, Box)
        with self._executor.move("passing over the plate"):
            poses = passing_poses(plate.T_arm_obj, 0.7 * plate.shape.high_mm[1])
            poses = poses @ self._T_sensor_flange
            self._executor.play(self.planner.path_to(poses[0], 50.0), 0.0, 0.2)
            self._executor.play(self.planner.path_of_scan(poses, PASS_S), 0.2, 1.0)
            return True
        return False

    def go_to_seat(self, seat: int, posture: int = 0) -> bool:
        """Puts the tip into the ``seat``-th seat about the reach; False when cancelled.

        A ``posture`` other than 0: with the elbow or the wrist turned over.
        """
        return self._enter_seat(f"seat {seat + 1}", seat_centre(self._arm, seat), posture)

    def go_to_bar(self, position: int, end: int, posture: int = 0) -> bool:
        """Puts the tip into an end (0 or 1) of the ball bar; False when cancelled."""
        return self._enter_seat("the bar", bar_end(self._arm, position, end), posture)

    def _enter_seat(self, name: str, centre_mm: Floats, posture: int) -> bool:
        with self._executor.move(f"going to {name}"):
            limits = self._arm.limits_rad
            start = (
                0.8 * self._rng.uniform(limits[:, 0], limits[:, 1])
                if posture
                else self.planner.current_joints()
            )
            into = path_into_seat(self._arm, centre_mm, start, self._rng, self.planner.pace)
            up = translation(0.0, 0.0, LIFT_MM) @ flange_pose(
                self._arm, self.planner.current_joints()
            )
            with suppress(UnreachableError):
                self._executor.play(self.planner.straight_path(up, LIFT_S), 0.0, 0.1)
            self._executor.play(self.planner.turn_joints(into.q_rad[0]), 0.1, 0.8)
            self._executor.play(into, 0.8, 1.0)
            self._last_contact = None
            return True
        return False

    def swing_in_seat(self) -> bool:
        """Swings the arm about the tip where it is; False when cancelled."""
        with self._executor.move("swinging the arm"):
            path = swing_path(
                self._arm, self.planner.current_joints(), self._rng, self._contact_sd_mm / 4
            )
            self._executor.play(self.planner.apply_pace(path), 0.0, 1.0)
            return True
        return False


def _depth(shape: CrenellatedBlock | Board, face: str) -> float:
    """How far (mm) a face lies below what is around it."""
    if isinstance(shape, CrenellatedBlock) and face == "floor":
        return shape.crest_z_mm - shape.floor_z_mm
    return 0.0
