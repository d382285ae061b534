"""Arms that hold a pose exactly: their readings are what such an arm reports."""

from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from crenel.formats.datasheets.arm import ArmFile, TipPart, arm_document
from crenel.metrology.adjustment.planning.inverse_kinematics import solve_inverse_kinematics
from crenel.metrology.arm.kinematics import Arm, Joint, Tip, flange_pose, geometric_jacobian
from crenel.metrology.arm.link_error import LinkError
from crenel.metrology.arm.reported_poses import pose_from_transform
from crenel.metrology.transforms import Floats, vector_from_rotation

TIP = TipPart(x_mm=2.0, y_mm=-12.0, z_mm=165.0, diameter_mm=6.0)
POLISH_STEPS = 6
POSTURE_RAD = np.radians([8.0, 20.0, 35.0, 5.0, 60.0, -10.0])
CHAIN = (  # a, alpha, d, theta: yaw, shoulder, elbow, and a wrist of three
    (0.0, -90.0, 320.0, 0.0),
    (560.0, 0.0, 0.0, -90.0),
    (32.0, -90.0, 0.0, 0.0),
    (0.0, 90.0, 540.0, 0.0),
    (0.0, -90.0, 0.0, 0.0),
    (0.0, 0.0, 82.0, 0.0),
)


class PoseArm:
    """Reports the pose itself."""

    joint_names: tuple[str, ...] | None = None

    def write(self, path: Path) -> None:
        """Writes ``arm.json``."""
        ArmFile(name="Arm", serial_number="A-1", convention="pose", tip=TIP).write(path)

    def reading(self, T_arm_flange: Floats) -> Floats | None:
        """The reading (7,) in a pose (4, 4)."""
        return pose_from_transform(T_arm_flange)


@dataclass
class JointArm:
    """Reports joint angles; one link of the true arm may differ from its datasheet."""

    link_mm: float = 0.0
    """Error of the second link, along its length."""

    def __post_init__(self) -> None:
        limits = (-np.pi, np.pi)
        joints = tuple(
            Joint(f"J{i + 1}", a, np.radians(alpha), d, np.radians(theta), limits_rad=limits)
            for i, (a, alpha, d, theta) in enumerate(CHAIN)
        )
        tip = Tip(TIP.x_mm, TIP.y_mm, TIP.z_mm, TIP.diameter_mm)
        self._nominal = Arm("Arm", "A-1", joints, tip)
        wrong = replace(joints[1], error=LinkError(x_mm=self.link_mm))
        self._true = replace(self._nominal, joints=(joints[0], wrong, *joints[2:]))
        self._last_rad: Floats = POSTURE_RAD
        self.joint_names: tuple[str, ...] | None = tuple(joint.name for joint in joints)

    def write(self, path: Path) -> None:
        """Writes ``arm.json`` by the datasheet."""
        arm_document(self._nominal).write(path)

    def reading(self, T_arm_flange: Floats) -> Floats | None:
        """Encoder angles (6,) at which the true arm is in a pose; None out of its reach."""
        for start in (self._last_rad, POSTURE_RAD):
            q = solve_inverse_kinematics(self._true, T_arm_flange, start)
            if q is not None:
                self._last_rad = _polish(self._true, T_arm_flange, q)
                return self._last_rad
        return None


def _polish(arm: Arm, T_arm_flange: Floats, q_rad: Floats) -> Floats:
    """The same angles to the last digits, by Newton's method."""
    q = q_rad
    for _ in range(POLISH_STEPS):
        T = flange_pose(arm, q)
        turn = vector_from_rotation(T_arm_flange[:3, :3] @ T[:3, :3].T)
        off = np.concatenate([T_arm_flange[:3, 3] - T[:3, 3], turn])
        q = q + np.linalg.lstsq(geometric_jacobian(arm, q, np.zeros(3)), off, rcond=None)[0]
    return np.asarray(q)
