"""The arm's kinematics: standard Denavit-Hartenberg (Eq. 1-2) with error matrices (Eq. 3)."""

from dataclasses import dataclass, field

import numpy as np

from crenel.errors import OperationError
from crenel.messages.message import Text, message
from crenel.metrology.arm.link_error import LinkError, error_transform
from crenel.metrology.arm.reported_poses import POSE_SIZE, ReadingKind, transforms_from_poses
from crenel.metrology.transforms import Floats


@dataclass(frozen=True)
class Joint:
    """One rotary joint and its link, ``A = Rz(sign q + theta) Tz(d) Tx(a) Rx(alpha)`` (Eq. 2)."""

    name: str
    a_mm: float
    alpha_rad: float
    d_mm: float
    theta_rad: float
    sign: int = 1
    limits_rad: tuple[float, float] = (-np.pi, np.pi)
    encoder_sd_rad: float = 0.0
    error: LinkError = field(default_factory=LinkError)


@dataclass(frozen=True)
class Tip:
    """The touch probe's sphere: its centre in the flange frame, and its diameter."""

    x_mm: float
    y_mm: float
    z_mm: float
    diameter_mm: float

    @property
    def centre_mm(self) -> Floats:
        """(3,) centre of the sphere in the flange frame."""
        return np.array([self.x_mm, self.y_mm, self.z_mm])

    @property
    def radius_mm(self) -> float:
        return self.diameter_mm / 2


@dataclass(frozen=True)
class Arm:
    """An articulated arm of five to seven rotary joints with a touch probe."""

    name: str
    serial_number: str
    joints: tuple[Joint, ...]
    tip: Tip
    base: LinkError = field(default_factory=LinkError)
    """Constant transform from the frame of the first joint to the arm frame."""
    frames_moved_mm: float = 0.0
    """How far away link frames lay in the datasheet, if they were moved near the arm; else 0."""

    @property
    def joint_count(self) -> int:
        return len(self.joints)

    @property
    def reading_kind(self) -> ReadingKind:
        """What it reports."""
        return "joints"

    @property
    def reading_size(self) -> int:
        """Numbers of one reading: the encoder angles in rad, before sign and offset."""
        return len(self.joints)

    @property
    def encoder_sd_rad(self) -> Floats:
        """(n,) standard deviation of each joint's encoder."""
        return np.array([joint.encoder_sd_rad for joint in self.joints])


@dataclass(frozen=True)
class RobotArm:
    """A robot whose controller reports the flange pose instead of joint angles."""

    name: str
    serial_number: str
    tip: Tip | None = None
    """The tip, if one is mounted for probing."""
    rotation: str = ""
    """How its tables write rotations: a name of ``CONVENTIONS``; empty for quaternions."""

    @property
    def reading_kind(self) -> ReadingKind:
        """What it reports."""
        return "pose"

    @property
    def reading_size(self) -> int:
        """Numbers of one reading, as in ``reported_poses``."""
        return POSE_SIZE


AnyArm = Arm | RobotArm
"""Its readings are (N, ``reading_size``) numbers."""


def refuse_other_angles(arm: Arm, q_rad: Floats, name: Text) -> None:
    """Raises ``OperationError`` where angles cannot be this arm's: ``name`` says of what."""
    if q_rad.ndim != 2 or q_rad.shape[1] != arm.joint_count:
        raise OperationError(
            "joint-count",
            message("joint-angles", name=name, count=q_rad.shape[-1]),
            message("arm-has-joints", arm=arm.name, count=arm.joint_count),
            message("check-session-taken-arm"),
        )
    if not np.isfinite(q_rad).all():
        raise OperationError("angles-not-finite", message("joint-angle-not-a-number", name=name))


def link_transforms(arm: Arm, q_rad: Floats) -> Floats:
    """``A_i E_i`` of every joint: Denavit-Hartenberg link and error transform.

    Args:
        q_rad: (N, n) encoder angles, before sign and offset.

    Returns:
        (n, N, 4, 4); element i maps frame i+1 to frame i. The first contains the base transform.

    Source:
        Eq. 2 and 3 of the article.
    """
    q = np.asarray(q_rad, dtype=np.float64)
    sign, theta, alpha, a, d = _link_parameters(arm)
    angle = sign * q.T + theta
    c, s = np.cos(angle), np.sin(angle)
    ca, sa = np.cos(alpha), np.sin(alpha)
    links = A = np.zeros((arm.joint_count, len(q), 4, 4))
    A[..., 0, 0], A[..., 0, 1], A[..., 0, 2], A[..., 0, 3] = c, -s * ca, s * sa, a * c
    A[..., 1, 0], A[..., 1, 1], A[..., 1, 2], A[..., 1, 3] = s, c * ca, -c * sa, a * s
    A[..., 2, 1], A[..., 2, 2], A[..., 2, 3] = sa, ca, d
    A[..., 3, 3] = 1.0
    for link, joint in zip(links, arm.joints, strict=True):
        if joint.error != LinkError():
            link[:] = link @ error_transform(joint.error)
    if arm.base != LinkError():
        links[0] = error_transform(arm.base) @ links[0]
    return links


def _link_parameters(arm: Arm) -> Floats:
    """Signs, theta and alpha (rad), a and d (mm) of the joints: (5, n, 1)."""
    rows = [(one.sign, one.theta_rad, one.alpha_rad, one.a_mm, one.d_mm) for one in arm.joints]
    return np.array(rows, dtype=np.float64).T[..., None]


def flange_poses(arm: AnyArm, readings: Floats) -> Floats:
    """``T_arm_flange`` of many poses at once.

    Args:
        readings: (N, n) encoder angles in rad, before sign and offset; of a ``RobotArm``, (N, 7)
            reported poses.

    Returns:
        (N, 4, 4).

    Source:
        Eq. 1 of the article, with the error transforms of Eq. 3.
    """
    if isinstance(arm, RobotArm):
        return transforms_from_poses(readings)
    links = link_transforms(arm, readings)
    T = links[0]
    for link in links[1:]:
        T = T @ link
    return np.asarray(T)


def flange_pose(arm: AnyArm, reading: Floats) -> Floats:
    """``T_arm_flange`` of one pose.

    Args:
        reading: (n,) encoder angles in rad, before sign and offset; of a ``RobotArm``, a reported
            pose (7,).

    Returns:
        (4, 4).

    Source:
        Eq. 1 of the article, with the error transforms of Eq. 3.

    Example:
        >>> joints = tuple(Joint(f"J{i}", 100.0, 0.0, 0.0, 0.0) for i in range(6))
        >>> arm = Arm("planar", "1", joints, Tip(0.0, 0.0, 50.0, 6.0))
        >>> flange_pose(arm, np.zeros(6))[:3, 3].tolist()
        [600.0, 0.0, 0.0]
    """
    return np.asarray(flange_poses(arm, np.asarray(reading, dtype=np.float64)[None])[0])


def tip_centres(arm: AnyArm, readings: Floats) -> Floats:
    """Centres of the tip's sphere in the arm frame.

    Args:
        readings: as of ``flange_poses``.

    Returns:
        (N, 3) mm. A contact point lies one tip radius off its centre, along the surface normal.

    Raises:
        OperationError: a robot without a tip.

    Source:
        Eq. 1 of the article, with the error transforms of Eq. 3.

    Example:
        >>> joints = tuple(Joint(f"J{i}", 100.0, 0.0, 0.0, 0.0) for i in range(6))
        >>> arm = Arm("planar", "1", joints, Tip(0.0, 0.0, 50.0, 6.0))
        >>> tip_centres(arm, np.zeros((1, 6))).tolist()
        [[600.0, 0.0, 50.0]]
    """
    T = flange_poses(arm, readings)
    return np.asarray(T[:, :3, :3] @ tip_of(arm).centre_mm + T[:, :3, 3])


def tip_of(arm: AnyArm) -> Tip:
    """The arm's tip; raises ``OperationError`` for a robot without one."""
    if arm.tip is None:
        raise OperationError(
            "tip-missing",
            message("arm-has-no-tip", name=arm.name),
            message("contacts-tips-sphere"),
            message("give-tip-or-leave-out-probing"),
        )
    return arm.tip


def geometric_jacobian(arm: Arm, q_rad: Floats, point_flange_mm: Floats) -> Floats:
    """Derivatives of a flange-fixed point and its orientation by the joints.

    Args:
        q_rad: (n,) encoder angles, before sign and offset.
        point_flange_mm: (3,) the point, in the flange frame.

    Returns:
        (6, n) in the arm frame, per unit rate of each encoder: rows 0-2 the velocity of the
        point in mm/rad, rows 3-5 the angular velocity in rad/rad.
    """
    one = np.asarray(q_rad, dtype=np.float64)[None]
    return np.asarray(geometric_jacobians(arm, one, point_flange_mm)[0])


def geometric_jacobians(arm: Arm, q_rad: Floats, point_flange_mm: Floats) -> Floats:
    """``geometric_jacobian`` of many poses at once.

    Args:
        q_rad: (N, n) encoder angles, before sign and offset.
        point_flange_mm: (3,) the point, in the flange frame.

    Returns:
        (N, 6, n), rows as in ``geometric_jacobian``.
    """
    return points_with_jacobians(arm, q_rad, point_flange_mm)[1]


def points_with_jacobians(
    arm: Arm, q_rad: Floats, point_flange_mm: Floats
) -> tuple[Floats, Floats]:
    """The point in the arm frame, and its derivatives by the joints.

    Args, rows and frame are those of ``geometric_jacobians``.

    Returns:
        (N, 3) mm, and (N, 6, n).
    """
    links = link_transforms(arm, q_rad)
    # the frame whose z axis each joint turns about
    frames = np.empty_like(links)
    frames[0] = error_transform(arm.base)
    flange = links[0]
    for frame, link in zip(frames[1:], links[1:], strict=True):
        frame[:] = flange
        flange = flange @ link
    point = flange[:, :3, :3] @ np.asarray(point_flange_mm) + flange[:, :3, 3]
    jacobians = np.empty((len(point), 6, arm.joint_count))
    for i, joint in enumerate(arm.joints):
        axis, lever = joint.sign * frames[i, :, :3, 2].T, (point - frames[i, :, :3, 3]).T
        for row, (j, k) in enumerate(((1, 2), (2, 0), (0, 1))):
            jacobians[:, row, i] = axis[j] * lever[k] - axis[k] * lever[j]
        jacobians[:, 3:, i] = axis.T
    return point, jacobians


def tip_covariances(arm: AnyArm, readings: Floats) -> Floats:
    """Covariance of the tip centre due to the noise of the encoders, arm frame.

    Args:
        readings: as of ``flange_poses``.

    Returns:
        (N, 3, 3) mm², k = 1; zero if the arm's datasheet states no encoder noise, and of a robot.

    Example:
        >>> joints = tuple(Joint("J", 100.0, 0.0, 0.0, 0.0, encoder_sd_rad=1e-5) for _ in range(6))
        >>> arm = Arm("planar", "1", joints, Tip(0.0, 0.0, 50.0, 6.0))
        >>> np.sqrt(tip_covariances(arm, np.zeros((1, 6)))[0].diagonal()).round(4).tolist()
        [0.0, 0.0095, 0.0]
    """
    if isinstance(arm, RobotArm):
        return np.zeros((len(readings), 3, 3))
    return tips_with_covariances(arm, np.asarray(readings, dtype=np.float64))[1]


def tips_with_covariances(arm: Arm, q_rad: Floats) -> tuple[Floats, Floats]:
    """``tip_centres`` and ``tip_covariances`` in one walk along the arm.

    Args:
        q_rad: (N, n) encoder angles, before sign and offset.

    Returns:
        (N, 3) mm, and (N, 3, 3) mm², k = 1.
    """
    tips, jacobians = points_with_jacobians(arm, q_rad, arm.tip.centre_mm)
    J = jacobians[:, :3]
    return tips, np.asarray(J @ np.diag(arm.encoder_sd_rad**2) @ np.swapaxes(J, 1, 2))
