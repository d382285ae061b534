"""The accuracy that calibrations of a sensor on a block will have, before either exists.

Contact points and pictures are predicted without noise, and the noise that they would have is
propagated through the same adjustment that calibrates (the Cramér-Rao bound): many simulated
calibrations would scatter by as much.
"""

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass, replace

import numpy as np

from app.errors import OperationError
from app.messages.message import message
from app.metrology.adjustment.block.observations import block_contacts, block_prior
from app.metrology.adjustment.block.predicted_view import ObservationNoise, predict_view
from app.metrology.adjustment.core.arm_errors import arm_motion
from app.metrology.adjustment.core.gauss_newton import AdjustmentResult
from app.metrology.adjustment.core.information import information_at
from app.metrology.adjustment.core.observations import AdjustmentProblem
from app.metrology.adjustment.core.parameters import AdjustmentState
from app.metrology.adjustment.core.uncertainty import point_budget, sensor_jacobian
from app.metrology.adjustment.core.variance_components import Scales
from app.metrology.arm.kinematics import Arm
from app.metrology.calibration.uncertainty_budget import BudgetContribution
from app.metrology.design.expected_contacts import contact_flanges, contact_places
from app.metrology.design.stripe_sensor import (
    StripeSensor,
    middle_height_mm,
    nominal_camera,
    nominal_plane,
    range_points,
)
from app.metrology.design.usual_arm import PostureFinder, table_places
from app.metrology.sensor.camera import Camera, project
from app.metrology.sensor.laser_plane import LaserPlane, in_frame
from app.metrology.targets.crenellated_block import Crenellated
from app.metrology.transforms import Floats, inverse, rigid, rotation_from_vector

BIN_SIZE = 4
"""Points merged into one when a picture is predicted."""
USUAL = Scales(links_rad=7.5e-6, links_mm=0.003, noise=1.0, touch_mm=0.005)
"""Errors of an arm's links, as of one whose tip is off by some 20 µm rms, and scatter of a
contact."""
BEHIND_MM = 90.0
"""The sensor's camera and laser sit so far below the flange."""
ASIDE_MM = 57.0
"""The sensor sits beside the stylus."""
TILTS_DEG = (
    (0.0, 0.0, 0.0),
    (15.0, 0.0, 20.0),
    (-15.0, 0.0, -20.0),
    (0.0, 15.0, 25.0),
    (0.0, -15.0, -25.0),
    (10.0, 12.0, -10.0),
    (-10.0, 12.0, 10.0),
    (0.0, -8.0, 0.0),
)
"""Rotations of the sensor about X, Y and Z of the block in each pose, as the station advises."""
POSES = len(TILTS_DEG)


@dataclass(frozen=True)
class ExpectedAccuracy:
    """Standard uncertainty of a point of the measuring range, rms over it, by source; k = 1."""

    poses: int
    total_um: float
    rows: tuple[BudgetContribution, ...]


@dataclass(frozen=True)
class ExpectedSession:
    """A session that somebody could take: how the arm stands, without noise."""

    sensor: StripeSensor
    arm: Arm
    block: Crenellated
    T_arm_obj: Floats
    features: tuple[str, ...]
    contact_q_rad: Floats  # (N, n)
    q_rad: Floats  # (P, n)

    def with_block(self, block: Crenellated) -> "ExpectedSession":
        """Much the same session with another block, whose middle is where that of this one is.

        The contact points stay where they are, which is near enough to compare blocks.
        """
        up = np.eye(4)
        up[2, 3] = middle_height_mm(self.block) - middle_height_mm(block)
        return replace(self, block=block, T_arm_obj=self.T_arm_obj @ up)

    def with_uncertainty(self, standard_uncertainty_mm: float) -> "ExpectedSession":
        """The same session with a block whose sizes are known otherwise."""
        block = replace(self.block, standard_uncertainty_mm=standard_uncertainty_mm)
        return replace(self, block=block)


def plan_session(sensor: StripeSensor, block: Crenellated, arm: Arm) -> ExpectedSession:
    """Contact points and poses that the arm reaches, with the block on a table.

    Raises:
        OperationError: ``arm-cannot-reach``.
    """
    for T_arm_obj in table_places():
        with suppress(OperationError):
            return _plan_at(sensor, block, arm, T_arm_obj)
    raise OperationError(
        "arm-cannot-reach",
        message("arm-reaches-no-place-for-block", arm=arm.name),
        "",
        message("check-arms-file-lengths-angles-signs"),
    )


def _plan_at(
    sensor: StripeSensor, block: Crenellated, arm: Arm, T_arm_obj: Floats
) -> ExpectedSession:
    touching, looking = PostureFinder(arm), PostureFinder(arm)
    features, spots = contact_places(block, arm.tip.radius_mm)
    flanges = contact_flanges(arm, T_arm_obj, block, features, spots)
    contact_q = np.array([touching.joints_rad(T) for T in flanges])
    T_sensor_flange = inverse(nominal_mounting(sensor))
    poses = [T_arm_obj @ T @ T_sensor_flange for T in sensor_holds(block)]
    # the arm may stand in another posture than while it touched: errors of its links cancel less
    looking.stand_otherwise(poses[0], contact_q[0])
    q = np.array([looking.joints_rad(T) for T in poses])
    return ExpectedSession(sensor, arm, block, T_arm_obj, tuple(features), contact_q, q)


def nominal_mounting(sensor: StripeSensor) -> Floats:
    """``T_flange_sensor`` (4, 4): the sensor beside the stylus, looking along it."""
    turned = np.diag([1.0, -1.0, -1.0])
    return rigid(turned, np.array([0.0, -ASIDE_MM, BEHIND_MM + sensor.standoff_mm]))


def sensor_holds(block: Crenellated) -> list[Floats]:
    """``T_obj_sensor`` (4, 4) of each pose, the sensor's origin in the middle of the grooves."""
    middle = np.array([0.0, 0.0, middle_height_mm(block)])
    return [rigid(rotation_from_vector(np.radians(turn)), middle) for turn in TILTS_DEG]


def predict_accuracy(
    session: ExpectedSession, poses: int, scales: Scales = USUAL
) -> ExpectedAccuracy:
    """What a calibration from the first poses of a session would be good for.

    Args:
        session: from ``plan_session``.
        poses: how many of its poses are taken, 1 to ``POSES``.
        scales: noise of arm and contacts.

    Returns:
        Standard uncertainty of a point over the sensor's measuring range, flange frame, k = 1.

    Raises:
        OperationError: ``adjustment-failed``, where the block does not determine the sensor.
    """
    found = _information(session, poses, scales)
    points = range_points(session.sensor)
    J = sensor_jacobian(found.state, project(nominal_camera(session.sensor), points))
    rows, total_um = point_budget(found, J)
    return ExpectedAccuracy(poses, total_um, rows)


def _information(session: ExpectedSession, poses: int, scales: Scales) -> AdjustmentResult:
    """The adjustment at the truth, with the information of everything that would be measured."""
    sensor, block, arm = session.sensor, session.block, session.arm
    camera, plane, T_flange_cam = _in_own_frame(sensor)
    moves = arm_motion(arm, session.q_rad[:poses])
    noise = ObservationNoise(axis=sensor.stripe_axis, bin_size=BIN_SIZE)
    T_obj_cam = inverse(session.T_arm_obj) @ moves.T_arm_flange @ T_flange_cam
    views = tuple(predict_view(*in_frame(camera, plane, T), block, noise) for T in T_obj_cam)
    everything = np.ones(len(session.features), dtype=np.bool_)
    problem = AdjustmentProblem(
        tuple(range(poses)),
        views,
        moves,
        block_contacts(arm, block, session.features, session.contact_q_rad, everything),
        block_prior(block),
        sensor.width_px,
        sensor.height_px,
    )
    state = AdjustmentState(
        camera,
        plane,
        T_flange_cam,
        session.T_arm_obj,
        problem.prior.coordinates,
        np.zeros(moves.by_links.shape[2]),
        np.zeros((poses, moves.by_noise.shape[2])),
    )
    return information_at(problem, state, scales)


def _in_own_frame(sensor: StripeSensor) -> tuple[Camera, LaserPlane, Floats]:
    """Camera and plane in the camera's own frame, and ``T_flange_cam`` (4, 4)."""
    camera = nominal_camera(sensor)
    T_cam_sensor = rigid(camera.rotation, camera.translation_mm)
    camera, plane = in_frame(camera, nominal_plane(), T_cam_sensor)
    return camera, plane, nominal_mounting(sensor) @ inverse(T_cam_sensor)


def total_um(session: ExpectedSession, counts: Sequence[int]) -> tuple[float, ...]:
    """Standard uncertainties in µm for numbers of poses, as ``predict_accuracy``."""
    return tuple(predict_accuracy(session, count).total_um for count in counts)
