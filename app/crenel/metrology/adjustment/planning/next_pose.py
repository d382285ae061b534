"""The pose to take next: the one that reduces the uncertainty of a scanned point most.

The picture of every candidate is predicted (``predicted_view``), and its part added to the normal
matrix of the adjustment so far: predicting the remaining uncertainty needs no picture.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from crenel.messages.message import Text, join, message, quantity
from crenel.metrology.adjustment.block.predicted_view import (
    ObservationNoise,
    predict_view,
    visible_share,
)
from crenel.metrology.adjustment.board.observations import BoardView
from crenel.metrology.adjustment.board.predicted_view import is_fully_visible, predict_board_view
from crenel.metrology.adjustment.core.arm_errors import FlangeMotion, arm_motion
from crenel.metrology.adjustment.core.gauss_newton import AdjustmentResult, free_covariance
from crenel.metrology.adjustment.core.parameters import SENSOR, pose_scene
from crenel.metrology.adjustment.core.robot_noise import robot_motion_at
from crenel.metrology.adjustment.core.robust_weights import RobustWeights, normal_equations
from crenel.metrology.adjustment.core.uncertainty import measuring_volume, sensor_jacobian
from crenel.metrology.adjustment.planning.inverse_kinematics import (
    nearest_joints,
    solve_inverse_kinematics,
)
from crenel.metrology.arm.kinematics import AnyArm, Arm, RobotArm, flange_pose
from crenel.metrology.arm.reported_poses import pose_from_transform
from crenel.metrology.calibration.observation_model import Rows
from crenel.metrology.sensor.camera import Camera
from crenel.metrology.sensor.laser_plane import LaserPlane, in_frame
from crenel.metrology.targets.crenellated_block import Crenellated
from crenel.metrology.targets.target import CalibrationTarget, PixelSegment, outline, target_centre
from crenel.metrology.transforms import (
    Floats,
    inverse,
    rigid,
    rotation_from_vector,
    vector_from_rotation,
)

# Tilts, rotations about the view and heights that an operator can hold easily.
TILTS_DEG = (-20.0, 0.0, 20.0)
TURNS_DEG = (-30.0, 0.0, 30.0)
HEIGHTS_MM = (-8.0, 0.0, 8.0)
# Minimum share of a block in the picture, and minimum number of stripe points on each level.
FRAMED, STRIPE_POINTS = 0.85, 40
# Number of points merged into one when a picture is predicted.
BIN_SIZE = 4
# Number of joints with which an arm can hold the sensor at any pose.
FREEDOMS = 6
# Smaller changes are not mentioned.
WORD_DEG, WORD_MM = 4.0, 3.0


RowsOf = Callable[[Camera, LaserPlane, Floats], tuple[Rows, Rows]]


@dataclass(frozen=True)
class PoseDelta:
    """How the sensor is held relative to another hold, in terms for an operator.

    ``tilt_right_deg``: the camera swings to the right about the object; ``tilt_back_deg``:
    to its back; ``turn_deg``: counter-clockwise as seen from above; ``higher_mm``: further
    from the object.
    """

    tilt_right_deg: float
    tilt_back_deg: float
    turn_deg: float
    higher_mm: float

    @property
    def largest_deg(self) -> float:
        """The largest of the three rotations."""
        return max(abs(self.tilt_right_deg), abs(self.tilt_back_deg), abs(self.turn_deg))

    @property
    def words(self) -> Text:
        """``tilt left 20°, 8 mm higher``; ``keep this pose`` if nothing changes."""
        right, back, turn = (
            quantity(abs(angle), "°")
            for angle in (self.tilt_right_deg, self.tilt_back_deg, self.turn_deg)
        )
        moves = []
        if abs(self.tilt_right_deg) >= WORD_DEG:
            to_right = self.tilt_right_deg > 0
            moves.append(
                message("tilt-right-by", angle=right)
                if to_right
                else message("tilt-left-by", angle=right)
            )
        if abs(self.tilt_back_deg) >= WORD_DEG:
            to_back = self.tilt_back_deg > 0
            moves.append(
                message("tilt-back-by", angle=back)
                if to_back
                else message("tilt-front-by", angle=back)
            )
        if abs(self.turn_deg) >= WORD_DEG:
            anticlockwise = self.turn_deg > 0
            moves.append(
                message("turn-anticlockwise-by", angle=turn)
                if anticlockwise
                else message("turn-clockwise-by", angle=turn)
            )
        if abs(self.higher_mm) >= WORD_MM:
            distance = quantity(abs(self.higher_mm), "mm")
            moves.append(
                message("higher-by", distance=distance)
                if self.higher_mm > 0
                else message("lower-by", distance=distance)
            )
        return join(moves) if moves else message("keep-this-pose")


@dataclass(frozen=True)
class PoseAdvice:
    """A suggested pose: its position, its benefit, and the view of the object from it."""

    T_obj_cam: Floats  # (4, 4)
    reading: Floats  # (k,) of the arm in this pose: joint angles that reach it, or the pose
    total_um: float  # of a point, k = 1, after this pose
    outline_px: tuple[PixelSegment, ...]
    """The object's edges as the picture would show them, end to end."""


def next_poses(
    found: AdjustmentResult,
    arm: AnyArm,
    item: CalibrationTarget,
    readings: Floats,
    seeing: ObservationNoise | None = None,
) -> list[PoseAdvice]:
    """Poses that the arm can take, the most helpful first.

    The image of every candidate is predicted and its part added to the normal matrix of the
    adjustment so far, so that the uncertainty that it would leave needs no image.

    Args:
        found: the adjustment of the P poses so far.
        arm: the candidates keep its joint limits; those of a robot are unknown.
        item: the target.
        readings: (P, n) encoder angles of the poses so far; of a robot, (P, 4, 4) poses.
        seeing: noise of the predicted images; None: the usual one.

    Returns:
        Advice with the standard uncertainty of a point after each pose, k = 1, µm.
    """
    seeing = seeing or ObservationNoise(bin_size=BIN_SIZE)
    reference = pose_scene(found.state, found.problem, found.layout, 0)
    T_cam_obj = rigid(reference.camera.rotation, reference.camera.translation_mm)
    volume = sensor_jacobian(found.state, measuring_volume(found).uv_px)
    by_sizes = found.link_size_covariance[SENSOR, SENSOR]
    advice = []
    for hold in _candidates(inverse(T_cam_obj), item):
        T_obj_cam = _nearest_hold(found, arm, hold, readings)
        rows_of = _predict_rows(found, item, T_obj_cam, seeing)
        reached = _reach(found, arm, T_obj_cam, readings) if rows_of is not None else None
        if rows_of is None or reached is None:
            continue
        reading, moves = reached
        # one more pose says little about the size of the link errors
        covariance = _covariance_after(found, moves, rows_of) + by_sizes
        total = float(np.sqrt(np.mean(np.einsum("gik,kl,gil->g", volume, covariance, volume))))
        camera, _ = place_sensor(found, T_obj_cam)
        advice.append(PoseAdvice(T_obj_cam, reading, 1e3 * total, outline(camera, item)))
    return sorted(advice, key=lambda one: one.total_um)


def _predict_rows(
    found: AdjustmentResult, item: CalibrationTarget, T_obj_cam: Floats, seeing: ObservationNoise
) -> RowsOf | None:
    """Noise of the picture from a hold; None if the picture would be unusable."""
    camera, plane = place_sensor(found, T_obj_cam)
    if isinstance(item, Crenellated):
        if visible_share(camera, item) < FRAMED:
            return None
        block = predict_view(camera, plane, item, seeing)
        on_each = (int(np.sum(block.level == name)) for name in ("crest", "floor"))
        return block.rows if min(on_each) * seeing.bin_size >= STRIPE_POINTS else None
    like = found.problem.views[0]
    assert isinstance(like, BoardView)
    if not is_fully_visible(camera, item):
        return None
    board = predict_board_view(camera, plane, like, seeing)
    if not found.problem.has_lines:
        return board.without_line().rows
    return board.rows if len(board.stripe.u) * seeing.bin_size >= STRIPE_POINTS else None


def pose_delta(T_obj_cam: Floats, T_obj_cam_before: Floats, item: CalibrationTarget) -> PoseDelta:
    """How one hold of the camera over the target differs from another.

    Args:
        T_obj_cam, T_obj_cam_before: (4, 4).
        item: the target, whose front, right and up the directions refer to.

    Returns:
        Turns in degrees and the change of height in mm.
    """
    turned = vector_from_rotation(T_obj_cam[:3, :3] @ T_obj_cam_before[:3, :3].T)
    x, y, z = np.degrees(_sides(item, T_obj_cam_before).T @ turned)
    middle = target_centre(item)
    apart = [float(np.linalg.norm(T[:3, 3] - middle)) for T in (T_obj_cam, T_obj_cam_before)]
    # a turn about +y swings what is above to the right, about -x to the back
    return PoseDelta(float(y), float(-x), float(z), apart[0] - apart[1])


def _sides(item: CalibrationTarget, T_obj_cam: Floats) -> Floats:
    """(3, 3) the operator's right, back and up, as columns in the object frame.

    A block has a front; a board may lie in any orientation, so right is right in the picture.
    """
    if isinstance(item, Crenellated):
        return np.eye(3)
    right = np.array([*T_obj_cam[:2, 0], 0.0])
    right /= np.linalg.norm(right)
    return np.column_stack([right, [-right[1], right[0], 0.0], [0.0, 0.0, 1.0]])


def place_sensor(found: AdjustmentResult, T_obj_cam: Floats) -> tuple[Camera, LaserPlane]:
    """Camera and plane in the object frame for the camera in a given pose."""
    return in_frame(found.state.camera, found.state.plane, T_obj_cam)


def _candidates(T_obj_cam: Floats, item: CalibrationTarget) -> Sequence[Floats]:
    """Holds rotated about the middle of the object, relative to a first one."""
    middle, sides = target_centre(item), _sides(item, T_obj_cam)
    away = T_obj_cam[:3, 3] - middle
    away /= np.linalg.norm(away)
    holds = []
    for right in TILTS_DEG:
        for back in TILTS_DEG:
            for turn in TURNS_DEG:
                swing = rotation_from_vector(sides @ np.radians([-back, right, turn]))
                about_middle = rigid(swing, middle - swing @ middle)
                for higher in HEIGHTS_MM if turn == 0.0 else (0.0,):
                    lift = rigid(np.eye(3), higher * away)
                    holds.append(about_middle @ lift @ T_obj_cam)
    return holds


def _reach(
    found: AdjustmentResult, arm: AnyArm, T_obj_cam: Floats, readings: Floats
) -> tuple[Floats, FlangeMotion] | None:
    """The arm's reading (k,) in a hold, and its motion there; None out of its reach."""
    T_arm_flange = found.state.T_arm_obj @ T_obj_cam @ inverse(found.state.T_flange_cam)
    if isinstance(arm, RobotArm):
        moves = robot_motion_at(found.problem.motion, T_arm_flange[None])
        return pose_from_transform(T_arm_flange), moves
    q_rad = _joints(found, arm, T_arm_flange, readings)
    return None if q_rad is None else (q_rad, arm_motion(arm, q_rad[None]))


def _nearest_hold(
    found: AdjustmentResult, arm: AnyArm, T_obj_cam: Floats, readings: Floats
) -> Floats:
    """The hold itself; of an arm with fewer than six joints, the nearest one that it can take."""
    if isinstance(arm, RobotArm) or arm.joint_count >= FREEDOMS:
        return T_obj_cam
    T_obj_flange = T_obj_cam @ inverse(found.state.T_flange_cam)
    T_arm_flange = found.state.T_arm_obj @ T_obj_flange
    q = nearest_joints(arm, T_arm_flange, readings[_nearest_pose(found, T_arm_flange)])
    return inverse(found.state.T_arm_obj) @ flange_pose(arm, q) @ found.state.T_flange_cam


def _nearest_pose(found: AdjustmentResult, T_arm_flange: Floats) -> int:
    """Which of the poses so far has its flange nearest to another."""
    apart = found.problem.motion.T_arm_flange[:, :3, 3] - T_arm_flange[:3, 3]
    return int(np.argmin(np.linalg.norm(apart, axis=1)))


def _joints(
    found: AdjustmentResult, arm: Arm, T_arm_flange: Floats, q_rad: Floats
) -> Floats | None:
    """Joint angles for a pose of the flange, starting from the pose with the nearest flange."""
    return solve_inverse_kinematics(arm, T_arm_flange, q_rad[_nearest_pose(found, T_arm_flange)])


def _covariance_after(found: AdjustmentResult, moves: FlangeMotion, rows_of: RowsOf) -> Floats:
    """Covariance (17, 17) of the sensor's unknowns with one more pose."""
    problem, state, at = found.problem, found.state, found.layout
    motion = problem.motion
    more = replace(
        problem,
        numbers=(*problem.numbers, -1),
        views=(*problem.views, problem.views[0]),
        motion=replace(
            motion,
            T_arm_flange=np.concatenate([motion.T_arm_flange, moves.T_arm_flange]),
            by_links=np.concatenate([motion.by_links, moves.by_links]),
            by_noise=np.concatenate([motion.by_noise, moves.by_noise]),
        ),
    )
    own = at.noise_per_pose
    wider = replace(at, noise=slice(at.noise.start, at.count + own), count=at.count + own)
    new = len(problem.views)
    moved = replace(state, noise=np.vstack([state.noise, np.zeros(own)]))
    scene = pose_scene(moved, more, wider, new)
    N = np.zeros((wider.count, wider.count))
    N[: at.count, : at.count] = np.sum(list(found.parts.values()), axis=0)
    index = np.arange(wider.count)[wider.noise_slice(new)]
    N[index, index] += (found.scales.noise * motion.noise_sd) ** -2.0
    for rows in rows_of(scene.camera, scene.plane, state.coordinates):
        everything = RobustWeights(np.ones(len(rows.sigma), np.bool_), np.ones(len(rows.sigma)))
        local, _ = normal_equations(rows, everything)
        N += scene.by_unknowns.T @ local @ scene.by_unknowns
    free = np.concatenate([found.free, np.ones(own, np.bool_)])
    return free_covariance(N, free)[SENSOR, SENSOR]
