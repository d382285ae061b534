"""The simulated operator's ways to a pose of the arm, at an operator's speed or faster, and the
way over the plate that shows a delay between arm and camera."""

import numpy as np

from crenel_hardware.clock import now_ns
from crenel_hardware.simulator.devices.kinematics import (
    ArmModel,
    Floats,
    UnreachableError,
    flange_pose,
    rotation_about,
    solve_joints,
    translation,
)
from crenel_hardware.simulator.devices.motion import (
    JointPath,
    Motion,
    min_jerk_progress,
    plan_approach,
    plan_path,
)
from crenel_hardware.simulator.operator.contact import contact_pose, outward_normal

OPERATOR_MM_S, OPERATOR_RAD_S = 260.0, 2.2
TRIES = 12
SWAY_RAD = 0.1
PASS_WAVES, PASS_WAVE_MM = 5.0, 6.0
PASS_S = 6.0
FASTEST_SCAN = 4.0
"""At any pace: faster, a camera's lines would lie too far apart."""
PASS_POSES = 121


class PathPlanner:
    """Plans ways from where one arm is.

    Args:
        pace: 1 is an operator's speed; 2 is twice as fast.
        contact_sd_mm: standard deviation of a contact.
    """

    def __init__(
        self,
        arm: ArmModel,
        motion: Motion,
        pace: float,
        contact_sd_mm: float,
        rng: np.random.Generator,
    ) -> None:
        self.pace = pace
        self._arm, self._motion = arm, motion
        self._contact_sd_mm, self._rng = contact_sd_mm, rng
        self._flange_x = flange_pose(arm, motion.at(now_ns()))[:3, 0]

    def current_joints(self) -> Floats:
        """(n,) joint angles of this moment."""
        return self._motion.at(now_ns())

    def gap_mm(self) -> float:
        """From the tip's centre to what it touches, with the error of this contact."""
        return self._arm.tip_diameter_mm / 2 + float(self._rng.normal(0.0, self._contact_sd_mm))

    def apply_pace(self, path: JointPath) -> JointPath:
        """An operator's path at this pace."""
        return JointPath(path.times_s / self.pace, path.q_rad)

    def path_through(self, poses: Floats, seconds: float) -> JointPath:
        """Through flange poses (K, 4, 4), in an operator's seconds."""
        return plan_path(self._arm, poses, self.current_joints(), seconds / self.pace)

    def path_of_scan(self, poses: Floats, seconds: float) -> JointPath:
        """As ``path_through``, at most at ``FASTEST_SCAN``."""
        return self.path_through(poses, seconds * max(1.0, self.pace / FASTEST_SCAN))

    def path_to_contact(
        self, T_arm_obj: Floats, face: str, spot: Floats, clear: Floats, left: str | None
    ) -> tuple[JointPath, Floats]:
        """The way to a place in front of the contact, and the flange's pose in contact.

        Args:
            spot: of the face, in the frame of ``T_arm_obj``.
            clear: from the contact to the place in front of it, arm frame.
            left: the face touched before.
        """
        q, tip = self.current_joints(), np.array(self._arm.tip_mm)
        up = T_arm_obj[:3, 2]
        if left == face:
            lifts = (0.3 * clear, 0.3 * clear)
        else:
            leave = np.zeros(3)
            if left is not None:
                leave = 20.0 * (T_arm_obj[:3, :3] @ outward_normal(left))
            lifts = (30.0 * up + leave, 30.0 * up + 5.0 * clear)
        gap = self.gap_mm()
        best: tuple[JointPath, Floats] | None = None
        for _ in range(TRIES):
            contact = contact_pose(
                self._arm, T_arm_obj, face, spot, gap, self._rng, self._flange_x, SWAY_RAD
            )
            before = translation(*clear.tolist()) @ contact
            wanted_s = self._duration_s(q, before, tip)
            try:
                path = plan_approach(self._arm, q, before, tip, lifts, wanted_s)
                plan_path(self._arm, np.stack([before, contact]), path.q_rad[-1], 1.0)
            except UnreachableError:
                continue
            if best is None or path.duration_s < best[0].duration_s:
                best = path, contact
            if path.duration_s < 1.2 * wanted_s:
                break
        return best or (self._detour(q, before), contact)

    def path_to(self, target: Floats, lift_mm: float) -> JointPath:
        """To a flange pose (4, 4), in a curve that is drawn up by so much."""
        q, tip = self.current_joints(), np.array(self._arm.tip_mm)
        up = np.array([0.0, 0.0, lift_mm])
        try:
            return plan_approach(
                self._arm, q, target, tip, (up, up), self._duration_s(q, target, tip)
            )
        except UnreachableError:
            return self._detour(q, target)

    def turn_joints(self, goal: Floats) -> JointPath:
        """Straight in the joints from where they are."""
        q = self.current_joints()
        share = min_jerk_progress(np.linspace(0.0, 1.0, 24))[:, None]
        seconds = 2.0 * float(np.max(np.abs(goal - q))) / OPERATOR_RAD_S / self.pace
        return JointPath(np.linspace(0.0, max(seconds, 0.3), 24), q + share * (goal - q))

    def straight_path(self, target: Floats, seconds: float) -> JointPath:
        """To a flange pose (4, 4) near by, in an operator's seconds."""
        q = self.current_joints()
        zero = np.zeros(3)
        tip = np.array(self._arm.tip_mm)
        return plan_approach(self._arm, q, target, tip, (zero, zero), seconds / self.pace)

    def _detour(self, q: Floats, target: Floats) -> JointPath:
        """Straight in the joints, where the arm cannot follow a straight way in space."""
        return self.turn_joints(solve_joints(self._arm, target, q, self._rng))

    def _duration_s(self, q: Floats, target: Floats, tool: Floats) -> float:
        """How long the simulated operator takes from here to a flange pose."""
        start = flange_pose(self._arm, q)
        way = target[:3, :3] @ tool + target[:3, 3] - start[:3, :3] @ tool - start[:3, 3]
        turn = start[:3, :3].T @ target[:3, :3]
        angle = float(np.arccos(np.clip((np.trace(turn) - 1) / 2, -1.0, 1.0)))
        seconds = 0.08 + float(np.linalg.norm(way)) / OPERATOR_MM_S + 0.4 * angle / OPERATOR_RAD_S
        return max(seconds, 0.16) / self.pace


def passing_poses(T_arm_plate: Floats, half_y_mm: float) -> Floats:
    """Sensor poses (K, 4, 4), arm frame, even in time: over the plate and back again, in waves
    nearer and away, as evenly as an operator does it."""
    poses = []
    for s in np.linspace(0.0, 1.0, PASS_POSES):
        y = -half_y_mm * np.cos(2 * np.pi * s)
        z = PASS_WAVE_MM * np.sin(2 * np.pi * PASS_WAVES * s) * np.sin(np.pi * s) ** 0.5
        lean = rotation_about("x", 0.05 * np.sin(6.0 * s)) @ rotation_about("y", 0.04 * s)
        poses.append(T_arm_plate @ translation(0.0, float(y), float(z)) @ lean)
    return np.stack(poses)
